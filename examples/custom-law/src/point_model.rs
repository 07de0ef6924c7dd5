//! A point model of its own: a laminate without damage whose shear stress levels off.
//!
//! ```text
//! σ̄ = A/h (ε − ᾱ ΔT)   but   τ̄_xy = τ₀ tanh(G γ/τ₀),   G = A₆₆/h
//! ```
//!
//! The response is elastic: loading and unloading follow one curve, the stored energy is ∫ σ̄ · dε, and nothing is dissipated. It
//! holds for a balanced lay-up, whose A₁₆ and A₂₆ vanish.

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use stickslip_laminate::progressive::{
    ParameterInfo, PointModelInfo, PointModelParameters, PointResponse, ProgressiveError,
    check_step,
};
use stickslip_laminate::{
    FailureCriterion, Laminate, LaminateMembrane, Material, PointModel, PointState,
};

/// In scenes `failure.progressive.model.soft_shear = { limit = "200 MPa" }`.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(try_from = "RawSoftShear")]
pub struct SoftShear {
    limit: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawSoftShear {
    limit: f64,
}

impl TryFrom<RawSoftShear> for SoftShear {
    type Error = String;

    fn try_from(raw: RawSoftShear) -> Result<Self, String> {
        let RawSoftShear { limit } = raw;
        if limit.is_finite() && limit > 0.0 {
            Ok(Self { limit })
        } else {
            Err(format!("limit = {limit} must be positive and finite"))
        }
    }
}

#[typetag::serde(name = "soft_shear")]
impl PointModelParameters for SoftShear {
    fn model(
        &self,
        laminate: Laminate,
        _criterion: &Arc<dyn FailureCriterion>,
    ) -> Result<Arc<dyn PointModel>, ProgressiveError> {
        Ok(Arc::new(SoftShearPoint {
            membrane: laminate.flat_membrane_material(),
            laminate,
            limit: self.limit,
        }))
    }

    fn describe(&self, _criterion: &str, stress: &dyn Fn(f64) -> String) -> String {
        format!("no damage, shear levelling off at {}", stress(self.limit))
    }
}

#[derive(Debug)]
struct SoftShearPoint {
    laminate: Laminate,
    membrane: LaminateMembrane,
    limit: f64,
}

impl PointModel for SoftShearPoint {
    fn laminate(&self) -> &Laminate {
        &self.laminate
    }

    fn respond(
        &self,
        committed: &PointState,
        strain: [f64; 3],
        temperature: f64,
    ) -> Result<PointResponse, ProgressiveError> {
        check_step(&self.laminate, committed, strain, temperature)?;
        let mut tangent = self.membrane.stiffness();
        let free = self.membrane.thermal_strain(temperature);
        let elastic = [0, 1, 2].map(|i| strain[i] - free[i]);
        let part = self.limit / tangent[2][2];
        let level = (elastic[2] / part).tanh();
        let normal = |row: [f64; 3]| row[0] * elastic[0] + row[1] * elastic[1];
        let stress = [normal(tangent[0]), normal(tangent[1]), self.limit * level];
        let shear_energy = self.limit * part * (elastic[2] / part).cosh().ln();
        tangent[2][2] *= 1.0 - level * level;
        for i in [0, 1] {
            tangent[i][2] = 0.0;
            tangent[2][i] = 0.0;
        }
        let mut trial = committed.clone();
        trial.strain = strain;
        trial.temperature = temperature;
        trial.stored = 0.5 * (stress[0] * elastic[0] + stress[1] * elastic[1]) + shear_energy;
        Ok(PointResponse {
            stress,
            tangent,
            trial,
        })
    }
}

stickslip_laminate::inventory::submit! {
    PointModelInfo {
        name: "soft_shear",
        summary: "no damage, shear that levels off",
        parameters: &[ParameterInfo::stress("limit", "largest shear stress of the laminate, > 0")],
    }
}
