//! Rigid motions that no contact can resist, wherever it closes:
//!
//! ```text
//! G_n α = 0 at every point,     G_t α = 0 at every point with friction
//! ```
//!
//! In equilibrium the load does no work along such an α. Then every multiple of α may be added to a solution.

use nalgebra::{DMatrix, DVector};
use stickslip_friction::History;

use crate::problem::{FreeMotions, InterfaceProblem};
use crate::state::{ContactState, Status};

/// Singular values up to this part of the largest motion are those of a motion that nothing resists.
const NEGLIGIBLE: f64 = 1e-10;

/// Part of the largest contact force up to which a force is rounding.
const FORCELESS: f64 = 1e-10;
/// Part of the length of a motion from which it moves a point.
const MOVES: f64 = 1e-6;

/// A body that can move as a whole without resistance.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FreeBody {
    /// Index of the body.
    pub body: usize,
    /// Whether it turns, and does not only slide along straight contacts.
    pub turns: bool,
    /// Its pairs, in which the motion is slip.
    pub slipping: Vec<usize>,
}

/// The bodies that take part in motions without resistance, as [`unresisted_motions`] finds them; `apart` `[rad]` as there.
pub fn free_bodies(problem: &InterfaceProblem, apart: f64) -> Vec<FreeBody> {
    let motions = unresisted_motions(problem, apart);
    let still = NEGLIGIBLE.max(2.0 * apart);
    if motions.ncols() == 0 {
        return Vec::new();
    }
    let relative = problem.modes() * &motions;
    let moves = |body: usize| {
        let modes = problem.body_modes(problem.carrier(body));
        motions.rows_range(modes).amax() > NEGLIGIBLE.max(apart)
    };
    let free = |body: usize| {
        let pairs = problem.pairs().iter().enumerate();
        let own = pairs.filter(|(_, pair)| pair.first == body || pair.second == body);
        let own: Vec<usize> = own.map(|(index, _)| index).collect();
        let mut normals = own.iter().flat_map(|&pair| &problem.pairs()[pair].points);
        let first = normals.next().map(|point| point.normal);
        FreeBody {
            body,
            turns: normals.any(|point| Some(point.normal) != first),
            slipping: own
                .into_iter()
                .filter(|&pair| {
                    let points = problem.pair_points(pair);
                    relative.rows(2 * points.start, 2 * points.len()).amax() > still
                })
                .collect(),
        }
    };
    (0..problem.body_count())
        .filter(|&body| moves(body))
        .map(free)
        .collect()
}

/// The pairs whose gaps the contact of `state` leaves undetermined: a rigid motion that moves no pressed point along its normal
/// and no sticking one along its tangent changes no force, and the gaps of these pairs. Pairs that nothing presses are among them.
pub fn loose_pairs(problem: &InterfaceProblem, state: &ContactState) -> Vec<usize> {
    let sticks = |k: usize| state.status[k] == Status::Stick;
    let Some(relative) = unresisted(problem, state, sticks) else {
        return Vec::new();
    };
    let loose = |&pair: &usize| {
        let mut points = problem.pair_points(pair);
        points.any(|k| relative.row(2 * k).amax() > MOVES)
    };
    (0..problem.pairs().len()).filter(loose).collect()
}

/// The pairs with friction whose slip the increment from `committed` to `state`, in which the points slipped by `slip` `[length]`, leaves
/// undetermined: a rigid motion that moves no pressed point along its normal, and along its tangent only those that slip on with the same
/// friction, changes no force. As where all that presses a pin slips, and the pin may turn. Of several such motions each is asked
/// alone, so a pair that only a combination of them moves may be missing.
pub fn sliding_pairs(
    problem: &InterfaceProblem,
    committed: &ContactState,
    state: &ContactState,
    slip: &DVector<f64>,
) -> Vec<usize> {
    let least_force = FORCELESS * state.forces.amax();
    let bound = |k: usize| {
        let point = &problem.points()[k];
        let pressure = state.normal_force(k) / point.area;
        let law = problem.law(k);
        law.bound(pressure, slip[k].abs(), &point.place, &committed.history[k])
    };
    let friction = |k: usize| state.forces[2 * k + 1];
    let held = |k: usize| match state.status[k] {
        Status::Stick => {
            let largest = bound(k).stick * problem.points()[k].area;
            friction(k).abs() < largest - least_force
        }
        _ => bound(k).slip_ds != 0.0,
    };
    let Some(relative) = unresisted(problem, state, held) else {
        return Vec::new();
    };
    let pressed = pressed(&state.forces, &state.status);
    let rubbing: Vec<usize> = (0..slip.len())
        .filter(|&k| pressed(k) && bound(k).slip > 0.0)
        .collect();
    let least = FORCELESS * slip.amax();
    // Where a point stands still at its bound, the motion may only go against its friction.
    let goes = |motion: usize, sign: f64| {
        let turns_back = |k: &usize| {
            slip[*k].abs() <= least
                && friction(*k).signum() * sign * relative[(2 * k + 1, motion)] > MOVES
        };
        !rubbing.iter().any(turns_back)
    };
    let motions: Vec<usize> = (0..relative.ncols())
        .filter(|&motion| goes(motion, 1.0) || goes(motion, -1.0))
        .collect();
    let slides = |&pair: &usize| {
        let points = problem.pair_points(pair);
        let mut own = rubbing.iter().filter(|k| points.contains(k));
        own.any(|k| {
            motions
                .iter()
                .any(|&motion| relative[(2 * k + 1, motion)].abs() > MOVES)
        })
    };
    (0..problem.pairs().len()).filter(slides).collect()
}

/// Relative motions (g, Δs) of all points, 2n × m, in the rigid motions that move no pressed point along its normal and no pressed one that
/// is `held` along its tangent; `None` if there are none.
fn unresisted(
    problem: &InterfaceProblem,
    state: &ContactState,
    held: impl Fn(usize) -> bool,
) -> Option<DMatrix<f64>> {
    let pressed = pressed(&state.forces, &state.status);
    let rows = (0..state.status.len())
        .filter(|&k| pressed(k))
        .flat_map(|k| {
            [Some(2 * k), held(k).then_some(2 * k + 1)]
                .into_iter()
                .flatten()
        });
    Some(problem.modes() * FreeMotions::of(problem, rows)?.projector)
}

/// Whether a point is pressed under the contact forces `forces`, 2n; one that closes without force is as well a moment before it does.
pub(crate) fn pressed<'a>(
    forces: &'a DVector<f64>,
    status: &'a [Status],
) -> impl Fn(usize) -> bool + 'a {
    let least = FORCELESS * forces.amax();
    move |k| status[k].touches() && forces[2 * k] > least
}

/// Columns α of length 1 that nothing resists, m × f, in the units of [`InterfaceProblem::modes`].
///
/// `apart` is the largest angle `[rad]` by which points of round pairs stand along their edge beside those that they are paired with, 0 where
/// they face each other: bodies that turn together then change gaps by as much of their motion, which resists nothing.
pub fn unresisted_motions(problem: &InterfaceProblem, apart: f64) -> DMatrix<f64> {
    let modes = problem.modes();
    if modes.ncols() == 0 {
        return DMatrix::zeros(0, 0);
    }
    let mut resisted = modes.clone();
    for (k, point) in problem.points().iter().enumerate() {
        let bound = problem
            .law(k)
            .bound(1.0, 0.0, &point.place, &History::default());
        if bound.stick == 0.0 && bound.slip == 0.0 {
            resisted.row_mut(2 * k + 1).fill(0.0);
        }
    }
    // Rows that are missing change no null space, and give as many right vectors as motions.
    let missing = modes.ncols().saturating_sub(resisted.nrows());
    let rows = resisted.nrows();
    let svd = resisted.insert_rows(rows, missing, 0.0).svd(false, true);
    // Beside whole motions: where friction is missing, the normal parts of a turn about its centre are all rounding.
    let largest = modes
        .column_iter()
        .map(|mode| mode.norm())
        .fold(0.0, f64::max);
    let Some(right) = svd.v_t else {
        return DMatrix::zeros(modes.ncols(), 0);
    };
    let free: Vec<DVector<f64>> = (0..right.nrows())
        .filter(|&k| svd.singular_values[k] <= NEGLIGIBLE.max(apart) * largest)
        .map(|k| right.row(k).transpose())
        .collect();
    if free.is_empty() {
        return DMatrix::zeros(modes.ncols(), 0);
    }
    DMatrix::from_columns(&free)
}
