//! Classical lamination theory: closed forms and invariants.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use proptest::prelude::*;
use std::sync::Arc;
use stickslip_fem_core::material::{Material, rotated_stiffness, rotated_strain};
use stickslip_friction::{Coulomb, FibreCoverage, Kernel, Place};
use stickslip_laminate::laminate::Position;
use stickslip_laminate::{Curvature, Deformation, Laminate, LaminateError, LaminateLoad};

use crate::{assert_matrix, assert_vector, constants, laminate, ply};

fn of_angles(angles: &[f64]) -> Laminate {
    let ply = Arc::new(ply());
    Laminate::from_layers(angles.iter().map(|&angle| (Arc::clone(&ply), angle))).unwrap()
}

#[test]
fn single_ply_has_its_own_moduli_stretched_and_bent() {
    let single = laminate("[0]");
    let given = constants();
    for moduli in [
        single.membrane_moduli(Curvature::Free),
        single.bending_moduli(Curvature::Free),
        single.bending_moduli(Curvature::Suppressed),
    ] {
        assert_relative_eq!(moduli.ex, given.e1, max_relative = 1e-13);
        assert_relative_eq!(moduli.ey, given.e2, max_relative = 1e-13);
        assert_relative_eq!(moduli.gxy, given.g12, max_relative = 1e-13);
        assert_relative_eq!(moduli.nuxy, given.nu12, max_relative = 1e-13);
        assert_eq!([moduli.eta_xy_x, moduli.eta_xy_y], [0.0; 2]);
    }
}

#[test]
fn cross_ply_coupling_in_closed_form() {
    // 0 below, 90 above, each h/2: B₁₁ = (Q₂₂ − Q₁₁) h²/8 = −B₂₂, all else 0; A₁₁ = (Q₁₁ + Q₂₂) h/2, D = A h²/12.
    let cross = laminate("[0/90]");
    let q = *ply().stiffness();
    let h = cross.thickness();
    let b = (q[1][1] - q[0][0]) * h * h / 8.0;
    assert_matrix(
        &cross.stiffness().coupling,
        &[[b, 0.0, 0.0], [0.0, -b, 0.0], [0.0; 3]],
        1e-14,
    );
    let a = cross.stiffness().membrane;
    assert_matrix(
        &cross.stiffness().bending,
        &a.map(|row| row.map(|v| v * h * h / 12.0)),
        1e-14,
    );
    // A⁻¹ B D⁻¹ B = (12/h²) (A⁻¹ B)²; A⁻¹ B swaps (1, ±1) and (1, ∓1), and (A⁻¹B)² = b²/((a₁₁ − a₁₂)(a₁₁ + a₁₂)) I.
    let squared = 12.0 / (h * h) * b * b / (a[0][0] * a[0][0] - a[0][1] * a[0][1]);
    let coupling = cross.coupling();
    assert_relative_eq!(coupling.stiffness_loss(), squared, max_relative = 1e-12);
    assert!(!coupling.is_symmetric());
    let Err(LaminateError::BendingExtension { coupling: size }) = cross.membrane_material() else {
        panic!("an unsymmetric laminate was taken for a membrane");
    };
    assert_eq!(size, coupling.bending_extension);
    let flat = cross.flat_membrane_material();
    assert_eq!(flat.coupling(), coupling);
    assert_matrix(&flat.stiffness(), &a.map(|row| row.map(|v| v / h)), 1e-15);
    // Free to bend it is softer, by no more than the coupling says.
    let [held, free] =
        [Curvature::Suppressed, Curvature::Free].map(|c| cross.membrane_moduli(c).ex);
    assert!(free < held && free >= (1.0 - squared) * held * (1.0 - 1e-12));
}

#[test]
fn couplings_with_shear_and_twist_in_closed_form() {
    let q = *ply().stiffness();
    // At 45°: Q̄₁₆ = Q̄₂₆ = (Q₁₁ − Q₂₂)/4, Q̄₁₁ = (Q₁₁ + Q₂₂ + 2 Q₁₂ + 4 Q₆₆)/4, Q̄₆₆ = (Q₁₁ + Q₂₂ − 2 Q₁₂)/4.
    let sum = q[0][0] + q[1][1];
    let square = (sum + 2.0 * q[0][1] + 4.0 * q[2][2]) * (sum - 2.0 * q[0][1]);
    let expected = (q[0][0] - q[1][1]) / square.sqrt();
    let single = laminate("[45]").coupling();
    assert_relative_eq!(single.extension_shear, expected, max_relative = 1e-13);
    assert_relative_eq!(single.bending_twisting, expected, max_relative = 1e-13);
    // Exchanging x and y exchanges the two candidates for the largest.
    let [a, b] = ["[30]", "[60]"].map(|layup| laminate(layup).coupling().extension_shear);
    assert_relative_eq!(a, b, max_relative = 1e-13);
    // Balanced and symmetric: no shear, but twist. Antisymmetric: the other way round, and it twists when stretched.
    let symmetric = laminate("[±45]s").coupling();
    assert!(symmetric.extension_shear < 1e-15 && symmetric.bending_twisting > 0.3 * expected);
    let antisymmetric = laminate("[±45]").coupling();
    assert!(antisymmetric.bending_twisting < 1e-15 && antisymmetric.bending_extension > 0.3);
}

#[test]
fn residual_stress_of_a_cross_ply_in_closed_form() {
    let cross = laminate("[0/90]s");
    let q = *ply().stiffness();
    let given = constants();
    let dt = -250.0;
    // Equal shares of 0 and 90: isotropic expansion α with (Q₁₁ + 2 Q₁₂ + Q₂₂) α = (Q₁₁ + Q₁₂) α₁ + (Q₁₂ + Q₂₂) α₂.
    let alpha = ((q[0][0] + q[0][1]) * given.alpha1 + (q[0][1] + q[1][1]) * given.alpha2)
        / (q[0][0] + 2.0 * q[0][1] + q[1][1]);
    let material = cross.membrane_material().unwrap();
    assert_vector(
        &material.thermal_strain(dt),
        &[alpha * dt, alpha * dt, 0.0],
        1e-13,
    );
    let s1 = (q[0][0] * (alpha - given.alpha1) + q[0][1] * (alpha - given.alpha2)) * dt;
    for state in cross.residual_states(dt) {
        assert_vector(&state.stress, &[s1, -s1, 0.0], 1e-12);
    }
    // Cooling puts the matrix in tension.
    assert!(s1 < 0.0);
}

#[test]
fn ply_fractions_feed_the_fibre_coverage_law() {
    let plies = laminate("[0_2/60_2/-60_2]s").ply_fractions();
    assert_vector(
        &plies.iter().map(|ply| ply.fraction).collect::<Vec<_>>(),
        &[1.0 / 3.0; 3],
        1e-14,
    );
    let angles: Vec<f64> = plies.iter().map(|ply| ply.angle.to_degrees()).collect();
    assert_vector(&angles, &[0.0, 60.0, -60.0], 1e-14);
    // Fibres have no head and tail: 120° is −60°, −90° is 90°.
    let folded = of_angles(&[120.0, -60.0, -90.0, 90.0, 270.0]).ply_fractions();
    let shares: Vec<_> = folded
        .iter()
        .map(|ply| (ply.angle.to_degrees().round(), (5.0 * ply.fraction).round()))
        .collect();
    assert_eq!(shares, [(-60.0, 2.0), (90.0, 3.0)]);
    let law = |mu| Box::new(Coulomb::new(mu).unwrap());
    let kernel = Kernel::Swept { kappa: 0.5 };
    let by_hand = FibreCoverage::new(plies, 0.6, kernel, law(0.15), law(0.35)).unwrap();
    let of_layup = laminate("[0_2/60_2/-60_2]s")
        .fibre_coverage(0.6, kernel, law(0.15), law(0.35))
        .unwrap();
    // Fibres are tangent to a hole at θ = 30° and 90°, and the coverage is largest there.
    let coverage = |law: &FibreCoverage, theta: f64| {
        let (sine, cosine) = theta.to_radians().sin_cos();
        let place = Place {
            position: [cosine, sine],
            tangent: [-sine, cosine],
            material_angle: 0.0,
        };
        law.coverage(&place)
    };
    for theta in [0.0, 13.0, 30.0, 60.0, 90.0] {
        assert_eq!(coverage(&of_layup, theta), coverage(&by_hand, theta));
    }
    assert_relative_eq!(
        coverage(&of_layup, 30.0),
        coverage(&of_layup, 90.0),
        max_relative = 1e-14
    );
    assert!(coverage(&of_layup, 30.0) > 1.03 * coverage(&of_layup, 0.0));
    assert!(
        laminate("[0]")
            .fibre_coverage(0.95, kernel, law(0.15), law(0.35))
            .is_err()
    );
}

#[test]
fn stress_along_the_thickness_of_a_bent_ply() {
    let single = laminate("[0]");
    let curvature = [0.2, 0.0, 0.0];
    let bent = Deformation {
        strain: [0.0; 3],
        curvature,
    };
    let states = single.ply_states(&bent, 0.0);
    let q11 = ply().stiffness()[0][0];
    for (state, z) in states.iter().zip([-0.0025, 0.0, 0.0025]) {
        assert_abs_diff_eq!(state.height, z, epsilon = 1e-18);
        assert_abs_diff_eq!(state.stress[0], q11 * 0.2 * z, epsilon = 1e-12);
    }
    assert_eq!(
        states
            .iter()
            .map(|state| state.position)
            .collect::<Vec<_>>(),
        Position::ALL
    );
}

fn angle_lists() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-90.0..90.0_f64, 1..8)
}

proptest! {
    #[test]
    fn stiffness_turns_with_the_plies(angles in angle_lists(), turn in -180.0..180.0_f64) {
        let original = of_angles(&angles);
        let turned = of_angles(&angles.iter().map(|angle| angle + turn).collect::<Vec<_>>());
        let (sine, cosine) = turn.to_radians().sin_cos();
        let rotate = |m| rotated_stiffness(m, [cosine, -sine]);
        let (a, b) = (original.stiffness(), turned.stiffness());
        assert_matrix(&b.membrane, &rotate(&a.membrane), 1e-12);
        assert_matrix(&b.bending, &rotate(&a.bending), 1e-12);
        let size = a.membrane[0][0].max(a.membrane[1][1]) * original.thickness();
        for (x, y) in b.coupling.iter().flatten().zip(rotate(&a.coupling).iter().flatten()) {
            prop_assert!((x - y).abs() < 1e-12 * size);
        }
        let (c, d) = (original.coupling().bending_extension, turned.coupling().bending_extension);
        prop_assert!((c - d).abs() < 1e-7 && c < 1.0);
        // So does the deformation under a load: compare the strain along the turned axes.
        let dt = -100.0;
        let free = |laminate: &Laminate| laminate.deformation(&LaminateLoad { temperature: dt, ..LaminateLoad::default() });
        let strain = rotated_strain(free(&original).strain, [cosine, -sine]);
        for (x, y) in free(&turned).strain.iter().zip(strain) {
            prop_assert!((x - y).abs() < 1e-10 * 15e-4);
        }
    }

    #[test]
    fn symmetric_stacks_do_not_couple(half in angle_lists()) {
        let angles: Vec<f64> = half.iter().chain(half.iter().rev()).copied().collect();
        let symmetric = of_angles(&angles);
        prop_assert!(symmetric.coupling().is_symmetric());
        prop_assert!(symmetric.membrane_material().is_ok());
        let size = symmetric.stiffness().membrane[0][0] * symmetric.thickness();
        prop_assert!(symmetric.stiffness().coupling.iter().flatten().all(|b| b.abs() < 1e-14 * size));
    }

    #[test]
    fn equal_shares_at_equal_angles_are_isotropic(directions in 3..9_usize, start in -90.0..90.0_f64) {
        let angles: Vec<f64> = (0..directions).map(|k| start + 180.0 * k as f64 / directions as f64).collect();
        let laminate = of_angles(&angles);
        let a = laminate.stiffness().membrane;
        let isotropic = [
            [a[0][0], a[0][1], 0.0],
            [a[0][1], a[0][0], 0.0],
            [0.0, 0.0, 0.5 * (a[0][0] - a[0][1])],
        ];
        assert_matrix(&a, &isotropic, 1e-12);
        let expansion = laminate.flat_membrane_material().thermal_strain(1.0);
        assert_vector(&expansion, &[expansion[0], expansion[0], 0.0], 1e-12);
    }

    #[test]
    fn deformation_and_resultants_are_inverse(
        angles in angle_lists(),
        force in prop::array::uniform3(-1.0..1.0_f64),
        moment in prop::array::uniform3(-0.005..0.005_f64),
        temperature in -300.0..100.0_f64,
    ) {
        let laminate = of_angles(&angles);
        let load = LaminateLoad { force, moment, temperature };
        let (n, m) = laminate.resultants(&laminate.deformation(&load), temperature);
        // The scale of the sums is that of the thermal resultants and of the load; the condition number is below 1e3.
        let (thermal, _) = laminate.thermal_resultants(temperature);
        let scale = 1.0 + thermal.iter().fold(0.0_f64, |s, v| s.max(v.abs()));
        for i in 0..3 {
            prop_assert!((n[i] - force[i]).abs() < 1e-11 * scale);
            prop_assert!((m[i] - moment[i]).abs() < 1e-11 * scale * laminate.thickness());
        }
    }

    #[test]
    fn ply_stresses_are_in_equilibrium_with_the_load(
        angles in angle_lists(),
        force in prop::array::uniform3(-1.0..1.0_f64),
        temperature in -300.0..100.0_f64,
    ) {
        let laminate = of_angles(&angles);
        let load = LaminateLoad { temperature, ..LaminateLoad::membrane(force) };
        let states = laminate.ply_states(&laminate.deformation(&load), temperature);
        let (mut n, mut m) = ([0.0; 3], [0.0; 3]);
        for state in states {
            // Simpson's rule is exact for the product of two linear functions of z.
            let weight = if state.position == Position::Middle { 4.0 } else { 1.0 } / 6.0;
            let layer = &laminate.layers()[state.layer];
            let stress = layer.laminate_stress(state.stress);
            for i in 0..3 {
                n[i] += weight * layer.ply().thickness() * stress[i];
                m[i] += weight * layer.ply().thickness() * stress[i] * state.height;
            }
        }
        let scale = 1.0 + laminate.layers().len() as f64 * 0.005 * 30.0;
        for i in 0..3 {
            prop_assert!((n[i] - force[i]).abs() < 1e-11 * scale);
            prop_assert!(m[i].abs() < 1e-11 * scale * laminate.thickness());
        }
    }
}
