//! Cells of a mirrored shape are mirrored, and a half has the cells of the whole.

use std::collections::BTreeSet;

use stickslip_fem_core::generate::{Disk, Extent, Generate, Outline, uniform_angles};
use stickslip_fem_core::mesh::{ElementKind, Mesh};

use crate::bodies::{HOLE, STRIP, cylinder, disk, plate};
use crate::{Outcome, fine_at_bearing};

/// The cells of `mesh` as sets of their nodes, seen from `centre` with axes that point as `signs` say; rounded far above rounding
/// errors and far below the smallest cell.
fn cells(mesh: &Mesh, centre: [f64; 2], signs: [f64; 2]) -> BTreeSet<BTreeSet<[i64; 2]>> {
    /// Odd, so that no simple fraction of the radius lies between two steps.
    const STEPS: f64 = 8_765_432.1;
    let rounded = |node: &usize| {
        let at = mesh.nodes()[*node];
        [0, 1].map(|k| (signs[k] * (at[k] - centre[k]) / HOLE * STEPS).round() as i64)
    };
    let blocks = mesh.blocks().iter();
    blocks
        .flat_map(|block| block.connectivity.chunks(block.kind.nodes()))
        .map(|nodes| nodes.iter().map(rounded).collect())
        .collect()
}

fn assert_mirrored(mesh: &Mesh, centre: [f64; 2], signs: [f64; 2], what: &str) {
    let (own, mirrored) = (cells(mesh, centre, [1.0; 2]), cells(mesh, centre, signs));
    let alone = own.difference(&mirrored).count();
    assert_eq!(alone, 0, "{what}: of {} cells", own.len());
}

fn angles(extent: Extent) -> Vec<Vec<f64>> {
    let uniform = [10, 12, 15, 16, 18, 20, 36].map(|half| match extent {
        Extent::Half => uniform_angles(extent, half),
        Extent::Whole => uniform_angles(extent, 2 * half),
    });
    let mut all = uniform.to_vec();
    all.push(fine_at_bearing(extent));
    all
}

const ABOUT_X: [f64; 2] = [1.0, -1.0];
const ABOUT_Y: [f64; 2] = [-1.0, 1.0];

#[test]
fn whole_bodies_are_their_own_mirror_images() -> Outcome {
    let origin = [0.0; 2];
    let square = Outline::Strip {
        half_width: 1.5,
        left: 1.5,
        right: 1.5,
    };
    let ring = Outline::Ring { outer_radius: 1.1 };
    for kind in ElementKind::COMMON {
        for angles in angles(Extent::Whole) {
            let count = angles.len();
            for outline in [STRIP, square, ring] {
                let mesh = plate(outline, Extent::Whole, angles.clone(), kind).generate()?;
                assert_mirrored(
                    &mesh,
                    origin,
                    ABOUT_X,
                    &format!("{outline:?} {kind:?} {count}"),
                );
            }
            let centre = [0.3, 0.1];
            let pin = disk(Extent::Whole, angles, 4, kind);
            let mesh = Disk { centre, ..pin }.generate()?;
            assert_mirrored(&mesh, centre, ABOUT_X, &format!("pin {kind:?} {count}"));
            if count.is_multiple_of(4) && count != 58 {
                assert_mirrored(
                    &mesh,
                    centre,
                    ABOUT_Y,
                    &format!("pin, end for end {kind:?} {count}"),
                );
            }
        }
        let bodies = cylinder(Extent::Whole, 0.25, kind).generate()?;
        for mesh in [&bodies.upper, &bodies.lower] {
            assert_mirrored(
                mesh,
                origin,
                ABOUT_Y,
                &format!("cylinder on block {kind:?}"),
            );
        }
    }
    Ok(())
}

#[test]
fn halves_have_the_cells_of_the_whole() -> Outcome {
    let check = |half: &Mesh, whole: &Mesh, what: &str| {
        let [half, whole] = [half, whole].map(|mesh| cells(mesh, [0.0; 2], [1.0; 2]));
        assert_eq!(
            half.difference(&whole).count(),
            0,
            "{what}: of {}",
            half.len()
        );
        assert_eq!(2 * half.len(), whole.len(), "{what}");
    };
    for kind in ElementKind::COMMON {
        for (half, whole) in angles(Extent::Half).into_iter().zip(angles(Extent::Whole)) {
            let what = format!("{kind:?} {}", whole.len());
            let plates = [(Extent::Half, half.clone()), (Extent::Whole, whole.clone())]
                .map(|(extent, angles)| plate(STRIP, extent, angles, kind).generate());
            let [half_plate, whole_plate] = plates;
            check(&half_plate?, &whole_plate?, &format!("plate {what}"));
            let half_pin = disk(Extent::Half, half, 4, kind).generate()?;
            let whole_pin = disk(Extent::Whole, whole, 4, kind).generate()?;
            check(&half_pin, &whole_pin, &format!("pin {what}"));
        }
        let [half, whole] =
            [Extent::Half, Extent::Whole].map(|extent| cylinder(extent, 0.25, kind).generate());
        let (half, whole) = (half?, whole?);
        check(&half.upper, &whole.upper, &format!("cap {kind:?}"));
        check(&half.lower, &whole.lower, &format!("block {kind:?}"));
    }
    Ok(())
}
