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

use super::closest_point::YieldSurface;
use super::state::{Assembly, LayerResponse, LayerState, elastic_strain};
use super::{PointModel, PointResponse, PointState, ProgressiveError, check_step};
use crate::laminate::{Laminate, Layer};

/// Laminate of elastic–plastic plies.
#[derive(Clone, Debug)]
pub struct TsaiHillPlasticity {
    laminate: Laminate,
    /// One per layer.
    surfaces: Vec<YieldSurface>,
}

impl TsaiHillPlasticity {
    /// Model of `laminate` with the hardening `hardening` = H ≥ 0 `[1/stress]` of every ply: the plastic modulus of a uniaxial test
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

    /// Yield surface of each layer, from the bottom up.
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
        let mut assembly = Assembly::new(&self.laminate, strain, temperature, committed.dissipated);
        for (index, layer) in self.laminate.layers().iter().enumerate() {
            let share = self.layer(index, layer, &committed.layers[index], strain, temperature)?;
            assembly.add(layer, &share);
        }
        Ok(assembly.finish())
    }
}
