//! Interface operators of circular bodies and of half-planes, without a mesh.
//!
//! A pin and the plate around its hole meet on a circle, on which elasticity is diagonal: with tractions q = Σ q_K e^{iKθ} along x and y (as x + iy),
//! the displacements are
//!
//! ```text
//! u = (R/2G) Σ g_K q_K e^{iKθ},     hole  g_K = 1/K, g_−K = κ/K,     disk  g_K = κ/K, g_−K = 1/K     (K ≥ 1, low modes apart)
//! ```
//!
//! so the compliance of nodes with hats between them is known in closed form. Bodies are
//! [`InterfaceOperator`](stickslip_fem_core::InterfaceOperator)s; contact does not distinguish them from condensed finite elements.
//!
//! | item | subject |
//! | --- | --- |
//! | [`Nodes`] | nodes on a circle, uniform or graded, whole, part or one half of a symmetric body |
//! | [`Hole`] | hole in an infinite plate |
//! | [`AnisotropicHole`] | the same in a plate of any linear material |
//! | [`Plate`] | hole in a plate with straight outer edges, [`Outline`], isotropic or anisotropic |
//! | [`Disk`] | pin, loaded and held at its centre or over its area |
//! | [`Field`] | stresses and displacements anywhere in a body |
//! | [`LineNodes`], [`HalfPlane`], [`HalfPlaneField`] | the same along a straight edge: half-planes |
//!
//! Signs: tension positive; forces λ and tractions q act on the body. θ counts from x, counter-clockwise. Any consistent units.
//!
//! Source: Muskhelishvili, *Some Basic Problems of the Mathematical Theory of Elasticity* (1953), §§ 54–59.

mod anisotropic;
mod arnoldi;
mod channel;
mod circle;
mod disk;
mod elasticity;
mod error;
mod expansion;
mod field;
mod gauss;
mod half_plane;
mod hole;
mod kernel;
mod lekhnitskii;
mod line;
mod nodes;
mod outline;
mod plate;

/// The crate of materials, loads and points.
pub use stickslip_fem_core;

pub use anisotropic::{AnisotropicHole, EdgeStress};
pub use circle::Circle;
pub use disk::{Anchor, Disk, DiskLoad};
pub use error::SeriesError;
pub use field::{Field, PolarStress};
pub use half_plane::{Ground, HalfPlane, HalfPlaneField, Lies};
pub use hole::{FarLoad, Hole};
pub use line::LineNodes;
pub use nodes::Nodes;
pub use outline::Outline;
pub use plate::{Accuracy, EdgeLoad, Fit, Plate};
