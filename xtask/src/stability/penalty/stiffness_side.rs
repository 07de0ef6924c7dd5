//! Contact springs added to the stiffness of the bodies, as most finite-element codes do it.
//!
//! ```text
//! C⁻¹ (d − d₀ − G α) = λ,    λ = λ₀ − k P d,    Gᵀ λ + r = 0       ⇒
//! [ C⁻¹ + k P   −C⁻¹ G ] [d]   [ C⁻¹ d₀ + λ₀ ]
//! [ k Gᵀ P         0   ] [α] = [ r + Gᵀ λ₀   ]
//! ```
//!
//! d holds gaps and slip increments, d₀ those without contact forces, C is the compliance of the points (so C⁻¹ is the stiffness of
//! the bodies condensed on them), k the stiffness of the springs, and P the statuses: (P d)_n = g_n at touching points;
//! (P d)_t = Δs at sticking ones, where λ₀ is the last tangential force, and −σ μ g_n at slipping ones. Statuses are those of the exact
//! answer, so that only springs and rounding make a difference.

use nalgebra::{DMatrix, DVector};
use stickslip_contact::Status;
use stickslip_contact::state::TrialState;
use stickslip_laboratory::discrete::Discrete;

use crate::stability::Trouble;

/// Compliance relative to the largest that is none.
const NEGLIGIBLE: f64 = 1e-12;

/// Contact forces `[force]` of the step `given` with springs `factor` times as stiff as a mean contact component, the statuses being
/// those of `answer`. The law's bound must be proportional to pressure.
pub(super) fn forces(
    given: &Discrete,
    answer: &TrialState,
    factor: f64,
) -> Result<DVector<f64>, Trouble> {
    let step = given.step();
    let all = given.problem.compliance();
    // A tangential motion that symmetry excludes gives no stiffness.
    let gives = |row: &usize| all[(*row, *row)] > NEGLIGIBLE * all.diagonal().max();
    let rows: Vec<usize> = (0..all.nrows()).filter(gives).collect();
    let compliance = all.select_rows(&rows).select_columns(&rows);
    let modes = given.problem.modes().select_rows(&rows);
    let free = DVector::from_iterator(rows.len(), rows.iter().map(|&row| step.free_motion()[row]));
    let (size, rigid) = modes.shape();
    let spring = factor * size as f64 / compliance.trace();
    let stiffness = compliance
        .cholesky()
        .ok_or("the compliance is not positive definite")?
        .inverse();
    let (springs, held) = springs(given, answer, spring);
    let springs = springs.select_rows(&rows).select_columns(&rows);
    let held = DVector::from_iterator(rows.len(), rows.iter().map(|&row| held[row]));
    let mut matrix = DMatrix::zeros(size + rigid, size + rigid);
    matrix
        .view_mut((0, 0), (size, size))
        .copy_from(&(&stiffness + &springs));
    matrix
        .view_mut((0, size), (size, rigid))
        .copy_from(&(-(&stiffness * &modes)));
    matrix
        .view_mut((size, 0), (rigid, size))
        .copy_from(&(modes.transpose() * &springs));
    let mut side = DVector::zeros(size + rigid);
    side.rows_mut(0, size)
        .copy_from(&(&stiffness * free + &held));
    side.rows_mut(size, rigid)
        .copy_from(&(step.mode_load() + modes.tr_mul(&held)));
    let solved = matrix
        .lu()
        .solve(&side)
        .ok_or("springs and stiffness are singular together")?;
    let pressed = held - springs * solved.rows(0, size);
    let mut forces = DVector::zeros(all.nrows());
    for (value, row) in pressed.iter().zip(rows) {
        forces[row] = *value;
    }
    Ok(forces)
}

/// k P and λ₀ of all points.
fn springs(given: &Discrete, answer: &TrialState, spring: f64) -> (DMatrix<f64>, DVector<f64>) {
    let step = given.step();
    let size = answer.forces.len();
    let mut springs = DMatrix::zeros(size, size);
    let mut held = DVector::zeros(size);
    for (k, status) in answer.status.iter().enumerate() {
        let (normal, tangential) = (2 * k, 2 * k + 1);
        if status.touches() {
            springs[(normal, normal)] = spring;
        }
        if *status == Status::Stick {
            springs[(tangential, tangential)] = spring;
            held[tangential] = given.committed.forces[tangential];
        }
        let coefficient = step.bound(k, 1.0, 0.0).slip;
        springs[(tangential, normal)] = -status.slip_sign() * coefficient * spring;
    }
    (springs, held)
}
