//! Orthotropic elasticity with the 1 axis at the angle φ from x. In material axes
//!
//! ```text
//! plane stress   S = [1/E₁ −ν₁₂/E₁ 0; −ν₁₂/E₁ 1/E₂ 0; 0 0 1/G₁₂]
//! plane strain   Sᵢⱼ − Sᵢ₃ Sⱼ₃ / S₃₃ for i, j = 1, 2, with Sᵢ₃ = −νᵢ₃/Eᵢ, S₃₃ = 1/E₃
//!                σ₃ = −(S₁₃ σ₁ + S₂₃ σ₂ + α₃ ΔT) / S₃₃
//! ```
//!
//! Source: Jones, *Mechanics of Composite Materials* (1999), chapter 2.

use super::{
    Material, MaterialError, PlaneStiffness, finite, inverse, modulus, rotated_compliance,
    rotated_stiffness, rotated_strain,
};

/// In-plane constants of an orthotropic material, for example a unidirectional ply with 1 along the fibres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrthotropicConstants {
    /// Young's modulus along 1 `[stress]`.
    pub e1: f64,
    /// Young's modulus along 2 `[stress]`.
    pub e2: f64,
    /// Shear modulus in the 1–2 plane `[stress]`.
    pub g12: f64,
    /// Poisson's ratio −ε₂/ε₁ for stress along 1 `[1]`.
    pub nu12: f64,
}

/// What plane strain needs beyond [`OrthotropicConstants`]; the 3 axis is normal to the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfPlane {
    /// Young's modulus along 3 `[stress]`.
    pub e3: f64,
    /// Poisson's ratio −ε₃/ε₁ for stress along 1 `[1]`.
    pub nu13: f64,
    /// Poisson's ratio −ε₃/ε₂ for stress along 2 `[1]`.
    pub nu23: f64,
    /// Coefficient of thermal expansion along 3 `[1/temperature]`.
    pub alpha3: f64,
}

/// Orthotropic material at an angle, in plane stress or plane strain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orthotropic {
    constants: OrthotropicConstants,
    angle: f64,
    stiffness: PlaneStiffness,
    compliance: PlaneStiffness,
    /// Effective expansion along 1 and 2 per unit of (α₁, α₂, α₃): αᵢ + `out_of_plane[i]`, zero in plane stress.
    out_of_plane: [f64; 2],
    /// Effective (α_xx, α_yy, α_xy) in x, y, engineering shear `[1/temperature]`.
    expansion: [f64; 3],
    thickness: Thickness,
}

/// σ₃ = `per_stress` · (σ_xx, σ_yy, τ_xy) + `per_degree` ΔT; zero in plane stress.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Thickness {
    per_stress: [f64; 3],
    /// `[stress/temperature]`.
    per_degree: f64,
}

impl Thickness {
    /// From σ₃ / σ₁ and σ₃ / σ₂ in axes at `angle`. Along n = (c, s) the normal stress is c² σ_xx + s² σ_yy + 2sc τ_xy.
    fn new([from1, from2]: [f64; 2], per_degree: f64, angle: f64) -> Self {
        let (s, c) = angle.sin_cos();
        Self {
            per_stress: [
                from1 * c * c + from2 * s * s,
                from1 * s * s + from2 * c * c,
                2.0 * s * c * (from1 - from2),
            ],
            per_degree,
        }
    }
}

impl Orthotropic {
    /// Material in plane stress with the 1 axis at `angle` `[rad]`, counter-clockwise from x; no thermal expansion.
    ///
    /// # Errors
    /// [`MaterialError::Modulus`] unless E₁, E₂ and G₁₂ are positive and finite,
    /// [`MaterialError::OrthotropicPoisson`] unless ν₁₂² < E₁/E₂, [`MaterialError::NotFinite`] unless the angle is finite.
    pub fn new(constants: OrthotropicConstants, angle: f64) -> Result<Self, MaterialError> {
        check_in_plane(&constants, angle)?;
        Ok(Self::from_normal_compliance(
            constants,
            angle,
            normal_compliance(&constants),
            [0.0; 2],
        ))
    }

    /// Material in plane strain with the 1 axis at `angle` `[rad]`, counter-clockwise from x; no thermal expansion along 1
    /// and 2.
    ///
    /// # Errors
    /// As [`Orthotropic::new`], and likewise for E₃, ν₁₃ and ν₂₃; [`MaterialError::OrthotropicIndefinite`] if the three
    /// Poisson's ratios contradict each other.
    pub fn plane_strain(
        constants: OrthotropicConstants,
        out_of_plane: OutOfPlane,
        angle: f64,
    ) -> Result<Self, MaterialError> {
        check_in_plane(&constants, angle)?;
        check_out_of_plane(&constants, &out_of_plane)?;
        let OutOfPlane {
            e3,
            nu13,
            nu23,
            alpha3,
        } = out_of_plane;
        let s3 = [-nu13 / constants.e1, -nu23 / constants.e2];
        let [[s11, s12], [_, s22]] = normal_compliance(&constants);
        let s11 = s11 - s3[0] * s3[0] * e3;
        let s12 = s12 - s3[0] * s3[1] * e3;
        let s22 = s22 - s3[1] * s3[1] * e3;
        let expansion = s3.map(|s| -s * e3 * alpha3);
        let material =
            Self::from_normal_compliance(constants, angle, [[s11, s12], [s12, s22]], expansion);
        Ok(Self {
            thickness: Thickness::new(s3.map(|s| -s * e3), -e3 * alpha3, angle),
            ..material.expanding(0.0, 0.0)
        })
    }

    /// The same material with the coefficients of thermal expansion `alpha1` and `alpha2` `[1/temperature]` along 1 and 2.
    ///
    /// # Errors
    /// [`MaterialError::NotFinite`] unless both are finite.
    pub fn with_expansion(self, alpha1: f64, alpha2: f64) -> Result<Self, MaterialError> {
        finite("alpha1", alpha1)?;
        finite("alpha2", alpha2)?;
        Ok(self.expanding(alpha1, alpha2))
    }

    /// In-plane constants in material axes.
    pub fn constants(&self) -> OrthotropicConstants {
        self.constants
    }

    /// Angle of the 1 axis `[rad]`, counter-clockwise from x.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    fn expanding(self, alpha1: f64, alpha2: f64) -> Self {
        let [extra1, extra2] = self.out_of_plane;
        let in_material_axes = [alpha1 + extra1, alpha2 + extra2, 0.0];
        Self {
            expansion: rotated_strain(in_material_axes, x_axis(self.angle)),
            ..self
        }
    }

    fn from_normal_compliance(
        constants: OrthotropicConstants,
        angle: f64,
        [[s11, s12], [_, s22]]: [[f64; 2]; 2],
        out_of_plane: [f64; 2],
    ) -> Self {
        let local = [
            [s11, s12, 0.0],
            [s12, s22, 0.0],
            [0.0, 0.0, 1.0 / constants.g12],
        ];
        let axis = x_axis(angle);
        Self {
            constants,
            angle,
            stiffness: rotated_stiffness(&inverse(&local), axis),
            compliance: rotated_compliance(&local, axis),
            out_of_plane,
            expansion: [0.0; 3],
            thickness: Thickness::default(),
        }
    }
}

impl Material for Orthotropic {
    fn stiffness(&self) -> PlaneStiffness {
        self.stiffness
    }

    fn compliance(&self) -> PlaneStiffness {
        self.compliance
    }

    fn thermal_strain(&self, dt: f64) -> [f64; 3] {
        self.expansion.map(|alpha| alpha * dt)
    }

    fn thickness_stress(&self, [xx, yy, xy]: [f64; 3], dt: f64) -> f64 {
        let Thickness {
            per_stress: [from_xx, from_yy, from_xy],
            per_degree,
        } = self.thickness;
        from_xx * xx + from_yy * yy + from_xy * xy + per_degree * dt
    }
}

/// Direction of x in axes turned by `angle`.
fn x_axis(angle: f64) -> [f64; 2] {
    [angle.cos(), -angle.sin()]
}

fn normal_compliance(constants: &OrthotropicConstants) -> [[f64; 2]; 2] {
    let OrthotropicConstants { e1, e2, nu12, .. } = *constants;
    [[1.0 / e1, -nu12 / e1], [-nu12 / e1, 1.0 / e2]]
}

fn check_in_plane(constants: &OrthotropicConstants, angle: f64) -> Result<(), MaterialError> {
    modulus("E1", constants.e1)?;
    modulus("E2", constants.e2)?;
    modulus("G12", constants.g12)?;
    poisson("nu12", constants.nu12, constants.e1, constants.e2)?;
    finite("angle", angle)
}

fn check_out_of_plane(
    constants: &OrthotropicConstants,
    out_of_plane: &OutOfPlane,
) -> Result<(), MaterialError> {
    let OrthotropicConstants { e1, e2, nu12, .. } = *constants;
    let OutOfPlane {
        e3,
        nu13,
        nu23,
        alpha3,
    } = *out_of_plane;
    modulus("E3", e3)?;
    poisson("nu13", nu13, e1, e3)?;
    poisson("nu23", nu23, e2, e3)?;
    finite("alpha3", alpha3)?;
    let [r12, r13, r23] = [
        nu12 * (e2 / e1).sqrt(),
        nu13 * (e3 / e1).sqrt(),
        nu23 * (e3 / e2).sqrt(),
    ];
    let determinant = 1.0 - r12 * r12 - r13 * r13 - r23 * r23 - 2.0 * r12 * r13 * r23;
    if determinant > 0.0 {
        Ok(())
    } else {
        Err(MaterialError::OrthotropicIndefinite {
            nu12,
            nu13,
            nu23,
            determinant,
        })
    }
}

fn poisson(name: &'static str, value: f64, along: f64, across: f64) -> Result<(), MaterialError> {
    let limit = (along / across).sqrt();
    if value.abs() < limit {
        Ok(())
    } else {
        Err(MaterialError::OrthotropicPoisson { name, value, limit })
    }
}

#[cfg(test)]
mod tests;
