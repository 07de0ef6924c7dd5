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
//! | [`YamadaSun`]      | `yamada_sun`    | Yamada & Sun (1978): no matrix failure    |

mod criterion;
mod envelope;
mod error;
mod first_ply;
mod hashin;
mod last_ply;
mod maximum;
mod needed;
mod quadratic;
mod ray;
mod registry;
mod solid;
mod yamada_sun;

pub use crate::failure_mode::FailureMode;
pub use criterion::{Assessment, FailureCriterion, PlyLoading, assess_all};
pub use envelope::{EnvelopeEvent, EnvelopePlane, EnvelopePoint, failure_envelope};
pub use error::FailureError;
pub use first_ply::{PlyAssessment, assess_plies, first_ply_failure};
pub use hashin::Hashin;
pub use last_ply::{FailureHistory, PlyFailureEvent, last_ply_failure};
pub(crate) use maximum::fibre_assessment;
pub use maximum::{MaximumStrain, MaximumStress};
pub use needed::needed_strength;
pub use quadratic::{Hoffman, Interaction, TsaiHill, TsaiWu};
pub use registry::{CriterionInfo, criteria, criterion_named};
pub use solid::TsaiHillSolid;
pub use yamada_sun::YamadaSun;

/// Makes the criteria that describe a ply up to its first failure, of whatever kind, with their usual parameters.
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
