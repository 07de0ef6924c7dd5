//! Element matrices: the inner loop of assembly.
//!
//! With the gradient g_a = J⁻ᵀ ∂N_a/∂ξ and the four numbers M_ab = t ∫ g_a g_bᵀ dA per pair of nodes, the 2×2 blocks of
//! the stiffness are, D being constant over the cell,
//!
//! ```text
//! K_ab[0][0] = D₀₀ M₀₀ + D₀₂ (M₀₁ + M₁₀) + D₂₂ M₁₁      K_ab[0][1] = D₀₁ M₀₁ + D₀₂ M₀₀ + D₁₂ M₁₁ + D₂₂ M₁₀
//! K_ab[1][1] = D₁₁ M₁₁ + D₁₂ (M₀₁ + M₁₀) + D₂₂ M₀₀      K_ab[1][0] = K_ab[0][1] with M₀₁ and M₁₀ exchanged
//! ```
//!
//! so the loop over quadrature points accumulates only M, half the work of Bᵀ D B.

use super::Element;
use crate::kind::Point;
use crate::material::PlaneStiffness;

/// Derivative of the map from the reference cell to the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobian {
    /// det ∂x/∂ξ `[length²]`; positive in every cell of a [`Mesh`](crate::mesh::Mesh).
    pub det: f64,
    /// `inverse[i][j]` = ∂ξᵢ/∂xⱼ `[1/length]`; not finite where `det` is zero.
    pub inverse: [[f64; 2]; 2],
}

/// Shape-function gradients in the plane at one point of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhysicalGradients<const N: usize> {
    /// det ∂x/∂ξ `[length²]`.
    pub det: f64,
    /// `[∂Nₐ/∂x, ∂Nₐ/∂y]` for each node `[1/length]`.
    pub gradients: [[f64; 2]; N],
}

impl<const N: usize> PhysicalGradients<N> {
    /// Strain (ε_xx, ε_yy, γ_xy) `[1]` of the nodal displacements `u` `[length]`.
    pub fn strain(&self, u: &[[f64; 2]; N]) -> [f64; 3] {
        let mut strain = [0.0; 3];
        for ([gx, gy], [ux, uy]) in self.gradients.iter().zip(u) {
            strain[0] += gx * ux;
            strain[1] += gy * uy;
            strain[2] += gy * ux + gx * uy;
        }
        strain
    }
}

/// Coordinates of one cell's nodes `[length]`. `connectivity` holds `N` valid indices into `nodes`, as in every block of a
/// [`Mesh`](crate::mesh::Mesh).
pub fn gather<const N: usize>(nodes: &[Point], connectivity: &[usize]) -> [Point; N] {
    std::array::from_fn(|a| nodes[connectivity[a]])
}

fn jacobian_of<const N: usize>(x: &[Point; N], gradients: &[[f64; 2]; N]) -> Jacobian {
    let mut j = [[0.0; 2]; 2];
    for ([px, py], [d_xi, d_eta]) in x.iter().zip(gradients) {
        j[0][0] += px * d_xi;
        j[0][1] += px * d_eta;
        j[1][0] += py * d_xi;
        j[1][1] += py * d_eta;
    }
    let det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    let inverse = [
        [j[1][1] / det, -j[0][1] / det],
        [-j[1][0] / det, j[0][0] / det],
    ];
    Jacobian { det, inverse }
}

/// Jacobian of the cell with nodes `x` `[length]` at the reference point `xi`.
pub fn jacobian<const N: usize, E: Element<N>>(x: &[Point; N], xi: Point) -> Jacobian {
    jacobian_of(x, &E::gradients(xi))
}

/// Gradients `[1/length]` of the shape functions with respect to x and y at the reference point `xi`: the entries of the
/// strain–displacement matrix B.
pub fn physical_gradients<const N: usize, E: Element<N>>(
    x: &[Point; N],
    xi: Point,
) -> PhysicalGradients<N> {
    let reference = E::gradients(xi);
    let Jacobian { det, inverse } = jacobian_of(x, &reference);
    let gradients = reference.map(|[d_xi, d_eta]| {
        [
            d_xi * inverse[0][0] + d_eta * inverse[1][0],
            d_xi * inverse[0][1] + d_eta * inverse[1][1],
        ]
    });
    PhysicalGradients { det, gradients }
}

/// Stiffness matrix `[force/length]` of the cell with nodes `x` `[length]`, symmetric material matrix `d` `[stress]` and
/// `thickness` `[length]`.
///
/// `out` receives (2N)² numbers row by row, `out[(2a + i) * 2N + 2b + j]` for nodes a, b and directions i, j; whatever it
/// held before is overwritten. The result is symmetric to the last bit.
pub fn stiffness<const N: usize, E: Element<N>>(
    x: &[Point; N],
    d: &PlaneStiffness,
    thickness: f64,
    out: &mut [f64],
) {
    let mut xx = [[0.0; N]; N];
    let mut xy = [[0.0; N]; N];
    let mut yy = [[0.0; N]; N];
    for point in E::QUADRATURE {
        let PhysicalGradients { det, gradients } = physical_gradients::<N, E>(x, point.at);
        let weight = point.weight * det * thickness;
        let gx = gradients.map(|g| g[0]);
        let gy = gradients.map(|g| g[1]);
        for a in 0..N {
            let (wx, wy) = (weight * gx[a], weight * gy[a]);
            for b in 0..N {
                xx[a][b] += wx * gx[b];
                xy[a][b] += wx * gy[b];
                yy[a][b] += wy * gy[b];
            }
        }
    }
    let width = 2 * N;
    for a in 0..N {
        for b in a..N {
            let (m00, m01, m10, m11) = (xx[a][b], xy[a][b], xy[b][a], yy[a][b]);
            let diagonal = [
                d[0][0] * m00 + d[0][2] * (m01 + m10) + d[2][2] * m11,
                d[1][1] * m11 + d[1][2] * (m01 + m10) + d[2][2] * m00,
            ];
            let coupling = d[0][2] * m00 + d[1][2] * m11;
            let upper = coupling + d[0][1] * m01 + d[2][2] * m10;
            let lower = coupling + d[0][1] * m10 + d[2][2] * m01;
            let block = [[diagonal[0], upper], [lower, diagonal[1]]];
            for i in 0..2 {
                for j in 0..2 {
                    out[(2 * a + i) * width + 2 * b + j] = block[i][j];
                    out[(2 * b + j) * width + 2 * a + i] = block[i][j];
                }
            }
        }
    }
}

/// Nodal forces `[force]` by which an initial strain `strain` (ε_xx, ε_yy, γ_xy) `[1]` loads the cell: f = t ∫ Bᵀ D ε₀ dA.
///
/// `out` receives 2N numbers, interleaved; whatever it held before is overwritten. Arguments otherwise as for
/// [`stiffness`].
pub fn thermal_load<const N: usize, E: Element<N>>(
    x: &[Point; N],
    d: &PlaneStiffness,
    strain: [f64; 3],
    thickness: f64,
    out: &mut [f64],
) {
    let stress = crate::material::apply(d, strain);
    out[..2 * N].fill(0.0);
    for point in E::QUADRATURE {
        let PhysicalGradients { det, gradients } = physical_gradients::<N, E>(x, point.at);
        let weight = point.weight * det * thickness;
        for (force, [gx, gy]) in out.chunks_exact_mut(2).zip(gradients) {
            force[0] += weight * (gx * stress[0] + gy * stress[2]);
            force[1] += weight * (gy * stress[1] + gx * stress[2]);
        }
    }
}
