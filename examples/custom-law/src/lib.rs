//! A friction law in a crate of its own; [`criterion`] and [`point_model`] are the same for the failure of plies.
//!
//! Running-in of a coated surface: the coefficient passes from that of the fresh coating to that of the worn surface along the
//! slip path s,
//!
//! ```text
//! F = μ(s) p,   μ(s) = μ_worn + (μ_fresh − μ_worn) exp(−s/s₀)
//! ```
//!
//! with s the path before the step. Stick and slip share the bound, so a step has one answer however the coefficient moves.
//! The three things below are all that a law needs: its parameters with their check, the trait, and an entry in the registry
//! from which the scene reader knows which parameters carry units.

use serde::{Deserialize, Serialize};
use stickslip_friction::{
    Bound, FrictionError, FrictionLaw, History, Interval, LawInfo, Mirror, ParameterInfo, Place,
};

pub mod criterion;
pub mod point_model;

const NAME: &str = "running_in";

/// In scenes `friction.running_in = { fresh = 0.1, worn = 0.25, slip_scale = "0.002 in" }`.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(try_from = "RawRunningIn")]
pub struct RunningIn {
    fresh: f64,
    worn: f64,
    slip_scale: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawRunningIn {
    fresh: f64,
    worn: f64,
    slip_scale: f64,
}

impl TryFrom<RawRunningIn> for RunningIn {
    type Error = FrictionError;

    fn try_from(raw: RawRunningIn) -> Result<Self, FrictionError> {
        Ok(Self {
            fresh: Interval::NON_NEGATIVE.check(NAME, "fresh", raw.fresh)?,
            worn: Interval::NON_NEGATIVE.check(NAME, "worn", raw.worn)?,
            slip_scale: Interval::POSITIVE.check(NAME, "slip_scale", raw.slip_scale)?,
        })
    }
}

#[typetag::serde(name = "running_in")]
impl FrictionLaw for RunningIn {
    fn bound(&self, pressure: f64, _slip_increment: f64, _place: &Place, past: &History) -> Bound {
        let fade = (-past.slip_path() / self.slip_scale).exp();
        let coefficient = self.worn + (self.fresh - self.worn) * fade;
        Bound::proportional(coefficient, coefficient, pressure)
    }

    fn is_linear(&self) -> bool {
        true
    }

    // It depends neither on the place nor on the direction of past slip. Without this claim every scene is modelled as a whole.
    fn is_symmetric(&self, _mirror: &Mirror) -> bool {
        true
    }

    fn box_clone(&self) -> Box<dyn FrictionLaw> {
        Box::new(self.clone())
    }
}

stickslip_friction::inventory::submit! {
    LawInfo {
        name: NAME,
        summary: "coefficient that passes from a fresh coating's to a worn surface's along the slip path",
        parameters: &[
            ParameterInfo::number("fresh", "coefficient of the fresh coating, ≥ 0"),
            ParameterInfo::number("worn", "coefficient of the worn surface, ≥ 0"),
            ParameterInfo::length("slip_scale", "slip path over which most of the passage happens, > 0"),
        ],
    }
}
