//! Stress resultants on circles around the origin, from stresses at the nodes of a mesh.
//!
//! ```text
//! F(r) = t ∫ σ e_r r dθ        the force on the material inside the circle by the material outside
//! ```
//!
//! Without body forces F balances what acts on the hole's edge, at any radius. Stresses between nodes follow the shape
//! functions of the cell that holds the point, found by Newton's method on x(ξ) = x.

use stickslip_fem_core::element::{Element, KindVisitor, gather, jacobian, with_element};
use stickslip_fem_core::mesh::{ElementBlock, Mesh, Point};

/// How far outside a cell, in reference coordinates, a point still counts as inside.
const EDGE: f64 = 1e-8;

/// The force F(r) `[stress·length²]` for `thickness`, from `points` equal steps over the angles from 0 to `turn` `[rad]`.
///
/// # Panics
/// If a part of the circle is outside the mesh.
pub fn force_on_arc(
    mesh: &Mesh,
    stress: &[[f64; 3]],
    thickness: f64,
    radius: f64,
    turn: f64,
    points: usize,
) -> [f64; 2] {
    let mut force = [0.0; 2];
    let share = turn / points as f64;
    for k in 0..points {
        let (s, c) = ((k as f64 + 0.5) * share).sin_cos();
        let place = [radius * c, radius * s];
        let [xx, yy, xy] = stress_at(mesh, stress, place)
            .unwrap_or_else(|| panic!("{place:?} is outside the mesh"));
        force[0] += thickness * radius * share * (xx * c + xy * s);
        force[1] += thickness * radius * share * (xy * c + yy * s);
    }
    force
}

/// Stress at a point, interpolated from the nodes of the cell around it.
fn stress_at(mesh: &Mesh, stress: &[[f64; 3]], place: Point) -> Option<[f64; 3]> {
    mesh.blocks().iter().find_map(|block| {
        let search = Search {
            mesh,
            block,
            stress,
            place,
        };
        with_element(block.kind, search)
    })
}

struct Search<'a> {
    mesh: &'a Mesh,
    block: &'a ElementBlock,
    stress: &'a [[f64; 3]],
    place: Point,
}

impl KindVisitor for Search<'_> {
    type Output = Option<[f64; 3]>;

    fn visit<const N: usize, E: Element<N>>(self) -> Option<[f64; 3]> {
        self.block.connectivity.chunks_exact(N).find_map(|cell| {
            let x = gather::<N>(self.mesh.nodes(), cell);
            let shape = E::shape(locate::<N, E>(&x, self.place)?);
            let mut sum = [0.0; 3];
            for (&node, weight) in cell.iter().zip(shape) {
                (0..3).for_each(|i| sum[i] += weight * self.stress[node][i]);
            }
            Some(sum)
        })
    }
}

/// Reference coordinates of `place` in the cell with nodes `x`, `None` if it lies outside.
fn locate<const N: usize, E: Element<N>>(x: &[Point; N], place: Point) -> Option<Point> {
    let range = |axis: usize| {
        let values = x.iter().map(|node| node[axis]);
        let (low, high) = values.fold((f64::MAX, f64::MIN), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        // A curved side may bulge beyond its nodes.
        let margin = 0.25 * (high - low);
        (low - margin)..=(high + margin)
    };
    if !(range(0).contains(&place[0]) && range(1).contains(&place[1])) {
        return None;
    }
    let triangle = E::KIND.corners() == 3;
    let mut xi = if triangle { [1.0 / 3.0; 2] } else { [0.0; 2] };
    for _ in 0..12 {
        let shape = E::shape(xi);
        let missing: [f64; 2] = std::array::from_fn(|axis| {
            place[axis] - (0..N).map(|a| shape[a] * x[a][axis]).sum::<f64>()
        });
        let inverse = jacobian::<N, E>(x, xi).inverse;
        let step = inverse.map(|row| row[0] * missing[0] + row[1] * missing[1]);
        xi = [xi[0] + step[0], xi[1] + step[1]];
        if step[0].abs().max(step[1].abs()) < 1e-13 {
            break;
        }
    }
    let inside = if triangle {
        xi[0] > -EDGE && xi[1] > -EDGE && xi[0] + xi[1] < 1.0 + EDGE
    } else {
        xi[0].abs() < 1.0 + EDGE && xi[1].abs() < 1.0 + EDGE
    };
    inside.then_some(xi)
}
