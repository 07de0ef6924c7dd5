//! Tests of laminates from outside the crate.

mod bad_input;
mod contract_criteria;
mod contract_models;
mod criteria;
mod failure;
mod layup;
mod plasticity;
mod ply_discount;
mod reference;
mod report;
mod theory;

use approx::assert_abs_diff_eq;
use stickslip_laminate::{Laminate, Ply, PlyConstants, Strengths};

/// Strengths of the report's strength study (Post & Reddy 1988, part II, 4.4) [ksi].
const STRENGTHS: [f64; 5] = [229.4, 252.1, 10.1, 32.0, 17.3];

fn strengths() -> Strengths {
    let [xt, xc, yt, yc, s12] = STRENGTHS;
    Strengths {
        zt: Some(yt),
        zc: Some(yc),
        s13: Some(s12),
        s23: Some(0.5 * yc),
        ..Strengths::in_plane(xt, xc, yt, yc, s12)
    }
}

/// Ply of the report's strength study [ksi, in], with expansions of a usual carbon-epoxy ply [1/°F] and linear strain limits.
fn constants() -> PlyConstants {
    PlyConstants {
        e1: 19_100.0,
        e2: 2_000.0,
        g12: 900.0,
        nu12: 0.3,
        alpha1: 0.2e-6,
        alpha2: 15.0e-6,
        thickness: 0.005,
    }
}

fn ply_with(strengths: Strengths) -> Ply {
    let PlyConstants { e1, e2, g12, .. } = constants();
    Ply::new(
        "carbon",
        constants(),
        strengths.with_linear_strain_limits(e1, e2, g12),
    )
    .unwrap()
}

fn ply() -> Ply {
    ply_with(strengths())
}

fn laminate(layup: &str) -> Laminate {
    Laminate::new(&layup.parse().unwrap(), &ply()).unwrap()
}

/// Entries agree to `relative` of the largest entry of `b`.
fn assert_matrix(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3], relative: f64) {
    let size = b.iter().flatten().fold(0.0_f64, |m, v| m.max(v.abs()));
    for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
        assert_abs_diff_eq!(*a, *b, epsilon = relative * size);
    }
}

fn assert_vector(a: &[f64], b: &[f64], relative: f64) {
    let size = b.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    assert_eq!(a.len(), b.len());
    for (a, b) in a.iter().zip(b) {
        assert_abs_diff_eq!(*a, *b, epsilon = relative * size);
    }
}
