//! The conditions of one step as they stand: a checker, and all solutions by enumeration.
//!
//! ```text
//! (g, s) = d + A λ + G α,   Gᵀ λ + r = 0
//! open:  λ = 0, g ≥ 0      stick:  g = 0, s = s_last, |λ_t| ≤ F      slip ±:  g = 0, λ_t = ∓F, ±(s − s_last) ≥ 0
//! ```

use nalgebra::{DMatrix, DVector};
use stickslip_contact::state::TrialState;
use stickslip_contact::{ContactState, InterfaceProblem, Status};

use super::STATUSES;

/// Relative violation up to which a candidate is a solution. Problems of a few points have residuals near 1e-15 times their
/// condition, which the candidates' pivots limit to 1e10 times smaller pivots.
const SOLUTION: f64 = 1e-9;
/// Violations between these leave open whether a candidate is a solution.
const BORDER: std::ops::Range<f64> = 1e-12..1e-6;
/// Relative difference of the forces of two solutions.
const DISTINCT: f64 = 1e-7;
/// Smallest over largest pivot from which statuses determine their solution.
const REGULAR: f64 = 1e-10;
/// Least residual of a singular system, relative to its right side and solution, from which it contradicts itself.
const CONTRADICTION: f64 = 1e-7;

/// The conditions of one step.
pub(super) struct Conditions<'a> {
    problem: &'a InterfaceProblem,
    committed: &'a ContactState,
    /// Gap and tangential displacement without contact forces and rigid motions.
    free: DVector<f64>,
    mode_load: DVector<f64>,
}

/// All solutions of a step with a bound proportional to pressure.
#[derive(Clone, Debug, PartialEq)]
pub struct Enumeration {
    /// The solutions, with one status of each; solutions that meet on a border of statuses count once.
    pub states: Vec<TrialState>,
    /// Whether some candidate lies within rounding of a border, so that the number of solutions means little.
    pub borderline: bool,
    /// Whether some statuses leave the solution undetermined, so that a family of solutions may be missing. Statuses whose
    /// equations contradict each other, as those of a floating body that nothing touches under a load, do not count.
    pub singular: bool,
}

/// What the equations of given statuses have.
enum Candidate {
    /// One solution, admissible or not.
    Only(TrialState),
    /// Many.
    Family,
    /// None.
    Contradiction,
}

/// Solutions of a linear system.
enum Solutions {
    One(DVector<f64>),
    Many,
    None,
}

impl<'a> Conditions<'a> {
    pub(super) fn new(
        problem: &'a InterfaceProblem,
        committed: &'a ContactState,
        multipliers: &[f64],
    ) -> Self {
        let mut free = problem.load_motion(multipliers);
        for (k, point) in problem.points().iter().enumerate() {
            free[2 * k] += point.gap;
        }
        Self {
            problem,
            committed,
            free,
            mode_load: problem.mode_load(multipliers),
        }
    }

    /// Largest violation of any equation or condition by `trial`; infinite if that is not a number.
    pub(super) fn violation(&self, trial: &TrialState) -> f64 {
        let motion = &self.free
            + &*self.problem.compliance().to_matrix() * &trial.forces
            + self.problem.modes() * &trial.rigid;
        let [force, length] = self.scales(&trial.forces, &motion);
        let balance = self.problem.modes().tr_mul(&trial.forces) + &self.mode_load;
        let balance = balance.iter().map(|resultant| resultant.abs() / force);
        let equations = (&motion - &trial.motion).amax() / length;
        let points =
            (0..trial.status.len()).map(|k| self.violation_at(k, trial, &motion, force, length));
        let worst = balance
            .chain([equations])
            .chain(points)
            .fold(0.0, |worst: f64, part| {
                if part.is_nan() {
                    f64::INFINITY
                } else {
                    worst.max(part)
                }
            });
        if worst.is_finite() {
            worst
        } else {
            f64::INFINITY
        }
    }

    fn violation_at(
        &self,
        k: usize,
        trial: &TrialState,
        motion: &DVector<f64>,
        force: f64,
        length: f64,
    ) -> f64 {
        let (normal, tangential) = (trial.forces[2 * k], trial.forces[2 * k + 1]);
        let gap = motion[2 * k] / length;
        let slip = motion[2 * k + 1] - self.committed.tangential_displacement(k);
        let point = &self.problem.points()[k];
        let bound = self.problem.law(k).bound(
            normal / point.area,
            slip.abs(),
            &point.place,
            &self.committed.history[k],
        );
        let status = trial.status[k];
        let (ordinary, friction) = match status {
            Status::Open => ([-gap, normal.abs() / force], tangential.abs() / force),
            Status::Stick => (
                [gap.abs(), -normal / force],
                (slip.abs() / length).max((tangential.abs() - bound.stick * point.area) / force),
            ),
            Status::SlipPositive | Status::SlipNegative => {
                let sign = status.slip_sign();
                (
                    [gap.abs(), -normal / force],
                    (-sign * slip / length)
                        .max((tangential + sign * bound.slip * point.area).abs() / force),
                )
            }
        };
        let friction = if point.slides { friction } else { 0.0 };
        // A sum keeps a NaN, which `max` would drop.
        let sum = ordinary[0] + ordinary[1] + friction;
        if sum.is_nan() {
            sum
        } else {
            ordinary[0].max(ordinary[1]).max(friction)
        }
    }

    /// Largest force and largest length in play.
    fn scales(&self, forces: &DVector<f64>, motion: &DVector<f64>) -> [f64; 2] {
        let largest = |parts: [&DVector<f64>; 3]| {
            let sizes = parts.into_iter().flat_map(|part| part.iter());
            sizes.fold(f64::MIN_POSITIVE, |most, value| most.max(value.abs()))
        };
        [
            largest([forces, &self.committed.forces, &self.mode_load]),
            largest([motion, &self.free, &self.committed.motion]),
        ]
    }

    /// Tries all 4ⁿ combinations of statuses. The law's bound must be proportional to pressure.
    pub(super) fn enumerate(&self) -> Enumeration {
        let count = self.problem.points().len();
        let mut all = Enumeration {
            states: Vec::new(),
            singular: false,
            borderline: false,
        };
        for code in 0..4_usize.pow(count as u32) {
            let status: Vec<Status> = (0..count).map(|k| STATUSES[code >> (2 * k) & 3]).collect();
            let trial = match self.candidate(&status) {
                Candidate::Only(trial) => trial,
                Candidate::Family => {
                    all.singular = true;
                    continue;
                }
                Candidate::Contradiction => continue,
            };
            let violation = self.violation(&trial);
            all.borderline |= BORDER.contains(&violation);
            if violation < SOLUTION {
                let [scale, _] = self.scales(&trial.forces, &trial.motion);
                let known =
                    |other: &TrialState| (&other.forces - &trial.forces).amax() < DISTINCT * scale;
                if all.states.iter().any(known) {
                    all.borderline = true;
                } else {
                    all.states.push(trial);
                }
            }
        }
        all
    }

    /// The state with these statuses, whether or not it is admissible.
    fn candidate(&self, status: &[Status]) -> Candidate {
        let (compliance, modes) = (self.problem.compliance().to_matrix(), self.problem.modes());
        let (size, rigid) = (compliance.nrows(), modes.ncols());
        let mut matrix = DMatrix::zeros(size + rigid, size + rigid);
        let mut side = DVector::zeros(size + rigid);
        for (k, &status) in status.iter().enumerate() {
            let (n, t) = (2 * k, 2 * k + 1);
            if status == Status::Open {
                matrix[(n, n)] = 1.0;
                matrix[(t, t)] = 1.0;
                continue;
            }
            self.motion_row(&mut matrix, &mut side, n, 0.0);
            if status == Status::Stick {
                let last = self.committed.tangential_displacement(k);
                self.motion_row(&mut matrix, &mut side, t, last);
                continue;
            }
            let place = &self.problem.points()[k].place;
            let law = self.problem.law(k);
            let coefficient = law.bound(1.0, 0.0, place, &self.committed.history[k]).slip;
            matrix[(t, t)] = 1.0;
            matrix[(t, n)] = status.slip_sign() * coefficient;
        }
        matrix
            .view_mut((size, 0), (rigid, size))
            .copy_from(&modes.transpose());
        side.rows_mut(size, rigid).copy_from(&-&self.mode_load);
        let solution = match solve(matrix, side) {
            Solutions::One(solution) => solution,
            Solutions::Many => return Candidate::Family,
            Solutions::None => return Candidate::Contradiction,
        };
        let forces = solution.rows(0, size).into_owned();
        let rigid = solution.rows(size, rigid).into_owned();
        let motion = &self.free + &*compliance * &forces + modes * &rigid;
        Candidate::Only(TrialState {
            forces,
            motion,
            rigid,
            status: status.to_vec(),
        })
    }

    /// Motion of row `row` equal to `target`.
    fn motion_row(
        &self,
        matrix: &mut DMatrix<f64>,
        side: &mut DVector<f64>,
        row: usize,
        target: f64,
    ) {
        let size = self.free.len();
        matrix
            .view_mut((row, 0), (1, size))
            .copy_from(&self.problem.compliance().to_matrix().row(row));
        let modes = self.problem.modes().row(row);
        matrix
            .view_mut((row, size), (1, modes.ncols()))
            .copy_from(&modes);
        side[row] = target - self.free[row];
    }
}

/// Rows are scaled to one, so that a small pivot means dependence and not units.
fn solve(mut matrix: DMatrix<f64>, mut side: DVector<f64>) -> Solutions {
    for row in 0..matrix.nrows() {
        let largest = matrix.row(row).amax();
        if largest > 0.0 {
            matrix.row_mut(row).scale_mut(1.0 / largest);
            side[row] /= largest;
        }
    }
    let factors = matrix.clone().full_piv_lu();
    let pivots = factors.u().diagonal().map(f64::abs);
    if pivots.min() >= REGULAR * pivots.max() {
        return factors.solve(&side).map_or(Solutions::Many, Solutions::One);
    }
    // A decomposition that was computed with both of its sides solves.
    let Ok(closest) = matrix.clone().svd(true, true).solve(&side, REGULAR) else {
        return Solutions::Many;
    };
    let scale = side.amax().max(closest.amax());
    if (&matrix * closest - side).amax() > CONTRADICTION * scale {
        Solutions::None
    } else {
        Solutions::Many
    }
}
