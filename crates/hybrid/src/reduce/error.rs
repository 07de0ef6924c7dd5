//! Why displacements of nodes cannot be found.

use stickslip_fem_core::mesh::Point;
use thiserror::Error;

use super::Uncovered;
use crate::data::{DataError, Field, letter};
use crate::triangles::TriangulationError;

/// How many nodes an error shows as text.
const SHOWN: usize = 3;

/// Why displacements of nodes cannot be found.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ReduceError {
    /// A node does not exist.
    #[error("node {node} does not exist; there are {count} nodes")]
    NoSuchNode {
        /// Requested index.
        node: usize,
        /// Nodes that exist.
        count: usize,
    },
    /// A node's place is not finite.
    #[error("node {node} is at ({}, {}); numbers must be finite", .place[0], .place[1])]
    NotFinite {
        /// Index of the node.
        node: usize,
        /// Its place `[length]`.
        place: Point,
    },
    /// An invalid measurement.
    #[error(transparent)]
    Data(#[from] DataError),
    /// A setting is not a positive length.
    #[error("{what} is {value}; it must be positive")]
    Setting {
        /// What it is.
        what: &'static str,
        /// Its value `[length]`.
        value: f64,
    },
    /// A polynomial order does not exist.
    #[error("local polynomials have order 1, 2 or 3, not {0}")]
    Order(usize),
    /// A fit has fewer neighbours than terms.
    #[error("a polynomial of order {order} needs at least {needed} neighbours, not {found}")]
    Neighbours {
        /// Order.
        order: usize,
        /// Terms.
        needed: usize,
        /// Requested neighbours.
        found: usize,
    },
    /// There are fewer valid places than a fit's neighbours.
    #[error(
        "{} is valid at {valid} places; {needed} are needed around each node",
        letter(*component)
    )]
    TooFew {
        /// Component, 0 for x and 1 for y.
        component: usize,
        /// Valid places.
        valid: usize,
        /// Requested neighbours.
        needed: usize,
    },
    /// Valid places cannot be triangulated.
    #[error("the valid places of {} cannot be triangulated: {cause}", letter(*component))]
    Triangulation {
        /// Component, 0 for x and 1 for y.
        component: usize,
        /// Why.
        #[source]
        cause: TriangulationError,
    },
    /// Fringe lines were given in the wrong order.
    #[error(
        "the fringe lines at place {place} are those of the {field:?} field; U comes first, V second"
    )]
    Field {
        /// Place in the pair, 0 or 1.
        place: usize,
        /// Field found there.
        field: Field,
    },
    /// Nodes are not covered by the data.
    #[error("{} of {wanted} nodes are not covered by the data: {}", .nodes.len(), some(.nodes))]
    Uncovered {
        /// Requested nodes.
        wanted: usize,
        /// Those not covered.
        nodes: Vec<Uncovered>,
    },
    /// A reduction meets data of another size.
    #[error("{} has {found} data; the reduction was made for {needed}", letter(*component))]
    Size {
        /// Component, 0 for x and 1 for y.
        component: usize,
        /// Data found.
        found: usize,
        /// Data needed.
        needed: usize,
    },
    /// A reduction meets data that are masked where those it was made for were not.
    #[error(
        "{} is masked at ({}, {}), which the reduction uses; make it for both masks together",
        letter(*component),
        .place[0],
        .place[1]
    )]
    Masked {
        /// Component, 0 for x and 1 for y.
        component: usize,
        /// Where `[length]`.
        place: Point,
    },
}

fn some(nodes: &[Uncovered]) -> String {
    let mut shown: Vec<String> = nodes.iter().take(SHOWN).map(ToString::to_string).collect();
    if nodes.len() > SHOWN {
        shown.push(format!("and {} more", nodes.len() - SHOWN));
    }
    shown.join("; ")
}

/// A setting that must be a positive length, infinite included.
pub(super) fn positive(what: &'static str, value: f64) -> Result<(), ReduceError> {
    if value > 0.0 {
        Ok(())
    } else {
        Err(ReduceError::Setting { what, value })
    }
}

/// Nodes that exist, at finite places.
pub(super) fn check_nodes(places: &[Point], nodes: &[usize]) -> Result<(), ReduceError> {
    for &node in nodes {
        let place = *places.get(node).ok_or(ReduceError::NoSuchNode {
            node,
            count: places.len(),
        })?;
        if !place.iter().all(|x| x.is_finite()) {
            return Err(ReduceError::NotFinite { node, place });
        }
    }
    Ok(())
}
