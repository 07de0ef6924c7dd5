//! Nodal fields at places inside a mesh: the cell that holds the place, and its shape functions there.

use stickslip_fem_core::element::{Element, KindVisitor, gather, with_element};
use stickslip_fem_core::mesh::{ElementKind, Mesh, Point};

/// How far outside its reference cell a place may be found: rounding, and the bulge of curved sides.
const OUTSIDE: f64 = 1e-6;
/// Newton's method on the map of a cell that is not degenerate takes far fewer.
const ITERATIONS: usize = 30;

/// A place as a weighted mean of nodes.
#[derive(Clone, Debug)]
pub(crate) struct Sample {
    nodes: Vec<usize>,
    weights: Vec<f64>,
}

impl Sample {
    /// The field with these nodal values there.
    pub(crate) fn of(&self, values: &[[f64; 3]]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (&node, weight) in self.nodes.iter().zip(&self.weights) {
            (0..3).for_each(|i| sum[i] += weight * values[node][i]);
        }
        sum
    }
}

/// The places as means of nodes; `None` where the mesh does not reach.
pub(crate) fn locate(mesh: &Mesh, places: &[Point]) -> Vec<Option<Sample>> {
    let mut found = vec![None; places.len()];
    for cell in 0..mesh.element_count() {
        let (kind, nodes, _) = mesh.element(cell);
        let [low, high] = bounds(mesh, nodes);
        for (place, sample) in places.iter().zip(&mut found) {
            let inside = |axis: usize| (low[axis]..=high[axis]).contains(&place[axis]);
            if sample.is_none() && inside(0) && inside(1) {
                *sample = in_cell(mesh, kind, nodes, *place);
            }
        }
    }
    found
}

/// A box around a cell, with room for sides that bulge between their nodes.
fn bounds(mesh: &Mesh, nodes: &[usize]) -> [Point; 2] {
    let ends = |axis: usize| {
        let along = nodes.iter().map(|&node| mesh.nodes()[node][axis]);
        let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        let room = 0.25 * (high - low);
        (low - room, high + room)
    };
    let ((left, right), (bottom, top)) = (ends(0), ends(1));
    [[left, bottom], [right, top]]
}

fn in_cell(mesh: &Mesh, kind: ElementKind, nodes: &[usize], place: Point) -> Option<Sample> {
    let weights = with_element(kind, Inverse { mesh, nodes, place })?;
    Some(Sample {
        nodes: nodes.to_vec(),
        weights,
    })
}

/// Newton's method for x(ξ) = place; the shape functions at the answer.
struct Inverse<'a> {
    mesh: &'a Mesh,
    nodes: &'a [usize],
    place: Point,
}

impl KindVisitor for Inverse<'_> {
    type Output = Option<Vec<f64>>;

    fn visit<const N: usize, E: Element<N>>(self) -> Self::Output {
        let x: [Point; N] = gather(self.mesh.nodes(), self.nodes);
        let size = (0..N).map(|a| (x[a][0] - x[0][0]).hypot(x[a][1] - x[0][1]));
        let size = size.fold(0.0, f64::max);
        let triangle = E::KIND.corners() == 3;
        let mut xi: Point = if triangle { [1.0 / 3.0; 2] } else { [0.0; 2] };
        for _ in 0..ITERATIONS {
            let (shape, gradients) = (E::shape(xi), E::gradients(xi));
            let mut miss = self.place;
            let mut j = [[0.0; 2]; 2];
            for a in 0..N {
                for i in 0..2 {
                    miss[i] -= shape[a] * x[a][i];
                    (0..2).for_each(|k| j[i][k] += gradients[a][k] * x[a][i]);
                }
            }
            if miss[0].hypot(miss[1]) <= 1e-12 * size {
                return inside(xi, triangle).then(|| shape.to_vec());
            }
            let det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
            let step = [
                (j[1][1] * miss[0] - j[0][1] * miss[1]) / det,
                (j[0][0] * miss[1] - j[1][0] * miss[0]) / det,
            ];
            // A place far outside may send the iteration anywhere; it is not in this cell.
            let far = |value: f64| value.is_nan() || value.abs() > 4.0;
            xi = [xi[0] + step[0], xi[1] + step[1]];
            if far(xi[0]) || far(xi[1]) {
                return None;
            }
        }
        None
    }
}

fn inside([a, b]: Point, triangle: bool) -> bool {
    if triangle {
        a >= -OUTSIDE && b >= -OUTSIDE && a + b <= 1.0 + OUTSIDE
    } else {
        a.abs() <= 1.0 + OUTSIDE && b.abs() <= 1.0 + OUTSIDE
    }
}

#[cfg(test)]
mod tests {
    use stickslip_fem_core::generate::{
        Extent, Generate, Growth, Outline, PlateWithHole, uniform_angles,
    };

    use super::*;

    fn plate(kind: ElementKind) -> Mesh {
        PlateWithHole {
            hole_radius: 5.0,
            outline: Outline::Ring { outer_radius: 25.0 },
            extent: Extent::Half,
            angles: uniform_angles(Extent::Half, 24),
            layers: 8,
            growth: Growth::Geometric { aspect: 1.0 },
            far_cells: 1,
            kind,
        }
        .generate()
        .unwrap()
    }

    #[test]
    fn a_linear_field_is_met_everywhere_and_nothing_outside() {
        for kind in ElementKind::ALL {
            let mesh = plate(kind);
            let field: Vec<[f64; 3]> = (mesh.nodes().iter())
                .map(|&[x, y]| [1.0 + x - 2.0 * y, x, y])
                .collect();
            let places: Vec<Point> = (0..=36)
                .map(|k| {
                    let (s, c) = (f64::from(k) * 5.0).to_radians().sin_cos();
                    [7.3 * c, 7.3 * s]
                })
                .collect();
            for (sample, [x, y]) in locate(&mesh, &places).iter().zip(&places) {
                let value = sample.as_ref().unwrap().of(&field);
                // Isoparametric maps hold linear fields exactly; Newton stops at 1e-12 of a cell.
                assert!(
                    (value[0] - (1.0 + x - 2.0 * y)).abs() < 1e-10,
                    "{kind:?} {x} {y}"
                );
            }
            let outside = locate(&mesh, &[[0.0, 0.0], [26.0, 0.0], [10.0, -1.0]]);
            assert!(outside.iter().all(Option::is_none), "{kind:?}");
        }
    }
}
