//! How many modes and which degree a fit of the outer edge takes.

use super::fit::{self, OuterFit, Task};
use crate::circle::Circle;
use crate::error::SeriesError;

/// Largest number of the hole's modes.
const LARGEST_ORDER: i64 = 400;
/// Factor between the degrees of the polynomials that are tried.
const STEP: f64 = 1.3;
/// Residual from which on a fit means nothing.
const USELESS: f64 = 0.1;

/// How well the outer edge is fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// Residual `[1]` to stop at, see [`Fit::residual`](super::Fit::residual).
    pub tolerance: f64,
    /// Largest degree of the polynomials, at which the fit stops whatever it leaves.
    pub degree: usize,
}

impl Default for Accuracy {
    /// 2e-3, at most degree 150. On the hole that leaves about a thousandth of it, 2e-6.
    fn default() -> Self {
        Self {
            tolerance: 2e-3,
            degree: 150,
        }
    }
}

/// The largest order K of the hole's modes that matters at the outer edge, (R/d)^K a thousandth of the tolerance.
pub(super) fn orders(distance: f64, circle: Circle, tolerance: f64) -> Result<i64, SeriesError> {
    let digits = (1e3 / tolerance.clamp(1e-13, 1.0)).ln();
    let needed = (digits / distance.ln()).ceil() + 2.0;
    if needed > LARGEST_ORDER as f64 {
        return Err(SeriesError::Ligament {
            ligament: (distance - 1.0) * circle.radius,
            radius: circle.radius,
            needed,
            largest: LARGEST_ORDER,
        });
    }
    Ok(needed as i64)
}

/// The degree that polynomials need for a residual of `tolerance`, within a tenth of what strips with 1 to 10 times their width and ligaments of half a radius and
/// more took for 2e-3. d: distance of the outline, P: its length, in radii.
///
/// ```text
/// 22 d/(d − 1) (P/8d)^0.7 (2e-3/tolerance)^¼
/// ```
fn predicted_degree(task: &Task<'_>, tolerance: f64) -> f64 {
    let surrounding = task.surrounding;
    let distance = fit::distance(task.elasticity, surrounding);
    let length: f64 = surrounding.sides.iter().map(|side| side.length).sum();
    let shape = distance / (distance - 1.0) * (length / (8.0 * surrounding.distance)).powf(0.7);
    22.0 * shape * (2e-3 / tolerance.clamp(1e-13, 1.0)).powf(0.25)
}

/// The fit of the degree that its outline needs; of higher ones while its residual is too large and becomes smaller.
pub(super) fn fitted(task: &Task<'_>, accuracy: Accuracy) -> Result<OuterFit, SeriesError> {
    let mut degree = predicted_degree(task, accuracy.tolerance);
    let mut best: Option<OuterFit> = None;
    loop {
        let last = degree >= accuracy.degree as f64;
        let next = OuterFit::new(task, (degree.ceil() as usize).min(accuracy.degree));
        let before = best.as_ref().map_or(f64::INFINITY, |best| best.residual);
        let residual = next.residual;
        if residual < before || best.is_none() {
            best = Some(next);
        }
        if last || residual <= accuracy.tolerance || residual >= before {
            break;
        }
        degree *= STEP;
    }
    let residual = best.as_ref().map_or(f64::NAN, |best| best.residual);
    match best {
        Some(best) if residual <= USELESS.max(accuracy.tolerance) => Ok(best),
        _ => Err(SeriesError::NotFitted {
            residual,
            degree: accuracy.degree,
        }),
    }
}
