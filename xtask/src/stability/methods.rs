//! The methods under test, one table for every study and map.

use stickslip_contact::solver::FailureCause;
use stickslip_contact::{
    AugmentedLagrangian, Chain, Continuation, Enumeration, GaussSeidel, InterfaceSolver, Penalty,
    Pivoting, PrincipalPivoting, SemismoothNewton, StatusIteration, TrescaFixedPoint,
};

/// Name of the default chain, whose failures fail the task.
pub(crate) const CHAIN: &str = "default chain";

/// A solver with its name in tables and maps.
#[derive(Debug)]
pub(crate) struct Method {
    pub(crate) name: &'static str,
    pub(crate) solver: Box<dyn InterfaceSolver>,
}

impl Method {
    fn new(name: &'static str, solver: impl InterfaceSolver + 'static) -> Self {
        Self {
            name,
            solver: Box::new(solver),
        }
    }

    /// Whether it is the chain that answers by default.
    pub(crate) fn is_chain(&self) -> bool {
        self.name == CHAIN
    }
}

/// Every method of the studies, in the order of the maps: the default first, then from the fastest to the slowest. A new solver of the contact
/// crate is added by hand, because variants of one solver stand here too.
pub(crate) fn methods() -> Vec<Method> {
    vec![
        Method::new(CHAIN, Chain::default()),
        Method::new("semismooth Newton", SemismoothNewton::default()),
        Method::new("status iteration", StatusIteration::default()),
        Method::new("Lemke pivoting", Pivoting::default()),
        Method::new("principal pivoting", PrincipalPivoting::default()),
        Method::new("continuation", Continuation::default()),
        Method::new("Tresca fixed point", TrescaFixedPoint::default()),
        Method::new("Gauss–Seidel", GaussSeidel::plain()),
        Method::new("Gauss–Seidel, accelerated", GaussSeidel::default()),
        Method::new("augmented Lagrangian", AugmentedLagrangian::default()),
        Method::new("penalty", Penalty::default()),
        Method::new("enumeration", Enumeration::default()),
    ]
}

/// Whether a failure only says that the problem is too large for the method.
pub(crate) fn is_too_large(cause: &FailureCause) -> bool {
    matches!(cause, FailureCause::TooManyPoints { .. })
}

#[cfg(test)]
mod tests {
    use stickslip_contact::solver::SOLVERS;

    use super::methods;

    #[test]
    fn every_listed_method_is_under_test() {
        let tested: Vec<&str> = methods().iter().map(|own| own.solver.name()).collect();
        for method in SOLVERS
            .iter()
            .flat_map(|solver| solver.method.split(", then "))
        {
            let is_tested = tested.iter().any(|name| method.contains(name));
            assert!(is_tested, "{method} is not among {tested:?}");
        }
    }
}
