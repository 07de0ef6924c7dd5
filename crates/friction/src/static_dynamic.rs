//! A static and a dynamic coefficient of friction (Post & Reddy 1988, part II, Eqs 2.1–2.3).
//!
//! ```text
//! F_stick = μs p   if the point was open or stuck at the end of the last accepted step (Eq. 2.1)
//!         = μd p   if it slipped in that step                                          (Eq. 2.2)
//! F_slip  = μd p      transition "drop": the traction falls as soon as slip begins     (Eq. 2.3)
//!         = F_stick   transition "lagged": one bound per step, μd from the next step on
//! ```
//!
//! | symbol     | meaning                          | dimension     |
//! |------------|----------------------------------|---------------|
//! | `μs`, `μd` | static, dynamic coefficient      | dimensionless |
//! | `p`        | contact pressure                 | `[stress]`    |
//!
//! Under "drop" a point with `μd p < |λ_t| ≤ μs p` that has not slipped may stick or slip; the committed state decides. The law
//! has no length scale, so the shear peak at the edge of the stick zone depends on the mesh. "lagged" is single-valued within a
//! step, but depends on the size of the steps.

use serde::{Deserialize, Serialize};

use crate::error::{FrictionError, check_coefficients};
use crate::history::{History, PointStatus};
use crate::law::{Bound, FrictionLaw, Mirror, Place};
use crate::registry::{LawInfo, ParameterInfo};

const NAME: &str = "static_dynamic";

/// When the traction of a point that begins to slip falls to the dynamic value.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Transition {
    /// At once, within the step in which slip begins.
    #[default]
    Drop,
    /// From the step after the one in which slip begins.
    Lagged,
}

/// Static and dynamic coefficient. In files `static_dynamic = { static = 0.35, dynamic = 0.30 }`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "RawStaticDynamic")]
pub struct StaticDynamic {
    #[serde(rename = "static")]
    static_coefficient: f64,
    #[serde(rename = "dynamic")]
    dynamic_coefficient: f64,
    transition: Transition,
    allow_strengthening: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawStaticDynamic {
    r#static: f64,
    dynamic: f64,
    #[serde(default)]
    transition: Transition,
    #[serde(default)]
    allow_strengthening: bool,
}

impl StaticDynamic {
    /// The law with coefficients 0 ≤ dynamic ≤ static, dimensionless.
    ///
    /// # Errors
    /// [`FrictionError::OutOfRange`] if a coefficient is negative or not finite, and [`FrictionError::Strengthening`] if the
    /// dynamic one is the greater.
    pub fn new(
        static_coefficient: f64,
        dynamic_coefficient: f64,
        transition: Transition,
    ) -> Result<Self, FrictionError> {
        Self::try_from(RawStaticDynamic {
            r#static: static_coefficient,
            dynamic: dynamic_coefficient,
            transition,
            allow_strengthening: false,
        })
    }

    /// The same with any two coefficients ≥ 0, dimensionless: the dynamic one may be the greater.
    ///
    /// # Errors
    /// [`FrictionError::OutOfRange`] if a coefficient is negative or not finite.
    pub fn allowing_strengthening(
        static_coefficient: f64,
        dynamic_coefficient: f64,
        transition: Transition,
    ) -> Result<Self, FrictionError> {
        Self::try_from(RawStaticDynamic {
            r#static: static_coefficient,
            dynamic: dynamic_coefficient,
            transition,
            allow_strengthening: true,
        })
    }

    /// Coefficient of a point that has not slipped in the last step, dimensionless.
    pub fn static_coefficient(&self) -> f64 {
        self.static_coefficient
    }

    /// Coefficient of a slipping point, dimensionless.
    pub fn dynamic_coefficient(&self) -> f64 {
        self.dynamic_coefficient
    }

    /// When the traction falls.
    pub fn transition(&self) -> Transition {
        self.transition
    }
}

impl TryFrom<RawStaticDynamic> for StaticDynamic {
    type Error = FrictionError;

    fn try_from(raw: RawStaticDynamic) -> Result<Self, FrictionError> {
        let coefficients = [raw.r#static, raw.dynamic];
        check_coefficients(NAME, coefficients, raw.allow_strengthening)?;
        Ok(Self {
            static_coefficient: raw.r#static,
            dynamic_coefficient: raw.dynamic,
            transition: raw.transition,
            allow_strengthening: raw.allow_strengthening,
        })
    }
}

#[typetag::serde(name = "static_dynamic")]
impl FrictionLaw for StaticDynamic {
    fn bound(&self, pressure: f64, _slip_increment: f64, _place: &Place, past: &History) -> Bound {
        let stick = match past.status() {
            PointStatus::Open | PointStatus::Stick => self.static_coefficient,
            PointStatus::Slip => self.dynamic_coefficient,
        };
        let slip = match self.transition {
            Transition::Drop => self.dynamic_coefficient,
            Transition::Lagged => stick,
        };
        Bound::proportional(stick, slip, pressure)
    }

    fn is_linear(&self) -> bool {
        self.transition == Transition::Lagged || self.static_coefficient == self.dynamic_coefficient
    }

    fn strengthens(&self) -> bool {
        self.dynamic_coefficient > self.static_coefficient
    }

    fn is_symmetric(&self, _mirror: &Mirror) -> bool {
        true
    }

    fn box_clone(&self) -> Box<dyn FrictionLaw> {
        Box::new(self.clone())
    }
}

inventory::submit! {
    LawInfo {
        name: NAME,
        summary: "static coefficient before slip, dynamic coefficient during it",
        parameters: &[
            ParameterInfo::number("static", "coefficient of a point that was open or stuck in the last step, ≥ 0"),
            ParameterInfo::number("dynamic", "coefficient of a slipping point, ≥ 0 and ≤ static"),
            ParameterInfo::text(
                "transition",
                "\"drop\": the traction falls as soon as slip begins; \"lagged\": from the next step on",
            ).or("\"drop\""),
            ParameterInfo::flag("allow_strengthening", "accept dynamic > static").or("false"),
        ],
    }
}
