//! Largest differences between results.

use stickslip::results::{EdgeResults, Results};

/// Largest difference of paired numbers relative to the largest number of both; 0 for equal ones.
pub fn relative_difference(
    first: impl IntoIterator<Item = f64>,
    second: impl IntoIterator<Item = f64>,
) -> f64 {
    let (mut difference, mut scale) = (0.0_f64, 0.0_f64);
    let (mut first, mut second) = (first.into_iter(), second.into_iter());
    loop {
        match (first.next(), second.next()) {
            (Some(a), Some(b)) => {
                assert!(a.is_finite() && b.is_finite(), "{a} against {b}");
                difference = difference.max((a - b).abs());
                scale = scale.max(a.abs()).max(b.abs());
            }
            (None, None) => break,
            _ => panic!("lists of different lengths"),
        }
    }
    if difference == 0.0 {
        0.0
    } else {
        difference / scale
    }
}

/// Pressures and shears along an edge `[MPa]`.
pub fn tractions(edge: &EdgeResults) -> impl Iterator<Item = f64> {
    edge.rows.iter().flat_map(|row| [row.pressure, row.shear])
}

/// Pressures and shears of the first edge in the last step `[MPa]`.
pub fn last_tractions(results: &Results) -> Vec<f64> {
    let last = results.steps.last().expect("at least one step");
    tractions(&last.edges[0]).collect()
}

/// Pressures, shears and edge stresses of all edges and steps `[MPa]`.
pub fn all_stresses(results: &Results) -> Vec<f64> {
    results
        .steps
        .iter()
        .flat_map(|step| &step.edges)
        .flat_map(|edge| &edge.rows)
        .flat_map(|row| {
            [
                row.pressure,
                row.shear,
                row.sigma_normal,
                row.sigma_tangential,
                row.tau,
            ]
        })
        .collect()
}
