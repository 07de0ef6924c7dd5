//! The time that finer models may take.

use std::sync::atomic::{AtomicBool, Ordering};

use stickslip_contact::InterfaceSolver;
use stickslip_contact::solver::{FailureCause, Step, StepFailure, StepSolution, Work};
use stickslip_scene::host::Host;

/// A solver that refuses every increment once the clock of `host` is past `until` `[s]`: a model that takes longer than expected ends within one increment.
#[derive(Debug)]
pub(super) struct Limited<'a> {
    solver: &'a dyn InterfaceSolver,
    host: Host,
    until: f64,
    refused: AtomicBool,
}

impl<'a> Limited<'a> {
    pub(super) fn new(solver: &'a dyn InterfaceSolver, host: Host, until: f64) -> Self {
        Self {
            solver,
            host,
            until,
            refused: AtomicBool::new(false),
        }
    }

    /// Whether an increment was refused.
    pub(super) fn has_refused(&self) -> bool {
        self.refused.load(Ordering::Relaxed)
    }

    fn in_time(&self) -> Result<(), StepFailure> {
        if !self.has_refused() && self.host.seconds() <= self.until {
            return Ok(());
        }
        self.refused.store(true, Ordering::Relaxed);
        let (name, cause) = (self.name(), FailureCause::Stopped);
        Err(StepFailure::new(name, cause, Work::default()))
    }
}

impl InterfaceSolver for Limited<'_> {
    fn name(&self) -> &'static str {
        self.solver.name()
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        self.in_time()?;
        self.solver.solve(step)
    }

    fn try_quickly(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        self.in_time()?;
        self.solver.try_quickly(step)
    }
}
