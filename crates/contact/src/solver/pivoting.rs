//! One step of Coulomb-type friction as a linear complementarity problem (Klarbring 1986), solved by pivoting.
//!
//! With the bound F = f₀ + f₁ λ_n, slip split as Δs = s⁺ − s⁻ and v = λ_t + F,
//!
//!     w = (g_n, s⁺, 2F − v),   z = (λ_n, v, s⁻),   w ≥ 0, z ≥ 0, wᵀz = 0
//!
//! Rigid motions α are free, and the balance of the floating bodies is an equation: as many λ as there are motions are
//! exchanged with their w to eliminate both. A law that is not linear in pressure, or whose slip traction lies below its
//! stick bound, is solved by repeating with new f₀, f₁; a point that slips once at its stick bound is held to its slip
//! traction from then on, so the repetition ends.

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::linalg::DenseLu;

use super::active_set::{accept, slip_line};
use super::frozen::{self, SlipLine};
use super::lemke::{Outcome, lemke};
use super::step::Step;
use super::{FailureCause, InterfaceSolver, StepFailure, StepSolution, Work};
use crate::state::Status;

/// Complementary pivoting, restarted with other covering vectors when it meets a ray.
#[derive(Clone, Copy, Debug)]
pub struct Pivoting {
    /// Largest number of pivots per complementarity problem, in multiples of its order.
    pub pivots_per_unknown: usize,
    /// Largest number of repetitions with a new linearisation of the law.
    pub repetitions: usize,
}

impl Default for Pivoting {
    fn default() -> Self {
        Self { pivots_per_unknown: 50, repetitions: 60 }
    }
}

impl InterfaceSolver for Pivoting {
    fn name(&self) -> &'static str {
        "pivoting"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let mut work = Work::default();
        self.run(step, &mut work).map_err(|cause| StepFailure::new(self.name(), cause, work))
    }
}

impl Pivoting {
    fn run(&self, step: &Step<'_>, work: &mut Work) -> Result<StepSolution, FailureCause> {
        let count = step.count();
        let mut slipped = vec![false; count];
        let mut normal = DVector::from_fn(count, |k, _| step.committed.normal_force(k).max(0.0));
        let mut slip = DVector::zeros(count);
        let mut last = FailureCause::Limit(self.repetitions);
        for _ in 0..self.repetitions {
            let bounds: Vec<SlipLine> = (0..count)
                .map(|k| {
                    if !step.problem.points()[k].slides {
                        return SlipLine::default();
                    }
                    if slipped[k] {
                        let line = slip_line(step, k, normal[k], slip[k]);
                        return SlipLine { constant: line.constant + line.slip * slip[k].abs(), slip: 0.0, ..line };
                    }
                    let bound = step.bound(k, normal[k], 0.0);
                    SlipLine { constant: bound.stick - bound.stick_dp * normal[k], normal: bound.stick_dp, slip: 0.0 }
                })
                .collect();
            let problem = Complementarity::new(step, &bounds)?;
            let Some(status) = problem.solve(self.pivots_per_unknown, &mut work.pivots) else {
                return Err(FailureCause::Ray);
            };
            work.solves += 1;
            let lines: Vec<SlipLine> = (0..count).map(|k| slip_line(step, k, normal[k], slip[k])).collect();
            let frozen = frozen::solve(step, &status, &lines)?;
            for k in 0..count {
                slipped[k] |= status[k].slip_sign() != 0.0;
                normal[k] = frozen.forces[2 * k].max(0.0);
                slip[k] = frozen.motion[2 * k + 1];
            }
            match accept(step, frozen, status, self.name(), *work) {
                Ok(solution) => return Ok(solution),
                Err(cause) => last = cause,
            }
        }
        Err(last)
    }
}

/// What a complementary pair of the reduced problem stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Normal,
    Tangent,
    Reverse,
}

struct Complementarity {
    matrix: DMatrix<f64>,
    constant: DVector<f64>,
    pairs: Vec<(Kind, usize)>,
    /// Pairs whose w and z were exchanged to eliminate the rigid motions.
    exchanged: Vec<usize>,
    count: usize,
}

impl Complementarity {
    fn new(step: &Step<'_>, bounds: &[SlipLine]) -> Result<Self, FailureCause> {
        let points = step.problem.points();
        let count = points.len();
        let frictional: Vec<usize> = (0..count)
            .filter(|&k| points[k].slides && (bounds[k].constant != 0.0 || bounds[k].normal != 0.0))
            .collect();
        let pairs: Vec<(Kind, usize)> = (0..count)
            .map(|k| (Kind::Normal, k))
            .chain(frictional.iter().map(|&k| (Kind::Tangent, k)))
            .chain(frictional.iter().map(|&k| (Kind::Reverse, k)))
            .collect();
        let n = pairs.len();
        // λ = E z + e₀ with λ_t = v − f₀ − f₁ λ_n.
        let mut e0 = DVector::zeros(2 * count);
        for &k in &frictional {
            e0[2 * k + 1] = -bounds[k].constant;
        }
        let compliance = step.problem.compliance();
        let mut response = DMatrix::zeros(2 * count, n);
        let mut balance = DMatrix::zeros(step.mode_load.len(), n);
        let modes = step.problem.modes();
        for (j, &(kind, k)) in pairs.iter().enumerate() {
            let (along_normal, along_tangent) = match kind {
                Kind::Normal if frictional.binary_search(&k).is_ok() => (1.0, -bounds[k].normal),
                Kind::Normal => (1.0, 0.0),
                Kind::Tangent => (0.0, 1.0),
                Kind::Reverse => continue,
            };
            let mut column = response.column_mut(j);
            column.axpy(along_normal, &compliance.column(2 * k), 0.0);
            column.axpy(along_tangent, &compliance.column(2 * k + 1), 1.0);
            let row = modes.row(2 * k) * along_normal + modes.row(2 * k + 1) * along_tangent;
            balance.column_mut(j).copy_from(&row.transpose());
        }
        let start = step.motion(&e0, &DVector::zeros(modes.ncols()));
        let balance_start = &step.mode_load + modes.tr_mul(&e0);

        let mut matrix = DMatrix::zeros(n, n);
        let mut constant = DVector::zeros(n);
        let mut motions = DMatrix::zeros(n, modes.ncols());
        for (i, &(kind, k)) in pairs.iter().enumerate() {
            match kind {
                Kind::Normal => {
                    matrix.row_mut(i).copy_from(&response.row(2 * k));
                    motions.row_mut(i).copy_from(&modes.row(2 * k));
                    constant[i] = start[2 * k];
                }
                Kind::Tangent => {
                    matrix.row_mut(i).copy_from(&response.row(2 * k + 1));
                    motions.row_mut(i).copy_from(&modes.row(2 * k + 1));
                    matrix[(i, i + frictional.len())] = 1.0;
                    constant[i] = start[2 * k + 1];
                }
                Kind::Reverse => {
                    matrix[(i, k)] = 2.0 * bounds[k].normal;
                    matrix[(i, i - frictional.len())] = -1.0;
                    constant[i] = 2.0 * bounds[k].constant;
                }
            }
        }
        let mut problem = Self { matrix, constant, pairs, exchanged: Vec::new(), count };
        problem.eliminate_motions(&motions, &balance, &balance_start)?;
        Ok(problem)
    }

    /// Exchanges w and z of as many pairs as there are rigid motions, chosen by pivoted elimination of their rows.
    fn eliminate_motions(
        &mut self,
        motions: &DMatrix<f64>,
        balance: &DMatrix<f64>,
        balance_start: &DVector<f64>,
    ) -> Result<(), FailureCause> {
        let m = motions.ncols();
        if m == 0 {
            return Ok(());
        }
        let chosen = pivot_rows(motions).ok_or(FailureCause::Singular)?;
        let n = self.constant.len();
        // [M_bb Ĝ_b; E_b 0] [z_b; α] = [w_b − M_bo z_o − q_b; −E_o z_o − r]
        let mut corner = DMatrix::zeros(2 * m, 2 * m);
        for (i, &row) in chosen.iter().enumerate() {
            for (j, &column) in chosen.iter().enumerate() {
                corner[(i, j)] = self.matrix[(row, column)];
            }
            for mode in 0..m {
                corner[(i, m + mode)] = motions[(row, mode)];
                corner[(m + mode, i)] = balance[(mode, row)];
            }
        }
        let corner = DenseLu::new(corner).map_err(|_| FailureCause::Singular)?;
        // Column j of `solved`: dependence of (z_b, α) on w_b (chosen) or z_o (others); the last column is the constant.
        let mut solved = DMatrix::zeros(2 * m, n + 1);
        for column in 0..=n {
            let mut side = DVector::zeros(2 * m);
            if let Some(i) = chosen.iter().position(|&row| row == column) {
                side[i] = 1.0;
            } else {
                for (i, &row) in chosen.iter().enumerate() {
                    side[i] = -if column == n { self.constant[row] } else { self.matrix[(row, column)] };
                }
                for mode in 0..m {
                    side[m + mode] = -if column == n { balance_start[mode] } else { balance[(mode, column)] };
                }
            }
            corner.solve(&mut side);
            solved.column_mut(column).copy_from(&side);
        }
        let mut into = DMatrix::zeros(n, 2 * m);
        for (i, &row) in chosen.iter().enumerate() {
            into.column_mut(i).copy_from(&self.matrix.column(row));
        }
        into.columns_mut(m, m).copy_from(motions);
        for &row in &chosen {
            self.matrix.column_mut(row).fill(0.0);
        }
        let update = into * &solved;
        self.matrix += update.columns(0, n);
        self.constant += update.column(n);
        for (i, &row) in chosen.iter().enumerate() {
            self.matrix.row_mut(row).copy_from(&solved.view((i, 0), (1, n)));
            self.constant[row] = solved[(i, n)];
        }
        self.exchanged = chosen;
        Ok(())
    }

    /// Statuses of the complementary solution; `None` if every covering vector ends on a ray.
    fn solve(&self, pivots_per_unknown: usize, pivots: &mut usize) -> Option<Vec<Status>> {
        let n = self.constant.len();
        // Scale forces and lengths so that covering vectors of ones weigh all pairs alike.
        let scale = DVector::from_fn(n, |i, _| {
            let diagonal = self.matrix[(i, i)].abs();
            if diagonal > 0.0 { 1.0 / diagonal.sqrt() } else { 1.0 }
        });
        let matrix = DMatrix::from_fn(n, n, |i, j| scale[i] * self.matrix[(i, j)] * scale[j]);
        let constant = self.constant.component_mul(&scale);
        let largest = constant.amax().max(f64::MIN_POSITIVE);
        let covers = [
            DVector::repeat(n, 1.0),
            DVector::from_fn(n, |i, _| 1.0 + constant[i].abs() / largest),
            DVector::from_fn(n, |i, _| 1.0 + ((i * 37) % 11) as f64 / 5.0),
            DVector::from_fn(n, |i, _| if constant[i] < 0.0 { 1.0 } else { 0.05 }),
        ];
        covers.iter().find_map(|cover| match lemke(&matrix, &(&constant / largest), cover, pivots_per_unknown * n, pivots) {
            Outcome::Solved(z) => Some(self.statuses(&z, &(&matrix * &z + &constant / largest))),
            Outcome::Unsolved => None,
        })
    }

    fn statuses(&self, z: &DVector<f64>, w: &DVector<f64>) -> Vec<Status> {
        let positive = |pair: usize| {
            let (mut force, mut motion) = (z[pair], w[pair]);
            if self.exchanged.contains(&pair) {
                std::mem::swap(&mut force, &mut motion);
            }
            (force > motion, motion > force)
        };
        let mut status = vec![Status::Open; self.count];
        for (pair, &(kind, k)) in self.pairs.iter().enumerate() {
            let (z_positive, w_positive) = positive(pair);
            match kind {
                Kind::Normal if z_positive => status[k] = Status::Stick,
                Kind::Tangent if status[k].touches() && w_positive => status[k] = Status::SlipPositive,
                Kind::Reverse if status[k].touches() && z_positive => status[k] = Status::SlipNegative,
                _ => {}
            }
        }
        status
    }
}

/// Rows of `motions`, one per column, that form a regular block: complete pivoting.
fn pivot_rows(motions: &DMatrix<f64>) -> Option<Vec<usize>> {
    let mut work = motions.clone();
    let mut chosen = Vec::new();
    for _ in 0..motions.ncols() {
        let (row, column) = work.iamax_full();
        let pivot = work[(row, column)];
        if pivot.abs() < 1e-12 {
            return None;
        }
        chosen.push(row);
        let pivot_row = work.row(row).into_owned();
        let factors = work.column(column) / pivot;
        work -= factors * pivot_row;
    }
    Some(chosen)
}
