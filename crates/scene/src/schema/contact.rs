//! Edges that may touch.

use serde::{Deserialize, Serialize};
use stickslip_friction::FrictionLaw;

use super::SetRef;

/// Two edges that may touch.
#[derive(Debug, Clone)]
pub struct Contact {
    /// Name in results.
    pub name: String,
    /// The edge that the normal points into: hole, or cylinder.
    pub first: SetRef,
    /// The other edge: rim of a pin, outer edge of a ring, or block.
    pub second: SetRef,
    /// How the initial gap is computed.
    pub gap: GapKind,
    /// How the two edges are tied to each other.
    pub projection: ProjectionChoice,
    /// Whether an initial overlap is meant.
    pub interference: bool,
    /// Its friction.
    pub law: Box<dyn FrictionLaw>,
}

/// How the initial gap between two circles is computed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum GapKind {
    /// From the circles.
    #[default]
    Exact,
    /// c (1 − cos θ), clearance c: what closed forms assume.
    Linearised,
    /// From the nodes and straight facets of the mesh.
    Faceted,
}

/// How two edges in contact are tied to each other.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ProjectionChoice {
    /// Pairs of nodes where the meshes match, dual mortar where they do not.
    #[default]
    Auto,
    /// Pairs of nodes; the meshes must match.
    Nodes,
    /// Mortar projection with the shape functions of the first edge.
    Mortar,
    /// Mortar projection with functions biorthogonal to them.
    DualMortar,
}

impl ProjectionChoice {
    /// Whether it asks for a mortar projection.
    pub fn is_mortar(self) -> bool {
        matches!(self, Self::Mortar | Self::DualMortar)
    }
}
