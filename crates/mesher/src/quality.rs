//! Shape of the cells of a mesh.

use stickslip_fem_core::mesh::{Mesh, Point};

use crate::vector::corner_angles;

/// Extreme angles of a mesh of triangles, between straight lines through their corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Least angle of all cells `[rad]`.
    pub least_angle: f64,
    /// Greatest angle of all cells `[rad]`.
    pub greatest_angle: f64,
    /// The cell with the least angle, by global index.
    pub worst: usize,
}

/// Measures the angles of the cells of a mesh, each by its first three corners, in one pass.
pub fn quality(mesh: &Mesh) -> Quality {
    let mut all = Quality {
        least_angle: f64::INFINITY,
        greatest_angle: 0.0,
        worst: 0,
    };
    for cell in 0..mesh.element_count() {
        let (_, nodes, _) = mesh.element(cell);
        // Every kind has at least three corners.
        let corners: [Point; 3] = [0, 1, 2].map(|k| mesh.nodes()[nodes[k]]);
        for angle in corner_angles(corners) {
            all.greatest_angle = all.greatest_angle.max(angle);
            if angle < all.least_angle {
                (all.least_angle, all.worst) = (angle, cell);
            }
        }
    }
    all
}
