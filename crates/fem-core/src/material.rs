//! Linear elastic materials in the plane.
//!
//! ```text
//! σ = D (ε − ε₀),   ε = S σ + ε₀,   S = D⁻¹,   vectors (xx, yy, xy) with engineering shear strain
//! ```
//!
//! In plane stress D is the reduced stiffness; in plane strain ε_zz = 0 has been eliminated from the three-dimensional
//! law, so S and the initial strain ε₀ are effective in-plane quantities. The stress across the thickness then follows from
//! that of the plane, with S₃ⱼ and α₃ of the three-dimensional law,
//!
//! ```text
//! 0 = ε_zz = Σⱼ S₃ⱼ σⱼ + S₃₃ σ_zz + α₃ ΔT,   j = xx, yy, xy
//! ```
//!
//! The element kernels see a material only as the 3×3 matrix [`PlaneStiffness`]. Anything that yields one, such as a
//! laminate, is a [`Material`].

mod isotropic;
mod orthotropic;
mod tensor;

use std::fmt::Debug;

use serde::{Deserialize, Serialize};
use thiserror::Error;

pub use isotropic::Isotropic;
pub use orthotropic::{Orthotropic, OrthotropicConstants, OutOfPlane};
pub use tensor::{apply, inverse, rotated_compliance, rotated_stiffness, rotated_strain};

/// Symmetric 3×3 matrix in Voigt order (xx, yy, xy): a stiffness `[stress]` or its inverse, a compliance `[1/stress]`.
pub type PlaneStiffness = [[f64; 3]; 3];

/// What happens across the thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum PlaneState {
    /// σ_zz = σ_xz = σ_yz = 0: thin plates.
    Stress,
    /// ε_zz = ε_xz = ε_yz = 0: long prisms.
    Strain,
}

/// A linear elastic material as plane elements need it.
pub trait Material: Debug + Send + Sync {
    /// The matrix D `[stress]`, symmetric and positive definite.
    fn stiffness(&self) -> PlaneStiffness;

    /// In-plane strain (ε_xx, ε_yy, γ_xy) `[1]` that the temperature rise `dt` `[temperature]` causes where nothing resists; in
    /// plane strain the effective one, which includes what the suppressed ε_zz does through Poisson's effect.
    fn thermal_strain(&self, dt: f64) -> [f64; 3] {
        let _ = dt;
        [0.0; 3]
    }

    /// Stress σ_zz across the thickness `[stress]` at the in-plane stress `stress` (xx, yy, xy) `[stress]` and the temperature
    /// rise `dt` `[temperature]`: the one that holds ε_zz = 0 in plane strain, zero in plane stress. Linear in both arguments.
    fn thickness_stress(&self, stress: [f64; 3], dt: f64) -> f64 {
        let _ = (stress, dt);
        0.0
    }

    /// The inverse S of the stiffness `[1/stress]`.
    fn compliance(&self) -> PlaneStiffness {
        inverse(&self.stiffness())
    }

    /// Whether reflection in the x axis leaves the material unchanged, that is, whether D has no coupling of normal and
    /// shear terms (to 10⁻¹² of its largest entry).
    fn symmetric_about_x(&self) -> bool {
        let d = self.stiffness();
        let coupling = d[0][2].abs().max(d[1][2].abs());
        let largest = d.iter().flatten().fold(0.0_f64, |m, v| m.max(v.abs()));
        coupling <= 1e-12 * largest
    }
}

/// A material constant that no stable material has.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum MaterialError {
    /// A modulus that is not a positive finite number.
    #[error("{name} = {value} must be a positive, finite modulus")]
    Modulus {
        /// The constant's name.
        name: &'static str,
        /// The value given `[stress]`.
        value: f64,
    },
    /// A number that is infinite or not a number.
    #[error("{name} = {value} is not a finite number")]
    NotFinite {
        /// The constant's name.
        name: &'static str,
        /// The value given, in the unit of the constant.
        value: f64,
    },
    /// Poisson's ratio of an isotropic material outside the stable range.
    #[error(
        "Poisson's ratio {poisson} must be greater than -1 and {} 0.5 in plane {}",
        if *state == PlaneState::Strain { "less than" } else { "at most" },
        if *state == PlaneState::Strain { "strain" } else { "stress" }
    )]
    Poisson {
        /// The value given `[1]`.
        poisson: f64,
        /// The state, on which the upper bound depends.
        state: PlaneState,
    },
    /// A Poisson's ratio of an orthotropic material too large for its moduli.
    #[error(
        "{name} = {value} makes the material unstable: its magnitude must be less than {limit}"
    )]
    OrthotropicPoisson {
        /// The constant's name.
        name: &'static str,
        /// The value given `[1]`.
        value: f64,
        /// √(Eᵢ/Eⱼ) `[1]`, which bounds |νᵢⱼ|.
        limit: f64,
    },
    /// Three Poisson's ratios each admissible, but not together.
    #[error(
        "nu12 = {nu12}, nu13 = {nu13} and nu23 = {nu23} together make the compliance indefinite: \
         its scaled determinant is {determinant:.3e}, must be positive"
    )]
    OrthotropicIndefinite {
        /// Major Poisson's ratio in the 1–2 plane `[1]`.
        nu12: f64,
        /// Poisson's ratio in the 1–3 plane `[1]`.
        nu13: f64,
        /// Poisson's ratio in the 2–3 plane `[1]`.
        nu23: f64,
        /// Determinant of the normal compliance scaled to a unit diagonal `[1]`.
        determinant: f64,
    },
}

fn modulus(name: &'static str, value: f64) -> Result<(), MaterialError> {
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(MaterialError::Modulus { name, value })
    }
}

fn finite(name: &'static str, value: f64) -> Result<(), MaterialError> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(MaterialError::NotFinite { name, value })
    }
}
