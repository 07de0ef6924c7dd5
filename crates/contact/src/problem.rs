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
//! and − for the second. Forces λ `[force]` act on the first body.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::InterfaceOperator;
use stickslip_friction::{FrictionLaw, Place};

use crate::error::ContactError;

/// One contact point of a pair: a node of the first body against a node of the second.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactPoint {
    /// Index of the point among the first body's contact points.
    pub first: usize,
    /// Index of the point among the second body's contact points.
    pub second: usize,
    /// Unit normal e_n from the second body into the first; e_t is e_n turned by +90°.
    pub normal: [f64; 2],
    /// Initial gap g₀ `[length]`; negative for interference.
    pub gap: f64,
    /// Contact area that the point stands for `[length²]`: traction = force / area.
    pub area: f64,
    /// Angle of the first body's 1-axis from x `[rad]`.
    pub material_angle: f64,
}

/// Two bodies that may touch, and the friction between them.
#[derive(Clone, Debug)]
pub struct ContactPair {
    /// Name for messages and results.
    pub name: String,
    /// Index of the first body.
    pub first: usize,
    /// Index of the second body.
    pub second: usize,
    /// Points in walk order along the contact.
    pub points: Vec<ContactPoint>,
    /// Friction law.
    pub law: Arc<dyn FrictionLaw>,
}

/// One contact point of the assembled problem.
#[derive(Clone, Debug)]
pub struct ProblemPoint {
    /// Index of the pair it belongs to.
    pub pair: usize,
    /// Initial gap `[length]`.
    pub gap: f64,
    /// Contact area `[length²]`.
    pub area: f64,
    /// Place handed to the friction law.
    pub place: Place,
    /// Unit normal e_n.
    pub normal: [f64; 2],
    /// Whether the bodies can move against each other tangentially here; not so on a line of symmetry.
    pub slides: bool,
}

/// The assembled interface problem: everything that solvers of one load step see.
#[derive(Clone, Debug)]
pub struct InterfaceProblem {
    pairs: Vec<ContactPair>,
    points: Vec<ProblemPoint>,
    /// First point of each pair, and the number of points at the end.
    offsets: Vec<usize>,
    compliance: DMatrix<f64>,
    modes: DMatrix<f64>,
    /// First mode of each body, and the number of modes at the end.
    mode_offsets: Vec<usize>,
    case_motion: Vec<DVector<f64>>,
    case_mode_load: Vec<DVector<f64>>,
}

impl InterfaceProblem {
    /// Assembles the problem of `pairs` between `bodies`. Cost: one pass over each body's compliance.
    ///
    /// # Errors
    /// [`ContactError::InvalidPair`] for an index out of range, a number that is not finite, a normal that is not a unit
    /// vector or an area that is not positive; [`ContactError::LoadCases`] if the bodies disagree in the number of cases.
    pub fn new(
        bodies: &[&dyn InterfaceOperator],
        pairs: Vec<ContactPair>,
    ) -> Result<Self, ContactError> {
        let cases = bodies.first().map_or(0, |body| body.load_cases());
        if let Some(other) = bodies.iter().find(|body| body.load_cases() != cases) {
            return Err(ContactError::LoadCases {
                first: cases,
                other: other.load_cases(),
            });
        }
        pairs.iter().try_for_each(|pair| check_pair(pair, bodies))?;
        let mut offsets = vec![0];
        for pair in &pairs {
            offsets.push(offsets[offsets.len() - 1] + pair.points.len());
        }
        let mut mode_offsets = vec![0];
        for body in bodies {
            mode_offsets.push(mode_offsets[mode_offsets.len() - 1] + body.modes().ncols());
        }
        let points = problem_points(&pairs, bodies);
        let size = 2 * points.len();
        let mut problem = Self {
            compliance: DMatrix::zeros(size, size),
            modes: DMatrix::zeros(size, mode_offsets[bodies.len()]),
            case_motion: vec![DVector::zeros(size); cases],
            case_mode_load: vec![DVector::zeros(mode_offsets[bodies.len()]); cases],
            pairs,
            points,
            offsets,
            mode_offsets,
        };
        for (index, body) in bodies.iter().enumerate() {
            problem.add_body(index, *body);
        }
        problem.find_sliding_points();
        Ok(problem)
    }

    fn add_body(&mut self, index: usize, body: &dyn InterfaceOperator) {
        let touches = self.touches(index);
        if let Some(compliance) = body.compliance() {
            for (j, column) in touches.iter().enumerate() {
                for row in &touches[j..] {
                    let block = compliance.fixed_view::<2, 2>(2 * row.local, 2 * column.local);
                    let turned = row.frame * block * column.frame.transpose();
                    let mut target = self
                        .compliance
                        .fixed_view_mut::<2, 2>(2 * row.point, 2 * column.point);
                    target += turned;
                    if row.point != column.point {
                        let mut mirror = self
                            .compliance
                            .fixed_view_mut::<2, 2>(2 * column.point, 2 * row.point);
                        mirror += turned.transpose();
                    }
                }
            }
        }
        let first_mode = self.mode_offsets[index];
        let count = body.modes().ncols();
        for touch in &touches {
            let motion = touch.frame * body.modes().rows(2 * touch.local, 2);
            self.modes
                .view_mut((2 * touch.point, first_mode), (2, count))
                .copy_from(&motion);
        }
        for case in 0..self.case_motion.len() {
            self.case_mode_load[case]
                .rows_mut(first_mode, count)
                .copy_from(body.mode_load(case));
            if let Some(response) = body.load_response(case) {
                for touch in &touches {
                    let motion = touch.frame * response.fixed_rows::<2>(2 * touch.local);
                    let mut target = self.case_motion[case].fixed_rows_mut::<2>(2 * touch.point);
                    target += motion;
                }
            }
        }
    }

    /// The points where body `index` touches, with the frame that takes its displacements into the point's.
    fn touches(&self, index: usize) -> Vec<Touch> {
        let mut touches = Vec::new();
        for (pair, &offset) in self.pairs.iter().zip(&self.offsets) {
            for (k, point) in pair.points.iter().enumerate() {
                let frame = frame(point.normal);
                if pair.first == index {
                    touches.push(Touch {
                        point: offset + k,
                        local: point.first,
                        frame,
                    });
                }
                if pair.second == index {
                    touches.push(Touch {
                        point: offset + k,
                        local: point.second,
                        frame: -frame,
                    });
                }
            }
        }
        touches
    }

    fn find_sliding_points(&mut self) {
        const NEGLIGIBLE: f64 = 1e-12;
        let stiffest = self.compliance.diagonal().max();
        for (k, point) in self.points.iter_mut().enumerate() {
            let row = 2 * k + 1;
            let gives = self.compliance[(row, row)] > NEGLIGIBLE * stiffest;
            point.slides = gives
                || self
                    .modes
                    .row(row)
                    .iter()
                    .any(|value| value.abs() > NEGLIGIBLE);
        }
    }

    /// Contact points, pair by pair in walk order.
    pub fn points(&self) -> &[ProblemPoint] {
        &self.points
    }

    /// The pairs.
    pub fn pairs(&self) -> &[ContactPair] {
        &self.pairs
    }

    /// Range of the points of pair `pair`.
    pub fn pair_points(&self, pair: usize) -> std::ops::Range<usize> {
        self.offsets[pair]..self.offsets[pair + 1]
    }

    /// Friction law at point `point`.
    pub fn law(&self, point: usize) -> &dyn FrictionLaw {
        self.pairs[self.points[point].pair].law.as_ref()
    }

    /// Compliance A `[length/force]`, 2n × 2n, symmetric positive semidefinite.
    pub fn compliance(&self) -> &DMatrix<f64> {
        &self.compliance
    }

    /// Rigid motions G, 2n × m.
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

    /// Number of load cases.
    pub fn load_cases(&self) -> usize {
        self.case_motion.len()
    }

    /// Relative motion Σ m_k d_k `[length]` of the points by the loads alone, 2n.
    pub fn load_motion(&self, multipliers: &[f64]) -> DVector<f64> {
        combine(&self.case_motion, multipliers, 2 * self.points.len())
    }

    /// Resultants Σ m_k r_k `[force]` of the loads in the rigid motions, m.
    pub fn mode_load(&self, multipliers: &[f64]) -> DVector<f64> {
        combine(&self.case_mode_load, multipliers, self.modes.ncols())
    }

    /// Forces `[force]` on the contact points of body `index` (2 × `count`, xy interleaved) by contact forces `forces`
    /// (2n, normal and tangential interleaved).
    pub fn forces_on_body(&self, index: usize, count: usize, forces: &DVector<f64>) -> Vec<f64> {
        let mut on_body = vec![0.0; 2 * count];
        for touch in self.touches(index) {
            let force = touch.frame.transpose() * forces.fixed_rows::<2>(2 * touch.point);
            on_body[2 * touch.local] += force[0];
            on_body[2 * touch.local + 1] += force[1];
        }
        on_body
    }
}

struct Touch {
    point: usize,
    local: usize,
    frame: nalgebra::Matrix2<f64>,
}

/// Rows e_n and e_t.
fn frame(normal: [f64; 2]) -> nalgebra::Matrix2<f64> {
    nalgebra::Matrix2::new(normal[0], normal[1], -normal[1], normal[0])
}

fn combine(parts: &[DVector<f64>], multipliers: &[f64], size: usize) -> DVector<f64> {
    let mut sum = DVector::zeros(size);
    for (part, &factor) in parts.iter().zip(multipliers) {
        sum.axpy(factor, part, 1.0);
    }
    sum
}

fn problem_points(pairs: &[ContactPair], bodies: &[&dyn InterfaceOperator]) -> Vec<ProblemPoint> {
    let mut points = Vec::new();
    for (index, pair) in pairs.iter().enumerate() {
        for point in &pair.points {
            let place = Place {
                position: bodies[pair.first].points()[point.first],
                tangent: [-point.normal[1], point.normal[0]],
                material_angle: point.material_angle,
            };
            points.push(ProblemPoint {
                pair: index,
                gap: point.gap,
                area: point.area,
                place,
                normal: point.normal,
                slides: true,
            });
        }
    }
    points
}

fn check_pair(pair: &ContactPair, bodies: &[&dyn InterfaceOperator]) -> Result<(), ContactError> {
    let refuse = |point: usize, what: String| {
        Err(ContactError::InvalidPair {
            pair: pair.name.clone(),
            point,
            what,
        })
    };
    for (index, body) in [pair.first, pair.second].into_iter().enumerate() {
        if body >= bodies.len() {
            return refuse(0, format!("body {body} of {} does not exist", bodies.len()));
        }
        for (k, point) in pair.points.iter().enumerate() {
            let local = if index == 0 {
                point.first
            } else {
                point.second
            };
            let count = bodies[body].points().len();
            if local >= count {
                return refuse(
                    k,
                    format!("contact node {local} of body {body}, which has {count}"),
                );
            }
        }
    }
    for (k, point) in pair.points.iter().enumerate() {
        let length = point.normal[0].hypot(point.normal[1]);
        if length.is_nan() || (length - 1.0).abs() >= 1e-9 {
            return refuse(k, format!("the normal has length {length}, not 1"));
        }
        if !point.gap.is_finite() {
            return refuse(k, format!("the initial gap is {}", point.gap));
        }
        if !(point.area > 0.0 && point.area.is_finite()) {
            return refuse(k, format!("the contact area is {}", point.area));
        }
    }
    Ok(())
}
