//! A failure criterion of its own: crushing of a ply, in which only compression along and across the fibres counts.
//!
//! ```text
//! f = max(−σ₁/X_c, −σ₂/Y_c, 0),     fails where f = 1
//! ```
//!
//! The trait and an entry in the registry are all that a criterion needs.

use stickslip_laminate::failure::{CriterionInfo, needed_strength};
use stickslip_laminate::{
    Assessment, FailureCriterion, FailureError, FailureMode, Ply, PlyLoading, Strength,
};

/// In scenes `failure.criteria = ["crushing"]`.
#[derive(Debug, Clone, Copy)]
pub struct Crushing;

impl FailureCriterion for Crushing {
    fn name(&self) -> &'static str {
        "crushing"
    }

    fn required(&self) -> &'static [Strength] {
        &[Strength::Xc, Strength::Yc]
    }

    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
        loading.check_finite()?;
        let mut found = Assessment {
            criterion: self.name(),
            index: 0.0,
            reserve_factor: f64::INFINITY,
            mode: FailureMode::MatrixCompression,
        };
        let sides = [
            (Strength::Xc, FailureMode::FibreCompression),
            (Strength::Yc, FailureMode::MatrixCompression),
        ];
        for (i, (strength, mode)) in sides.into_iter().enumerate() {
            let limit = needed_strength(self.name(), ply, strength)?;
            let [held, applied] = [-loading.held[i], -loading.applied[i]];
            let reserve_factor = if held >= limit {
                0.0
            } else if applied > 0.0 {
                (limit - held) / applied
            } else {
                f64::INFINITY
            };
            found.index = found.index.max((held + applied) / limit);
            if reserve_factor < found.reserve_factor {
                found.reserve_factor = reserve_factor;
                found.mode = mode;
            }
        }
        Ok(found)
    }
}

stickslip_laminate::inventory::submit! {
    CriterionInfo {
        name: "crushing",
        summary: "compression along and across the fibres alone, each against its strength",
        make: || Box::new(Crushing),
    }
}
