//! Classical lamination theory of a thin plate.
//!
//! ```text
//! (N, M) + (N^T, M^T) = [A B; B D] (ε⁰, κ),     ε(z) = ε⁰ + z κ
//!
//! A = Σ_k Q̄_k (z_k − z_{k−1}),   B = ½ Σ_k Q̄_k (z_k² − z_{k−1}²),   D = ⅓ Σ_k Q̄_k (z_k³ − z_{k−1}³)
//! (N^T, M^T) = ΔT Σ_k Q̄_k ᾱ_k (z_k − z_{k−1}, ½ (z_k² − z_{k−1}²))
//! ```
//!
//! | symbol  | meaning                                            | shape | dimension        |
//! |---------|----------------------------------------------------|-------|------------------|
//! | `N`, `M`| forces and moments per length of edge              | 3     | `[force/length]`, `[force]` |
//! | `ε⁰`, `κ`| strain and curvature of the mid-plane             | 3     | –, `[1/length]`  |
//! | `A`, `B`, `D` | membrane, coupling and bending stiffness     | 3×3   | `[force/length]`, `[force]`, `[force length]` |
//! | `Q̄_k`, `ᾱ_k` | stiffness and expansion of ply k in x, y      | 3×3, 3| `[stress]`, `[1/temperature]` |
//!
//! Vectors are (xx, yy, xy) with engineering shear, and κ_xy is the engineering twist. z grows from the bottom ply, −h/2, to the
//! top ply, h/2.
//!
//! Source: Jones, *Mechanics of Composite Materials* (1999), chapter 4.
//!
//! # Example
//!
//! The report of Post & Reddy (1988) gives its quasi-isotropic laminate E = 7.72·10⁶ psi, G = 2.97·10⁶ psi and ν = 0.30. A ply
//! with 19 585, 1 500 and 847 ksi and ν₁₂ = 0.28 has them:
//!
//! ```
//! use stickslip_laminate::{Curvature, Laminate, Layup, Ply, PlyConstants, Strengths};
//!
//! let constants = PlyConstants {
//!     e1: 19_585.0, e2: 1_500.0, g12: 847.0, nu12: 0.28, alpha1: 0.0, alpha2: 0.0, thickness: 0.005,
//! };
//! let ply = Ply::new("back-calculated", constants, Strengths::default())?;
//! let layup: Layup = "[0_2/60_2/-60_2]s".parse()?;
//! let moduli = Laminate::new(&layup, &ply)?.membrane_moduli(Curvature::Suppressed);
//! assert!((moduli.ex - 7_720.0).abs() < 0.5 && (moduli.gxy - 2_969.0).abs() < 0.5);
//! assert!((moduli.nuxy - 0.30).abs() < 1e-4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A textbook ply does not: T300/5208 (Tsai & Hahn 1980: 181, 10.3 and 7.17 GPa, ν₁₂ = 0.28) in the same lay-up has E = 69.7 GPa,
//! which is 10.1·10⁶ psi. The report's plate was softer by a quarter than that material at its usual fibre fraction.

mod build;
mod coupling;
mod coverage;
mod membrane;
mod response;

use std::sync::Arc;

use nalgebra::{Cholesky, SMatrix};
use stickslip_fem_core::material::{PlaneStiffness, apply, rotated_stiffness, rotated_strain};
use thiserror::Error;

pub use coupling::Coupling;
pub use membrane::{Curvature, EffectiveModuli, LaminateMembrane};
pub use response::{Deformation, LaminateLoad, PlyState, Position};

use crate::ply::Ply;

/// A stack of plies that is no laminate, or unsuitable for the requested use.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum LaminateError {
    /// No plies.
    #[error("a laminate needs at least one ply")]
    Empty,
    /// A fibre angle that is not a finite number.
    #[error("layer {} (ply '{ply}'): angle = {angle} is not a finite number of degrees", .layer + 1)]
    Angle {
        /// Index of the layer, from the bottom, from 0; messages count from 1.
        layer: usize,
        /// Name of the ply.
        ply: String,
        /// The value given `[degree]`.
        angle: f64,
    },
    /// A lay-up that names a ply which is not given.
    #[error("layer {} names ply '{ply}', which is not among: {}", .layer + 1, .known.join(", "))]
    UnknownPly {
        /// Index of the layer, from the bottom, from 0; messages count from 1.
        layer: usize,
        /// The name in the lay-up.
        ply: String,
        /// Names of the plies given.
        known: Vec<String>,
    },
    /// Moduli and thicknesses so large or so different that the stiffness has no inverse in floating point.
    #[error(
        "the laminate's stiffness cannot be inverted: its plies' moduli or thicknesses overflow or differ too much"
    )]
    NotInvertible,
    /// A membrane analysis of a laminate that bends when it is stretched.
    #[error(
        "the lay-up is not symmetric: stretching bends it, with a coupling of {coupling:.3} (0 none, 1 complete), and a membrane \
         analysis overstates its stiffness by up to {:.1} %; make the lay-up symmetric, or say that the plate is held flat",
        100.0 * (1.0 / (1.0 - .coupling * .coupling) - 1.0)
    )]
    BendingExtension {
        /// [`Coupling::bending_extension`], dimensionless.
        coupling: f64,
    },
    /// A damage record for another number of layers.
    #[error("{given} layers of damage for a laminate of {layers}")]
    LayerCount {
        /// Layers of the laminate.
        layers: usize,
        /// Layers given.
        given: usize,
    },
}

/// One ply in its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    ply: Arc<Ply>,
    angle: f64,
    /// Fibre direction, a unit vector.
    axis: [f64; 2],
    bottom: f64,
    top: f64,
    /// Stiffness in material axes, of the damaged ply where there is damage.
    local: PlaneStiffness,
    stiffness: PlaneStiffness,
    expansion: [f64; 3],
}

impl Layer {
    /// The ply.
    pub fn ply(&self) -> &Ply {
        &self.ply
    }

    /// The angle of the fibres `[degree]`, counter-clockwise from x.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// The heights z of the lower and the upper face `[length]`, from the mid-plane.
    pub fn faces(&self) -> [f64; 2] {
        [self.bottom, self.top]
    }

    /// The stiffness Q̄ (3×3, `[stress]`) in the laminate's axes.
    pub fn stiffness(&self) -> &PlaneStiffness {
        &self.stiffness
    }

    /// The expansion ᾱ (xx, yy, xy) in the laminate's axes `[1/temperature]`, engineering shear.
    pub fn expansion(&self) -> [f64; 3] {
        self.expansion
    }

    /// Turns the strain (xx, yy, xy) in the laminate's axes into (11, 22, 12) in material axes, engineering shear in both, dimensionless.
    pub fn material_strain(&self, strain: [f64; 3]) -> [f64; 3] {
        rotated_strain(strain, self.axis)
    }

    /// Turns the stress (11, 22, 12) `[stress]` in material axes into (xx, yy, xy) `[stress]` in the laminate's axes.
    pub fn laminate_stress(&self, stress: [f64; 3]) -> [f64; 3] {
        let [c, s] = self.axis;
        let [s1, s2, t] = stress;
        [
            c * c * s1 + s * s * s2 - 2.0 * s * c * t,
            s * s * s1 + c * c * s2 + 2.0 * s * c * t,
            s * c * (s1 - s2) + (c * c - s * s) * t,
        ]
    }

    /// A stiffness `[stress]` given in material axes, in the laminate's axes.
    pub(crate) fn laminate_stiffness(&self, local: &PlaneStiffness) -> PlaneStiffness {
        rotated_stiffness(local, [self.axis[0], -self.axis[1]])
    }

    /// Computes the stress (σ₁, σ₂, τ₁₂) `[stress]` in material axes, for the strain `strain` (dimensionless) in the laminate's axes and the temperature rise
    /// `temperature` `[temperature]` since the ply was free of stress.
    pub fn stress(&self, strain: [f64; 3], temperature: f64) -> [f64; 3] {
        let total = self.material_strain(strain);
        let free = self.ply.expansion();
        apply(
            &self.local,
            [0, 1, 2].map(|i| total[i] - free[i] * temperature),
        )
    }
}

/// A, B and D of a laminate, or the blocks of their inverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlateMatrix {
    /// A `[force/length]`; of the inverse: ε⁰ per N `[length/force]`.
    pub membrane: PlaneStiffness,
    /// B `[force]`; of the inverse: ε⁰ per M `[1/force]`, whose transpose is κ per N.
    pub coupling: PlaneStiffness,
    /// D `[force length]`; of the inverse: κ per M `[1/(force length)]`.
    pub bending: PlaneStiffness,
}

/// A checked laminate.
#[derive(Clone, Debug, PartialEq)]
pub struct Laminate {
    layers: Vec<Layer>,
    thickness: f64,
    stiffness: PlateMatrix,
    compliance: PlateMatrix,
}

impl Laminate {
    /// The layers, from the bottom up; never empty.
    pub fn layers(&self) -> &[Layer] {
        &self.layers
    }

    /// The thickness h `[length]`.
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// A `[force/length]`, B `[force]` and D `[force length]`, 3×3 each.
    pub fn stiffness(&self) -> &PlateMatrix {
        &self.stiffness
    }

    /// The inverse of [A B; B D] in blocks, with the units of [`PlateMatrix`].
    pub fn compliance(&self) -> &PlateMatrix {
        &self.compliance
    }
}

impl PlateMatrix {
    fn sum(layers: &[Layer]) -> Self {
        let mut sum = Self {
            membrane: [[0.0; 3]; 3],
            coupling: [[0.0; 3]; 3],
            bending: [[0.0; 3]; 3],
        };
        for layer in layers {
            let [first, second, third] = layer.moments();
            for (i, row) in layer.stiffness.iter().enumerate() {
                for (j, q) in row.iter().enumerate() {
                    sum.membrane[i][j] += q * first;
                    sum.coupling[i][j] += q * second;
                    sum.bending[i][j] += q * third;
                }
            }
        }
        sum
    }

    /// The inverse, `None` where it is not finite.
    fn inverse(&self) -> Option<Self> {
        let full = SMatrix::<f64, 6, 6>::from_fn(|i, j| match (i / 3, j / 3) {
            (0, 0) => self.membrane[i][j],
            (1, 1) => self.bending[i - 3][j - 3],
            _ => self.coupling[i % 3][j % 3],
        });
        // A, B and D differ by powers of the thickness: scale to a unit diagonal.
        let scale = full.diagonal().map(|d| 1.0 / d.sqrt());
        let scaled = SMatrix::<f64, 6, 6>::from_fn(|i, j| full[(i, j)] * scale[i] * scale[j]);
        let inverse = Cholesky::new(scaled)?.inverse();
        let entry =
            |i: usize, j: usize| 0.5 * (inverse[(i, j)] + inverse[(j, i)]) * scale[i] * scale[j];
        let block = |row: usize, column: usize| {
            std::array::from_fn(|i| std::array::from_fn(|j| entry(row + i, column + j)))
        };
        let result = Self {
            membrane: block(0, 0),
            coupling: block(0, 3),
            bending: block(3, 3),
        };
        result.is_finite().then_some(result)
    }

    fn is_finite(&self) -> bool {
        let blocks = [&self.membrane, &self.coupling, &self.bending];
        blocks
            .iter()
            .all(|block| block.iter().flatten().all(|value| value.is_finite()))
    }
}
