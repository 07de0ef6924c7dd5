//! What holds of every answer, whatever the numbers.

use nalgebra::{DMatrix, DVector, Matrix2, Rotation2};
use proptest::prelude::*;
use stickslip_contact::history::travelled;
use stickslip_contact::state::TrialState;
use stickslip_contact::{ContactPair, ContactPoint, ContactState, InterfaceProblem};
use stickslip_fem_core::{GivenBody, InterfaceOperator, RigidBody};

use crate::oracle::Conditions;
use crate::scene::{ROUNDING, Scene, assert_close, follow};
use crate::{coulomb, positive_definite};

/// A held elastic body and a rigid one that floats on it, pressed into the wedge of normals around the x axis.
fn wedge(
    count: usize,
    entries: &[f64],
    tilts: &[f64],
    gap: f64,
    mu: f64,
) -> (InterfaceProblem, Vec<[f64; 2]>) {
    let compliance = positive_definite(2 * count, &entries[..4 * count * count], 0.5);
    let elastic = GivenBody::held(compliance, vec![DVector::zeros(2 * count); 2]).unwrap();
    let places = elastic.points().to_vec();
    let rigid = RigidBody::sliding(places.clone(), [true, true], &[[1.0, 0.0], [0.0, 1.0]]);
    let points = (0..count)
        .map(|k| {
            let angle = if k % 2 == 0 { tilts[k] } else { -tilts[k] };
            ContactPoint {
                first: k.into(),
                second: k.into(),
                normal: [angle.cos(), angle.sin()],
                gap,
                area: 1.0,
                material_angle: 0.0,
            }
        })
        .collect();
    let pair = ContactPair {
        name: "wedge".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points,
        law: coulomb(mu),
    };
    (
        InterfaceProblem::new(&[&elastic, &rigid], vec![pair]).unwrap(),
        places,
    )
}

proptest! {
    #[test]
    fn every_step_meets_the_conditions(scene in Scene::any()) {
        let problem = scene.problem();
        let mut state = ContactState::unloaded(&problem);
        for (record, multipliers) in scene.follow(1).iter().zip(&scene.steps) {
            let ends = [&*state.multipliers, multipliers];
            state = travelled(&problem, &state, ends).unwrap_or(state);
            let conditions = Conditions::new(&problem, &state, multipliers);
            let trial = TrialState {
                forces: record.state.forces.clone(),
                motion: record.state.motion.clone(),
                rigid: record.state.rigid.clone(),
                status: record.state.status.clone(),
            };
            prop_assert!(conditions.violation(&trial) < ROUNDING);
            prop_assert!(record.residuals.largest() < ROUNDING);
            prop_assert!(record.audit.gap_work < ROUNDING);
            prop_assert_eq!(&record.state, &crate::commit(&state, &trial, multipliers));
            state = record.state.clone();
        }
    }

    /// The tilts of neighbours have opposite signs, so that the normals' cone holds the load (1, ±0.2).
    #[test]
    fn floating_bodies_are_in_balance_and_action_is_reaction(
        count in 2..=4_usize,
        entries in prop::collection::vec(-0.5..0.5_f64, 64),
        tilts in prop::collection::vec(0.3..0.8_f64, 4),
        gap in 0.0..0.5_f64,
        mu in 0.0..0.4_f64,
        across in -0.2..0.2_f64,
    ) {
        let (problem, places) = wedge(count, &entries, &tilts, gap, mu);
        let multipliers = [1.0, across];
        let records = follow(&problem, &[multipliers.to_vec()], 3);
        let (state, audit) = (&records[0].state, &records[0].audit);
        let first = problem.forces_on_body(0, count, &state.forces);
        let second = problem.forces_on_body(1, count, &state.forces);
        let (mut resultant, mut moment) = ([0.0; 2], 0.0);
        for k in 0..count {
            for i in 0..2 {
                prop_assert_eq!(first[2 * k + i], -second[2 * k + i]);
                resultant[i] += first[2 * k + i];
            }
            moment += places[k][0] * first[2 * k + 1] - places[k][1] * first[2 * k];
        }
        for i in 0..2 {
            prop_assert!((resultant[i] - multipliers[i]).abs() < ROUNDING);
            prop_assert!((audit.pairs[0].resultant[i] - resultant[i]).abs() < ROUNDING);
        }
        prop_assert!((audit.pairs[0].moment - moment).abs() < ROUNDING);
        prop_assert!(audit.balance() < ROUNDING);
    }

    #[test]
    fn turning_everything_turns_the_answer(scene in Scene::any(), turn in -3.0..3.0_f64) {
        let map = Rotation2::new(turn).into_inner();
        let turned = scene.mapped(&map, |angle| angle + turn);
        for (record, other) in scene.follow(2).iter().zip(turned.follow(2)) {
            assert_close(&record.state.forces, &other.state.forces);
            assert_close(&record.state.motion, &other.state.motion);
            let count = scene.count();
            let forces = scene.problem().forces_on_body(0, count, &record.state.forces);
            let others = turned.problem().forces_on_body(0, count, &other.state.forces);
            for k in 0..count {
                let expected = map * nalgebra::Vector2::new(forces[2 * k], forces[2 * k + 1]);
                prop_assert!((expected[0] - others[2 * k]).abs() < 1e-9);
                prop_assert!((expected[1] - others[2 * k + 1]).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn the_mirror_image_is_the_answer_in_the_mirror(scene in Scene::any()) {
        let mirror = Matrix2::new(1.0, 0.0, 0.0, -1.0);
        let mirrored = scene.mapped(&mirror, |angle| -angle);
        for (record, other) in scene.follow(2).iter().zip(mirrored.follow(2)) {
            let flip = |values: &DVector<f64>| {
                DVector::from_fn(values.len(), |i, _| if i % 2 == 0 { values[i] } else { -values[i] })
            };
            assert_close(&flip(&record.state.forces), &other.state.forces);
            assert_close(&flip(&record.state.motion), &other.state.motion);
            assert_close(&-&record.slip, &other.slip);
        }
    }

    #[test]
    fn loads_and_gaps_scale_forces_and_motions(scene in Scene::any(), factor in 0.01..100.0_f64) {
        let larger = Scene {
            gaps: scene.gaps.iter().map(|gap| factor * gap).collect(),
            steps: scene.steps.iter().map(|step| step.iter().map(|load| factor * load).collect()).collect(),
            ..scene.clone()
        };
        for (record, other) in scene.follow(2).iter().zip(larger.follow(2)) {
            assert_close(&record.state.forces, &(&other.state.forces / factor));
            assert_close(&record.state.motion, &(&other.state.motion / factor));
            prop_assert!((record.dissipation() - other.dissipation() / (factor * factor)).abs() < 1e-9);
        }
    }

    /// Millimetres or kilometres, newtons or giganewtons.
    #[test]
    fn units_do_not_matter(scene in Scene::any(), length in -9..6_i32, force in -9..9_i32) {
        let (length, force) = (10.0_f64.powi(length), 10.0_f64.powi(force));
        let other = Scene {
            compliance: &scene.compliance * (length / force),
            responses: scene.responses.iter().map(|response| response * length).collect(),
            gaps: scene.gaps.iter().map(|gap| gap * length).collect(),
            ..scene.clone()
        };
        for (record, other) in scene.follow(2).iter().zip(other.follow(2)) {
            assert_close(&record.state.forces, &(&other.state.forces / force));
            assert_close(&record.state.motion, &(&other.state.motion / length));
            prop_assert_eq!(&record.state.status, &other.state.status);
        }
    }

    /// Only the sum of the two compliances matters, whatever the order of the second body's points.
    #[test]
    fn two_elastic_bodies_are_as_one_that_gives_as_both(scene in Scene::any(), share in 0.1..0.9_f64) {
        let (count, size) = (scene.count(), 2 * scene.count());
        // Second body: the remaining share, its points numbered backwards, loaded with minus its share of the motion.
        let backwards = |i: usize| 2 * (count - 1 - i / 2) + i % 2;
        let first = GivenBody::held(
            &scene.compliance * share,
            scene.responses.iter().map(|response| response * share).collect(),
        ).unwrap();
        let second = GivenBody::held(
            DMatrix::from_fn(size, size, |i, j| scene.compliance[(backwards(i), backwards(j))] * (1.0 - share)),
            scene.responses.iter().map(|all| DVector::from_fn(size, |i, _| (share - 1.0) * all[backwards(i)])).collect(),
        ).unwrap();
        let points = (0..count)
            .map(|k| ContactPoint {
                first: k.into(),
                second: (count - 1 - k).into(),
                normal: [scene.angles[k].cos(), scene.angles[k].sin()],
                gap: scene.gaps[k],
                area: 1.0,
                material_angle: 0.0,
            })
            .collect();
        let pair = ContactPair { name: "pair".into(), origin: [0.0; 2], first: 0, second: 1, points, law: coulomb(scene.mu) };
        let problem = InterfaceProblem::new(&[&first, &second], vec![pair]).unwrap();
        for (record, other) in scene.follow(1).iter().zip(follow(&problem, &scene.steps, 1)) {
            assert_close(&record.state.forces, &other.state.forces);
            assert_close(&record.state.motion, &other.state.motion);
        }
    }
}
