//! The kinds of cells and their numbering: below [`element`](crate::element) and [`mesh`](crate::mesh), which both build on it.
//!
//! All kinds number their nodes alike: corners counter-clockwise, then the inner nodes of each edge along the walk from
//! corner k to corner k + 1, then what is inside the cell. Edges of order p carry p − 1 inner nodes, at the Gauss–Lobatto
//! points, so that cells of any two kinds of the same order fit together.

use std::ops::Range;

use serde::{Deserialize, Serialize};

/// A point of the plane or of the reference cell: (x, y) `[length]` or (ξ, η) `[1]`.
pub type Point = [f64; 2];

/// Highest polynomial order of a kind.
pub const MAX_ORDER: usize = 8;

/// Kind of a plane cell: T and Q count its nodes, P its order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum ElementKind {
    /// Linear triangle.
    T3,
    /// Quadratic triangle.
    T6,
    /// Bilinear quadrilateral.
    Q4,
    /// Serendipity quadrilateral.
    Q8,
    /// Biquadratic (Lagrange) quadrilateral.
    Q9,
    /// Gauss–Lobatto quadrilateral of order 1.
    P1,
    /// Gauss–Lobatto quadrilateral of order 2.
    P2,
    /// Gauss–Lobatto quadrilateral of order 3.
    P3,
    /// Gauss–Lobatto quadrilateral of order 4.
    P4,
    /// Gauss–Lobatto quadrilateral of order 5.
    P5,
    /// Gauss–Lobatto quadrilateral of order 6.
    P6,
    /// Gauss–Lobatto quadrilateral of order 7.
    P7,
    /// Gauss–Lobatto quadrilateral of order 8.
    P8,
}

/// What files and pictures show of a cell.
#[derive(Clone, Copy)]
enum Shown {
    /// The cell itself, by the cell type number of the VTK file formats.
    Whole(u8),
    /// The bilinear quadrilaterals between neighbouring nodes of its tensor grid: of a quadrilateral with (order + 1)² nodes.
    Grid,
}

/// What is known of a kind beside its shape functions.
struct Facts {
    kind: ElementKind,
    name: &'static str,
    summary: &'static str,
    corners: usize,
    order: usize,
    nodes: usize,
    shown: Shown,
}

const fn facts(
    kind: ElementKind,
    name: &'static str,
    summary: &'static str,
    [corners, order, nodes]: [usize; 3],
    shown: Shown,
) -> Facts {
    Facts {
        kind,
        name,
        summary,
        corners,
        order,
        nodes,
        shown,
    }
}

/// One line per kind, in the order of [`ElementKind`]: corners, order and nodes.
#[rustfmt::skip]
const TABLE: [Facts; 13] = {
    use ElementKind::{P1, P2, P3, P4, P5, P6, P7, P8, Q4, Q8, Q9, T3, T6};
    use Shown::{Grid, Whole};
    [
        facts(T3, "T3", "linear triangle", [3, 1, 3], Whole(5)),
        facts(T6, "T6", "quadratic triangle", [3, 2, 6], Whole(22)),
        facts(Q4, "Q4", "bilinear quadrilateral", [4, 1, 4], Whole(9)),
        facts(Q8, "Q8", "serendipity quadrilateral", [4, 2, 8], Whole(23)),
        facts(Q9, "Q9", "biquadratic quadrilateral", [4, 2, 9], Whole(28)),
        facts(P1, "P1", "Gauss–Lobatto quadrilateral, order 1", [4, 1, 4], Whole(9)),
        facts(P2, "P2", "Gauss–Lobatto quadrilateral, order 2", [4, 2, 9], Whole(28)),
        facts(P3, "P3", "Gauss–Lobatto quadrilateral, order 3", [4, 3, 16], Grid),
        facts(P4, "P4", "Gauss–Lobatto quadrilateral, order 4", [4, 4, 25], Grid),
        facts(P5, "P5", "Gauss–Lobatto quadrilateral, order 5", [4, 5, 36], Grid),
        facts(P6, "P6", "Gauss–Lobatto quadrilateral, order 6", [4, 6, 49], Grid),
        facts(P7, "P7", "Gauss–Lobatto quadrilateral, order 7", [4, 7, 64], Grid),
        facts(P8, "P8", "Gauss–Lobatto quadrilateral, order 8", [4, 8, 81], Grid),
    ]
};

// Only tensor grids are shown as grids.
const _: () = {
    let mut k = 0;
    while k < TABLE.len() {
        let row = TABLE[k].order + 1;
        assert!(matches!(TABLE[k].shown, Shown::Whole(_)) || TABLE[k].nodes == row * row);
        k += 1;
    }
};

/// An edge in a cell's local node numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EdgeLocal {
    /// First and last corner, walking with the interior on the left.
    pub ends: [usize; 2],
    /// Inner nodes of the edge, in walk order: one less than its order.
    pub inner: Range<usize>,
}

impl ElementKind {
    /// All kinds, for lists, tests and tables.
    pub const ALL: [Self; TABLE.len()] = {
        let mut all = [Self::T3; TABLE.len()];
        let mut k = 0;
        while k < all.len() {
            all[k] = TABLE[k].kind;
            assert!(
                all[k] as usize == k,
                "the table is in the order of the kinds"
            );
            k += 1;
        }
        all
    };

    /// The kinds of order 1 and 2 that finite-element programs share.
    pub const COMMON: [Self; 5] = [Self::T3, Self::T6, Self::Q4, Self::Q8, Self::Q9];

    const fn facts(self) -> &'static Facts {
        &TABLE[self as usize]
    }

    /// The name by which scenes know the kind.
    pub const fn name(self) -> &'static str {
        self.facts().name
    }

    /// What the kind is, in three or four words.
    pub const fn summary(self) -> &'static str {
        self.facts().summary
    }

    /// Number of nodes.
    pub const fn nodes(self) -> usize {
        self.facts().nodes
    }

    /// Number of corners: 3 or 4.
    pub const fn corners(self) -> usize {
        self.facts().corners
    }

    /// Polynomial order along an edge, at most [`MAX_ORDER`].
    pub const fn order(self) -> usize {
        self.facts().order
    }

    /// Number of edges: as many as corners.
    pub const fn edges(self) -> usize {
        self.corners()
    }

    /// Number of nodes on the border of the cell: corners and inner nodes of edges. The others are inside, numbered last.
    pub const fn border_nodes(self) -> usize {
        self.corners() * self.order()
    }

    /// Local nodes of local edge `local`, which is less than [`ElementKind::edges`].
    pub const fn edge_nodes(self, local: usize) -> EdgeLocal {
        let (corners, inner) = (self.corners(), self.order() - 1);
        let first = corners + local * inner;
        EdgeLocal {
            ends: [local, (local + 1) % corners],
            inner: first..first + inner,
        }
    }

    /// Local nodes of the cells that stand for one cell in VTK files, of the type [`vtk_cell_type`](Self::vtk_cell_type): the cell
    /// itself where VTK has it, otherwise the quadrilaterals between neighbouring nodes, in rows of η.
    ///
    /// VTK's own cells of high order place their nodes at equal steps, so between Gauss–Lobatto nodes they would show another
    /// polynomial than the one that was computed.
    pub fn vtk_cells(self) -> Vec<Vec<usize>> {
        if let Shown::Whole(_) = self.facts().shown {
            return vec![(0..self.nodes()).collect()];
        }
        let order = self.order();
        let mut at = vec![0; self.nodes()];
        for node in 0..self.nodes() {
            let [i, j] = tensor_place(order, node);
            at[j * (order + 1) + i] = node;
        }
        let cell = |first: usize| {
            let ring = [0, 1, order + 2, order + 1];
            ring.map(|step| at[first + step]).to_vec()
        };
        (0..order)
            .flat_map(|j| (0..order).map(move |i| j * (order + 1) + i))
            .map(cell)
            .collect()
    }

    /// Local nodes around each cell that stands for one cell in pictures, counter-clockwise: of an edge of order 2 corner, middle,
    /// corner. Cells are those of [`vtk_cells`](Self::vtk_cells).
    pub fn drawn_cells(self) -> Vec<Vec<usize>> {
        match self.facts().shown {
            Shown::Grid => self.vtk_cells(),
            Shown::Whole(_) => {
                let edge = |k: usize| {
                    let EdgeLocal { ends, inner } = self.edge_nodes(k);
                    std::iter::once(ends[0]).chain(inner)
                };
                vec![(0..self.edges()).flat_map(edge).collect()]
            }
        }
    }

    /// Cell type number, in the VTK file formats, of [`vtk_cells`](Self::vtk_cells).
    pub const fn vtk_cell_type(self) -> u8 {
        match self.facts().shown {
            Shown::Whole(number) => number,
            Shown::Grid => 9,
        }
    }
}

/// Column and row, 0 … `order`, of local node `node` in the tensor grid of a quadrilateral of `order`.
pub(crate) const fn tensor_place(order: usize, node: usize) -> [usize; 2] {
    const CORNERS: [[usize; 2]; 4] = [[0, 0], [1, 0], [1, 1], [0, 1]];
    let inner = order - 1;
    if node < 4 {
        return [CORNERS[node][0] * order, CORNERS[node][1] * order];
    }
    if node < 4 * order {
        let (edge, step) = ((node - 4) / inner, (node - 4) % inner + 1);
        return match edge {
            0 => [step, 0],
            1 => [order, step],
            2 => [order - step, order],
            _ => [0, order - step],
        };
    }
    let inside = node - 4 * order;
    [inside % inner + 1, inside / inner + 1]
}
