//! Stresses from displacements.
//!
//! ```text
//! σ = D (B u − ε₀)
//! ```
//!
//! [`ElasticField`] joins a mesh, its materials and a displacement, and offers the stress of its whole domain in three ways,
//! from plain to accurate: at the quadrature points, extrapolated to the nodes, and by superconvergent patch recovery.
//! On an edge whose tractions are known, as after a contact analysis, [`edge_stresses`] is better than all of them: only the
//! stress along the edge is then unknown, and it follows from the edge's own displacement.
//!
//! Stresses are (σ_xx, σ_yy, τ_xy) `[stress]`, tension positive.

mod edge;
mod gauss;
mod nodal;
mod patch;

use thiserror::Error;

pub use edge::{EdgeData, EdgeStress, PathEnd, PathEnds, edge_stresses};
pub use gauss::{ElasticField, GaussStresses};
pub use nodal::{BlockStresses, NodalStresses, extrapolation};

/// Input that does not fit together.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum StressError {
    /// An array of the wrong length.
    #[error("{name} has {found} entries, expected {expected}")]
    Length {
        /// Which array.
        name: &'static str,
        /// Entries needed.
        expected: usize,
        /// Entries given.
        found: usize,
    },
    /// An edge path with a number of nodes that its order and ends do not admit.
    #[error(
        "{nodes} nodes do not make {} edge path of order {order}: up to order 2 it takes two edges at least, three if closed, \
         beyond one, two if closed, of {order} nodes each and one more if open",
        if *closed { "a closed" } else { "an open" }
    )]
    PathNodes {
        /// Nodes given.
        nodes: usize,
        /// Order given.
        order: usize,
        /// Whether the path was declared closed.
        closed: bool,
    },
    /// An edge parameter that does not run strictly one way.
    #[error(
        "the edge parameter must increase or decrease strictly: {before} is followed by {after} after path node {node}"
    )]
    Parameter {
        /// Path node before the defect.
        node: usize,
        /// Parameter there `[length]`.
        before: f64,
        /// Parameter of the next node, one turn later if that is the first `[length]`.
        after: f64,
    },
    /// A direction that is not a unit vector.
    #[error("{name} at path node {node} has length {length}, must be 1 to within 1e-6")]
    Direction {
        /// Which vector.
        name: &'static str,
        /// Path node.
        node: usize,
        /// Its length `[1]`.
        length: f64,
    },
}

fn length(name: &'static str, expected: usize, found: usize) -> Result<(), StressError> {
    if expected == found {
        Ok(())
    } else {
        Err(StressError::Length {
            name,
            expected,
            found,
        })
    }
}

/// Components (σ_rr, σ_θθ, τ_rθ) `[stress]` of the stress (σ_xx, σ_yy, τ_xy) `[stress]` where the radius has the direction `theta` `[rad]`.
pub fn polar(stress: [f64; 3], theta: f64) -> [f64; 3] {
    let (s, c) = theta.sin_cos();
    let [xx, yy, xy] = stress;
    [
        c * c * xx + s * s * yy + 2.0 * s * c * xy,
        s * s * xx + c * c * yy - 2.0 * s * c * xy,
        s * c * (yy - xx) + (c * c - s * s) * xy,
    ]
}

/// Components (σ_xx, σ_yy, τ_xy) `[stress]` of the stress (σ_rr, σ_θθ, τ_rθ) `[stress]` where the radius has the direction `theta` `[rad]`.
pub fn cartesian(stress: [f64; 3], theta: f64) -> [f64; 3] {
    polar(stress, -theta)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_4;

    use approx::assert_relative_eq;

    use super::{cartesian, polar};

    #[test]
    fn pure_shear_is_tension_at_45_degrees() {
        let [rr, tt, rt] = polar([0.0, 0.0, 1.0], FRAC_PI_4);
        assert_relative_eq!(rr, 1.0, epsilon = 1e-15);
        assert_relative_eq!(tt, -1.0, epsilon = 1e-15);
        assert_relative_eq!(rt, 0.0, epsilon = 1e-15);
    }

    #[test]
    fn cartesian_undoes_polar() {
        let stress = [3.0, -2.0, 0.7];
        for theta in [-2.0, 0.0, 0.3, 1.9, 4.0] {
            let back = cartesian(polar(stress, theta), theta);
            for (a, b) in back.iter().zip(stress) {
                assert_relative_eq!(*a, b, epsilon = 1e-14);
            }
        }
    }
}
