//! Elastic–plastic plies with the Tsai–Hill quadratic as Hill's yield function; the equations are those of
//! [`YieldSurface`], whose strengths are the yield stresses.
//!
//! ```text
//! ε*_k = T_k ε − α ΔT − ε^p_k,n   →   σ_k, Δε^p_k, Δλ_k by closest-point projection
//! dissipated += Σ_k (h_k/h) σ_k · Δε^p_k                                               ≥ 0
//! ```
//!
//! The step is implicit: its plastic work is that of the stress at its end, and the result converges with the first power of the
//! step where the direction of flow turns. In a proportional stress path it is exact in one step. What hardening stores at the
//! microscale counts as dissipated.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::closest_point::YieldSurface;
use super::error::ProgressiveError;
use super::model::{PointModel, check_step};
use super::registry::{ParameterInfo, PointModelInfo, PointModelParameters};
use super::state::{
    LayerResponse, LayerState, PointResponse, PointState, by_layers, elastic_strain,
};
use crate::failure::FailureCriterion;
use crate::laminate::{Laminate, Layer};
use crate::strengths::Strength;

/// Laminate of elastic–plastic plies.
#[derive(Clone, Debug)]
pub struct TsaiHillPlasticity {
    laminate: Laminate,
    /// One per layer.
    surfaces: Vec<YieldSurface>,
}

impl TsaiHillPlasticity {
    /// Makes the model of `laminate` with the hardening `hardening` = H ≥ 0 `[1/stress]` of every ply: the plastic modulus of a uniaxial test
    /// is H times the square of the strength; 0 is perfect plasticity.
    ///
    /// # Errors
    /// As [`YieldSurface::new`].
    pub fn new(laminate: Laminate, hardening: f64) -> Result<Self, ProgressiveError> {
        let surfaces = laminate
            .layers()
            .iter()
            .map(|layer| YieldSurface::new(layer.ply(), hardening));
        Ok(Self {
            surfaces: surfaces.collect::<Result<_, _>>()?,
            laminate,
        })
    }

    /// Makes the model of `laminate` whose first ply, sheared, has the plastic modulus dτ/dγᵖ = `modulus` ≥ 0 `[stress]`; every ply has the same
    /// H = `modulus`/S₁₂². 0 is perfect plasticity.
    ///
    /// # Errors
    /// As [`YieldSurface::new`].
    pub fn with_shear_modulus(laminate: Laminate, modulus: f64) -> Result<Self, ProgressiveError> {
        // Without a shear strength there is no surface, which `new` reports.
        let strengths = laminate
            .layers()
            .first()
            .map(|layer| layer.ply().strengths());
        let shear = strengths.and_then(|strengths| strengths.get(Strength::S12));
        let hardening = shear.map_or(0.0, |shear| modulus / (shear * shear));
        Self::new(laminate, hardening)
    }

    /// The yield surface of each layer, from the bottom up.
    pub fn surfaces(&self) -> &[YieldSurface] {
        &self.surfaces
    }

    fn layer(
        &self,
        index: usize,
        layer: &Layer,
        committed: &LayerState,
        strain: [f64; 3],
        temperature: f64,
    ) -> Result<LayerResponse, ProgressiveError> {
        let trial = elastic_strain(layer, strain, temperature, committed.plastic_strain);
        let end = self.surfaces[index]
            .closest_point(trial, committed.hardening)
            .map_err(|(distance, iterations)| ProgressiveError::ReturnMapping {
                layer: index,
                distance,
                iterations,
            })?;
        let work: f64 = (0..3)
            .map(|i| end.stress[i] * end.plastic_increment[i])
            .sum();
        Ok(LayerResponse {
            state: LayerState {
                stress: end.stress,
                plastic_strain: [0, 1, 2]
                    .map(|i| committed.plastic_strain[i] + end.plastic_increment[i]),
                hardening: committed.hardening + end.hardening_increment,
                damage: committed.damage,
            },
            elastic_strain: [0, 1, 2].map(|i| trial[i] - end.plastic_increment[i]),
            tangent: end.tangent,
            dissipated: work,
        })
    }
}

impl PointModel for TsaiHillPlasticity {
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
        let layer = |index: usize, layer: &Layer| {
            self.layer(index, layer, &committed.layers[index], strain, temperature)
        };
        by_layers(&self.laminate, committed, strain, temperature, layer)
    }
}

/// Parameters of [`TsaiHillPlasticity`], in files `plasticity = { hardening = "500 MPa" }`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "RawPlasticity")]
pub struct PlasticityParameters {
    hardening: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawPlasticity {
    hardening: f64,
}

impl PlasticityParameters {
    /// Checks the plastic shear modulus dτ/dγᵖ = `hardening` ≥ 0 `[stress]` of the first ply.
    ///
    /// # Errors
    /// [`ProgressiveError::Hardening`] unless it is finite and not negative.
    pub fn new(hardening: f64) -> Result<Self, ProgressiveError> {
        if hardening.is_finite() && hardening >= 0.0 {
            Ok(Self { hardening })
        } else {
            Err(ProgressiveError::Hardening { value: hardening })
        }
    }

    /// The plastic shear modulus as given `[stress]`.
    pub fn hardening(&self) -> f64 {
        self.hardening
    }
}

impl TryFrom<RawPlasticity> for PlasticityParameters {
    type Error = ProgressiveError;

    fn try_from(raw: RawPlasticity) -> Result<Self, ProgressiveError> {
        Self::new(raw.hardening)
    }
}

#[typetag::serde(name = "plasticity")]
impl PointModelParameters for PlasticityParameters {
    fn model(
        &self,
        laminate: Laminate,
        _criterion: &Arc<dyn FailureCriterion>,
    ) -> Result<Arc<dyn PointModel>, ProgressiveError> {
        let model = TsaiHillPlasticity::with_shear_modulus(laminate, self.hardening)?;
        Ok(Arc::new(model))
    }

    fn describe(&self, _criterion: &str, stress: &dyn Fn(f64) -> String) -> String {
        let modulus = stress(self.hardening);
        format!("Tsai–Hill plasticity, plastic shear modulus {modulus}")
    }
}

inventory::submit! {
    PointModelInfo {
        name: "plasticity",
        summary: "plies flow from the Tsai–Hill surface on",
        parameters: &[ParameterInfo::stress(
            "hardening",
            "plastic shear modulus of a ply, by the shear strength of the first ply, ≥ 0; 0 is perfect plasticity",
        )],
    }
}
