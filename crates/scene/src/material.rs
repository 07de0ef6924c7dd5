//! Elastic constants of a scene.

use std::sync::Arc;

use stickslip_fem_core::material::{
    self, Isotropic, Material as _, MaterialError, Orthotropic, OrthotropicConstants, PlaneState,
};
use stickslip_friction::PlyFraction;
use stickslip_laminate::{Laminate, LaminateMembrane};

/// Constants of a material.
#[derive(Debug, Clone, PartialEq)]
pub enum Material {
    /// The same in all directions.
    Isotropic {
        /// Young's modulus `[MPa]`.
        young: f64,
        /// Poisson's ratio `[1]`.
        poisson: f64,
        /// Coefficient of thermal expansion `[1/K]`.
        expansion: f64,
        /// Von Mises stress at which it yields `[MPa]`, where it is known. The material stays elastic beyond.
        yield_stress: Option<f64>,
    },
    /// Three planes of symmetry.
    Orthotropic {
        /// In-plane constants: moduli `[MPa]` and Poisson's ratio `[1]`.
        constants: OrthotropicConstants,
        /// Direction of the 1-axis, counter-clockwise from +x `[rad]`.
        angle: f64,
        /// Coefficients of thermal expansion along 1 and 2 `[1/K]`.
        expansion: [f64; 2],
        /// What plane strain needs beside.
        out_of_plane: Option<OutOfPlane>,
    },
    /// A stack of plies, in plane stress.
    Laminate(Arc<LaminateSheet>),
}

/// A laminate as a scene uses it: in its plane.
#[derive(Debug, Clone, PartialEq)]
pub struct LaminateSheet {
    /// The lay-up as the scene has it.
    pub layup: String,
    /// The laminate in the scene's axes: its angles are from +x, those of the lay-up plus [`angle`](Self::angle).
    pub laminate: Laminate,
    /// Its membrane stiffness and expansion.
    pub membrane: LaminateMembrane,
    /// Direction of the lay-up's 0° from +x `[rad]`.
    pub angle: f64,
    /// Temperature since the plies were free of stress `[K]`, usually negative.
    pub cure: f64,
}

pub use stickslip_fem_core::material::OutOfPlane;

impl LaminateSheet {
    /// Fraction of the thickness per fibre angle from the lay-up's 0°, as the fibre-coverage law takes them.
    pub fn ply_fractions(&self) -> Vec<PlyFraction> {
        let mut fractions = self.laminate.ply_fractions();
        for fraction in &mut fractions {
            fraction.angle -= self.angle;
        }
        fractions
    }
}

impl Material {
    /// The material as elements see it. Orthotropic constants for plane strain that are not there are taken as an error of the
    /// modulus e3. A laminate is in plane stress whatever `plane` says; the scene's reader refuses plane strain.
    ///
    /// # Errors
    /// [`MaterialError`] for constants that no stable material has.
    pub fn in_plane(
        &self,
        plane: PlaneState,
    ) -> Result<Box<dyn material::Material>, MaterialError> {
        match *self {
            Self::Laminate(ref sheet) => Ok(Box::new(sheet.membrane)),
            Self::Isotropic {
                young,
                poisson,
                expansion,
                yield_stress: _,
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

    /// The laminate, if it is one.
    pub fn laminate(&self) -> Option<&Arc<LaminateSheet>> {
        match self {
            Self::Laminate(sheet) => Some(sheet),
            Self::Isotropic { .. } | Self::Orthotropic { .. } => None,
        }
    }

    /// Von Mises stress at which it yields `[MPa]`, where it is known.
    pub fn yield_stress(&self) -> Option<f64> {
        match self {
            Self::Isotropic { yield_stress, .. } => *yield_stress,
            Self::Orthotropic { .. } | Self::Laminate(_) => None,
        }
    }

    /// Direction of the 1-axis or of the lay-up's 0° from +x `[rad]`; 0 for isotropic materials.
    pub fn angle(&self) -> f64 {
        match self {
            Self::Laminate(sheet) => sheet.angle,
            Self::Isotropic { .. } => 0.0,
            Self::Orthotropic { angle, .. } => *angle,
        }
    }

    /// Whether any coefficient of thermal expansion differs from zero.
    pub fn expands(&self) -> bool {
        match self {
            Self::Laminate(sheet) => sheet.membrane.thermal_strain(1.0) != [0.0; 3],
            Self::Isotropic { expansion, .. } => *expansion != 0.0,
            Self::Orthotropic { expansion, .. } => expansion.iter().any(|value| *value != 0.0),
        }
    }
}
