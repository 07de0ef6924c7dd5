//! What can be wrong with a mesh.

use thiserror::Error;

use crate::kind::{ElementKind, Point};

/// Why a mesh, or a question to it, was refused.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum MeshError {
    /// No cell at all.
    #[error("the mesh has no cells")]
    Empty,
    /// A block's node list does not divide into cells.
    #[error("block '{block}': {length} node numbers do not divide into cells of {kind:?} ({} nodes each)", kind.nodes())]
    RaggedConnectivity {
        /// Name of the block.
        block: String,
        /// Kind of its cells.
        kind: ElementKind,
        /// Length of its node list.
        length: usize,
    },
    /// A cell refers to a node that does not exist.
    #[error(
        "cell {element} of block '{block}' refers to node {node}, but there are only {count} nodes"
    )]
    NodeOutOfRange {
        /// Global cell index.
        element: usize,
        /// Name of its block.
        block: String,
        /// The node number.
        node: usize,
        /// Number of nodes of the mesh.
        count: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("node {node} is not finite: ({}, {})", at[0], at[1])]
    NonFiniteNode {
        /// The node.
        node: usize,
        /// Its coordinates `[length]`.
        at: Point,
    },
    /// A node that no cell uses would make the stiffness matrix singular.
    #[error("node {node} at ({}, {}) belongs to no cell", at[0], at[1])]
    UnusedNode {
        /// The node.
        node: usize,
        /// Its coordinates `[length]`.
        at: Point,
    },
    /// A cell is folded or numbered clockwise.
    #[error(
        "cell {element} of block '{block}' is inverted: its Jacobian determinant is {determinant:.3e} at reference point ({}, {})",
        at[0], at[1]
    )]
    Inverted {
        /// Global cell index.
        element: usize,
        /// Name of its block.
        block: String,
        /// Determinant of the Jacobian `[length²]`.
        determinant: f64,
        /// Reference point where it was found `[1]`.
        at: Point,
    },
    /// A cell's Jacobian vanishes to rounding.
    #[error(
        "cell {element} of block '{block}' has no area: its Jacobian determinant is {determinant:.3e} at reference point ({}, {})",
        at[0], at[1]
    )]
    ZeroArea {
        /// Global cell index.
        element: usize,
        /// Name of its block.
        block: String,
        /// Determinant of the Jacobian `[length²]`.
        determinant: f64,
        /// Reference point where it was found `[1]`.
        at: Point,
    },
    /// A set contains an index that does not exist.
    #[error("{family} set '{set}' contains {what}, but there are only {count}")]
    SetOutOfRange {
        /// "node", "edge" or "element".
        family: &'static str,
        /// Name of the set.
        set: String,
        /// The member, as text.
        what: String,
        /// How many there are.
        count: usize,
    },
    /// A set contains the same thing twice.
    #[error("{family} set '{set}' contains {what} twice")]
    DuplicateInSet {
        /// "node", "edge" or "element".
        family: &'static str,
        /// Name of the set.
        set: String,
        /// The member, as text.
        what: String,
    },
    /// A requested set does not exist.
    #[error("no {family} set '{name}'; the mesh has: {}", listed(available))]
    MissingSet {
        /// "node", "edge" or "element".
        family: &'static str,
        /// The requested name.
        name: String,
        /// The names that exist.
        available: Vec<String>,
    },
    /// A chain was asked for from a set without edges.
    #[error("edge set '{set}' is empty")]
    EmptySet {
        /// Name of the set.
        set: String,
    },
    /// More than two edges of a set meet at a node.
    #[error("edge set '{set}': {edges} of its edges meet at node {node}; a boundary has at most 2")]
    NonManifoldEdge {
        /// Name of the set.
        set: String,
        /// The node.
        node: usize,
        /// How many edges meet there.
        edges: usize,
    },
    /// A set falls into several chains.
    #[error("edge set '{set}' falls into {chains} separate chains; a contact edge must be one")]
    DisconnectedEdge {
        /// Name of the set.
        set: String,
        /// Number of chains.
        chains: usize,
    },
    /// Two neighbouring edges of a set have their interiors on opposite sides.
    #[error("edge set '{set}': the material changes sides at node {node}")]
    MixedOrientation {
        /// Name of the set.
        set: String,
        /// The node between the two edges.
        node: usize,
    },
    /// A set mixes edges of different orders.
    #[error("edge set '{set}' mixes edges of different orders")]
    MixedOrder {
        /// Name of the set.
        set: String,
    },
}

fn listed(names: &[String]) -> String {
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
}
