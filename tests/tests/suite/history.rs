//! Load histories: unloading, paths, rejected increments, sub-steps, energy.

use std::sync::Mutex;

use stickslip::results::Finding;
use stickslip_contact::solver::{FailureCause, StepFailure, StepSolution, Work};
use stickslip_contact::{Chain, InterfaceSolver, solver::Step};
use stickslip_tests::balance::{internal_forces, load_forces};
use stickslip_tests::compare::{all_stresses, last_tractions, relative_difference, tractions};
use stickslip_tests::{Draft, Solution};

/// The same numbers up to rounding; see the tests of symmetry.
const ROUNDING: f64 = 1e-8;

/// Wherever contact ends below atan(1/μ), every contact force has a part along the pull, so that none is left without it.
#[test]
fn nothing_is_left_of_contact_when_the_pull_is_gone() {
    for model in ["half", "whole"] {
        let results = Draft::pin()
            .set("analysis.model", model)
            .forces(0, &[1000.0, 2000.0, 300.0, 0.0, 2000.0])
            .run();
        let peak = results.steps[1].edges[0].peak_pressure.expect("contact").0;
        let extent = results.steps[1].edges[0]
            .contact_half_extent
            .expect("contact");
        assert!(extent < (1.0_f64 / 0.25).atan(), "{extent}");
        let unloaded = &results.steps[3].edges[0];
        assert!(
            tractions(unloaded).all(|traction| traction.abs() < 1e-9 * peak),
            "{unloaded:?}"
        );
        assert!(
            unloaded.normal_force.abs() < 1e-9 * 2000.0
                && unloaded
                    .bearing_stress(&results.edges[0])
                    .is_none_or(|stress| stress < 1e-6)
        );
        assert!((results.steps[4].edges[0].resultant[0] - 2000.0).abs() < 1e-6);
        assert!(
            results
                .steps
                .iter()
                .map(|step| step.unloading)
                .eq([false, false, true, true, false])
        );
    }
}

/// Around a neat fit everything slips one way at the first pull, and all of it the other way once the pull is nearly gone.
#[test]
fn friction_turns_round_on_unloading() {
    let results = Draft::pin()
        .set("bodies.pin.shape.disk.radius", "5 mm")
        .friction("coulomb = { mu = 0.1 }")
        .forces(0, &[2000.0, 1500.0, 1000.0, 500.0, 50.0, 2000.0])
        .run();
    let shares: Vec<f64> = results
        .steps
        .iter()
        .map(|step| step.edges[0].friction_force / step.edges[0].normal_force)
        .collect();
    assert!(
        shares.windows(2).take(4).all(|pair| pair[1] < pair[0]),
        "{shares:?}"
    );
    // The node at the bearing point cannot slide and carries no shear, and its neighbour may stick: a few parts in a hundred.
    for (share, full) in [(shares[0], 0.1), (shares[4], -0.1), (shares[5], 0.1)] {
        assert!((share - full).abs() < 0.01, "{shares:?}");
    }
}

#[test]
fn without_friction_the_path_does_not_matter() {
    let draft = Draft::pin().friction("coulomb = { mu = 0 }");
    let direct = last_tractions(&draft.clone().forces(0, &[1300.0]).run());
    let paths: [&[f64]; 4] = [
        &[100.0, 700.0, 1300.0],
        &[3000.0, 1300.0],
        &[2000.0, 0.0, 1300.0],
        &[1000.0, -500.0, 1300.0],
    ];
    for path in paths {
        let walked = last_tractions(&draft.clone().forces(0, path).run());
        let difference = relative_difference(direct.iter().copied(), walked);
        assert!(difference < ROUNDING, "{path:?}: {difference:e}");
    }
    // With friction it does.
    let draft = Draft::pin();
    let direct = last_tractions(&draft.clone().forces(0, &[1300.0]).run());
    let back = last_tractions(&draft.forces(0, &[3000.0, 1300.0]).run());
    assert!(relative_difference(direct, back) > 0.05);
}

/// A pin that fits neatly and a growing pull: nothing but the pull has a size, so that all stresses grow with it.
#[test]
fn a_neat_fit_grows_in_proportion() {
    let draft = Draft::pin()
        .set("bodies.pin.shape.disk.radius", "5 mm")
        .friction("coulomb = { mu = 0.4 }");
    let results = draft.forces(0, &[400.0, 1000.0, 2500.0]).run();
    let unit = |step: usize, pull: f64| -> Vec<f64> {
        tractions(&results.steps[step].edges[0])
            .map(|traction| traction / pull)
            .collect()
    };
    for (step, pull) in [(1, 1000.0), (2, 2500.0)] {
        let difference = relative_difference(unit(0, 400.0), unit(step, pull));
        assert!(difference < ROUNDING, "{difference:e}");
    }
}

/// Solves every step, and then refuses the first increment from each load step that was reached: the history has to cut back.
#[derive(Debug)]
struct Fickle {
    inner: Chain,
    ends: Vec<Vec<f64>>,
    refused: Mutex<Vec<Vec<f64>>>,
}

impl InterfaceSolver for Fickle {
    fn name(&self) -> &'static str {
        "fickle"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let solution = self.inner.solve(step)?;
        let from = &step.committed.multipliers;
        let mut refused = self.refused.lock().expect("no panic elsewhere");
        if self.ends.contains(from) && !refused.contains(from) {
            refused.push(from.clone());
            return Err(StepFailure {
                attempts: vec![("fickle", FailureCause::Limit(0))],
                work: Work::default(),
                best: None,
            });
        }
        Ok(solution)
    }
}

#[test]
fn rejected_increments_leave_no_trace() {
    for law in [
        "coulomb = { mu = 0.3 }",
        "static_dynamic = { static = 0.35, dynamic = 0.2, transition = \"lagged\" }",
        "slip_power = { static = 0.4, dynamic = 0.2, slip_scale = \"1 um\", exponent = 1.0 }",
    ] {
        let draft = Draft::pin()
            .friction(law)
            .forces(0, &[900.0, 2200.0, 700.0]);
        let scene = draft.scene();
        let solution = Solution::of(&scene);
        let start = vec![0.0; solution.records()[0].state.multipliers.len()];
        let reached = solution
            .records()
            .iter()
            .map(|record| record.state.multipliers.clone());
        let fickle = Fickle {
            inner: Chain::newton_first(),
            ends: std::iter::once(start).chain(reached).collect(),
            refused: Mutex::default(),
        };
        let cut =
            stickslip::run::run_with(&scene, &fickle, &mut |_| {}).expect("halves are accepted");
        let halved = draft.clone().set("analysis.substeps", 2).run();
        assert!(
            cut.steps
                .iter()
                .all(|step| step.cutbacks == 1 && step.increments == 2)
        );
        let cut_back = |finding: &Finding| matches!(finding, Finding::CutBack { steps, .. } if steps[..] == [1, 2, 3]);
        assert!(cut.findings.iter().any(cut_back), "{:?}", cut.findings);
        assert_eq!(all_stresses(&cut), all_stresses(&halved), "{law}");
        let dissipation = |results: &stickslip::results::Results| {
            results
                .steps
                .iter()
                .map(|step| step.dissipation)
                .collect::<Vec<_>>()
        };
        assert_eq!(dissipation(&cut), dissipation(&halved), "{law}");
    }
}

/// With clearance contact spreads while the pull grows, and the answer depends on the path: ever smaller sub-steps lead to
/// one limit, at first order.
#[test]
fn substeps_converge() {
    let tractions_with = |substeps: usize| {
        let draft = Draft::pin()
            .friction("coulomb = { mu = 0.4 }")
            .set("analysis.substeps", substeps);
        last_tractions(&draft.forces(0, &[2000.0, 800.0]).run())
    };
    let limit = tractions_with(128);
    let errors: Vec<f64> = [1, 4, 16, 32]
        .map(|substeps| relative_difference(tractions_with(substeps), limit.iter().copied()))
        .to_vec();
    assert!(
        errors.windows(2).all(|pair| pair[1] < pair[0]),
        "{errors:?}"
    );
    // First order is a factor of 8 from 4 to 32, less where the first few sub-steps miss part of the passage.
    assert!(
        errors[3] < errors[1] / 4.0 && errors[3] < 0.04,
        "{errors:?}"
    );
}

/// Work of the pull = elastic energy + work lost to friction. Trapezoids of both works err by the square of the step.
#[test]
fn the_pull_pays_for_energy_and_friction() {
    let imbalance = |count: usize| {
        let up = (1..=count).map(|k| 2000.0 * k as f64 / count as f64);
        let down = (1..=count).map(|k| 2000.0 - 1500.0 * k as f64 / count as f64);
        let pulls: Vec<f64> = up.chain(down).collect();
        let solution = Draft::pin()
            .friction("coulomb = { mu = 0.4 }")
            .forces(0, &pulls)
            .solve();
        let (plate, pin) = (solution.body("plate"), solution.body("pin"));
        let unit = load_forces(solution.elastic(plate).expect("elastic"), &[1.0]);
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let (mut work, mut lost, mut before) = (0.0, 0.0, (0.0, 0.0));
        let mut energy = 0.0;
        for (pull, record) in pulls.iter().zip(solution.records()) {
            let u = [plate, pin].map(|body| solution.displacement(body, record));
            let travel = dot(&unit, &u[0]);
            work += f64::midpoint(before.0, *pull) * (travel - before.1);
            lost += record.dissipation();
            before = (*pull, travel);
            energy = [plate, pin]
                .iter()
                .zip(&u)
                .map(|(&body, u)| {
                    dot(
                        u,
                        &internal_forces(solution.elastic(body).expect("elastic"), u),
                    ) / 2.0
                })
                .sum();
        }
        assert!(lost > 0.0);
        (work - energy - lost).abs() / lost
    };
    let errors = [5, 20, 80].map(imbalance);
    assert!(
        errors[1] < errors[0] / 3.0 && errors[2] < errors[1] / 3.0 && errors[2] < 0.02,
        "{errors:?}"
    );
}
