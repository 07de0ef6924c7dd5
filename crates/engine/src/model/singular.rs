//! Places of a body where stresses of the linear model have no bound.

use stickslip_fem_core::mesh::{Mesh, MeshError};

use stickslip_scene::schema::LoadKind;

use super::plan::Plan;

/// A place where stresses have no bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Singular {
    /// The node of a held point, of one on a spring, or of one that a force acts on, whose reaction is a concentrated force.
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
    let springs = plan.springs.iter().filter(|own| own.body == body);
    let at_points = springs
        .filter(|own| own.edge.is_none())
        .map(|own| &own.of.on);
    let loaded = plan
        .loads
        .iter()
        .filter(|load| load.body == body && load.edge.is_none());
    let loaded = loaded.filter_map(|load| match &load.of.kind {
        LoadKind::Force { on, .. } => Some(on),
        _ => None,
    });
    let platens = plan.platens_of(body).map(|platen| &platen.on);
    let mut places = Vec::new();
    let shape = plan.bodies[body].shape;
    for on in supports
        .chain(at_points)
        .chain(loaded)
        .chain(platens)
        .filter(|on| !shape.is_area(&on.set))
    {
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
