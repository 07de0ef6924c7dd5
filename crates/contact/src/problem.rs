//! The interface problem: all bodies of a scene reduced to the relative motion of their contact points.
//!
//! With normal and tangential components interleaved, (n, t) per point,
//!
//! ```text
//! (g − g₀, s) = A λ + Σ_k m_k d_k + G α,     Gᵀ λ + Σ_k m_k r_k = 0
//! A = Σ_b B_b C_b B_bᵀ,   d_k = Σ_b B_b u_k,b,   G = [B_b R_b],   r_k = [r_k,b]
//! ```
//!
//! where B_b takes displacements of body b into the frames of the points it touches, with + for the first body of a pair
//! and − for the second. Forces λ `[force]` act on the first body. A contact point is a node of each body, or a short
//! weighted [`Stencil`] of nodes as the [`mortar`](crate::mortar) projection makes it.

pub(crate) mod check;
mod compliance;
mod contacts;
mod free_motions;
pub(crate) mod link;
mod moved;
mod stencil;

use std::ops::Range;
use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::InterfaceOperator;
use stickslip_friction::{FrictionLaw, History};

pub(crate) use compliance::Chosen;
pub use compliance::Compliance;
use compliance::assemble;
pub use contacts::{ContactPair, ContactPoint, Contacts, ProblemPoint};
pub(crate) use contacts::{Couple, frame};
pub use free_motions::FreeMotions;
pub use link::Link;
use link::Linked;
pub use stencil::{BodyRows, Stencil, StencilTerm};

use crate::error::ContactError;
use crate::state::{ContactState, Status};

/// The assembled interface problem: everything that solvers of one load step see.
#[derive(Clone, Debug)]
pub struct InterfaceProblem {
    contacts: Contacts,
    compliance: Compliance,
    compliance_unit: f64,
    /// See [`Self::local_give`].
    local_give: f64,
    modes: DMatrix<f64>,
    /// Unit of each mode: what an amount of 1 is in the body's own amounts.
    mode_units: Vec<f64>,
    /// First mode of each body, and the number of modes at the end.
    mode_offsets: Vec<usize>,
    case_motion: Vec<DVector<f64>>,
    case_mode_load: Vec<DVector<f64>>,
    links: Vec<Linked>,
}

impl InterfaceProblem {
    /// Assembles the problem of `pairs` between `bodies`. Cost: a body of n contact nodes whose stencils have s terms takes
    /// O(n² s) operations.
    ///
    /// # Errors
    /// [`ContactError::InvalidPair`] for an index out of range, a number that is not finite, a normal that is not a unit
    /// vector, an area that is not positive or a stencil without terms; [`ContactError::LoadCases`] if the bodies disagree in the number of cases.
    pub fn new(
        bodies: &[&dyn InterfaceOperator],
        pairs: Vec<ContactPair>,
    ) -> Result<Self, ContactError> {
        Self::linked(bodies, pairs, &[])
    }

    /// As [`new`](Self::new), with springs `links` between rigid motions of bodies. The motions that the springs of a link do not resist
    /// count as those of its first body.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`ContactError::InvalidLink`] for a link that does not fit its bodies.
    pub fn linked(
        bodies: &[&dyn InterfaceOperator],
        pairs: Vec<ContactPair>,
        links: &[Link],
    ) -> Result<Self, ContactError> {
        let cases = check::all(&pairs, bodies)?;
        link::check(links, bodies)?;
        let mode_offsets = link::mode_offsets(bodies, &[]);
        let contacts = Contacts::new(pairs, bodies);
        let size = 2 * contacts.points().len();
        let mut problem = Self {
            compliance: assemble(&contacts, bodies),
            compliance_unit: 1.0,
            local_give: 0.0,
            modes: DMatrix::zeros(size, mode_offsets[bodies.len()]),
            mode_units: vec![1.0; mode_offsets[bodies.len()]],
            case_motion: vec![DVector::zeros(size); cases],
            case_mode_load: vec![DVector::zeros(mode_offsets[bodies.len()]); cases],
            contacts,
            mode_offsets,
            links: Vec::new(),
        };
        for (index, body) in bodies.iter().enumerate() {
            problem.add_body(index, *body);
        }
        problem.link(bodies, links);
        problem.equilibrate_modes();
        problem.find_sliding_points();
        problem.compliance_unit = power_of_two_near(problem.largest_give());
        problem.find_local_give();
        Ok(problem)
    }

    fn add_body(&mut self, index: usize, body: &dyn InterfaceOperator) {
        let rows = self.body_rows(index);
        self.add_motions(index, body, &rows);
        let modes = self.body_modes(index);
        for (case, load) in self.case_mode_load.iter_mut().enumerate() {
            load.rows_mut(modes.start, modes.len())
                .copy_from(body.mode_load(case));
        }
    }

    /// Adds the rigid motions and the responses to loads of body `index`, whose rows are `rows`.
    fn add_motions(&mut self, index: usize, body: &dyn InterfaceOperator, rows: &[BodyRows]) {
        let modes = self.body_modes(index);
        for row in rows {
            for (node, weight) in &row.terms {
                let motion = weight * body.modes().rows(2 * node, 2);
                let place = (2 * row.point, modes.start);
                let mut target = self.modes.view_mut(place, (2, modes.len()));
                target += motion;
            }
        }
        for (case, motion) in self.case_motion.iter_mut().enumerate() {
            if let Some(response) = body.load_response(case) {
                for row in rows {
                    let mut target = motion.fixed_rows_mut::<2>(2 * row.point);
                    for (node, weight) in &row.terms {
                        target += weight * response.fixed_rows::<2>(2 * node);
                    }
                }
            }
        }
    }

    /// The rows of B of body `index`, of the points where it touches, in their order.
    pub fn body_rows(&self, index: usize) -> Vec<BodyRows> {
        self.contacts.body_rows(index)
    }

    /// Counts each rigid motion in a unit in which it moves the contact points by about 1, so that neither pivots nor resultants
    /// depend on the units of a body: a turn in radians moves them by their distance, in millimetres or in metres.
    fn equilibrate_modes(&mut self) {
        for (mode, unit) in self.mode_units.iter_mut().enumerate() {
            *unit = unit_of_motion(self.modes.column(mode).amax());
            self.modes.column_mut(mode).scale_mut(*unit);
            for load in &mut self.case_mode_load {
                load[mode] *= *unit;
            }
        }
    }

    fn find_sliding_points(&mut self) {
        const NEGLIGIBLE: f64 = 1e-12;
        let give = self.compliance.diagonal();
        let stiffest = give.max();
        for (k, point) in self.contacts.points_mut().iter_mut().enumerate() {
            let row = 2 * k + 1;
            let gives = give[row] > NEGLIGIBLE * stiffest;
            point.slides = gives
                || self
                    .modes
                    .row(row)
                    .iter()
                    .any(|value| value.abs() > NEGLIGIBLE);
        }
    }

    /// The pairs and their points.
    pub fn contacts(&self) -> &Contacts {
        &self.contacts
    }

    /// Contact points, pair by pair in walk order.
    pub fn points(&self) -> &[ProblemPoint] {
        self.contacts.points()
    }

    /// The pairs.
    pub fn pairs(&self) -> &[ContactPair] {
        self.contacts.pairs()
    }

    /// The same problem with `law` as the friction of pair `pair`; nothing is assembled anew.
    ///
    /// # Errors
    /// [`ContactError::UnknownPair`] if the problem has no pair `pair`.
    pub fn with_law(
        mut self,
        pair: usize,
        law: Arc<dyn FrictionLaw>,
    ) -> Result<Self, ContactError> {
        self.contacts.set_law(pair, law)?;
        Ok(self)
    }

    /// Range of the points of pair `pair`.
    pub fn pair_points(&self, pair: usize) -> std::ops::Range<usize> {
        self.contacts.pair_points(pair)
    }

    /// Friction law at point `point`.
    pub fn law(&self, point: usize) -> &dyn FrictionLaw {
        self.contacts.law(point)
    }

    /// Compliance A `[length/force]`, 2n × 2n, symmetric positive semidefinite.
    pub fn compliance(&self) -> &Compliance {
        &self.compliance
    }

    /// The largest compliance of a point under its own force `[length/force]`.
    pub fn largest_give(&self) -> f64 {
        self.compliance.diagonal().amax()
    }

    /// The largest normal compliance of a point against its neighbour in the pair, ½ (A_kk + A_jj − 2 A_kj) `[length/force]`: without what bodies move as a whole, as on soft springs.
    pub(crate) fn local_give(&self) -> f64 {
        self.local_give
    }

    fn find_local_give(&mut self) {
        let Some(matrix) = self.compliance.matrix() else {
            self.local_give = 0.0;
            return;
        };
        let own = |range: Range<usize>| range.clone().zip(range.skip(1));
        let pairs = 0..self.contacts.pairs().len();
        let neighbours = pairs.flat_map(|pair| own(self.contacts.pair_points(pair)));
        let gives = neighbours.map(|(k, j)| {
            let [k, j] = [2 * k, 2 * j];
            0.5 * (matrix[(k, k)] + matrix[(j, j)] - 2.0 * matrix[(k, j)])
        });
        self.local_give = gives.fold(0.0, f64::max);
    }

    /// The unit of compliance `[length/force]` in which solvers work, so that A and G have entries of one size: forces times this
    /// unit are lengths. A power of two near the largest entry of A, which changes no digit of any number; 1 where nothing gives.
    pub fn compliance_unit(&self) -> f64 {
        self.compliance_unit
    }

    /// Rigid motions G `[1]`, 2n × m, each in a unit in which it moves the contact points by about 1: that of its body times a power of 256,
    /// which changes no digit of any number. Motions that move them by 1/16 to 16 as they are have a factor of 1.
    pub fn modes(&self) -> &DMatrix<f64> {
        &self.modes
    }

    /// Number of bodies.
    pub fn body_count(&self) -> usize {
        self.mode_offsets.len() - 1
    }

    /// Range of the rigid motions of body `body` among the columns of G.
    pub fn body_modes(&self, body: usize) -> std::ops::Range<usize> {
        self.mode_offsets[body]..self.mode_offsets[body + 1]
    }

    /// Units of the rigid motions of body `body`.
    pub(crate) fn mode_units(&self, body: usize) -> &[f64] {
        &self.mode_units[self.body_modes(body)]
    }

    /// Number of load cases.
    pub fn load_cases(&self) -> usize {
        self.case_motion.len()
    }

    /// Whether the load case `case` moves contact points, or acts on rigid motions.
    pub(crate) fn is_moved_by(&self, case: usize) -> bool {
        let acts = |own: &DVector<f64>| own.iter().any(|value| *value != 0.0);
        acts(&self.case_motion[case]) || acts(&self.case_mode_load[case])
    }

    /// Relative motion Σ m_k d_k `[length]` of the points by the loads alone, 2n.
    pub fn load_motion(&self, multipliers: &[f64]) -> DVector<f64> {
        combine(&self.case_motion, multipliers, 2 * self.points().len())
    }

    /// Relative motion `[length]` of the points, 2n, by contact forces `[force]`, rigid motions and loads: what is added to gaps.
    pub(crate) fn relative_motion(
        &self,
        forces: &DVector<f64>,
        rigid: &DVector<f64>,
        multipliers: &[f64],
    ) -> DVector<f64> {
        let mut motion = self.load_motion(multipliers);
        self.compliance.add_motion(forces, &mut motion);
        motion.gemv(1.0, &self.modes, rigid, 1.0);
        motion
    }

    /// Resultants Σ m_k r_k `[force]` of the loads in the rigid motions, m. What is left by rounding where load cases cancel
    /// is zero.
    pub fn mode_load(&self, multipliers: &[f64]) -> DVector<f64> {
        const ROUNDING: f64 = 1e-13;
        let mut load = combine(&self.case_mode_load, multipliers, self.modes.ncols());
        for (mode, sum) in load.iter_mut().enumerate() {
            let parts = self.case_mode_load.iter().zip(multipliers);
            let size: f64 = parts
                .map(|(case, factor)| (factor * case[mode]).abs())
                .sum();
            if sum.abs() <= ROUNDING * size {
                *sum = 0.0;
            }
        }
        load
    }

    /// Forces `[force]` on the contact points of body `index` (2 × `count`, xy interleaved) by contact forces `forces`
    /// (2n, normal and tangential interleaved).
    pub fn forces_on_body(&self, index: usize, count: usize, forces: &DVector<f64>) -> Vec<f64> {
        self.contacts.forces_on_body(index, count, forces)
    }
}

impl ContactState {
    /// The state before any load: no forces, no motion, every point untouched.
    pub fn unloaded(problem: &InterfaceProblem) -> Self {
        let count = problem.points().len();
        let mut motion = DVector::zeros(2 * count);
        for (k, point) in problem.points().iter().enumerate() {
            motion[2 * k] = point.gap;
        }
        Self {
            forces: DVector::zeros(2 * count),
            motion,
            rigid: DVector::zeros(problem.modes().ncols()),
            status: vec![Status::Open; count],
            history: vec![History::default(); count],
            multipliers: vec![0.0; problem.load_cases()],
        }
    }
}

fn combine(parts: &[DVector<f64>], multipliers: &[f64], size: usize) -> DVector<f64> {
    let mut sum = DVector::zeros(size);
    for (part, &factor) in parts.iter().zip(multipliers) {
        sum.axpy(factor, part, 1.0);
    }
    sum
}

/// The power of 256 that brings a motion of size `largest` nearest to 1; 1 where nothing moves.
fn unit_of_motion(largest: f64) -> f64 {
    const STEP: f64 = 8.0;
    if largest > 0.0 && largest.is_finite() {
        (-STEP * (largest.log2() / STEP).round()).exp2()
    } else {
        1.0
    }
}

/// The power of two next below `value`, or 1 without a value.
fn power_of_two_near(value: f64) -> f64 {
    if value > 0.0 && value.is_finite() {
        value.log2().floor().exp2()
    } else {
        1.0
    }
}
