//! Stress recovery: exact where it must be, converging at the right rate elsewhere.

mod domain;
mod edge;
mod kirsch;
mod meshes;
mod solve;

/// Observed rates of `error` between successive entries, the resolution doubling from one to the next.
fn rates(error: &[f64]) -> Vec<f64> {
    error
        .windows(2)
        .map(|pair| (pair[0] / pair[1]).log2())
        .collect()
}
