//! Failure envelopes: the load at failure over all directions in a plane of membrane forces.
//!
//! ```text
//! (N_x, N_y) or (N_x, N_xy) = r(φ) (cos φ, sin φ),     φ = 2π i/n, i = 0 … n − 1
//! ```

use std::f64::consts::TAU;

use super::criterion::FailureCriterion;
use super::error::{FailureError, finite};
use super::first_ply::{PlyAssessment, first_ply_failure};
use super::last_ply::last_ply_failure;
use crate::degradation::Degradation;
use crate::laminate::{Laminate, LaminateLoad};

const DIRECTIONS: std::ops::RangeInclusive<usize> = 3..=1_000_000;

/// The plane of an envelope.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EnvelopePlane {
    /// (N_x, N_y) with N_xy = 0.
    NormalNormal,
    /// (N_x, N_xy) with N_y = 0.
    NormalShear,
}

/// Which failure an envelope bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EnvelopeEvent {
    /// The first ply's.
    First,
    /// The laminate's, by ply discount.
    Last(Degradation),
}

/// A point of an envelope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnvelopePoint {
    /// φ `[rad]`.
    pub direction: f64,
    /// (N_x, N_y, N_xy) at failure `[force/length]`; all zero where the temperature alone fails the laminate.
    pub force: [f64; 3],
    /// The layer that fails, its place and mode; its reserve factor refers to a force of magnitude 1.
    pub ply: PlyAssessment,
}

/// Computes the envelope of `laminate` in `plane` at the temperature rise `temperature` `[temperature]`, in `directions` equal steps.
///
/// # Errors
/// [`FailureError::Directions`] unless 3 ≤ `directions` ≤ 10⁶; [`FailureError::OpenEnvelope`] if nothing fails along one of them;
/// else as [`first_ply_failure`] and [`last_ply_failure`].
pub fn failure_envelope(
    laminate: &Laminate,
    plane: EnvelopePlane,
    directions: usize,
    temperature: f64,
    criterion: &dyn FailureCriterion,
    event: EnvelopeEvent,
) -> Result<Vec<EnvelopePoint>, FailureError> {
    if !DIRECTIONS.contains(&directions) {
        return Err(FailureError::Directions { directions });
    }
    finite("temperature", &[temperature])?;
    let point = |index: usize| {
        let direction = TAU * index as f64 / directions as f64;
        let (sine, cosine) = direction.sin_cos();
        let force = match plane {
            EnvelopePlane::NormalNormal => [cosine, sine, 0.0],
            EnvelopePlane::NormalShear => [cosine, 0.0, sine],
        };
        let load = LaminateLoad {
            temperature,
            ..LaminateLoad::membrane(force)
        };
        let failure = match event {
            EnvelopeEvent::First => {
                let ply = first_ply_failure(laminate, &load, criterion)?;
                Some((ply.assessment.reserve_factor, ply)).filter(|(factor, _)| factor.is_finite())
            }
            EnvelopeEvent::Last(degradation) => {
                let history = last_ply_failure(laminate, &load, criterion, &degradation)?;
                let last = history.events.last().filter(|_| history.collapsed);
                last.map(|event| (event.factor, event.ply))
            }
        };
        let (factor, ply) = failure.ok_or(FailureError::OpenEnvelope { force })?;
        Ok(EnvelopePoint {
            direction,
            force: force.map(|component| factor * component),
            ply,
        })
    };
    (0..directions).map(point).collect()
}
