//! Results of runs for readers: tables, figures, pages and files, see [`results`].
//!
//! Nothing here touches a file: each file is passed as name and bytes to the caller's [`PutFile`].
//!
//! ```
//! use std::path::Path;
//! use stickslip_ladder::run;
//! use stickslip_present::results::summary_json;
//! use stickslip_scene::{Format, Scene};
//!
//! let text = r#"
//!     version = 1
//!     [materials.steel.isotropic]
//!     young = "210 GPa"
//!     poisson = 0.3
//!     [bodies.ring]
//!     material = "steel"
//!     thickness = "2 mm"
//!     shape.plate_with_hole = { hole_radius = "5 mm", outline.ring = { radius = "20 mm" } }
//!     [mesh]
//!     spacing = "5 deg"
//!     [[supports]]
//!     on = "ring.outer"
//!     fix = ["x", "y"]
//!     [[loads]]
//!     on = "ring.hole"
//!     pressure.steps = ["10 MPa"]
//!     [[edges]]
//!     on = "ring.hole"
//! "#;
//! let scene = Scene::from_text(text, Format::Toml, "ring.toml", Path::new(""), &[""; 0])?;
//! let summary = summary_json(&run(&scene, &mut |_| {})?)?;
//! // Lamé's ring of radii a, b with a fixed rim, b/a = 4 and ν = 0.3: σ_θ = p ((1 − ν) b²/a² − (1 + ν))/((1 − ν) b²/a² + (1 + ν)).
//! let hoop = summary["steps"][0]["peak_hoop"]["value"].as_f64().unwrap_or(0.0);
//! assert!((hoop / 7.92 - 1.0).abs() < 0.01, "{hoop} MPa");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod results;

/// The crate whose values summaries are.
pub use serde_json;
/// The crates of meshes, scenes, results, findings and figures that tables, pages and errors show.
pub use {
    stickslip_fem_core, stickslip_mesh_files, stickslip_report, stickslip_results, stickslip_scene,
};

pub use stickslip_report::PutFile;
