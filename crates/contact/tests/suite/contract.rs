//! The contract of all solvers that are chosen by name, and of those that chains are made of.

use stickslip_contact::contract::{Breach, check, check_experimental, check_listed};
use stickslip_contact::solver::{
    FailureCause, SOLVERS, SolverInfo, SolverKind, Step, StepFailure, StepSolution, Stop, Work,
};
use stickslip_contact::{
    Chain, GaussSeidel, InterfaceSolver, Penalty, Pivoting, PrincipalPivoting, SemismoothNewton,
    StatusIteration,
};

#[test]
fn every_solver_of_the_list_keeps_the_contract() {
    for solver in &SOLVERS {
        let kept = check_listed(solver);
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
pub(crate) struct Lazy;

impl InterfaceSolver for Lazy {
    fn name(&self) -> &'static str {
        "lazy"
    }

    fn solve(&self, _step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let cause = FailureCause::Limit(0);
        Err(StepFailure::new(self.name(), cause, Work::default()))
    }
}

/// The penalty method, without a declaration that its answers are not verified.
#[test]
fn a_solver_of_unverified_answers_must_be_declared_experimental() {
    let penalty = SolverKind::Penalty.info();
    assert!(penalty.experimental && check_listed(penalty).is_ok());
    let undeclared = SolverInfo {
        experimental: false,
        ..*penalty
    };
    let found = check_listed(&undeclared);
    let stop = Stop::Regularised;
    assert!(matches!(found, Err(Breach::Unverified { stop: own, .. }) if own == stop));
    assert!(check_experimental(&Penalty::default()).is_ok());
}

/// As a chain's member it is asked in vain, so nothing that the chain returns is unverified.
#[test]
fn a_chain_takes_no_unverified_answer() {
    let chain = Chain::alone(Box::new(Penalty::default()));
    assert!(matches!(
        check(&chain),
        Err(Breach::Refused { reason, .. }) if reason.contains("penalty")
    ));
    let rescued = Chain::new(vec![
        Box::new(Penalty::default()),
        Box::new(SemismoothNewton::default()),
    ]);
    assert!(check(&rescued).is_ok());
}

#[test]
fn breaches_are_found() {
    assert!(matches!(check(&Boastful), Err(Breach::Violated { .. })));
    assert!(matches!(check(&Lazy), Err(Breach::Refused { .. })));
}
