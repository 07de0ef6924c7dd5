//! Sizes of structured meshes by Euler's formula V − E + F = χ.

use super::{GenerateError, MeshEstimate};
use crate::mesh::ElementKind;

/// Corner nodes and quadrilaterals of a mesh, before any cutting into triangles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Count {
    pub(super) vertices: usize,
    pub(super) quads: usize,
    /// Whether the body has a hole inside: χ = 0 instead of 1.
    pub(super) ring: bool,
}

impl Count {
    /// One lattice of `cells`.
    pub(super) fn lattice(cells: [usize; 2]) -> Self {
        let [ni, nj] = cells;
        let vertices = ni.saturating_add(1).saturating_mul(nj.saturating_add(1));
        Self {
            vertices,
            quads: ni.saturating_mul(nj),
            ring: false,
        }
    }

    /// Adds a lattice that shares `shared` of its corner nodes.
    pub(super) fn joined(self, cells: [usize; 2], shared: usize) -> Self {
        let other = Self::lattice(cells);
        Self {
            vertices: self
                .vertices
                .saturating_add(other.vertices.saturating_sub(shared)),
            quads: self.quads.saturating_add(other.quads),
            ring: self.ring,
        }
    }

    /// Joins the first and last column of a lattice with `rows` cells along them.
    pub(super) fn closed(self, rows: usize) -> Self {
        Self {
            vertices: self.vertices.saturating_sub(rows.saturating_add(1)),
            ring: true,
            ..self
        }
    }

    /// Nodes and cells when made of `kind`.
    pub(super) fn estimate(self, kind: ElementKind) -> MeshEstimate {
        let Self {
            vertices,
            quads,
            ring,
        } = self;
        let edges = vertices
            .saturating_add(quads)
            .saturating_sub(usize::from(!ring));
        let on_edges = edges.saturating_mul(kind.order() - 1);
        let inside_cell = kind.nodes() - kind.border_nodes();
        // Two triangles share the inner nodes of the diagonal.
        let (cells, on_diagonal) = if kind.corners() == 3 {
            (2, kind.order() - 1)
        } else {
            (1, 0)
        };
        let inside = quads.saturating_mul(cells * inside_cell + on_diagonal);
        MeshEstimate {
            nodes: vertices.saturating_add(on_edges).saturating_add(inside),
            elements: quads.saturating_mul(cells),
        }
    }
}

/// Refuses a mesh of more than `limit` nodes.
pub(super) fn within(
    estimate: MeshEstimate,
    kind: ElementKind,
    limit: usize,
) -> Result<(), GenerateError> {
    let MeshEstimate { nodes, elements } = estimate;
    if nodes <= limit {
        return Ok(());
    }
    let coordinates = nodes.saturating_mul(2 * size_of::<f64>());
    let connectivity = elements.saturating_mul(kind.nodes() * size_of::<usize>());
    let bytes = coordinates.saturating_add(connectivity);
    Err(GenerateError::TooLarge {
        nodes,
        bytes,
        limit,
    })
}
