//! Supports: directions in which nodes are held, also skew to the axes, springs to the ground, platens that carry an edge, and holds of a whole section.

use crate::mesh::EdgeRef;

/// Direction in which a support holds its nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HeldDirection {
    /// Along x.
    X,
    /// Along y.
    Y,
    /// Along the direction at this angle `[rad]`, counter-clockwise from x.
    Angle(f64),
}

impl HeldDirection {
    /// Unit vector of the direction `[1]`.
    pub fn unit(self) -> [f64; 2] {
        match self {
            Self::X => [1.0, 0.0],
            Self::Y => [0.0, 1.0],
            Self::Angle(angle) => [angle.cos(), angle.sin()],
        }
    }
}

/// Nodes held in one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Support {
    /// The nodes.
    pub nodes: Vec<usize>,
    /// The direction.
    pub direction: HeldDirection,
    /// Displacement in that direction `[length]`, scaled by the load case that drives the supports.
    pub displacement: f64,
}

/// Springs between nodes of a body and the ground, which is at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Spring {
    /// Where they are.
    pub site: SpringSite,
    /// The direction in which they act; across it they give way.
    pub direction: HeldDirection,
    /// Force per displacement `[force/length]` at a node, per displacement and area `[stress/length]` on edges.
    pub stiffness: f64,
}

/// Where springs are.
#[derive(Clone, Debug, PartialEq)]
pub enum SpringSite {
    /// Spread evenly over edges.
    Edges(Vec<EdgeRef>),
    /// At a node.
    Node(usize),
}

/// A rigid plate glued to nodes, free to move along some axes and never turning.
#[derive(Clone, Debug, PartialEq)]
pub struct Platen {
    /// The nodes.
    pub nodes: Vec<usize>,
    /// Whether the platen moves freely along x and along y.
    pub free: [bool; 2],
}

/// Holds the mean displacement of a body over its area, by a reaction that is spread evenly over it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionHold {
    /// Whether the mean along x and along y is held.
    pub held: [bool; 2],
    /// Its values `[length]`, scaled by the load case that drives the supports.
    pub displacement: [f64; 2],
}
