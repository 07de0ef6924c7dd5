//! Where a body hangs loose, it moves least.
//!
//! Rigid motions that move no pressed point change no force, so a solver may leave bodies anywhere along them. Of all such places the
//! one is taken at which the surfaces have moved least against each other since the increment began, without penetration:
//!
//! ```text
//! min Σ a |Δ(g, s)|² / Σ a,     g ≥ 0 where nothing presses
//! ```
//!
//! It is unique but for motions of bodies that go together, so it keeps the symmetries of a scene and does not depend on the solver.
//! Pressed points slip as the solver found it, also where their slip is in a range.

use nalgebra::{DMatrix, DVector};

use crate::freedom::pressed;
use crate::problem::FreeMotions;
use crate::solver::accept::ACCEPTED;
use crate::solver::least_distance::least_distance;
use crate::solver::{Residuals, Step};
use crate::state::{Status, TrialState};

/// Part of what points see of the single rigid motions below which a motion is one of bodies that go together: points of both sides of an
/// open gap stand apart, and see the clearance of a common turn.
const UNSEEN: f64 = 0.1;

/// Moves the bodies that hang loose in `trial`, the end of `step`, to where they have moved least.
pub(super) fn take(step: &Step<'_>, trial: &mut TrialState) {
    if step.problem.modes().ncols() == 0 {
        return;
    }
    let (held, loose): (Vec<usize>, Vec<usize>) = {
        let pressed = pressed(&trial.forces, &trial.status);
        (0..step.count()).partition(|&k| pressed(k))
    };
    let rows = held.iter().flat_map(|&k| [2 * k, 2 * k + 1]);
    let free = FreeMotions::of(step.problem, rows);
    let Some((amounts, change)) = free.and_then(|free| least(step, trial, &free, &loose)) else {
        return;
    };
    let mut moved = trial.clone();
    moved.rigid += amounts;
    moved.motion += change;
    for k in loose {
        moved.status[k] = Status::Open;
    }
    // Where rounding takes more than the motion is worth, bodies stay.
    let before = Residuals::of(step, trial).largest();
    if Residuals::of(step, &moved).largest() <= before.max(ACCEPTED) {
        *trial = moved;
    }
}

/// Amounts of the rigid motions that lead to the least motion, m, and what they change of (g, Δs), 2n, where the points `loose` may open; `None`
/// if no point moves, or if that place is not found.
fn least(
    step: &Step<'_>,
    trial: &TrialState,
    free: &FreeMotions,
    loose: &[usize],
) -> Option<(DVector<f64>, DVector<f64>)> {
    let seen = Seen::of(step, trial, free)?;
    let edges = DMatrix::from_fn(seen.moves.ncols(), loose.len(), |motion, k| {
        seen.moves[(2 * loose[k], motion)]
    });
    // What penetrates, by rounding, stays as it is.
    let room: Vec<f64> = loose.iter().map(|k| trial.motion[2 * k].max(0.0)).collect();
    let mut way = seen.unbounded;
    let reached = edges.tr_mul(&way);
    let lacking: Vec<f64> = (room.iter().zip(&reached))
        .map(|(room, reached)| -room - reached)
        .collect();
    if lacking.iter().any(|&lack| lack > 0.0) {
        way += least_distance(&edges, &lacking)?;
    }
    Some((seen.amounts * &way, seen.moves * way))
}

/// Those of the free motions that points see, in combinations whose Σ a |Δ(g, s)|² / Σ a is the square of their amounts.
struct Seen {
    /// Amounts of the rigid motions, m × s.
    amounts: DMatrix<f64>,
    /// What they move, 2n × s.
    moves: DMatrix<f64>,
    /// How much of each leads to the least motion without bounds, s.
    unbounded: DVector<f64>,
}

impl Seen {
    /// `None` if no point sees any.
    fn of(step: &Step<'_>, trial: &TrialState, free: &FreeMotions) -> Option<Self> {
        let (points, modes) = (step.problem.points(), step.problem.modes());
        let whole: f64 = points.iter().map(|point| 2.0 * point.area).sum();
        let weight = |row: usize| (points[row / 2].area / whole).sqrt();
        let weigh = |motions: &DMatrix<f64>| {
            DMatrix::from_fn(motions.nrows(), motions.ncols(), |row, motion| {
                weight(row) * motions[(row, motion)]
            })
        };
        let amounts = evened(&free.basis, &weigh(modes))?;
        let moves = modes * &amounts;
        let since = DVector::from_fn(moves.nrows(), |row, _| {
            weight(row) * (trial.motion[row] - step.committed.motion[row])
        });
        let svd = weigh(&moves).svd(true, true);
        let (left, right) = (svd.u?, svd.v_t?);
        let seen: Vec<usize> = (0..svd.singular_values.len())
            .filter(|&k| svd.singular_values[k] > UNSEEN)
            .collect();
        if seen.is_empty() {
            return None;
        }
        let combined = DMatrix::from_fn(moves.ncols(), seen.len(), |row, k| {
            right[(seen[k], row)] / svd.singular_values[seen[k]]
        });
        Some(Self {
            amounts: amounts * &combined,
            moves: moves * combined,
            unbounded: -left.select_columns(&seen).tr_mul(&since),
        })
    }
}

/// Amounts of rigid motions that span the same as `basis`, m × f, orthonormal where each is counted in what points see of it alone, the columns of
/// `weighed`; `None` if they see none.
fn evened(basis: &DMatrix<f64>, weighed: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let whole = Some(weighed.norm()).filter(|whole| *whole > 0.0)?;
    let unit = |mode: usize| match weighed.column(mode).norm() {
        0.0 => whole,
        own => own,
    };
    let units = DVector::from_fn(weighed.ncols(), |mode, _| unit(mode));
    let mut amounts = basis.clone();
    for mut motion in amounts.column_iter_mut() {
        motion.component_mul_assign(&units);
    }
    let mut amounts = amounts.qr().q();
    for mut motion in amounts.column_iter_mut() {
        motion.component_div_assign(&units);
    }
    Some(amounts)
}
