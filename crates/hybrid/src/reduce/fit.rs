//! Weights of a local polynomial fit.
//!
//! ```text
//! min_a Σ_i ω_i (u_i − Σ_j a_j p_j(x_i))²,   ω_i = (1 − (r_i/h)³)³,   value a_0 = Σ_i w_i u_i,   w = √ω Q R⁻ᵀ e₀,   √ω P = Q R
//! ```
//!
//! Sources: Lancaster & Salkauskas (1981), moving least squares; Cleveland (1979), the weight.

use stickslip_fem_core::mesh::Point;

use crate::least_squares::{dot, orthogonalise};

/// Part of a column that must be left when the columns before it are taken off: below it the points do not distinguish the column from
/// them.
const RANK: f64 = 1e-6;

/// Number of terms of a plane polynomial.
pub(super) fn terms(order: usize) -> usize {
    (order + 1) * (order + 2) / 2
}

/// Weights of values at `places` for the value at `at` of the polynomial of `order` fitted within `radius`; nothing where the
/// places do not determine it.
pub(super) fn weights(places: &[Point], at: Point, radius: f64, order: usize) -> Option<Vec<f64>> {
    let local: Vec<Point> = places
        .iter()
        .map(|place| [(place[0] - at[0]) / radius, (place[1] - at[1]) / radius])
        .collect();
    let root: Vec<f64> = local
        .iter()
        .map(|[x, y]| {
            let r = x.hypot(*y);
            (1.0 - r * r * r).max(0.0).powf(1.5)
        })
        .collect();
    let mut columns: Vec<Vec<f64>> = Vec::with_capacity(terms(order));
    // Row 0 of the inverse transpose of R, built with R's columns one after another.
    let mut first: Vec<f64> = Vec::with_capacity(terms(order));
    for degree in 0..=order {
        for power in 0..=degree {
            let mut column: Vec<f64> = local
                .iter()
                .zip(&root)
                .map(|([x, y], root)| root * x.powi((degree - power) as i32) * y.powi(power as i32))
                .collect();
            let before = dot(&column, &column).sqrt();
            let taken = orthogonalise(&mut column, &columns);
            let left = dot(&column, &column).sqrt();
            // A column of zeros or with NaN fails as well.
            if left.is_nan() || left <= RANK * before {
                return None;
            }
            for entry in &mut column {
                *entry /= left;
            }
            let known = dot(&taken, &first);
            let target = if first.is_empty() { 1.0 } else { 0.0 };
            first.push((target - known) / left);
            columns.push(column);
        }
    }
    Some(
        (0..local.len())
            .map(|i| {
                root[i]
                    * columns
                        .iter()
                        .zip(&first)
                        .map(|(q, z)| q[i] * z)
                        .sum::<f64>()
            })
            .collect(),
    )
}

/// Largest angle at `at` without a place in it `[rad]`; above π, `at` lies outside the hull of the places.
pub(super) fn open_angle(places: &[Point], at: Point) -> f64 {
    let mut angles: Vec<f64> = places
        .iter()
        .filter(|place| **place != at)
        .map(|place| (place[1] - at[1]).atan2(place[0] - at[0]))
        .collect();
    angles.sort_by(f64::total_cmp);
    let [Some(first), Some(last)] = [angles.first(), angles.last()] else {
        return std::f64::consts::TAU;
    };
    let around = std::f64::consts::TAU + first - last;
    angles
        .windows(2)
        .map(|pair| pair[1] - pair[0])
        .fold(around, f64::max)
}
