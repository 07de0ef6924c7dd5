//! Triangle meshes of plane bodies whose outline is made of straight lines, circular arcs and splines, with cut-outs of the same and circular
//! holes anywhere in it.
//!
//! A size function rules the cells,
//!
//! ```text
//! h(x) = min over sources s of (h_s + g |x − x_s|),
//! ```
//!
//! with growth g and sources on holes, arcs, splines, sharp and re-entrant corners, narrow gaps and walls, and edges that are to be finer.
//!
//! | step | result | source |
//! | --- | --- | --- |
//! | frame | the body in unit size, turned and mirrored so that its triangles do not depend on how it is drawn; one side of each mirror | |
//! | rings | layers of nearly square cells around each hole, cut into triangles; their nodes stay where they are | as the fans of `stickslip_fem_core::generate` |
//! | edges | nodes on the outline, equally spaced in ∫ ds/h; equal first edges on both sides of an acute corner | Ruppert (1995), § 5 |
//! | refinement | constrained Delaunay triangles, circumcentres of large or flat ones inserted | Ruppert (1995); Shewchuk (2002) |
//! | smoothing | inner nodes moved where the least angle around them grows, triangulated anew | Freitag & Ollivier-Gooch (1997) |
//! | cells | T3, or T6 with the inner nodes of boundary edges on the true curve | |
//!
//! ```
//! use stickslip_fem_core::generate::{Extent, Generate, uniform_angles};
//! use stickslip_mesher::{Contour, ContourMesh, Course, Division, Hole, Piece};
//!
//! let line = |name: &str, to| Piece { name: name.into(), to, course: Course::Line };
//! let contour = Contour {
//!     start: [0.0, 0.0],
//!     pieces: vec![
//!         line("bottom", [4.0, 0.0]),
//!         line("right", [4.0, 2.0]),
//!         line("top", [0.0, 2.0]),
//!         line("left", [0.0, 0.0]),
//!     ],
//!     cutouts: Vec::new(),
//!     holes: vec![Hole {
//!         name: "hole".into(),
//!         centre: [3.0, 1.0],
//!         radius: 0.25,
//!         angles: uniform_angles(Extent::Whole, 36),
//!         layers: None,
//!     }],
//! };
//! let mesh = ContourMesh { contour, division: Division::default() }.generate()?;
//! assert_eq!(mesh.edge_set("hole")?.edges.len(), 36);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The same input gives the same bits. All lengths are in one unit `[length]`, angles in rad, counter-clockwise from x.
//!
//! Sources: Ruppert, J. Algorithms 18 (1995) 548–585; Shewchuk, Comput. Geom. 22 (2002) 21–74; Freitag & Ollivier-Gooch,
//! Int. J. Numer. Meth. Engng 40 (1997) 3979–4002.

mod assemble;
mod contour;
mod contour_mesh;
mod course;
mod cubic;
mod curve;
mod division;
mod edges;
mod error;
mod frame;
mod meet;
mod orientation;
mod outline;
mod path;
mod plan;
mod quality;
mod ring;
mod size;
mod smooth;
mod spline;
mod symmetry;
mod triangulate;
mod vector;

/// The crate of the meshes.
pub use stickslip_fem_core;

pub use contour::{Contour, Cutout, Hole, Piece};
pub use contour_mesh::ContourMesh;
pub use course::{Course, Spline};
pub use division::Division;
pub use error::{ContourError, SplineFlaw};
pub use path::{Path, Stretch};
pub use quality::{Quality, quality};
