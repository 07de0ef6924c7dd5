//! First and last ply failure of laminates, and envelopes.

use approx::assert_relative_eq;
use proptest::prelude::*;
use stickslip_laminate::failure::{
    EnvelopeEvent, EnvelopePlane, MaximumStress, TsaiHill, TsaiWu, assess_plies, failure_envelope,
    first_ply_failure, last_ply_failure, standard_criteria,
};
use stickslip_laminate::laminate::Position;
use stickslip_laminate::{Damage, Degradation, FailureMode, LaminateLoad};

use crate::{STRENGTHS, constants, laminate};

fn brittle() -> Degradation {
    Degradation::new(1e-6, 1e-6).unwrap()
}

#[test]
fn cross_ply_in_tension_cracks_across_then_breaks_along() {
    let cross = laminate("[0/90]s");
    let load = LaminateLoad::membrane([cross.thickness(), 0.0, 0.0]);
    let history = last_ply_failure(&cross, &load, &MaximumStress, &brittle()).unwrap();
    let first = history.events[0];
    assert_eq!(
        (first.ply.angle, first.ply.assessment.mode),
        (90.0, FailureMode::MatrixTension)
    );
    let expected = first_ply_failure(&cross, &load, &MaximumStress).unwrap();
    assert_eq!(history.first_factor(), expected.assessment.reserve_factor);
    // Both 90° plies fail at once, being alike.
    assert_eq!(
        (history.events[0].ply.layer, history.events[1].ply.layer),
        (1, 2)
    );
    // In the end only the 0° plies' fibres carry: N/h = X_t/2, but for what the factor 1e-6 leaves and Poisson's effect moves.
    assert_relative_eq!(
        history.last_factor(),
        0.5 * STRENGTHS[0],
        max_relative = 1e-4
    );
    assert!(
        history
            .events
            .iter()
            .any(|event| event.ply.assessment.mode == FailureMode::FibreTension)
    );
    assert!(
        history
            .events
            .windows(2)
            .all(|pair| pair[1].factor >= pair[0].factor)
    );
    assert!(history.damage.iter().all(|damage| damage.matrix));
    assert!(
        history.damage[0]
            == Damage {
                fibre: true,
                matrix: true
            }
    );
}

#[test]
fn cracks_are_no_collapse_while_fibres_carry_the_load() {
    let history = |layup: &str, force: [f64; 3]| {
        let plies = laminate(layup);
        let load = LaminateLoad::membrane(force.map(|component| component * plies.thickness()));
        last_ply_failure(&plies, &load, &MaximumStress, &brittle()).unwrap()
    };
    // Netting: equal tension both ways cracks all plies and then breaks the fibres at N/h = X_t/2.
    let netting = history("[0/90]s", [1.0, 1.0, 0.0]);
    assert!(
        netting.events[..4]
            .iter()
            .all(|event| event.ply.assessment.mode == FailureMode::MatrixTension)
    );
    let q = *crate::ply().stiffness();
    let crack = STRENGTHS[2] * (q[0][0] + 2.0 * q[0][1] + q[1][1]) / (2.0 * (q[0][1] + q[1][1]));
    assert_relative_eq!(netting.first_factor(), crack, max_relative = 1e-12);
    assert!(netting.collapsed);
    assert_relative_eq!(
        netting.last_factor(),
        0.5 * STRENGTHS[0],
        max_relative = 1e-4
    );
    // At 45° the fibres alone cannot carry tension along x: the matrix is the strength.
    let scissors = history("[±45]s", [1.0, 0.0, 0.0]);
    assert!(scissors.collapsed && scissors.last_factor() == scissors.first_factor());
    assert!(
        scissors
            .damage
            .iter()
            .all(|damage| damage.matrix && !damage.fibre)
    );
    // The same plies under equal tension both ways are the cross-ply again.
    let turned = history("[±45]s", [1.0, 1.0, 0.0]);
    assert_relative_eq!(
        turned.last_factor(),
        netting.last_factor(),
        max_relative = 1e-9
    );
}

#[test]
fn residual_stress_lowers_the_first_failure_of_a_cross_ply() {
    let cross = laminate("[0/90]s");
    let load = |temperature| LaminateLoad {
        temperature,
        ..LaminateLoad::membrane([cross.thickness(), 0.0, 0.0])
    };
    let residual = cross
        .residual_states(-250.0)
        .iter()
        .map(|state| state.stress[1])
        .fold(0.0, f64::max);
    let applied = first_ply_failure(&cross, &load(0.0), &MaximumStress).unwrap();
    let cooled = first_ply_failure(&cross, &load(-250.0), &MaximumStress).unwrap();
    // Maximum stress: the room left in the 90° ply, 1 − residual/Y_t, scales the factor.
    let expected = applied.assessment.reserve_factor * (1.0 - residual / STRENGTHS[2]);
    assert_relative_eq!(
        cooled.assessment.reserve_factor,
        expected,
        max_relative = 1e-12
    );
    // Cold enough, it cracks by itself.
    let frozen = first_ply_failure(&cross, &load(-2000.0), &MaximumStress).unwrap();
    assert_eq!(frozen.assessment.reserve_factor, 0.0);
}

#[test]
fn bending_fails_the_outer_face() {
    let single = laminate("[0_2]");
    let h = single.thickness();
    // σ₁ = ±6 M/h² at the faces: tension above, compression below.
    let load = LaminateLoad {
        moment: [h * h / 6.0, 0.0, 0.0],
        ..LaminateLoad::default()
    };
    let first = first_ply_failure(&single, &load, &MaximumStress).unwrap();
    assert_eq!((first.layer, first.position), (1, Position::Top));
    assert_relative_eq!(
        first.assessment.reserve_factor,
        STRENGTHS[0],
        max_relative = 1e-12
    );
    let plies = assess_plies(&single, &load, &MaximumStress).unwrap();
    assert_eq!(plies[0].position, Position::Bottom);
    assert_relative_eq!(
        plies[0].assessment.reserve_factor,
        STRENGTHS[1],
        max_relative = 1e-12
    );
    let stretched = LaminateLoad::membrane([1.0, 0.0, 0.0]);
    assert_eq!(
        first_ply_failure(&single, &stretched, &MaximumStress)
            .unwrap()
            .position,
        Position::Middle
    );
}

#[test]
fn no_load_fails_nothing() {
    let history = last_ply_failure(
        &laminate("[0/90]s"),
        &LaminateLoad::default(),
        &TsaiHill,
        &brittle(),
    )
    .unwrap();
    assert!(history.events.is_empty());
    assert_eq!(
        (history.first_factor(), history.last_factor()),
        (f64::INFINITY, f64::INFINITY)
    );
}

#[test]
fn damage_only_softens() {
    let ply = crate::ply();
    let degradation = Degradation::new(0.05, 0.2).unwrap();
    let given = constants();
    let matrix = degradation.stiffness(
        &ply,
        Damage {
            fibre: false,
            matrix: true,
        },
    );
    let s = stickslip_fem_core::material::inverse(&matrix);
    assert_relative_eq!(1.0 / s[0][0], given.e1, max_relative = 1e-12);
    assert_relative_eq!(1.0 / s[1][1], 0.2 * given.e2, max_relative = 1e-12);
    assert_relative_eq!(1.0 / s[2][2], 0.2 * given.g12, max_relative = 1e-12);
    let fibre = degradation.stiffness(
        &ply,
        Damage {
            fibre: true,
            matrix: true,
        },
    );
    let s = stickslip_fem_core::material::inverse(&fibre);
    assert_relative_eq!(1.0 / s[0][0], 0.05 * given.e1, max_relative = 1e-12);
    assert_relative_eq!(1.0 / s[1][1], 0.05 * given.e2, max_relative = 1e-12);
}

#[test]
fn envelope_of_one_ply_passes_its_strengths() {
    let single = laminate("[0]");
    let h = single.thickness();
    let [xt, xc, yt, yc, s] = STRENGTHS;
    let points = |plane| {
        failure_envelope(
            &single,
            plane,
            4,
            0.0,
            &TsaiWu::default(),
            EnvelopeEvent::First,
        )
        .unwrap()
    };
    let normal = points(EnvelopePlane::NormalNormal);
    for (point, force) in normal
        .iter()
        .zip([[xt, 0.0], [0.0, yt], [-xc, 0.0], [0.0, -yc]])
    {
        for i in 0..2 {
            assert!((point.force[i] - force[i] * h).abs() < 1e-10 * h * xt);
        }
    }
    let shear = points(EnvelopePlane::NormalShear);
    assert_relative_eq!(shear[1].force[2], s * h, max_relative = 1e-12);
    assert_relative_eq!(shear[3].force[2], -s * h, max_relative = 1e-12);
}

#[test]
fn last_ply_envelope_contains_the_first() {
    let quasi = laminate("[0/±45/90]s");
    let envelope = |event| {
        failure_envelope(
            &quasi,
            EnvelopePlane::NormalShear,
            16,
            -200.0,
            &TsaiHill,
            event,
        )
        .unwrap()
    };
    let first = envelope(EnvelopeEvent::First);
    let last = envelope(EnvelopeEvent::Last(brittle()));
    let size = |force: [f64; 3]| force[0].hypot(force[2]);
    for (inner, outer) in first.iter().zip(&last) {
        assert!(size(inner.force) <= size(outer.force) * (1.0 + 1e-12));
    }
    assert!(
        first
            .iter()
            .zip(&last)
            .any(|(inner, outer)| size(inner.force) < 0.9 * size(outer.force))
    );
    // A balanced lay-up does not know the sign of shear.
    for k in 1..8 {
        assert_relative_eq!(
            size(first[k].force),
            size(first[16 - k].force),
            max_relative = 1e-10
        );
        assert_relative_eq!(
            size(last[k].force),
            size(last[16 - k].force),
            max_relative = 1e-6
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn first_failure_turns_with_load_and_plies(turn in -90.0..90.0_f64, force in prop::array::uniform3(-1.0..1.0_f64)) {
        let plain = laminate("[0/±45/90]s");
        let layup = format!("[{}/{}/{}/{}]s", turn, turn + 45.0, turn - 45.0, turn + 90.0);
        let turned = laminate(&layup.replace("--", "-"));
        let (s, c) = turn.to_radians().sin_cos();
        let [x, y, t] = force;
        let rotated = [
            c * c * x + s * s * y - 2.0 * s * c * t,
            s * s * x + c * c * y + 2.0 * s * c * t,
            s * c * (x - y) + (c * c - s * s) * t,
        ];
        let factor = |laminate, force| {
            first_ply_failure(laminate, &LaminateLoad::membrane(force), &TsaiHill).unwrap().assessment.reserve_factor
        };
        let (a, b) = (factor(&plain, force), factor(&turned, rotated));
        prop_assert!((a / b - 1.0).abs() < 1e-10);
    }

    #[test]
    fn the_reserve_factor_times_the_load_is_at_the_limit(
        force in prop::array::uniform3(-1.0..1.0_f64),
        moment in prop::array::uniform3(-0.01..0.01_f64),
        temperature in -200.0..0.0_f64,
    ) {
        // Neither symmetric nor balanced: every coupling is at work.
        let plies = laminate("[0/30_2/-45/90]");
        let load = LaminateLoad { force, moment, temperature };
        for criterion in standard_criteria() {
            let factor = first_ply_failure(&plies, &load, criterion.as_ref()).unwrap().assessment.reserve_factor;
            prop_assume!(factor > 1e-3);
            let [force, moment] = [force, moment].map(|vector| vector.map(|component| factor * component));
            let scaled = LaminateLoad { force, moment, temperature };
            let assessments = assess_plies(&plies, &scaled, criterion.as_ref()).unwrap();
            let indices = assessments.iter().map(|ply| ply.assessment.index);
            prop_assert!((indices.fold(0.0, f64::max) - 1.0).abs() < 1e-10, "{}", criterion.name());
        }
    }

    #[test]
    fn failure_histories_end_and_never_unload(force in prop::array::uniform3(-1.0..1.0_f64), factor in 1e-6..1.0_f64) {
        let quasi = laminate("[0/±45/90]s");
        let degradation = Degradation::new(factor, factor).unwrap();
        let history = last_ply_failure(&quasi, &LaminateLoad::membrane(force), &TsaiHill, &degradation).unwrap();
        prop_assert!(history.events.len() <= 2 * quasi.layers().len());
        prop_assert!(history.events.windows(2).all(|pair| pair[1].factor >= pair[0].factor));
        prop_assert!(history.last_factor() >= history.first_factor());
    }
}
