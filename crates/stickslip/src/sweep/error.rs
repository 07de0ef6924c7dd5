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
    #[error("line {line} of the table: {cause}")]
    #[diagnostic(
        code(sweep::row),
        help("delete the line; the case that it stands for is then solved again")
    )]
    Row {
        /// Line, from 1.
        line: u64,
        /// What is wrong.
        cause: RowError,
    },
    /// A row cannot be written.
    #[error("the table cannot be written")]
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
    #[error("a worker cannot be started")]
    #[diagnostic(code(sweep::threads), help("ask for fewer workers with --jobs"))]
    Workers {
        /// Its reason.
        #[source]
        cause: Box<dyn std::error::Error + Send + Sync>,
    },
}

/// Why a row of a table cannot be read.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RowError {
    /// A line that makes no cells.
    #[error(transparent)]
    Csv(#[from] csv::Error),
    /// More or fewer cells than headings.
    #[error("{cells} cells under {headings} headings")]
    Cells {
        /// Number of cells.
        cells: usize,
        /// Number of headings.
        headings: usize,
    },
    /// A cell of a number that holds none.
    #[error("'{0}' is not a number")]
    Number(String),
    /// A first cell that counts no case.
    #[error("'{0}' is not the number of a case")]
    CaseNumber(String),
    /// A case that the sweep does not have.
    #[error("case {case} does not exist: this sweep has {cases}")]
    Case {
        /// Its number, from 0.
        case: usize,
        /// Number of cases.
        cases: usize,
    },
    /// A failure mode that no joint has, or one without its angle.
    #[error("'{0}' is not a failure mode with an angle")]
    Mode(String),
    /// A row that says neither that it is solved nor why not.
    #[error("the outcome is missing")]
    Outcome,
}
