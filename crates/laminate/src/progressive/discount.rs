//! Ply discount at a point: a ply loses stiffness at once when its criterion is met.
//!
//! ```text
//! ε(s) = ε_n + s (ε − ε_n),   ΔT(s) likewise,   s ∈ [0, 1]
//! at the smallest s with index(σ_k(s)) ≥ 1:  Q_k ← Q_k(damage),  dissipated += ½ e · (Q_before − Q_after) e,  go on from s
//! ```
//!
//! e is the elastic strain of the ply. Every ply follows its own strain, so a step along a straight path finds the same events
//! whatever its size, and passes several of them exactly. The tangent is the stiffness after the step, which is the derivative of
//! the stress except at the events themselves, where the stress jumps. After matrix failure a ply is checked for fibre failure only.
//!
//! The energy dissipated is per volume: in a body it shrinks with the elements in which the damage gathers, so the load at which a
//! structure fails depends on its mesh.

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use stickslip_fem_core::material::{PlaneStiffness, apply};

use super::error::ProgressiveError;
use super::model::{PointModel, check_step};
use super::registry::{ParameterInfo, PointModelInfo, PointModelParameters};
use super::state::{LayerResponse, PointResponse, PointState, by_layers, elastic_strain, energy};
use crate::degradation::Degradation;
use crate::failure::{FailureCriterion, FailureError, PlyLoading, fibre_assessment};
use crate::laminate::{Laminate, Layer};

/// Ply discount by a failure criterion and degradation factors.
#[derive(Debug)]
pub struct PlyDiscount {
    laminate: Laminate,
    criterion: Box<dyn FailureCriterion>,
    degradation: Degradation,
}

impl PlyDiscount {
    /// Makes the model of `laminate` whose plies fail by `criterion` and then keep what `degradation` leaves them.
    ///
    /// # Errors
    /// [`ProgressiveError::Failure`] if a ply lacks a strength that `criterion`, or the fibre check after matrix failure, needs.
    pub fn new(
        laminate: Laminate,
        criterion: Box<dyn FailureCriterion>,
        degradation: Degradation,
    ) -> Result<Self, ProgressiveError> {
        for layer in laminate.layers() {
            criterion.check(layer.ply())?;
            fibre_assessment(layer.ply(), &PlyLoading::default())?;
        }
        Ok(Self {
            laminate,
            criterion,
            degradation,
        })
    }

    /// The factors on the moduli of failed plies.
    pub fn degradation(&self) -> &Degradation {
        &self.degradation
    }

    /// The layer with index `index` on the way from `committed` to `strain`.
    fn layer(
        &self,
        index: usize,
        layer: &Layer,
        committed: &PointState,
        strain: [f64; 3],
        temperature: f64,
    ) -> Result<LayerResponse, FailureError> {
        let mut state = committed.layers[index];
        let plastic = state.plastic_strain;
        let mut from = elastic_strain(layer, committed.strain, committed.temperature, plastic);
        let to = elastic_strain(layer, strain, temperature, plastic);
        let mut stiffness = self.degradation.stiffness(layer.ply(), state.damage);
        let mut dissipated = 0.0;
        // At most two events: the matrix, then the fibres.
        while !state.damage.fibre {
            let loading = PlyLoading {
                held: apply(&stiffness, from),
                applied: apply(&stiffness, [0, 1, 2].map(|i| to[i] - from[i])),
            };
            let assessment = if state.damage.matrix {
                fibre_assessment(layer.ply(), &loading)?
            } else {
                self.criterion.assess(layer.ply(), &loading)?
            };
            if !assessment.fails() {
                break;
            }
            let share = assessment.reserve_factor;
            from = [0, 1, 2].map(|i| from[i] + share * (to[i] - from[i]));
            state.damage = state.damage.with(assessment.mode);
            let softened = self.degradation.stiffness(layer.ply(), state.damage);
            // Damage never stiffens; only rounding could make this negative.
            dissipated += (energy(&stiffness, from) - energy(&softened, from)).max(0.0);
            stiffness = softened;
        }
        state.stress = apply(&stiffness, to);
        Ok(LayerResponse {
            state,
            elastic_strain: to,
            tangent: stiffness,
            dissipated,
        })
    }
}

impl PointModel for PlyDiscount {
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
        let layer =
            |index: usize, layer: &Layer| self.layer(index, layer, committed, strain, temperature);
        Ok(by_layers(
            &self.laminate,
            committed,
            strain,
            temperature,
            layer,
        )?)
    }

    fn weakened_stiffness(&self, state: &PointState, part: f64) -> Option<PlaneStiffness> {
        let degradation = self.degradation.weakened(part);
        let mut sum = [[0.0; 3]; 3];
        for (layer, own) in self.laminate.layers().iter().zip(&state.layers) {
            let fraction = layer.ply().thickness() / self.laminate.thickness();
            let stiffness = degradation.stiffness(layer.ply(), own.damage);
            let stiffness = layer.laminate_stiffness(&stiffness);
            for (total, term) in sum.iter_mut().flatten().zip(stiffness.iter().flatten()) {
                *total += fraction * term;
            }
        }
        Some(sum)
    }
}

/// Parameters of [`PlyDiscount`], in files `ply_discount = { criterion = "max_stress", fibre = 0.01, matrix = 0.1 }`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "RawPlyDiscount", into = "RawPlyDiscount")]
pub struct PlyDiscountParameters {
    criterion: Option<String>,
    degradation: Degradation,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct RawPlyDiscount {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    criterion: Option<String>,
    fibre: f64,
    matrix: f64,
}

impl PlyDiscountParameters {
    /// Makes parameters of what failed plies keep, and of the name of a failure criterion, or `None` for the caller's.
    pub fn new(criterion: Option<String>, degradation: Degradation) -> Self {
        Self {
            criterion,
            degradation,
        }
    }
}

impl TryFrom<RawPlyDiscount> for PlyDiscountParameters {
    type Error = ProgressiveError;

    fn try_from(raw: RawPlyDiscount) -> Result<Self, ProgressiveError> {
        let degradation = Degradation::new(raw.fibre, raw.matrix)?;
        Ok(Self::new(raw.criterion, degradation))
    }
}

impl From<PlyDiscountParameters> for RawPlyDiscount {
    fn from(parameters: PlyDiscountParameters) -> Self {
        Self {
            criterion: parameters.criterion,
            fibre: parameters.degradation.fibre(),
            matrix: parameters.degradation.matrix(),
        }
    }
}

#[typetag::serde(name = "ply_discount")]
impl PointModelParameters for PlyDiscountParameters {
    fn criterion(&self) -> Option<&str> {
        self.criterion.as_deref()
    }

    fn degradation(&self) -> Option<Degradation> {
        Some(self.degradation)
    }

    fn model(
        &self,
        laminate: Laminate,
        criterion: &Arc<dyn FailureCriterion>,
    ) -> Result<Arc<dyn PointModel>, ProgressiveError> {
        let criterion = Box::new(Arc::clone(criterion));
        let model = PlyDiscount::new(laminate, criterion, self.degradation)?;
        Ok(Arc::new(model))
    }

    fn describe(&self, criterion: &str, _stress: &dyn Fn(f64) -> String) -> String {
        format!(
            "ply discount by {criterion}, failed plies keep {} (fibre) and {} (matrix)",
            self.degradation.fibre(),
            self.degradation.matrix()
        )
    }
}

inventory::submit! {
    PointModelInfo {
        name: "ply_discount",
        summary: "plies lose stiffness at once when their failure criterion is met",
        parameters: &[
            ParameterInfo::text("criterion", "the criterion by which plies fail").or("the first criterion"),
            ParameterInfo::number(
                "fibre",
                "factor on E1 after fibre failure, from 1e-9 to 1; on E2 and G12 the smaller of both",
            ),
            ParameterInfo::number("matrix", "factor on E2 and G12 after failure of the matrix, from 1e-9 to 1"),
        ],
    }
}
