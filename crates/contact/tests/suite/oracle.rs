//! What the tests hold against the solvers: a checker of the contact conditions, and all solutions by enumeration. Neither
//! uses anything of the solvers.

use nalgebra::{DMatrix, DVector};
use stickslip_contact::state::TrialState;
use stickslip_contact::{ContactState, InterfaceProblem, Status};

pub(crate) const STATUSES: [Status; 4] = [
    Status::Open,
    Status::Stick,
    Status::SlipPositive,
    Status::SlipNegative,
];

/// The conditions of one step.
pub(crate) struct Conditions<'a> {
    problem: &'a InterfaceProblem,
    committed: &'a ContactState,
    /// Gap and tangential displacement without contact forces and rigid motions.
    free: DVector<f64>,
    mode_load: DVector<f64>,
}

/// All solutions of a step with a bound proportional to pressure.
pub(crate) struct Enumeration {
    /// Contact forces, motions and one status of each solution; solutions that meet on a border of statuses count once.
    pub(crate) solutions: Vec<TrialState>,
    /// Whether some statuses leave the solution undetermined, so that a family of solutions may be missing.
    pub(crate) singular: bool,
    /// Whether some candidate lies within rounding of a border, so that the number of solutions means little.
    pub(crate) borderline: bool,
}

impl<'a> Conditions<'a> {
    pub(crate) fn new(
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

    /// Largest violation of any condition by `trial`, relative to the largest force and the largest length in play.
    pub(crate) fn violation(&self, trial: &TrialState) -> f64 {
        let motion = &self.free
            + &*self.problem.compliance().to_matrix() * &trial.forces
            + self.problem.modes() * &trial.rigid;
        let (force_scale, length_scale) = self.scales(&trial.forces, &motion);
        let balance = self.problem.modes().tr_mul(&trial.forces) + &self.mode_load;
        let mut worst =
            ((&motion - &trial.motion).amax() / length_scale).max(if balance.is_empty() {
                0.0
            } else {
                balance.amax() / force_scale
            });
        for (k, &status) in trial.status.iter().enumerate() {
            let (normal, tangential) = (trial.forces[2 * k], trial.forces[2 * k + 1]);
            let gap = motion[2 * k];
            let slip = motion[2 * k + 1] - self.committed.tangential_displacement(k);
            let point = &self.problem.points()[k];
            let bound = self.problem.law(k).bound(
                normal / point.area,
                slip.abs(),
                &point.place,
                &self.committed.history[k],
            );
            let (stick, slipping) = (bound.stick * point.area, bound.slip * point.area);
            let parts = match status {
                Status::Open => [
                    -gap / length_scale,
                    normal.abs().max(tangential.abs()) / force_scale,
                    0.0,
                ],
                Status::Stick => [
                    gap.abs() / length_scale,
                    -normal / force_scale,
                    (slip.abs() / length_scale).max((tangential.abs() - stick) / force_scale),
                ],
                Status::SlipPositive | Status::SlipNegative => {
                    let sign = if status == Status::SlipPositive {
                        1.0
                    } else {
                        -1.0
                    };
                    [
                        gap.abs() / length_scale,
                        -normal / force_scale,
                        (-sign * slip / length_scale)
                            .max((tangential + sign * slipping).abs() / force_scale),
                    ]
                }
            };
            let parts = if point.slides {
                parts
            } else {
                [parts[0], parts[1], 0.0]
            };
            for part in parts {
                assert!(!part.is_nan());
                worst = worst.max(part);
            }
        }
        worst
    }

    fn scales(&self, forces: &DVector<f64>, motion: &DVector<f64>) -> (f64, f64) {
        let force = forces.amax().max(self.committed.forces.amax());
        let force = if self.mode_load.is_empty() {
            force
        } else {
            force.max(self.mode_load.amax())
        };
        let length = motion
            .amax()
            .max(self.free.amax())
            .max(self.committed.motion.amax());
        (force.max(f64::MIN_POSITIVE), length.max(f64::MIN_POSITIVE))
    }

    /// Tries all 4ⁿ combinations of statuses. The law's bound must be proportional to pressure.
    pub(crate) fn enumerate(&self) -> Enumeration {
        let count = self.problem.points().len();
        let mut all = Enumeration {
            solutions: Vec::new(),
            singular: false,
            borderline: false,
        };
        for code in 0..4_usize.pow(count as u32) {
            let status: Vec<Status> = (0..count).map(|k| STATUSES[code >> (2 * k) & 3]).collect();
            let Some(trial) = self.candidate(&status) else {
                all.singular = true;
                continue;
            };
            let violation = self.violation(&trial);
            all.borderline |= (1e-12..1e-6).contains(&violation);
            if violation < 1e-9 {
                let scale = self.scales(&trial.forces, &trial.motion).0;
                let known =
                    |other: &TrialState| (&other.forces - &trial.forces).amax() < 1e-7 * scale;
                if all.solutions.iter().any(known) {
                    all.borderline = true;
                } else {
                    all.solutions.push(trial);
                }
            }
        }
        all
    }

    /// The only state with these statuses, whether or not it is admissible: the equations as they stand, all of them.
    fn candidate(&self, status: &[Status]) -> Option<TrialState> {
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
                self.motion_row(
                    &mut matrix,
                    &mut side,
                    t,
                    self.committed.tangential_displacement(k),
                );
                continue;
            }
            let place = &self.problem.points()[k].place;
            let coefficient = self
                .problem
                .law(k)
                .bound(1.0, 0.0, place, &self.committed.history[k])
                .slip;
            matrix[(t, t)] = 1.0;
            matrix[(t, n)] = if status == Status::SlipPositive {
                coefficient
            } else {
                -coefficient
            };
        }
        matrix
            .view_mut((size, 0), (rigid, size))
            .copy_from(&modes.transpose());
        side.rows_mut(size, rigid).copy_from(&-&self.mode_load);
        // Rows scaled to one, so that a small pivot means dependence and not units.
        for row in 0..size + rigid {
            let largest = matrix.row(row).amax();
            if largest == 0.0 {
                return None;
            }
            matrix.row_mut(row).scale_mut(1.0 / largest);
            side[row] /= largest;
        }
        let factors = matrix.full_piv_lu();
        let pivots = factors.u().diagonal().map(f64::abs);
        if pivots.min() < 1e-10 * pivots.max() {
            return None;
        }
        let solution = factors.solve(&side)?;
        let forces = solution.rows(0, size).into_owned();
        let rigid = solution.rows(size, rigid).into_owned();
        let motion = &self.free + &*compliance * &forces + modes * &rigid;
        Some(TrialState {
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
