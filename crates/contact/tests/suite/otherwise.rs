//! Load steps walked again by another solver or in smaller increments.

use stickslip_contact::history::{Missing, Otherwise};
use stickslip_contact::solver::{FailureCause, Step, StepFailure, StepSolution, Work};
use stickslip_contact::{
    InterfaceSolver, Kinematics, LoadHistory, Pivoting, Ramp, SemismoothNewton, StepRecord,
};

use crate::scaling::disk;

/// Newton, but for increments of more than `most` of the second load.
#[derive(Debug)]
struct Reluctant {
    most: f64,
}

impl InterfaceSolver for Reluctant {
    fn name(&self) -> &'static str {
        "reluctant"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let change = step.multipliers()[1] - step.committed.multipliers[1];
        if change.abs() > self.most {
            let cause = FailureCause::Limit(0);
            return Err(StepFailure::new(self.name(), cause, Work::default()));
        }
        SemismoothNewton::default().solve(step)
    }
}

const START: [f64; 2] = [-2.0, 0.0];
const END: [f64; 2] = [-1.5, 0.8];

fn walk(solver: &dyn InterfaceSolver) -> (Vec<StepRecord>, Vec<Otherwise>) {
    let problem = disk(1.0, 1.0);
    let steps = vec![START.to_vec(), END.to_vec()];
    let history = LoadHistory::new(steps, 1, Ramp::Linear).unwrap();
    let records = history.follow(&problem, solver, |_| {}).unwrap();
    let otherwise = history.walked_otherwise(&problem.into(), &Kinematics::Small, solver, &records);
    (records, otherwise)
}

/// The largest force at the end where `parts` load steps lead to it.
fn peak_in(solver: &dyn InterfaceSolver, parts: usize) -> f64 {
    let between = |part: usize| {
        let part = part as f64 / parts as f64;
        (0..2)
            .map(|k| (1.0 - part) * START[k] + part * END[k])
            .collect()
    };
    let history = LoadHistory::new((0..=parts).map(between).collect(), 1, Ramp::Linear).unwrap();
    peak(&history.follow(&disk(1.0, 1.0), solver, |_| {}).unwrap())
}

fn peak(records: &[StepRecord]) -> f64 {
    let forces = &records[records.len() - 1].state.forces;
    forces.iter().step_by(2).copied().fold(0.0, f64::max)
}

/// The size of a cut-back is what the same step changes by in twice as many increments, and by another solver in one.
#[test]
fn a_cut_back_is_measured() {
    let (cut, otherwise) = walk(&Reluctant { most: 0.5 });
    assert_eq!((cut[1].cutbacks, cut[1].increments), (1, 2));
    assert_eq!(otherwise[0].finer, None);
    let finer = otherwise[1].finer.unwrap();
    assert_eq!((finer.solver, finer.increments), ("reluctant", 4));
    let expected = peak_in(&SemismoothNewton::default(), 4) / peak(&cut) - 1.0;
    assert!(
        (finer.peak_pressure - expected).abs() < 1e-12,
        "{finer:?} {expected}"
    );
    assert!(finer.is_distinct() && finer.traction > 1e-4, "{finer:?}");
    let whole = otherwise[1].other_solver.unwrap();
    assert_eq!((whole.solver, whole.increments), ("pivoting", 1));
    let expected = peak_in(&Pivoting::default(), 1) / peak(&cut) - 1.0;
    assert!(
        (whole.peak_pressure - expected).abs() < 1e-12,
        "{whole:?} {expected}"
    );
}

/// Below the bound of uniqueness no other solver is asked; steps in which the load path begins or turns are compared with four increments.
#[test]
fn nothing_is_asked_where_the_answer_is_one() {
    let (records, otherwise) = walk(&SemismoothNewton::default());
    assert!(
        records
            .iter()
            .all(|record| record.cutbacks == 0 && record.coefficient > 0.0)
    );
    for own in &otherwise {
        let path = own.path.unwrap();
        assert_eq!((path.increments, path.solver), (4, "semismooth Newton"));
        let path = Otherwise { path: None, ..*own };
        assert_eq!(path, Otherwise::default());
    }
    let steps = vec![START.to_vec(), END.to_vec()];
    let fine = LoadHistory::new(steps, 4, Ramp::Linear).unwrap();
    let fine = fine.follow(&disk(1.0, 1.0), &SemismoothNewton::default(), |_| {});
    let expected = peak(&fine.unwrap()) / peak(&records) - 1.0;
    let found = otherwise[1].path.unwrap().peak_pressure;
    assert!((found - expected).abs() < 1e-12, "{found} {expected}");
}

/// Steps in which the path begins or turns are walked in four times as many increments, in any units; those that go on as the one before, or hold, in as many from where
/// these end. Steps of many increments are not walked again.
#[test]
fn load_paths_are_divided_where_they_turn() {
    let divided = |steps: &[[f64; 2]], substeps: usize, unit: f64| -> Vec<usize> {
        let problem = disk(1.0, 1.0);
        let scaled = steps.iter().map(|step| step.to_vec()).collect();
        let history = LoadHistory::new(scaled, substeps, Ramp::Linear).unwrap();
        let solver = SemismoothNewton::default();
        let records = history.follow(&problem, &solver, |_| {}).unwrap();
        // The other unit of the second load changes nothing but its numbers.
        let other: Vec<Vec<f64>> = steps.iter().map(|[a, b]| vec![*a, unit * b]).collect();
        let other = LoadHistory::new(other, substeps, Ramp::Linear).unwrap();
        let ways = other.walked_otherwise(&problem.into(), &Kinematics::Small, &solver, &records);
        assert!(ways.iter().all(|own| own.path_missing.is_none()));
        let increments = |own: &Otherwise| own.path.map_or(0, |path| path.increments);
        ways.iter().map(increments).collect()
    };
    let on = [
        [-1.0, 0.0],
        [-2.0, 0.0],
        [-2.0, 0.0],
        [-3.0, 0.0],
        [-2.0, 0.0],
    ];
    assert_eq!(divided(&on, 1, 1.0), [4, 1, 1, 4, 4]);
    assert_eq!(divided(&on, 8, 1.0), [0; 5]);
    let turned = [[-2.0, 0.1], [-2.5, -0.1]];
    assert_eq!(divided(&turned, 1, 1.0), [4, 4]);
    assert_eq!(divided(&turned, 1, 1e-3), [4, 4]);
}

/// What more increments change is what they change at the end of the whole history, not of a step from where few increments lead: the same as two histories apart.
#[test]
fn a_load_path_is_refined_from_its_beginning() {
    let steps = [
        [-2.0, 0.3],
        [-2.5, 0.9],
        [-2.6, 0.2],
        [-1.5, -0.4],
        [-1.39, -0.46],
    ];
    let walk = |substeps: usize| {
        let steps = steps.iter().map(|step| step.to_vec()).collect();
        let history = LoadHistory::new(steps, substeps, Ramp::Linear).unwrap();
        let solver = SemismoothNewton::default();
        let problem = disk(1.0, 1.0);
        let records = history.follow(&problem, &solver, |_| {}).unwrap();
        let ways = history.walked_otherwise(&problem.into(), &Kinematics::Small, &solver, &records);
        (records, ways)
    };
    let (coarse, ways) = walk(1);
    let (fine, _) = walk(4);
    for step in 0..4 {
        let path = ways[step].path.unwrap();
        assert_eq!(path.increments, 4, "step {step}");
        let work = [&coarse, &fine].map(|records| records[step].dissipation());
        let expected = (work[1] - work[0]) / work[0].max(work[1]);
        assert!((path.dissipation - expected).abs() < 1e-12, "step {step}");
        let expected = peak(&fine[..=step]) / peak(&coarse[..=step]) - 1.0;
        assert!((path.peak_pressure - expected).abs() < 1e-12, "step {step}");
    }
    let last = ways[4].path.unwrap();
    assert_eq!(last.increments, 1);
    assert!(last.traction > 1e-6, "{last:?}");
}

/// Newton, but for increments by a quarter of a load step.
#[derive(Debug)]
struct NoQuarters;

impl InterfaceSolver for NoQuarters {
    fn name(&self) -> &'static str {
        "no quarters"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let change = step.multipliers()[1] - step.committed.multipliers[1];
        if change.abs() < 0.3 {
            let cause = FailureCause::Limit(0);
            return Err(StepFailure::new(self.name(), cause, Work::default()));
        }
        SemismoothNewton::default().solve(step)
    }
}

/// Where more increments have no solution, the step is not compared, nor those that go on from there, until one begins or turns that has.
#[test]
fn a_second_walk_that_ends_is_reported_until_it_begins_again() {
    let steps = [[-2.0, 0.5], [-4.0, 1.0], [-4.0, -1.0]];
    let steps = steps.iter().map(|step| step.to_vec()).collect();
    let history = LoadHistory::new(steps, 1, Ramp::Linear).unwrap();
    let (problem, solver) = (disk(1.0, 1.0), NoQuarters);
    let records = history.follow(&problem, &solver, |_| {}).unwrap();
    assert!(records.iter().all(|record| record.cutbacks == 0));
    let ways = history.walked_otherwise(&problem.into(), &Kinematics::Small, &solver, &records);
    let missing = |own: &Otherwise| own.path_missing;
    let [first, second, third] = &ways[..] else {
        panic!("{ways:?}");
    };
    for own in [first, second] {
        assert_eq!((own.path, missing(own)), (None, Some(Missing::Answer)));
    }
    assert_eq!(missing(third), None);
    assert_eq!(third.path.unwrap().increments, 4);
}

/// A step in which contact bears anew forgets what was before, though its loads go on as those of the step before: it is divided too.
#[test]
fn a_step_that_bears_anew_is_divided() {
    let steps = vec![vec![-2.0, 0.3], vec![0.0, 0.0], vec![2.0, -0.3]];
    let history = LoadHistory::new(steps, 1, Ramp::Linear).unwrap();
    let (problem, solver) = (disk(1.0, 1.0), SemismoothNewton::default());
    let records = history.follow(&problem, &solver, |_| {}).unwrap();
    let ways = history.walked_otherwise(&problem.into(), &Kinematics::Small, &solver, &records);
    assert_eq!((records[1].coefficient, ways[1].path), (0.0, None));
    let path = ways[2].path.unwrap();
    assert_eq!(path.increments, 4);
    // The other way round it is the first step.
    let first = ways[0].path.unwrap();
    assert!(first.dissipation.abs() > 0.01, "{first:?}");
    assert!(
        (path.dissipation - first.dissipation).abs() < 1e-9,
        "{first:?} {path:?}"
    );
}
