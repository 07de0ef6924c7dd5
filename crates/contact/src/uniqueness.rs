//! An estimate of the friction coefficient up to which a step has only one solution.
//!
//! Where points touch and none of them lifts off, normal forces follow the tangential ones,
//!
//! ```text
//! 0 = A_nn λ_n + A_nt λ_t + G_n α,   G_nᵀ λ_n + G_tᵀ λ_t = −r     ⇒     Δλ_n = −N Δλ_t
//! ```
//!
//! and friction bounds |λ_t| ≤ μ λ_n by them in turn. Bounds that differ by ΔF change λ_t by at most as much where all points
//! slip, so that the round trip multiplies them by μ |N|, and shrinks them if
//!
//! ```text
//! μ < 1/ρ(|N|),   ρ: spectral radius.
//! ```
//!
//! For one point this is A_nn/|A_nt| = k_t/|k_c| with K = [[k_t, k_c], [k_c, k_n]], the exact bound (Klarbring 1990). For more
//! it is an estimate: sticking neighbours and points that open change the round trip, in either direction.

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::linalg::DenseLu;

use crate::problem::{FreeMotions, InterfaceProblem};
use crate::state::Status;

/// Part of the bound `[1]` from which friction is near it: the bound is an estimate.
pub const NEAR_BOUND: f64 = 0.8;

/// Estimate of the friction coefficient (dimensionless) up to which the step with touching points as in `status` (one per
/// point; open points carry nothing) has one solution. Infinite if normal and tangential directions are not coupled; `None` if
/// no point touches, or if the touching points do not hold the bodies.
pub fn uniqueness_bound(problem: &InterfaceProblem, status: &[Status]) -> Option<f64> {
    let touching = (0..problem.points().len())
        .filter(|&k| status.get(k).is_some_and(|status| status.touches()));
    // What nothing holds makes the equations singular, of which rounding would leave 10⁻¹⁶ for an estimate.
    match FreeMotions::of(problem, touching.map(|k| 2 * k)) {
        Some(_) => None,
        None => estimate(problem, status, None),
    }
}

/// The same where rigid motions that no normal resists, such as the turn of a round body, are held where they are: a hint whether to
/// look for other solutions, where friction alone holds them.
pub(crate) fn bound_with_turns_held(problem: &InterfaceProblem, status: &[Status]) -> Option<f64> {
    let normals = (0..problem.points().len()).map(|k| 2 * k);
    estimate(problem, status, FreeMotions::of(problem, normals))
}

fn estimate(
    problem: &InterfaceProblem,
    status: &[Status],
    held: Option<FreeMotions>,
) -> Option<f64> {
    let touching: Vec<usize> = (0..problem.points().len())
        .filter(|&k| status.get(k).is_some_and(|status| status.touches()))
        .collect();
    if touching.is_empty() {
        return None;
    }
    let coupling = normal_response(problem, &touching, held)?.abs();
    let radius = spectral_radius(&coupling);
    Some(if radius > 0.0 {
        1.0 / radius
    } else {
        f64::INFINITY
    })
}

/// N, rows: normal forces of the points `touching`; columns: tangential ones, zero where a point cannot slide.
fn normal_response(
    problem: &InterfaceProblem,
    touching: &[usize],
    held: Option<FreeMotions>,
) -> Option<DMatrix<f64>> {
    let modes = problem.modes();
    let normals: Vec<usize> = touching.iter().map(|k| 2 * k).collect();
    let columns: Vec<usize> = touching.iter().flat_map(|k| [2 * k, 2 * k + 1]).collect();
    let compliance = problem.compliance().chosen(&normals, &columns);
    let unit = problem.compliance_unit();
    let (count, rigid) = (touching.len(), modes.ncols());
    let motions = |row: usize| (0..rigid).map(move |mode| modes[(row, mode)]);
    let mut matrix = DMatrix::zeros(count + rigid, count + rigid);
    for (i, &k) in touching.iter().enumerate() {
        for (j, &l) in touching.iter().enumerate() {
            matrix[(i, j)] = compliance.at(i, 2 * l) / unit;
        }
        for (mode, value) in motions(2 * k).enumerate() {
            matrix[(i, count + mode)] = value;
            matrix[(count + mode, i)] = value;
        }
    }
    if let Some(free) = held {
        let mut corner = matrix.view_mut((count, count), (rigid, rigid));
        corner += free.projector;
    }
    let factors = DenseLu::new(matrix).ok()?;
    let mut response = DMatrix::zeros(count, count);
    for (j, &l) in touching.iter().enumerate() {
        if !problem.points()[l].slides {
            continue;
        }
        let along = (0..count).map(|i| compliance.at(i, 2 * l + 1) / unit);
        let mut column = DVector::from_iterator(count + rigid, along.chain(motions(2 * l + 1)));
        factors.solve(&mut column);
        response.set_column(j, &column.rows(0, count));
    }
    Some(response)
}

/// Largest eigenvalue of a matrix without negative entries, by powers of it plus the identity, which makes it the only one of
/// its size.
fn spectral_radius(matrix: &DMatrix<f64>) -> f64 {
    const LIMIT: usize = 2000;
    const CONVERGED: f64 = 1e-12;
    let scale = matrix.amax();
    if scale == 0.0 {
        return 0.0;
    }
    let mut vector = DVector::repeat(matrix.nrows(), 1.0);
    let mut radius = 0.0;
    for _ in 0..LIMIT {
        let next = matrix * &vector / scale + &vector;
        let size = next.amax() / vector.amax();
        vector = next / (size * vector.amax());
        let before = std::mem::replace(&mut radius, size - 1.0);
        if (radius - before).abs() <= CONVERGED * radius {
            break;
        }
    }
    radius * scale
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spectral_radii() {
        let radius = |rows: &[f64], n| spectral_radius(&DMatrix::from_row_slice(n, n, rows));
        assert!((radius(&[0.0, 2.0, 8.0, 0.0], 2) - 4.0).abs() < 1e-9);
        assert!(
            (radius(&[1.0, 2.0, 3.0, 4.0], 2) - f64::midpoint(5.0, 33.0_f64.sqrt())).abs() < 1e-9
        );
        assert_eq!(radius(&[0.0; 4], 2), 0.0);
    }
}
