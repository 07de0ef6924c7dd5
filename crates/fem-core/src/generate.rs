//! Structured, graded meshes of the bodies that contact problems are made of.
//!
//! Every generator maps lattices of cells to the plane,
//!
//! ```text
//! x(i, j),   0 ≤ i ≤ nᵢ,   0 ≤ j ≤ nⱼ,
//! ```
//!
//! fractions of steps giving the inner nodes of edges (half steps on quadratic cells), so that they lie on the true circle. Lattices are joined where
//! their nodes coincide ([`Blocks`]). Triangles come from cutting each quadrilateral along its shorter diagonal.
//!
//! | generator          | body                                       | edge and node sets                                 |
//! |--------------------|--------------------------------------------|----------------------------------------------------|
//! | [`PlateWithHole`]  | strip or ring around a circular hole       | hole, left, right, top, bottom, outer, symmetry    |
//! | [`Disk`]           | disk, for a pin                            | rim, symmetry; nodes also: centre                  |
//! | [`Rectangle`]      | rectangle                                  | left, right, bottom, top                           |
//! | [`CylinderOnBlock`]| block and cylindrical cap, matching nodes  | contact, bottom or top, left, right, symmetry      |
//!
//! All lengths are in one unit `[length]`, angles in rad, counter-clockwise from x.

mod blocks;
mod count;
mod cylinder;
mod disk;
mod error;
mod fan;
mod plate;
mod rectangle;
mod spacing;

pub use blocks::{BlockId, Blocks, Side};
pub use cylinder::{CylinderOnBlock, CylinderOnBlockMeshes};
pub use disk::Disk;
pub use error::GenerateError;
pub use fan::{bisected_angles, uniform_angles, unit_vector};
pub use plate::{Outline, PlateWithHole};
pub use rectangle::Rectangle;
pub use spacing::{geometric, graded, graded_both};

/// Number of nodes that [`Generate::generate`] allows.
pub const DEFAULT_NODE_LIMIT: usize = 50_000_000;

/// Which part of a symmetric body is meshed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// The half on the positive side of the symmetry line: y ≥ 0 (about the centre) for holes and disks, x ≥ 0 for
    /// [`CylinderOnBlock`]. The cut is the set "symmetry".
    Half,
    /// All of it.
    Whole,
}

/// How the layers of cells grow away from the contact circle.
#[derive(Clone, Debug, PartialEq)]
pub enum Growth {
    /// Geometric growth along each ray. The first layer is `aspect` times as thick as the neighbouring cells are wide on
    /// the circle, but never thicker than equal layers would be.
    Geometric {
        /// Thickness of the first layer over the local arc spacing `[1]`; 1 makes square cells.
        aspect: f64,
    },
    /// The far side of each layer as a fraction of the way from the circle `[1]`: as many numbers as layers, increasing strictly
    /// from above 0 to exactly 1.
    Fractions(Vec<f64>),
}

/// Size of a mesh before it is made: exact for structured meshes, an estimate otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshEstimate {
    /// Number of nodes.
    pub nodes: usize,
    /// Number of cells.
    pub elements: usize,
}

/// A description of a body that can be meshed.
pub trait Generate {
    /// What is made: a mesh, or several that match.
    type Output;

    /// Size of the result before it is made; exact if it follows from counts alone.
    ///
    /// # Errors
    /// Whatever is wrong with the input.
    fn estimate(&self) -> Result<MeshEstimate, GenerateError>;

    /// Generates if the result has at most `limit` nodes; nothing large is allocated before that is known.
    ///
    /// # Errors
    /// Whatever is wrong with the input, [`GenerateError::TooLarge`], or [`GenerateError::Mesh`] if the cells of a valid
    /// input turn out folded.
    fn generate_within(&self, limit: usize) -> Result<Self::Output, GenerateError>;

    /// Generates within [`DEFAULT_NODE_LIMIT`].
    ///
    /// # Errors
    /// As [`Generate::generate_within`].
    fn generate(&self) -> Result<Self::Output, GenerateError> {
        self.generate_within(DEFAULT_NODE_LIMIT)
    }
}
