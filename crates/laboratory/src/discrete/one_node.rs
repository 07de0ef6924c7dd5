//! One contact node (Klarbring 1990): every solution in closed form.
//!
//! ```text
//! k_t u_t + k_c u_n = F_t + λ_t,   k_c u_t + k_n u_n = F_n + λ_n
//! open:    u = K⁻¹ F
//! stick:   u_n = −g₀,  u_t = u_last
//! slip σ:  u_n = −g₀,  (k_t + σμ k_c) u_t = F_t + k_c g₀ + σμ (F_n + k_n g₀),   λ_t = −σ μ λ_n
//! ```
//!
//! Up to μ_c = k_t/|k_c| there is one solution; above it there may be three.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_contact::state::TrialState;
use stickslip_contact::{ContactState, Status};
use stickslip_fem_core::GivenBody;
use stickslip_friction::Coulomb;

use super::{Discrete, GroundPoint, Known, on_ground};
use crate::error::LaboratoryError;

/// Relative rounding of an admissibility condition.
const ROUNDING: f64 = 1e-13;

/// The coefficient of friction μ_c = k_t/|k_c| `[1]` up to which the node with `stiffness` [[k_t, k_c], [k_c, k_n]]
/// `[force/length]` has one solution; infinite without coupling.
pub fn one_node_bound(stiffness: [[f64; 2]; 2]) -> f64 {
    stiffness[0][0] / stiffness[0][1].abs()
}

/// One node with `stiffness` [[k_t, k_c], [k_c, k_n]] `[force/length]`, positive definite, and friction `mu` `[1]`, under `force` (F_t, F_n) `[force]`,
/// with initial gap `gap` `[length]` and last tangential displacement `previous` `[length]`, and all its solutions.
///
/// # Errors
/// [`LaboratoryError`] if `mu` is negative or not finite, `stiffness` is singular, or another number is not finite.
pub fn one_node(
    mu: f64,
    stiffness: [[f64; 2]; 2],
    force: [f64; 2],
    gap: f64,
    previous: f64,
) -> Result<Discrete, LaboratoryError> {
    let [[tangential, coupling], [_, normal]] = stiffness;
    // Contact components are ordered (n, t).
    let matrix = DMatrix::from_row_slice(2, 2, &[normal, coupling, coupling, tangential]);
    let refuse = |cause: &dyn std::fmt::Display| {
        LaboratoryError::Missing(format!("one node, μ = {mu}: {cause}"))
    };
    let compliance = matrix
        .try_inverse()
        .ok_or_else(|| refuse(&format!("the stiffness {stiffness:?} is singular")))?;
    let response = &compliance * DVector::from_vec(vec![force[1], force[0]]);
    let body = GivenBody::held(compliance, vec![response])?;
    let law = Coulomb::new(mu).map_err(|cause| refuse(&cause))?;
    let problem = on_ground(&body, &[GroundPoint::along_x(gap)], Arc::new(law))?;
    let mut committed = ContactState::unloaded(&problem);
    committed.motion[1] = previous;
    Ok(Discrete {
        name: format!("one node, μ = {mu}"),
        problem,
        committed,
        multipliers: vec![1.0],
        coercive: true,
        solutions: Some(solutions(mu, stiffness, force, gap, previous)),
    })
}

/// A node without load that was pushed against friction with the coefficient `mu` `[1]`: beyond μ_c = 1.5 it can stay wedged.
///
/// # Errors
/// [`LaboratoryError`] if `mu` is negative or not finite.
pub fn wedged(mu: f64) -> Result<Discrete, LaboratoryError> {
    const STIFFNESS: [[f64; 2]; 2] = [[3.0, -2.0], [-2.0, 3.0]];
    let mut discrete = one_node(mu, STIFFNESS, [0.0, 0.0], 0.0, -1.0)?;
    discrete.name = format!("one node without load, pushed before, μ = {mu}");
    // What held it: the force of the wedged state as far as friction carries it, the rest by a load that is gone.
    discrete.committed.forces = DVector::from_vec(vec![2.0, -f64::min(3.0, 2.0 * mu)]);
    discrete.committed.motion[0] = 0.0;
    discrete.committed.status = vec![Status::Stick];
    Ok(discrete)
}

fn solutions(
    mu: f64,
    [[tangential, coupling], [_, normal]]: [[f64; 2]; 2],
    [push, press]: [f64; 2],
    gap: f64,
    previous: f64,
) -> Known {
    let forces = |u_t: f64, u_n: f64| {
        [
            coupling * u_t + normal * u_n - press,
            tangential * u_t + coupling * u_n - push,
        ]
    };
    let length = previous.abs().max(gap.abs());
    let scale = push
        .abs()
        .max(press.abs())
        .max(normal.max(tangential) * length);
    let small = ROUNDING * scale;
    let small_length = ROUNDING * (scale / normal.min(tangential)).max(length);
    let mut known = Known {
        complete: true,
        states: Vec::new(),
    };
    let mut keep = |status: Status, u_t: f64, u_n: f64, [force_n, force_t]: [f64; 2]| {
        let forces = DVector::from_vec(vec![force_n, force_t]);
        let same = |state: &TrialState| (&state.forces - &forces).amax() <= 1e3 * small;
        if !known.states.iter().any(same) {
            known.states.push(TrialState {
                forces,
                motion: DVector::from_vec(vec![gap + u_n, u_t]),
                rigid: DVector::zeros(0),
                status: vec![status],
            });
        }
    };
    let determinant = tangential * normal - coupling * coupling;
    let free_t = (normal * push - coupling * press) / determinant;
    let free_n = (tangential * press - coupling * push) / determinant;
    if gap + free_n >= -small_length {
        keep(Status::Open, free_t, free_n, [0.0, 0.0]);
    }
    let [force_n, force_t] = forces(previous, -gap);
    if force_n >= -small && force_t.abs() <= mu * force_n + small {
        keep(Status::Stick, previous, -gap, [force_n, force_t]);
    }
    let mut continuum = false;
    for status in [Status::SlipPositive, Status::SlipNegative] {
        let drag = status.slip_sign() * mu;
        let slope = tangential + drag * coupling;
        if slope.abs() <= ROUNDING * tangential {
            continuum = true;
            continue;
        }
        let u_t = (push + coupling * gap + drag * (press + normal * gap)) / slope;
        let [force_n, _] = forces(u_t, -gap);
        if force_n >= -small && status.slip_sign() * (u_t - previous) >= -small_length {
            keep(status, u_t, -gap, [force_n, -drag * force_n]);
        }
    }
    known.complete = !continuum;
    known
}
