//! `cargo xtask hybrid-noise`: what noise and bias are left in the shear at a measured edge.
//!
//! Displacements of a sector pressed and sheared at its hole are measured with errors of ±1/4 fringe, reduced in several ways, and made
//! into shear at the edge by localized hybrid analysis. Noise is the propagated standard deviation, confirmed by draws; bias is the error
//! without noise. Varied are data per cell, cell size, amount of smoothing, and the distance of the data from the edge.

pub(crate) mod case;
pub(crate) mod specimen;

use toml::Table;

use crate::study::record::{fields, needed, number, text};
use crate::study::table::Tables;
use crate::study::{Study, TaskError, solved_side_by_side};
use case::{Case, Method};
use specimen::Specimen;

pub(crate) const STUDY: Study = Study {
    name: "hybrid-noise",
    solve,
    complete: |_| {},
};

/// Biases below this count as zero `[MPa]`.
const ROUNDING: f64 = 1e-9;

fn solve(cases: &[Table]) -> Result<Tables, TaskError> {
    let first = cases.first().ok_or("no case")?;
    let cells = [
        needed(first, "around")? as usize,
        needed(first, "outwards")? as usize,
    ];
    let specimen = Specimen::new(cells)?;
    solved_side_by_side(cases, |case| rows(case, &specimen))
}

/// The row of a case; none where its reduction needs data that are not there.
fn rows(case: &Table, specimen: &Specimen) -> Result<Vec<Table>, TaskError> {
    let name = text(case, "reduction")?;
    let own = Method::ALL.into_iter().find(|method| method.name() == name);
    let method = match number(case, "share") {
        Some(share) => Method::Smoothed(share),
        None => own.ok_or_else(|| format!("no reduction '{name}'"))?,
    };
    let own = Case {
        method,
        size: needed(case, "cell_mm")?,
        spacing: needed(case, "spacing_mm")?,
        stand_off: needed(case, "stand_off_mm")?,
    };
    let Some(quality) = own.solve(specimen, needed(case, "draws")? as u64)? else {
        return Ok(Vec::new());
    };
    // What is left by rounding has no place on a logarithmic axis.
    let bias = if quality.bias > ROUNDING {
        quality.bias
    } else {
        0.0
    };
    let mut row = case.clone();
    row.extend(fields([
        ("points_per_cell", (own.size / own.spacing).powi(2).into()),
        ("noise_MPa", quality.noise.into()),
        ("noise_of_draws_MPa", quality.drawn.into()),
        ("bias_of_reduction_MPa", bias.into()),
        ("bias_of_mesh_MPa", quality.mesh.into()),
    ]));
    Ok(vec![row])
}
