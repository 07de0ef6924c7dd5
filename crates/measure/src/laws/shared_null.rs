//! States that have one null field in common.
//!
//! ```text
//! d_k = m_k − n,     cov(d_j, d_k) = σ_n²,     ρ = ⟨r_j r_k⟩ / ½⟨r_j² + r_k²⟩ over common data and pairs
//! ```
//!
//! The errors of n are in all of them. A fit that treats K such states as independent has standard deviations that are wrong by a factor
//! of at most √(1 + (K − 1) ρ), the root of the largest eigenvalue of the correlations: that much too small where a parameter moves all
//! states alike, and too large where it moves them oppositely, as friction does on the way up and on the way down.

use std::collections::HashMap;

use stickslip_hybrid::calibrate::Noise;

use super::{Fit, Observation};
use stickslip_experiment::Experiment;

/// States with one null field.
#[derive(Clone, Debug, PartialEq)]
pub struct SharedNull {
    /// Their indices in the experiment.
    pub states: Vec<usize>,
    /// Data that two of them have in common, all pairs together.
    pub data: usize,
    /// Correlation of what the best law leaves of these `[1]`.
    pub correlation: f64,
}

impl SharedNull {
    /// The factor `[1]` by which standard deviations may be too small.
    pub fn too_narrow(&self) -> f64 {
        (1.0 + (self.states.len() as f64 - 1.0) * self.correlation.max(0.0)).sqrt()
    }
}

/// Groups of `states`, those of `observations`, whose null fields are one measurement. Null fields of synthetic states are pictures of
/// their own.
pub(super) fn shared_nulls(
    experiment: &Experiment,
    states: &[usize],
    observations: &[Observation],
    best: &Fit,
) -> Vec<SharedNull> {
    let null = |k: usize| {
        let source = experiment.states[states[k]].null.as_ref();
        source.filter(|source| !source.is_synthetic())
    };
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for k in 0..states.len() {
        let Some(own) = null(k) else { continue };
        match groups.iter_mut().find(|group| null(group[0]) == Some(own)) {
            Some(group) => group.push(k),
            None => groups.push(vec![k]),
        }
    }
    (groups.iter().filter(|group| group.len() > 1))
        .map(|group| {
            let left: Vec<_> = group
                .iter()
                .map(|&k| relative(&observations[k], &best.states[k].residual))
                .collect();
            let [mut products, mut squares, mut data] = [0.0, 0.0, 0.0];
            for (first, own) in left.iter().enumerate() {
                for other in &left[first + 1..] {
                    for (key, a) in own {
                        let Some(b) = other.get(key) else { continue };
                        products += a * b;
                        squares += 0.5 * (a * a + b * b);
                        data += 1.0;
                    }
                }
            }
            SharedNull {
                states: group.iter().map(|&k| states[k]).collect(),
                data: data as usize,
                correlation: if squares > 0.0 {
                    products / squares
                } else {
                    0.0
                },
            }
        })
        .collect()
}

/// Residuals over their standard deviations, by place and axis.
fn relative(own: &Observation, residual: &[f64]) -> HashMap<([u64; 2], usize), f64> {
    let deviation = |k: usize| match &own.noise {
        Noise::Independent(all) => all.get(k).copied().unwrap_or(1.0),
        Noise::Correlated(all) => all
            .get(k * (own.values.len() + 1))
            .map_or(1.0, |own| own.sqrt()),
    };
    let each = own.components.iter().zip(residual).enumerate();
    each.map(|(k, (&(place, axis), left))| {
        let key = (own.places[place].map(f64::to_bits), axis);
        (key, left / deviation(k))
    })
    .collect()
}
