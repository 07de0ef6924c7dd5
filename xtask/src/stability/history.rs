//! Histories in which every method gets the same steps: each from the state that the default chain committed before it.

use stickslip_contact::state::TrialState;
use stickslip_contact::{Chain, ContactState, InterfaceProblem, InterfaceSolver};
use stickslip_laboratory::discrete::{Discrete, commit};

use super::methods::Method;
use super::outcome::judge;
use super::row::Row;

/// A step with a verified answer; without one there is none, or none was found.
#[derive(Debug)]
pub(crate) struct Stage {
    pub(crate) given: Discrete,
    pub(crate) answer: Option<TrialState>,
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
            let given = Discrete {
                name: String::new(),
                problem: problem.clone(),
                committed: state.clone(),
                multipliers: multipliers.clone(),
                coercive,
                solutions: None,
            };
            let answer = Chain::default()
                .solve(&given.step())
                .ok()
                .map(|solution| solution.trial);
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

    /// What each of `methods` does with these steps, as one row each.
    pub(crate) fn rows(&self, case: &str, value: f64, methods: &[Method]) -> Vec<Row> {
        methods
            .iter()
            .map(|method| {
                let steps: Vec<Row> = self
                    .list
                    .iter()
                    .map(|stage| judge(method, &stage.given, stage.answer.as_ref()))
                    .collect();
                Row::of_steps(case, value, self.coercive, &steps)
            })
            .collect()
    }
}
