//! What a contact solver sees of a body: a small dense operator on its contact points.
//!
//! ```text
//! u = C λ + Σ_k m_k u_k + R α,      Rᵀ λ + Σ_k m_k r_k = 0
//! ```
//!
//! | symbol | meaning | shape | unit |
//! | --- | --- | --- | --- |
//! | u | displacements of the contact points, interleaved | 2n | length |
//! | λ | forces on the contact points, interleaved | 2n | force |
//! | C | compliance, a symmetric generalised inverse where the body floats | 2n × 2n | length/force |
//! | u_k | response to load case k, m_k its multiplier | 2n | length |
//! | R, α | rigid motions that the supports leave free, and their amounts | 2n × f, f | –, length |
//! | r_k | resultants of load case k in those motions, Rᵀ over the whole body | f | force |

use std::fmt::Debug;

use nalgebra::{DMatrix, DVector};

use crate::mesh::Point;

/// A body reduced to its contact points; how it was made is its own affair.
pub trait InterfaceOperator: Debug + Send + Sync {
    /// Positions of the contact points `[length]`, undeformed.
    fn points(&self) -> &[Point];

    /// Compliance C `[length/force]`, 2n × 2n; `None` for a rigid body.
    fn compliance(&self) -> Option<&DMatrix<f64>>;

    /// Rigid motions R of the contact points, 2n × f; f = 0 for a body that is held.
    fn modes(&self) -> &DMatrix<f64>;

    /// Number of load cases.
    fn load_cases(&self) -> usize;

    /// Response u_k `[length]` of the contact points to load case `case`, 2n; `None` where the case does not load this body.
    fn load_response(&self, case: usize) -> Option<&DVector<f64>>;

    /// Resultants r_k `[force]` of load case `case` in the rigid motions, f.
    fn mode_load(&self, case: usize) -> &DVector<f64>;
}

/// Rigid motions of `points`: translations along x and y, and the turn about `centre` divided by `length`.
pub fn rigid_motions(points: &[Point], centre: Point, length: f64) -> DMatrix<f64> {
    let mut motions = DMatrix::zeros(2 * points.len(), 3);
    for (k, point) in points.iter().enumerate() {
        motions[(2 * k, 0)] = 1.0;
        motions[(2 * k + 1, 1)] = 1.0;
        motions[(2 * k, 2)] = -(point[1] - centre[1]) / length;
        motions[(2 * k + 1, 2)] = (point[0] - centre[0]) / length;
    }
    motions
}

/// A rigid body: no compliance, only rigid motions.
#[derive(Clone, Debug)]
pub struct RigidBody {
    points: Vec<Point>,
    modes: DMatrix<f64>,
    mode_loads: Vec<DVector<f64>>,
}

impl RigidBody {
    /// A rigid body that cannot move.
    pub fn held(points: Vec<Point>, load_cases: usize) -> Self {
        let modes = DMatrix::zeros(2 * points.len(), 0);
        Self {
            points,
            modes,
            mode_loads: vec![DVector::zeros(0); load_cases],
        }
    }

    /// A rigid body free to move along x and y (where `free` says so) without turning; `forces[k]` is the resultant
    /// `[force]` of load case `k`.
    pub fn sliding(points: Vec<Point>, free: [bool; 2], forces: &[[f64; 2]]) -> Self {
        let directions: Vec<usize> = (0..2).filter(|&i| free[i]).collect();
        let modes = rigid_motions(&points, [0.0, 0.0], 1.0).select_columns(&directions);
        let mode_loads = forces
            .iter()
            .map(|force| {
                DVector::from_iterator(directions.len(), directions.iter().map(|&i| force[i]))
            })
            .collect();
        Self {
            points,
            modes,
            mode_loads,
        }
    }
}

impl InterfaceOperator for RigidBody {
    fn points(&self) -> &[Point] {
        &self.points
    }

    fn compliance(&self) -> Option<&DMatrix<f64>> {
        None
    }

    fn modes(&self) -> &DMatrix<f64> {
        &self.modes
    }

    fn load_cases(&self) -> usize {
        self.mode_loads.len()
    }

    fn load_response(&self, _case: usize) -> Option<&DVector<f64>> {
        None
    }

    fn mode_load(&self, case: usize) -> &DVector<f64> {
        &self.mode_loads[case]
    }
}
