//! The data of one load step.

use nalgebra::{DMatrix, DVector};
use stickslip_friction::Bound;

use crate::failure::FailureCause;
use crate::problem::InterfaceProblem;
use crate::state::{ContactState, Status, TrialState};

/// One load step: where the contact was, and the loads at its end.
#[derive(Clone, Debug)]
pub struct Step<'a> {
    /// The interface problem.
    pub problem: &'a InterfaceProblem,
    /// The last accepted state.
    pub committed: &'a ContactState,
    /// Multipliers of the load cases at the end of the step.
    pub(crate) multipliers: Vec<f64>,
    /// Gap and slip increment [length] without contact forces and rigid motions, 2n.
    pub(crate) free_motion: DVector<f64>,
    /// Resultants of the loads in the rigid motions [force], m.
    pub(crate) mode_load: DVector<f64>,
    /// Compliance [length/force] of springs between the surfaces of each point, zero but for regularised problems.
    pub(crate) softness: f64,
    /// Factor on all friction bounds, 1 but on the way of a continuation.
    pub(crate) friction: f64,
    /// Where to start from, if not from the last accepted state.
    guess: Option<Guess>,
}

/// Statuses and forces near which a solution is expected.
#[derive(Clone, Debug)]
struct Guess {
    status: Vec<Status>,
    forces: DVector<f64>,
}

impl<'a> Step<'a> {
    /// The step from `committed` to the load multipliers `multipliers` `[1]`, one per load case.
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
            multipliers: multipliers.to_vec(),
            free_motion,
            mode_load: problem.mode_load(multipliers),
            softness: 0.0,
            friction: 1.0,
            guess: None,
        }
    }

    /// Gap and slip increment `[length]` of all points without contact forces and rigid motions, interleaved, 2n.
    pub fn free_motion(&self) -> &DVector<f64> {
        &self.free_motion
    }

    /// Resultants `[force]` of the loads in the rigid motions, m.
    pub fn mode_load(&self) -> &DVector<f64> {
        &self.mode_load
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
            multipliers: self.multipliers.clone(),
            free_motion,
            mode_load: self.mode_load.clone(),
            softness: self.softness,
            friction: self.friction,
            guess: None,
        }
    }

    /// The step with springs of compliance `softness` between the surfaces, which are at rest under `forces`: penetration
    /// and slip of sticking points are `softness` times the change of force.
    pub(crate) fn softened(&self, softness: f64, forces: &DVector<f64>) -> Self {
        let mut soft = self.clone();
        soft.softness = softness;
        soft.free_motion.axpy(-softness, forces, 1.0);
        for (k, point) in self.problem.points().iter().enumerate() {
            if !point.slides {
                soft.free_motion[2 * k + 1] = self.free_motion[2 * k + 1];
            }
        }
        soft
    }

    /// The step with all friction bounds multiplied by `factor`.
    pub(crate) fn with_friction(&self, factor: f64) -> Self {
        let mut step = self.clone();
        step.friction = factor;
        step
    }

    /// The step with the part `part` of the change of load, from the same last accepted state.
    pub(crate) fn with_load(&self, part: f64) -> Self {
        let at_rest = Self::new(self.problem, self.committed, &self.committed.multipliers);
        let mut step = self.clone();
        step.free_motion *= part;
        step.free_motion.axpy(1.0 - part, &at_rest.free_motion, 1.0);
        step.mode_load *= part;
        step.mode_load.axpy(1.0 - part, &at_rest.mode_load, 1.0);
        step
    }

    /// The step, to be started from the statuses and forces of `trial`.
    #[must_use]
    pub fn near(mut self, trial: &TrialState) -> Self {
        self.guess = Some(Guess {
            status: trial.status.clone(),
            forces: trial.forces.clone(),
        });
        self
    }

    /// Multipliers of the load cases at the end of the step `[1]`.
    pub fn multipliers(&self) -> &[f64] {
        &self.multipliers
    }

    /// Number of contact points.
    pub fn count(&self) -> usize {
        self.problem.points().len()
    }

    /// Friction bound of a point as forces: values `[force]`, pressure derivatives as ∂F/∂λ_n (dimensionless), and
    /// ∂F_slip/∂|Δs| `[force/length]`.
    ///
    /// `slip_increment` `[length]` counts from the last accepted state, `normal_force` `[force]` is positive in compression.
    pub fn bound(&self, point: usize, normal_force: f64, slip_increment: f64) -> Bound {
        let at = &self.problem.points()[point];
        let stress = self.problem.law(point).bound(
            normal_force / at.area,
            slip_increment.abs(),
            &at.place,
            &self.committed.history[point],
        );
        let force = self.friction * at.area;
        Bound {
            stick: stress.stick * force,
            stick_dp: stress.stick_dp * self.friction,
            slip: stress.slip * force,
            slip_dp: stress.slip_dp * self.friction,
            slip_ds: stress.slip_ds * force,
        }
    }

    /// The largest coefficient of friction (dimensionless) of the points that touch in `trial`: the larger one of the bounds of
    /// sticking and of slipping over the normal force. Points that carry less than a hundredth of the largest normal force do not
    /// count: a law may be as steep as it likes at vanishing pressure.
    pub fn largest_coefficient(&self, trial: &TrialState) -> f64 {
        const CARRIES: f64 = 1e-2;
        let normal = |k: usize| trial.forces[2 * k];
        let largest = (0..self.count()).map(normal).fold(0.0, f64::max);
        let coefficient = |k: usize| {
            let slip = trial.motion[2 * k + 1] - self.committed.tangential_displacement(k);
            let bound = self.bound(k, normal(k), slip);
            bound.stick.max(bound.slip) / normal(k)
        };
        (0..self.count())
            .filter(|&k| trial.status[k].touches() && self.problem.points()[k].slides)
            .filter(|&k| normal(k) > CARRIES * largest)
            .map(coefficient)
            .fold(0.0, f64::max)
    }

    /// The largest coefficient of friction (dimensionless) of `points`, at the last normal forces or such as the loads make.
    pub(crate) fn coefficient_of(&self, points: &[usize]) -> f64 {
        let normal = self.starting_forces();
        let coefficient = |&k: &usize| {
            let bound = self.bound(k, normal[k], 0.0);
            let slides = self.problem.points()[k].slides;
            let force = if slides {
                bound.stick.max(bound.slip)
            } else {
                0.0
            };
            force / normal[k]
        };
        points.iter().map(coefficient).fold(0.0, f64::max)
    }

    /// Gap and slip increment `[length]` of all points under contact forces and rigid motions, interleaved, 2n.
    pub fn motion(&self, forces: &DVector<f64>, rigid: &DVector<f64>) -> DVector<f64> {
        let mut motion = self.free_motion.clone();
        self.problem.compliance().add_motion(forces, &mut motion);
        if self.softness != 0.0 {
            motion.axpy(self.softness, forces, 1.0);
        }
        motion.gemv(1.0, self.problem.modes(), rigid, 1.0);
        motion
    }

    /// Unbalanced resultants Gᵀλ + r `[force]` of floating bodies, m.
    pub(crate) fn imbalance(&self, forces: &DVector<f64>) -> DVector<f64> {
        let mut resultants = self.mode_load.clone();
        resultants.gemv_tr(1.0, self.problem.modes(), forces, 1.0);
        resultants
    }

    /// The compliance, for solvers that work on one matrix.
    ///
    /// # Errors
    /// [`FailureCause::Blocks`] where it is held in blocks.
    pub(crate) fn matrix(&self) -> Result<&'a DMatrix<f64>, FailureCause> {
        let points = self.count();
        let own = self.problem.compliance().matrix();
        own.ok_or(FailureCause::Blocks { points })
    }

    /// Compliance of the bodies and of springs between the surfaces.
    pub(crate) fn soft_compliance(&self) -> DMatrix<f64> {
        let mut compliance = self.problem.compliance().to_matrix().into_owned();
        for i in 0..compliance.nrows() {
            compliance[(i, i)] += self.softness;
        }
        compliance
    }

    /// The mean compliance of a contact component `[length/force]`; 1 where nothing gives.
    pub(crate) fn mean_compliance(&self) -> f64 {
        let diagonal = self.problem.compliance().diagonal();
        let count = diagonal.iter().filter(|&&value| value > 0.0).count();
        if count > 0 {
            diagonal.sum() / count as f64
        } else {
            1.0
        }
    }

    /// The weight κ of the balance at which κ G Gᵀ has entries of the size of the compliance.
    pub(crate) fn balance_weight(&self) -> f64 {
        let modes = self.problem.modes();
        let count = modes.row_iter().filter(|row| row.amax() > 0.0).count();
        if count > 0 {
            self.mean_compliance() * count as f64 / modes.norm_squared()
        } else {
            0.0
        }
    }

    /// The motion of a [`TrialState`] from gap and slip increment `[length]`: tangential displacements since the start.
    pub fn total_motion(&self, mut motion: DVector<f64>) -> DVector<f64> {
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
        let near = self
            .guess
            .as_ref()
            .map_or(&self.committed.forces, |guess| &guess.forces);
        (0..self.count()).map(|k| start(near[2 * k])).collect()
    }

    /// Statuses to start from.
    pub(crate) fn starting_status(&self) -> Vec<Status> {
        self.guess
            .as_ref()
            .map_or(&self.committed.status, |guess| &guess.status)
            .clone()
    }
}
