//! Places of a body where stresses of the linear model have no bound.

use stickslip_fem_core::mesh::{Mesh, MeshError};
use stickslip_scene::schema::LoadKind;

use super::edge::ModelEdge;
use super::plan::Plan;
use crate::results::EdgeResults;

/// A place where stresses have no bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Singular {
    /// The node of a held point, of one on a spring, or of one that a force acts on, whose reaction is a concentrated force.
    Point(usize),
    /// The node at the end of a supported edge or of a platen.
    End(usize),
    /// A corner of the body of more than half a turn.
    Corner {
        /// The node.
        node: usize,
        /// Angle inside the body, between π and 2π `[rad]`.
        angle: f64,
    },
}

impl Singular {
    /// The node.
    pub fn node(self) -> usize {
        match self {
            Self::Point(node) | Self::End(node) | Self::Corner { node, .. } => node,
        }
    }
}

/// λ − 1 of the stress r^(λ − 1) that grows fastest towards a free corner of the inner `angle` `[rad]`, between π and 2π, of an isotropic body
/// whose sides are opened symmetrically:
///
/// ```text
/// sin(λ ω) + λ sin ω = 0,   ½ ≤ λ < 1
/// ```
///
/// Source: Williams, J. Appl. Mech. 19 (1952) 526–528.
pub fn corner_exponent(angle: f64) -> f64 {
    let (mut low, mut high) = (0.5, 1.0);
    for _ in 0..f64::MANTISSA_DIGITS {
        let middle = f64::midpoint(low, high);
        if (middle * angle).sin() + middle * angle.sin() > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low - 1.0
}

impl ModelEdge {
    /// Where among `singular`, places of its body, its largest tangential stress is; `None` where that has a limit.
    pub fn unbounded_peak(&self, singular: &[Singular], results: &EdgeResults) -> Option<Singular> {
        let (_, place) = results.peak_hoop?;
        let near = (self.geometry.parameter)
            .partition_point(|&at| at < place - f64::EPSILON * place.abs());
        let cell = near.saturating_sub(self.order)..=near + self.order;
        let nodes = self.nodes.iter().enumerate();
        let mut nodes = nodes.filter(|(k, _)| cell.contains(k));
        nodes.find_map(|(_, &node)| singular.iter().find(|own| own.node() == node).copied())
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
    places.extend(corners(plan, body, mesh));
    Ok(places)
}

/// Corners of more than half a turn, which the mesh has as nodes.
fn corners(plan: &Plan<'_>, body: usize, mesh: &Mesh) -> Vec<Singular> {
    let own = &plan.bodies[body];
    let [x, y] = own.centre;
    let nearest = |at: [f64; 2]| {
        let apart = |node: &usize| {
            let [u, v] = mesh.nodes()[*node];
            (u - at[0]).hypot(v - at[1])
        };
        (0..mesh.nodes().len()).min_by(|a, b| apart(a).total_cmp(&apart(b)))
    };
    let corners = own.shape.reentrant_corners().into_iter();
    let corner = |([u, v], angle): ([f64; 2], f64)| {
        let node = nearest([x + u, y + v])?;
        Some(Singular::Corner { node, angle })
    };
    corners.filter_map(corner).collect()
}
