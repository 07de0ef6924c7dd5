//! The conventional path: the whole finite-element system, factorised anew in every contact iteration.
//!
//! Unknown are the displacements u of all bodies together with the contact forces λ and the rigid motions α. For given
//! statuses, with the relative motion B u + G α + d of the contact points (d: initial gaps, prescribed motion, and what had
//! slipped before),
//!
//! ```text
//! K u − Bᵀ λ = f                                                   every unknown
//! (B u + G α + d)_n = 0   touching,      λ_n = 0   open             every point
//! (B u + G α + d)_t = 0   sticking,      λ_t = 0   open
//! λ_t + σ f₁ λ_n + f₂ (B u + G α + d)_t = −σ f₀   slipping
//! Gᵀ λ + r = 0                                                     every rigid motion
//! ```
//!
//! which is one step of the semismooth Newton method (Alart & Curnier 1991) as general finite-element codes take it. The
//! statuses are corrected by the very rules of [`SemismoothNewton`], so both paths go through the same iterations and differ
//! in what one of them costs. The matrix is unsymmetric because of friction and is factorised by sparse LU.
//!
//! In favour of this path: the stiffness of the bodies is assembled once and not in every iteration, contact is searched
//! once, and the column order and symbolic analysis are made once for all iterations, on a pattern that holds the contact
//! rows of every status. Against it: the sparse LU at hand costs about five Cholesky factorisations of the same bodies, where
//! general codes with a multifrontal solver pay three to four.

mod pattern;

use nalgebra::DVector;
use stickslip::run::Operator;
use stickslip_contact::solver::{
    FailureCause, FreeMotions, Frozen, FrozenSystem, SlipLine, Step, StepFailure, StepSolution,
    Work,
};
use stickslip_contact::{InterfaceProblem, InterfaceSolver, SemismoothNewton, Status};
use stickslip_fem_core::CondensedBody;
use stickslip_fem_core::linalg::{FactorError, LuStructure, SparseLu, SparseMatrix};
use thiserror::Error;

use pattern::{Coefficients, Pattern, contact_coefficients, relative_motion};

/// Why the whole system cannot be set up.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ConventionalError {
    /// Its factor does not fit in memory.
    #[error(transparent)]
    Factor(#[from] FactorError),
    /// Contact is to be found on the deformed geometry.
    #[error(
        "the conventional path finds contact on the undeformed geometry: say analysis.kinematics = \"small\""
    )]
    DeformedGaps,
    /// A mean displacement is held, which the matrix of nodes does not have.
    #[error("the conventional path holds no sections: hold a point, or an edge")]
    HeldSection,
    /// The problem was made for other bodies.
    #[error("the problem has {expected} rigid motions, the bodies have {found}")]
    OtherBodies {
        /// Of the problem.
        expected: usize,
        /// Of the bodies.
        found: usize,
    },
}

/// How the conventional path iterates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Largest number of contact iterations in a step.
    pub limit: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            limit: SemismoothNewton::default().limit,
        }
    }
}

/// Newton's method on the whole finite-element system. One solver belongs to the problem that it was made for.
#[derive(Debug)]
pub struct ConventionalNewton {
    system: WholeSystem,
    settings: Settings,
}

impl ConventionalNewton {
    /// Assembles the bodies' stiffness and analyses the structure of the whole system.
    ///
    /// `operators` are the bodies of `problem`, in its order.
    ///
    /// # Errors
    /// [`ConventionalError::OtherBodies`], [`ConventionalError::HeldSection`], [`ConventionalError::Factor`] if the structure does not fit in memory.
    pub fn new(
        operators: &[Operator],
        problem: &InterfaceProblem,
        settings: Settings,
    ) -> Result<Self, ConventionalError> {
        let found = operators
            .iter()
            .map(|operator| operator.interface().modes().ncols())
            .sum();
        let expected = problem.modes().ncols();
        if found != expected {
            return Err(ConventionalError::OtherBodies { expected, found });
        }
        let mut elastic = operators.iter().filter_map(Operator::elastic);
        if elastic.any(|body| body.body().has_section()) {
            return Err(ConventionalError::HeldSection);
        }
        Ok(Self {
            system: WholeSystem::new(operators, problem)?,
            settings,
        })
    }

    /// Number of unknowns: displacements, contact forces and rigid motions.
    pub fn unknowns(&self) -> usize {
        self.system.matrix.order()
    }

    /// Stored entries of the matrix.
    pub fn entries(&self) -> usize {
        self.system.matrix.rows.len()
    }
}

impl InterfaceSolver for ConventionalNewton {
    fn name(&self) -> &'static str {
        "conventional Newton"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let rules = SemismoothNewton {
            limit: self.settings.limit,
        };
        rules.solve_with(step, &self.system, self.name())
    }
}

/// A part of the load on the unknowns and of the prescribed motion of the contact points, by one load case.
#[derive(Debug)]
struct CaseLoad {
    /// `[force]`, one per displacement unknown.
    forces: Vec<f64>,
    /// Relative motion `[length]`, 2n.
    motion: DVector<f64>,
}

#[derive(Debug)]
struct WholeSystem {
    /// Bodies and reactions filled in; contact rows and balance empty.
    matrix: SparseMatrix,
    structure: LuStructure,
    /// Displacement unknowns.
    displacements: usize,
    contact: Vec<ContactRow>,
    /// Position of each rigid motion's balance: contact forces 2n, then rigid motions m.
    balance: Vec<Vec<usize>>,
    cases: Vec<CaseLoad>,
    /// A stiffness `[force/length]` by which contact forces and conditions are scaled, so that pivots compare like with like.
    scale: f64,
    operations: u64,
}

/// The condition on one component of one point's relative motion: where its coefficients stand in the matrix.
#[derive(Debug, Default)]
struct ContactRow {
    /// Displacement unknown, its coefficient in B, and its position.
    displacements: Vec<(usize, f64, usize)>,
    /// Position for each rigid motion.
    rigid: Vec<usize>,
    /// Position for the point's own force in this direction.
    own: usize,
    /// Position for its normal force, in the row of the tangential one.
    normal: Option<usize>,
}

impl WholeSystem {
    fn new(operators: &[Operator], problem: &InterfaceProblem) -> Result<Self, FactorError> {
        let bodies: Vec<Option<&CondensedBody>> = operators.iter().map(Operator::elastic).collect();
        let mut first = vec![0];
        for body in &bodies {
            let unknowns = body.map_or(0, |body| body.structure().unknowns());
            first.push(first[first.len() - 1] + unknowns);
        }
        let displacements = first[bodies.len()];
        let rows = contact_coefficients(&bodies, &first, problem);
        let mut pattern = Pattern::new(displacements, problem);
        let (mut scale, mut operations) = (0.0_f64, 0);
        for (body, &start) in bodies.iter().zip(&first) {
            if let Some(body) = body {
                scale = scale.max(pattern.add_stiffness(body, start));
                operations += 2 * body.structure().factor_operations();
            }
        }
        let scale = if scale > 0.0 { scale } else { 1.0 };
        pattern.add_contact(&rows, scale);
        let matrix = pattern.compress();
        let structure = LuStructure::analyse(&matrix)?;
        let cases = (0..problem.load_cases())
            .map(|case| case_load(&bodies, case, problem, displacements))
            .collect();
        let (contact, balance) = positions(&matrix, rows, displacements, problem);
        Ok(Self {
            matrix,
            structure,
            displacements,
            contact,
            balance,
            cases,
            scale,
            operations,
        })
    }

    /// Relative motion d without displacements and rigid motions: initial gaps and prescribed motion, less what had slipped.
    fn given_motion(&self, step: &Step<'_>) -> DVector<f64> {
        let mut motion = DVector::zeros(self.contact.len());
        for (case, &factor) in self.cases.iter().zip(step.multipliers()) {
            motion.axpy(factor, &case.motion, 1.0);
        }
        for (k, point) in step.problem.points().iter().enumerate() {
            motion[2 * k] += point.gap;
            motion[2 * k + 1] -= step.committed.tangential_displacement(k);
        }
        motion
    }

    /// Matrix and right-hand side for the statuses, and the rigid motions that no condition resists.
    fn assemble(
        &self,
        step: &Step<'_>,
        status: &[Status],
        lines: &[SlipLine],
        given: &DVector<f64>,
    ) -> (SparseMatrix, Vec<f64>, Option<FreeMotions>) {
        let mut matrix = self.matrix.clone();
        let values = &mut matrix.values;
        let mut side = vec![0.0; self.matrix.order()];
        for (case, &factor) in self.cases.iter().zip(step.multipliers()) {
            for (sum, part) in side.iter_mut().zip(&case.forces) {
                *sum += factor * part;
            }
        }
        let mut resisting = Vec::new();
        for (row, condition) in self.contact.iter().enumerate() {
            let (point, tangential) = (row / 2, row % 2 == 1);
            let slides = step.problem.points()[point].slides;
            let sign = status[point].slip_sign();
            let place = self.displacements + row;
            if !status[point].touches() || (tangential && !slides) {
                values[condition.own] = self.scale;
                continue;
            }
            let weight = if tangential && sign != 0.0 {
                let line = lines[point];
                values[condition.own] = self.scale;
                if let Some(normal) = condition.normal {
                    values[normal] = sign * line.normal * self.scale;
                }
                side[place] = -sign * line.constant;
                line.slip
            } else {
                self.scale
            };
            if weight == 0.0 {
                continue;
            }
            resisting.push(row);
            for &(_, coefficient, position) in &condition.displacements {
                values[position] = weight * coefficient;
            }
            for (mode, &position) in condition.rigid.iter().enumerate() {
                values[position] = weight * step.problem.modes()[(row, mode)];
            }
            side[place] -= weight * given[row];
        }
        let free = FreeMotions::of(step.problem, resisting);
        self.assemble_balance(step, free.as_ref(), values, &mut side);
        (matrix, side, free)
    }

    /// Gᵀλ + r = 0, but for rigid motions that are free: these keep their committed amount.
    fn assemble_balance(
        &self,
        step: &Step<'_>,
        free: Option<&FreeMotions>,
        values: &mut [f64],
        side: &mut [f64],
    ) {
        let modes = step.problem.modes();
        let count = modes.ncols();
        let mut coefficients = modes.transpose() * self.scale;
        let mut load = -step.mode_load();
        let mut corner = nalgebra::DMatrix::zeros(count, count);
        if let Some(free) = free {
            let projector = &free.projector;
            coefficients -= projector * &coefficients;
            load -= projector * &load;
            load += projector * &step.committed.rigid * self.scale;
            corner = projector * self.scale;
        }
        let start = self.displacements + self.contact.len();
        for (mode, positions) in self.balance.iter().enumerate() {
            let (row, held) = (coefficients.row(mode), corner.row(mode));
            for (&position, &value) in positions.iter().zip(row.iter().chain(held.iter())) {
                values[position] = value;
            }
            side[start + mode] = load[mode];
        }
    }
}

impl FrozenSystem for WholeSystem {
    fn solve(
        &self,
        step: &Step<'_>,
        status: &[Status],
        lines: &[SlipLine],
        work: &mut Work,
    ) -> Result<Frozen, FailureCause> {
        let given = self.given_motion(step);
        let (matrix, mut solution, free) = self.assemble(step, status, lines, &given);
        work.solves += 1;
        work.factorisations += 1;
        work.operations += self.operations;
        SparseLu::factorise(&self.structure, &matrix)
            .map_err(|_| FailureCause::Singular)?
            .solve(&mut solution);
        if !solution.iter().all(|value| value.is_finite()) {
            return Err(FailureCause::Singular);
        }
        let (u, rest) = solution.split_at(self.displacements);
        let (forces, rigid) = rest.split_at(self.contact.len());
        let forces = DVector::from_column_slice(forces) * self.scale;
        let rigid = DVector::from_column_slice(rigid);
        let mut motion = given;
        motion.gemv(1.0, step.problem.modes(), &rigid, 1.0);
        for (value, condition) in motion.iter_mut().zip(&self.contact) {
            let terms = condition.displacements.iter();
            *value += terms.map(|&(unknown, b, _)| b * u[unknown]).sum::<f64>();
        }
        let unbalanced = free.and_then(|free| free.unbalanced(step, &forces));
        Ok(Frozen {
            forces,
            rigid,
            motion,
            unbalanced,
        })
    }
}

/// What load case `case` does to the displacement unknowns and to the contact points.
fn case_load(
    bodies: &[Option<&CondensedBody>],
    case: usize,
    problem: &InterfaceProblem,
    displacements: usize,
) -> CaseLoad {
    let mut multipliers = vec![0.0; problem.load_cases()];
    multipliers[case] = 1.0;
    let mut load = CaseLoad {
        forces: Vec::with_capacity(displacements),
        motion: DVector::zeros(2 * problem.points().len()),
    };
    for (index, body) in bodies.iter().enumerate() {
        let Some(body) = body else { continue };
        load.forces.extend(body.load_on_unknowns(&multipliers));
        let prescribed = body.prescribed_motion(&multipliers);
        if prescribed.iter().any(|&displacement| displacement != 0.0) {
            load.motion += relative_motion(problem, index, &prescribed);
        }
    }
    load
}

/// Where the contact conditions and the balances stand in `matrix`.
fn positions(
    matrix: &SparseMatrix,
    rows: Vec<Coefficients>,
    displacements: usize,
    problem: &InterfaceProblem,
) -> (Vec<ContactRow>, Vec<Vec<usize>>) {
    // Every place that is asked for was put into the pattern.
    let at = |row, column| matrix.position(row, column).unwrap_or(0);
    let first = displacements + rows.len();
    let motions = first..first + problem.modes().ncols();
    let balance = motions
        .clone()
        .map(|row| {
            (displacements..motions.end)
                .map(|column| at(row, column))
                .collect()
        })
        .collect();
    let contact = rows
        .into_iter()
        .enumerate()
        .map(|(k, coefficients)| {
            let row = displacements + k;
            ContactRow {
                displacements: coefficients
                    .into_iter()
                    .map(|(unknown, coefficient)| (unknown, coefficient, at(row, unknown)))
                    .collect(),
                rigid: motions.clone().map(|column| at(row, column)).collect(),
                own: at(row, row),
                normal: (k % 2 == 1).then(|| at(row, row - 1)),
            }
        })
        .collect();
    (contact, balance)
}
