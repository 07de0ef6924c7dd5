//! In which cell a place lies, and the shape functions there.
//!
//! ```text
//! x = Σₐ Nₐ(ξ) xₐ,   solved for ξ by Newton's method in the cells whose box holds x;   u(x) = Σₐ Nₐ(ξ) uₐ
//! ```

use stickslip_fem_core::body::SparseRow;
use stickslip_fem_core::element::{Element, KindVisitor, gather, jacobian, with_element};
use stickslip_fem_core::mesh::{Mesh, Point};

/// How far outside of a cell, in its reference coordinates, a place still counts as inside: places on the true circle lie a little
/// outside of the cells' polynomials.
const OUTSIDE: f64 = 1e-3;

/// A place in a cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Located {
    /// Global index of the cell.
    pub cell: usize,
    /// Nodes of the cell with their shape functions `[1]`.
    pub shape: Vec<(usize, f64)>,
}

impl Located {
    /// Displacement along `axis` (0 or 1) at the place, in the unit of `displacements`, those of all nodes, x and y of each in turn.
    pub fn displacement(&self, axis: usize, displacements: &[f64]) -> f64 {
        let parts = self.shape.iter();
        parts
            .map(|&(node, n)| n * displacements[2 * node + axis])
            .sum()
    }

    /// Weights of the displacements that make the displacement along `axis` (0 or 1) at the place.
    pub fn row(&self, axis: usize) -> SparseRow {
        self.shape
            .iter()
            .map(|&(node, n)| (2 * node + axis, n))
            .collect()
    }
}

/// A grid of boxes over a mesh, each with the cells that may reach into it.
#[derive(Clone, Debug)]
pub struct Locator<'a> {
    mesh: &'a Mesh,
    low: Point,
    size: Point,
    count: [usize; 2],
    boxes: Vec<Vec<u32>>,
}

impl<'a> Locator<'a> {
    /// Sorts the cells of `mesh`, whatever its unit of length, into about as many boxes as cells.
    pub fn new(mesh: &'a Mesh) -> Self {
        let [low, high] = mesh.bounding_box();
        let across = (mesh.element_count() as f64).sqrt().ceil().max(1.0);
        let extent = [0, 1].map(|i| (high[i] - low[i]).max(f64::MIN_POSITIVE));
        let mut locator = Self {
            mesh,
            low,
            size: extent.map(|length| length / across),
            count: [across as usize; 2],
            boxes: vec![Vec::new(); (across * across) as usize],
        };
        for cell in 0..mesh.element_count() {
            let [from, to] = bounds(mesh, cell);
            let ([i0, j0], [i1, j1]) = (locator.index(from), locator.index(to));
            for j in j0..=j1 {
                for i in i0..=i1 {
                    locator.boxes[j * locator.count[0] + i].push(cell as u32);
                }
            }
        }
        locator
    }

    fn index(&self, place: Point) -> [usize; 2] {
        // The cast saturates, so places outside fall into the outermost boxes.
        [0, 1].map(|i| (((place[i] - self.low[i]) / self.size[i]) as usize).min(self.count[i] - 1))
    }

    /// The cell in which `place` `[length]` lies deepest; `None` outside of the mesh.
    pub fn locate(&self, place: Point) -> Option<Located> {
        let [i, j] = self.index(place);
        let mut best: Option<(f64, Located)> = None;
        for &cell in &self.boxes[j * self.count[0] + i] {
            let (kind, nodes, _) = self.mesh.element(cell as usize);
            let Some((outside, shape)) = with_element(
                kind,
                Invert {
                    mesh: self.mesh,
                    nodes,
                    place,
                },
            ) else {
                continue;
            };
            if outside <= best.as_ref().map_or(OUTSIDE, |(least, _)| *least) {
                let shape = nodes.iter().copied().zip(shape).collect();
                let cell = cell as usize;
                best = Some((outside, Located { cell, shape }));
            }
            if outside <= 0.0 {
                break;
            }
        }
        best.map(|(_, located)| located)
    }
}

/// Box around a cell, as much larger as its curved sides and [`OUTSIDE`] need.
fn bounds(mesh: &Mesh, cell: usize) -> [Point; 2] {
    let (_, nodes, _) = mesh.element(cell);
    let mut bounds = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for &node in nodes {
        for i in 0..2 {
            bounds[0][i] = bounds[0][i].min(mesh.nodes()[node][i]);
            bounds[1][i] = bounds[1][i].max(mesh.nodes()[node][i]);
        }
    }
    let margin = 0.1 * (bounds[1][0] - bounds[0][0]).hypot(bounds[1][1] - bounds[0][1]);
    [bounds[0].map(|x| x - margin), bounds[1].map(|x| x + margin)]
}

/// Finds the reference coordinates of a place: how far they are outside, and the shape functions there.
struct Invert<'a> {
    mesh: &'a Mesh,
    nodes: &'a [usize],
    place: Point,
}

impl KindVisitor for Invert<'_> {
    type Output = Option<(f64, Vec<f64>)>;

    fn visit<const N: usize, E: Element<N>>(self) -> Self::Output {
        /// Newton converges quadratically from the middle of a cell that is not folded.
        const ITERATIONS: usize = 20;
        let x = gather::<N>(self.mesh.nodes(), self.nodes);
        let triangle = E::KIND.corners() == 3;
        let mut xi = if triangle { [1.0 / 3.0; 2] } else { [0.0; 2] };
        for _ in 0..ITERATIONS {
            let shape = E::shape(xi);
            let [mut dx, mut dy] = self.place;
            for (node, n) in x.iter().zip(shape) {
                dx -= n * node[0];
                dy -= n * node[1];
            }
            let inverse = jacobian::<N, E>(&x, xi).inverse;
            let step = inverse.map(|row| row[0] * dx + row[1] * dy);
            xi = [xi[0] + step[0], xi[1] + step[1]];
            // Far outside the map may be folded; such a place is in another cell.
            if !(xi[0].abs() < 3.0 && xi[1].abs() < 3.0) {
                return None;
            }
            if step[0].hypot(step[1]) < 1e-13 {
                break;
            }
        }
        let outside = if triangle {
            (-xi[0]).max(-xi[1]).max(xi[0] + xi[1] - 1.0)
        } else {
            xi[0].abs().max(xi[1].abs()) - 1.0
        };
        Some((outside, E::shape(xi).to_vec()))
    }
}
