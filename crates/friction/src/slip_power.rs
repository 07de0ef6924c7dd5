//! A continuous transition from the static to the dynamic coefficient along the slip path (after Post & Reddy 1988, part II, 4.1,
//! who suggest a power law).
//!
//! ```text
//! μ(s)    = μd + (μs − μd) (1 + s/s₀)^(−m)
//! dμ/ds   = −(m/s₀) (μs − μd) (1 + s/s₀)^(−m−1)
//!
//! F_stick = μ(s) p                 s: slip path up to the last accepted step
//! F_slip  = μ(s) p                 path "committed": one bound per step
//!         = μ(s + |Δs|) p          path "current": the step in progress counts
//! ```
//!
//! | symbol     | meaning                                            | dimension     |
//! |------------|----------------------------------------------------|---------------|
//! | `μs`, `μd` | coefficient before any slip, and after much of it  | dimensionless |
//! | `s₀`       | slip scale                                         | `[length]`    |
//! | `m`        | exponent                                           | dimensionless |
//! | `s`, `Δs`  | slip path, slip increment                          | `[length]`    |
//! | `p`        | contact pressure                                   | `[stress]`    |
//!
//! Unlike a drop at the onset of slip this law has a length scale, s₀, and so a limit under mesh refinement.

use serde::{Deserialize, Serialize};

use crate::error::{FrictionError, Interval, check_coefficients};
use crate::history::History;
use crate::law::{Bound, FrictionLaw, Mirror, Place, compression};
use crate::registry::{LawInfo, ParameterInfo};

const NAME: &str = "slip_power";

/// Up to when slip counts.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SlipPath {
    /// Up to the end of the last accepted step.
    #[default]
    Committed,
    /// Including the step in progress.
    Current,
}

/// Power law in the slip path. In files
/// `slip_power = { static = 0.35, dynamic = 0.25, slip_scale = 0.001, exponent = 1.0 }`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "RawSlipPower")]
pub struct SlipPower {
    #[serde(rename = "static")]
    static_coefficient: f64,
    #[serde(rename = "dynamic")]
    dynamic_coefficient: f64,
    slip_scale: f64,
    exponent: f64,
    path: SlipPath,
    allow_strengthening: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawSlipPower {
    r#static: f64,
    dynamic: f64,
    slip_scale: f64,
    exponent: f64,
    #[serde(default)]
    path: SlipPath,
    #[serde(default)]
    allow_strengthening: bool,
}

impl SlipPower {
    /// The law with coefficients 0 ≤ dynamic ≤ static (dimensionless), `slip_scale` > 0 `[length]` and `exponent` > 0
    /// (dimensionless).
    ///
    /// # Errors
    /// [`FrictionError::OutOfRange`] if a number is outside its range or not finite, and [`FrictionError::Strengthening`] if the
    /// dynamic coefficient is the greater.
    pub fn new(
        static_coefficient: f64,
        dynamic_coefficient: f64,
        slip_scale: f64,
        exponent: f64,
        path: SlipPath,
    ) -> Result<Self, FrictionError> {
        Self::try_from(RawSlipPower {
            r#static: static_coefficient,
            dynamic: dynamic_coefficient,
            slip_scale,
            exponent,
            path,
            allow_strengthening: false,
        })
    }

    /// The law as by [`new`](Self::new), with any two coefficients ≥ 0: the dynamic one may be the greater.
    ///
    /// # Errors
    /// [`FrictionError::OutOfRange`] if a number is outside its range or not finite.
    pub fn allowing_strengthening(
        static_coefficient: f64,
        dynamic_coefficient: f64,
        slip_scale: f64,
        exponent: f64,
        path: SlipPath,
    ) -> Result<Self, FrictionError> {
        Self::try_from(RawSlipPower {
            r#static: static_coefficient,
            dynamic: dynamic_coefficient,
            slip_scale,
            exponent,
            path,
            allow_strengthening: true,
        })
    }

    /// Coefficient after the slip path `slip_path` ≥ 0 `[length]`, and its derivative `[1/length]`.
    pub fn coefficient(&self, slip_path: f64) -> (f64, f64) {
        // μs w + μd (1 − w) with w = (1 + s/s₀)^(−m): no cancellation, neither near s = 0 nor far from it.
        let logarithm = -self.exponent * (slip_path / self.slip_scale).ln_1p();
        let weight = logarithm.exp();
        let coefficient =
            self.static_coefficient * weight - self.dynamic_coefficient * logarithm.exp_m1();
        let excess = (self.static_coefficient - self.dynamic_coefficient) * weight;
        (
            coefficient,
            -self.exponent * excess / (self.slip_scale + slip_path),
        )
    }
}

impl TryFrom<RawSlipPower> for SlipPower {
    type Error = FrictionError;

    fn try_from(raw: RawSlipPower) -> Result<Self, FrictionError> {
        let coefficients = [raw.r#static, raw.dynamic];
        check_coefficients(NAME, coefficients, raw.allow_strengthening)?;
        Ok(Self {
            static_coefficient: raw.r#static,
            dynamic_coefficient: raw.dynamic,
            slip_scale: Interval::POSITIVE.check(NAME, "slip_scale", raw.slip_scale)?,
            exponent: Interval::POSITIVE.check(NAME, "exponent", raw.exponent)?,
            path: raw.path,
            allow_strengthening: raw.allow_strengthening,
        })
    }
}

#[typetag::serde(name = "slip_power")]
impl FrictionLaw for SlipPower {
    fn bound(&self, pressure: f64, slip_increment: f64, _place: &Place, past: &History) -> Bound {
        let (committed, _) = self.coefficient(past.slip_path());
        match self.path {
            SlipPath::Committed => Bound::proportional(committed, committed, pressure),
            SlipPath::Current => {
                let (current, derivative) = self.coefficient(past.slip_path() + slip_increment);
                Bound {
                    slip_ds: derivative * compression(pressure),
                    ..Bound::proportional(committed, current, pressure)
                }
            }
        }
    }

    fn is_linear(&self) -> bool {
        self.path == SlipPath::Committed
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
        summary: "coefficient that passes from static to dynamic along the slip path",
        parameters: &[
            ParameterInfo::number("static", "coefficient of a point that has never slipped, ≥ 0"),
            ParameterInfo::number("dynamic", "coefficient after a long slip path, ≥ 0 and ≤ static"),
            ParameterInfo::length("slip_scale", "slip path over which the coefficient falls, > 0"),
            ParameterInfo::number("exponent", "exponent of the fall, > 0"),
            ParameterInfo::text(
                "path",
                "\"committed\": slip counts once its step is accepted; \"current\": at once",
            ).or("\"committed\""),
            ParameterInfo::flag("allow_strengthening", "accept dynamic > static").or("false"),
        ],
    }
}
