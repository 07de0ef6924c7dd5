//! Derivatives along an edge by the values at its nodes.

use std::f64::consts::TAU;

/// The derivative in each node's cell, at a corner the mean of both cells by their lengths, or `crosswise` by the length of the other cell: of linear
/// cells the first is skew and the second exact for parabolas.
pub(super) fn slopes(
    parameter: &[f64],
    order: usize,
    closed: bool,
    crosswise: bool,
) -> Vec<Vec<(usize, f64)>> {
    let count = parameter.len();
    let mut slopes: Vec<Vec<(usize, f64)>> = vec![Vec::new(); count];
    let lengths = |first: usize| parameter_at(parameter, first + order) - parameter[first];
    let last = if closed { count } else { count - 1 };
    for first in (0..last).step_by(order) {
        let at: Vec<f64> = (first..=first + order)
            .map(|k| parameter_at(parameter, k))
            .collect();
        for (own, weights) in derivatives(&at).into_iter().enumerate() {
            let node = (first + own) % count;
            let neighbour = match (own, closed) {
                (0, true) => Some((first + count - order) % count),
                (0, false) => first.checked_sub(order),
                (_, true) if own == order => Some(node),
                (_, false) if own == order && node < last => Some(node),
                _ => None,
            };
            let length = lengths(first);
            let share = neighbour.map_or(1.0, |other| {
                let other = lengths(other);
                let own = if crosswise { other } else { length };
                own / (length + other)
            });
            for (k, weight) in weights.into_iter().enumerate() {
                let position = (first + k) % count;
                match slopes[node]
                    .iter_mut()
                    .find(|(known, _)| *known == position)
                {
                    Some((_, sum)) => *sum += share * weight,
                    None => slopes[node].push((position, share * weight)),
                }
            }
        }
    }
    let negligible = |own: &[(usize, f64)]| {
        1e-12
            * own
                .iter()
                .fold(0.0, |most: f64, (_, weight)| most.max(weight.abs()))
    };
    for own in &mut slopes {
        let least = negligible(own);
        own.retain(|(_, weight)| weight.abs() > least);
    }
    slopes
}

/// Parameter of the node `k`, which may be beyond the period.
fn parameter_at(parameter: &[f64], k: usize) -> f64 {
    let count = parameter.len();
    parameter[k % count] + TAU * (k / count) as f64
}

/// Derivatives of Lagrange's polynomials of the places `at`, at each place those of all.
fn derivatives(at: &[f64]) -> Vec<Vec<f64>> {
    let others = |k: usize| (0..at.len()).filter(move |&other| other != k);
    let product = |k: usize| -> f64 { others(k).map(|other| at[k] - at[other]).product() };
    let entry = |own: usize, of: usize| {
        if own == of {
            others(own).map(|other| (at[own] - at[other]).recip()).sum()
        } else {
            product(own) / (product(of) * (at[own] - at[of]))
        }
    };
    let row = |own: usize| (0..at.len()).map(|of| entry(own, of)).collect();
    (0..at.len()).map(row).collect()
}
