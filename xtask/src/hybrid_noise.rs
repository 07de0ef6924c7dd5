//! `cargo xtask hybrid-noise`: what noise and bias are left in the shear at a measured edge.
//!
//! Displacements of a sector pressed and sheared at its hole are measured with errors of ±1/4 fringe, reduced in several ways, and made
//! into shear at the edge by localized hybrid analysis. Noise is the propagated deviation, confirmed by draws; bias is the error without
//! noise. Varied are data per cell, cell size, amount of smoothing, and the distance of the data from the edge. The task writes a table,
//! charts and a page.

pub(crate) mod case;
mod page;
pub(crate) mod specimen;

use std::process::ExitCode;

use crate::publish::{self, Options, Picture, Publication, Trouble};
use case::{Case, Method, Row, Varied};
use specimen::Specimen;

/// Runs the task: progress on stderr, findings on stdout.
pub(crate) fn main(options: &Options) -> ExitCode {
    publish::main("hybrid-noise", options, study)
}

/// Cells of the specimen's mesh, and draws of the noise.
const FULL: ([usize; 2], u64) = ([240, 100], 200);
const QUICK: ([usize; 2], u64) = ([96, 40], 40);

/// Cell size where it is not varied `[mm]`, and spacing of the data where they are not.
pub(crate) const SIZE: f64 = 1.0;
const SPACING: f64 = 0.5;

/// All cases, or a coarse few.
fn cases(quick: bool) -> Vec<Case> {
    let base = Case {
        varied: Varied::Points,
        method: Method::Linear,
        size: SIZE,
        spacing: SPACING,
        stand_off: 0.0,
    };
    let points = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0_f64].map(|points| Case {
        spacing: SIZE / points.sqrt(),
        ..base
    });
    let sizes = [2.0, 1.5, 1.0, 0.75, 0.5].map(|size| Case {
        varied: Varied::Mesh,
        size,
        ..base
    });
    let distances = [0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0].map(|stand_off| Case {
        varied: Varied::StandOff,
        stand_off,
        ..base
    });
    let shares = [0.003, 0.01, 0.03, 0.1, 0.2, SHARE, 1.0, 3.0, 10.0];
    let thin = |all: &[Case]| -> Vec<Case> {
        let step = if quick { all.len().div_ceil(2) } else { 1 };
        all.iter().step_by(step).copied().collect()
    };
    let mut all = Vec::new();
    for case in [thin(&points), thin(&sizes), thin(&distances)].concat() {
        all.extend(Method::ALL.map(|method| Case { method, ..case }));
    }
    for spacing in [1.0, 0.5, 0.25] {
        let varied = shares.map(|share| Case {
            varied: Varied::Smoothing,
            method: Method::Smoothed(share),
            spacing,
            ..base
        });
        all.extend(thin(&varied));
    }
    all
}

const SHARE: f64 = case::SHARE;

fn study(quick: bool) -> Result<Publication, Trouble> {
    let (cells, seeds) = if quick { QUICK } else { FULL };
    let specimen = Specimen::new(cells)?;
    let solved = publish::side_by_side(&cases(quick), |case| case.solve(&specimen, seeds))?;
    let rows: Vec<Row> = solved.into_iter().flatten().collect();
    let pictures = page::pictures(&rows)?;
    Ok(Publication {
        tables: vec![("noise-and-bias.csv", page::csv(&rows)?)],
        page: page::page(&rows, &pictures, seeds),
        pictures,
        findings: page::findings(&rows).join("\n\n") + "\n",
    })
}
