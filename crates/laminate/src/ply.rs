//! A ply: one layer of aligned fibres, orthotropic and in plane stress. In its material axes
//!
//! ```text
//! ε = S σ + α ΔT,   S = [1/E₁ −ν₁₂/E₁ 0; −ν₁₂/E₁ 1/E₂ 0; 0 0 1/G₁₂],   Q = S⁻¹,   α = (α₁, α₂, 0)
//! ```
//!
//! with vectors (11, 22, 12) and engineering shear strain; 1 is along the fibres.
//!
//! Source: Jones, *Mechanics of Composite Materials* (1999), chapter 2.

use stickslip_fem_core::material::{
    Material, MaterialError, Orthotropic, OrthotropicConstants, PlaneStiffness,
};
use thiserror::Error;

use crate::strengths::{Strength, Strengths};

/// Elastic and thermal constants of a ply and its thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlyConstants {
    /// Young's modulus along the fibres `[stress]`.
    pub e1: f64,
    /// Young's modulus across the fibres `[stress]`.
    pub e2: f64,
    /// Shear modulus in the plane of the ply `[stress]`.
    pub g12: f64,
    /// Major Poisson's ratio −ε₂/ε₁ for stress along 1, dimensionless.
    pub nu12: f64,
    /// Thermal expansion along the fibres `[1/temperature]`.
    pub alpha1: f64,
    /// Thermal expansion across the fibres `[1/temperature]`.
    pub alpha2: f64,
    /// Thickness `[length]`.
    pub thickness: f64,
}

/// A ply that no laminate can be made of.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum PlyError {
    /// A modulus, Poisson's ratio or expansion that no stable material has.
    #[error("ply '{ply}': {cause}")]
    Constant {
        /// Name of the ply.
        ply: String,
        /// Which constant, and its value.
        #[source]
        cause: MaterialError,
    },
    /// A thickness that is not a positive finite number.
    #[error("ply '{ply}': thickness = {thickness} must be positive and finite")]
    Thickness {
        /// Name of the ply.
        ply: String,
        /// The value given `[length]`.
        thickness: f64,
    },
    /// A strength that is not a positive finite number.
    #[error(
        "ply '{ply}': {strength} = {value} ({}) must be positive and finite; strengths are magnitudes, in compression too",
        .strength.meaning()
    )]
    Strength {
        /// Name of the ply.
        ply: String,
        /// Which strength.
        strength: Strength,
        /// The value given, `[stress]` or a strain limit.
        value: f64,
    },
}

/// A checked ply, by name.
#[derive(Clone, Debug, PartialEq)]
pub struct Ply {
    name: String,
    constants: PlyConstants,
    strengths: Strengths,
    stiffness: PlaneStiffness,
    compliance: PlaneStiffness,
}

impl Ply {
    /// Checks a ply called `name` with the given constants and strengths, and computes its stiffness; Jones (1999), chapter 2.
    ///
    /// # Errors
    /// [`PlyError::Constant`] unless E₁, E₂, G₁₂ are positive, ν₁₂² < E₁/E₂ and the expansions finite,
    /// [`PlyError::Thickness`] unless the thickness is positive, [`PlyError::Strength`] unless each strength given is.
    pub fn new(
        name: impl Into<String>,
        constants: PlyConstants,
        strengths: Strengths,
    ) -> Result<Self, PlyError> {
        let name = name.into();
        let elastic = match elastic_material(&constants) {
            Ok(elastic) => elastic,
            Err(cause) => return Err(PlyError::Constant { ply: name, cause }),
        };
        let positive = |value: f64| value.is_finite() && value > 0.0;
        if !positive(constants.thickness) {
            return Err(PlyError::Thickness {
                ply: name,
                thickness: constants.thickness,
            });
        }
        for strength in Strength::ALL {
            if let Some(value) = strengths.get(strength).filter(|&value| !positive(value)) {
                return Err(PlyError::Strength {
                    ply: name,
                    strength,
                    value,
                });
            }
        }
        Ok(Self {
            name,
            constants,
            strengths,
            stiffness: elastic.stiffness(),
            compliance: elastic.compliance(),
        })
    }

    /// The name of the ply.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The constants and the thickness as given.
    pub fn constants(&self) -> &PlyConstants {
        &self.constants
    }

    /// The strengths as given.
    pub fn strengths(&self) -> &Strengths {
        &self.strengths
    }

    /// The same ply with strengths that were checked in another one.
    pub(crate) fn with_strengths(&self, strengths: Strengths) -> Self {
        Self {
            strengths,
            ..self.clone()
        }
    }

    /// The reduced stiffness Q (3×3, `[stress]`) in material axes.
    pub fn stiffness(&self) -> &PlaneStiffness {
        &self.stiffness
    }

    /// The compliance S (3×3, `[1/stress]`) in material axes.
    pub fn compliance(&self) -> &PlaneStiffness {
        &self.compliance
    }

    /// The thickness `[length]`.
    pub fn thickness(&self) -> f64 {
        self.constants.thickness
    }

    /// The expansion (α₁, α₂, 0) in material axes `[1/temperature]`.
    pub fn expansion(&self) -> [f64; 3] {
        [self.constants.alpha1, self.constants.alpha2, 0.0]
    }
}

fn elastic_material(constants: &PlyConstants) -> Result<Orthotropic, MaterialError> {
    let &PlyConstants {
        e1,
        e2,
        g12,
        nu12,
        alpha1,
        alpha2,
        ..
    } = constants;
    let in_plane = OrthotropicConstants { e1, e2, g12, nu12 };
    Orthotropic::new(in_plane, 0.0)?.with_expansion(alpha1, alpha2)
}
