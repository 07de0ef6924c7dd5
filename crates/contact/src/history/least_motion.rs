//! Where a body hangs loose, it moves least.
//!
//! Rigid motions that move no pressed point along its normal, and no sticking one along its tangent, change no force, so a solver may leave
//! bodies anywhere along them. Of all such places the one is taken at which the surfaces have moved least against each other since the
//! increment began, without penetration and without slip turned back:
//!
//! ```text
//! min Σ a |Δ(g, s)|²,     g ≥ 0 where nothing presses,     σ Δs ≥ 0 where friction slips
//! ```
//!
//! It is unique but for motions that no point sees, so it keeps the symmetries of a scene, and it does not depend on the solver, nor on
//! which body is held.

use nalgebra::{DMatrix, DVector};

use crate::freedom::pressed;
use crate::problem::FreeMotions;
use crate::solver::Step;
use crate::solver::least_distance::least_distance;
use crate::state::{Status, TrialState};

/// Part of all that rigid motions move, below which a motion moves no point.
const UNSEEN: f64 = 1e-8;
/// Part of the largest motion that is rounding.
const ROUNDING: f64 = 1e-12;
/// Most ways to the nearest place without penetration, each from where the one before ended.
const WAYS: usize = 4;

/// Moves the bodies that hang loose in `trial`, the end of `step`, to where they have moved least.
pub(super) fn take(step: &Step<'_>, trial: &mut TrialState) {
    if step.problem.modes().ncols() == 0 {
        return;
    }
    let slips = slips(step, trial);
    let rows = (slips.iter().enumerate()).flat_map(|(k, slip)| {
        let normal = (*slip != Slip::Loose).then_some(2 * k);
        normal
            .into_iter()
            .chain((*slip == Slip::Held).then_some(2 * k + 1))
    });
    let Some(free) = FreeMotions::of(step.problem, rows) else {
        return;
    };
    let Some((amounts, change)) = least(step, trial, &free, &slips) else {
        return;
    };
    trial.rigid += amounts;
    trial.motion += change;
    let tolerance = ROUNDING * trial.motion.amax();
    for (k, slip) in slips.iter().enumerate() {
        if *slip == Slip::Loose && trial.motion[2 * k] > tolerance {
            trial.status[k] = Status::Open;
        }
    }
}

/// What each point allows.
fn slips(step: &Step<'_>, trial: &TrialState) -> Vec<Slip> {
    let pressed = pressed(&trial.forces, &trial.status);
    (0..step.count())
        .map(|k| {
            if pressed(k) {
                Slip::pressed(step, trial, k)
            } else {
                Slip::Loose
            }
        })
        .collect()
}

/// What a rigid motion may do to a point without changing a force.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Slip {
    /// Nothing presses the point: it may open.
    Loose,
    /// It may slide along, but not back against this sign; zero without friction.
    Along(f64),
    /// It may not slide.
    Held,
}

impl Slip {
    /// Of point `k`, which is pressed.
    fn pressed(step: &Step<'_>, trial: &TrialState, k: usize) -> Self {
        let slip = trial.motion[2 * k + 1] - step.committed.tangential_displacement(k);
        let bound = step.bound(k, trial.forces[2 * k], slip);
        let sign = trial.status[k].slip_sign();
        if bound.stick == 0.0 && bound.slip == 0.0 {
            Self::Along(0.0)
        } else if sign == 0.0 || bound.slip_ds != 0.0 {
            Self::Held
        } else {
            Self::Along(sign)
        }
    }
}

/// Amounts of the rigid motions that lead to the least motion, m, and what they change of (g, Δs), 2n; `None` if no point moves, or if
/// that place is not found.
fn least(
    step: &Step<'_>,
    trial: &TrialState,
    free: &FreeMotions,
    slips: &[Slip],
) -> Option<(DVector<f64>, DVector<f64>)> {
    let seen = Seen::of(step, trial, free)?;
    let bounds = bounds(step, trial, slips);
    let edges = DMatrix::from_fn(seen.moves.ncols(), bounds.len(), |motion, k| {
        bounds[k].sign * seen.moves[(bounds[k].row, motion)]
    });
    let largest = trial.motion.amax();
    let mut way = seen.unbounded;
    // The first way costs digits, which later ones find again.
    for _ in 0..WAYS {
        let reached = edges.tr_mul(&way);
        let lacking: Vec<f64> = (bounds.iter().zip(&reached))
            .map(|(bound, reached)| -bound.room - reached)
            .collect();
        if lacking.iter().all(|&lack| lack <= f64::EPSILON * largest) {
            break;
        }
        way += least_distance(&edges, &lacking)?;
    }
    let change = seen.moves * &way;
    let clear = |bound: &Bound| bound.sign * change[bound.row] >= -bound.room - ROUNDING * largest;
    (bounds.iter().all(clear)).then(|| (seen.amounts * way, change))
}

/// Those of the free motions that points see, in combinations whose Σ a |Δ(g, s)|² is the square of their amounts.
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
        let moves = modes * &free.basis;
        let weight = |row: usize| points[row / 2].area.sqrt();
        let weigh = |motions: &DMatrix<f64>| {
            DMatrix::from_fn(motions.nrows(), motions.ncols(), |row, motion| {
                weight(row) * motions[(row, motion)]
            })
        };
        let since = DVector::from_fn(moves.nrows(), |row, _| {
            weight(row) * (trial.motion[row] - step.committed.motion[row])
        });
        // Free motions may all be unseen: what points see of them is measured by what they see of any.
        let least = UNSEEN * weigh(modes).norm();
        let svd = weigh(&moves).svd(true, true);
        let (left, right) = (svd.u?, svd.v_t?);
        let seen: Vec<usize> = (0..svd.singular_values.len())
            .filter(|&k| svd.singular_values[k] > least)
            .collect();
        if seen.is_empty() {
            return None;
        }
        let combined = DMatrix::from_fn(moves.ncols(), seen.len(), |row, k| {
            right[(seen[k], row)] / svd.singular_values[seen[k]]
        });
        Some(Self {
            amounts: &free.basis * &combined,
            moves: moves * combined,
            unbounded: -left.select_columns(&seen).tr_mul(&since),
        })
    }
}

/// How far a component of (g, Δs) may go against a sign; what is beyond that, by rounding, stays as it is.
struct Bound {
    row: usize,
    sign: f64,
    room: f64,
}

fn bounds(step: &Step<'_>, trial: &TrialState, slips: &[Slip]) -> Vec<Bound> {
    let bound = |row: usize, sign: f64, place: f64| Bound {
        row,
        sign,
        room: (sign * place).max(0.0),
    };
    (slips.iter().enumerate())
        .filter_map(|(k, slip)| match *slip {
            Slip::Loose => Some(bound(2 * k, 1.0, trial.motion[2 * k])),
            Slip::Along(sign) if sign != 0.0 => {
                let slipped = trial.motion[2 * k + 1] - step.committed.tangential_displacement(k);
                Some(bound(2 * k + 1, sign, slipped))
            }
            Slip::Along(_) | Slip::Held => None,
        })
        .collect()
}
