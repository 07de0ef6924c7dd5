//! Elastic constants of a scene.

use stickslip_fem_core::material::{
    self, Isotropic, MaterialError, Orthotropic, OrthotropicConstants, PlaneState,
};

/// Constants of a material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Material {
    /// The same in all directions.
    Isotropic {
        /// Young's modulus `[MPa]`.
        young: f64,
        /// Poisson's ratio.
        poisson: f64,
        /// Coefficient of thermal expansion `[1/K]`.
        expansion: f64,
    },
    /// Three planes of symmetry.
    Orthotropic {
        /// In-plane constants `[MPa]`.
        constants: OrthotropicConstants,
        /// Direction of the 1-axis `[rad]`.
        angle: f64,
        /// Coefficients of thermal expansion along 1 and 2 `[1/K]`.
        expansion: [f64; 2],
        /// What plane strain needs beside.
        out_of_plane: Option<OutOfPlane>,
    },
}

pub use stickslip_fem_core::material::OutOfPlane;

impl Material {
    /// The material as elements see it. Orthotropic constants for plane strain that are not there are taken as an error of the
    /// modulus e3.
    ///
    /// # Errors
    /// [`MaterialError`] for constants that no stable material has.
    pub fn in_plane(
        &self,
        plane: PlaneState,
    ) -> Result<Box<dyn material::Material>, MaterialError> {
        match *self {
            Self::Isotropic {
                young,
                poisson,
                expansion,
            } => Ok(Box::new(
                Isotropic::new(young, poisson, plane)?.with_expansion(expansion)?,
            )),
            Self::Orthotropic {
                constants,
                angle,
                expansion: [first, second],
                out_of_plane,
            } => {
                let made = match (plane, out_of_plane) {
                    (PlaneState::Stress, _) => Orthotropic::new(constants, angle)?,
                    (PlaneState::Strain, Some(other)) => {
                        Orthotropic::plane_strain(constants, other, angle)?
                    }
                    (PlaneState::Strain, None) => {
                        return Err(MaterialError::Modulus {
                            name: "e3",
                            value: f64::NAN,
                        });
                    }
                };
                Ok(Box::new(made.with_expansion(first, second)?))
            }
        }
    }

    /// Direction of the 1-axis from +x `[rad]`; 0 for isotropic materials.
    pub fn angle(&self) -> f64 {
        match self {
            Self::Isotropic { .. } => 0.0,
            Self::Orthotropic { angle, .. } => *angle,
        }
    }

    /// Whether any coefficient of thermal expansion differs from zero.
    pub fn expands(&self) -> bool {
        match self {
            Self::Isotropic { expansion, .. } => *expansion != 0.0,
            Self::Orthotropic { expansion, .. } => expansion.iter().any(|value| *value != 0.0),
        }
    }
}
