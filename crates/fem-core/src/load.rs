//! Nodal forces of loads.
//!
//! ```text
//! f_a = t ∫ N_a q ds   (tractions q on edges)      f = t ∫ Bᵀ D ε₀ dA   (initial strain ε₀)
//! ```

use nalgebra::{Matrix2, Vector2};

use crate::element::{
    EdgeValues, Element, KindVisitor, edge_rule, edge_shape, edge_slope, gather,
    physical_gradients, thermal_load, with_element,
};
use crate::material::PlaneStiffness;
use crate::mesh::{Curve, EdgeRef, Mesh, Point};

/// Part of its area by which the area inside the rim of a disk may differ from it.
const ENCLOSED: f64 = 1e-6;

/// Where a traction is evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgePoint {
    /// Position `[length]`.
    pub position: Point,
    /// Unit outward normal `[1]`.
    pub normal: [f64; 2],
}

/// Forces `[force]` on all nodes, interleaved (2 × nodes), of a traction `[stress]` on `edges` of a body of `thickness`
/// `[length]`. The traction is integrated by the Gauss points of [`edge_rule`] on each isoparametric edge.
pub fn edge_load(
    mesh: &Mesh,
    edges: &[EdgeRef],
    thickness: f64,
    traction: impl Fn(EdgePoint) -> [f64; 2],
) -> Vec<f64> {
    let mut forces = vec![0.0; 2 * mesh.nodes().len()];
    for &edge in edges {
        let nodes = mesh.edge_nodes(edge);
        let order = nodes.order();
        // The ends come first, here and in the sums.
        let ends_first = |values: EdgeValues| {
            let [first, inner @ ..] = values;
            [first, values[order]].into_iter().chain(inner)
        };
        for &(xi, weight) in edge_rule(order) {
            let interpolate = |values: EdgeValues| -> Point {
                let terms = nodes.all().zip(ends_first(values));
                terms.fold([0.0; 2], |[x, y], (node, value)| {
                    let at = mesh.nodes()[node];
                    [x + value * at[0], y + value * at[1]]
                })
            };
            let (shape, slope) = (edge_shape(order, xi), edge_slope(order, xi));
            let tangent = interpolate(slope);
            let speed = tangent[0].hypot(tangent[1]);
            let normal = [tangent[1] / speed, -tangent[0] / speed];
            let q = traction(EdgePoint {
                position: interpolate(shape),
                normal,
            });
            let factor = weight * speed * thickness;
            for (node, value) in nodes.all().zip(ends_first(shape)) {
                forces[2 * node] += factor * value * q[0];
                forces[2 * node + 1] += factor * value * q[1];
            }
        }
    }
    forces
}

/// Computes the part ∫ N_a (1 + g · (x − c)) dA `[length²]` that each node has of the body's area.
///
/// g is zero but for a disk, whose centre c it makes the centroid of the parts. The facets of a rim that is divided unevenly move it by some 10⁻⁷ of the
/// radius, which turns a pin without friction.
pub fn area_load(mesh: &Mesh) -> Vec<f64> {
    let areas = area_integral(mesh, |_| 1.0);
    match disk_centre(mesh, areas.iter().sum()) {
        Some(centre) => centred(mesh.nodes(), areas, centre),
        None => areas,
    }
}

/// Centre of the circle that is the whole boundary of the mesh of a body of the area `area` `[length²]`; `None` of other bodies.
fn disk_centre(mesh: &Mesh, area: f64) -> Option<Point> {
    mesh.edge_set_names().find_map(|name| {
        let set = mesh.edge_set(name).ok()?;
        let Some(Curve::Arc { centre, .. }) = set.curve else {
            return None;
        };
        let closed = mesh.edge_path(name).is_ok_and(|path| path.closed);
        // ½ ∮ (x − c) · n ds
        let half_flux = |at: EdgePoint| {
            let [x, y] = [0, 1].map(|axis| (at.position[axis] - centre[axis]) * at.normal[axis]);
            [0.5 * (x + y), 0.0]
        };
        let enclosed: f64 = edge_load(mesh, &set.edges, 1.0, half_flux).iter().sum();
        (closed && (enclosed - area).abs() <= ENCLOSED * area).then_some(centre)
    })
}

/// `areas` of `nodes` `[length²]`, times what is linear in the place and moves their centroid to `centre`.
fn centred(nodes: &[Point], mut areas: Vec<f64>, centre: Point) -> Vec<f64> {
    let from = |[x, y]: Point| Vector2::new(x - centre[0], y - centre[1]);
    let (mut first, mut second) = (Vector2::zeros(), Matrix2::zeros());
    for (&node, &area) in nodes.iter().zip(&areas) {
        let away = from(node);
        first += area * away;
        second += area * away * away.transpose();
    }
    if let Some(slope) = second.lu().solve(&first) {
        for (area, &node) in areas.iter_mut().zip(nodes) {
            *area *= 1.0 - slope.dot(&from(node));
        }
    }
    areas
}

/// Computes ∫ N_a f dA of a function f of the place, for each node, in the unit of f times `[length²]`.
pub fn area_integral(mesh: &Mesh, function: impl Fn(Point) -> f64) -> Vec<f64> {
    struct Visit<'a, F> {
        mesh: &'a Mesh,
        connectivity: &'a [usize],
        function: &'a F,
        integrals: &'a mut [f64],
    }
    impl<F: Fn(Point) -> f64> KindVisitor for Visit<'_, F> {
        type Output = ();
        fn visit<const N: usize, E: Element<N>>(self) {
            for cell in self.connectivity.chunks_exact(N) {
                let x = gather::<N>(self.mesh.nodes(), cell);
                for point in E::QUADRATURE {
                    let shapes = E::shape(point.at);
                    let place = [0, 1].map(|axis| {
                        let terms = x.iter().zip(shapes.iter());
                        terms.map(|(at, shape)| at[axis] * shape).sum()
                    });
                    let weight = point.weight * physical_gradients::<N, E>(&x, point.at).det;
                    let weight = weight * (self.function)(place);
                    for (&node, shape) in cell.iter().zip(shapes) {
                        self.integrals[node] += weight * shape;
                    }
                }
            }
        }
    }
    let mut integrals = vec![0.0; mesh.nodes().len()];
    for block in mesh.blocks() {
        let visit = Visit {
            mesh,
            connectivity: &block.connectivity,
            function: &function,
            integrals: &mut integrals,
        };
        with_element(block.kind, visit);
    }
    integrals
}

/// Forces `[force]` on all nodes, interleaved, of one initial strain (ε_xx, ε_yy, γ_xy) per block, with the blocks'
/// stiffnesses `[stress]`; strains `[1]`, `thickness` `[length]`.
pub fn initial_strain_load(
    mesh: &Mesh,
    stiffness: &[PlaneStiffness],
    strain: &[[f64; 3]],
    thickness: f64,
) -> Vec<f64> {
    struct Visit<'a> {
        mesh: &'a Mesh,
        connectivity: &'a [usize],
        stiffness: &'a PlaneStiffness,
        strain: [f64; 3],
        thickness: f64,
        forces: &'a mut [f64],
    }
    impl KindVisitor for Visit<'_> {
        type Output = ();
        fn visit<const N: usize, E: Element<N>>(self) {
            let mut local = vec![0.0; 2 * N];
            for cell in self.connectivity.chunks_exact(N) {
                let x = gather::<N>(self.mesh.nodes(), cell);
                thermal_load::<N, E>(&x, self.stiffness, self.strain, self.thickness, &mut local);
                for (&node, force) in cell.iter().zip(local.chunks_exact(2)) {
                    self.forces[2 * node] += force[0];
                    self.forces[2 * node + 1] += force[1];
                }
            }
        }
    }
    let mut forces = vec![0.0; 2 * mesh.nodes().len()];
    for ((block, stiffness), &strain) in mesh.blocks().iter().zip(stiffness).zip(strain) {
        let visit = Visit {
            mesh,
            connectivity: &block.connectivity,
            stiffness,
            strain,
            thickness,
            forces: &mut forces,
        };
        with_element(block.kind, visit);
    }
    forces
}
