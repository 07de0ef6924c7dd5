//! `cargo xtask mesh-dependence`: what ply discount makes of a finer mesh.
//!
//! A ply that loses its stiffness at once dissipates ½ X²(1 − d)/E per volume. Its failure gathers in one row of points, so the energy
//! of a crack goes with the size h of the cells, and the load at which a crack runs with √h. Strengths that make the energy per crack
//! area the same on every mesh (crack bands, Bažant & Oh 1983) correct that. Two specimens, each with the plies' own strengths and with
//! crack bands: a strip of fibres along x with a crack along them, pulled across, and a pinned joint. Scenes never raise a strength, so
//! both are built from the library.

mod pin;
mod plies;
mod strip;

use stickslip_fem_core::mesh::ElementKind;
use toml::Table;

use crate::study::record::{fields, needed, text};
use crate::study::{Study, TaskError, solved_side_by_side};

pub(crate) const STUDY: Study = Study {
    name: "mesh-dependence",
    solve: |cases| solved_side_by_side(cases, strength),
    complete: |_| {},
};

fn strength(case: &Table) -> Result<Vec<Table>, TaskError> {
    let kind: ElementKind = case["element"].clone().try_into()?;
    let cells = needed(case, "cells")? as usize;
    let has_bands = text(case, "strengths")? == "crack bands";
    let (size, strength) = match text(case, "specimen")? {
        "strip" => strip::strength(kind, cells, has_bands)?,
        _ => pin::strength(kind, cells, has_bands)?,
    };
    let mut row = case.clone();
    row.extend(fields([
        ("size_mm", size.into()),
        ("strength_MPa", strength.into()),
        (
            "fracture_mechanics_MPa",
            strip::fracture_mechanics()?.into(),
        ),
    ]));
    Ok(vec![row])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crack_runs_at_the_root_of_the_size_of_cells_or_with_bands_at_one_load() {
        let solve = |cells, has_bands| {
            let found = strip::strength(ElementKind::Q4, cells, has_bands);
            found.expect("it breaks").1
        };
        let own = [6, 12].map(|cells| solve(cells, false));
        let bands = [6, 12].map(|cells| solve(cells, true));
        // 4 % off on cells of a quarter of the crack.
        assert!((own[0] / own[1] / 2.0_f64.sqrt() - 1.0).abs() < 0.05);
        assert!((bands[0] / bands[1] - 1.0).abs() < 0.06);
        // Cells of 1 mm are those with the plies' own strengths.
        assert!((own[1] / bands[1] - 1.0).abs() < 1e-9);
    }
}
