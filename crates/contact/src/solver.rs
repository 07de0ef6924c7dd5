//! One load step of frictional contact, and the family of solvers for it.
//!
//! ```text
//! g_n ≥ 0,  λ_n ≥ 0,  g_n λ_n = 0
//! |λ_t| ≤ F_stick where Δs = 0 (stick),   λ_t = −F_slip sign(Δs) where Δs ≠ 0 (slip)
//! ```
//!
//! | solver | idea | ends |
//! | --- | --- | --- |
//! | [`StatusIteration`] | guess open/stick/slip, solve, correct all at once (Post & Reddy 1988, II 2.1) | may cycle, which it detects |
//! | [`SemismoothNewton`] | the same solves, corrected by the projection (Alart & Curnier 1991), with rules against repetition | may cycle, which it detects |
//! | [`TrescaFixedPoint`] | a convex problem with given bounds, then new bounds (Panagiotopoulos 1975) | at its tolerance for small μ; may stall for large |
//! | [`Pivoting`] | Lemke's complementary pivoting (Cottle, Pang & Stone 1992) | after finitely many pivots; with a solution where all bodies are supported |
//! | [`PrincipalPivoting`] | exchange of single complementary pairs, least index first (Murty 1974) | for small μ; detects repetition |
//! | [`GaussSeidel`] | each point solved exactly, in turn (Jean 1999) | at its tolerance for small μ |
//! | [`Penalty`] | contact springs | with an answer of the springs' accuracy |
//! | [`AugmentedLagrangian`] | contact springs, and multipliers that take over from them (Hestenes 1969, Powell 1969) | at its tolerance, whatever the springs |
//! | [`Continuation`] | the solution followed from a simpler problem | with a solution, if the path has no fold that it cannot jump |
//! | [`Enumeration`] | every combination of statuses | after 4ⁿ solves, with a proof if there is no solution |
//! | [`Chain`] | a solver made of solvers: the next one takes over where one fails | with its last member |
//!
//! To add a solver, write its file and add its module, its [`SolverKind`] and its line in [`SOLVERS`] here.

pub(crate) mod accept;
mod active_set;
mod attempt;
mod augmented;
mod balance;
mod boxed;
mod candidate;
mod chain;
mod complementarity;
mod continuation;
mod enumeration;
mod frozen;
mod gauss_seidel;
mod hold;
pub(crate) mod least_distance;
mod least_index;
mod lemke;
mod mixing;
pub(crate) mod nearest;
mod penalty;
mod pivoting;
mod principal;
mod residual;
mod rules;
mod secants;
mod sensitivity;
mod solution;
mod step;
mod tableau;
mod tresca;

pub(crate) use balance::{balanced_by, settled};
pub(crate) use chain::released;

pub use crate::failure::{FailureCause, Residuals, StepFailure, Unresolved, Work};
pub use crate::problem::FreeMotions;
pub use active_set::{SemismoothNewton, StatusIteration};
pub use augmented::AugmentedLagrangian;
pub use chain::Chain;
pub use continuation::Continuation;
pub use enumeration::Enumeration;
pub use frozen::{Frozen, FrozenSystem, SlipLine};
pub use gauss_seidel::{Acceleration, GaussSeidel};
pub use penalty::Penalty;
pub use pivoting::Pivoting;
pub use principal::PrincipalPivoting;
pub use solution::{InterfaceSolver, StepSolution, Stop};
pub use step::Step;
pub use tresca::TrescaFixedPoint;

/// A solver that is chosen by its name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum SolverKind {
    /// [`Chain::newton_first`], as the default.
    #[default]
    Auto,
    /// [`Chain::status_first`].
    Status,
    /// [`Chain::newton_first`], by choice.
    Newton,
    /// [`Pivoting`].
    Pivoting,
    /// [`PrincipalPivoting`].
    PrincipalPivoting,
    /// [`GaussSeidel`].
    GaussSeidel,
    /// [`AugmentedLagrangian`].
    AugmentedLagrangian,
    /// [`Continuation`].
    Continuation,
    /// [`Penalty`].
    Penalty,
    /// [`TrescaFixedPoint`].
    Tresca,
    /// [`Enumeration`].
    Enumeration,
}

/// One line of the list of solvers, [`SOLVERS`].
#[derive(Clone, Copy, Debug)]
pub struct SolverInfo {
    /// Which it is.
    pub kind: SolverKind,
    /// Its name in scenes.
    pub name: &'static str,
    /// The methods behind it, in the order in which they are tried.
    pub method: &'static str,
    /// What it is, in one line.
    pub summary: &'static str,
    /// Whether its answers may be regularised, of a looser tolerance, or limited to few points: for studies of methods. Answers of others
    /// are verified, as [`contract::check_listed`](crate::contract::check_listed) tests.
    pub experimental: bool,
    /// Whether it works on problems whose compliance is held in blocks too.
    pub on_blocks: bool,
    /// Makes it with its default options.
    pub make: fn() -> Box<dyn InterfaceSolver>,
}

/// All solvers that can be chosen by name, in the order of [`SolverKind`].
pub const SOLVERS: [SolverInfo; 11] = [
    SolverInfo {
        kind: SolverKind::Auto,
        name: "auto",
        method: "semismooth Newton, then pivoting",
        summary: "climbs from the fastest to the safest until one succeeds (default)",
        experimental: false,
        on_blocks: true,
        make: || Box::new(Chain::newton_first()),
    },
    SolverInfo {
        kind: SolverKind::Status,
        name: "status",
        method: "status iteration, then semismooth Newton, then pivoting",
        summary: "iteration of open, stick and slip per node",
        experimental: false,
        on_blocks: true,
        make: || Box::new(Chain::status_first()),
    },
    SolverInfo {
        kind: SolverKind::Newton,
        name: "newton",
        method: "semismooth Newton, then pivoting",
        summary: "semismooth Newton on the contact conditions",
        experimental: false,
        on_blocks: true,
        make: || Box::new(Chain::newton_first()),
    },
    SolverInfo {
        kind: SolverKind::Pivoting,
        name: "pivoting",
        method: "pivoting",
        summary: "Lemke's pivoting on the linear complementarity problem",
        experimental: false,
        on_blocks: false,
        make: || alone(Pivoting::default()),
    },
    SolverInfo {
        kind: SolverKind::PrincipalPivoting,
        name: "principal_pivoting",
        method: "least-index principal pivoting",
        summary: "exchange of single complementary pairs, for small friction",
        experimental: false,
        on_blocks: false,
        make: || alone(PrincipalPivoting::default()),
    },
    SolverInfo {
        kind: SolverKind::GaussSeidel,
        name: "gauss_seidel",
        method: "accelerated Gauss-Seidel",
        summary: "each point solved in turn, with acceleration of the sweeps",
        experimental: false,
        on_blocks: false,
        make: || alone(GaussSeidel::default()),
    },
    SolverInfo {
        kind: SolverKind::AugmentedLagrangian,
        name: "augmented_lagrangian",
        method: "augmented Lagrangian",
        summary: "contact springs, and multipliers that take over from them",
        experimental: false,
        on_blocks: false,
        make: || alone(AugmentedLagrangian::default()),
    },
    SolverInfo {
        kind: SolverKind::Continuation,
        name: "continuation",
        method: "continuation",
        summary: "the solution followed from less friction or a smaller load",
        experimental: false,
        on_blocks: false,
        make: || alone(Continuation::default()),
    },
    SolverInfo {
        kind: SolverKind::Penalty,
        name: "penalty",
        method: "penalty",
        summary: "contact springs: answers of the springs' accuracy",
        experimental: true,
        on_blocks: false,
        make: || Box::new(Penalty::default()),
    },
    SolverInfo {
        kind: SolverKind::Tresca,
        name: "tresca",
        method: "Tresca fixed point",
        summary: "given friction bounds, updated until they fit, for small friction",
        experimental: true,
        on_blocks: false,
        make: || Box::new(TrescaFixedPoint::default()),
    },
    SolverInfo {
        kind: SolverKind::Enumeration,
        name: "enumeration",
        method: "enumeration of all statuses",
        summary: "every combination of statuses, of at most six points",
        experimental: true,
        on_blocks: false,
        make: || Box::new(Enumeration::default()),
    },
];

const _: () = {
    let mut index = 0;
    while index < SOLVERS.len() {
        assert!(
            SOLVERS[index].kind as usize == index,
            "in the order of the kinds"
        );
        index += 1;
    }
};

fn alone(solver: impl InterfaceSolver + 'static) -> Box<dyn InterfaceSolver> {
    Box::new(Chain::alone(Box::new(solver)))
}

impl SolverKind {
    /// The names of all, in the order of [`SOLVERS`].
    pub const NAMES: [&'static str; SOLVERS.len()] = {
        let mut names = [""; SOLVERS.len()];
        let mut k = 0;
        while k < SOLVERS.len() {
            names[k] = SOLVERS[k].name;
            k += 1;
        }
        names
    };

    /// The solver called `name`, if there is one.
    ///
    /// ```
    /// use stickslip_contact::solver::SolverKind;
    ///
    /// assert_eq!(SolverKind::named("pivoting"), Some(SolverKind::Pivoting));
    /// assert!(SolverKind::named("penalty").unwrap().info().experimental);
    /// assert_eq!(SolverKind::named("magic"), None);
    /// ```
    pub fn named(name: &str) -> Option<Self> {
        let found = SOLVERS.iter().find(|solver| solver.name == name);
        found.map(|solver| solver.kind)
    }

    /// Its line in [`SOLVERS`].
    pub fn info(self) -> &'static SolverInfo {
        // The list is in the order of the kinds, which is checked below it.
        &SOLVERS[self as usize]
    }

    /// The solver with its default options.
    pub fn make(self) -> Box<dyn InterfaceSolver> {
        (self.info().make)()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_solver_is_found_by_its_name() {
        for solver in SOLVERS {
            assert_eq!(SolverKind::named(solver.name), Some(solver.kind));
        }
    }
}
