//! Any reasonable list of angles and any map give a sound mesh.

use proptest::prelude::*;
use stickslip_fem_core::generate::{
    Blocks, Extent, Generate, Growth, Outline, PlateWithHole, Side,
};
use stickslip_fem_core::mesh::ElementKind;

use crate::bodies::disk;
use crate::measure::{area, boundary, named_edges};

/// Angles whose intervals vary by a factor of 4 from one to the next and do not exceed a fifth of the half circle.
fn angles(extent: Extent) -> impl Strategy<Value = Vec<f64>> {
    let end = if extent == Extent::Half {
        std::f64::consts::PI
    } else {
        std::f64::consts::TAU
    };
    let pairs = if extent == Extent::Half {
        11..40
    } else {
        22..60
    };
    let evens = prop::collection::vec([0.25..1.0, 0.25..1.0], pairs);
    evens.prop_map(move |pairs| {
        let widths: Vec<f64> = pairs.into_iter().flatten().collect();
        let total: f64 = widths.iter().sum();
        let ends = widths.iter().scan(0.0, |sum, width| {
            *sum += width;
            Some(*sum / total * end)
        });
        let mut list: Vec<f64> = [0.0].into_iter().chain(ends).collect();
        list.pop();
        if extent == Extent::Half {
            list.push(end);
        }
        list
    })
}

fn kind() -> impl Strategy<Value = ElementKind> {
    prop::sample::select(ElementKind::COMMON.to_vec())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn plates_with_any_angles_are_sound(
        half in angles(Extent::Half),
        whole in angles(Extent::Whole),
        kind in kind(),
        ends in [0.5..6.0, 0.5..6.0],
        layers in 3_usize..12,
        aspect in 0.3..2.0,
    ) {
        for (extent, angles) in [(Extent::Half, half), (Extent::Whole, whole)] {
            let body = PlateWithHole {
                hole_radius: 0.25,
                outline: Outline::Strip { half_width: 1.0, left: ends[0], right: ends[1] },
                extent,
                angles,
                layers,
                growth: Growth::Geometric { aspect },
                far_cells: 4,
                kind,
            };
            let mesh = body.generate()?;
            prop_assert_eq!(mesh.nodes().len(), body.estimate()?.nodes);
            prop_assert_eq!(named_edges(&mesh), boundary(&mesh));
        }
    }

    #[test]
    fn disks_with_any_angles_are_sound(
        half in angles(Extent::Half),
        whole in angles(Extent::Whole),
        kind in kind(),
        layers in 2_usize..10,
    ) {
        for (extent, angles) in [(Extent::Half, half), (Extent::Whole, whole)] {
            let body = disk(extent, angles, layers, kind);
            let mesh = body.generate()?;
            prop_assert_eq!(mesh.nodes().len(), body.estimate()?.nodes);
            prop_assert_eq!(named_edges(&mesh), boundary(&mesh));
        }
    }

    /// Two blocks that share a side, under any rotation, mirroring, scale and shift: the same mesh, oriented positively.
    #[test]
    fn blocks_join_under_any_map(
        kind in kind(),
        turn in 0.0..6.3,
        mirror in any::<bool>(),
        scale in -6.0..6.0,
        shift in [-1e3..1e3, -1e3..1e3],
    ) {
        let size = 10_f64.powf(scale);
        let (sin, cos) = f64::sin_cos(turn);
        let map = |x: f64, y: f64| {
            let y = if mirror { -y } else { y };
            let (x, y) = (x + 0.1 * y * y, y + 0.05 * x * x);
            [size * (cos * x - sin * y + shift[0]), size * (sin * x + cos * y + shift[1])]
        };
        let mut blocks = Blocks::new("two", kind);
        let first = blocks.add([3, 2], |i, j| map(i / 3.0, j / 2.0));
        // The second block is walked from the other corner.
        let second = blocks.add([2, 4], |i, j| map(2.0 - j / 4.0, 1.0 - i / 2.0));
        for (side, cells) in [(Side::South, 3), (Side::West, 2), (Side::North, 3)] {
            blocks.name("outer", first, side, 0..cells);
        }
        for (side, cells) in [(Side::South, 2), (Side::West, 4), (Side::East, 4)] {
            blocks.name("outer", second, side, 0..cells);
        }
        let mesh = blocks.build()?;
        prop_assert_eq!(named_edges(&mesh), boundary(&mesh));
        prop_assert_eq!(mesh.edge_path("outer")?.edges.len(), 3 + 2 + 3 + 2 + 4 + 4);
        // Jacobian of the quadratic part: 1 − 0.02 x y, over 0 … 2 × ±(0 … 1).
        let exact = size * size * if mirror { 2.0 + 0.02 } else { 2.0 - 0.02 };
        // Chords leave out slivers of relative size h²; shifted coordinates round to 1e-13 of the size.
        let tolerance = if kind.order() == 2 { 1e-8 } else { 0.02 };
        prop_assert!((area(&mesh) / exact - 1.0).abs() < tolerance);
    }
}
