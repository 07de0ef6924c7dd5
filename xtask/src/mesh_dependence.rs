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

use std::process::ExitCode;

use stickslip_fem_core::mesh::ElementKind;

use crate::publish::{self, Options, Picture, Publication, Trouble};

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
    fn solve(&self) -> Result<Row, Trouble> {
        let Self {
            specimen,
            kind,
            cells,
            strengths,
        } = *self;
        let (size, strength) = match specimen {
            Specimen::Strip => strip::strength(kind, cells, strengths)?,
            Specimen::Pin => pin::strength(kind, cells, strengths)?,
        };
        Ok(Row {
            case: *self,
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
    publish::main("mesh-dependence", options, study)
}

fn study(quick: bool) -> Result<Publication, Trouble> {
    let rows = publish::side_by_side(&cases(quick), Case::solve)?;
    Ok(Publication {
        tables: vec![("strength.csv", page::csv(&rows).into_bytes())],
        pictures: vec![Picture {
            name: "strength",
            svg: page::chart(&rows)?,
            alternative: page::ALTERNATIVE,
        }],
        page: page::page(&rows),
        findings: page::findings(&rows) + "\n",
    })
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
