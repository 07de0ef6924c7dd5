//! States in which everything that touches sticks, from which the load is then removed.

use stickslip_contact::{ContactState, InterfaceProblem};
use stickslip_laboratory::discrete::{Discrete, commit};

use crate::publish::TaskError;
use crate::stability::history::{Stages, increment};

/// Coefficient of friction under which nothing slips.
const HIGH: f64 = 100.0;

/// A state in which all touching points stick.
pub(super) struct Stuck(ContactState);

/// The state of the problem that `problem` makes for a coefficient of friction, at the end of `loads` under so much friction that
/// nothing slips.
pub(super) fn stuck(
    problem: &dyn Fn(f64) -> Result<InterfaceProblem, TaskError>,
    loads: &[Vec<f64>],
) -> Result<Stuck, TaskError> {
    let stages = Stages::follow(&problem(HIGH)?, loads);
    let last = stages.list.last().ok_or("a history without steps")?;
    let answer = last
        .answer
        .as_ref()
        .ok_or("friction of 100 is not solved")?;
    if answer.status.iter().any(|status| status.slip_sign() != 0.0) {
        return Err("a point slips under friction of 100".into());
    }
    let given = &last.given;
    Ok(Stuck(commit(&given.committed, answer, &given.multipliers)))
}

impl Stuck {
    /// The increment in which the load is removed from this state of `problem`, the same under another coefficient.
    pub(super) fn without_load(&self, problem: InterfaceProblem) -> Discrete {
        let multipliers = vec![0.0; problem.load_cases()];
        increment(problem, self.0.clone(), multipliers)
    }
}
