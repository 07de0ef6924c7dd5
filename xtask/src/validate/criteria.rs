//! Failure criteria that the table of laminates leaves out, against reserve factors by hand.
//!
//! Strengths and stresses are such that every polynomial has rational coefficients and its root can be written down. σ_held stays, and
//! σ_applied is multiplied by the reserve factor r:
//!
//! ```text
//! Hashin         X = 1500, 1000;  Y = 50, 200;  S₁₂ = 100, S₂₃ = 80
//!   fibre tension        (900/1500)² + (80/100)² = 1
//!   fibre compression    500/1000
//!   matrix tension       (30/50)² + (80/100)² = 1;   of held (0, 10, 0) and applied (0, 20, 40): r² + r/2 = 3, r = 3/2
//!   matrix compression   [(200/160)² − 1] = 9/16, so uniaxial (200/160)² − 9/16 = 1;
//!                        of (0, −80, 60): (1/4 + 9/25) r² − 9/40 r = 1, r = (9/40 + √(2.490625))/1.22
//!
//! Tsai–Hill      X = 100, 120;  Y = 50, 150;  Z = 60, 150;  T = 50, S = 50, R = 40,  1/Z² = 25/9 · 10⁻⁴ in tension
//!   plane, (60, 30, 0)       9/25 + 9/25 − 20/9 · 10⁻⁴ · 1800 = 8/25,   r = 5/(2√2)
//!   plane, (60, −60, 10)     9/25 + 4/25 + 36 · 10⁻² + 1/25 = 23/25,    r = 5/√23
//!   shear, τ₂₃ 32, τ₁₃ 30    16/25 + 9/25 = 1
//!   solid, (60, 30, 30)      9/25 + 9/25 + 1/4 − 2/5 − 13/25 + 1/25 = 9/100,   r = 10/3
//!
//! maximum strain   E₁ = 10⁵, E₂ = 10⁴, ν₁₂ = 1/4, G₁₂ = 5000;  ε₁ = 0.01, 0.008;  ε₂ = 0.005, 0.02;  γ = 0.02
//!   (500, 20, 40)     ε₁ = 0.005 − 0.00005,     r = 0.01/0.00495 = 200/99
//!   (0, −100, 0)      ε₂ = −0.01,               r = 2
//!   (−400, 60, 0)     ε₂ = 0.006 + 0.001,       r = 5/7, where stress alone would leave the strain of 0.006
//!   held and applied (200, 0, 0)   0.002 (1 + r) = 0.01,   r = 4
//! ```

use std::collections::BTreeMap;

use serde::Deserialize;
use stickslip_laminate::failure::{TsaiHillSolid, criterion_named};
use stickslip_laminate::{Assessment, Ply, PlyConstants, PlyLoading, Strengths};

use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use crate::publish::TaskError;

/// Relative error of closed forms on both sides.
const CLOSED: f64 = 1e-10;

/// A stress with its reserve factor and mode.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct State {
    #[serde(default)]
    held: [f64; 3],
    applied: Vec<f64>,
    factor: f64,
    mode: String,
}

pub(super) fn checks(_: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let states: BTreeMap<String, Vec<State>> = toml::from_str(include_str!("criteria.toml"))?;
    let mut checks = Checks::against("the root of Hashin's (1980) polynomials by hand");
    let hashin = ply(Strengths {
        s23: Some(80.0),
        ..Strengths::in_plane(1500.0, 1000.0, 50.0, 200.0, 100.0)
    })?;
    plane(&mut checks, "hashin", &hashin, &states)?;
    checks.now_against("the root of Post & Reddy's (1988) form by hand");
    let hill = ply(Strengths {
        zt: Some(60.0),
        zc: Some(150.0),
        s13: Some(50.0),
        s23: Some(40.0),
        ..Strengths::in_plane(100.0, 120.0, 50.0, 150.0, 50.0)
    })?;
    plane(&mut checks, "tsai_hill_3d", &hill, &states)?;
    for state in &states["solid"] {
        let stress = state.applied.as_slice().try_into()?;
        let found = TsaiHillSolid.assess_solid(&hill, &[0.0; 6], stress)?;
        compare(&mut checks, &format!("{stress:?}"), &found, state);
    }
    checks.now_against("strains by Hooke's law and their limits, by hand");
    let limited = ply(Strengths {
        strain_1t: Some(0.01),
        strain_1c: Some(0.008),
        strain_2t: Some(0.005),
        strain_2c: Some(0.02),
        strain_12: Some(0.02),
        ..Strengths::default()
    })?;
    plane(&mut checks, "max_strain", &limited, &states)?;
    Ok(checks.into_list())
}

fn ply(strengths: Strengths) -> Result<Ply, TaskError> {
    let constants = PlyConstants {
        e1: 1e5,
        e2: 1e4,
        g12: 5e3,
        nu12: 0.25,
        alpha1: 0.0,
        alpha2: 0.0,
        thickness: 1.0,
    };
    Ok(Ply::new("by hand", constants, strengths)?)
}

/// The states of a criterion.
fn plane(
    checks: &mut Checks,
    criterion: &str,
    ply: &Ply,
    states: &BTreeMap<String, Vec<State>>,
) -> Result<(), TaskError> {
    let chosen = criterion_named(criterion)?;
    for state in &states[criterion] {
        let loading = PlyLoading {
            held: state.held,
            applied: state.applied.as_slice().try_into()?,
        };
        let PlyLoading { held, applied } = &loading;
        let stress = if *held == [0.0; 3] {
            format!("{applied:?}")
        } else {
            format!("{applied:?} on {held:?}")
        };
        compare(checks, &stress, &chosen.assess(ply, &loading)?, state);
    }
    Ok(())
}

/// The reserve factor and the mode; another mode is an error of 1.
fn compare(checks: &mut Checks, stress: &str, found: &Assessment, known: &State) {
    let factor = known.factor;
    let error = if found.mode.name() == known.mode {
        (found.reserve_factor / factor - 1.0).abs()
    } else {
        1.0
    };
    checks.rounding_below(
        format!("{} under {stress}: r = {factor:.6}", found.criterion),
        (
            format!("{:.6}, {}", found.reserve_factor, found.mode),
            error,
        ),
        CLOSED,
    );
}
