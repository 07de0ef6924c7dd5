//! Circular rims: walks along them, with weights, angles and sense, and the area inside.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use approx::assert_relative_eq;
use stickslip_fem_core::generate::{Disk, Extent, Generate, Growth, Rectangle, uniform_angles};
use stickslip_fem_core::load::{area_integral, area_load};
use stickslip_fem_core::mesh::{ElementKind, Mesh};

const CENTRE: [f64; 2] = [5.0, -3.0];

fn disk(extent: Extent, kind: ElementKind) -> Result<Mesh, Box<dyn std::error::Error>> {
    divided(extent, uniform_angles(extent, 24), kind)
}

fn divided(
    extent: Extent,
    angles: Vec<f64>,
    kind: ElementKind,
) -> Result<Mesh, Box<dyn std::error::Error>> {
    let disk = Disk {
        radius: 2.0,
        centre: CENTRE,
        extent,
        angles,
        core: Disk::CORE,
        layers: 4,
        growth: Growth::Geometric { aspect: 1.0 },
        kind,
    };
    Ok(disk.generate()?)
}

#[test]
fn weights_on_an_arc_sum_to_its_true_length() -> Result<(), Box<dyn std::error::Error>> {
    for kind in ElementKind::COMMON {
        for (extent, length) in [(Extent::Half, 2.0 * PI), (Extent::Whole, 2.0 * TAU)] {
            let mesh = disk(extent, kind)?;
            let path = mesh.edge_path("rim")?;
            assert_eq!(path.closed, extent == Extent::Whole);
            let exact: f64 = mesh
                .edge_weights(&path, mesh.edge_set("rim")?.curve)
                .iter()
                .sum();
            // Some fifty additions of numbers that carry the rounding of coordinates near 7.
            assert_relative_eq!(exact, length, max_relative = 1e-14 * 50.0);
            let weights = mesh.edge_weights(&path, None);
            let chords: f64 = weights.iter().sum();
            // Chords miss h²/24 of the length, parabolas h⁴/480 (half angle h/2 = π/48 or π/24).
            let h = length / 2.0 / 24.0;
            let bound = if kind.order() == 1 {
                h * h / 20.0
            } else {
                h.powi(4) / 200.0
            };
            assert!((chords / length - 1.0).abs() < bound);
        }
    }
    Ok(())
}

#[test]
fn straight_quadratic_edges_have_simpson_weights() -> Result<(), Box<dyn std::error::Error>> {
    let mesh = Rectangle {
        xs: vec![0.0, 6.0, 18.0],
        ys: vec![0.0, 1.0],
        kind: ElementKind::Q9,
    }
    .generate()?;
    let path = mesh.edge_path("bottom")?;
    let weights = mesh.edge_weights(&path, None);
    for (weight, expected) in weights.into_iter().zip([1.0, 4.0, 3.0, 8.0, 2.0]) {
        assert_relative_eq!(weight, expected, max_relative = 1e-14);
    }
    Ok(())
}

#[test]
fn a_rim_is_walked_by_increasing_angle() -> Result<(), Box<dyn std::error::Error>> {
    for kind in ElementKind::COMMON {
        for extent in [Extent::Half, Extent::Whole] {
            let mesh = disk(extent, kind)?;
            let walk = mesh.counter_clockwise(&mesh.edge_path("rim")?, [5.0, -3.0]);
            let angles = mesh.angles(&walk, [5.0, -3.0]);
            let end = if extent == Extent::Half { PI } else { TAU };
            let intervals = 24.0 * kind.order() as f64;
            for (k, angle) in angles.into_iter().enumerate() {
                assert!((angle - end * k as f64 / intervals).abs() < 1e-14 * 10.0);
            }
            let back = mesh.counter_clockwise(&walk.reversed(), [5.0, -3.0]);
            assert_eq!(back, walk);
        }
    }
    Ok(())
}

#[test]
fn a_closed_walk_starts_at_the_smallest_angle() -> Result<(), Box<dyn std::error::Error>> {
    let mesh = disk(Extent::Whole, ElementKind::Q8)?;
    let mut parts = mesh.into_parts();
    // Another first edge must not change the walk's start.
    if let Some(rim) = parts.edge_sets.get_mut("rim") {
        rim.edges.rotate_left(7);
    }
    let mesh = Mesh::new(parts)?;
    let path = mesh.edge_path("rim")?;
    assert!((mesh.angles(&path, [5.0, -3.0])[0] - FRAC_PI_2 * 7.0 / 6.0).abs() < 1e-13);
    let walk = mesh.counter_clockwise(&path, [5.0, -3.0]);
    assert!(mesh.angles(&walk, [5.0, -3.0])[0].abs() < 1e-13);
    Ok(())
}

#[test]
fn areas_of_a_disk_balance_about_its_centre() -> Result<(), Box<dyn std::error::Error>> {
    // Fine around 1 rad only.
    let angles = (0..24).map(|k| f64::from(k) * TAU / 24.0);
    let angles: Vec<f64> = angles
        .map(|at| at - 0.3 * (at - 1.0).sin() - 0.25)
        .collect();
    let angles: Vec<f64> = angles.iter().map(|at| at - angles[0]).collect();
    for kind in ElementKind::COMMON {
        let mesh = divided(Extent::Whole, angles.clone(), kind)?;
        let moments = |areas: &[f64]| {
            [0, 1].map(|axis| {
                let nodes = mesh.nodes().iter().zip(areas);
                nodes
                    .map(|(node, area)| area * (node[axis] - CENTRE[axis]))
                    .sum::<f64>()
            })
        };
        let (own, areas) = (area_integral(&mesh, |_| 1.0), area_load(&mesh));
        // Facets move the centroid by much more than the rounding of a sum over some hundred nodes.
        assert!(moments(&own).iter().any(|moment| moment.abs() > 1e-5));
        assert!(moments(&areas).iter().all(|moment| moment.abs() < 1e-12));
        let [own, sum] = [own, areas].map(|areas| areas.iter().sum::<f64>());
        // The density that moves the centroid changes the area in the second order only.
        assert_relative_eq!(sum, own, max_relative = 1e-2);
    }
    // The straight side of a half is not on the circle.
    let half = disk(Extent::Half, ElementKind::Q8)?;
    assert_eq!(area_load(&half), area_integral(&half, |_| 1.0));
    Ok(())
}
