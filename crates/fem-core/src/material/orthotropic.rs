//! Orthotropic elasticity with the 1 axis at the angle φ from x. In material axes
//!
//! ```text
//! plane stress   S = [1/E₁ −ν₁₂/E₁ 0; −ν₁₂/E₁ 1/E₂ 0; 0 0 1/G₁₂]
//! plane strain   Sᵢⱼ − Sᵢ₃ Sⱼ₃ / S₃₃ for i, j = 1, 2, with Sᵢ₃ = −νᵢ₃/Eᵢ, S₃₃ = 1/E₃
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
    /// Poisson's ratio −ε₂/ε₁ for stress along 1.
    pub nu12: f64,
}

/// What plane strain needs beyond [`OrthotropicConstants`]; the 3 axis is normal to the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfPlane {
    /// Young's modulus along 3 `[stress]`.
    pub e3: f64,
    /// Poisson's ratio −ε₃/ε₁ for stress along 1.
    pub nu13: f64,
    /// Poisson's ratio −ε₃/ε₂ for stress along 2.
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
        Ok(material.expanding(0.0, 0.0))
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
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use approx::assert_relative_eq;

    use super::*;
    use crate::material::{Isotropic, PlaneState};

    /// T300/5208, Tsai and Hahn, *Introduction to Composite Materials* (1980) [GPa].
    const PLY: OrthotropicConstants = OrthotropicConstants {
        e1: 181.0,
        e2: 10.3,
        g12: 7.17,
        nu12: 0.28,
    };

    fn assert_close(a: &PlaneStiffness, b: &PlaneStiffness, relative: f64) {
        let size = b.iter().flatten().fold(0.0_f64, |m, v| m.max(v.abs()));
        for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
            assert_relative_eq!(*a, *b, epsilon = relative * size);
        }
    }

    #[test]
    fn stiffness_at_45_degrees_is_the_published_one() {
        // Tsai and Hahn (1980) give Q11 = Q22 = 56.66, Q12 = 42.32, Q66 = 46.59, Q16 = Q26 = 42.87 GPa for +45°.
        let d = Orthotropic::new(PLY, PI / 4.0).unwrap().stiffness();
        let published = [
            [56.66, 42.32, 42.87],
            [42.32, 56.66, 42.87],
            [42.87, 42.87, 46.59],
        ];
        for (a, b) in d.iter().flatten().zip(published.iter().flatten()) {
            assert_relative_eq!(*a, *b, epsilon = 0.005 * 1.01);
        }
    }

    #[test]
    fn rotation_follows_the_explicit_formulas() {
        let angle = 0.7_f64;
        let (c, s) = (angle.cos(), angle.sin());
        let q = Orthotropic::new(PLY, 0.0).unwrap().stiffness();
        let (q11, q22, q12, q66) = (q[0][0], q[1][1], q[0][1], q[2][2]);
        let d11 = q11 * c.powi(4) + 2.0 * (q12 + 2.0 * q66) * (s * c).powi(2) + q22 * s.powi(4);
        let d12 = (q11 + q22 - 4.0 * q66) * (s * c).powi(2) + q12 * (s.powi(4) + c.powi(4));
        let d22 = q11 * s.powi(4) + 2.0 * (q12 + 2.0 * q66) * (s * c).powi(2) + q22 * c.powi(4);
        let d16 = (q11 - q12 - 2.0 * q66) * s * c.powi(3) + (q12 - q22 + 2.0 * q66) * s.powi(3) * c;
        let d26 = (q11 - q12 - 2.0 * q66) * s.powi(3) * c + (q12 - q22 + 2.0 * q66) * s * c.powi(3);
        let d66 =
            (q11 + q22 - 2.0 * q12 - 2.0 * q66) * (s * c).powi(2) + q66 * (s.powi(4) + c.powi(4));
        let explicit = [[d11, d12, d16], [d12, d22, d26], [d16, d26, d66]];
        let material = Orthotropic::new(PLY, angle).unwrap();
        assert_close(&material.stiffness(), &explicit, 1e-14);
        assert_close(&material.compliance(), &inverse(&explicit), 1e-13);
    }

    #[test]
    fn equal_constants_give_the_isotropic_law() {
        let (e, nu, alpha) = (70.0, 0.3, 2e-5);
        let constants = OrthotropicConstants {
            e1: e,
            e2: e,
            g12: 0.5 * e / (1.0 + nu),
            nu12: nu,
        };
        let out = OutOfPlane {
            e3: e,
            nu13: nu,
            nu23: nu,
            alpha3: alpha,
        };
        let stress = Orthotropic::new(constants, 0.4).unwrap();
        let strain = Orthotropic::plane_strain(constants, out, 0.4).unwrap();
        for (orthotropic, state) in [(stress, PlaneState::Stress), (strain, PlaneState::Strain)] {
            let isotropic = Isotropic::new(e, nu, state)
                .unwrap()
                .with_expansion(alpha)
                .unwrap();
            let orthotropic = orthotropic.with_expansion(alpha, alpha).unwrap();
            assert_close(&orthotropic.stiffness(), &isotropic.stiffness(), 1e-14);
            assert_close(&orthotropic.compliance(), &isotropic.compliance(), 1e-14);
            for (a, b) in orthotropic
                .thermal_strain(50.0)
                .iter()
                .zip(isotropic.thermal_strain(50.0))
            {
                assert_relative_eq!(*a, b, epsilon = 1e-16);
            }
        }
    }

    #[test]
    fn a_quarter_turn_exchanges_the_axes_and_keeps_symmetry() {
        let across = Orthotropic::new(PLY, FRAC_PI_2)
            .unwrap()
            .with_expansion(1e-6, 3e-5)
            .unwrap();
        let along = Orthotropic::new(PLY, 0.0).unwrap();
        assert_relative_eq!(
            across.stiffness()[0][0],
            along.stiffness()[1][1],
            max_relative = 1e-14
        );
        assert_relative_eq!(across.thermal_strain(1.0)[0], 3e-5, max_relative = 1e-14);
        assert!(across.symmetric_about_x() && along.symmetric_about_x());
        assert!(!Orthotropic::new(PLY, 0.1).unwrap().symmetric_about_x());
    }

    #[test]
    fn expansion_rotates_as_a_strain() {
        // Expansion along fibres at +45° only: ε_xx = ε_yy = α/2, γ_xy = α.
        let ply = Orthotropic::new(PLY, PI / 4.0)
            .unwrap()
            .with_expansion(2e-6, 0.0)
            .unwrap();
        let [xx, yy, xy] = ply.thermal_strain(1.0);
        assert_relative_eq!(xx, 1e-6, max_relative = 1e-14);
        assert_relative_eq!(yy, 1e-6, max_relative = 1e-14);
        assert_relative_eq!(xy, 2e-6, max_relative = 1e-14);
    }

    #[test]
    fn unstable_constants_are_refused_with_their_numbers() {
        let too_large = OrthotropicConstants { nu12: 4.2, ..PLY };
        let error = Orthotropic::new(too_large, 0.0).unwrap_err();
        // √(181/10.3) = 4.1920
        assert!(
            matches!(error, MaterialError::OrthotropicPoisson { limit, .. } if (limit - 4.1920).abs() < 1e-4)
        );
        assert!(Orthotropic::new(OrthotropicConstants { nu12: 4.19, ..PLY }, 0.0).is_ok());
        for bad in [
            OrthotropicConstants { e1: -1.0, ..PLY },
            OrthotropicConstants {
                e2: f64::NAN,
                ..PLY
            },
            OrthotropicConstants { g12: 0.0, ..PLY },
        ] {
            let error = Orthotropic::new(bad, 0.0).unwrap_err();
            assert!(matches!(error, MaterialError::Modulus { .. }), "{error}");
        }
        assert!(matches!(
            Orthotropic::new(PLY, f64::NAN),
            Err(MaterialError::NotFinite { .. })
        ));
        let cube = OrthotropicConstants {
            e1: 1.0,
            e2: 1.0,
            g12: 1.0,
            nu12: 0.6,
        };
        let out = OutOfPlane {
            e3: 1.0,
            nu13: 0.6,
            nu23: 0.6,
            alpha3: 0.0,
        };
        let error = Orthotropic::plane_strain(cube, out, 0.0).unwrap_err();
        assert!(
            matches!(error, MaterialError::OrthotropicIndefinite { .. }),
            "{error}"
        );
    }
}
