//! Failure criteria of a ply, and of a laminate by its plies.
//!
//! ```text
//! σ(r) = σ_held + r σ_applied,     index = f(σ(1)),     reserve factor = the smallest r ≥ 0 with f(σ(r)) ≥ 1
//! ```
//!
//! σ_held stays while the load grows: the residual stress of the cure, or zero. Every criterion here is, for given signs of the
//! stresses, a set of quadratic polynomials in σ, so f along the ray is a quadratic in r on each interval between changes of sign,
//! and the reserve factor comes from its roots in closed form. f is 1 on the surface but does not grow in proportion to the load:
//! compare loads by the reserve factor, not by the index.
//!
//! | criterion          | name            | source                                    |
//! |--------------------|-----------------|-------------------------------------------|
//! | [`MaximumStress`]  | `max_stress`    | Jones (1999), 2.9.1                       |
//! | [`MaximumStrain`]  | `max_strain`    | Jones (1999), 2.9.2                       |
//! | [`TsaiHill`]       | `tsai_hill`     | Azzi & Tsai (1965), strengths by sign     |
//! | [`TsaiHillSolid`]  | `tsai_hill_3d`  | Post & Reddy (1988), part II, 4.4         |
//! | [`Hoffman`]        | `hoffman`       | Hoffman (1967)                            |
//! | [`TsaiWu`]         | `tsai_wu`       | Tsai & Wu (1971)                          |
//! | [`Hashin`]         | `hashin`        | Hashin (1980)                             |

mod envelope;
mod error;
mod first_ply;
mod hashin;
mod last_ply;
mod maximum;
mod mode;
mod quadratic;
mod ray;
mod solid;

use std::fmt::Debug;

pub use envelope::{EnvelopeEvent, EnvelopePlane, EnvelopePoint, failure_envelope};
pub use error::FailureError;
pub use first_ply::{PlyAssessment, assess_plies, first_ply_failure};
pub use hashin::Hashin;
pub use last_ply::{FailureHistory, PlyFailureEvent, last_ply_failure};
pub(crate) use maximum::fibre_assessment;
pub use maximum::{MaximumStrain, MaximumStress};
pub use mode::FailureMode;
pub use quadratic::{Hoffman, Interaction, TsaiHill, TsaiWu};
pub use solid::TsaiHillSolid;

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
    /// The stress `applied` `[stress]` without residual stress.
    pub fn mechanical(applied: [f64; 3]) -> Self {
        Self {
            held: [0.0; 3],
            applied,
        }
    }

    /// The stress `[stress]` at `factor` times the load.
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
    /// Multiple of the load at which the ply fails: infinite if no multiple does it, 0 if it has failed without load.
    pub reserve_factor: f64,
    /// How it fails at that multiple, or what comes nearest to failure where none does.
    pub mode: FailureMode,
}

impl Assessment {
    /// Margin of safety, reserve factor − 1: negative where the load as given is too much.
    pub fn margin(&self) -> f64 {
        self.reserve_factor - 1.0
    }

    /// Whether the ply fails at the load as given or before.
    pub fn fails(&self) -> bool {
        self.reserve_factor <= 1.0
    }
}

/// A failure criterion of a ply in plane stress. Another crate's criterion implements [`assess`](Self::assess). A ply is its own
/// mirror image across its fibres, so no criterion may tell τ₁₂ from −τ₁₂.
pub trait FailureCriterion: Debug + Send + Sync {
    /// Short name, as in the table of the [module](self).
    fn name(&self) -> &'static str;

    /// The strengths that it asks for.
    fn required(&self) -> &'static [Strength];

    /// Index, reserve factor and mode of `ply` under `loading`.
    ///
    /// # Errors
    /// [`FailureError::MissingStrength`] if the ply lacks a strength in [`required`](Self::required),
    /// [`FailureError::NotFinite`] if a stress is not finite, [`FailureError::OpenSurface`] if its strengths make no closed surface.
    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError>;

    /// Whether `ply` has all strengths that it asks for, to be known before anything is computed.
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
            .try_for_each(|&strength| needed(self.name(), ply, strength).map(|_| ()))
    }
}

/// All criteria of this crate, with their usual parameters.
pub fn standard_criteria() -> Vec<Box<dyn FailureCriterion>> {
    vec![
        Box::new(MaximumStress),
        Box::new(MaximumStrain),
        Box::new(TsaiHill),
        Box::new(TsaiHillSolid),
        Box::new(Hoffman),
        Box::new(TsaiWu::default()),
        Box::new(Hashin::default()),
    ]
}

/// The criterion of this name with its usual parameters.
///
/// # Errors
/// [`FailureError::UnknownCriterion`] with the names that there are.
pub fn criterion_named(name: &str) -> Result<Box<dyn FailureCriterion>, FailureError> {
    let criteria = standard_criteria();
    let known = criteria.iter().map(|criterion| criterion.name()).collect();
    let found = criteria
        .into_iter()
        .find(|criterion| criterion.name() == name);
    found.ok_or_else(|| FailureError::UnknownCriterion {
        name: name.to_owned(),
        known,
    })
}

/// Several criteria at once, in their order.
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

fn needed(criterion: &'static str, ply: &Ply, strength: Strength) -> Result<f64, FailureError> {
    ply.strengths()
        .get(strength)
        .ok_or_else(|| FailureError::MissingStrength {
            criterion,
            strength,
            ply: ply.name().to_owned(),
        })
}

/// The five in-plane strengths X_t, X_c, Y_t, Y_c, S₁₂.
const IN_PLANE: [Strength; 5] = [
    Strength::Xt,
    Strength::Xc,
    Strength::Yt,
    Strength::Yc,
    Strength::S12,
];

fn in_plane(criterion: &'static str, ply: &Ply) -> Result<InPlane, FailureError> {
    Ok(InPlane {
        xt: needed(criterion, ply, Strength::Xt)?,
        xc: needed(criterion, ply, Strength::Xc)?,
        yt: needed(criterion, ply, Strength::Yt)?,
        yc: needed(criterion, ply, Strength::Yc)?,
        s12: needed(criterion, ply, Strength::S12)?,
    })
}

#[derive(Clone, Copy)]
struct InPlane {
    xt: f64,
    xc: f64,
    yt: f64,
    yc: f64,
    s12: f64,
}

impl InPlane {
    /// The mode of the stress that is nearest to its strength: interactive criteria do not tell modes apart themselves.
    fn dominant(&self, [s1, s2, t]: &[f64; 3]) -> FailureMode {
        mode::largest(&[
            (s1 / self.xt, FailureMode::FibreTension),
            (-s1 / self.xc, FailureMode::FibreCompression),
            (s2 / self.yt, FailureMode::MatrixTension),
            (-s2 / self.yc, FailureMode::MatrixCompression),
            (t.abs() / self.s12, FailureMode::Shear),
        ])
    }
}
