//! Failure criteria: values by hand, an oracle by search, and invariants.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use proptest::prelude::*;
use stickslip_laminate::failure::{
    Hashin, Hoffman, Interaction, MaximumStrain, MaximumStress, TsaiHill, TsaiHillSolid, TsaiWu,
    assess_all, standard_criteria,
};
use stickslip_laminate::{FailureCriterion, FailureMode, Ply, PlyLoading, Strengths};

use crate::{STRENGTHS, constants, ply, ply_with, strengths};

fn index(criterion: &dyn FailureCriterion, ply: &Ply, stress: [f64; 3]) -> f64 {
    criterion
        .assess(ply, &PlyLoading::mechanical(stress))
        .unwrap()
        .index
}

#[test]
fn uniaxial_strengths_are_on_every_surface() {
    let [xt, xc, yt, yc, s12] = STRENGTHS;
    let cases = [
        ([xt, 0.0, 0.0], FailureMode::FibreTension),
        ([-xc, 0.0, 0.0], FailureMode::FibreCompression),
        ([0.0, yt, 0.0], FailureMode::MatrixTension),
        ([0.0, -yc, 0.0], FailureMode::MatrixCompression),
        ([0.0, 0.0, s12], FailureMode::Shear),
        ([0.0, 0.0, -s12], FailureMode::Shear),
    ];
    for criterion in standard_criteria() {
        for (strength, mode) in cases {
            // Half the strength: the reserve factor is 2, the index anything below 1.
            let half = PlyLoading::mechanical(strength.map(|s| 0.5 * s));
            let assessment = criterion.assess(&ply(), &half).unwrap();
            assert_relative_eq!(assessment.reserve_factor, 2.0, max_relative = 1e-13);
            assert_relative_eq!(assessment.margin(), 1.0, max_relative = 1e-12);
            assert!(!assessment.fails() && assessment.index < 1.0);
            assert_relative_eq!(
                index(criterion.as_ref(), &ply(), strength),
                1.0,
                max_relative = 1e-13
            );
            // Hashin has no mode of shear: it is the matrix's tension there.
            if !(criterion.name() == "hashin" && mode == FailureMode::Shear) {
                assert_eq!(assessment.mode, mode, "{}", criterion.name());
            }
        }
    }
}

#[test]
fn interactive_criteria_by_hand() {
    let ply = ply();
    let [xt, xc, yt, yc, s] = STRENGTHS;
    let [s1, s2, t] = [-100.0, 5.0, 8.0];
    let stress = [s1, s2, t];
    let shear = (t / s).powi(2);
    let hill = (s1 / xc).powi(2) - s1 * s2 / (xc * xc) + (s2 / yt).powi(2) + shear;
    assert_relative_eq!(index(&TsaiHill, &ply, stress), hill, max_relative = 1e-14);
    let uniaxial = s1 * s1 / (xt * xc)
        + s2 * s2 / (yt * yc)
        + (1.0 / xt - 1.0 / xc) * s1
        + (1.0 / yt - 1.0 / yc) * s2
        + shear;
    assert_relative_eq!(
        index(&Hoffman, &ply, stress),
        uniaxial - s1 * s2 / (xt * xc),
        max_relative = 1e-13
    );
    let f12 = -0.5 / (xt * xc * yt * yc).sqrt();
    assert_relative_eq!(
        index(&TsaiWu::default(), &ply, stress),
        uniaxial + 2.0 * f12 * s1 * s2,
        max_relative = 1e-13
    );
    // Hoffman is Tsai–Wu with F12 = −1/(2 Xt Xc).
    let as_hoffman = TsaiWu {
        interaction: Interaction::Coefficient(-0.5 / (xt * xc)),
    };
    assert_relative_eq!(
        index(&as_hoffman, &ply, stress),
        index(&Hoffman, &ply, stress),
        max_relative = 1e-14
    );
}

#[test]
fn hashin_by_hand() {
    let ply = ply();
    let [xt, xc, yt, yc, s] = STRENGTHS;
    let s23 = 12.0;
    let given = ply_with(Strengths {
        s23: Some(s23),
        ..strengths()
    });
    let hashin = Hashin::default();
    let shear = (8.0 / s).powi(2);
    let matrix_tension = (5.0 / yt).powi(2) + shear;
    assert_relative_eq!(
        index(&hashin, &ply, [-100.0, 5.0, 8.0]),
        matrix_tension,
        max_relative = 1e-14
    );
    assert_relative_eq!(
        index(&hashin, &ply, [-200.0, 1.0, 0.0]),
        (200.0 / xc).powi(2),
        max_relative = 1e-14
    );
    let fibre = (200.0 / xt).powi(2);
    assert_relative_eq!(
        index(&hashin, &ply, [200.0, 1.0, 8.0]),
        fibre + shear,
        max_relative = 1e-14
    );
    let without = Hashin::with_shear_weight(0.0).unwrap();
    assert_relative_eq!(
        index(&without, &ply, [200.0, 1.0, 8.0]),
        fibre,
        max_relative = 1e-14
    );
    let transverse = 20.0 / (2.0 * s23);
    let compression =
        transverse * transverse - ((yc / (2.0 * s23)).powi(2) - 1.0) * 20.0 / yc + shear;
    assert_relative_eq!(
        index(&hashin, &given, [0.0, -20.0, 8.0]),
        compression,
        max_relative = 1e-13
    );
}

#[test]
fn solid_tsai_hill_by_hand_and_in_its_plane_form() {
    let ply = ply();
    let [xt, xc, yt, yc, s] = STRENGTHS;
    let inverse = |v: f64| 1.0 / (v * v);
    let stress = [50.0, -6.0, -4.0, 3.0, 2.0, 5.0];
    let (x, y, z) = (inverse(xt), inverse(yc), inverse(yc));
    let hand = x * 2500.0 + y * 36.0 + z * 16.0 + (x + y - z) * 300.0 - (y + z - x) * 24.0
        + (z + x - y) * 200.0
        + 9.0 * inverse(0.5 * yc)
        + (4.0 + 25.0) * inverse(s);
    let solid = TsaiHillSolid
        .assess_solid(&ply, &[0.0; 6], &stress)
        .unwrap();
    assert_relative_eq!(solid.index, hand, max_relative = 1e-13);
    // A hydrostatic stress is harmless where all strengths are equal: the criterion is then von Mises'.
    let equal = Strengths {
        zt: Some(9.0),
        zc: Some(9.0),
        s13: Some(5.0),
        s23: Some(5.0),
        ..Strengths::in_plane(9.0, 9.0, 9.0, 9.0, 5.0)
    };
    let hydrostatic = TsaiHillSolid
        .assess_solid(&ply_with(equal), &[0.0; 6], &[3.0, 3.0, 3.0, 0.0, 0.0, 0.0])
        .unwrap();
    assert_abs_diff_eq!(hydrostatic.index, 0.0, epsilon = 1e-15);
    assert_eq!(
        TsaiHillSolid
            .assess_solid(&ply, &[0.0; 6], &[0.0, 0.0, yt, 0.0, 0.0, 0.0])
            .unwrap()
            .mode,
        FailureMode::ThicknessTension
    );
    assert_eq!(
        TsaiHillSolid
            .assess_solid(&ply, &[0.0; 6], &[0.0, 0.0, 0.0, 9.0, 0.0, 0.0])
            .unwrap()
            .mode,
        FailureMode::ThicknessShear
    );
    // With Z = Y and plane stress it is the plane form in every quadrant.
    for stress in [
        [120.0, 4.0, 3.0],
        [-xc / 3.0, 7.0, -2.0],
        [80.0, -20.0, 9.0],
        [-xc / 2.0, -11.0, 1.0],
    ] {
        let [a, b] = [&TsaiHillSolid as &dyn FailureCriterion, &TsaiHill].map(|criterion| {
            criterion
                .assess(&ply, &PlyLoading::mechanical(stress))
                .unwrap()
        });
        assert_relative_eq!(a.index, b.index, max_relative = 1e-13);
        assert_relative_eq!(a.reserve_factor, b.reserve_factor, max_relative = 1e-13);
    }
}

#[test]
fn maximum_strain_counts_stress_in_both_directions() {
    let ply = ply();
    let given = constants();
    // Uniaxial stress at the strength: ε₁ is at its limit; ε₂ = −ν₁₂ σ₁/E₁ against Y_c/E₂ is not.
    let assessment = MaximumStrain
        .assess(
            &ply,
            &PlyLoading::mechanical([0.5 * STRENGTHS[0], 10.0, 0.0]),
        )
        .unwrap();
    let strain = [
        (0.5 * STRENGTHS[0] - given.nu12 * 10.0) / given.e1,
        10.0 / given.e2 - given.nu12 * 0.5 * STRENGTHS[0] / given.e1,
    ];
    let hand = (strain[0] * given.e1 / STRENGTHS[0]).max(strain[1] * given.e2 / STRENGTHS[2]);
    assert_relative_eq!(assessment.index, hand, max_relative = 1e-13);
    assert_relative_eq!(assessment.reserve_factor, 1.0 / hand, max_relative = 1e-13);
}

#[test]
fn held_stress_uses_up_the_strength() {
    let ply = ply();
    let loading = PlyLoading {
        held: [0.0, 4.1, 0.0],
        applied: [0.0, 2.0, 0.0],
    };
    for criterion in standard_criteria() {
        // (10.1 − 4.1)/2, whatever the criterion.
        let factor = criterion.assess(&ply, &loading).unwrap().reserve_factor;
        assert_relative_eq!(factor, 3.0, max_relative = 1e-12);
    }
    let failed = PlyLoading {
        held: [0.0, 11.0, 0.0],
        applied: [0.0, -1.0, 0.0],
    };
    let harmless = PlyLoading {
        held: [1.0, 1.0, 1.0],
        applied: [0.0; 3],
    };
    for criterion in standard_criteria() {
        assert_eq!(criterion.assess(&ply, &failed).unwrap().reserve_factor, 0.0);
        let assessment = criterion.assess(&ply, &harmless).unwrap();
        assert_eq!(assessment.reserve_factor, f64::INFINITY);
        assert!(assessment.index < 1.0);
    }
    assert_eq!(
        MaximumStress.assess(&ply, &harmless).unwrap().mode,
        FailureMode::MatrixTension
    );
}

#[test]
fn several_criteria_at_once() {
    let loading = PlyLoading::mechanical([100.0, 5.0, 5.0]);
    let criteria = standard_criteria();
    let all = assess_all(&criteria, &ply(), &loading).unwrap();
    let names: Vec<_> = all.iter().map(|assessment| assessment.criterion).collect();
    assert_eq!(
        names,
        criteria
            .iter()
            .map(FailureCriterion::name)
            .collect::<Vec<_>>()
    );
}

/// The smallest r with index ≥ 1 on a fine grid, refined by bisection.
fn searched(criterion: &dyn FailureCriterion, ply: &Ply, loading: &PlyLoading) -> f64 {
    let value = |r: f64| index(criterion, ply, loading.at(r));
    let (steps, largest) = (4000, 20.0);
    let grid = |k: usize| largest * k as f64 / f64::from(steps);
    let Some(first) = (0..=steps as usize).find(|&k| value(grid(k)) >= 1.0) else {
        return f64::INFINITY;
    };
    let (mut low, mut high) = (grid(first.saturating_sub(1)), grid(first));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if value(middle) >= 1.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

fn stress(scale: f64) -> impl Strategy<Value = [f64; 3]> {
    let [xt, _, yt, _, s] = STRENGTHS;
    let unit = -scale..scale;
    (unit.clone(), unit.clone(), unit).prop_map(move |(a, b, c)| [a * xt, b * yt, c * s])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn reserve_factor_is_the_first_crossing(held in stress(0.5), applied in stress(0.6)) {
        let ply = ply();
        let loading = PlyLoading { held, applied };
        for criterion in standard_criteria() {
            let factor = criterion.assess(&ply, &loading).unwrap().reserve_factor;
            let oracle = searched(criterion.as_ref(), &ply, &loading);
            if oracle.is_finite() {
                // The grid may step over a surface that is left again within 0.005.
                prop_assert!((factor - oracle).abs() < 1e-9 * (1.0 + oracle) || factor < oracle, "{} {factor} {oracle}", criterion.name());
            } else {
                prop_assert!(factor > 19.9, "{} {factor}", criterion.name());
            }
        }
    }

    #[test]
    fn reserve_factor_makes_the_index_one(held in stress(0.4), applied in stress(1.0)) {
        let ply = ply();
        for criterion in standard_criteria() {
            let loading = PlyLoading { held, applied };
            let factor = criterion.assess(&ply, &loading).unwrap().reserve_factor;
            if factor > 0.0 && factor.is_finite() {
                let scaled = PlyLoading { held, applied: applied.map(|s| factor * s) };
                let again = criterion.assess(&ply, &scaled).unwrap();
                prop_assert!((again.index - 1.0).abs() < 1e-11, "{} {}", criterion.name(), again.index);
                prop_assert!((again.reserve_factor - 1.0).abs() < 1e-11);
            }
        }
    }

    #[test]
    fn without_held_stress_the_reserve_factor_is_inverse_to_the_load(applied in stress(1.0), multiple in 0.01..100.0_f64) {
        let ply = ply();
        for criterion in standard_criteria() {
            let [a, b] = [1.0, multiple].map(|m| {
                criterion.assess(&ply, &PlyLoading::mechanical(applied.map(|s| m * s))).unwrap()
            });
            prop_assert!((a.reserve_factor / (multiple * b.reserve_factor) - 1.0).abs() < 1e-11);
            prop_assert_eq!(b.fails(), b.index >= 1.0);
        }
    }
}
