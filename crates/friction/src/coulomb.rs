//! Coulomb's law.
//!
//! ```text
//! F_stick = F_slip = μ p
//! ```
//!
//! | symbol | meaning                    | dimension     |
//! |--------|----------------------------|---------------|
//! | `μ`    | coefficient of friction    | dimensionless |
//! | `p`    | contact pressure           | `[stress]`    |

use serde::{Deserialize, Serialize};

use crate::error::{FrictionError, Interval};
use crate::history::History;
use crate::law::{Bound, FrictionLaw, Mirror, Place};
use crate::registry::{LawInfo, ParameterInfo};

const NAME: &str = "coulomb";

/// Coulomb's law: one constant coefficient. In files `coulomb = { mu = 0.3 }`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "RawCoulomb")]
pub struct Coulomb {
    mu: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawCoulomb {
    mu: f64,
}

impl Coulomb {
    /// The law with coefficient `mu` ≥ 0, dimensionless.
    ///
    /// # Errors
    /// [`FrictionError::OutOfRange`] if `mu` is negative or not finite.
    pub fn new(mu: f64) -> Result<Self, FrictionError> {
        Ok(Self {
            mu: Interval::NON_NEGATIVE.check(NAME, "mu", mu)?,
        })
    }

    /// Coefficient of friction, dimensionless.
    pub fn mu(&self) -> f64 {
        self.mu
    }
}

impl TryFrom<RawCoulomb> for Coulomb {
    type Error = FrictionError;

    fn try_from(raw: RawCoulomb) -> Result<Self, FrictionError> {
        Self::new(raw.mu)
    }
}

#[typetag::serde(name = "coulomb")]
impl FrictionLaw for Coulomb {
    fn bound(&self, pressure: f64, _slip_increment: f64, _place: &Place, _past: &History) -> Bound {
        Bound::proportional(self.mu, self.mu, pressure)
    }

    fn is_linear(&self) -> bool {
        true
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
        summary: "constant coefficient of friction",
        parameters: &[ParameterInfo::number("mu", "coefficient of friction, ≥ 0")],
    }
}
