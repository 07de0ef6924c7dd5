//! The stiffness of a cell whose material differs from point to point: K = t Σ_q w_q det J_q Bᵀ D_q B.

use super::{Element, PhysicalGradients, physical_gradients};
use crate::kind::Point;
use crate::material::PlaneStiffness;

/// Stiffness matrix `[force/length]` of the cell with nodes `x` `[length]`, one symmetric material matrix `[stress]` of
/// `tangents` per quadrature point of `E`, and `thickness` `[length]`.
///
/// `out` receives (2N)² numbers row by row, as in [`stiffness`](super::stiffness); whatever it held before is overwritten.
pub fn tangent_stiffness<const N: usize, E: Element<N>>(
    x: &[Point; N],
    tangents: &[PlaneStiffness],
    thickness: f64,
    out: &mut [f64],
) {
    let width = 2 * N;
    out[..width * width].fill(0.0);
    for (point, d) in E::QUADRATURE.iter().zip(tangents) {
        let PhysicalGradients { det, gradients } = physical_gradients::<N, E>(x, point.at);
        let weight = point.weight * det * thickness;
        for (a, [gx, gy]) in gradients.into_iter().enumerate() {
            // Rows of Bₐᵀ D, times the weight.
            let rows = [
                [0, 1, 2].map(|k| weight * (gx * d[0][k] + gy * d[2][k])),
                [0, 1, 2].map(|k| weight * (gy * d[1][k] + gx * d[2][k])),
            ];
            for (b, [hx, hy]) in gradients.into_iter().enumerate().skip(a) {
                for (i, row) in rows.iter().enumerate() {
                    let at = (2 * a + i) * width + 2 * b;
                    out[at] += row[0] * hx + row[2] * hy;
                    out[at + 1] += row[1] * hy + row[2] * hx;
                }
            }
        }
    }
    for row in 0..width {
        for column in 0..row {
            out[row * width + column] = out[column * width + row];
        }
    }
}
