//! One block: its points and its cells.

use std::ops::Range;

use super::Side;
use crate::mesh::{ElementKind, Point};

/// Points of a block in steps of a cell (linear kinds) or half a cell (quadratic kinds), rows of constant j. For quadratic
/// kinds the middles of cells are left at the origin: nothing reads them.
#[derive(Debug)]
pub(super) struct Lattice {
    cells: [usize; 2],
    /// Lattice steps per cell: 1 or 2.
    order: usize,
    points: Vec<Point>,
    /// Whether the map turns the lattice over, so that cells must be walked the other way.
    mirrored: bool,
    /// Point about whose axes cuts into triangles are mirrored `[length]`.
    centre: Point,
}

impl Lattice {
    pub(super) fn new(
        cells: [usize; 2],
        order: usize,
        centre: Point,
        map: impl Fn(f64, f64) -> Point,
    ) -> Self {
        let [columns, rows] = cells.map(|n| order * n + 1);
        let mut points = Vec::with_capacity(columns * rows);
        for j in 0..rows {
            for i in 0..columns {
                let middle = order == 2 && i % 2 == 1 && j % 2 == 1;
                let step = |k: usize| k as f64 / order as f64;
                points.push(if middle {
                    [0.0; 2]
                } else {
                    map(step(i), step(j))
                });
            }
        }
        let mut lattice = Self {
            cells,
            order,
            points,
            mirrored: false,
            centre,
        };
        lattice.mirrored = lattice.signed_area() < 0.0;
        lattice
    }

    pub(super) fn points(&self) -> &[Point] {
        &self.points
    }

    /// Index of corner node `at`, clamped to the block.
    pub(super) fn corner(&self, at: [usize; 2]) -> usize {
        let [i, j] = [0, 1].map(|k| at[k].min(self.cells[k]) * self.order);
        self.index(i, j)
    }

    fn columns(&self) -> usize {
        self.order * self.cells[0] + 1
    }

    fn index(&self, i: usize, j: usize) -> usize {
        j * self.columns() + i
    }

    /// Whether the lattice has a node at index `k` (not so in the middle of quadratic cells), and whether it lies on the rim.
    pub(super) fn node_kind(&self, k: usize) -> NodeKind {
        let (i, j) = (k % self.columns(), k / self.columns());
        if self.order == 2 && i % 2 == 1 && j % 2 == 1 {
            NodeKind::None
        } else if i == 0 || j == 0 || i + 1 == self.columns() || j == self.order * self.cells[1] {
            NodeKind::Rim
        } else {
            NodeKind::Interior
        }
    }

    /// Smallest distance between neighbours on the rim, zero not counted.
    pub(super) fn rim_spacing(&self) -> f64 {
        let [right, top] = self.cells.map(|n| n * self.order);
        let horizontal = |j| (1..=right).map(move |i| [self.index(i - 1, j), self.index(i, j)]);
        let vertical = |i| (1..=top).map(move |j| [self.index(i, j - 1), self.index(i, j)]);
        let pairs = [0, top].into_iter().flat_map(horizontal);
        let pairs = pairs.chain([0, right].into_iter().flat_map(vertical));
        let distances = pairs.map(|[a, b]| distance(self.points[a], self.points[b]));
        distances.filter(|&d| d > 0.0).fold(f64::INFINITY, f64::min)
    }

    /// Lattice indices of a cell's four corners and four mid-side nodes (for linear kinds corners again), counter-clockwise.
    fn quad(&self, i: usize, j: usize) -> [usize; 8] {
        let n = self.order;
        let (half, full) = (n / 2, n);
        let ring = [
            (0, 0),
            (full, 0),
            (full, full),
            (0, full),
            (half, 0),
            (full, half),
            (half, full),
            (0, half),
        ];
        ring.map(|(a, b)| {
            let (a, b) = if self.mirrored { (b, a) } else { (a, b) };
            self.index(i * n + a, j * n + b)
        })
    }

    fn signed_area(&self) -> f64 {
        let mut twice = 0.0;
        for j in 0..self.cells[1] {
            for i in 0..self.cells[0] {
                let [a, b, c, d, ..] = self.quad(i, j).map(|k| self.points[k]);
                twice += (c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0]);
            }
        }
        twice / 2.0
    }

    /// Appends the connectivity of all cells; `number` maps lattice indices to nodes. Centres are added to `nodes`.
    pub(super) fn cells(
        &self,
        kind: ElementKind,
        number: &[usize],
        nodes: &mut Vec<Point>,
        connectivity: &mut Vec<usize>,
    ) {
        for j in 0..self.cells[1] {
            for i in 0..self.cells[0] {
                let quad = self.quad(i, j);
                let x = quad.map(|k| self.points[k]);
                let n = quad.map(|k| number[k]);
                let mut centre = |at| {
                    nodes.push(at);
                    nodes.len() - 1
                };
                match kind {
                    ElementKind::Q4 => connectivity.extend(&n[..4]),
                    ElementKind::Q8 => connectivity.extend(n),
                    ElementKind::Q9 => {
                        connectivity.extend(n);
                        connectivity.push(centre(coons_centre(&x)));
                    }
                    ElementKind::T3 => {
                        for corners in Cut::of(&x, self.centre).triangles() {
                            connectivity.extend(corners.map(|c| n[c]));
                        }
                    }
                    ElementKind::T6 => {
                        let cut = Cut::of(&x, self.centre);
                        let middle = centre(cut.middle(&x));
                        for corners in cut.triangles() {
                            connectivity.extend(corners.map(|c| n[c]));
                            connectivity.extend((0..3).map(|k| {
                                let (a, b) = (corners[k], corners[(k + 1) % 3]);
                                if (a + 1) % 4 == b { n[4 + a] } else { middle }
                            }));
                        }
                    }
                }
            }
        }
    }

    /// Cells (counted within the block) and local edges along a side.
    pub(super) fn side(
        &self,
        kind: ElementKind,
        side: Side,
        range: Range<usize>,
    ) -> impl Iterator<Item = (usize, usize)> {
        let [ni, nj] = self.cells;
        let length = match side {
            _ if ni == 0 || nj == 0 => 0,
            Side::South | Side::North => ni,
            Side::East | Side::West => nj,
        };
        (range.start..range.end.min(length)).map(move |k| {
            let (i, j, straight, turned) = match side {
                Side::South => (k, 0, 0, 3),
                Side::East => (ni - 1, k, 1, 2),
                Side::North => (k, nj - 1, 2, 1),
                Side::West => (0, k, 3, 0),
            };
            let edge = if self.mirrored { turned } else { straight };
            let cell = j * ni + i;
            if kind.corners() == 4 {
                return (cell, edge);
            }
            let x = self.quad(i, j).map(|k| self.points[k]);
            let (triangle, edge) = Cut::of(&x, self.centre).edge(edge);
            (2 * cell + triangle, edge)
        })
    }
}

/// What is at a lattice position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NodeKind {
    None,
    Rim,
    Interior,
}

/// The diagonal along which a quadrilateral is cut into triangles.
#[derive(Clone, Copy)]
enum Cut {
    From0To2,
    From1To3,
}

impl Cut {
    /// The shorter diagonal. Of equal ones, as in rings, the one that ends farther from the axes through `centre`: that choice depends
    /// neither on numbering nor on orientation, so meshes of mirrored points are mirrored, and a half is the whole cut in two. Of a cell
    /// that an axis cuts in two, the one whose outer end lies on its positive side: mirrored about the other axis it is the same.
    fn of(x: &[Point; 8], centre: Point) -> Self {
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
    fn edge(self, edge: usize) -> (usize, usize) {
        match self {
            Self::From0To2 => [(0, 0), (0, 1), (1, 1), (1, 2)][edge],
            Self::From1To3 => [(0, 0), (1, 0), (1, 1), (0, 2)][edge],
        }
    }

    /// Middle of the diagonal, moved with the sides where they are curved.
    fn middle(self, x: &[Point; 8]) -> Point {
        let (a, b) = match self {
            Self::From0To2 => (x[0], x[2]),
            Self::From1To3 => (x[1], x[3]),
        };
        let centre = coons_centre(x);
        [0, 1].map(|i| {
            let mean = (x[0][i] + x[1][i] + x[2][i] + x[3][i]) / 4.0;
            f64::midpoint(a[i], b[i]) + (centre[i] - mean)
        })
    }
}

fn coons_centre(x: &[Point; 8]) -> Point {
    [0, 1].map(|i| {
        let corners = x[0][i] + x[1][i] + x[2][i] + x[3][i];
        let mid_sides = x[4][i] + x[5][i] + x[6][i] + x[7][i];
        mid_sides / 2.0 - corners / 4.0
    })
}

fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
