//! Why a body cannot be made or condensed.

use thiserror::Error;

use crate::linalg::FactorError;
use crate::mesh::Point;

/// Why a body cannot be made or condensed.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum BodyError {
    /// The number of materials is not the number of element blocks.
    #[error("{materials} materials for {blocks} element blocks: each block needs one")]
    MaterialCount {
        /// Materials given.
        materials: usize,
        /// Blocks of the mesh.
        blocks: usize,
    },
    /// The thickness `[length]` is not a positive number.
    #[error("thickness {0} is not positive")]
    Thickness(f64),
    /// A support, platen or interface names a node that the mesh does not have.
    #[error("node {node} does not exist")]
    NoSuchNode {
        /// Index of the node.
        node: usize,
    },
    /// An interface names a node twice.
    #[error("node {node} appears twice in the interface")]
    RepeatedNode {
        /// Index of the node.
        node: usize,
    },
    /// Two supports ask different displacements of a node in one direction, or a support holds or moves a node of a platen
    /// in a way that the platen does not.
    #[error("the supports of node {node} contradict each other")]
    ContradictingSupports {
        /// Index of the node.
        node: usize,
    },
    /// A support has a direction or displacement that is not a finite number.
    #[error("support {support}: its direction or displacement is not a finite number")]
    SupportNotFinite {
        /// Index of the support.
        support: usize,
    },
    /// Springs whose stiffness is not a positive number.
    #[error(
        "spring {spring}: its stiffness {stiffness} is not positive, or its direction is not a finite number"
    )]
    Spring {
        /// Index of the spring.
        spring: usize,
        /// Its stiffness, in the unit of [`Spring::stiffness`](crate::support::Spring::stiffness).
        stiffness: f64,
    },
    /// A platen is free along an axis in which supports elsewhere, or springs, hold the body.
    #[error(
        "the platen is free in {free} translations, but supports and springs leave the body only {left}: hold the platen there too, and put no spring on its body along a free axis"
    )]
    PlatenResisted {
        /// Translations that the platen is free to make.
        free: usize,
        /// Translations that the supports leave.
        left: usize,
    },
    /// The mean displacement over the area is held where supports hold the body already.
    #[error(
        "the mean displacement over the section is held along an axis in which other supports hold the body already"
    )]
    SectionHeld,
    /// A part of the mesh that shares no node with the rest, or is all of it, has a rigid motion that nothing prevents.
    #[error(
        "{} can move freely in {motions} of its 3 rigid motions: nothing holds it",
        match parts {
            1 => "the mesh".to_owned(),
            _ => format!("the part of the mesh at ({:.4}, {:.4}), one of {parts},", at[0], at[1]),
        }
    )]
    LoosePart {
        /// A node of the part.
        node: usize,
        /// Its place `[length]`.
        at: Point,
        /// Of how many parts of the mesh it is one; 1 where the mesh can move as a whole.
        parts: usize,
        /// Number of rigid motions that nothing prevents.
        motions: usize,
    },
    /// A load case has a vector of the wrong length, or a number that is not finite.
    #[error("load case {case}: {what}")]
    LoadCase {
        /// Index of the case.
        case: usize,
        /// What is wrong.
        what: &'static str,
    },
    /// A body was given to a structure made for another mesh.
    #[error(
        "the structure was made for another mesh: it has {expected} nodes, this body's has {found}"
    )]
    OtherStructure {
        /// Nodes of the structure's mesh.
        expected: usize,
        /// Nodes of the body's mesh.
        found: usize,
    },
    /// A body was given to a structure made for other supports or another platen.
    #[error("the structure was made for other supports")]
    OtherSupports,
    /// There is not one value per quadrature point.
    #[error("{found} {what} for {expected} quadrature points")]
    PointCount {
        /// What is counted.
        what: &'static str,
        /// Quadrature points of the mesh.
        expected: usize,
        /// Values given.
        found: usize,
    },
    /// The factorisation failed.
    #[error(transparent)]
    Factor(#[from] FactorError),
}
