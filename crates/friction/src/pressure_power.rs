//! A coefficient that falls with pressure (Oden & Martins, Comput. Methods Appl. Mech. Eng. 52, 1985, 527–634: pressure and
//! friction as powers m_n, m_T of the approach of the surfaces, so that m = m_T/m_n).
//!
//! ```text
//! μ(p)  = μ₀ (p/p₀)^(m−1),   0 < m ≤ 1
//! F     = μ(p) p = μ₀ p₀ (p/p₀)^m
//! dF/dp = m μ₀ (p/p₀)^(m−1)
//! ```
//!
//! | symbol | meaning                       | dimension     |
//! |--------|-------------------------------|---------------|
//! | `μ₀`   | coefficient at pressure p₀    | dimensionless |
//! | `p₀`   | reference pressure            | `[stress]`    |
//! | `m`    | exponent                      | dimensionless |
//! | `p`    | contact pressure              | `[stress]`    |
//!
//! For m < 1 the derivative is unbounded at p → 0. A pressure below ε p₀ (ε: spacing of the floating-point numbers at 1) is not
//! distinguished from zero in a solution whose pressures are of the order p₀, so below it the derivative at ε p₀ is returned: finite, and
//! at most μ₀/ε. The value is exact at all pressures.

use serde::{Deserialize, Serialize};

use crate::error::{FrictionError, Interval};
use crate::history::History;
use crate::law::{Bound, FrictionLaw, Mirror, Place, compression};
use crate::registry::{LawInfo, ParameterInfo};

const NAME: &str = "pressure_power";

/// Power law in the pressure. In files `pressure_power = { mu = 0.3, reference_pressure = 100.0, exponent = 0.8 }`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "RawPressurePower")]
pub struct PressurePower {
    mu: f64,
    reference_pressure: f64,
    exponent: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawPressurePower {
    mu: f64,
    reference_pressure: f64,
    exponent: f64,
}

impl PressurePower {
    /// The law with coefficient `mu` ≥ 0 (dimensionless) at `reference_pressure` > 0 `[stress]`, and 0 < `exponent` ≤ 1
    /// (dimensionless).
    ///
    /// # Errors
    /// [`FrictionError::OutOfRange`] if a number is outside its range or not finite.
    pub fn new(mu: f64, reference_pressure: f64, exponent: f64) -> Result<Self, FrictionError> {
        Ok(Self {
            mu: Interval::NON_NEGATIVE.check(NAME, "mu", mu)?,
            reference_pressure: Interval::POSITIVE.check(
                NAME,
                "reference_pressure",
                reference_pressure,
            )?,
            exponent: Interval::open_closed(0.0, 1.0).check(NAME, "exponent", exponent)?,
        })
    }
}

impl TryFrom<RawPressurePower> for PressurePower {
    type Error = FrictionError;

    fn try_from(raw: RawPressurePower) -> Result<Self, FrictionError> {
        Self::new(raw.mu, raw.reference_pressure, raw.exponent)
    }
}

#[typetag::serde(name = "pressure_power")]
impl FrictionLaw for PressurePower {
    fn bound(&self, pressure: f64, _slip_increment: f64, _place: &Place, _past: &History) -> Bound {
        if self.exponent == 1.0 {
            // Coulomb's law to the last digit, as is_linear promises.
            return Bound::proportional(self.mu, self.mu, pressure);
        }
        let ratio = compression(pressure) / self.reference_pressure;
        let value = self.mu * self.reference_pressure * ratio.powf(self.exponent);
        let derivative =
            self.exponent * self.mu * ratio.max(f64::EPSILON).powf(self.exponent - 1.0);
        Bound::single(value, derivative)
    }

    fn is_linear(&self) -> bool {
        self.exponent == 1.0
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
        summary: "coefficient that falls with pressure as a power",
        parameters: &[
            ParameterInfo::number("mu", "coefficient of friction at the reference pressure, ≥ 0"),
            ParameterInfo::stress("reference_pressure", "pressure at which mu holds, > 0"),
            ParameterInfo::number("exponent", "shear grows as this power of the pressure, in (0, 1]; 1 is Coulomb's law"),
        ],
    }
}
