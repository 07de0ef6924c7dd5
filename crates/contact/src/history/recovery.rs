//! What failed before a load step was solved, in a form that does not grow with the number of its increments.

use crate::solver::FailureCause;

/// Attempts at the increments of a load step that failed, before another solver or a smaller increment took over.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recovery {
    /// One entry for each solver and kind of failure, in the order in which they were first met.
    pub failures: Vec<FailedAttempts>,
    /// The first cycle of statuses that was met.
    pub first_cycle: Option<Cycle>,
}

/// How often a solver failed in one way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FailedAttempts {
    /// Name of the solver.
    pub solver: &'static str,
    /// What happened, as in [`FailureCause::kind`].
    pub kind: &'static str,
    /// How often.
    pub count: usize,
}

/// Statuses that repeated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cycle {
    /// Name of the solver.
    pub solver: &'static str,
    /// Number of iterations after which the statuses return.
    pub period: usize,
    /// Contact points whose status changes within the cycle.
    pub points: Vec<usize>,
}

impl Recovery {
    /// Whether the first solver solved every increment as it stood.
    pub fn is_empty(&self) -> bool {
        self.failures.is_empty()
    }

    /// The failed attempts at one increment.
    pub fn of(attempts: &[(&'static str, FailureCause)]) -> Self {
        let mut recovery = Self::default();
        recovery.add(attempts);
        recovery
    }

    /// Counts `count` failures of `solver` in the way `kind`.
    pub(super) fn count(&mut self, solver: &'static str, kind: &'static str, count: usize) {
        let mut known = self.failures.iter_mut();
        match known.find(|entry| entry.solver == solver && entry.kind == kind) {
            Some(entry) => entry.count += count,
            None => self.failures.push(FailedAttempts {
                solver,
                kind,
                count,
            }),
        }
    }

    /// Takes over the failed attempts at one increment.
    pub(super) fn add(&mut self, attempts: &[(&'static str, FailureCause)]) {
        for (solver, cause) in attempts {
            self.count(solver, cause.kind(), 1);
            if let (None, FailureCause::Cycled { period, points }) = (&self.first_cycle, cause) {
                self.first_cycle = Some(Cycle {
                    solver,
                    period: *period,
                    points: points.clone(),
                });
            }
        }
    }

    /// Takes over what failed later.
    pub(super) fn append(&mut self, later: Self) {
        for entry in later.failures {
            self.count(entry.solver, entry.kind, entry.count);
        }
        self.first_cycle = self.first_cycle.take().or(later.first_cycle);
    }
}
