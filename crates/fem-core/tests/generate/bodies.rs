//! Areas and boundaries of every body.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use stickslip_fem_core::generate::{
    CylinderOnBlock, Disk, Extent, Generate, Growth, Outline, PlateWithHole, Rectangle,
    bisected_angles, uniform_angles,
};
use stickslip_fem_core::mesh::{ElementKind, Mesh};

use crate::measure::{area, boundary, named_edges};
use crate::{Outcome, fine_at_bearing};

pub(crate) const EXTENTS: [Extent; 2] = [Extent::Half, Extent::Whole];
/// The report's plate.
pub(crate) const STRIP: Outline = Outline::Strip {
    half_width: 1.495,
    left: 7.005,
    right: 1.5,
};
pub(crate) const HOLE: f64 = 0.375;

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

pub(crate) fn cylinder(extent: Extent, spacing: f64, kind: ElementKind) -> CylinderOnBlock {
    CylinderOnBlock {
        radius: 10.0,
        half_width: 6.0,
        height: 5.0,
        inner: 1.0,
        spacing,
        growth: 1.3,
        columns: None,
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
    for kind in ElementKind::COMMON {
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
    for kind in ElementKind::COMMON {
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
    for kind in ElementKind::COMMON {
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
    for kind in ElementKind::COMMON {
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
