//! What a point remembers, and what a step returns.

use stickslip_fem_core::material::{PlaneStiffness, apply};

use crate::degradation::Damage;
use crate::laminate::{Laminate, Layer};

/// History of one layer at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LayerState {
    /// Stress (σ₁, σ₂, τ₁₂) in material axes `[stress]`.
    pub stress: [f64; 3],
    /// Plastic strain (ε₁, ε₂, γ₁₂) in material axes, dimensionless.
    pub plastic_strain: [f64; 3],
    /// Hardening variable λ `[stress]`: for perfect plasticity the plastic work per volume.
    pub hardening: f64,
    /// What has failed.
    pub damage: Damage,
}

/// History of a point of the laminate.
#[derive(Clone, Debug, PartialEq)]
pub struct PointState {
    /// Total strain (xx, yy, xy), engineering shear, dimensionless.
    pub strain: [f64; 3],
    /// Temperature rise `[temperature]`.
    pub temperature: f64,
    /// The layers, from the bottom up.
    pub layers: Vec<LayerState>,
    /// Stored elastic energy per volume `[stress]`, the mean over the thickness.
    pub stored: f64,
    /// Energy per volume dissipated so far `[stress]`, the mean over the thickness; it never falls.
    pub dissipated: f64,
}

impl PointState {
    pub(super) fn initial(layers: usize) -> Self {
        Self {
            strain: [0.0; 3],
            temperature: 0.0,
            layers: vec![LayerState::default(); layers],
            stored: 0.0,
            dissipated: 0.0,
        }
    }
}

/// What a step returns.
#[derive(Clone, Debug, PartialEq)]
pub struct PointResponse {
    /// Mean stress N/h (xx, yy, xy) `[stress]`.
    pub stress: [f64; 3],
    /// Its derivative in the strain `[stress]`, consistent with the step; symmetric.
    pub tangent: PlaneStiffness,
    /// State at the end of the step, if it is accepted.
    pub trial: PointState,
}

/// The committed state of a point, which changes only by [`commit`](Self::commit).
#[derive(Clone, Debug, PartialEq)]
pub struct PointHistory {
    committed: PointState,
}

impl PointHistory {
    /// Begins a history with `state`.
    pub fn new(state: PointState) -> Self {
        Self { committed: state }
    }

    /// The state of the last accepted step.
    pub fn committed(&self) -> &PointState {
        &self.committed
    }

    /// Accepts the step that returned `trial`.
    pub fn commit(&mut self, trial: PointState) {
        self.committed = trial;
    }
}

/// One layer's share in a step, in material axes.
pub(super) struct LayerResponse {
    pub state: LayerState,
    /// Strain that the stress belongs to.
    pub elastic_strain: [f64; 3],
    pub tangent: PlaneStiffness,
    /// Energy per volume that the step dissipates in this layer `[stress]`.
    pub dissipated: f64,
}

/// The response of `laminate` in a step from `committed`: means over the thickness of what `respond` says of the layers by index.
pub(super) fn by_layers<E>(
    laminate: &Laminate,
    committed: &PointState,
    strain: [f64; 3],
    temperature: f64,
    respond: impl Fn(usize, &Layer) -> Result<LayerResponse, E>,
) -> Result<PointResponse, E> {
    let mut sum = PointResponse {
        stress: [0.0; 3],
        tangent: [[0.0; 3]; 3],
        trial: PointState {
            strain,
            temperature,
            layers: Vec::with_capacity(laminate.layers().len()),
            stored: 0.0,
            dissipated: committed.dissipated,
        },
    };
    for (index, layer) in laminate.layers().iter().enumerate() {
        let share = respond(index, layer)?;
        let fraction = layer.ply().thickness() / laminate.thickness();
        let stress = layer.laminate_stress(share.state.stress);
        let tangent = layer.laminate_stiffness(&share.tangent);
        for i in 0..3 {
            sum.stress[i] += fraction * stress[i];
            sum.trial.stored += 0.5 * fraction * share.state.stress[i] * share.elastic_strain[i];
            for j in 0..3 {
                sum.tangent[i][j] += fraction * tangent[i][j];
            }
        }
        sum.trial.dissipated += fraction * share.dissipated;
        sum.trial.layers.push(share.state);
    }
    Ok(sum)
}

/// Strain of a layer in material axes less its thermal and plastic parts.
pub(super) fn elastic_strain(
    layer: &Layer,
    strain: [f64; 3],
    temperature: f64,
    plastic: [f64; 3],
) -> [f64; 3] {
    let total = layer.material_strain(strain);
    let free = layer.ply().expansion();
    [0, 1, 2].map(|i| total[i] - free[i] * temperature - plastic[i])
}

/// ½ ε · Q ε.
pub(super) fn energy(stiffness: &PlaneStiffness, strain: [f64; 3]) -> f64 {
    let stress = apply(stiffness, strain);
    0.5 * (stress[0] * strain[0] + stress[1] * strain[1] + stress[2] * strain[2])
}
