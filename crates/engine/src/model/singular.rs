//! Places of a body where stresses of the linear model have no bound.

use stickslip_fem_core::mesh::{Mesh, MeshError};

use super::plan::Plan;

/// A place where stresses have no bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Singular {
    /// The node of a held point, whose reaction is a concentrated force.
    Point(usize),
    /// The node at the end of a supported edge or of a platen.
    End(usize),
}

impl Singular {
    /// The node.
    pub fn node(self) -> usize {
        match self {
            Self::Point(node) | Self::End(node) => node,
        }
    }
}

/// Those of the body with the index `body`.
pub(super) fn places(
    plan: &Plan<'_>,
    body: usize,
    mesh: &Mesh,
) -> Result<Vec<Singular>, MeshError> {
    let supports = plan.supports_of(body).map(|support| &support.on);
    let platens = plan.platens_of(body).map(|platen| &platen.on);
    let mut places = Vec::new();
    let shape = plan.bodies[body].shape;
    for on in supports.chain(platens).filter(|on| !shape.is_area(&on.set)) {
        if mesh.edge_set(&on.set).is_err() {
            let nodes = mesh.node_set(&on.set)?.iter();
            places.extend(nodes.map(|&node| Singular::Point(node)));
            continue;
        }
        let path = mesh.edge_path(&on.set)?;
        if !path.closed {
            let ends = path.nodes.first().into_iter().chain(path.nodes.last());
            places.extend(ends.map(|&node| Singular::End(node)));
        }
    }
    Ok(places)
}
