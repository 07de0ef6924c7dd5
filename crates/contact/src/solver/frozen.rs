//! One interface solve with frozen statuses.
//!
//! Unknown are λ_n of touching points, λ_t of sticking ones, and the rigid motions α. A slipping point carries
//! λ_t = −σ F_slip(λ_n, |Δs|), linearised about the last iterate, F ≈ f₀ + f₁ λ_n + f₂ σ Δs:
//!
//! ```text
//! g_n = 0 (touching),   Δs = 0 (sticking),   λ_t + σ f₁ λ_n + f₂ Δs = −σ f₀ (slipping),   Gᵀ λ + r = 0
//! ```
//!
//! Where f₂ = 0 the third line is eliminated. Forces are unknown as lengths, times the problem's unit of compliance: then all rows
//! are lengths, and neither the units of a scene nor its size change a pivot. Rigid motions that the touching points do not resist keep their committed
//! amount; the load and slip tractions left unbalanced in them are reported, so that the caller can bring further points
//! into contact.

use std::fmt::Debug;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::linalg::DenseLu;

use super::step::Step;
use super::{FailureCause, Work};
use crate::problem::{Chosen, FreeMotions};
use crate::state::Status;

/// Relative size below which a resistance or a resultant is rounding.
const NEGLIGIBLE: f64 = 1e-12;

/// Linearised slip traction of one point: F ≈ f₀ + f₁ λ_n + f₂ |Δs|.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SlipLine {
    /// f₀ `[force]`.
    pub constant: f64,
    /// f₁ `[1]`.
    pub normal: f64,
    /// f₂ `[force/length]`.
    pub slip: f64,
}

/// Result of a solve with frozen statuses.
#[derive(Clone, Debug)]
pub struct Frozen {
    /// Contact forces `[force]`, 2n.
    pub forces: DVector<f64>,
    /// Rigid motions, m, in the units of [`InterfaceProblem::modes`](crate::InterfaceProblem::modes).
    pub rigid: DVector<f64>,
    /// Gap and slip increment `[length]`, 2n.
    pub motion: DVector<f64>,
    /// Resultants `[force]`, m, that nothing resists, of the load and the slip tractions, if there are any.
    pub unbalanced: Option<DVector<f64>>,
}

/// Solves the linear problem of a step with frozen statuses: what an active-set iteration repeats. The solvers of this crate
/// do it on the condensed problem; another way, such as the whole finite-element system, gives the same iteration.
pub trait FrozenSystem: Debug + Send + Sync {
    /// Forces and motion of `step` for the statuses `status` and the slip tractions `lines`, both one per point; counts in
    /// `work` what that costs, the solve included.
    ///
    /// # Errors
    /// [`FailureCause::Singular`] if the statuses leave the solution undetermined.
    fn solve(
        &self,
        step: &Step<'_>,
        status: &[Status],
        lines: &[SlipLine],
        work: &mut Work,
    ) -> Result<Frozen, FailureCause>;
}

/// The condensed problem: compliance of the touching points, bordered by the rigid motions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Condensed;

impl FrozenSystem for Condensed {
    fn solve(
        &self,
        step: &Step<'_>,
        status: &[Status],
        lines: &[SlipLine],
        work: &mut Work,
    ) -> Result<Frozen, FailureCause> {
        solve(step, status, lines, work)
    }
}

/// How the unknown at each position of the reduced system relates to the contact forces.
pub(super) struct Layout {
    /// Touching points: unknown λ_n.
    pub(super) normal: Vec<usize>,
    /// Points whose λ_t is an unknown: sticking ones, and slipping ones with f₂ ≠ 0.
    pub(super) tangential: Vec<usize>,
}

impl Layout {
    fn of(step: &Step<'_>, status: &[Status], lines: &[SlipLine]) -> Self {
        let points = step.problem.points();
        let sticks =
            |k: usize| status[k] == Status::Stick || (status[k].touches() && lines[k].slip != 0.0);
        Self {
            normal: (0..points.len()).filter(|&k| status[k].touches()).collect(),
            tangential: (0..points.len())
                .filter(|&k| points[k].slides && sticks(k))
                .collect(),
        }
    }

    /// The conditions of (g, Δs) that are equations.
    pub(super) fn rows(&self) -> Vec<usize> {
        let normal = self.normal.iter().map(|k| 2 * k);
        normal
            .chain(self.tangential.iter().map(|k| 2 * k + 1))
            .collect()
    }
}

/// Solves with statuses `status` and slip tractions `lines`, and counts what that costs.
pub(super) fn solve(
    step: &Step<'_>,
    status: &[Status],
    lines: &[SlipLine],
    work: &mut Work,
) -> Result<Frozen, FailureCause> {
    let points = step.problem.points();
    let layout = Layout::of(step, status, lines);
    let (matrix, side, free) = reduced_system(step, status, lines, &layout);
    let unit = step.problem.compliance_unit();
    let mut solution = side;
    let (order, count) = (solution.len() as u64, points.len() as u64);
    work.solves += 1;
    work.factorisations += 1;
    work.operations += lu_operations(order) + 4 * count * order;
    DenseLu::new(matrix)
        .map_err(|_| FailureCause::Singular)?
        .solve(&mut solution);
    if !solution.iter().all(|value| value.is_finite()) {
        return Err(FailureCause::Singular);
    }

    let mut forces = DVector::zeros(2 * points.len());
    for (value, &k) in solution.iter().zip(&layout.normal) {
        forces[2 * k] = *value / unit;
        if points[k].slides {
            forces[2 * k + 1] =
                -status[k].slip_sign() * (lines[k].constant + lines[k].normal * forces[2 * k]);
        }
    }
    let touching = layout.normal.len();
    for (value, &k) in solution.iter().skip(touching).zip(&layout.tangential) {
        forces[2 * k + 1] = *value / unit;
    }
    let rigid = solution
        .rows(touching + layout.tangential.len(), step.mode_load.len())
        .into_owned();
    let motion = step.motion(&forces, &rigid);
    let unbalanced = free.and_then(|free| free.unbalanced(step, &forces));
    Ok(Frozen {
        forces,
        rigid,
        motion,
        unbalanced,
    })
}

/// Operations of a dense LU factorisation of that order with one pair of triangular solves.
pub(super) fn lu_operations(order: u64) -> u64 {
    2 * order * order * order / 3 + 2 * order * order
}

impl FreeMotions {
    /// The part `[force]`, m, along them of the load and of the contact forces `forces` `[force]`, 2n; `None` where it is rounding.
    pub fn unbalanced(&self, step: &Step<'_>, forces: &DVector<f64>) -> Option<DVector<f64>> {
        let mut resultants = step.mode_load.clone();
        resultants.gemv_tr(1.0, step.problem.modes(), forces, 1.0);
        let along = &self.projector * resultants;
        (along.amax() > NEGLIGIBLE * step.mode_load.amax().max(forces.amax())).then_some(along)
    }
}

/// The matrix of the reduced system, and how its unknowns relate to the contact forces.
pub(super) fn matrix_of(
    step: &Step<'_>,
    status: &[Status],
    lines: &[SlipLine],
) -> (DMatrix<f64>, Layout) {
    let layout = Layout::of(step, status, lines);
    (reduced_system(step, status, lines, &layout).0, layout)
}

/// Matrix and right-hand side of the reduced system, unknown forces times the unit of compliance, and the rigid motions that no
/// row resists.
fn reduced_system(
    step: &Step<'_>,
    status: &[Status],
    lines: &[SlipLine],
    layout: &Layout,
) -> (DMatrix<f64>, DVector<f64>, Option<FreeMotions>) {
    let modes = step.problem.modes();
    let unit = step.problem.compliance_unit();
    let rows = layout.rows();
    let columns: Vec<usize> = (layout.normal.iter())
        .flat_map(|k| [2 * k, 2 * k + 1])
        .collect();
    let compliance = step.problem.compliance().chosen(&rows, &columns);
    let (contact, rigid) = (rows.len(), modes.ncols());
    let size = contact + rigid;
    let mut matrix = DMatrix::zeros(size, size);
    let mut side = DVector::zeros(size);
    for (i, &row) in rows.iter().enumerate() {
        side[i] = -step.free_motion[row];
        for mode in 0..rigid {
            matrix[(i, contact + mode)] = modes[(row, mode)];
        }
    }
    for mode in 0..rigid {
        side[contact + mode] = -unit * step.mode_load[mode];
    }
    for (j, &k) in layout.normal.iter().enumerate() {
        let sign = if step.problem.points()[k].slides {
            status[k].slip_sign()
        } else {
            0.0
        };
        let eliminated = sign != 0.0 && lines[k].slip == 0.0;
        let (slope, constant) = if eliminated {
            (-sign * lines[k].normal, -sign * lines[k].constant * unit)
        } else {
            (0.0, 0.0)
        };
        for i in 0..contact {
            let tangential = compliance.at(i, 2 * k + 1);
            matrix[(i, j)] = (compliance.at(i, 2 * k) + slope * tangential) / unit;
            side[i] -= constant * tangential / unit;
        }
        matrix[(j, j)] += step.softness / unit;
        for mode in 0..rigid {
            let (along_normal, along_tangent) = (modes[(2 * k, mode)], modes[(2 * k + 1, mode)]);
            matrix[(contact + mode, j)] = along_normal + slope * along_tangent;
            side[contact + mode] -= constant * along_tangent;
        }
    }
    add_tangential_columns(&mut matrix, step, &compliance, layout);
    soften_slip_rows(&mut matrix, &mut side, status, lines, layout, unit);
    let free = hold_free_motions(step, &rows, &mut matrix, &mut side);
    (matrix, side, free)
}

/// What the tangential forces that are unknown do to the rows of `compliance` and to the balance of the rigid motions.
fn add_tangential_columns(
    matrix: &mut DMatrix<f64>,
    step: &Step<'_>,
    compliance: &Chosen<'_>,
    layout: &Layout,
) {
    let (unit, modes) = (step.problem.compliance_unit(), step.problem.modes());
    for (j, &k) in (layout.normal.len()..).zip(&layout.tangential) {
        let contact = layout.normal.len() + layout.tangential.len();
        for i in 0..contact {
            matrix[(i, j)] = compliance.at(i, 2 * k + 1) / unit;
        }
        matrix[(j, j)] += step.softness / unit;
        for mode in 0..modes.ncols() {
            matrix[(contact + mode, j)] = modes[(2 * k + 1, mode)];
        }
    }
}

/// Turns the row Δs = 0 of a slipping point with f₂ ≠ 0 into λ_t + σ f₁ λ_n + f₂ Δs = −σ f₀.
fn soften_slip_rows(
    matrix: &mut DMatrix<f64>,
    side: &mut DVector<f64>,
    status: &[Status],
    lines: &[SlipLine],
    layout: &Layout,
    unit: f64,
) {
    let touching = layout.normal.len();
    for (position, &k) in layout.tangential.iter().enumerate() {
        let sign = status[k].slip_sign();
        if sign == 0.0 {
            continue;
        }
        let row = touching + position;
        let slope = lines[k].slip * unit;
        matrix.row_mut(row).scale_mut(slope);
        side[row] = slope * side[row] - sign * lines[k].constant * unit;
        matrix[(row, row)] += 1.0;
        // Every tangential unknown belongs to a touching point.
        if let Ok(j) = layout.normal.binary_search(&k) {
            matrix[(row, j)] += sign * lines[k].normal;
        }
    }
}

/// Whether the solve with statuses `status` may be off by `f64::EPSILON / tolerance` of its solution: the reduced matrix, rows
/// and columns scaled to one, has a condition number beyond 1/`tolerance`, or a rigid motion is neither free nor resisted.
pub(super) fn undetermined(
    step: &Step<'_>,
    status: &[Status],
    lines: &[SlipLine],
    tolerance: f64,
) -> bool {
    const RESISTED: f64 = 1e-5;
    let layout = Layout::of(step, status, lines);
    let (mut matrix, _, _) = reduced_system(step, status, lines, &layout);
    for _ in 0..3 {
        for mut row in matrix.row_iter_mut() {
            row /= positive(row.amax());
        }
        for mut column in matrix.column_iter_mut() {
            column /= positive(column.amax());
        }
    }
    let ratio = |values: &DVector<f64>| values.min() / positive(values.max());
    if !matrix.is_empty() && ratio(&matrix.singular_values()) < tolerance {
        return true;
    }
    let rows = layout.rows();
    let held = step.problem.modes().select_rows(&rows);
    if held.is_empty() {
        return false;
    }
    let values = held.singular_values();
    let largest = positive(values.max());
    values
        .iter()
        .any(|value| (NEGLIGIBLE * largest..RESISTED * largest).contains(value) && *value > 0.0)
}

fn positive(value: f64) -> f64 {
    if value > 0.0 { value } else { 1.0 }
}

/// Keeps rigid motions that no row of `rows` resists at their committed amount, and returns them.
fn hold_free_motions(
    step: &Step<'_>,
    rows: &[usize],
    matrix: &mut DMatrix<f64>,
    side: &mut DVector<f64>,
) -> Option<FreeMotions> {
    let (contact, rigid) = (rows.len(), step.problem.modes().ncols());
    let free = FreeMotions::of(step.problem, rows.iter().copied())?;
    let projector = &free.projector;
    let mut balance = matrix.rows_mut(contact, rigid);
    let along = projector * &balance;
    balance -= along;
    let mut corner = matrix.view_mut((contact, contact), (rigid, rigid));
    corner += projector;
    let mut resultants = side.rows_mut(contact, rigid);
    let along = projector * &resultants;
    resultants -= along;
    resultants.gemv(1.0, projector, &step.committed.rigid, 1.0);
    Some(free)
}
