//! Where nodes lie and how cells are shaped.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use stickslip_fem_core::generate::{
    Disk, Extent, Generate, Growth, bisected_angles, graded, graded_both, uniform_angles,
};
use stickslip_fem_core::mesh::{Curve, ElementKind, Mesh};

use crate::bodies::{EXTENTS, HOLE, STRIP, cylinder, disk, plate};
use crate::measure::{corner_angles, longest_edge};
use crate::{FINE_AT_BEARING, Outcome, fine_at_bearing};

#[test]
fn hole_and_pin_have_the_given_angles_and_face_each_other() -> Outcome {
    for kind in ElementKind::COMMON {
        for extent in EXTENTS {
            let angles = fine_at_bearing(extent);
            let walk =
                |mesh: &Mesh, name: &str| -> Result<Vec<[f64; 2]>, Box<dyn std::error::Error>> {
                    let Some(Curve::Arc { centre, radius }) = mesh.edge_set(name)?.curve else {
                        return Err("not an arc".into());
                    };
                    let path = mesh.counter_clockwise(&mesh.edge_path(name)?, centre);
                    let found = mesh.angles(&path, centre);
                    for (angle, found) in angles.iter().zip(found.iter().step_by(kind.order())) {
                        assert!((angle - found).abs() < 1e-14 * 10.0);
                    }
                    let points = path.nodes.iter().map(|&node| mesh.nodes()[node]);
                    let on_circle =
                        |p: &[f64; 2]| (p[0].hypot(p[1]) / radius - 1.0).abs() < 1e-15 * 10.0;
                    Ok(points.inspect(|p| assert!(on_circle(p))).collect())
                };
            let hole = walk(
                &plate(STRIP, extent, angles.clone(), kind).generate()?,
                "hole",
            )?;
            let pin = walk(&disk(extent, angles.clone(), 5, kind).generate()?, "rim")?;
            assert_eq!(hole, pin);
        }
    }
    Ok(())
}

#[test]
fn cells_of_the_reports_plate_are_well_shaped() -> Outcome {
    for extent in EXTENTS {
        let mesh = plate(STRIP, extent, fine_at_bearing(extent), ElementKind::Q4).generate()?;
        let [smallest, largest] = corner_angles(&mesh);
        assert!(smallest > 25.0 && largest < 155.0, "{smallest} {largest}");
        let pin = disk(extent, fine_at_bearing(extent), 8, ElementKind::Q4).generate()?;
        let [smallest, largest] = corner_angles(&pin);
        assert!(smallest > 15.0 && largest < 165.0, "{smallest} {largest}");
        let uniform = disk(extent, uniform_angles(extent, 32), 6, ElementKind::Q4).generate()?;
        let [smallest, largest] = corner_angles(&uniform);
        assert!(smallest > 45.0 && largest < 135.0, "{smallest} {largest}");
    }
    Ok(())
}

#[test]
fn the_first_layer_is_as_thick_as_asked() -> Outcome {
    for aspect in [0.25, 1.0] {
        let mut body = plate(
            STRIP,
            Extent::Half,
            uniform_angles(Extent::Half, 40),
            ElementKind::Q4,
        );
        body.growth = Growth::Geometric { aspect };
        body.layers = 14;
        let mesh = body.generate()?;
        let second = mesh
            .node_set("symmetry")?
            .iter()
            .map(|&n| mesh.nodes()[n][0]);
        let thickness = second
            .filter(|&x| x > HOLE * 1.0001)
            .fold(f64::INFINITY, f64::min)
            - HOLE;
        assert_relative_eq!(thickness, aspect * HOLE * PI / 40.0, max_relative = 1e-9);
        // Explicit fractions instead: of the way 1.125 from the hole to the right end.
        body.growth = Growth::Fractions((1..=14).map(|k| (f64::from(k) / 14.0).powi(2)).collect());
        let mesh = body.generate()?;
        let second = mesh
            .node_set("symmetry")?
            .iter()
            .map(|&n| mesh.nodes()[n][0]);
        let thickness = second
            .filter(|&x| x > HOLE * 1.0001)
            .fold(f64::INFINITY, f64::min)
            - HOLE;
        assert_relative_eq!(thickness, 1.125 / 196.0, max_relative = 1e-12);
    }
    Ok(())
}

#[test]
fn refinement_shrinks_every_cell_of_a_disk() -> Outcome {
    for extent in EXTENTS {
        let mut angles = fine_at_bearing(extent);
        let mut last = f64::INFINITY;
        for level in 0..4 {
            let mesh = disk(extent, angles.clone(), 4 << level, ElementKind::Q4).generate()?;
            let longest = longest_edge(&mesh);
            // Halved but for the change of the layers' growth.
            assert!(longest < 0.65 * last, "{longest} after {last}");
            last = longest;
            angles = bisected_angles(extent, &angles);
        }
    }
    Ok(())
}

#[test]
fn the_centre_of_a_disk_is_a_node() -> Outcome {
    for kind in ElementKind::COMMON {
        for (extent, counts) in [(Extent::Half, 4..12), (Extent::Whole, 4..12)] {
            for count in counts {
                let count = if extent == Extent::Whole {
                    2 * count
                } else {
                    count
                };
                let centre = [1.25, -7.5];
                let body = Disk {
                    centre,
                    ..disk(extent, uniform_angles(extent, count), 2, kind)
                };
                let mesh = body.generate()?;
                let &[node] = mesh.node_set("centre")? else {
                    return Err("not one node".into());
                };
                assert_eq!(mesh.nodes()[node], centre);
            }
        }
    }
    Ok(())
}

#[test]
fn contact_nodes_of_cap_and_block_face_each_other() -> Outcome {
    for kind in ElementKind::COMMON {
        for extent in EXTENTS {
            let bodies = cylinder(extent, 0.3, kind).generate()?;
            let walk = |mesh: &Mesh| -> Result<Vec<[f64; 2]>, Box<dyn std::error::Error>> {
                Ok(mesh
                    .edge_path("contact")?
                    .nodes
                    .iter()
                    .map(|&node| mesh.nodes()[node])
                    .collect())
            };
            // The block's cells are under its contact edge, the cap's over: they are walked in opposite senses.
            let (mut lower, upper) = (walk(&bodies.lower)?, walk(&bodies.upper)?);
            lower.reverse();
            assert_eq!(lower.len(), upper.len());
            for (below, above) in lower.iter().zip(&upper) {
                assert_eq!((below[0], below[1]), (above[0], 0.0));
                let radius = above[0].hypot(above[1] - 10.0);
                assert!((radius / 10.0 - 1.0).abs() < 1e-15 * 4.0);
            }
            let spacing = upper
                .iter()
                .filter(|p| p[0] >= 0.0 && p[0] < 1.0 + 1e-12)
                .count();
            // Four equal cells of 0.25 in 0 … 1, the widest not above 0.3.
            assert_eq!(spacing, 4 * kind.order() + 1);
        }
    }
    Ok(())
}

#[test]
fn graded_lists_have_their_ratio() -> Outcome {
    let list = graded(1.0, 3.0, 5, 4.0)?;
    assert_eq!((list.len(), list[0], list[5]), (6, 1.0, 3.0));
    assert_relative_eq!(
        (list[5] - list[4]) / (list[1] - list[0]),
        4.0,
        max_relative = 1e-12
    );
    let both = graded_both(-1.0, 1.0, 6, 3.0)?;
    assert_relative_eq!(
        (both[3] - both[2]) / (both[1] - both[0]),
        3.0,
        max_relative = 1e-12
    );
    assert!(
        both.iter()
            .zip(both.iter().rev())
            .all(|(a, b)| (a + b).abs() < 1e-15 * 2.0)
    );
    let degrees = FINE_AT_BEARING.map(f64::to_radians);
    assert_eq!(bisected_angles(Extent::Half, &degrees).len(), 59);
    assert_eq!(
        bisected_angles(Extent::Whole, &uniform_angles(Extent::Whole, 5)).len(),
        10
    );
    Ok(())
}
