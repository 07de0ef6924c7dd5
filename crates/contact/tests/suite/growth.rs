//! Increments that were cut back grow again, and histories without cut-back take the increments that they name.

use nalgebra::{DMatrix, DVector};
use stickslip_contact::solver::{FailureCause, Step, StepFailure, StepSolution, Work};
use stickslip_contact::{
    Chain, ContactState, Increment, InterfaceProblem, InterfaceSolver, LoadHistory, Ramp,
};
use stickslip_fem_core::GivenBody;

use crate::{Ground, coulomb};

/// Two coupled points of a held body, pressed by the first load case and sheared by the second.
fn sheared() -> InterfaceProblem {
    let compliance = DMatrix::from_row_slice(
        4,
        4,
        &[
            2.0, 0.3, 0.5, 0.0, 0.3, 1.0, 0.0, 0.2, 0.5, 0.0, 2.0, 0.3, 0.0, 0.2, 0.3, 1.0,
        ],
    );
    let press = DVector::from_row_slice(&[-1.0, 0.0, -0.5, 0.0]);
    let shear = DVector::from_row_slice(&[0.0, 0.4, 0.0, 0.1]);
    let body = GivenBody::held(compliance, vec![press, shear]).unwrap();
    Ground::along_x(vec![0.0; 2], coulomb(0.4)).under(&body)
}

/// Solves no increment of more than `longest` of the second load that begins below `until`.
#[derive(Debug)]
struct Rough {
    longest: f64,
    until: f64,
}

impl InterfaceSolver for Rough {
    fn name(&self) -> &'static str {
        "rough"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let (from, to) = (step.committed.multipliers[1], step.multipliers()[1]);
        if from < self.until && to - from > self.longest {
            return Err(StepFailure::new(
                "rough",
                FailureCause::Limit(1),
                Work::default(),
            ));
        }
        Chain::default().solve(step)
    }
}

/// Cut back to 1/1024 at the start of a step, a history used to stay there to its end, in a thousand increments.
#[test]
fn a_history_grows_again_after_cut_back() {
    let problem = sheared();
    let steps = vec![vec![1.0, 0.0], vec![1.0, 1.0]];
    let history = LoadHistory::new(steps, 1, Ramp::Linear).unwrap();
    let rough = Rough {
        longest: 1.0 / 1024.0,
        until: 0.004,
    };
    let records = history.follow(&problem, &rough, |_| {}).unwrap();
    let whole = history.follow(&problem, &Chain::default(), |_| {}).unwrap();
    let (record, whole) = (&records[1], &whole[1]);
    assert!(record.cutbacks >= 10, "{}", record.cutbacks);
    assert!(record.increments < 50, "{}", record.increments);
    assert_eq!(record.state.multipliers, [1.0, 1.0]);
    // Both points go on slipping one way, so that the end depends on no increment.
    assert_eq!(record.state.status, whole.state.status);
    assert!((&record.state.forces - &whole.state.forces).amax() < 1e-12);
}

/// Without cut-back, each sub-step is one increment, and its numbers are those of the bare steps, to the last bit.
#[test]
fn a_walk_without_cut_back_is_its_steps() {
    let problem = sheared();
    let targets = [[1.0, 0.0], [1.0, 0.7], [0.8, -0.2]];
    let substeps = 7;
    let history =
        LoadHistory::new(targets.map(Vec::from).to_vec(), substeps, Ramp::Linear).unwrap();
    let records = history.follow(&problem, &Chain::default(), |_| {}).unwrap();
    let mut state = ContactState::unloaded(&problem);
    for (record, target) in records.iter().zip(targets) {
        let start = state.multipliers.clone();
        let mut friction_work = DVector::zeros(state.status.len());
        for k in 1..=substeps {
            let part = k as f64 * (1.0 / substeps as f64);
            let part = if k == substeps { 1.0 } else { part };
            let ends = start.iter().zip(target);
            let loads: Vec<f64> = ends.map(|(a, b)| (1.0 - part) * a + part * b).collect();
            let step = Step::new(&problem, &state, &loads);
            let trial = Chain::default().solve(&step).unwrap().trial;
            let increment = Increment::accept(&step, trial);
            friction_work += increment.friction_work;
            state = increment.state;
        }
        assert_eq!(record.state, state);
        assert_eq!(record.friction_work, friction_work);
        assert_eq!((record.increments, record.cutbacks), (substeps, 0));
    }
}

/// Two points that do not know of each other. The first bears from the start, the second closes under half of the load, and sticks from then on.
fn closing() -> InterfaceProblem {
    let response = DVector::from_row_slice(&[-1.0, 0.0, -1.0, 1.0]);
    let body = GivenBody::held(DMatrix::identity(4, 4), vec![response]).unwrap();
    Ground::along_x(vec![0.0, 0.5], coulomb(10.0)).under(&body)
}

/// Solves no increment of less than this part of the load.
#[derive(Debug)]
struct Coarse(f64);

impl InterfaceSolver for Coarse {
    fn name(&self) -> &'static str {
        "coarse"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        if step.multipliers()[0] - step.committed.multipliers[0] < self.0 {
            let cause = FailureCause::Limit(1);
            return Err(StepFailure::new("coarse", cause, Work::default()));
        }
        Chain::default().solve(step)
    }
}

/// In one increment the second point is held back from where the load step began, and friction is twice too large.
#[test]
fn increments_end_where_a_point_closes() {
    let problem = closing();
    let end = |ramp: Ramp, solver: &dyn InterfaceSolver| {
        let history = LoadHistory::new(vec![vec![1.0]], 1, ramp).unwrap();
        history.follow(&problem, solver, |_| {}).unwrap().remove(0)
    };
    let forces = [-1.0, -0.5];
    for (ramp, force) in [Ramp::Quadratic, Ramp::Contact].into_iter().zip(forces) {
        let record = end(ramp, &Chain::default());
        assert!((record.state.forces[3] - force).abs() < 1e-5, "{record:?}");
        assert!(record.verified && record.cutbacks == 0, "{record:?}");
        assert_eq!(record.ends.len(), record.increments);
        assert_eq!(record.ends.last(), Some(&1.0));
    }
    // Longer ones follow those that fail.
    let record = end(Ramp::Contact, &Coarse(0.05));
    assert_eq!(
        (record.cutbacks, &*record.state.multipliers),
        (4, &[1.0][..])
    );
    assert!((record.state.forces[3] + 0.5).abs() < 1e-5, "{record:?}");
    assert!(record.verified);
}
