//! Contact springs added to the stiffness of the bodies, as most finite-element codes do it.
//!
//! ```text
//! body:     [ C  R ] [λ_b]   [ u − u⁰ ]                [ C  R ]⁻¹   [ S  Y ]
//!           [ Rᵀ 0 ] [ α ] = [  −r    ]      ⇒   with  [ Rᵀ 0 ]   = [ Yᵀ · ]    λ_b = S (u − u⁰) − Y r
//! springs:  λ = λ₀ − k P d,   d = d₀ + Σ B_b u_b,   λ_b = B_bᵀ λ
//! whole:    (S + k Bᵀ P B) u = S u⁰ + Y r + Bᵀ (λ₀ − k P d₀)
//! ```
//!
//! S is the stiffness of a body condensed on its contact nodes, C, R, u⁰ and r are those of its interface operator. d holds gaps and
//! slip increments, d₀ those of bodies at rest. P are the statuses: (P d)_n = g_n at touching points; (P d)_t = Δs at sticking ones, where
//! λ₀ is the last tangential force, and −σ μ g_n at slipping ones. Statuses are those of the exact answer, so that only springs and
//! rounding make a difference: a force is k times the difference of two displacements that are k times larger than it.

use nalgebra::{DMatrix, DVector};
use stickslip_contact::Status;
use stickslip_contact::state::TrialState;
use stickslip_fem_core::InterfaceOperator;
use stickslip_laboratory::discrete::Discrete;

use crate::publish::TaskError;
use crate::stability::joint::Joint;

/// Compliance and rigid motion of a node, relative to the largest, that count as zero: a motion that symmetry excludes.
const NEGLIGIBLE: f64 = 1e-12;

/// Stiffness of the bodies side by side, what they carry without contact, and how their nodes move the contact points.
struct Bodies {
    stiffness: DMatrix<f64>,
    carried: DVector<f64>,
    relative: DMatrix<f64>,
}

/// Contact forces `[force]` of the step `given` of the bodies of `joint` with springs `factor` times as stiff as a mean contact
/// component, the statuses being those of `answer`. The law's bound must be proportional to pressure.
pub(super) fn forces(
    joint: &Joint,
    given: &Discrete,
    answer: &TrialState,
    factor: f64,
) -> Result<DVector<f64>, TaskError> {
    let compliance = given.problem.compliance().to_matrix();
    let spring = factor * compliance.nrows() as f64 / compliance.trace();
    let bodies = bodies(joint, given)?;
    let (springs, held) = springs(given, answer, spring);
    let mut rest = DVector::zeros(held.len());
    for (k, point) in given.problem.points().iter().enumerate() {
        rest[2 * k] = point.gap;
        rest[2 * k + 1] = -given.committed.tangential_displacement(k);
    }
    let side = bodies.carried + bodies.relative.tr_mul(&(&held - &springs * &rest));
    let matrix = bodies.stiffness + bodies.relative.transpose() * &springs * &bodies.relative;
    let motion = matrix
        .lu()
        .solve(&side)
        .ok_or("springs and stiffness are singular together")?;
    Ok(held - springs * (rest + bodies.relative * motion))
}

fn bodies(joint: &Joint, given: &Discrete) -> Result<Bodies, TaskError> {
    let count = 2 * given.problem.points().len();
    let parts = joint
        .operators
        .iter()
        .enumerate()
        .map(|(index, operator)| body(operator.interface(), index, given))
        .collect::<Result<Vec<Bodies>, TaskError>>()?;
    let size = parts.iter().map(|part| part.carried.len()).sum();
    let mut whole = Bodies {
        stiffness: DMatrix::zeros(size, size),
        carried: DVector::zeros(size),
        relative: DMatrix::zeros(count, size),
    };
    let mut start = 0;
    for part in parts {
        let own = part.carried.len();
        let mut block = whole.stiffness.view_mut((start, start), (own, own));
        block.copy_from(&part.stiffness);
        whole.carried.rows_mut(start, own).copy_from(&part.carried);
        whole
            .relative
            .columns_mut(start, own)
            .copy_from(&part.relative);
        start += own;
    }
    Ok(whole)
}

fn body(
    operator: &dyn InterfaceOperator,
    index: usize,
    given: &Discrete,
) -> Result<Bodies, TaskError> {
    let all = operator
        .compliance()
        .ok_or("a rigid body has no stiffness")?;
    let modes = operator.modes();
    let moves = |row: &usize| {
        all[(*row, *row)] > NEGLIGIBLE * all.diagonal().max() || modes.row(*row).amax() > NEGLIGIBLE
    };
    let rows: Vec<usize> = (0..all.nrows()).filter(moves).collect();
    let (size, rigid) = (rows.len(), modes.ncols());
    let held = modes.select_rows(&rows);
    let mut bordered = DMatrix::zeros(size + rigid, size + rigid);
    bordered
        .view_mut((0, 0), (size, size))
        .copy_from(&all.select_rows(&rows).select_columns(&rows));
    bordered.view_mut((0, size), (size, rigid)).copy_from(&held);
    bordered
        .view_mut((size, 0), (rigid, size))
        .copy_from(&held.transpose());
    let inverse = bordered.try_inverse().ok_or("a body has no stiffness")?;
    let stiffness = inverse.view((0, 0), (size, size)).into_owned();
    let mut carried = DVector::zeros(size);
    for (case, &multiplier) in given.multipliers.iter().enumerate() {
        if let Some(response) = operator.load_response(case) {
            let own = DVector::from_iterator(size, rows.iter().map(|&row| response[row]));
            carried += &stiffness * own * multiplier;
        }
        let balanced = inverse.view((0, size), (size, rigid)) * operator.mode_load(case);
        carried += balanced * multiplier;
    }
    let mut relative = DMatrix::zeros(2 * given.problem.points().len(), all.nrows());
    for row in given.problem.body_rows(index) {
        for (node, weight) in row.terms {
            let mut block = relative.fixed_view_mut::<2, 2>(2 * row.point, 2 * node);
            block += weight;
        }
    }
    Ok(Bodies {
        stiffness,
        carried,
        relative: relative.select_columns(&rows),
    })
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
        if *status == Status::Stick && given.problem.points()[k].slides {
            springs[(tangential, tangential)] = spring;
            held[tangential] = given.committed.forces[tangential];
        }
        let coefficient = step.bound(k, 1.0, 0.0).slip;
        springs[(tangential, normal)] = -status.slip_sign() * coefficient * spring;
    }
    (springs, held)
}
