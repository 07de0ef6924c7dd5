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

/// Takes a file by its name in the folder of results and its bytes, and says why it cannot be kept; may be called from several threads.
pub type PutFile<'a> =
    dyn Fn(&str, &[u8]) -> Result<(), Box<dyn std::error::Error + Send + Sync>> + Sync + 'a;
