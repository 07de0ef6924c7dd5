//! The five kinds of cells.

use serde::{Deserialize, Serialize};

/// Kind of a plane cell. The number counts its nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum ElementKind {
    /// Linear triangle.
    #[serde(rename = "T3")]
    T3,
    /// Quadratic triangle.
    #[serde(rename = "T6")]
    T6,
    /// Bilinear quadrilateral.
    #[serde(rename = "Q4")]
    Q4,
    /// Serendipity quadrilateral.
    #[serde(rename = "Q8")]
    Q8,
    /// Biquadratic (Lagrange) quadrilateral.
    #[serde(rename = "Q9")]
    Q9,
}

/// An edge in a cell's local node numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EdgeLocal {
    /// First and last corner, walking with the interior on the left.
    pub ends: [usize; 2],
    /// Mid-side node of a quadratic cell.
    pub mid: Option<usize>,
}

impl ElementKind {
    /// All kinds, for tests and tables.
    pub const ALL: [Self; 5] = [Self::T3, Self::T6, Self::Q4, Self::Q8, Self::Q9];

    /// Number of nodes.
    pub const fn nodes(self) -> usize {
        match self {
            Self::T3 => 3,
            Self::T6 => 6,
            Self::Q4 => 4,
            Self::Q8 => 8,
            Self::Q9 => 9,
        }
    }

    /// Number of corners: 3 or 4.
    pub const fn corners(self) -> usize {
        match self {
            Self::T3 | Self::T6 => 3,
            Self::Q4 | Self::Q8 | Self::Q9 => 4,
        }
    }

    /// Polynomial order along an edge: 1 or 2.
    pub const fn order(self) -> usize {
        match self {
            Self::T3 | Self::Q4 => 1,
            Self::T6 | Self::Q8 | Self::Q9 => 2,
        }
    }

    /// Number of edges: as many as corners.
    pub const fn edges(self) -> usize {
        self.corners()
    }

    /// Local nodes of local edge `local`, which is less than [`ElementKind::edges`].
    pub const fn edge_nodes(self, local: usize) -> EdgeLocal {
        let corners = self.corners();
        EdgeLocal {
            ends: [local, (local + 1) % corners],
            mid: if self.order() == 2 {
                Some(corners + local)
            } else {
                None
            },
        }
    }

    /// Cell type number of the VTK file formats.
    pub const fn vtk_cell_type(self) -> u8 {
        match self {
            Self::T3 => 5,
            Self::T6 => 22,
            Self::Q4 => 9,
            Self::Q8 => 23,
            Self::Q9 => 28,
        }
    }
}
