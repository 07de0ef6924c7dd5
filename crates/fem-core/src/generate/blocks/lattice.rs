//! One block: its points and its cells.

use std::ops::Range;

use super::Side;
use super::cell::{Cut, Outline, distance};
use crate::element::{edge_nodes, reference_nodes};
use crate::kind::tensor_place;
use crate::mesh::{ElementKind, Point};

/// Points of a block in steps between the nodes of edges, rows of constant j. Positions inside cells are left at the origin: nothing
/// reads them.
#[derive(Debug)]
pub(super) struct Lattice {
    cells: [usize; 2],
    /// Lattice steps per cell.
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
        let line = edge_nodes(order).unwrap_or_default();
        let step = |k: usize| (k / order) as f64 + f64::midpoint(1.0, line[k % order].0);
        for j in 0..rows {
            for i in 0..columns {
                points.push(if inside_cell(order, i, j) {
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

    /// Whether the lattice has a node at index `k` (not so inside cells), and whether it lies on the rim.
    pub(super) fn node_kind(&self, k: usize) -> NodeKind {
        let (i, j) = (k % self.columns(), k / self.columns());
        if inside_cell(self.order, i, j) {
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

    /// Lattice indices of a cell's corners and of the inner nodes of its edges along the walk around it, counter-clockwise.
    fn ring(&self, i: usize, j: usize) -> Vec<usize> {
        let n = self.order;
        let at = |k: usize| {
            let [a, b] = tensor_place(n, k);
            let (a, b) = if self.mirrored { (b, a) } else { (a, b) };
            self.index(i * n + a, j * n + b)
        };
        (0..4 * n).map(at).collect()
    }

    /// Places of a cell's ring.
    fn outline(&self, i: usize, j: usize) -> Outline {
        let points = self.ring(i, j).into_iter().map(|k| self.points[k]);
        Outline::new(self.order, points.collect())
    }

    fn signed_area(&self) -> f64 {
        let mut twice = 0.0;
        for j in 0..self.cells[1] {
            for i in 0..self.cells[0] {
                let corner = |k: usize| {
                    let [a, b] = tensor_place(1, k);
                    let (a, b) = if self.mirrored { (b, a) } else { (a, b) };
                    self.points[self.index((i + a) * self.order, (j + b) * self.order)]
                };
                let [a, b, c, d] = [0, 1, 2, 3].map(corner);
                twice += (c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0]);
            }
        }
        twice / 2.0
    }

    /// Appends the connectivity of all cells; `number` maps lattice indices to nodes. Nodes inside the quadrilaterals are added to
    /// `nodes`.
    pub(super) fn cells(
        &self,
        kind: ElementKind,
        number: &[usize],
        nodes: &mut Vec<Point>,
        connectivity: &mut Vec<usize>,
    ) {
        let inside = reference_nodes(kind).split_off(kind.border_nodes());
        for j in 0..self.cells[1] {
            for i in 0..self.cells[0] {
                let outline = self.outline(i, j);
                let ring: Vec<usize> = (self.ring(i, j).into_iter()).map(|k| number[k]).collect();
                if kind.corners() == 4 {
                    connectivity.extend(ring);
                    for &at in &inside {
                        connectivity.push(nodes.len());
                        nodes.push(outline.blended(at));
                    }
                } else {
                    let cut = Cut::of(outline.corners(), self.centre);
                    cut.add(&outline, &ring, &inside, nodes, connectivity);
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
            let (triangle, edge) = Cut::of(self.outline(i, j).corners(), self.centre).edge(edge);
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

/// Whether the lattice position (i, j) lies inside a cell of `order`.
fn inside_cell(order: usize, i: usize, j: usize) -> bool {
    !i.is_multiple_of(order) && !j.is_multiple_of(order)
}
