//! Criteria without interaction.
//!
//! ```text
//! maximum stress   max( σ₁/X_t, −σ₁/X_c, σ₂/Y_t, −σ₂/Y_c, |τ₁₂|/S₁₂ )
//! maximum strain   the same of the strains ε = S σ and their limits
//! ```
//!
//! Strains are those that stress causes: free thermal expansion does not count. Source: Jones (1999), 2.9.1 and 2.9.2.

use stickslip_fem_core::material::apply;

use super::criterion::{Assessment, FailureCriterion, PlyLoading};
use super::error::{FailureError, finite};
use super::needed::{IN_PLANE, in_plane, needed_strength};
use super::ray::{Branch, Surface};
use super::registry::CriterionInfo;
use crate::failure_mode::FailureMode;
use crate::ply::Ply;
use crate::strengths::Strength;

/// Maximum stress: each stress against its own strength (Jones 1999, 2.9.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaximumStress;

/// Maximum strain: each strain that stress causes against its own limit (Jones 1999, 2.9.2).
/// [`Strengths::with_linear_strain_limits`](crate::Strengths::with_linear_strain_limits) makes limits from strengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaximumStrain;

impl FailureCriterion for MaximumStress {
    fn name(&self) -> &'static str {
        "max_stress"
    }

    fn title(&self) -> String {
        "maximum stress".to_owned()
    }

    fn required(&self) -> &'static [Strength] {
        &IN_PLANE
    }

    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
        let strengths = in_plane(self.name(), ply)?;
        let limits = Limits {
            tension: [strengths.xt, strengths.yt],
            compression: [strengths.xc, strengths.yc],
            shear: strengths.s12,
        };
        limits.assess(self.name(), &loading.held, &loading.applied)
    }
}

impl FailureCriterion for MaximumStrain {
    fn name(&self) -> &'static str {
        "max_strain"
    }

    fn title(&self) -> String {
        "maximum strain".to_owned()
    }

    fn required(&self) -> &'static [Strength] {
        &[
            Strength::Strain1t,
            Strength::Strain1c,
            Strength::Strain2t,
            Strength::Strain2c,
            Strength::Strain12,
        ]
    }

    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
        let limit = |strength| needed_strength(self.name(), ply, strength);
        let limits = Limits {
            tension: [limit(Strength::Strain1t)?, limit(Strength::Strain2t)?],
            compression: [limit(Strength::Strain1c)?, limit(Strength::Strain2c)?],
            shear: limit(Strength::Strain12)?,
        };
        let strain = |stress| apply(ply.compliance(), stress);
        limits.assess(self.name(), &strain(loading.held), &strain(loading.applied))
    }
}

/// Fibre failure alone, for a ply whose matrix has failed already: σ₁/X_t or −σ₁/X_c.
pub(crate) fn fibre_assessment(
    ply: &Ply,
    loading: &PlyLoading,
) -> Result<Assessment, FailureError> {
    let name = MaximumStress.name();
    let [xt, xc] = [
        needed_strength(name, ply, Strength::Xt)?,
        needed_strength(name, ply, Strength::Xc)?,
    ];
    let surface = Surface {
        criterion: name,
        branches: |[tension]: [bool; 1]| {
            let branch = if tension {
                Branch::linear(FailureMode::FibreTension, [1.0 / xt])
            } else {
                Branch::linear(FailureMode::FibreCompression, [-1.0 / xc])
            };
            [Some(branch), None, None]
        },
        dominant: |_: &[f64; 1]| FailureMode::FibreTension,
    };
    surface.assess(&[loading.held[0]], &[loading.applied[0]])
}

struct Limits {
    tension: [f64; 2],
    compression: [f64; 2],
    shear: f64,
}

/// Modes by variable and side.
const MODES: [[FailureMode; 2]; 3] = [
    [FailureMode::FibreTension, FailureMode::FibreCompression],
    [FailureMode::MatrixTension, FailureMode::MatrixCompression],
    [FailureMode::Shear, FailureMode::Shear],
];

impl Limits {
    /// Without interaction every variable goes its own way: the reserve factor is the least (limit − held)/applied.
    fn assess(
        &self,
        criterion: &'static str,
        held: &[f64; 3],
        applied: &[f64; 3],
    ) -> Result<Assessment, FailureError> {
        finite("stress", held)?;
        finite("stress", applied)?;
        let mut index = (f64::NEG_INFINITY, FailureMode::Shear);
        let mut crossing = (f64::INFINITY, None);
        for i in 0..3 {
            let sides = [self.limit(i, 0), self.limit(i, 1)];
            let there = held[i] + applied[i];
            let side = usize::from(there < 0.0);
            let ratio = there.abs() / sides[side];
            if ratio > index.0 {
                index = (ratio, MODES[i][side]);
            }
            let (factor, side) = first_reached(held[i], applied[i], sides);
            if factor < crossing.0 {
                crossing = (factor, Some(MODES[i][side]));
            }
        }
        Ok(Assessment {
            criterion,
            index: index.0,
            reserve_factor: crossing.0,
            mode: crossing.1.unwrap_or(index.1),
        })
    }

    fn limit(&self, variable: usize, side: usize) -> f64 {
        match variable {
            2 => self.shear,
            _ if side == 0 => self.tension[variable],
            _ => self.compression[variable],
        }
    }
}

/// The smallest r ≥ 0 at which held + r applied is at one of the limits, upper and lower, or beyond; and which one it is.
fn first_reached(held: f64, applied: f64, [upper, lower]: [f64; 2]) -> (f64, usize) {
    if held >= upper {
        (0.0, 0)
    } else if held <= -lower {
        (0.0, 1)
    } else if applied > 0.0 {
        ((upper - held) / applied, 0)
    } else if applied < 0.0 {
        ((lower + held) / -applied, 1)
    } else {
        (f64::INFINITY, 0)
    }
}

inventory::submit! {
    CriterionInfo {
        name: "max_stress",
        summary: "each stress against its strength; Jones (1999), 2.9.1",
        make: || Box::new(MaximumStress),
    }
}

inventory::submit! {
    CriterionInfo {
        name: "max_strain",
        summary: "each strain against its limit; Jones (1999), 2.9.2",
        make: || Box::new(MaximumStrain),
    }
}
