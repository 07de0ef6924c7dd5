//! Why a step was not solved, what was spent on it, and how near the best state came.
//!
//! These types do not depend on a problem or a solver: errors of histories carry the values that a solver returned.

use thiserror::Error;

use crate::state::TrialState;

/// What a solver did, each in its own units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Interface solves with frozen statuses, the confirming one included.
    pub solves: usize,
    /// Complementary pivots.
    pub pivots: usize,
    /// Sweeps over all contact points.
    pub sweeps: usize,
    /// Updates of friction bounds or multipliers by an outer iteration.
    pub updates: usize,
    /// Factorisations: dense ones of the interface, or sparse ones of whole bodies where a solver works on these.
    pub factorisations: usize,
    /// Floating-point operations of the dominant kernels (factorisations, pivots, products with the compliance).
    pub operations: u64,
}

impl std::ops::AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        self.solves += other.solves;
        self.pivots += other.pivots;
        self.sweeps += other.sweeps;
        self.updates += other.updates;
        self.factorisations += other.factorisations;
        self.operations += other.operations;
    }
}

/// Largest violations of the conditions of a step, each relative to its own scale: forces to the largest contact force or
/// load resultant, lengths to the largest motion of a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Residuals {
    /// Penetration, tension, gaps of touching points, and forces on open ones `[1]`.
    pub complementarity: f64,
    /// Tangential force beyond the bound, slip along the force, and slip of sticking points `[1]`.
    pub cone: f64,
    /// Unbalanced resultants of floating bodies `[1]`.
    pub balance: f64,
}

impl Residuals {
    /// The largest of the three `[1]`; NaN if one is.
    pub fn largest(&self) -> f64 {
        // `max` would drop a NaN; a sum keeps it.
        let sum = self.complementarity + self.cone + self.balance;
        if sum.is_nan() {
            f64::NAN
        } else {
            self.complementarity.max(self.cone).max(self.balance)
        }
    }

    /// The larger ones of both; what is no number stays.
    #[must_use]
    pub fn worse(self, other: Self) -> Self {
        let worse = |a: f64, b: f64| if a.is_nan() || a > b { a } else { b };
        Self {
            complementarity: worse(self.complementarity, other.complementarity),
            cone: worse(self.cone, other.cone),
            balance: worse(self.balance, other.balance),
        }
    }
}

/// Why a solver did not solve a step.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum FailureCause {
    /// The statuses repeat.
    #[error("the statuses of {} points repeat with period {period}", points.len())]
    Cycled {
        /// Number of iterations after which the statuses return.
        period: usize,
        /// Points whose status changes within the cycle.
        points: Vec<usize>,
    },
    /// The iteration limit was reached.
    #[error("not converged after {0} iterations")]
    Limit(usize),
    /// The interface matrix of the current statuses is singular.
    #[error("the interface matrix of the current statuses is singular")]
    Singular,
    /// Pivoting ended on a ray, which proves nothing for friction.
    #[error("complementary pivoting ended on a ray")]
    Ray,
    /// A candidate does not meet the conditions.
    #[error("the candidate violates the contact conditions by {violation:.1e} of their scale")]
    Inaccurate {
        /// Largest relative violation `[1]`.
        violation: f64,
    },
    /// No combination of statuses meets the conditions.
    #[error("none of {combinations} combinations of statuses meets the contact conditions{}", if *proved { " (proved)" } else { "" })]
    NoSolution {
        /// Number of combinations.
        combinations: usize,
        /// Whether that is a proof: a body floats, the law is linear within the step, and every combination has one solution
        /// that misses the conditions by far more than rounding.
        proved: bool,
    },
    /// The problem is too large for enumeration.
    #[error("{points} points are more than {limit}")]
    TooManyPoints {
        /// Number of points.
        points: usize,
        /// Largest number that is tried.
        limit: usize,
    },
    /// The compliance is held in blocks, and the solver works on one matrix.
    #[error("it needs one compliance matrix, but that of {points} points is held in blocks")]
    Blocks {
        /// Number of points.
        points: usize,
    },
    /// The work that is given to a search was done.
    #[error(
        "given up after {operations:.1e} floating-point operations, of {limit:.1e} that it may take"
    )]
    Effort {
        /// Operations done.
        operations: u64,
        /// Operations that the search may take.
        limit: u64,
    },
    /// The time for the step is spent.
    #[error("stopped, because the time is spent")]
    Stopped,
    /// Contact on the deformed geometry does not settle.
    #[error(
        "contact on the deformed geometry changes by {change:.1e} of its scale after {passes} passes"
    )]
    Geometry {
        /// Passes made.
        passes: usize,
        /// Change of a gap relative to the largest motion, or of a normal `[rad]`, in the last one.
        change: f64,
    },
    /// A contact point faces no place on the deformed second edge.
    #[error("contact point {point} faces no place on the deformed edge of the second body")]
    Unfaced {
        /// Index of the point.
        point: usize,
    },
    /// Bodies have moved so far along each other that the closest points are not known well.
    #[error(
        "closest points of the deformed edges are known to {error:.1e} of the motion of points, more than {limit:.0e}: bodies moved too far along \
         each other"
    )]
    Apart {
        /// Error relative to the largest motion `[1]`.
        error: f64,
        /// The largest that is accepted `[1]`.
        limit: f64,
    },
    /// A floating body's load cannot be balanced: a rigid motion along which the load works separates, or slides along,
    /// every contact.
    #[error("the load cannot be balanced: nothing stops a rigid motion on which {}it does work{}", of(*part), if *proved { " (proved)" } else { "" })]
    Unbalanced {
        /// The part of the load that works along it `[1]`, translations and rotations alike by what they move points: below [`ROUNDED`](Self::ROUNDED) where coordinates or directions
        /// have too few digits.
        part: f64,
        /// The rigid motion α that begins, one number per mode, in the units of [`InterfaceProblem::modes`](crate::InterfaceProblem::modes).
        motion: Vec<f64>,
        /// Whether there is a proof (Farkas): a motion that differs from this one by the lift of sliding points, against which no admissible contact force works, whatever the points remember
        /// of slip.
        proved: bool,
    },
}

/// "1e-8 of " a load, where that is little.
fn of(part: f64) -> String {
    if part < FailureCause::ROUNDED {
        format!("{part:.0e} of ")
    } else {
        String::new()
    }
}

impl FailureCause {
    /// Part of a load `[1]` below which it is out of balance because numbers were rounded, most likely.
    pub const ROUNDED: f64 = 1e-6;

    /// What kind of failure it is, in a word or two.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Cycled { .. } => "cycled",
            Self::Limit(_) => "iteration limit",
            Self::Singular => "singular matrix",
            Self::Ray => "ray",
            Self::Inaccurate { .. } => "inaccurate",
            Self::NoSolution { .. } => "no solution among all statuses",
            Self::TooManyPoints { .. } => "too many points",
            Self::Blocks { .. } => "compliance in blocks",
            Self::Effort { .. } => "work limit",
            Self::Stopped => "stopped",
            Self::Geometry { .. } => "unsettled geometry",
            Self::Unfaced { .. } => "no closest point",
            Self::Apart { .. } => "closest points too far",
            Self::Unbalanced { .. } => "no balance",
        }
    }
}

/// A step that was not solved: what each solver said, the work spent, and the state that came closest.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("{}{}", reasons(attempts), best_residual(best.as_deref()))]
pub struct StepFailure {
    /// Each solver that was tried, with its reason.
    pub attempts: Vec<(&'static str, FailureCause)>,
    /// Work of all of them.
    pub work: Work,
    /// The state that met the conditions best, if a solver has one: no solution, and committed only where cut-back ends and it nearly meets them.
    pub best: Option<Box<Unresolved>>,
}

/// The best state of a step that no solver solved.
#[derive(Clone, Debug, PartialEq)]
pub struct Unresolved {
    /// The solver that found it.
    pub solver: &'static str,
    /// The state.
    pub trial: TrialState,
    /// How far it is from meeting the conditions.
    pub residuals: Residuals,
}

fn reasons(attempts: &[(&'static str, FailureCause)]) -> String {
    let reason = |(solver, cause): &(&'static str, FailureCause)| format!("{solver}: {cause}");
    attempts.iter().map(reason).collect::<Vec<_>>().join("; ")
}

fn best_residual(best: Option<&Unresolved>) -> String {
    best.map_or_else(String::new, |state| {
        let residual = state.residuals.largest();
        format!("; the best state violates the contact conditions by {residual:.1e} of their scale")
    })
}

impl StepFailure {
    /// The failure of one solver after `work`, without a state.
    pub fn new(solver: &'static str, cause: FailureCause, work: Work) -> Self {
        Self {
            attempts: vec![(solver, cause)],
            work,
            best: None,
        }
    }

    /// Whether the time for the step was spent, so that nothing is known of its solution.
    pub fn is_stopped(&self) -> bool {
        let mut attempts = self.attempts.iter();
        attempts.any(|(_, cause)| *cause == FailureCause::Stopped)
    }

    /// The same failure with a state that came close; the better one is kept.
    #[must_use]
    pub fn with_best(mut self, candidate: Option<Box<Unresolved>>) -> Self {
        if let Some(candidate) = candidate
            && candidate.residuals.largest().is_finite()
            && self
                .best
                .as_ref()
                .is_none_or(|best| candidate.residuals.largest() < best.residuals.largest())
        {
            self.best = Some(candidate);
        }
        self
    }

    /// Whether the step is left open: no solution was found, and none was proved not to exist.
    pub fn is_unresolved(&self) -> bool {
        !self.attempts.iter().any(|(_, cause)| {
            matches!(
                cause,
                FailureCause::Unbalanced { proved: true, .. }
                    | FailureCause::NoSolution { proved: true, .. }
            )
        })
    }

    /// Whether the load at the end of the step was proved to have no balance, whatever the contact points remember of slip, so
    /// that no smaller increments reach it.
    pub fn is_proved_impossible(&self) -> bool {
        self.attempts
            .iter()
            .any(|(_, cause)| matches!(cause, FailureCause::Unbalanced { proved: true, .. }))
    }
}
