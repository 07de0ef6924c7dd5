//! Frictionless pin of the plate's material in an infinite plate (Persson 1964; Ciavarella & Decuzzi 2001).

use std::f64::consts::PI;

use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_series::{Anchor, Circle, Disk, DiskLoad, FarLoad, Hole, Nodes};

use crate::contacts::{follow, pressures, problem};

const UNIT: Circle = Circle {
    centre: [0.0, 0.0],
    radius: 1.0,
    thickness: 1.0,
};

/// Contact half angle `[deg]`, E ΔR t/Q and p_max R t/Q of the closed form, 8 digits (table R1: closed form and Chebyshev collocation agree
/// to 1e-13).
const CLOSED_FORM: [[f64; 3]; 4] = [
    [25.0, 12.020181, 1.4953617],
    [45.0, 2.8231213, 0.88211136],
    [65.0, 0.74191808, 0.67697427],
    [75.0, 0.28707749, 0.62810319],
];
/// Contact half angle `[deg]` without clearance, for any load.
const CONFORMING: f64 = 84.82795;

/// Pressures for a pin pushed along x by 1.
fn solve(nodes: &Nodes, clearance: f64, anchor: Anchor) -> Vec<f64> {
    let material = Isotropic::new(1.0, 0.3, PlaneState::Stress).unwrap();
    let push = DiskLoad {
        force: [1.0, 0.0],
        ..DiskLoad::default()
    };
    let plate = Hole::held(nodes.clone(), &material, UNIT, &[FarLoad::default()]).unwrap();
    let pin = Disk::floating(nodes.clone(), &material, UNIT, anchor, &[push]).unwrap();
    let problem = problem(&plate, &pin, nodes, 1.0, clearance, 0.0);
    let states = follow(&problem, vec![vec![1.0]], 1);
    pressures(&problem, &states[0])
}

/// Second order from 61 nodes on; at 25° the contact holds eight spacings of 3°, and where its end lies between nodes shows.
#[test]
fn peak_pressures_converge_to_the_closed_form() {
    for [half_angle, clearance, expected] in CLOSED_FORM {
        let errors = [31, 61, 121].map(|count| {
            let nodes = Nodes::uniform_half(count).unwrap();
            let p = solve(&nodes, clearance, Anchor::default());
            (p[0] / expected - 1.0).abs()
        });
        let bound = [4e-3, 6e-4, 1.3e-4];
        assert!(
            errors
                .iter()
                .zip(bound)
                .all(|(error, bound)| *error < bound),
            "{errors:?}"
        );
        if half_angle > 30.0 {
            let rate = (errors[1] / errors[2]).log2();
            assert!((1.8..2.2).contains(&rate), "{half_angle}°: {errors:?}");
        }
    }
}

/// Nodes 0.1° apart around the end of contact and up to 3° elsewhere, so that at 25° seven of them share the peak.
#[test]
fn contact_ends_where_the_closed_form_says() {
    let conforming = [CONFORMING, 0.0, f64::NAN];
    for [half_angle, clearance, expected] in CLOSED_FORM.into_iter().chain([conforming]) {
        let mut angles = vec![0.0];
        let mut last = 0.0_f64;
        while last < 180.0 {
            let away = (last - half_angle).abs() - 1.0;
            last = (last + (0.3 * away).clamp(0.1, 3.0)).min(180.0);
            angles.push(last.to_radians());
        }
        let nodes = Nodes::mirrored(angles).unwrap();
        let p = solve(&nodes, clearance, Anchor::default());
        let touching = p.iter().filter(|p| **p > 0.0).count();
        let end = nodes.angles()[touching - 1].to_degrees();
        assert!(
            (end - half_angle).abs() < 0.2,
            "{end} {half_angle} {}",
            nodes.len()
        );
        if expected.is_finite() {
            assert!(
                (p[0] / expected - 1.0).abs() < 2e-3,
                "{}",
                p[0] / expected - 1.0
            );
        }
    }
}

/// How far the centre gives under a force, and whether the force acts there or over the area, changes no traction: only the first harmonic.
#[test]
fn how_the_pin_is_loaded_changes_no_pressure() {
    let nodes = Nodes::uniform_half(61).unwrap();
    let clearance = CLOSED_FORM[2][1];
    let own = solve(&nodes, clearance, Anchor::default());
    let smaller = solve(&nodes, clearance, Anchor::Centre { circle: 1e-9 });
    let over_area = solve(&nodes, clearance, Anchor::Area);
    let difference = |other: &[f64]| {
        own.iter()
            .zip(other)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max)
    };
    assert!(
        difference(&smaller) < 1e-10 * own[0],
        "{:e}",
        difference(&smaller)
    );
    // Linearly interpolated tractions have the normal part of a mode to their second order.
    assert!(
        difference(&over_area) < PI * 1e-4 * own[0],
        "{:e}",
        difference(&over_area)
    );
}

/// θ `[deg]` and σ_θ R t/Q of the closed form on the edge at 65°, six digits (table R1).
const HOOP: [[f64; 2]; 7] = [
    [0.0, 0.126568],
    [30.0, 0.159236],
    [60.0, 0.351279],
    [75.0, 0.485043],
    [90.0, 0.373824],
    [135.0, 0.069967],
    [180.0, -0.055894],
];
/// θ `[deg]`, σ_r, σ_θ and τ_rθ times R t/Q at five radii, at 65°, eight digits (table R1).
const RING: [[f64; 4]; 5] = [
    [0.0, -0.075580056, 0.01886026, 0.0],
    [45.0, -0.044490442, 0.01561923, 9.0317831e-05],
    [90.0, 0.0071295043, 0.0077223206, 0.011253758],
    [135.0, 0.02921881, -0.00056574129, 0.014247418],
    [180.0, 0.032050644, -0.0045989619, 2.8161244e-18],
];

/// Hoop stresses on the edge and stresses five radii away. The table is for a plate that is balanced far away, as a held hole is.
#[test]
fn stresses_of_the_plate_are_those_of_the_closed_form() {
    let material = Isotropic::new(1.0, 0.3, PlaneState::Stress).unwrap();
    let nodes = Nodes::uniform_half(121).unwrap();
    let p = solve(&nodes, CLOSED_FORM[2][1], Anchor::default());
    let plate = Hole::held(nodes.clone(), &material, UNIT, &[]).unwrap();
    let weights = nodes.weights();
    let forces: Vec<f64> = (nodes.angles().iter().zip(&p).zip(&weights))
        .flat_map(|((angle, p), weight)| [p * weight * angle.cos(), p * weight * angle.sin()])
        .collect();
    let state = BodyLoad {
        forces: &forces,
        multipliers: &[],
        motions: &[],
    };
    let field = plate.field(&state).unwrap();
    for [angle, expected] in HOOP {
        let found = field.edge(angle.to_radians()).hoop;
        // At 60° the nodes see the cusp at the end of contact.
        let bound = if angle == 60.0 { 3e-3 } else { 2e-4 };
        assert!((found - expected).abs() < bound, "{angle}°: {found}");
    }
    for [angle, radial, hoop, shear] in RING {
        let theta = angle.to_radians();
        let found = field
            .stress([5.0 * theta.cos(), 5.0 * theta.sin()])
            .unwrap();
        let errors = [
            found.radial - radial,
            found.hoop - hoop,
            found.shear - shear,
        ];
        assert!(
            errors.iter().all(|error| error.abs() < 2e-6),
            "{angle}°: {errors:?}"
        );
    }
}
