//! Why results could not be written.

use stickslip_fem_core::mesh::MeshError;
use stickslip_fem_core::vtk::VtkError;
use stickslip_report::FigureError;
use stickslip_report::page::PageError;
use thiserror::Error;

/// Why results could not be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum OutputError {
    /// What takes the files refuses one.
    #[error(transparent)]
    Put(#[from] Box<dyn std::error::Error + Send + Sync>),
    /// Parts of the results that do not belong together.
    #[error("the results do not fit together: {what} has {found} entries, expected {expected}")]
    Inconsistent {
        /// Which part.
        what: String,
        /// Entries found.
        found: usize,
        /// Entries needed.
        expected: usize,
    },
    /// An index that leads out of the list that it belongs to.
    #[error("the results do not fit together: {what} names entry {index} of {entries}")]
    NoEntry {
        /// Which part.
        what: String,
        /// The index, from 0.
        index: usize,
        /// Entries that there are.
        entries: usize,
    },
    /// Fields of a body that does not exist or is rigid.
    #[error("step {step} has fields of body {body}, which is not an elastic body of the results")]
    NoBody {
        /// Load step, from 1.
        step: usize,
        /// Index of the body.
        body: usize,
    },
    /// A body's mesh in display units.
    #[error("body '{body}': its mesh cannot be written in display units")]
    Mesh {
        /// The body.
        body: String,
        /// Its reason.
        #[source]
        cause: MeshError,
    },
    /// A mesh that no format of other programs holds.
    #[error(
        "body '{body}': its mesh cannot be written for other programs: {cause}; leave out output.meshes"
    )]
    MeshFile {
        /// The body.
        body: String,
        /// Its reason.
        cause: stickslip_mesh_files::WriteError,
    },
    /// A field file.
    #[error("the field file '{file}' could not be written")]
    Vtk {
        /// The file.
        file: String,
        /// Its reason.
        #[source]
        cause: VtkError,
    },
    /// A figure as PNG.
    #[error("the figure '{name}' could not be written as PNG")]
    Picture {
        /// Name of the figure.
        name: String,
        /// Its reason.
        #[source]
        cause: FigureError,
    },
    /// The page.
    #[error("the report page could not be written")]
    Page(#[from] PageError),
    /// The summary.
    #[error("the summary could not be written")]
    Summary(#[from] serde_json::Error),
}
