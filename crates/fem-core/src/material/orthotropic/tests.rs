//! Orthotropic laws against published and three-dimensional ones.

use std::f64::consts::{FRAC_PI_2, PI};

use approx::assert_relative_eq;

use super::*;
use crate::material::{Isotropic, PlaneState, apply};

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
    let d66 = (q11 + q22 - 2.0 * q12 - 2.0 * q66) * (s * c).powi(2) + q66 * (s.powi(4) + c.powi(4));
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

#[test]
fn the_thickness_stress_is_that_of_hookes_law_in_three_dimensions() {
    // Three different directions, heated, at an angle.
    let out = OutOfPlane {
        e3: 14.0,
        nu13: 0.31,
        nu23: 0.45,
        alpha3: 30e-6,
    };
    let (alpha1, alpha2, dt, angle) = (0.1e-6, 25e-6, 80.0, 0.6_f64);
    let ply = Orthotropic::plane_strain(PLY, out, angle)
        .unwrap()
        .with_expansion(alpha1, alpha2)
        .unwrap();
    let strain = [3e-3, -1.5e-3, 2e-3];

    // Normal compliances of all three axes; its inverse times (ε₁ − α₁ ΔT, ε₂ − α₂ ΔT, −α₃ ΔT) holds σ₃.
    let (s12, s13, s23) = (-PLY.nu12 / PLY.e1, -out.nu13 / PLY.e1, -out.nu23 / PLY.e2);
    let compliance = nalgebra::Matrix3::new(
        1.0 / PLY.e1,
        s12,
        s13,
        s12,
        1.0 / PLY.e2,
        s23,
        s13,
        s23,
        1.0 / out.e3,
    );
    let [along, across, _] = rotated_strain(strain, [angle.cos(), angle.sin()]);
    let elastic =
        nalgebra::Vector3::new(along - alpha1 * dt, across - alpha2 * dt, -out.alpha3 * dt);
    let whole = compliance.lu().solve(&elastic).unwrap();

    let thermal = ply.thermal_strain(dt);
    let in_plane = apply(&ply.stiffness(), [0, 1, 2].map(|i| strain[i] - thermal[i]));
    let sigma3 = ply.thickness_stress(in_plane, dt);
    // Some ten operations on stresses of the size of `whole`.
    assert_relative_eq!(sigma3, whole[2], epsilon = 1e-13 * whole.amax());
    assert!(sigma3.abs() > 0.01 * whole.amax());
    let thin = Orthotropic::new(PLY, angle).unwrap();
    assert_eq!(thin.thickness_stress(in_plane, dt), 0.0);
}
