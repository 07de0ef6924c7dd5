//! The contract of all solvers that are chosen by name, and of those that chains are made of.

use stickslip_contact::solver::contract::{Breach, check};
use stickslip_contact::solver::{FailureCause, SOLVERS, Step, StepFailure, StepSolution, Work};
use stickslip_contact::{
    Chain, GaussSeidel, InterfaceSolver, Penalty, Pivoting, PrincipalPivoting, SemismoothNewton,
    StatusIteration,
};

#[test]
fn every_solver_of_the_list_keeps_the_contract() {
    for solver in &SOLVERS {
        let kept = check((solver.make)().as_ref());
        assert!(kept.is_ok(), "{}: {}", solver.name, kept.unwrap_err());
    }
}

#[test]
fn members_of_chains_keep_the_contract() {
    let members: [Box<dyn InterfaceSolver>; 5] = [
        Box::new(SemismoothNewton::default()),
        Box::new(StatusIteration::default()),
        Box::new(Pivoting::default()),
        Box::new(PrincipalPivoting::default()),
        Box::new(GaussSeidel::plain()),
    ];
    for solver in members {
        let kept = check(solver.as_ref());
        assert!(kept.is_ok(), "{}: {}", solver.name(), kept.unwrap_err());
    }
}

/// Says of the penalty method's answers that they are verified.
#[derive(Debug)]
struct Boastful;

impl InterfaceSolver for Boastful {
    fn name(&self) -> &'static str {
        "boastful"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let solution = Penalty::default().solve(step)?;
        Ok(StepSolution {
            residuals: Chain::default().solve(step)?.residuals,
            ..solution
        })
    }
}

/// Refuses everything.
#[derive(Debug)]
struct Lazy;

impl InterfaceSolver for Lazy {
    fn name(&self) -> &'static str {
        "lazy"
    }

    fn solve(&self, _step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let cause = FailureCause::Limit(0);
        Err(StepFailure::new(self.name(), cause, Work::default()))
    }
}

#[test]
fn breaches_are_found() {
    assert!(matches!(check(&Boastful), Err(Breach::Violated { .. })));
    assert!(matches!(check(&Lazy), Err(Breach::Refused { .. })));
}
