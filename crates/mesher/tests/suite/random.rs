//! Random bodies are meshed.

use std::f64::consts::{PI, TAU};

use proptest::prelude::*;
use stickslip_fem_core::mesh::{ElementKind, Point};
use stickslip_mesher::{Contour, ContourError, Hole, quality};

use crate::area::area;
use crate::shapes::{of_kind, polygon};

/// A convex polygon of corners on an ellipse, sides at least 0.2 rad apart.
fn outline() -> impl Strategy<Value = (Contour, f64)> {
    let steps = prop::collection::vec(0.2..1.0, 3..9);
    (steps, 0.0..TAU, 0.3..3.0).prop_map(|(steps, first, ratio)| {
        let total: f64 = steps.iter().sum();
        let mut angle = first;
        let corners: Vec<Point> = (steps.iter())
            .map(|step| {
                angle += TAU * step / total;
                [2.0 * angle.cos(), 2.0 * ratio * angle.sin()]
            })
            .collect();
        let ends = corners.iter().zip(corners.iter().cycle().skip(1));
        let area = ends.map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>() / 2.0;
        (polygon(&corners), area)
    })
}

/// Holes anywhere around the polygon; those that do not fit, or leave gaps below half an edge, are left out.
fn holes() -> impl Strategy<Value = Vec<Hole>> {
    let hole = (-2.0..2.0, -6.0..6.0, 0.05..0.8, 8_usize..60, 0.0..1.0);
    prop::collection::vec(hole, 0..6).prop_map(|list| {
        let holes = list.into_iter().enumerate();
        let hole = |(k, (x, y, radius, count, shift)): (usize, (f64, f64, f64, usize, f64))| {
            let angle = |n: usize| TAU * (n as f64 + shift) / count as f64;
            Hole {
                name: format!("hole {k}"),
                centre: [x, y],
                radius,
                angles: (0..count).map(angle).filter(|&a| a < TAU).collect(),
                layers: None,
            }
        };
        holes.map(hole).collect()
    })
}

fn edge(hole: &Hole) -> f64 {
    TAU * hole.radius / hole.angles.len() as f64
}

/// Adds a hole if it fits with half an edge to spare.
fn add(contour: &mut Contour, hole: Hole) {
    let mut larger = contour.clone();
    for other in &mut larger.holes {
        other.radius += edge(other) / 2.0;
    }
    let radius = hole.radius + edge(&hole) / 2.0;
    larger.holes.push(Hole {
        radius,
        ..hole.clone()
    });
    if larger.check().is_ok() {
        contour.holes.push(hole);
    }
}

/// Area between a circle and the parabolas of its edges.
fn hole_area(hole: &Hole) -> f64 {
    let half = PI / hole.angles.len() as f64;
    let radius = hole.radius;
    let triangle = radius * radius * half.sin() * half.cos();
    let parabola = 4.0 / 3.0 * radius * radius * half.sin() * (1.0 - half.cos());
    hole.angles.len() as f64 * (triangle + parabola)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    /// `Mesh::new` has seen positive Jacobians of all cells.
    #[test]
    fn random_bodies_are_meshed((outline, whole) in outline(), holes in holes()) {
        let mut contour = outline;
        for hole in holes {
            add(&mut contour, hole);
        }
        let exact = whole - contour.holes.iter().map(hole_area).sum::<f64>();
        let is_coarse = contour.holes.iter().any(|hole| hole.angles.len() < 12);
        let mesh = match of_kind(contour, ElementKind::T6).mesh(2_000_000) {
            // Long edges of a coarse hole beside another one bulge into thin cells.
            Err(ContourError::Mesh(_)) if is_coarse => return Ok(()),
            mesh => mesh.map_err(|error| TestCaseError::fail(error.to_string()))?,
        };
        let found = area(&mesh);
        prop_assert!((found / exact - 1.0).abs() < 1e-10, "{} {}", found, exact);
        prop_assert!(quality(&mesh).least_angle > 0.0);
    }
}
