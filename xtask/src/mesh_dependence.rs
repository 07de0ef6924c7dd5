//! `cargo xtask mesh-dependence`: what ply discount makes of a finer mesh.
//!
//! A ply that loses its stiffness at once dissipates ½ X²(1 − d)/E per volume. Its failure gathers in one row of points, so the energy
//! of a crack goes with the size h of the cells, and the load at which a crack runs with √h. Strengths that make the energy per crack
//! area the same on every mesh (crack bands, Bažant & Oh 1983) mend that. Two specimens, each with the plies' own strengths and with
//! crack bands: a strip of fibres along x with a crack along them, pulled across, and a pinned joint. The task writes a table, a chart and
//! a page.

mod page;
mod pin;
mod plies;
mod strip;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use rayon::prelude::*;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_report::folder::write_atomic;
use stickslip_report::raster::{DEFAULT_SCALE, to_png};

/// Why the study stopped.
type Trouble = Box<dyn std::error::Error + Send + Sync>;

/// What to compute.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// The two coarsest meshes only. Nothing is written unless a folder is named.
    #[arg(long)]
    quick: bool,
    /// Folder for table, chart and page; docs/mesh-dependence for a full run.
    #[arg(long, value_name = "FOLDER")]
    output: Option<PathBuf>,
}

/// What breaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Specimen {
    Strip,
    Pin,
}

/// Whose strengths the plies have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Strengths {
    Own,
    /// Those by which a row of cells dissipates the fracture energy.
    CrackBands,
}

/// One specimen on one mesh.
#[derive(Clone, Copy, Debug)]
struct Case {
    specimen: Specimen,
    kind: ElementKind,
    /// Cells across: of the strip's width, or along the half circle of the pin's hole.
    cells: usize,
    strengths: Strengths,
}

/// A case with its answer.
#[derive(Clone, Copy, Debug)]
struct Row {
    case: Case,
    /// Size of the cells where it breaks `[mm]`.
    size: f64,
    /// Mean stress at the largest load `[MPa]`: over the strip's width, or over D t of the joint.
    strength: f64,
}

impl Case {
    fn solve(self) -> Result<Row, Trouble> {
        let Self {
            specimen,
            kind,
            cells,
            strengths,
        } = self;
        let (size, strength) = match specimen {
            Specimen::Strip => strip::strength(kind, cells, strengths)?,
            Specimen::Pin => pin::strength(kind, cells, strengths)?,
        };
        eprintln!("{self:?}: {size:.3} mm, {strength:.2} MPa");
        Ok(Row {
            case: self,
            size,
            strength,
        })
    }
}

/// Cases from coarse to fine: every specimen and kind of cell, plain and with crack bands.
fn cases(quick: bool) -> Vec<Case> {
    const MESHES: [(Specimen, ElementKind, &[usize]); 3] = [
        (Specimen::Strip, ElementKind::Q4, &[3, 6, 12, 24, 48]),
        (Specimen::Strip, ElementKind::Q8, &[3, 6, 12, 24]),
        (Specimen::Pin, ElementKind::Q8, &[8, 12, 16, 24, 32]),
    ];
    let mut all = Vec::new();
    for (specimen, kind, meshes) in MESHES {
        let meshes = if quick { &meshes[..2] } else { meshes };
        for &cells in meshes {
            for strengths in [Strengths::Own, Strengths::CrackBands] {
                all.push(Case {
                    specimen,
                    kind,
                    cells,
                    strengths,
                });
            }
        }
    }
    all
}

/// Runs the task: progress on stderr, findings on stdout.
pub(crate) fn main(options: &Options) -> ExitCode {
    let start = Instant::now();
    let outcome = study(options);
    eprintln!("{:.0} s", start.elapsed().as_secs_f64());
    match outcome {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(trouble) => {
            eprintln!("{trouble}");
            ExitCode::FAILURE
        }
    }
}

fn study(options: &Options) -> Result<String, Trouble> {
    let rows = (cases(options.quick).into_par_iter())
        .map(Case::solve)
        .collect::<Result<Vec<Row>, Trouble>>()?;
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = match &options.output {
        Some(folder) => Some(folder.clone()),
        None => (!options.quick).then(|| root.join("docs/mesh-dependence")),
    };
    if let Some(folder) = folder {
        std::fs::create_dir_all(&folder)?;
        let chart = page::chart(&rows)?;
        write_atomic(&folder.join("strength.csv"), page::csv(&rows).as_bytes())?;
        write_atomic(&folder.join("strength.svg"), chart.as_str().as_bytes())?;
        let picture = to_png(&chart, DEFAULT_SCALE)?;
        write_atomic(&folder.join("strength.png"), &picture)?;
        write_atomic(&folder.join("README.md"), page::page(&rows).as_bytes())?;
    }
    Ok(page::findings(&rows) + "\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crack_runs_at_the_root_of_the_size_of_cells_or_with_bands_at_one_load() {
        let solve = |cells: usize, strengths: Strengths| {
            let case = Case {
                specimen: Specimen::Strip,
                kind: ElementKind::Q4,
                cells,
                strengths,
            };
            case.solve().unwrap()
        };
        let rows = [
            (6, Strengths::Own),
            (12, Strengths::Own),
            (6, Strengths::CrackBands),
            (12, Strengths::CrackBands),
        ]
        .map(|(cells, strengths)| solve(cells, strengths));
        let ratio = |a: usize, b: usize| rows[a].strength / rows[b].strength;
        // 4 % off on cells of a quarter of the crack.
        assert!((ratio(0, 1) / 2.0_f64.sqrt() - 1.0).abs() < 0.05);
        assert!((ratio(2, 3) - 1.0).abs() < 0.06);
        // Cells of 1 mm are those with the plies' own strengths.
        assert!((ratio(1, 3) - 1.0).abs() < 1e-9);
        let page = page::page(&rows);
        assert_eq!(page.matches("| Strip").count(), rows.len());
        assert_eq!(page::csv(&rows).lines().count(), rows.len() + 1);
    }
}
