//! Results and findings for readers: tables, figures, pages and files.
//!
//! | module | shows |
//! | --- | --- |
//! | [`results`] | what a run yields |
//! | [`experiment`] | what was found in measured displacements |
//!
//! Nothing here touches a file: each file is passed as name and bytes to the caller's [`PutFile`].

mod csv;
pub mod experiment;
pub mod results;

/// The crate whose values summaries are.
pub use serde_json;
/// The crates of meshes, scenes, results, findings and figures that tables, pages and errors show.
pub use {
    stickslip_engine, stickslip_fem_core, stickslip_measure, stickslip_report, stickslip_scene,
};

/// Takes a file by its name in the folder of results and its bytes, and says why it cannot be kept; may be called from several threads.
pub type PutFile<'a> =
    dyn Fn(&str, &[u8]) -> Result<(), Box<dyn std::error::Error + Send + Sync>> + Sync + 'a;
