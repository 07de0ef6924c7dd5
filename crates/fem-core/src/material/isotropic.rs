//! Isotropic elasticity,
//!
//! ```text
//! plane stress   D = E/(1 − ν²) [1 ν 0; ν 1 0; 0 0 (1 − ν)/2]
//! plane strain   the same with E/(1 − ν²) for E and ν/(1 − ν) for ν
//! ```
//!
//! and G = E / 2(1 + ν) in both; in plane strain σ_zz = ν (σ_xx + σ_yy) − E α ΔT.

use super::{Material, MaterialError, PlaneState, PlaneStiffness, finite, modulus};

/// Isotropic material in plane stress or plane strain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isotropic {
    young: f64,
    poisson: f64,
    state: PlaneState,
    expansion: f64,
}

impl Isotropic {
    /// Material with Young's modulus `young` `[stress]` and Poisson's ratio `poisson` `[1]`, without thermal expansion.
    ///
    /// # Errors
    /// [`MaterialError::Modulus`] unless `young` is positive and finite; [`MaterialError::Poisson`] unless
    /// −1 < ν ≤ 0.5 in plane stress and −1 < ν < 0.5 in plane strain, where the incompressible limit has no D.
    pub fn new(young: f64, poisson: f64, state: PlaneState) -> Result<Self, MaterialError> {
        modulus("Young's modulus", young)?;
        let stable = match state {
            PlaneState::Stress => poisson > -1.0 && poisson <= 0.5,
            PlaneState::Strain => poisson > -1.0 && poisson < 0.5,
        };
        if stable {
            Ok(Self {
                young,
                poisson,
                state,
                expansion: 0.0,
            })
        } else {
            Err(MaterialError::Poisson { poisson, state })
        }
    }

    /// The same material with the coefficient of thermal expansion `alpha` `[1/temperature]`.
    ///
    /// # Errors
    /// [`MaterialError::NotFinite`] unless `alpha` is finite.
    pub fn with_expansion(self, alpha: f64) -> Result<Self, MaterialError> {
        finite("alpha", alpha)?;
        Ok(Self {
            expansion: alpha,
            ..self
        })
    }

    /// Young's modulus E `[stress]`.
    pub fn young(&self) -> f64 {
        self.young
    }

    /// Poisson's ratio ν `[1]`.
    pub fn poisson(&self) -> f64 {
        self.poisson
    }

    /// Shear modulus G = E / 2(1 + ν) `[stress]`.
    pub fn shear(&self) -> f64 {
        0.5 * self.young / (1.0 + self.poisson)
    }

    /// Plane stress or plane strain.
    pub fn state(&self) -> PlaneState {
        self.state
    }
}

impl Material for Isotropic {
    fn stiffness(&self) -> PlaneStiffness {
        let (e, nu) = (self.young, self.poisson);
        let (direct, cross) = match self.state {
            PlaneState::Stress => (e / (1.0 - nu * nu), nu * e / (1.0 - nu * nu)),
            PlaneState::Strain => {
                let factor = e / ((1.0 + nu) * (1.0 - 2.0 * nu));
                ((1.0 - nu) * factor, nu * factor)
            }
        };
        [
            [direct, cross, 0.0],
            [cross, direct, 0.0],
            [0.0, 0.0, self.shear()],
        ]
    }

    fn compliance(&self) -> PlaneStiffness {
        let (e, nu) = (self.young, self.poisson);
        let (direct, cross) = match self.state {
            PlaneState::Stress => (1.0 / e, -nu / e),
            PlaneState::Strain => ((1.0 - nu * nu) / e, -nu * (1.0 + nu) / e),
        };
        [
            [direct, cross, 0.0],
            [cross, direct, 0.0],
            [0.0, 0.0, 1.0 / self.shear()],
        ]
    }

    fn thermal_strain(&self, dt: f64) -> [f64; 3] {
        let in_plane = match self.state {
            PlaneState::Stress => self.expansion * dt,
            PlaneState::Strain => (1.0 + self.poisson) * self.expansion * dt,
        };
        [in_plane, in_plane, 0.0]
    }

    fn thickness_stress(&self, [xx, yy, _]: [f64; 3], dt: f64) -> f64 {
        match self.state {
            PlaneState::Stress => 0.0,
            PlaneState::Strain => self.poisson * (xx + yy) - self.young * self.expansion * dt,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::{inverse, rotated_stiffness};
    use approx::assert_relative_eq;

    #[test]
    fn plane_strain_is_the_three_dimensional_law_with_no_thickness_strain() {
        // Lamé: σ_xx = (λ + 2G) ε_xx + λ ε_yy, with λ = Eν/((1+ν)(1−2ν)).
        let (e, nu) = (70e3, 0.33);
        let material = Isotropic::new(e, nu, PlaneState::Strain).unwrap();
        let lambda = e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
        let d = material.stiffness();
        assert_relative_eq!(
            d[0][0],
            lambda + 2.0 * material.shear(),
            max_relative = 1e-14
        );
        assert_relative_eq!(d[0][1], lambda, max_relative = 1e-14);
        assert_relative_eq!(d[2][2], material.shear());
    }

    #[test]
    fn compliance_inverts_stiffness_in_both_states() {
        for state in [PlaneState::Stress, PlaneState::Strain] {
            let material = Isotropic::new(70e3, 0.3, state).unwrap();
            let (s, general) = (material.compliance(), inverse(&material.stiffness()));
            for (a, b) in s.iter().flatten().zip(general.iter().flatten()) {
                assert_relative_eq!(*a, *b, max_relative = 1e-14);
            }
        }
    }

    #[test]
    fn rotation_changes_nothing() {
        let d = Isotropic::new(70e3, 0.3, PlaneState::Strain)
            .unwrap()
            .stiffness();
        let turned = rotated_stiffness(&d, [0.6, 0.8]);
        for (a, b) in d.iter().flatten().zip(turned.iter().flatten()) {
            assert_relative_eq!(*a, *b, epsilon = 1e-14 * d[0][0]);
        }
    }

    #[test]
    fn expansion_in_plane_strain_includes_the_suppressed_thickness() {
        // With σ_xx = σ_yy = 0 and ε_zz = 0: σ_zz = −E α ΔT, so ε_xx = α ΔT + ν α ΔT.
        let material = Isotropic::new(200e3, 0.25, PlaneState::Strain)
            .unwrap()
            .with_expansion(1e-5)
            .unwrap();
        assert_relative_eq!(
            material.thermal_strain(100.0)[0],
            1.25e-3,
            max_relative = 1e-15
        );
    }

    #[test]
    fn no_thickness_strain_is_left_in_plane_strain() {
        let material = Isotropic::new(200e3, 0.25, PlaneState::Strain)
            .unwrap()
            .with_expansion(1e-5)
            .unwrap();
        let stress = [120.0, -40.0, 30.0];
        // 0.25 · 80 − 200 000 · 10⁻⁵ · 10
        assert_eq!(material.thickness_stress(stress, 10.0), 20.0 - 20.0);
        assert_eq!(material.thickness_stress(stress, 0.0), 20.0);
        let thin = Isotropic::new(200e3, 0.25, PlaneState::Stress).unwrap();
        assert_eq!(thin.thickness_stress(stress, 10.0), 0.0);
    }

    #[test]
    fn the_poisson_range_depends_on_the_state() {
        use PlaneState::{Strain, Stress};
        assert!(Isotropic::new(1.0, 0.5, Stress).is_ok());
        for (poisson, state) in [
            (0.5, Strain),
            (0.51, Stress),
            (-1.0, Stress),
            (f64::NAN, Strain),
        ] {
            let error = Isotropic::new(1.0, poisson, state).unwrap_err();
            assert!(matches!(error, MaterialError::Poisson { .. }), "{error}");
        }
        for young in [0.0, -1.0, f64::INFINITY, f64::NAN] {
            let error = Isotropic::new(young, 0.3, Stress).unwrap_err();
            assert!(matches!(error, MaterialError::Modulus { .. }), "{error}");
        }
        let error = Isotropic::new(1.0, 0.5, Strain).unwrap_err().to_string();
        assert!(error.contains("less than 0.5 in plane strain"), "{error}");
    }
}
