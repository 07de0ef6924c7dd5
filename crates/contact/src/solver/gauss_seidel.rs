//! Block Gauss–Seidel (nonlinear Gauss–Seidel of contact dynamics: Jean 1999): each point in turn meets its own conditions
//! exactly, under the forces that the others have at that moment,
//!
//! ```text
//! (g, Δs)_k = A_kk λ_k + b_k,   b_k = free motion + Σ_{l≠k} A_kl λ_l + G_k α
//! ```
//!
//! which has at most four cases: open, stick, and slip to either side. Sweeps are cheap; their number grows with the number of
//! points and with μ, and for large μ they need not converge. A floating body's balance is enforced by the method of
//! multipliers (Hestenes 1969, Powell 1969): A + κ G Gᵀ stands for A, and α ← α + κ (Gᵀλ + r) after each sweep, so that no
//! trace of κ remains in the answer.

use nalgebra::{DMatrix, DVector};

use super::active_set::slip_line;
use super::attempt::Attempt;
use super::frozen::SlipLine;
use super::mixing::Mixing;
use super::residual::read_statuses;
use super::step::Step;
use super::{FailureCause, InterfaceSolver, StepFailure, StepSolution};
use crate::state::{Status, TrialState};

/// How the sequence of sweeps is sped up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Acceleration {
    /// Not at all.
    None,
    /// Anderson mixing of as many past sweeps, with restarts.
    Anderson(usize),
}

/// Block Gauss–Seidel with exact frictional solutions of the points.
#[derive(Clone, Copy, Debug)]
pub struct GaussSeidel {
    /// Acceleration of the sweeps.
    pub acceleration: Acceleration,
    /// Largest number of sweeps.
    pub limit: usize,
    /// Largest relative residual at which it stops `[1]`.
    pub tolerance: f64,
}

impl Default for GaussSeidel {
    fn default() -> Self {
        Self {
            acceleration: Acceleration::Anderson(10),
            limit: 3000,
            tolerance: 1e-10,
        }
    }
}

impl GaussSeidel {
    /// Without acceleration.
    pub fn plain() -> Self {
        Self {
            acceleration: Acceleration::None,
            ..Self::default()
        }
    }
}

impl InterfaceSolver for GaussSeidel {
    fn name(&self) -> &'static str {
        match self.acceleration {
            Acceleration::None => "Gauss-Seidel",
            Acceleration::Anderson(_) => "accelerated Gauss-Seidel",
        }
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        Attempt::run(step, self.name(), |attempt| self.run(attempt))
    }
}

impl GaussSeidel {
    fn run(&self, attempt: &mut Attempt<'_>) -> Result<StepSolution, FailureCause> {
        let step = attempt.step;
        let mut mixing = Mixing::new(match self.acceleration {
            Acceleration::None => 0,
            Acceleration::Anderson(depth) => depth,
        });
        let mut sweep = Sweep::new(step, step.matrix()?);
        let per_product = 2 * (sweep.forces.len() * sweep.forces.len()) as u64;
        for _ in 0..self.limit {
            let before = sweep.packed();
            sweep.run();
            attempt.work.sweeps += 1;
            attempt.work.operations += 2 * per_product;
            let status = read_statuses(step, &sweep.forces, &sweep.motion());
            sweep.remember_slips(&status);
            let trial = TrialState {
                forces: sweep.forces.clone(),
                motion: step.total_motion(sweep.motion()),
                rigid: sweep.rigid.clone(),
                status,
            };
            let residual = attempt.offer(&trial).largest();
            if residual <= self.tolerance {
                return attempt.accept_within(trial, self.tolerance);
            }
            if residual.is_nan() {
                return Err(FailureCause::Inaccurate {
                    violation: residual,
                });
            }
            sweep.unpack(&mixing.next(&before, sweep.packed()));
        }
        Err(FailureCause::Limit(self.limit))
    }
}

/// The iterate of the sweeps.
struct Sweep<'a> {
    step: &'a Step<'a>,
    compliance: &'a DMatrix<f64>,
    forces: DVector<f64>,
    rigid: DVector<f64>,
    /// A λ + free motion, kept up to date with the forces.
    elastic: DVector<f64>,
    /// Gᵀλ + r, likewise.
    imbalance: DVector<f64>,
    /// κ of the balance.
    weight: f64,
    /// Points that slipped once stay on their slip traction, so that a drop of the traction ends.
    slipped: Vec<bool>,
}

impl<'a> Sweep<'a> {
    fn new(step: &'a Step<'a>, compliance: &'a DMatrix<f64>) -> Self {
        let forces = DVector::zeros(2 * step.count());
        Self {
            compliance,
            elastic: step.free_motion.clone(),
            imbalance: step.mode_load.clone(),
            rigid: step.committed.rigid.clone(),
            weight: step.balance_weight(),
            slipped: vec![false; step.count()],
            forces,
            step,
        }
    }

    /// Solves every point once, and moves the bodies by what is left unbalanced.
    fn run(&mut self) {
        for k in 0..self.step.count() {
            let solved = self.local(k).solve();
            self.set(2 * k, solved[0]);
            self.set(2 * k + 1, solved[1]);
        }
        self.rigid.axpy(self.weight, &self.imbalance, 1.0);
    }

    /// Changes one force, and with it the motions.
    fn set(&mut self, row: usize, force: f64) {
        let change = force - self.forces[row];
        if change == 0.0 {
            return;
        }
        self.forces[row] = force;
        let column = self.compliance.column(row);
        self.elastic.axpy(change, &column, 1.0);
        self.elastic[row] += self.step.softness * change;
        for (sum, mode) in self
            .imbalance
            .iter_mut()
            .zip(self.step.problem.modes().row(row).iter())
        {
            *sum += change * mode;
        }
    }

    /// Motion of one row with the bodies where the weighted balance puts them.
    fn motion_of(&self, row: usize) -> f64 {
        let modes = self.step.problem.modes().row(row);
        let rigid: f64 = (modes
            .iter()
            .zip(self.rigid.iter())
            .zip(self.imbalance.iter()))
        .map(|((mode, rigid), sum)| mode * (rigid + self.weight * sum))
        .sum();
        self.elastic[row] + rigid
    }

    /// Gap and slip increment of all points.
    fn motion(&self) -> DVector<f64> {
        let mut motion = self.elastic.clone();
        motion.gemv(1.0, self.step.problem.modes(), &self.rigid, 1.0);
        motion
    }

    fn local(&self, k: usize) -> Local<'_> {
        let (n, t) = (2 * k, 2 * k + 1);
        let (compliance, modes) = (self.compliance, self.step.problem.modes());
        let entry = |row: usize, column: usize| {
            let soft = if row == column {
                self.step.softness
            } else {
                0.0
            };
            compliance[(row, column)] + soft + self.weight * modes.row(row).dot(&modes.row(column))
        };
        let now = [self.forces[n], self.forces[t]];
        let stiff = [entry(n, n), entry(n, t), entry(t, t)];
        let motion = [self.motion_of(n), self.motion_of(t)];
        Local {
            step: self.step,
            point: k,
            give: stiff,
            free: [
                motion[0] - stiff[0] * now[0] - stiff[1] * now[1],
                motion[1] - stiff[1] * now[0] - stiff[2] * now[1],
            ],
            now,
            line: slip_line(self.step, k, now[0].max(0.0), motion[1]),
            speed: motion[1].abs(),
            slipped: self.slipped[k],
        }
    }

    fn remember_slips(&mut self, status: &[Status]) {
        for (slipped, status) in self.slipped.iter_mut().zip(status) {
            *slipped |= status.slip_sign() != 0.0;
        }
    }

    /// Forces and rigid motions as one vector of forces.
    fn packed(&self) -> DVector<f64> {
        let scale = if self.weight > 0.0 { self.weight } else { 1.0 };
        let amounts = self.rigid.iter().map(|amount| amount / scale);
        DVector::from_iterator(
            self.forces.len() + self.rigid.len(),
            self.forces.iter().copied().chain(amounts),
        )
    }

    fn unpack(&mut self, packed: &DVector<f64>) {
        let size = self.forces.len();
        let scale = if self.weight > 0.0 { self.weight } else { 1.0 };
        for row in 0..size {
            self.set(row, packed[row]);
        }
        self.rigid = packed.rows(size, self.rigid.len()) * scale;
    }
}

/// The problem of one point.
struct Local<'a> {
    step: &'a Step<'a>,
    point: usize,
    /// Compliances nn, nt, tt.
    give: [f64; 3],
    /// Gap and slip increment without this point's force.
    free: [f64; 2],
    now: [f64; 2],
    line: SlipLine,
    /// |Δs| where the law was linearised.
    speed: f64,
    slipped: bool,
}

impl Local<'_> {
    /// The force that meets the point's conditions; of several the one nearest to the present one.
    fn solve(&self) -> [f64; 2] {
        let [nn, nt, tt] = self.give;
        let [gap, slip] = self.free;
        if gap >= 0.0 && self.now[0] <= 0.0 || nn <= 0.0 {
            return [0.0; 2];
        }
        if !self.step.problem.points()[self.point].slides {
            return [(-gap / nn).max(0.0), 0.0];
        }
        let mut candidates = Vec::with_capacity(4);
        if gap >= 0.0 {
            candidates.push([0.0; 2]);
        }
        let determinant = nn * tt - nt * nt;
        if determinant > 0.0 {
            let normal = (nt * slip - tt * gap) / determinant;
            let tangential = (nt * gap - nn * slip) / determinant;
            if normal >= 0.0 && tangential.abs() <= self.most_shear(normal) {
                candidates.push([normal, tangential]);
            }
        }
        let constant = self.line.constant + self.line.slip * self.speed;
        for sign in [1.0, -1.0] {
            let normal = (sign * nt * constant - gap) / (nn - sign * nt * self.line.normal);
            let tangential = -sign * (constant + self.line.normal * normal);
            let moved = nt * normal + tt * tangential + slip;
            if normal >= 0.0 && sign * tangential <= 0.0 && sign * moved >= 0.0 {
                candidates.push([normal, tangential]);
            }
        }
        let distance = |force: &[f64; 2]| (force[0] - self.now[0]).hypot(force[1] - self.now[1]);
        candidates
            .into_iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or_else(|| self.projected())
    }

    fn most_shear(&self, normal: f64) -> f64 {
        let bound = self.step.bound(self.point, normal, 0.0);
        if self.slipped {
            bound.slip
        } else {
            bound.stick
        }
    }

    /// Without a case that fits, as the law's linearisation may leave it: one component after the other.
    fn projected(&self) -> [f64; 2] {
        let [nn, nt, tt] = self.give;
        let normal = (-(self.free[0] + nt * self.now[1]) / nn).max(0.0);
        let most = self.most_shear(normal);
        let stick = if tt > 0.0 {
            -(self.free[1] + nt * normal) / tt
        } else {
            0.0
        };
        [normal, stick.clamp(-most, most)]
    }
}
