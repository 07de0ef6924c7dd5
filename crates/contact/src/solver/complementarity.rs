//! The linear complementarity problem of one step with bounds F = μ λ_n, and its statuses by Lemke's method.
//!
//! ```text
//! w = (g_n, s⁺, 2μλ_n − v),   z = (λ_n, v, s⁻),   v = λ_t + μλ_n,   w = M z + q,  w ≥ 0, z ≥ 0, wᵀz = 0
//! ```
//!
//! Lemke's method adds z₀ d to q. It ends with a solution, and on no ray, if z = 0 alone solves the problem with q = d.
//! Here that holds for every μ if d > 0 and d_n > μ d_t: any solution has λ_t Δs ≤ 0 and λ_t ≥ −μ λ_n, so that
//!
//! ```text
//! λᵀ A λ = −Σ λ_n d_n + Σ λ_t (Δs − d_t) ≤ −Σ λ_n (d_n − μ d_t)
//! ```
//!
//! and A, positive semidefinite, leaves λ_n = 0, then λ_t = v = 0, then s⁻ = 0. Homogeneous rays (z₀ = 0) are excluded in
//! the same way where A is positive definite. So a supported body's step is always solved, up to rounding.
//!
//! Rigid motions α are held by springs, A + κ G Gᵀ, which makes the statement hold for floating bodies. The springs are
//! soft beside the bodies, and serve to find statuses only: forces are then solved from the balance itself. Where that does
//! not confirm the statuses, the springs are put at rest where they gave way to, and the problem is repeated.

use nalgebra::{DMatrix, DVector};

use super::candidate::Candidate;
use super::least_index::least_index;
use super::lemke::{Outcome, lemke, pivot_operations};
use super::step::Step;
use super::{FailureCause, Work};
use crate::state::Status;

/// Overlap of points that are left out, as a part of the largest motion, up to which they are open.
const OVERLAP: f64 = 1e-9;

/// What a complementary pair stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Normal,
    Tangent,
    Reverse,
}

/// A step with a coefficient of friction for every point, its rigid motions held by springs.
pub(super) struct Complementarity<'a> {
    step: &'a Step<'a>,
    coefficients: Vec<f64>,
    /// Compliance and free motion, springs included, relative to the largest compliance.
    sprung: Sprung,
    /// Rigid motions at which the springs are at rest.
    rest: &'a DVector<f64>,
    compliance_unit: f64,
}

/// The conditions of some of its points, the others being open: M and q in units in which the largest compliance and the largest entry of q are 1.
pub(super) struct Conditions<'a> {
    problem: &'a Complementarity<'a>,
    matrix: DMatrix<f64>,
    constant: DVector<f64>,
    pairs: Vec<(Kind, usize)>,
    force_unit: f64,
}

/// Matrix and constant of the complementarity conditions `pairs`, whose last `frictional` are those of reverse slip, after those of tangents; the normal ones come
/// first.
fn conditions(
    step: &Step<'_>,
    pairs: &[(Kind, usize)],
    frictional: usize,
    coefficients: &[f64],
    sprung: &Sprung,
) -> (DMatrix<f64>, DVector<f64>) {
    let (points, size) = (step.problem.points(), pairs.len());
    let (compliance, motion) = (&sprung.compliance, &sprung.motion);
    let mut normal = vec![0; points.len()];
    for (i, &(_, k)) in pairs[..size - 2 * frictional].iter().enumerate() {
        normal[k] = i;
    }
    let row_of = |kind, k| {
        if kind == Kind::Normal {
            2 * k
        } else {
            2 * k + 1
        }
    };
    let mut matrix = DMatrix::zeros(size, size);
    let mut constant = DVector::zeros(size);
    for (i, &(kind, k)) in pairs.iter().enumerate() {
        if kind == Kind::Reverse {
            matrix[(i, normal[k])] = 2.0 * coefficients[k];
            matrix[(i, i - frictional)] = -1.0;
            continue;
        }
        let row = row_of(kind, k);
        constant[i] = motion[row];
        for (j, &(other, l)) in pairs[..size - frictional].iter().enumerate() {
            matrix[(i, j)] = compliance[(row, row_of(other, l))];
            if other == Kind::Normal && points[l].slides {
                matrix[(i, j)] -= coefficients[l] * compliance[(row, 2 * l + 1)];
            }
        }
        if kind == Kind::Tangent {
            matrix[(i, i + frictional)] = 1.0;
        }
    }
    (matrix, constant)
}

impl<'a> Complementarity<'a> {
    /// The problem of `step` with friction coefficients `coefficients` of all points. Springs are `softness` times as
    /// compliant as the bodies, and at rest at the rigid motions `rest`.
    pub(super) fn new(
        step: &'a Step<'a>,
        coefficients: Vec<f64>,
        softness: f64,
        rest: &'a DVector<f64>,
    ) -> Self {
        let compliance_unit = positive(step.problem.compliance().diagonal().max());
        Self {
            step,
            coefficients,
            sprung: Sprung::new(step, compliance_unit, softness, rest),
            rest,
            compliance_unit,
        }
    }

    /// The conditions of `chosen` points, which ascend.
    pub(super) fn among(&self, chosen: &[usize]) -> Conditions<'_> {
        let points = self.step.problem.points();
        let rubs = |k: &&usize| points[**k].slides && self.coefficients[**k] > 0.0;
        let frictional: Vec<usize> = chosen.iter().filter(rubs).copied().collect();
        let of = |kind: Kind| move |&k: &usize| (kind, k);
        let pairs: Vec<(Kind, usize)> = (chosen.iter().map(of(Kind::Normal)))
            .chain(frictional.iter().map(of(Kind::Tangent)))
            .chain(frictional.iter().map(of(Kind::Reverse)))
            .collect();
        let rows = frictional.len();
        let (matrix, mut constant) =
            conditions(self.step, &pairs, rows, &self.coefficients, &self.sprung);
        let force_unit = positive(constant.amax());
        constant /= force_unit;
        Conditions {
            problem: self,
            matrix,
            constant,
            pairs,
            force_unit,
        }
    }
}

impl Conditions<'_> {
    /// Number of complementary pairs.
    pub(super) fn order(&self) -> usize {
        self.constant.len()
    }

    /// The solution found with covering vector number `cover` in at most `limit` pivots.
    pub(super) fn solve(
        &self,
        cover: usize,
        limit: usize,
        work: &mut Work,
    ) -> Result<Candidate, FailureCause> {
        match lemke(
            &self.matrix,
            &self.constant,
            &self.cover(cover),
            limit,
            work,
        ) {
            Outcome::Solved(z) => Ok(self.candidate(&z)),
            Outcome::Ray => Err(FailureCause::Ray),
            Outcome::Limit => {
                let operations = limit as u64 * pivot_operations(self.order());
                Err(FailureCause::Effort {
                    operations,
                    limit: operations,
                })
            }
        }
    }

    /// The solution found by least-index principal pivoting, or the statuses where that ended and why.
    pub(super) fn solve_by_least_index(
        &self,
        pivots_per_unknown: usize,
        work: &mut Work,
    ) -> (Candidate, Result<(), FailureCause>) {
        let limit = pivots_per_unknown * self.constant.len();
        let (z, outcome) = least_index(&self.matrix, &self.constant, limit, work);
        let outcome = outcome.map_err(|cause| match cause {
            FailureCause::Cycled { period, points } => {
                let mut points: Vec<usize> =
                    points.iter().map(|&pair| self.pairs[pair].1).collect();
                points.sort_unstable();
                points.dedup();
                FailureCause::Cycled { period, points }
            }
            other => other,
        });
        (self.candidate(&z), outcome)
    }

    /// A covering vector with d > 0 and d_n > μ d_t; each number gives another.
    fn cover(&self, number: usize) -> DVector<f64> {
        DVector::from_fn(self.pairs.len(), |i, _| {
            let (kind, k) = self.pairs[i];
            // Deterministic, between 1 and 2, and 1 throughout for the first.
            let variation = 1.0 + ((i * 37 * number) % 11) as f64 / 11.0;
            match kind {
                Kind::Normal | Kind::Reverse => variation,
                Kind::Tangent => 0.25 * variation / self.problem.coefficients[k].max(1.0),
            }
        })
    }

    fn candidate(&self, z: &DVector<f64>) -> Candidate {
        let problem = self.problem;
        let (coefficients, step) = (&problem.coefficients, problem.step);
        let points = step.problem.points();
        let count = points.len();
        let w = &self.matrix * z + &self.constant;
        let mut status = vec![Status::Open; count];
        let mut forces = DVector::zeros(2 * count);
        for (pair, &(kind, k)) in self.pairs.iter().enumerate() {
            match kind {
                Kind::Normal => {
                    forces[2 * k] = self.force_unit * z[pair];
                    if points[k].slides {
                        forces[2 * k + 1] = -coefficients[k] * forces[2 * k];
                    }
                    if z[pair] > w[pair] {
                        status[k] = Status::Stick;
                    }
                }
                Kind::Tangent => {
                    forces[2 * k + 1] += self.force_unit * z[pair];
                    if status[k].touches() && w[pair] > z[pair] {
                        status[k] = Status::SlipPositive;
                    }
                }
                Kind::Reverse if status[k].touches() && z[pair] > w[pair] => {
                    status[k] = Status::SlipNegative;
                }
                Kind::Reverse => {}
            }
        }
        let sprung = &problem.sprung;
        let motion = (&sprung.compliance * &forces + &sprung.motion) * problem.compliance_unit;
        let give = sprung.spring * problem.compliance_unit;
        let modes = step.problem.modes();
        let rigid = problem.rest + (modes.tr_mul(&forces) + &step.mode_load) * give;
        for k in 0..count {
            if status[k].touches() && points[k].slides && coefficients[k] == 0.0 {
                status[k] = Status::slip_along(motion[2 * k + 1]);
            }
        }
        let depth = OVERLAP * motion.amax();
        let mut is_chosen = vec![false; count];
        self.pairs.iter().for_each(|&(_, k)| is_chosen[k] = true);
        let overlaps = |k: &usize| !is_chosen[*k] && motion[2 * k] < -depth;
        Candidate {
            overlapping: (0..count).filter(overlaps).collect(),
            status,
            normal: (0..count).map(|k| forces[2 * k]).collect(),
            slip: (0..count).map(|k| motion[2 * k + 1]).collect(),
            rigid,
        }
    }
}

/// Compliance and free motion with springs on the rigid motions, in units of a compliance `[length/force]`.
struct Sprung {
    compliance: DMatrix<f64>,
    motion: DVector<f64>,
    /// κ of the springs in the same unit.
    spring: f64,
}

impl Sprung {
    fn new(step: &Step<'_>, unit: f64, softness: f64, rest: &DVector<f64>) -> Self {
        let modes = step.problem.modes();
        let spring = softness / positive(modes.amax().powi(2));
        let mut compliance = step.soft_compliance() / unit;
        let mut motion = &step.free_motion / unit;
        if modes.ncols() > 0 {
            compliance.gemm(spring, modes, &modes.transpose(), 1.0);
            motion.gemv(spring, modes, &step.mode_load, 1.0);
            motion.gemv(1.0 / unit, modes, rest, 1.0);
        }
        Self {
            compliance,
            motion,
            spring,
        }
    }
}

fn positive(value: f64) -> f64 {
    if value > 0.0 { value } else { 1.0 }
}
