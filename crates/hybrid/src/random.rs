//! Random numbers of the distributions that noise has.

use std::f64::consts::TAU;

use rand::RngExt;
use rand::rngs::StdRng;

/// Exponential distribution of mean 1: the intensity of fully developed speckle.
pub(crate) fn exponential(random: &mut StdRng) -> f64 {
    // 1 − u is in (0, 1], so the logarithm is finite.
    -(1.0 - random.random::<f64>()).ln()
}

/// Standard normal distribution (Box & Muller 1958).
pub(crate) fn normal(random: &mut StdRng) -> f64 {
    (2.0 * exponential(random)).sqrt() * (TAU * random.random::<f64>()).cos()
}
