//! Ply discount as a point model.

use approx::assert_relative_eq;
use proptest::prelude::*;
use stickslip_fem_core::material::{Material, apply};
use stickslip_laminate::failure::{Hashin, MaximumStress, TsaiHill, first_ply_failure};
use stickslip_laminate::progressive::PlyDiscount;
use stickslip_laminate::{
    Degradation, FailureCriterion, LaminateLoad, PointHistory, PointModel, PointState,
};

use crate::{assert_matrix, assert_vector, laminate};

fn model(layup: &str, criterion: impl FailureCriterion + 'static) -> PlyDiscount {
    PlyDiscount::new(
        laminate(layup),
        Box::new(criterion),
        Degradation::new(0.02, 0.1).unwrap(),
    )
    .unwrap()
}

/// From no strain to `strain` and `temperature` in equal steps, and the work done on the way by the trapezoidal rule.
fn walk(
    model: &dyn PointModel,
    strain: [f64; 3],
    temperature: f64,
    steps: usize,
) -> (PointState, f64) {
    let mut history = PointHistory::new(model.initial_state());
    let (mut work, mut stress) = (0.0, [0.0; 3]);
    for step in 1..=steps {
        let share = step as f64 / steps as f64;
        let at = strain.map(|component| component * share);
        let response = model
            .respond(history.committed(), at, temperature * share)
            .unwrap();
        let before = history.committed().strain;
        work += (0..3)
            .map(|i| 0.5 * (stress[i] + response.stress[i]) * (at[i] - before[i]))
            .sum::<f64>();
        stress = response.stress;
        history.commit(response.trial);
    }
    (history.committed().clone(), work)
}

#[test]
fn sound_laminate_is_its_membrane() {
    let model = model("[0/±45/90]s", TsaiHill);
    let material = model.laminate().membrane_material().unwrap();
    let strain = [0.001, -0.0005, 0.0008];
    let response = model.respond(&model.initial_state(), strain, 0.0).unwrap();
    assert_matrix(&response.tangent, &material.stiffness(), 1e-14);
    assert_vector(
        &response.stress,
        &apply(&material.stiffness(), strain),
        1e-13,
    );
    assert_eq!(response.trial.dissipated, 0.0);
    // Heated and free it is without mean stress.
    let free = material.thermal_strain(-250.0);
    let cooled = model.respond(&model.initial_state(), free, -250.0).unwrap();
    assert!(cooled.stress.iter().all(|s| s.abs() < 1e-12) && cooled.trial.stored > 0.0);
}

#[test]
fn first_event_is_first_ply_failure() {
    let model = model("[0/±45/90]s", TsaiHill);
    let laminate = model.laminate();
    let load = LaminateLoad::membrane([laminate.thickness(), 0.0, 0.0]);
    let factor = first_ply_failure(laminate, &load, &TsaiHill)
        .unwrap()
        .assessment
        .reserve_factor;
    let strain = laminate.deformation(&load).strain;
    let damaged = |multiple: f64| {
        let response = model
            .respond(
                &model.initial_state(),
                strain.map(|e| multiple * factor * e),
                0.0,
            )
            .unwrap();
        response
            .trial
            .layers
            .iter()
            .filter(|layer| layer.damage.matrix)
            .count()
    };
    assert_eq!((damaged(1.0 - 1e-12), damaged(1.0 + 1e-12)), (0, 2));
}

#[test]
fn step_size_changes_nothing_on_a_straight_path() {
    let strain = [0.016, -0.003, 0.01];
    for criterion in [
        Box::new(TsaiHill) as Box<dyn FailureCriterion>,
        Box::new(Hashin::default()),
        Box::new(MaximumStress),
    ] {
        let degradation = Degradation::new(0.02, 0.1).unwrap();
        let model = PlyDiscount::new(laminate("[0/±45/90]s"), criterion, degradation).unwrap();
        for temperature in [0.0, -100.0] {
            let (one, _) = walk(&model, strain, temperature, 1);
            // Fibres and matrix fail on the way, not all at the same strain.
            assert!(
                one.layers[0].damage.fibre
                    && one.layers[3].damage.matrix
                    && !one.layers[3].damage.fibre
            );
            for steps in [3, 17, 1000] {
                let (many, _) = walk(&model, strain, temperature, steps);
                for (a, b) in one.layers.iter().zip(&many.layers) {
                    assert_eq!(a.damage, b.damage);
                    assert_vector(&a.stress, &b.stress, 1e-12);
                }
                assert_relative_eq!(many.dissipated, one.dissipated, max_relative = 1e-10);
                assert_relative_eq!(many.stored, one.stored, max_relative = 1e-12);
            }
        }
    }
}

#[test]
fn work_is_stored_or_dissipated() {
    // The trapezoidal rule errs by half a step times each drop of stress: first order.
    let model = model("[0/±45/90]s", TsaiHill);
    let error = |steps| {
        let (state, work) = walk(&model, [0.016, -0.003, 0.01], 0.0, steps);
        (work - state.stored - state.dissipated).abs() / work
    };
    let (coarse, fine) = (error(200), error(20_000));
    assert!(coarse < 0.02, "{coarse}");
    assert!(fine < 0.02 * 0.02, "{fine}");
}

#[test]
fn damage_stays_when_unloaded_and_a_rejected_step_leaves_no_trace() {
    let model = model("[0/90]s", MaximumStress);
    let start = model.initial_state();
    let stretched = model.respond(&start, [0.01, 0.0, 0.0], 0.0).unwrap();
    assert!(stretched.trial.layers[1].damage.matrix);
    assert_eq!(start, model.initial_state());
    let mut history = PointHistory::new(start);
    history.commit(stretched.trial.clone());
    let back = model.respond(history.committed(), [0.0; 3], 0.0).unwrap();
    assert_eq!(back.tangent, stretched.tangent);
    assert_eq!(back.stress, [0.0; 3]);
    assert_eq!(back.trial.stored, 0.0);
    assert_eq!(back.trial.dissipated, stretched.trial.dissipated);
}

fn strains() -> impl Strategy<Value = Vec<[f64; 3]>> {
    prop::collection::vec(prop::array::uniform3(-0.03..0.03_f64), 1..6)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn dissipation_never_falls_and_damage_never_heals(path in strains(), temperature in -300.0..0.0_f64) {
        let model = model("[0/±45/90]s", Hashin::default());
        let mut history = PointHistory::new(model.initial_state());
        for strain in path {
            let response = model.respond(history.committed(), strain, temperature).unwrap();
            prop_assert!(response.trial.dissipated >= history.committed().dissipated);
            prop_assert!(response.trial.stored >= 0.0);
            for (new, old) in response.trial.layers.iter().zip(&history.committed().layers) {
                prop_assert!(new.damage.fibre >= old.damage.fibre && new.damage.matrix >= old.damage.matrix);
            }
            history.commit(response.trial);
        }
    }

    #[test]
    fn tangent_is_the_derivative_between_events(strain in prop::array::uniform3(-0.02..0.02_f64)) {
        let model = model("[0/±45/90]s", TsaiHill);
        let start = model.initial_state();
        let here = model.respond(&start, strain, 0.0).unwrap();
        let h = 1e-7;
        for j in 0..3 {
            let side = |step: f64| {
                let mut moved = strain;
                moved[j] += step;
                model.respond(&start, moved, 0.0).unwrap()
            };
            let (left, right) = (side(-h), side(h));
            let same = |a: &PointState| a.layers.iter().zip(&here.trial.layers).all(|(a, b)| a.damage == b.damage);
            prop_assume!(same(&left.trial) && same(&right.trial));
            for i in 0..3 {
                // The response is linear between events: rounding of the stresses over the step is all there is.
                let difference = (right.stress[i] - left.stress[i]) / (2.0 * h);
                prop_assert!((difference - here.tangent[i][j]).abs() < 1e-5 * here.tangent[0][0].max(100.0));
            }
        }
    }
}
