//! Last-ply failure by ply discount under a load that grows in proportion.
//!
//! ```text
//! repeat   r ← max(r, min_k reserve factor of layer k)      the load never falls
//!          degrade the layers that reach it                  fibre modes: fibres and matrix; other modes: the matrix
//! until    φ > ½,   φ = Σ_k ∫ w_k^failed dz / Σ_k ∫ w_k dz
//!
//! w = ½ σ · ε     w^failed = w where fibres have failed,  ½ (S₂₂σ₂² + S₆₆τ₁₂²) where the matrix has,  0 in a sound ply
//! ```
//!
//! Stresses are those of the laminate as damaged so far, redistributed after each failure at the same load; layers alike by
//! symmetry fail together. A layer whose matrix has failed is checked for fibre failure only, by maximum stress along the fibres:
//! an interactive criterion would find its matrix failed again.
//!
//! *The strength* of the laminate is the load of the event after which failed material carries more than half of it: φ is the
//! share of the elastic energy of (N, M) that failed fibres and failed matrix store. What they keep of their stiffness is a means
//! to go on with the calculation and has no strength limit, so a calculation that goes on beyond would find loads of any size.
//! Cracks in the matrix of every ply are no collapse as long as the fibres carry the load, which is netting theory; they are one for
//! ±45° plies in tension.

use super::criterion::FailureCriterion;
use super::error::{FailureError, finite};
use super::first_ply::{Loaded, PlyAssessment};
use super::maximum::fibre_assessment;
use crate::degradation::{Damage, Degradation};
use crate::laminate::{Laminate, LaminateLoad, Position};

/// Reserve factors closer than this, relatively, are reached together: plies alike by symmetry, whose stresses pass through the
/// inverse of a stiffness with failed plies.
const TOGETHER: f64 = 1e-9;

/// Share of the load's energy in failed material beyond which the laminate no longer carries the load.
const COLLAPSED: f64 = 0.5;

/// The failure of a layer while the load grows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlyFailureEvent {
    /// Multiple of the load at which it happened, dimensionless.
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
    /// Whether failed material carries most of the load at the end, or else the rest withstands any multiple of it.
    pub collapsed: bool,
}

impl FailureHistory {
    /// The multiple of the load at which the first layer fails, dimensionless, infinite if none does.
    pub fn first_factor(&self) -> f64 {
        self.events
            .first()
            .map_or(f64::INFINITY, |event| event.factor)
    }

    /// The multiple of the load at which the laminate collapses, its strength, dimensionless; infinite if it does not.
    pub fn last_factor(&self) -> f64 {
        let last = self.events.last().filter(|_| self.collapsed);
        last.map_or(f64::INFINITY, |event| event.factor)
    }
}

/// Follows the failures of `laminate` when (N, M) of `load` grow in proportion, its temperature held, up to its
/// collapse.
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
        collapsed: false,
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
        if failed_share(&current, load, &history.damage) > COLLAPSED {
            history.collapsed = true;
            return Ok(history);
        }
    }
}

/// φ of the damaged laminate, 0 without load.
fn failed_share(laminate: &Laminate, load: &LaminateLoad, damage: &[Damage]) -> f64 {
    let mechanical = LaminateLoad {
        temperature: 0.0,
        ..*load
    };
    let deformation = laminate.deformation(&mechanical);
    let (mut failed, mut total) = (0.0, 0.0);
    for state in laminate.ply_states(&deformation, 0.0) {
        // Simpson's rule is exact for the product of two linear functions of z.
        let weight = match state.position {
            Position::Middle => 4.0,
            Position::Bottom | Position::Top => 1.0,
        };
        let ply = laminate.layers()[state.layer].ply();
        let ([s1, s2, shear], [e1, e2, gamma]) = (state.stress, state.strain);
        // S₂₂ σ₂ is what the strain across the fibres has beside Poisson's share.
        let matrix = s2 * (e2 - ply.compliance()[1][0] * s1) + shear * gamma;
        let whole = s1 * e1 + s2 * e2 + shear * gamma;
        let share = match damage[state.layer] {
            Damage { fibre: true, .. } => whole,
            Damage { matrix: true, .. } => matrix,
            Damage { .. } => 0.0,
        };
        failed += weight * ply.thickness() * share;
        total += weight * ply.thickness() * whole;
    }
    if total > 0.0 { failed / total } else { 0.0 }
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
