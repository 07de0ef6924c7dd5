//! Areas, sets and shapes of every body.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use stickslip_fem_core::generate::{
    CylinderOnBlock, Disk, Extent, Generate, Growth, Outline, PlateWithHole, Rectangle,
    bisected_angles, graded, graded_both, uniform_angles,
};
use stickslip_fem_core::mesh::{Curve, ElementKind, Mesh};

use crate::measure::{area, boundary, corner_angles, longest_edge, named_edges};
use crate::{FINE_AT_BEARING, Outcome, fine_at_bearing};

const EXTENTS: [Extent; 2] = [Extent::Half, Extent::Whole];
/// The report's plate.
const STRIP: Outline = Outline::Strip {
    half_width: 1.495,
    left: 7.005,
    right: 1.5,
};
const HOLE: f64 = 0.375;

pub(crate) fn plate(
    outline: Outline,
    extent: Extent,
    angles: Vec<f64>,
    kind: ElementKind,
) -> PlateWithHole {
    let growth = Growth::Geometric { aspect: 1.0 };
    PlateWithHole {
        hole_radius: HOLE,
        outline,
        extent,
        angles,
        layers: 8,
        growth,
        far_cells: 5,
        kind,
    }
}

pub(crate) fn disk(extent: Extent, angles: Vec<f64>, layers: usize, kind: ElementKind) -> Disk {
    let growth = Growth::Geometric { aspect: 1.0 };
    Disk {
        radius: HOLE,
        centre: [0.0; 2],
        extent,
        angles,
        core: Disk::CORE,
        layers,
        growth,
        kind,
    }
}

fn cylinder(extent: Extent, spacing: f64, kind: ElementKind) -> CylinderOnBlock {
    CylinderOnBlock {
        radius: 10.0,
        half_width: 6.0,
        height: 5.0,
        inner: 1.0,
        spacing,
        growth: 1.3,
        extent,
        kind,
    }
}

/// Area between the polygon and its circle that straight or parabolic edges over `interval` [rad] cover, plus the sector's
/// triangle: what `intervals` of them give for the area of the (half) circle.
fn meshed_circle(radius: f64, interval: f64, intervals: usize, kind: ElementKind) -> f64 {
    let triangle = radius * radius * interval.sin() / 2.0;
    let (chord, rise) = (
        2.0 * radius * (interval / 2.0).sin(),
        radius * (1.0 - (interval / 2.0).cos()),
    );
    let parabola = if kind.order() == 2 {
        2.0 / 3.0 * chord * rise
    } else {
        0.0
    };
    intervals as f64 * (triangle + parabola)
}

fn check_boundary(mesh: &Mesh, names: &[&str]) {
    assert_eq!(mesh.edge_set_names().collect::<Vec<_>>(), names);
    // Every boundary edge has exactly one name, and no inner edge has: so the blocks are joined without gaps.
    assert_eq!(named_edges(mesh), boundary(mesh));
}

#[test]
fn plates_have_the_area_of_their_interpolated_outline() -> Outcome {
    for kind in ElementKind::ALL {
        for extent in EXTENTS {
            let part = if extent == Extent::Half { 0.5 } else { 1.0 };
            let intervals = if extent == Extent::Half { 24 } else { 48 };
            let angles = uniform_angles(extent, intervals);
            let hole = meshed_circle(HOLE, PI / 24.0, intervals, kind);
            let strip = plate(STRIP, extent, angles.clone(), kind).generate()?;
            let exact = part * 2.0 * 1.495 * (7.005 + 1.5) - hole;
            assert_relative_eq!(area(&strip), exact, max_relative = 1e-12);
            let ring =
                plate(Outline::Ring { outer_radius: 2.0 }, extent, angles, kind).generate()?;
            let exact = meshed_circle(2.0, PI / 24.0, intervals, kind) - hole;
            assert_relative_eq!(area(&ring), exact, max_relative = 1e-12);
        }
    }
    Ok(())
}

#[test]
fn disks_have_the_area_of_their_interpolated_rim() -> Outcome {
    for kind in ElementKind::ALL {
        for (extent, counts) in [
            (Extent::Half, [4, 7, 24, 29]),
            (Extent::Whole, [8, 10, 32, 50]),
        ] {
            for count in counts {
                let interval = if extent == Extent::Half { PI } else { 2.0 * PI } / count as f64;
                let mesh = disk(extent, uniform_angles(extent, count), 4, kind).generate()?;
                let exact = meshed_circle(HOLE, interval, count, kind);
                assert_relative_eq!(area(&mesh), exact, max_relative = 1e-12);
            }
        }
    }
    Ok(())
}

#[test]
fn areas_converge_with_the_square_or_fourth_power_of_the_cell_size() -> Outcome {
    for kind in ElementKind::ALL {
        let mut errors = Vec::new();
        let mut angles = uniform_angles(Extent::Half, 8);
        for _ in 0..4 {
            let body = plate(
                Outline::Ring { outer_radius: 1.0 },
                Extent::Half,
                angles.clone(),
                kind,
            );
            errors.push((area(&body.generate()?) / (PI / 2.0 * (1.0 - HOLE * HOLE)) - 1.0).abs());
            angles = bisected_angles(Extent::Half, &angles);
        }
        let expected = 2.0 * kind.order() as f64;
        for pair in errors.windows(2) {
            let rate = (pair[0] / pair[1]).log2();
            // From π/8 on the next term of the series changes the rate by less than 0.02.
            assert!((rate - expected).abs() < 0.02, "{kind:?}: {rate}");
        }
    }
    Ok(())
}

#[test]
fn the_cap_converges_to_its_exact_area() -> Outcome {
    // ∫ (H − R + √(R² − x²)) dx over 0 … L, R = 10, L = 6, H = 5; √(R² − L²) = 8.
    let exact = 6.0 * (5.0 - 10.0) + f64::midpoint(6.0 * 8.0, 100.0 * 0.6_f64.asin());
    for kind in ElementKind::ALL {
        let error = |spacing| -> Result<f64, Box<dyn std::error::Error>> {
            let bodies = cylinder(Extent::Half, spacing, kind).generate()?;
            assert_relative_eq!(area(&bodies.lower), 30.0, max_relative = 1e-12);
            Ok((area(&bodies.upper) / exact - 1.0).abs())
        };
        // The growing cells are not halved exactly, so only the size of the error is asked for: h²/12 × curvature for chords
        // of the largest cells (about 1.2), and a thousand times less for parabolas.
        let bound = if kind.order() == 1 { 1e-2 } else { 1e-5 };
        assert!(error(0.5)? < bound);
        assert!(error(0.1)? < bound);
    }
    Ok(())
}

#[test]
fn every_boundary_edge_of_a_plate_has_one_name() -> Outcome {
    let short = Outline::Strip {
        half_width: 1.0,
        left: 1.1,
        right: 0.6,
    };
    let long = Outline::Strip {
        half_width: 1.0,
        left: 3.0,
        right: 2.0,
    };
    for kind in ElementKind::ALL {
        for angles in [
            uniform_angles(Extent::Half, 12),
            fine_at_bearing(Extent::Half),
        ] {
            for outline in [STRIP, short, long] {
                let mesh = plate(outline, Extent::Half, angles.clone(), kind).generate()?;
                check_boundary(&mesh, &["hole", "left", "right", "symmetry", "top"]);
            }
        }
        for angles in [
            uniform_angles(Extent::Whole, 22),
            fine_at_bearing(Extent::Whole),
        ] {
            for outline in [STRIP, short, long] {
                let mesh = plate(outline, Extent::Whole, angles.clone(), kind).generate()?;
                check_boundary(&mesh, &["bottom", "hole", "left", "right", "top"]);
                for side in ["bottom", "hole", "left", "right", "top"] {
                    assert!(mesh.edge_path(side).is_ok());
                }
            }
        }
        let ring = Outline::Ring { outer_radius: 1.0 };
        let half = plate(ring, Extent::Half, uniform_angles(Extent::Half, 6), kind).generate()?;
        check_boundary(&half, &["hole", "outer", "symmetry"]);
        let whole =
            plate(ring, Extent::Whole, uniform_angles(Extent::Whole, 9), kind).generate()?;
        check_boundary(&whole, &["hole", "outer"]);
    }
    Ok(())
}

#[test]
fn every_boundary_edge_of_the_other_bodies_has_one_name() -> Outcome {
    for kind in ElementKind::ALL {
        for extent in EXTENTS {
            let names: &[_] = if extent == Extent::Half {
                &["rim", "symmetry"]
            } else {
                &["rim"]
            };
            for angles in [uniform_angles(extent, 14), fine_at_bearing(extent)] {
                let mesh = disk(extent, angles, 5, kind).generate()?;
                check_boundary(&mesh, names);
                names
                    .iter()
                    .try_for_each(|name| mesh.edge_path(name).map(drop))?;
            }
            let bodies = cylinder(extent, 0.5, kind).generate()?;
            let (left, last) = if extent == Extent::Half {
                (None, Some("symmetry"))
            } else {
                (Some("left"), None)
            };
            let names = |far| {
                let mut names: Vec<_> = ["contact", far, "right"]
                    .into_iter()
                    .chain(left)
                    .chain(last)
                    .collect();
                names.sort_unstable();
                names
            };
            check_boundary(&bodies.lower, &names("bottom"));
            check_boundary(&bodies.upper, &names("top"));
        }
        let rectangle = Rectangle::uniform([0.0, 2.0], [-1.0, 1.0], [3, 4], kind)?.generate()?;
        check_boundary(&rectangle, &["bottom", "left", "right", "top"]);
    }
    Ok(())
}

#[test]
fn sides_lie_where_their_names_say() -> Outcome {
    for kind in ElementKind::ALL {
        for extent in EXTENTS {
            let mesh = plate(STRIP, extent, fine_at_bearing(extent), kind).generate()?;
            let places = [
                ("left", 0, -7.005),
                ("right", 0, 1.5),
                ("top", 1, 1.495),
                ("bottom", 1, -1.495),
                ("symmetry", 1, 0.0),
            ];
            for (name, axis, value) in places {
                let Ok(nodes) = mesh.node_set(name) else {
                    continue;
                };
                assert!(
                    nodes.iter().all(|&node| mesh.nodes()[node][axis] == value),
                    "{name}"
                );
            }
            assert_eq!(mesh.bounding_box()[1], [1.5, 1.495]);
            let corner = |at| mesh.nodes().contains(&at);
            assert!(corner([1.5, 1.495]) && corner([-7.005, 1.495]) && corner([-1.495, 1.495]));
        }
        let mesh = disk(Extent::Half, fine_at_bearing(Extent::Half), 6, kind).generate()?;
        let cut = mesh.node_set("symmetry")?;
        assert!(cut.iter().all(|&node| mesh.nodes()[node][1] == 0.0));
        // Nothing else lies on the diameter.
        assert_eq!(
            mesh.nodes().iter().filter(|p| p[1] == 0.0).count(),
            cut.len()
        );
    }
    Ok(())
}

#[test]
fn hole_and_pin_have_the_given_angles_and_face_each_other() -> Outcome {
    for kind in ElementKind::ALL {
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
    for kind in ElementKind::ALL {
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
    for kind in ElementKind::ALL {
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
