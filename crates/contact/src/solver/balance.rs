//! Decides whether the load can be balanced at all, with a proof by Farkas' lemma where it cannot; and finds where unloaded bodies are
//! clear of each other.
//!
//! Contact forces that obey the friction cones act on the rigid motions through Gᵀλ = A z, z ≥ 0, where the columns of A are
//! the edges G_n ± μ G_t of the cones. The load r has no balance if and only if the nearest point of the cone {A z} to −r
//! leaves a remainder ρ = r + A z ≠ 0: then ρ·a ≥ 0 for every column and ρ·r > 0, so along the rigid motion ρ the load does
//! work and no admissible contact force works against it.
//!
//! μ is the largest coefficient of the law at a point over three histories: untouched, as now, and after long slip. So the proof holds for
//! every path to the load if the law's coefficient stays within the range of these three histories. For a law that does not declare its
//! bound proportional to pressure, μ is the largest at several pressures about that of the load, which is an indication and no proof.

use nalgebra::{DMatrix, DVector};

use super::least_distance::{least_distance, nearest};
use super::step::Step;
use super::{FailureCause, FreeMotions};
use stickslip_friction::{History, PointStatus};

/// Relative size of a remainder that counts.
const NEGLIGIBLE: f64 = 1e-9;
/// Relative size of what counts as zero of a motion along an edge of a cone.
const SLIDING: f64 = 1e-6;
/// Clearances to the place along a load from which that of its least potential is sought.
const FAR: f64 = 1e4;
/// Largest way to where a load comes to rest, in clearances.
const MOST_CLEARANCES: f64 = 4.0;

/// The rigid motions nearest to the last accepted ones at which nothing penetrates, without contact forces; `None` if loads push
/// floating bodies, or if there are none.
pub(super) fn clear(step: &Step<'_>) -> Option<DVector<f64>> {
    let pushed = step.mode_load.amax() > 0.0;
    (!pushed)
        .then(|| nearest_clear(step, &step.committed.rigid))
        .flatten()
}

/// The rigid motions at which the load `push` `[force]` comes to rest without friction and deformation, the bodies of `step` being without
/// contact forces. `None` if it does not come to rest within the clearance. What no normal resists does not move.
pub(crate) fn settled(step: &Step<'_>, push: &DVector<f64>) -> Option<DVector<f64>> {
    let (problem, here) = (step.problem, &step.committed.rigid);
    let normals = (0..step.count()).map(|k| 2 * k);
    let push = match FreeMotions::of(problem, normals) {
        Some(free) => push - free.projector * push,
        None => push.clone(),
    };
    let units = units(step);
    let direction = push.component_mul(&units).component_mul(&units);
    let gaps = step.motion(&DVector::zeros(2 * step.count()), here);
    let clearance = (0..step.count()).fold(0.0, |most: f64, k| most.max(gaps[2 * k]));
    let speed = (problem.modes() * &direction).amax();
    let reach = direction * (clearance / speed);
    if !reach.iter().all(|amount| amount.is_finite()) {
        return None;
    }
    // Of all places that are clear, the one nearest to a far one along the load is that of its least potential; from a near one the digits that the
    // far one costs are found again.
    let rest = nearest_clear(step, &(here + &reach * FAR))?;
    let rest = nearest_clear(step, &(rest + reach))?;
    let way = (problem.modes() * (&rest - here)).amax();
    (way <= MOST_CLEARANCES * clearance).then_some(rest)
}

/// The rigid motions nearest to `place` at which nothing penetrates, without contact forces; `None` if nothing does at `place`.
fn nearest_clear(step: &Step<'_>, place: &DVector<f64>) -> Option<DVector<f64>> {
    if place.is_empty() {
        return None;
    }
    let motion = step.motion(&DVector::zeros(2 * step.count()), place);
    if (0..step.count()).all(|k| motion[2 * k] >= 0.0) {
        return None;
    }
    let units = units(step);
    let edges = DMatrix::from_fn(place.len(), step.count(), |row, k| {
        step.problem.modes()[(2 * k, row)] * units[row]
    });
    let ways_out: Vec<f64> = (0..step.count()).map(|k| -motion[2 * k]).collect();
    Some(place + least_distance(&edges, &ways_out)?.component_mul(&units))
}

/// Translations and rotations have different units: the amount of each rigid motion that moves a point by 1 at most.
fn units(step: &Step<'_>) -> DVector<f64> {
    let modes = step.problem.modes();
    DVector::from_fn(modes.ncols(), |mode, _| match modes.column(mode).amax() {
        largest if largest > 0.0 => 1.0 / largest,
        _ => 1.0,
    })
}

/// [`FailureCause::Unbalanced`] where there is a rigid motion along which the load of `step` does work against no friction cone; `None` where there is no such motion.
pub(super) fn impossible(step: &Step<'_>) -> Option<FailureCause> {
    if step.mode_load.amax() == 0.0 {
        return None;
    }
    let mut edges = cone_edges(step);
    let units = units(step);
    for (mut row, unit) in edges.row_iter_mut().zip(&units) {
        row *= *unit;
    }
    let load = step.mode_load.component_mul(&units);
    let remainder = nearest(&edges, &load);
    let proved = (0..step.count()).all(|k| step.problem.law(k).is_linear());
    proves(&edges, &load, &remainder).then(|| {
        let part = remainder.norm() / load.norm();
        let motion = without_lift(step, &edges, &units, remainder);
        FailureCause::Unbalanced {
            part,
            motion: motion.component_mul(&units).as_slice().to_vec(),
            proved,
        }
    })
}

/// The motion `remainder` without what lifts points from each other that slide: on the edge of a friction cone a proof parts them by μ of their slip, and bodies do not. As it is where the load
/// does no work on the rest; both scaled by `units`.
fn without_lift(
    step: &Step<'_>,
    edges: &DMatrix<f64>,
    units: &DVector<f64>,
    remainder: DVector<f64>,
) -> DVector<f64> {
    let modes = step.problem.modes();
    let size = remainder.norm();
    let is_at_edge = |k: usize| {
        let mut own = [2 * k, 2 * k + 1]
            .into_iter()
            .map(|column| edges.column(column));
        own.any(|edge| remainder.dot(&edge).abs() <= SLIDING * size * edge.norm())
    };
    let sliding: Vec<usize> = (0..step.count()).filter(|&k| is_at_edge(k)).collect();
    if sliding.is_empty() {
        return remainder;
    }
    let normals = DMatrix::from_fn(sliding.len(), remainder.len(), |row, mode| {
        modes[(2 * sliding[row], mode)] * units[mode]
    });
    let decomposed = normals.svd(false, true);
    let Some(directions) = decomposed.v_t else {
        return remainder;
    };
    let largest = decomposed.singular_values.max();
    let mut rest = remainder.clone();
    for (direction, &value) in directions.row_iter().zip(&decomposed.singular_values) {
        if value > SLIDING * largest {
            let along = direction.transpose();
            rest -= &along * along.dot(&remainder);
        }
    }
    let load = step.mode_load.component_mul(units);
    let does_work = rest.dot(&load) > SLIDING * rest.norm() * load.norm();
    if does_work && rest.norm() > SLIDING * size {
        rest
    } else {
        remainder
    }
}

/// The part of the load of `step` `[1]` that the resultants `unbalanced` are, which nothing balances; infinite without a load.
pub(super) fn part_of_load(step: &Step<'_>, unbalanced: &DVector<f64>) -> f64 {
    let units = units(step);
    let size = |resultants: &DVector<f64>| resultants.component_mul(&units).norm();
    size(unbalanced) / size(&step.mode_load)
}

/// Whether contact forces in the friction cones of `points` balance the load of `step`.
pub(crate) fn balanced_by(step: &Step<'_>, points: &[usize]) -> bool {
    let units = units(step);
    let columns: Vec<usize> = points.iter().flat_map(|&k| [2 * k, 2 * k + 1]).collect();
    let mut edges = cone_edges(step).select_columns(&columns);
    for (mut row, unit) in edges.row_iter_mut().zip(&units) {
        row *= *unit;
    }
    let load = step.mode_load.component_mul(&units);
    nearest(&edges, &load).norm() <= NEGLIGIBLE * load.norm()
}

/// Whether along `remainder` the load does work and no edge of the cones works against it: checked, because the search for
/// the nearest point may have ended early.
fn proves(edges: &DMatrix<f64>, load: &DVector<f64>, remainder: &DVector<f64>) -> bool {
    let size = remainder.norm();
    size > NEGLIGIBLE * load.norm()
        && remainder.dot(load) > 0.0
        && edges
            .column_iter()
            .all(|edge| remainder.dot(&edge) >= -NEGLIGIBLE * size * edge.norm())
}

/// Columns G_n ± μ G_t, m × 2n.
fn cone_edges(step: &Step<'_>) -> DMatrix<f64> {
    let modes = step.problem.modes();
    let mut edges = DMatrix::zeros(modes.ncols(), 2 * step.count());
    for (k, point) in step.problem.points().iter().enumerate() {
        let coefficient = if point.slides {
            largest_coefficient(step, k)
        } else {
            0.0
        };
        let (normal, tangential) = (modes.row(2 * k), modes.row(2 * k + 1));
        for (side, sign) in [1.0, -1.0].into_iter().enumerate() {
            let edge = normal + tangential * (sign * coefficient);
            edges.column_mut(2 * k + side).copy_from(&edge.transpose());
        }
    }
    edges
}

/// The largest μ of `point` in any past: exact where the law's bound is proportional to pressure, else at pressures up to a
/// thousand times larger and smaller than that of the load.
fn largest_coefficient(step: &Step<'_>, point: usize) -> f64 {
    let (law, at) = (step.problem.law(point), &step.problem.points()[point]);
    let untouched = History::default();
    let worn = untouched.commit(PointStatus::Slip, f64::MAX);
    let pasts = [&untouched, &step.committed.history[point], &worn];
    let shares: &[f64] = if law.is_linear() {
        &[1.0]
    } else {
        &[1e-3, 1.0, 1e3]
    };
    let load = step.mode_load.amax() / at.area;
    let coefficients = shares.iter().flat_map(|share| {
        let pressure = share * load;
        pasts.map(|past| {
            let bound = law.bound(pressure, 0.0, &at.place, past);
            step.friction * bound.stick.max(bound.slip) / pressure
        })
    });
    coefficients.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn remainder(edges: &[[f64; 2]], load: [f64; 2]) -> DVector<f64> {
        let columns: Vec<f64> = edges.iter().flatten().copied().collect();
        nearest(
            &DMatrix::from_column_slice(2, edges.len(), &columns),
            &DVector::from_column_slice(&load),
        )
    }

    #[test]
    fn a_push_within_the_cone_is_balanced_and_one_beyond_is_not() {
        // λ_n acts along +y, friction along x with μ = 0.4; the body is pressed down by 1.
        let cone = [[0.4, 1.0], [-0.4, 1.0], [0.4, 1.0], [-0.4, 1.0]];
        assert!(remainder(&cone, [0.39, -1.0]).norm() < 1e-12);
        let proof = remainder(&cone, [0.41, -1.0]);
        assert!(proof.dot(&DVector::from_column_slice(&[0.41, -1.0])) > 0.0);
        assert!(
            cone.iter()
                .all(|edge| proof[0] * edge[0] + proof[1] * edge[1] > -1e-12)
        );
    }

    #[test]
    fn a_pull_is_not_balanced() {
        assert!(remainder(&[[0.0, 1.0]], [0.0, 1.0]).norm() > 0.99);
    }

    /// Loads inside the cone of random edges in three motions, whatever the units of the third.
    #[test]
    fn loads_that_can_be_balanced_are_never_proved_impossible() {
        let mut seed = 1_u64;
        let mut draw = || {
            seed = seed
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        for unit in [1.0, 1e-4, 40.0] {
            for count in [2, 4, 8, 60] {
                for _ in 0..200 {
                    let mut edges = DMatrix::from_fn(3, count, |_, _| draw());
                    edges.row_mut(2).scale_mut(unit);
                    let weights = DVector::from_fn(count, |_, _| draw().max(0.0));
                    let load = -(&edges * weights);
                    let rest = nearest(&edges, &load);
                    assert!(!proves(&edges, &load, &rest), "{edges} {load} {rest}");
                }
            }
        }
    }
}
