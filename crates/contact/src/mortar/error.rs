//! Why edges cannot be projected.

use stickslip_fem_core::mesh::MAX_ORDER;
use thiserror::Error;

/// Why two edges cannot be projected on each other.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum MortarError {
    /// Edges have the orders of the elements.
    #[error("edges of order {0}; 1 to {MAX_ORDER} exist")]
    Order(usize),
    /// There are not as many parameters as nodes.
    #[error("{parameters} parameters for {nodes} nodes")]
    Parameters {
        /// Parameters given.
        parameters: usize,
        /// Nodes given.
        nodes: usize,
    },
    /// The number of nodes does not make whole edges.
    #[error("{nodes} nodes do not make whole edges of order {order}")]
    Nodes {
        /// Nodes given.
        nodes: usize,
        /// Order of the edges.
        order: usize,
    },
    /// The parameter does not ascend, or a number of it is not finite.
    #[error("the parameter goes from {from} to {to} after node {node} of the walk; it must ascend")]
    NotAscending {
        /// Place in the walk.
        node: usize,
        /// Parameter there, in the unit given.
        from: f64,
        /// Parameter at the next node, in the unit given.
        to: f64,
    },
    /// A mid-side node lies outside the middle half of its edge, where the edge folds back on itself.
    #[error(
        "the mid-side node {node} of the walk lies {fraction:.3} along its edge; 0.25 to 0.75 is possible"
    )]
    MidSide {
        /// Place in the walk.
        node: usize,
        /// Fraction of the edge `[1]`.
        fraction: f64,
    },
    /// The nodes inside an edge of order above 2 are so far from their places that the edge folds back on itself.
    #[error("edge {edge} of the walk folds back on itself between its nodes")]
    Folded {
        /// Place of the edge in the walk.
        edge: usize,
    },
    /// A closed edge spans more than its period, or two closed edges differ in it.
    #[error("an edge spans {span} of a period of {period}")]
    Period {
        /// What it spans, in the unit of the parameter.
        span: f64,
        /// The period, in the unit of the parameter.
        period: f64,
    },
    /// A length or thickness is not positive.
    #[error("the {what} is {value}; it must be positive")]
    NotPositive {
        /// What it is.
        what: &'static str,
        /// Its value `[length]`.
        value: f64,
    },
    /// A position is needed of a node that has none.
    #[error("node {node} of {count} has no position")]
    NoPosition {
        /// Index of the node.
        node: usize,
        /// Positions given.
        count: usize,
    },
    /// The edges do not face each other anywhere.
    #[error("the edges have no common part")]
    NoOverlap,
}
