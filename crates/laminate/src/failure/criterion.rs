//! The trait behind which all failure criteria stand: a loaded ply in, index, reserve factor and mode out.

use std::fmt::Debug;
use std::sync::Arc;

use super::error::{FailureError, finite};
use super::needed::needed_strength;
use crate::failure_mode::FailureMode;
use crate::ply::Ply;
use crate::strengths::Strength;

/// Stress of a ply in its material axes (σ₁, σ₂, τ₁₂), in the part that stays and the part that the load multiplies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlyLoading {
    /// Residual stress, the same at every load `[stress]`.
    pub held: [f64; 3],
    /// Stress of the load as given `[stress]`.
    pub applied: [f64; 3],
}

impl PlyLoading {
    /// Makes a loading of the stress `applied` (σ₁, σ₂, τ₁₂) `[stress]` without residual stress.
    pub fn mechanical(applied: [f64; 3]) -> Self {
        Self {
            held: [0.0; 3],
            applied,
        }
    }

    /// Refuses a stress that is infinite or no number.
    ///
    /// # Errors
    /// [`FailureError::NotFinite`] with the stress.
    pub fn check_finite(&self) -> Result<(), FailureError> {
        finite("stress", &self.held)?;
        finite("stress", &self.applied)
    }

    /// Computes the stress σ_held + `factor` σ_applied `[stress]`; `factor` is dimensionless.
    pub fn at(&self, factor: f64) -> [f64; 3] {
        [0, 1, 2].map(|i| self.held[i] + factor * self.applied[i])
    }
}

/// What a criterion says of a loaded ply.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assessment {
    /// Name of the criterion.
    pub criterion: &'static str,
    /// f at the load as given, dimensionless: the ply has failed where it is 1 or more.
    pub index: f64,
    /// Multiple of the load at which the ply fails, dimensionless: infinite if no multiple does it, 0 if it has failed without load.
    pub reserve_factor: f64,
    /// How it fails at that multiple, or what comes nearest to failure where none does.
    pub mode: FailureMode,
}

impl Assessment {
    /// Computes the margin of safety, reserve factor − 1, dimensionless: negative where the load as given is too much.
    pub fn margin(&self) -> f64 {
        self.reserve_factor - 1.0
    }

    /// Checks whether the ply fails at the load as given or before.
    pub fn fails(&self) -> bool {
        self.reserve_factor <= 1.0
    }
}

/// A failure criterion of a ply in plane stress. Another crate's criterion implements [`assess`](Self::assess). A ply is its own
/// mirror image across its fibres, so no criterion may distinguish τ₁₂ from −τ₁₂.
pub trait FailureCriterion: Debug + Send + Sync {
    /// The short name, as in the table of [`failure`](crate::failure).
    fn name(&self) -> &'static str;

    /// The name in tables and legends.
    fn title(&self) -> String {
        self.name().replace('_', " ")
    }

    /// Whether failure by this criterion ends a joint in any mode, as of criteria of ultimate failure.
    fn is_ultimate(&self) -> bool {
        false
    }

    /// The strengths that it needs.
    fn required(&self) -> &'static [Strength];

    /// Computes index, reserve factor and mode of `ply` under `loading`.
    ///
    /// # Errors
    /// [`FailureError::MissingStrength`] if the ply lacks a strength in [`required`](Self::required),
    /// [`FailureError::NotFinite`] if a stress is not finite, [`FailureError::OpenSurface`] if its strengths make no closed surface.
    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError>;

    /// Checks that `ply` has all strengths that the criterion needs, to be known before anything is computed.
    ///
    /// # Errors
    /// [`FailureError::NoStrengths`] if the ply has none at all, [`FailureError::MissingStrength`] for the first that is missing.
    fn check(&self, ply: &Ply) -> Result<(), FailureError> {
        if ply.strengths().is_empty() {
            return Err(FailureError::NoStrengths {
                criterion: self.name(),
                ply: ply.name().to_owned(),
            });
        }
        self.required()
            .iter()
            .try_for_each(|&strength| needed_strength(self.name(), ply, strength).map(|_| ()))
    }
}

impl<C: FailureCriterion + ?Sized> FailureCriterion for Box<C> {
    fn name(&self) -> &'static str {
        self.as_ref().name()
    }

    fn title(&self) -> String {
        self.as_ref().title()
    }

    fn is_ultimate(&self) -> bool {
        self.as_ref().is_ultimate()
    }

    fn required(&self) -> &'static [Strength] {
        self.as_ref().required()
    }

    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
        self.as_ref().assess(ply, loading)
    }

    fn check(&self, ply: &Ply) -> Result<(), FailureError> {
        self.as_ref().check(ply)
    }
}

/// A criterion that many points share.
impl<C: FailureCriterion + ?Sized> FailureCriterion for Arc<C> {
    fn name(&self) -> &'static str {
        self.as_ref().name()
    }

    fn title(&self) -> String {
        self.as_ref().title()
    }

    fn is_ultimate(&self) -> bool {
        self.as_ref().is_ultimate()
    }

    fn required(&self) -> &'static [Strength] {
        self.as_ref().required()
    }

    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
        self.as_ref().assess(ply, loading)
    }

    fn check(&self, ply: &Ply) -> Result<(), FailureError> {
        self.as_ref().check(ply)
    }
}

/// Assesses a ply by several criteria, in their order.
///
/// # Errors
/// The first error of [`FailureCriterion::assess`].
pub fn assess_all(
    criteria: &[Box<dyn FailureCriterion>],
    ply: &Ply,
    loading: &PlyLoading,
) -> Result<Vec<Assessment>, FailureError> {
    criteria
        .iter()
        .map(|criterion| criterion.assess(ply, loading))
        .collect()
}
