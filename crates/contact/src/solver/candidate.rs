//! What a search by pivoting proposes.

use nalgebra::DVector;

use crate::state::Status;

/// A solution up to the springs.
pub(super) struct Candidate {
    pub(super) status: Vec<Status>,
    /// Normal force of each point.
    pub(super) normal: Vec<f64>,
    /// Slip increment of each point.
    pub(super) slip: Vec<f64>,
    /// Points without conditions that overlap, in ascending order.
    pub(super) overlapping: Vec<usize>,
    /// Rigid motions at which the springs would hold the bodies under these forces.
    pub(super) rigid: DVector<f64>,
}
