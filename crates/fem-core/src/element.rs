//! Reference elements and the matrices made from them.
//!
//! On a cell with nodes xₐ the geometry and the displacement share the shape functions Nₐ(ξ),
//!
//! ```text
//! x(ξ) = Σₐ Nₐ xₐ,   u(ξ) = Σₐ Nₐ uₐ,   ε = Σₐ Bₐ uₐ,   Bₐ = [∂ₓNₐ 0; 0 ∂ᵧNₐ; ∂ᵧNₐ ∂ₓNₐ],
//! K = t ∫ Bᵀ D B dA,   f = t ∫ Bᵀ D ε₀ dA,   integrals by the element's own quadrature.
//! ```
//!
//! An [`Element`] holds only what is fixed by the reference cell: nodes, shape functions, sampling points. The material
//! enters the kernels as a 3×3 matrix D `[stress]`; t is the thickness `[length]`.
//!
//! | element | reference cell      | quadrature      | superconvergent points |
//! |---------|---------------------|-----------------|------------------------|
//! | T3      | (0,0) (1,0) (0,1)   | 1 point         | centroid               |
//! | T6      | (0,0) (1,0) (0,1)   | 3, interior     | the same 3             |
//! | Q4      | `[-1, 1]²`          | 2×2 Gauss       | centre                 |
//! | Q8, Q9  | `[-1, 1]²`          | 3×3 Gauss       | 2×2 Gauss              |
//! | P1 … P8 | `[-1, 1]²`          | (p + 1)² Gauss  | p×p Gauss              |
//!
//! Every rule leaves exactly the three rigid motions without energy. On a straight-sided T6 the three points integrate the
//! stiffness exactly; on a curved one they integrate the area exactly and the stiffness with an error of the order of the
//! discretisation error.
//!
//! Source: Zienkiewicz, Taylor and Zhu, *The Finite Element Method* (2005), chapters 5 and 14.

mod edge;
mod kernel;
mod legendre;
mod lobatto;
mod quadrature;
mod quads;
mod tangent;
mod triangles;

use std::fmt::Debug;

pub use edge::{EdgeValues, edge_nodes, edge_rule, edge_shape, edge_slope};
pub use kernel::{
    Jacobian, PhysicalGradients, gather, jacobian, physical_gradients, stiffness, thermal_load,
};
pub use lobatto::Lobatto;
pub use quads::{Q4, Q8, Q9};
pub use tangent::tangent_stiffness;
pub use triangles::{T3, T6};

use crate::kind::{ElementKind, Point};

/// A sampling point of a quadrature rule on the reference cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuadraturePoint {
    /// Reference coordinates (ξ, η) `[1]`.
    pub at: Point,
    /// Weight `[1]`; all weights of a rule sum to the area of the reference cell (4 or 1/2).
    pub weight: f64,
}

/// A reference cell with `N` nodes: geometry and sampling points, nothing about material.
///
/// Nodes are numbered as in [`ElementKind`]: corners counter-clockwise, inner nodes of edges along the walk, the inside. Those of an
/// edge are its Gauss–Lobatto points, on which the shape functions are [`edge_shape`].
pub trait Element<const N: usize>: Copy + Debug + Default + Send + Sync + 'static {
    /// The name by which meshes know the element.
    const KIND: ElementKind;
    /// Reference coordinates of the nodes.
    const NODES: [Point; N];
    /// Rule for the stiffness matrix.
    const QUADRATURE: &'static [QuadraturePoint];
    /// Points where the stress of a finite-element solution is one order more accurate than elsewhere (Barlow, 1976);
    /// exactly so on parallelogram quadrilaterals, in practice also on triangles.
    const SUPERCONVERGENT: &'static [Point];

    /// Shape functions Nₐ `[1]` at the reference point `xi`.
    fn shape(xi: Point) -> [f64; N];

    /// Gradients `[∂Nₐ/∂ξ, ∂Nₐ/∂η]` `[1]` at the reference point `xi`.
    fn gradients(xi: Point) -> [[f64; 2]; N];
}

/// Work that is written once for all elements and instantiated for the kind found in a mesh.
///
/// ```
/// use stickslip_fem_core::element::{Element, KindVisitor, with_element};
/// use stickslip_fem_core::mesh::ElementKind;
///
/// struct CountPoints;
/// impl KindVisitor for CountPoints {
///     type Output = usize;
///     fn visit<const N: usize, E: Element<N>>(self) -> usize {
///         E::QUADRATURE.len()
///     }
/// }
/// assert_eq!(with_element(ElementKind::Q8, CountPoints), 9);
/// ```
pub trait KindVisitor {
    /// What the work yields.
    type Output;

    /// Does the work for element `E` with `N` nodes.
    fn visit<const N: usize, E: Element<N>>(self) -> Self::Output;
}

/// Runs `visitor` for the element of `kind`. Call it once per block of cells, not once per cell.
pub fn with_element<V: KindVisitor>(kind: ElementKind, visitor: V) -> V::Output {
    match kind {
        ElementKind::T3 => visitor.visit::<3, T3>(),
        ElementKind::T6 => visitor.visit::<6, T6>(),
        ElementKind::Q4 => visitor.visit::<4, Q4>(),
        ElementKind::Q8 => visitor.visit::<8, Q8>(),
        ElementKind::Q9 => visitor.visit::<9, Q9>(),
        ElementKind::P1 => visitor.visit::<4, Lobatto<2, 4>>(),
        ElementKind::P2 => visitor.visit::<9, Lobatto<3, 9>>(),
        ElementKind::P3 => visitor.visit::<16, Lobatto<4, 16>>(),
        ElementKind::P4 => visitor.visit::<25, Lobatto<5, 25>>(),
        ElementKind::P5 => visitor.visit::<36, Lobatto<6, 36>>(),
        ElementKind::P6 => visitor.visit::<49, Lobatto<7, 49>>(),
        ElementKind::P7 => visitor.visit::<64, Lobatto<8, 64>>(),
        ElementKind::P8 => visitor.visit::<81, Lobatto<9, 81>>(),
    }
}

/// Reference coordinates of the nodes of `kind`, in its numbering `[1]`.
pub fn reference_nodes(kind: ElementKind) -> Vec<Point> {
    struct Nodes;
    impl KindVisitor for Nodes {
        type Output = Vec<Point>;
        fn visit<const N: usize, E: Element<N>>(self) -> Vec<Point> {
            E::NODES.to_vec()
        }
    }
    with_element(kind, Nodes)
}
