//! The data of one load step.

use nalgebra::DVector;
use stickslip_friction::Bound;

use crate::problem::InterfaceProblem;
use crate::state::{ContactState, Status};

/// One load step: where the contact was, and the loads at its end.
#[derive(Clone, Debug)]
pub struct Step<'a> {
    /// The interface problem.
    pub problem: &'a InterfaceProblem,
    /// The last accepted state.
    pub committed: &'a ContactState,
    /// Gap and slip increment [length] without contact forces and rigid motions, 2n.
    pub(crate) free_motion: DVector<f64>,
    /// Resultants of the loads in the rigid motions [force], m.
    pub(crate) mode_load: DVector<f64>,
}

impl<'a> Step<'a> {
    /// The step from `committed` to the load multipliers `multipliers` (one per load case).
    pub fn new(
        problem: &'a InterfaceProblem,
        committed: &'a ContactState,
        multipliers: &[f64],
    ) -> Self {
        let mut free_motion = problem.load_motion(multipliers);
        for (k, point) in problem.points().iter().enumerate() {
            free_motion[2 * k] += point.gap;
            free_motion[2 * k + 1] -= committed.tangential_displacement(k);
        }
        Self {
            problem,
            committed,
            free_motion,
            mode_load: problem.mode_load(multipliers),
        }
    }

    /// The same loads applied from `committed`, another state of the same problem: slip counts from its displacements, and
    /// its histories are what laws remember.
    #[must_use]
    pub fn from_state<'b>(&self, committed: &'b ContactState) -> Step<'b>
    where
        'a: 'b,
    {
        let mut free_motion = self.free_motion.clone();
        for k in 0..self.count() {
            free_motion[2 * k + 1] +=
                self.committed.tangential_displacement(k) - committed.tangential_displacement(k);
        }
        Step {
            problem: self.problem,
            committed,
            free_motion,
            mode_load: self.mode_load.clone(),
        }
    }

    /// Number of contact points.
    pub fn count(&self) -> usize {
        self.problem.points().len()
    }

    /// Friction bound of a point as forces: values [force], pressure derivatives as ∂F/∂λ_n (dimensionless), and
    /// ∂F_slip/∂|Δs| [force/length].
    pub(crate) fn bound(&self, point: usize, normal_force: f64, slip_increment: f64) -> Bound {
        let at = &self.problem.points()[point];
        let stress = self.problem.law(point).bound(
            normal_force / at.area,
            slip_increment.abs(),
            &at.place,
            &self.committed.history[point],
        );
        Bound {
            stick: stress.stick * at.area,
            slip: stress.slip * at.area,
            slip_ds: stress.slip_ds * at.area,
            ..stress
        }
    }

    /// Gap and slip increment [length] of all points under contact forces and rigid motions.
    pub(crate) fn motion(&self, forces: &DVector<f64>, rigid: &DVector<f64>) -> DVector<f64> {
        let mut motion = self.free_motion.clone();
        let compliance = self.problem.compliance();
        for (column, &force) in forces.iter().enumerate() {
            if force != 0.0 {
                motion.axpy(force, &compliance.column(column), 1.0);
            }
        }
        motion.gemv(1.0, self.problem.modes(), rigid, 1.0);
        motion
    }

    /// Tangential displacement since the start from a slip increment.
    pub(crate) fn total_motion(&self, mut motion: DVector<f64>) -> DVector<f64> {
        for k in 0..self.count() {
            motion[2 * k + 1] += self.committed.tangential_displacement(k);
        }
        motion
    }

    /// Normal force of each point to linearise the law at first: the committed one, or one of the size that the loads make.
    pub(crate) fn starting_forces(&self) -> Vec<f64> {
        let compliance = self.problem.compliance().diagonal().max();
        let blocked = if compliance > 0.0 {
            self.free_motion.amax() / compliance
        } else {
            0.0
        };
        let loads = blocked.max(self.mode_load.amax());
        let typical = if loads > 0.0 { loads } else { 1.0 };
        let start = |force: f64| if force > 0.0 { force } else { typical };
        (0..self.count())
            .map(|k| start(self.committed.normal_force(k)))
            .collect()
    }

    /// Statuses to start from: the committed ones; a point that cannot slide sticks.
    pub(crate) fn starting_status(&self) -> Vec<Status> {
        self.committed.status.clone()
    }
}
