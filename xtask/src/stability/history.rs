//! Histories in which every method gets the same steps: each from the state that the default chain committed before it.

use stickslip_contact::state::TrialState;
use stickslip_contact::{Chain, ContactState, InterfaceProblem, InterfaceSolver};
use stickslip_laboratory::discrete::{Discrete, commit};

use super::judge::judge;
use super::methods::Method;
use super::row::Row;

/// A step with a verified answer; without one there is none, or none was found.
#[derive(Debug)]
pub(crate) struct Stage {
    pub(crate) given: Discrete,
    pub(crate) answer: Option<TrialState>,
}

/// The increment of a problem from a state, whose answers are not known.
pub(crate) fn increment(
    problem: InterfaceProblem,
    committed: ContactState,
    multipliers: Vec<f64>,
) -> Discrete {
    Discrete {
        name: String::new(),
        coercive: problem.modes().ncols() == 0,
        problem,
        committed,
        multipliers,
        solutions: None,
    }
}

/// The steps of a history.
#[derive(Debug)]
pub(crate) struct Stages {
    pub(crate) list: Vec<Stage>,
    pub(crate) coercive: bool,
}

impl Stages {
    /// Follows `loads` (multipliers at the end of each step) with the default chain. It ends with the first step that the chain
    /// does not solve, that step included.
    pub(crate) fn follow(problem: &InterfaceProblem, loads: &[Vec<f64>]) -> Self {
        let coercive = problem.modes().ncols() == 0;
        let mut state = ContactState::unloaded(problem);
        let mut list = Vec::with_capacity(loads.len());
        for multipliers in loads {
            let given = increment(problem.clone(), state.clone(), multipliers.clone());
            let solution = Chain::default().solve(&given.step()).ok();
            let answer = solution.map(|solution| solution.trial);
            let next = answer
                .as_ref()
                .map(|trial| commit(&state, trial, multipliers));
            list.push(Stage { given, answer });
            match next {
                Some(next) => state = next,
                None => break,
            }
        }
        Self { list, coercive }
    }

    /// Largest pressure of the answer of a step.
    pub(crate) fn peak(&self, step: usize) -> Option<f64> {
        let Stage { given, answer } = self.list.get(step)?;
        let forces = &answer.as_ref()?.forces;
        let points = given.problem.points().iter().enumerate();
        let pressures = points.map(|(k, point)| forces[2 * k] / point.area);
        Some(pressures.fold(0.0, f64::max))
    }

    /// What each of `methods` does with these steps, as one row each.
    pub(crate) fn rows(&self, case: &str, value: f64, methods: &[Method]) -> Vec<Row> {
        let row = |method: &Method| {
            let stages = self.list.iter();
            let steps = stages.map(|stage| judge(method, &stage.given, stage.answer.as_ref()));
            let steps: Vec<Row> = steps.collect();
            Row::of_steps(case, value, self.coercive, &steps)
        };
        methods.iter().map(row).collect()
    }
}
