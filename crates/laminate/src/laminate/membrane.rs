//! The laminate as a homogeneous plate: effective moduli, and a material for plane elements.
//!
//! ```text
//! membrane   S = h A⁻¹          held flat (κ = 0)         or h a, a the membrane block of the inverse, free to bend (M = 0)
//! bending    S = (h³/12) D⁻¹    mid-plane unstrained      or (h³/12) d, free to stretch (N = 0)
//!
//! E_x = 1/S₁₁,  E_y = 1/S₂₂,  G_xy = 1/S₆₆,  ν_xy = −S₁₂/S₁₁,  ν_yx = −S₁₂/S₂₂,  η_xy,x = S₁₆/S₁₁,  η_xy,y = S₂₆/S₂₂
//! ```
//!
//! For a symmetric lay-up the two columns agree. Source: Jones (1999), sections 2.6 and 4.3.

use stickslip_fem_core::material::{Material, PlaneStiffness, apply, inverse};

use super::{Coupling, Laminate, LaminateError};

/// What the laminate may do besides the deformation that is asked for. Both agree for a symmetric lay-up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curvature {
    /// The other deformation is held at zero: a stretched plate stays flat, a bent one keeps its mid-plane unstrained.
    Suppressed,
    /// The other resultant is zero: a stretched plate bends, a bent one stretches.
    Free,
}

/// Moduli of the homogeneous plate with the same stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EffectiveModuli {
    /// Young's modulus along x `[stress]`.
    pub ex: f64,
    /// Young's modulus along y `[stress]`.
    pub ey: f64,
    /// Shear modulus `[stress]`.
    pub gxy: f64,
    /// Poisson's ratio −ε_y/ε_x for stress along x, dimensionless.
    pub nuxy: f64,
    /// Poisson's ratio −ε_x/ε_y for stress along y, dimensionless.
    pub nuyx: f64,
    /// γ_xy/ε_x for stress along x, dimensionless, zero for a balanced lay-up.
    pub eta_xy_x: f64,
    /// γ_xy/ε_y for stress along y, dimensionless, zero for a balanced lay-up.
    pub eta_xy_y: f64,
}

impl EffectiveModuli {
    fn of_compliance(s: &PlaneStiffness) -> Self {
        Self {
            ex: 1.0 / s[0][0],
            ey: 1.0 / s[1][1],
            gxy: 1.0 / s[2][2],
            nuxy: -s[0][1] / s[0][0],
            nuyx: -s[0][1] / s[1][1],
            eta_xy_x: s[0][2] / s[0][0],
            eta_xy_y: s[1][2] / s[1][1],
        }
    }
}

impl Laminate {
    /// Computes the effective moduli `[stress]` of the laminate in its plane, of the compliance S = h A⁻¹ (flat) or h a (free to bend);
    /// Jones (1999), 4.3.
    pub fn membrane_moduli(&self, curvature: Curvature) -> EffectiveModuli {
        let compliance = match curvature {
            Curvature::Suppressed => inverse(&self.stiffness.membrane),
            Curvature::Free => self.compliance.membrane,
        };
        EffectiveModuli::of_compliance(&scaled(&compliance, self.thickness))
    }

    /// Computes the effective moduli `[stress]` of the laminate in bending, S = (h³/12) D⁻¹ or (h³/12) d: those of the homogeneous plate of the same thickness and bending stiffness.
    pub fn bending_moduli(&self, curvature: Curvature) -> EffectiveModuli {
        let compliance = match curvature {
            Curvature::Suppressed => inverse(&self.stiffness.bending),
            Curvature::Free => self.compliance.bending,
        };
        EffectiveModuli::of_compliance(&scaled(&compliance, self.thickness.powi(3) / 12.0))
    }

    /// Makes the laminate a material for plane elements, exact because it does not bend when stretched.
    ///
    /// # Errors
    /// [`LaminateError::BendingExtension`] with the size of the coupling unless [`Coupling::is_symmetric`].
    pub fn membrane_material(&self) -> Result<LaminateMembrane, LaminateError> {
        let material = self.flat_membrane_material();
        if material.coupling.is_symmetric() {
            Ok(material)
        } else {
            Err(LaminateError::BendingExtension {
                coupling: material.coupling.bending_extension,
            })
        }
    }

    /// Makes the laminate a material for plane elements, whatever its coupling: exact where the plate is held flat. Where it is
    /// free to bend, its stiffness is overstated; [`LaminateMembrane::coupling`] says by how much.
    pub fn flat_membrane_material(&self) -> LaminateMembrane {
        let expansion = apply(
            &inverse(&self.stiffness.membrane),
            self.thermal_resultants(1.0).0,
        );
        LaminateMembrane {
            stiffness: scaled(&self.stiffness.membrane, 1.0 / self.thickness),
            expansion,
            coupling: self.coupling(),
        }
    }
}

/// A laminate as plane elements see it: the mean stiffness A/h over the thickness, and the expansion A⁻¹ N^T per ΔT.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LaminateMembrane {
    stiffness: PlaneStiffness,
    expansion: [f64; 3],
    coupling: Coupling,
}

impl LaminateMembrane {
    /// The couplings of the laminate, dimensionless, of which this material keeps only that of stretching with shear.
    pub fn coupling(&self) -> Coupling {
        self.coupling
    }
}

impl Material for LaminateMembrane {
    fn stiffness(&self) -> PlaneStiffness {
        self.stiffness
    }

    fn thermal_strain(&self, dt: f64) -> [f64; 3] {
        self.expansion.map(|alpha| alpha * dt)
    }
}

fn scaled(matrix: &PlaneStiffness, factor: f64) -> PlaneStiffness {
    matrix.map(|row| row.map(|value| value * factor))
}
