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

mod blocks;
pub mod contract;
mod misfit;

use std::borrow::Cow;
use std::fmt::Debug;

use nalgebra::{DMatrix, DVector};
use thiserror::Error;

use crate::mesh::Point;
pub use blocks::{Block, BlockCompliance};
pub use misfit::Misfit;
use misfit::fits;

/// A body reduced to its contact points; how it was made is its own affair.
pub trait InterfaceOperator: Debug + Send + Sync {
    /// Positions of the contact points `[length]`, undeformed.
    fn points(&self) -> &[Point];

    /// Compliance C `[length/force]`, 2n × 2n; `None` for a rigid body, and where it is held as [`blocks`](Self::blocks).
    fn compliance(&self) -> Option<&DMatrix<f64>>;

    /// Compliance C `[length/force]` of a body that has too many contact points for one matrix; `None` for others.
    fn blocks(&self) -> Option<&BlockCompliance> {
        None
    }

    /// Compliance C `[length/force]` as one matrix, made of its blocks where it is held in blocks; `None` for a rigid body.
    fn matrix(&self) -> Option<Cow<'_, DMatrix<f64>>> {
        let own = self.compliance().map(Cow::Borrowed);
        own.or_else(|| self.blocks().map(|blocks| Cow::Owned(blocks.matrix())))
    }

    /// The compliance `[length/force]` of each component of the contact points under its own force, 2n; `None` for a rigid body.
    fn give_of_each(&self) -> Option<DVector<f64>> {
        let own = self.compliance().map(DMatrix::diagonal);
        own.or_else(|| self.blocks().map(BlockCompliance::diagonal))
    }

    /// Whether contact forces deform it.
    fn gives(&self) -> bool {
        self.compliance().is_some() || self.blocks().is_some()
    }

    /// Computes the displacements C λ `[length]` of the contact points, 2n, by the forces `forces` `[force]` on them, 2n; zero for a rigid
    /// body.
    fn give(&self, forces: &DVector<f64>) -> DVector<f64> {
        match (self.compliance(), self.blocks()) {
            (Some(compliance), _) => compliance * forces,
            (None, Some(blocks)) => blocks.times(forces),
            (None, None) => DVector::zeros(forces.len()),
        }
    }

    /// Rigid motions R `[1]` of the contact points, 2n × f: their displacements `[length]` over the amount `[length]` of each; f = 0 for a body that is held.
    fn modes(&self) -> &DMatrix<f64>;

    /// Number of load cases.
    fn load_cases(&self) -> usize;

    /// Response u_k `[length]` of the contact points to load case `case`, 2n; `None` where the case does not load this body.
    fn load_response(&self, case: usize) -> Option<&DVector<f64>>;

    /// Resultants r_k `[force]` of load case `case` in the rigid motions, f.
    fn mode_load(&self, case: usize) -> &DVector<f64>;

    /// Computes the displacements u `[length]` of the contact points, 2n, under the forces `forces` `[force]`, 2n, the rigid motions `amounts` `[length]`, f, and the
    /// load multipliers `multipliers` `[1]`, by the module's first equation. Points without force cost nothing.
    fn displacements(&self, forces: &[f64], amounts: &[f64], multipliers: &[f64]) -> DVector<f64> {
        let mut displacements = self.modes() * DVector::from_column_slice(amounts);
        if let Some(compliance) = self.compliance() {
            for (column, &force) in forces.iter().enumerate() {
                if force != 0.0 {
                    displacements.axpy(force, &compliance.column(column), 1.0);
                }
            }
        } else if let Some(blocks) = self.blocks() {
            displacements += blocks.times(&DVector::from_column_slice(forces));
        }
        for (case, &factor) in multipliers.iter().enumerate() {
            if let Some(response) = self.load_response(case) {
                displacements.axpy(factor, response, 1.0);
            }
        }
        displacements
    }
}

/// Computes the rigid motions of `points` `[length]`, 2n × 3 `[1]`: translations along x and y, and the turn about `centre` `[length]`
/// divided by `length` `[length]`.
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
    /// A rigid body that cannot move, with contact points at `points` `[length]`.
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

/// Why numbers make no operator.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum GivenBodyError {
    /// A matrix or a vector does not fit the others, or is not finite.
    #[error(transparent)]
    Misfit(#[from] Misfit),
    /// The numbers of load cases differ.
    #[error("{responses} responses and {mode_loads} resultants of load cases")]
    LoadCases {
        /// Number of responses.
        responses: usize,
        /// Number of resultants.
        mode_loads: usize,
    },
}

/// A body given by the numbers of its operator. Its points lie on the y axis, one apart.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenBody {
    points: Vec<Point>,
    compliance: DMatrix<f64>,
    modes: DMatrix<f64>,
    responses: Vec<DVector<f64>>,
    mode_loads: Vec<DVector<f64>>,
}

impl GivenBody {
    /// A held body with compliance `compliance` `[length/force]`, 2n × 2n, and `responses[k]` `[length]` the motion of its
    /// points by load case `k`, 2n.
    ///
    /// # Errors
    /// [`GivenBodyError`] if a shape does not fit or a number is not finite.
    pub fn held(
        compliance: DMatrix<f64>,
        responses: Vec<DVector<f64>>,
    ) -> Result<Self, GivenBodyError> {
        let modes = DMatrix::zeros(compliance.nrows(), 0);
        let mode_loads = vec![DVector::zeros(0); responses.len()];
        Self::floating(compliance, modes, responses, mode_loads)
    }

    /// A body that floats along `modes`, 2n × f, with `mode_loads[k]` `[force]` the resultants of load case `k` in them, f.
    ///
    /// # Errors
    /// As [`GivenBody::held`], and if responses and resultants differ in number.
    pub fn floating(
        compliance: DMatrix<f64>,
        modes: DMatrix<f64>,
        responses: Vec<DVector<f64>>,
        mode_loads: Vec<DVector<f64>>,
    ) -> Result<Self, GivenBodyError> {
        let count = compliance.nrows() / 2;
        let (size, free) = (2 * count, modes.ncols());
        let name = |what: &'static str| move || what.to_owned();
        fits(name("the compliance"), &compliance, [size, size])?;
        fits(name("the matrix of rigid motions"), &modes, [size, free])?;
        if responses.len() != mode_loads.len() {
            return Err(GivenBodyError::LoadCases {
                responses: responses.len(),
                mode_loads: mode_loads.len(),
            });
        }
        for (case, (response, load)) in responses.iter().zip(&mode_loads).enumerate() {
            let name = |what: &'static str| move || format!("{what} load case {}", case + 1);
            fits(name("the response to"), response, [size, 1])?;
            fits(name("the resultant of"), load, [free, 1])?;
        }
        Ok(Self {
            points: (0..count).map(|k| [0.0, k as f64]).collect(),
            compliance,
            modes,
            responses,
            mode_loads,
        })
    }
}

impl InterfaceOperator for GivenBody {
    fn points(&self) -> &[Point] {
        &self.points
    }

    fn compliance(&self) -> Option<&DMatrix<f64>> {
        Some(&self.compliance)
    }

    fn modes(&self) -> &DMatrix<f64> {
        &self.modes
    }

    fn load_cases(&self) -> usize {
        self.responses.len()
    }

    fn load_response(&self, case: usize) -> Option<&DVector<f64>> {
        Some(&self.responses[case])
    }

    fn mode_load(&self, case: usize) -> &DVector<f64> {
        &self.mode_loads[case]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_do_not_fit_are_refused() {
        let square = |size| DMatrix::<f64>::identity(size, size);
        let response = |size| vec![DVector::zeros(size)];
        assert!(GivenBody::held(square(4), response(4)).is_ok());
        let shape = |what: &str, own: [usize; 2], expected: [usize; 2]| {
            Err(GivenBodyError::Misfit(Misfit::Shape {
                what: what.to_owned(),
                rows: own[0],
                columns: own[1],
                expected_rows: expected[0],
                expected_columns: expected[1],
            }))
        };
        let odd = GivenBody::held(square(3), response(3));
        assert_eq!(odd, shape("the compliance", [3, 3], [2, 2]));
        let text = odd.unwrap_err().to_string();
        assert!(text.contains("3 × 3, where 2 × 2 is needed"), "{text}");
        assert_eq!(
            GivenBody::held(square(4), response(2)),
            shape("the response to load case 1", [2, 1], [4, 1])
        );
        let floating = |resultants| {
            GivenBody::floating(square(4), DMatrix::zeros(4, 1), response(4), resultants)
        };
        assert_eq!(
            floating(response(2)),
            shape("the resultant of load case 1", [2, 1], [1, 1])
        );
        let none = floating(Vec::new()).unwrap_err();
        let text = none.to_string();
        assert!(text.contains("1 responses and 0 resultants"), "{text}");
        let expected = GivenBodyError::LoadCases {
            responses: 1,
            mode_loads: 0,
        };
        assert_eq!(none, expected);
        let infinite = GivenBody::held(square(2) * f64::NAN, Vec::new()).unwrap_err();
        assert_eq!(infinite.to_string(), "the compliance is not finite");
    }
}
