//! Why a sweep stops.

use miette::Diagnostic;
use thiserror::Error;

/// Why a sweep stops, beyond what is wrong with its files ([`SceneError`](stickslip_scene::diagnostic::SceneError)) and its cases, which are
/// rows with their reasons.
#[derive(Debug, Error, Diagnostic)]
#[non_exhaustive]
pub enum SweepError {
    /// The table of another sweep.
    #[error("the table is that of another sweep: {what}")]
    #[diagnostic(
        code(sweep::other),
        help(
            "name another folder with --output DIR, or go back to the sweep and the base scene that the table was begun with"
        )
    )]
    Other {
        /// What differs.
        what: String,
    },
    /// A row of a table that is read again.
    #[error("line {line} of the table: {what}")]
    #[diagnostic(
        code(sweep::row),
        help("delete the line; the case that it stands for is then solved again")
    )]
    Row {
        /// Line, from 1.
        line: u64,
        /// What is wrong.
        what: String,
    },
    /// A row cannot be written.
    #[error("the table cannot be written: {cause}")]
    #[diagnostic(
        code(sweep::write),
        help("make room on the disk, and go on with --resume")
    )]
    Write {
        /// Its reason.
        #[source]
        cause: csv::Error,
    },
    /// No threads.
    #[error("a worker cannot be started: {cause}")]
    #[diagnostic(code(sweep::threads), help("ask for fewer workers with --jobs"))]
    Workers {
        /// Its reason.
        #[source]
        cause: Box<dyn std::error::Error + Send + Sync>,
    },
}
