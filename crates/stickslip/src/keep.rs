//! Results and findings in folders that appear whole or not at all.

use std::path::PathBuf;

use stickslip_engine::results::Results;
use stickslip_experiment_pages::report::{ExperimentReport, ReportError};
use stickslip_present::results::{self, OutputError};
use thiserror::Error;

use crate::folder::{FolderError, ResultFolder};

/// Why results or findings cannot be kept.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum KeepError {
    /// The folder or a file in it.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// A file of results cannot be made.
    #[error(transparent)]
    Results(#[from] OutputError),
    /// A file of findings cannot be made.
    #[error(transparent)]
    Findings(#[from] ReportError),
}

/// Writes all files of `results` into `folder`, which was prepared before the run, puts it in its place and returns its path. Figures are
/// drawn if `figures` says so.
///
/// # Errors
/// [`KeepError::Results`] for a file that cannot be made, [`KeepError::Folder`] for one that cannot be written; nothing is left then.
pub fn results(
    results: &Results,
    folder: ResultFolder,
    figures: bool,
) -> Result<PathBuf, KeepError> {
    let summary = results::write(results, figures, &|name, bytes| {
        Ok(folder.write(name, bytes)?)
    })?;
    Ok(folder.finish(&summary)?)
}

/// Writes all files of `report` into `folder`, puts it in its place and returns its path.
///
/// # Errors
/// [`KeepError::Findings`] for a file that cannot be made, [`KeepError::Folder`] for one that cannot be written; nothing is left then.
pub fn report(report: ExperimentReport, folder: ResultFolder) -> Result<PathBuf, KeepError> {
    let summary = report.write(&|name, bytes| Ok(folder.write(name, bytes)?))?;
    Ok(folder.finish(&summary)?)
}
