//! What a load does to a laminate: deformation of its mid-plane, then strain and stress of each ply in material axes.
//!
//! ```text
//! (ε⁰, κ) = [A B; B D]⁻¹ ((N, M) + (N^T, M^T)),    σ_k(z) = Q (T_k (ε⁰ + z κ) − α ΔT)
//! ```
//!
//! T_k turns a strain into the axes of ply k. Without N and M this is the residual stress after a temperature change from the
//! state free of stress, usually the cure: ΔT is then negative.

use stickslip_fem_core::material::apply;

use super::{Laminate, Layer};

/// Resultants on the edges of a laminate, and its temperature rise since it was free of stress.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LaminateLoad {
    /// (N_x, N_y, N_xy) `[force/length]`.
    pub force: [f64; 3],
    /// (M_x, M_y, M_xy) `[force]`.
    pub moment: [f64; 3],
    /// ΔT `[temperature]`.
    pub temperature: f64,
}

impl LaminateLoad {
    /// Makes a load of the in-plane forces (N_x, N_y, N_xy) `[force/length]` alone.
    pub fn membrane(force: [f64; 3]) -> Self {
        Self {
            force,
            ..Self::default()
        }
    }

    /// Checks whether every number is finite.
    pub fn is_finite(&self) -> bool {
        let resultants = self.force.iter().chain(&self.moment);
        resultants
            .chain([&self.temperature])
            .all(|value| value.is_finite())
    }
}

/// Deformation of the mid-plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deformation {
    /// ε⁰ (xx, yy, xy), engineering shear, dimensionless.
    pub strain: [f64; 3],
    /// κ (xx, yy, xy), engineering twist `[1/length]`.
    pub curvature: [f64; 3],
}

impl Deformation {
    /// Makes a deformation of the strain (xx, yy, xy), engineering shear, dimensionless, alone: a plate that stays flat.
    pub fn membrane(strain: [f64; 3]) -> Self {
        Self {
            strain,
            curvature: [0.0; 3],
        }
    }

    /// Computes the strain ε⁰ + zκ (xx, yy, xy), dimensionless, at the height `z` `[length]`.
    pub fn strain_at(&self, z: f64) -> [f64; 3] {
        [0, 1, 2].map(|i| self.strain[i] + z * self.curvature[i])
    }
}

/// Place in a layer's thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Position {
    /// Its lower face, towards −z.
    Bottom,
    /// Half-way.
    Middle,
    /// Its upper face.
    Top,
}

impl Position {
    /// From the bottom up.
    pub const ALL: [Self; 3] = [Self::Bottom, Self::Middle, Self::Top];

    /// Computes the height `[length]` of this place in `layer`, from the mid-plane of the laminate.
    pub fn height(self, layer: &Layer) -> f64 {
        match self {
            Self::Bottom => layer.bottom,
            Self::Middle => 0.5 * (layer.bottom + layer.top),
            Self::Top => layer.top,
        }
    }
}

/// Strain and stress at a place in a layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlyState {
    /// Index of the layer, from the bottom, from 0.
    pub layer: usize,
    /// Angle of its fibres `[degree]`.
    pub angle: f64,
    /// Where in its thickness.
    pub position: Position,
    /// Height of that place `[length]`.
    pub height: f64,
    /// Total strain (ε₁, ε₂, γ₁₂) in material axes, thermal strain included, dimensionless.
    pub strain: [f64; 3],
    /// Stress (σ₁, σ₂, τ₁₂) in material axes `[stress]`.
    pub stress: [f64; 3],
}

impl Laminate {
    /// Computes (N^T, M^T) `[force/length]`, `[force]` of the temperature rise `temperature` `[temperature]`: what holds the laminate undeformed, with
    /// the opposite sign.
    pub fn thermal_resultants(&self, temperature: f64) -> ([f64; 3], [f64; 3]) {
        let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
        for layer in &self.layers {
            let [first, second, _] = layer.moments();
            let stress = apply(
                &layer.stiffness,
                layer.expansion.map(|alpha| alpha * temperature),
            );
            for i in 0..3 {
                force[i] += stress[i] * first;
                moment[i] += stress[i] * second;
            }
        }
        (force, moment)
    }

    /// Computes the deformation (ε⁰, κ) = [A B; B D]⁻¹ ((N, M) + (N^T, M^T)) under `load`.
    pub fn deformation(&self, load: &LaminateLoad) -> Deformation {
        let (thermal_force, thermal_moment) = self.thermal_resultants(load.temperature);
        let force = [0, 1, 2].map(|i| load.force[i] + thermal_force[i]);
        let moment = [0, 1, 2].map(|i| load.moment[i] + thermal_moment[i]);
        let s = &self.compliance;
        let transposed = std::array::from_fn(|i| std::array::from_fn(|j| s.coupling[j][i]));
        Deformation {
            strain: added(apply(&s.membrane, force), apply(&s.coupling, moment)),
            curvature: added(apply(&transposed, force), apply(&s.bending, moment)),
        }
    }

    /// Computes (N, M) `[force/length]`, `[force]` that give `deformation` at the temperature rise `temperature`.
    pub fn resultants(&self, deformation: &Deformation, temperature: f64) -> ([f64; 3], [f64; 3]) {
        let (thermal_force, thermal_moment) = self.thermal_resultants(temperature);
        let Deformation { strain, curvature } = *deformation;
        let s = &self.stiffness;
        let force = added(apply(&s.membrane, strain), apply(&s.coupling, curvature));
        let moment = added(apply(&s.coupling, strain), apply(&s.bending, curvature));
        (
            [0, 1, 2].map(|i| force[i] - thermal_force[i]),
            [0, 1, 2].map(|i| moment[i] - thermal_moment[i]),
        )
    }

    /// Computes strain and stress `[stress]` of every layer at its lower face, middle and upper face, from the bottom up, at the temperature
    /// rise `temperature` `[temperature]`: σ = Q (T (ε⁰ + z κ) − α ΔT).
    pub fn ply_states(&self, deformation: &Deformation, temperature: f64) -> Vec<PlyState> {
        let state = |index: usize, layer: &Layer, position: Position| {
            let height = position.height(layer);
            let strain = deformation.strain_at(height);
            PlyState {
                layer: index,
                angle: layer.angle,
                position,
                height,
                strain: layer.material_strain(strain),
                stress: layer.stress(strain, temperature),
            }
        };
        let layers = self.layers.iter().enumerate();
        layers
            .flat_map(|(index, layer)| Position::ALL.map(|position| state(index, layer, position)))
            .collect()
    }

    /// Computes the residual stresses of the unloaded laminate after the temperature rise `temperature` `[temperature]`, as [`Laminate::ply_states`].
    pub fn residual_states(&self, temperature: f64) -> Vec<PlyState> {
        let free = LaminateLoad {
            temperature,
            ..LaminateLoad::default()
        };
        self.ply_states(&self.deformation(&free), temperature)
    }
}

fn added(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] + b[i])
}
