//! Last-ply failure by ply discount under a load that grows in proportion.
//!
//! ```text
//! repeat   r ← max(r, min_k reserve factor of layer k)      the load never falls
//!          degrade the layers that reach it                  fibre modes: fibres and matrix; other modes: the matrix
//! until    no layer fails any more
//! ```
//!
//! Stresses are those of the laminate as damaged so far, redistributed after each failure at the same load; layers alike by
//! symmetry fail together. A layer whose matrix has failed is asked for fibre failure only, by maximum stress along the fibres:
//! an interactive criterion would find its matrix failed again. The laminate's strength is the load of the last event.

use super::error::finite;
use super::first_ply::Loaded;
use super::{FailureCriterion, FailureError, PlyAssessment, fibre_assessment};
use crate::degradation::{Damage, Degradation};
use crate::laminate::{Laminate, LaminateLoad};

/// Reserve factors closer than this, relatively, are reached together: plies alike by symmetry, whose stresses pass through the
/// inverse of a stiffness with failed plies.
const TOGETHER: f64 = 1e-9;

/// The failure of a layer while the load grows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlyFailureEvent {
    /// Multiple of the load at which it happened.
    pub factor: f64,
    /// The layer, its place and mode. The reserve factor is that of the laminate as damaged before: less than `factor` where the
    /// failure follows from an earlier one at the same load.
    pub ply: PlyAssessment,
}

/// Failures of a laminate's layers in their order, and what is left.
#[derive(Clone, Debug, PartialEq)]
pub struct FailureHistory {
    /// The events; empty if no multiple of the load fails any layer.
    pub events: Vec<PlyFailureEvent>,
    /// Damage of each layer at the end, from the bottom up.
    pub damage: Vec<Damage>,
}

impl FailureHistory {
    /// Multiple of the load at which the first layer fails, infinite if none does.
    pub fn first_factor(&self) -> f64 {
        self.events
            .first()
            .map_or(f64::INFINITY, |event| event.factor)
    }

    /// Multiple of the load at which the last layer fails, infinite if none does: the strength of the laminate.
    pub fn last_factor(&self) -> f64 {
        self.events
            .last()
            .map_or(f64::INFINITY, |event| event.factor)
    }
}

/// The failures of `laminate` when (N, M) of `load` grow in proportion, its temperature held, up to the last.
///
/// # Errors
/// As [`assess_plies`](super::assess_plies); [`FailureError::MissingStrength`] also without X_t and X_c;
/// [`FailureError::Laminate`] if `degradation` leaves no stiffness that can be inverted.
pub fn last_ply_failure(
    laminate: &Laminate,
    load: &LaminateLoad,
    criterion: &dyn FailureCriterion,
    degradation: &Degradation,
) -> Result<FailureHistory, FailureError> {
    finite("load", &[load.force, load.moment].concat())?;
    let mut history = FailureHistory {
        events: Vec::new(),
        damage: vec![Damage::default(); laminate.layers().len()],
    };
    let mut current = laminate.clone();
    let mut factor = 0.0;
    loop {
        let assessments = remaining(&current, load, criterion, &history.damage)?;
        let reserves = assessments.iter().map(|ply| ply.assessment.reserve_factor);
        let smallest = reserves.fold(f64::INFINITY, f64::min);
        if !smallest.is_finite() {
            return Ok(history);
        }
        factor = smallest.max(factor);
        for ply in assessments {
            if ply.assessment.reserve_factor <= smallest * (1.0 + TOGETHER) {
                let damage = &mut history.damage[ply.layer];
                *damage = damage.with(ply.assessment.mode);
                history.events.push(PlyFailureEvent { factor, ply });
            }
        }
        current = laminate.damaged(&history.damage, degradation)?;
    }
}

/// The layers that can still fail.
fn remaining(
    laminate: &Laminate,
    load: &LaminateLoad,
    criterion: &dyn FailureCriterion,
    damage: &[Damage],
) -> Result<Vec<PlyAssessment>, FailureError> {
    let loaded = Loaded::new(laminate, load)?;
    let layers = laminate.layers().iter().enumerate();
    layers
        .filter(|(index, _)| !damage[*index].fibre)
        .map(|(index, layer)| {
            loaded.govern(index, layer, |loading| {
                if damage[index].matrix {
                    fibre_assessment(layer.ply(), loading)
                } else {
                    criterion.assess(layer.ply(), loading)
                }
            })
        })
        .collect()
}
