//! Errors of a nodal displacement against an exact field.
//!
//! ```text
//! ‖e‖² = ∫ |u − u_h|² dA,      ‖e‖_E² = ∫ (σ − σ_h) · S (σ − σ_h) dA
//! ```
//!
//! by a 5 × 5 Gauss rule per cell, p + 3 points each way for orders p > 2, on triangles through the collapsed square: enough points
//! to be blind to none of them, as a cell's own rule is, which sits where its stresses are superconvergent.

use stickslip_fem_core::element::{
    Element, KindVisitor, edge_rule, gather, physical_gradients, with_element,
};
use stickslip_fem_core::material::{Material, PlaneStiffness, apply};
use stickslip_fem_core::mesh::{Mesh, Point};

use super::fields::Field;

/// Errors in the two norms.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Errors {
    pub(crate) l2: f64,
    pub(crate) energy: f64,
}

/// Errors of the nodal displacement `u`.
pub(crate) fn errors(mesh: &Mesh, material: &dyn Material, u: &[f64], exact: &Field) -> Errors {
    let kind = mesh.blocks()[0].kind;
    let (stiffness, compliance) = (material.stiffness(), material.compliance());
    let squares = Squares {
        mesh,
        stiffness,
        compliance,
        u,
        exact,
    };
    let [l2, energy] = with_element(kind, squares).map(f64::sqrt);
    Errors { l2, energy }
}

/// Points of the reference cell with weights.
fn rule(order: usize, triangle: bool) -> Vec<(Point, f64)> {
    let mut points = Vec::new();
    for &(xi, w_xi) in edge_rule(order) {
        for &(eta, w_eta) in edge_rule(order) {
            points.push(if triangle {
                let (a, b) = (f64::midpoint(1.0, xi), f64::midpoint(1.0, eta));
                ([a, b * (1.0 - a)], w_xi * w_eta * (1.0 - a) / 4.0)
            } else {
                ([xi, eta], w_xi * w_eta)
            });
        }
    }
    points
}

struct Squares<'a> {
    mesh: &'a Mesh,
    stiffness: PlaneStiffness,
    compliance: PlaneStiffness,
    u: &'a [f64],
    exact: &'a Field,
}

impl KindVisitor for Squares<'_> {
    type Output = [f64; 2];

    fn visit<const N: usize, E: Element<N>>(self) -> [f64; 2] {
        let rule = rule(E::KIND.order(), E::KIND.corners() == 3);
        let mut sums = [0.0; 2];
        for cell in self.mesh.blocks()[0].connectivity.chunks_exact(N) {
            let x = gather::<N>(self.mesh.nodes(), cell);
            let moved: [[f64; 2]; N] =
                std::array::from_fn(|a| [0, 1].map(|i| self.u[2 * cell[a] + i]));
            for &(xi, weight) in &rule {
                let shape = E::shape(xi);
                let sum = |v: &[[f64; 2]; N]| {
                    [0, 1].map(|i| (0..N).map(|a| shape[a] * v[a][i]).sum::<f64>())
                };
                let (place, u) = (sum(&x), sum(&moved));
                let gradients = physical_gradients::<N, E>(&x, xi);
                let stress = apply(&self.stiffness, gradients.strain(&moved));
                let (exact_u, exact_stress) =
                    ((self.exact.displacement)(place), (self.exact.stress)(place));
                let wrong_u = [0, 1].map(|i| exact_u[i] - u[i]);
                let wrong = [0, 1, 2].map(|i| exact_stress[i] - stress[i]);
                let strain = apply(&self.compliance, wrong);
                let density: f64 = wrong.iter().zip(strain).map(|(a, b)| a * b).sum();
                let area = weight * gradients.det;
                sums[0] += area * (wrong_u[0] * wrong_u[0] + wrong_u[1] * wrong_u[1]);
                sums[1] += area * density;
            }
        }
        sums
    }
}
