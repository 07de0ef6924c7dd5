//! Scenes: what is modelled, in a text file with units.
//!
//! A scene names materials, bodies, a mesh, contacts with their friction laws, supports and loads; see `stickslip init` for a
//! commented one. Every quantity carries its unit and arrives here in base units (mm, N, MPa, rad, K). A [`Scene`] that exists is
//! checked: names resolve, sizes are positive, every body is held, all loads have the same number of steps.
//!
//! ```
//! use std::path::Path;
//! use stickslip_scene::{Format, Scene};
//!
//! let text = r#"
//!     version = 1
//!     [materials.steel.isotropic]
//!     young = "210 GPa"
//!     poisson = 0.3
//!     [bodies.plate]
//!     material = "steel"
//!     thickness = "2 mm"
//!     shape.plate_with_hole = { hole_radius = "5 mm", outline.ring = { radius = "50 mm" } }
//!     [mesh]
//!     spacing = "5 deg"
//!     [[supports]]
//!     on = "plate.outer"
//!     fix = ["x", "y"]
//!     [[loads]]
//!     on = "plate.hole"
//!     pressure.steps = ["10 MPa"]
//! "#;
//! let scene = Scene::from_text(text, Format::Toml, "press.toml", Path::new("."), &["mesh.spacing=2.5 deg"])?;
//! assert_eq!(scene.steps(), 1);
//! # Ok::<(), stickslip_scene::diagnostic::SceneError>(())
//! ```

mod build;
pub mod declaration;
pub mod digest;
mod examples;
mod foreign;
mod format;
mod friction;
mod from_file;
pub mod keys;
mod material;
pub mod open;
mod overrides;
mod pattern;
pub mod placement;
mod point_model;
pub mod read;
mod scene;
pub mod schema;
pub mod shape;
mod table;
pub mod templates;

#[cfg(test)]
mod tests;

/// The crates whose values documents are made of, and whose diagnostics errors are.
pub use {miette, serde_json};
/// The crates of bodies, outlines, laws, contacts, laminates and joints that scenes hold.
pub use {
    stickslip_contact, stickslip_fem_core, stickslip_friction, stickslip_joint, stickslip_laminate,
    stickslip_mesh_files, stickslip_mesher,
};

pub use document::Format;
pub use scene::{Scene, VERSION};
pub use stickslip_document::{diagnostic, document, host, limits};
pub use stickslip_units as units;
