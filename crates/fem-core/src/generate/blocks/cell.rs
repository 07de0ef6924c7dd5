//! One quadrilateral of a lattice: the places inside it, and its cut into triangles.
//!
//! ```text
//! x(ξ, η) = ½ (1 − η) S(ξ) + ½ (1 + ξ) E(η) + ½ (1 + η) N(ξ) + ½ (1 − ξ) W(η) − Σₖ ¼ (1 + ξₖξ)(1 + ηₖη) xₖ
//! ```
//!
//! Source: Gordon and Hall, Int. J. Numer. Methods Eng. 7 (1973) 461–477.

use crate::element::{edge_nodes, edge_shape};
use crate::mesh::Point;

/// Reference coordinates of the corners.
const CORNERS: [Point; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// The diagonal along which a quadrilateral is cut into triangles.
#[derive(Clone, Copy)]
pub(super) enum Cut {
    From0To2,
    From1To3,
}

impl Cut {
    /// The shorter diagonal. Of equal ones, as in rings, the one that ends farther from the axes through `centre`: that choice depends
    /// neither on numbering nor on orientation, so meshes of mirrored points are mirrored, and a half is the whole cut in two. Of a cell
    /// that an axis cuts in two, the one whose outer end lies on its positive side: mirrored about the other axis it is the same.
    pub(super) fn of(x: [Point; 4], centre: Point) -> Self {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| [0, 1].map(|i| (x[k][i] - centre[i]).abs()));
        let area = |p: Point| p[0] * p[1];
        let outer_end = |p: usize, q: usize| {
            let end = if distance(x[p], centre) > distance(x[q], centre) {
                x[p]
            } else {
                x[q]
            };
            [0, 1].map(|i| end[i] - centre[i])
        };
        let ends = [outer_end(0, 2), outer_end(1, 3)];
        let criteria = [
            [-distance(x[0], x[2]), -distance(x[1], x[3])],
            [area(a).max(area(c)), area(b).max(area(d))],
            [a[1].max(c[1]), b[1].max(d[1])],
            ends.map(|end| end[0]),
            ends.map(|end| end[1]),
        ];
        let decided = criteria
            .into_iter()
            .find(|[p, q]| (p - q).abs() > 1e-9 * p.abs().max(q.abs()));
        match decided {
            Some([first, second]) if second > first => Self::From1To3,
            _ => Self::From0To2,
        }
    }

    fn triangles(self) -> [[usize; 3]; 2] {
        match self {
            Self::From0To2 => [[0, 1, 2], [0, 2, 3]],
            Self::From1To3 => [[0, 1, 3], [1, 2, 3]],
        }
    }

    /// Triangle and local edge that lie on edge `edge` of the quadrilateral.
    pub(super) fn edge(self, edge: usize) -> (usize, usize) {
        match self {
            Self::From0To2 => [(0, 0), (0, 1), (1, 1), (1, 2)][edge],
            Self::From1To3 => [(0, 0), (1, 0), (1, 1), (0, 2)][edge],
        }
    }

    /// Appends both triangles of the quadrilateral with the nodes `ring` around it. `inside` are reference coordinates of the nodes
    /// inside a triangle.
    pub(super) fn add(
        self,
        outline: &Outline,
        ring: &[usize],
        inside: &[Point],
        nodes: &mut Vec<Point>,
        connectivity: &mut Vec<usize>,
    ) {
        let inner = outline.order - 1;
        let mut node = |at| {
            nodes.push(at);
            nodes.len() - 1
        };
        let [from, _] = self.diagonal();
        let across: Vec<usize> = (edge_nodes(outline.order).unwrap_or_default().iter())
            .skip(1)
            .take(inner)
            .map(|&(xi, _)| {
                node(
                    outline
                        .on_triangle(self.diagonal(), [(1.0 - xi) / 2.0, f64::midpoint(1.0, xi)]),
                )
            })
            .collect();
        for corners in self.triangles() {
            connectivity.extend(corners.map(|c| ring[c]));
            for k in 0..3 {
                let (a, b) = (corners[k], corners[(k + 1) % 3]);
                if (a + 1) % 4 == b {
                    connectivity.extend(&ring[4 + a * inner..4 + (a + 1) * inner]);
                } else if a == from {
                    connectivity.extend(&across);
                } else {
                    connectivity.extend(across.iter().rev());
                }
            }
            for &[xi, eta] in inside {
                let at = outline.on_triangle(corners, [1.0 - xi - eta, xi, eta]);
                connectivity.push(node(at));
            }
        }
    }

    /// The corners that the diagonal joins.
    fn diagonal(self) -> [usize; 2] {
        match self {
            Self::From0To2 => [0, 2],
            Self::From1To3 => [1, 3],
        }
    }
}

/// The points around a quadrilateral with curved edges, and the places inside that follow from them.
pub(super) struct Outline {
    order: usize,
    /// Corners, then the inner nodes of each edge along the walk.
    points: Vec<Point>,
}

impl Outline {
    pub(super) fn new(order: usize, points: Vec<Point>) -> Self {
        Self { order, points }
    }

    pub(super) fn corners(&self) -> [Point; 4] {
        [0, 1, 2, 3].map(|k| self.points[k])
    }

    /// Coons' patch at the reference point (ξ, η): the edges blended linearly, less the corners blended bilinearly.
    pub(super) fn blended(&self, at: Point) -> Point {
        let [sides, corners] = self.parts(at);
        [0, 1].map(|i| sides[i] - corners[i])
    }

    /// The place with the weights `area` of some of the `corners`, moved with the sides where they are curved.
    fn on_triangle<const M: usize>(&self, corners: [usize; M], area: [f64; M]) -> Point {
        let mut place = [0.0; 2];
        let mut at = [0.0; 2];
        for (&corner, share) in corners.iter().zip(area) {
            for i in 0..2 {
                place[i] += share * self.points[corner][i];
                at[i] += share * CORNERS[corner][i];
            }
        }
        let (blended, [_, straight]) = (self.blended(at), self.parts(at));
        [0, 1].map(|i| place[i] + (blended[i] - straight[i]))
    }

    /// Edges blended linearly and corners blended bilinearly at a reference point.
    fn parts(&self, [xi, eta]: Point) -> [Point; 2] {
        let (mut sides, mut straight) = ([0.0; 2], [0.0; 2]);
        let inner = self.order - 1;
        // Parameter along the walk, and share, of each edge.
        let edges = [(xi, -eta), (eta, xi), (-xi, eta), (-eta, -xi)];
        for (k, (along, towards)) in edges.into_iter().enumerate() {
            let (first, last) = (self.points[k], self.points[(k + 1) % 4]);
            let between = &self.points[4 + k * inner..4 + (k + 1) * inner];
            let walk = [first]
                .into_iter()
                .chain(between.iter().copied())
                .chain([last]);
            let mut place = [0.0; 2];
            for (point, value) in walk.zip(edge_shape(self.order, along)) {
                (0..2).for_each(|i| place[i] += value * point[i]);
            }
            let [x, y] = CORNERS[k];
            let (share, of_corner) = (
                f64::midpoint(1.0, towards),
                0.25 * (1.0 + x * xi) * (1.0 + y * eta),
            );
            for i in 0..2 {
                sides[i] += share * place[i];
                straight[i] += of_corner * first[i];
            }
        }
        [sides, straight]
    }
}

pub(super) fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
