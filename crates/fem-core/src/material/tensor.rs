//! Rotation and inversion of plane matrices in Voigt order.
//!
//! ```text
//! ε' = T ε,   T = [c² s² sc; s² c² −sc; −2sc 2sc c²−s²]   components in axes turned by +φ
//! S' = T S Tᵀ,   D = Tᵀ D' T
//! ```
//!
//! Source: Jones, *Mechanics of Composite Materials* (1999), section 2.6, written for engineering shear.

use super::PlaneStiffness;

/// Matrix times vector: the stress `[stress]` of the strain `strain` under the stiffness `matrix`, or the strain `[1]` of a stress
/// under a compliance.
pub fn apply(matrix: &PlaneStiffness, strain: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * strain[0] + row[1] * strain[1] + row[2] * strain[2])
}

/// Inverse of a symmetric positive definite matrix, in the inverse of its unit, by cofactors and symmetric to the last bit. Entries are not finite
/// where `matrix` is singular.
pub fn inverse(matrix: &PlaneStiffness) -> PlaneStiffness {
    // A shear stiffness of another magnitude than the rest must not underflow the determinant: scale to a unit diagonal.
    let scale = [0, 1, 2].map(|i| matrix[i][i].sqrt());
    let m: PlaneStiffness =
        std::array::from_fn(|i| std::array::from_fn(|j| matrix[i][j] / (scale[i] * scale[j])));
    let c00 = m[1][1] * m[2][2] - m[1][2] * m[1][2];
    let c01 = m[0][2] * m[1][2] - m[0][1] * m[2][2];
    let c02 = m[0][1] * m[1][2] - m[0][2] * m[1][1];
    let c11 = m[0][0] * m[2][2] - m[0][2] * m[0][2];
    let c12 = m[0][1] * m[0][2] - m[0][0] * m[1][2];
    let c22 = m[0][0] * m[1][1] - m[0][1] * m[0][1];
    let det = m[0][0] * c00 + m[0][1] * c01 + m[0][2] * c02;
    let cofactors = [[c00, c01, c02], [c01, c11, c12], [c02, c12, c22]];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| cofactors[i][j] / (det * (scale[i] * scale[j])))
    })
}

fn strain_rotation([c, s]: [f64; 2]) -> PlaneStiffness {
    [
        [c * c, s * s, s * c],
        [s * s, c * c, -s * c],
        [-2.0 * s * c, 2.0 * s * c, c * c - s * s],
    ]
}

/// `t m tᵀ`, symmetric to the last bit.
fn congruence(t: &PlaneStiffness, m: &PlaneStiffness) -> PlaneStiffness {
    let half = t.map(|row| apply(m, row));
    let entry =
        |i: usize, j: usize| half[i][0] * t[j][0] + half[i][1] * t[j][1] + half[i][2] * t[j][2];
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i.min(j), i.max(j))))
}

fn transpose(m: &PlaneStiffness) -> PlaneStiffness {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
}

/// The compliance `compliance` `[1/stress]`, given in (x, y), in axes whose first direction is the unit vector `axis`.
pub fn rotated_compliance(compliance: &PlaneStiffness, axis: [f64; 2]) -> PlaneStiffness {
    congruence(&strain_rotation(axis), compliance)
}

/// The stiffness `stiffness` `[stress]`, given in (x, y), in axes whose first direction is the unit vector `axis`.
pub fn rotated_stiffness(stiffness: &PlaneStiffness, axis: [f64; 2]) -> PlaneStiffness {
    // Stress rotates by the inverse transpose of the strain rotation, which is the transpose for the opposite angle.
    congruence(&transpose(&strain_rotation([axis[0], -axis[1]])), stiffness)
}

/// The strain `strain` (ε_xx, ε_yy, γ_xy) `[1]`, given in (x, y), in axes whose first direction is the unit vector `axis`.
pub fn rotated_strain(strain: [f64; 3], axis: [f64; 2]) -> [f64; 3] {
    apply(&strain_rotation(axis), strain)
}
