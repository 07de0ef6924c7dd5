//! Knots, elements and their checks.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::{Element, Knot};
use crate::error::SeriesError;

/// Least distance of neighbouring nodes `[rad]`.
pub(super) const LEAST_SPACING: f64 = 1e-7;
/// Largest distance of neighbouring nodes `[rad]`: eight nodes on a circle.
pub(super) const LARGEST_SPACING: f64 = TAU / 8.0 + 1e-9;

/// ∫ (1 − s) e^{iκs} ds and ∫ s e^{iκs} ds over 0 to 1.
pub(super) fn half_hats(kappa: f64) -> [Complex<f64>; 2] {
    let turn = Complex::from_polar(1.0, kappa);
    let rising = if kappa.abs() < 1.0 {
        // Σ (iκ)^n / (n! (n + 2))
        let (mut term, mut sum) = (Complex::new(1.0, 0.0), Complex::new(0.5, 0.0));
        for n in 1..18 {
            term *= Complex::new(0.0, kappa / f64::from(n));
            sum += term / f64::from(n + 2);
        }
        sum
    } else {
        (turn - 1.0) / (kappa * kappa) - turn * Complex::new(0.0, 1.0 / kappa)
    };
    [turn * rising.conj(), rising]
}

pub(super) fn own_knots(angles: &[f64]) -> Vec<Knot> {
    let knot = |(node, &angle)| Knot {
        angle,
        node,
        image: node,
        weight: 0.0,
    };
    angles.iter().enumerate().map(knot).collect()
}

pub(super) fn element(knots: [usize; 2], [start, end]: [f64; 2]) -> Element {
    Element {
        knots,
        start,
        length: end - start,
    }
}

/// The elements between neighbours of `angles`, whose first is knot `first`.
pub(super) fn chain(angles: &[f64], first: usize) -> Vec<Element> {
    let pairs = angles.windows(2).enumerate();
    pairs
        .map(|(k, ends)| element([first + k, first + k + 1], [ends[0], ends[1]]))
        .collect()
}

pub(super) fn check(angles: &[f64]) -> Result<(), SeriesError> {
    if angles.len() < 2 {
        return Err(SeriesError::Count {
            count: angles.len(),
        });
    }
    if let Some(&angle) = angles
        .iter()
        .find(|angle| angle.is_nan() || angle.abs() > 2.0 * TAU)
    {
        return Err(SeriesError::Angle { angle });
    }
    let gaps = angles.windows(2).enumerate();
    gaps.into_iter()
        .try_for_each(|(k, ends)| spacing(k, ends[1] - ends[0]))
}

pub(super) fn spacing(node: usize, spacing: f64) -> Result<(), SeriesError> {
    if (LEAST_SPACING..=LARGEST_SPACING).contains(&spacing) {
        Ok(())
    } else {
        Err(SeriesError::Spacing { node, spacing })
    }
}

pub(super) fn spacing_below(node: usize, spacing: f64) -> Result<(), SeriesError> {
    if spacing >= LEAST_SPACING {
        Ok(())
    } else {
        Err(SeriesError::Spacing { node, spacing })
    }
}
