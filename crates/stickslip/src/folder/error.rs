//! What can go wrong with files.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

use super::{LIST, MARKER};

/// What keeps results from being written. Each message names the path and a remedy.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum FolderError {
    /// The target is there already and may not be replaced.
    #[error("'{}' exists; choose another folder or ask to overwrite it", path.display())]
    Exists {
        /// The target.
        path: PathBuf,
    },
    /// Files that this program did not write would be lost.
    #[error(
        "'{}' holds what stickslip did not write: {}; nothing is overwritten, so choose another folder or move these files away",
        path.display(),
        listed(files)
    )]
    Foreign {
        /// The target.
        path: PathBuf,
        /// What is in the way, relative to the target; folders end in `/`.
        files: Vec<String>,
    },
    /// The folder holds what another command computed.
    #[error("'{}' holds results of {command}, which are not replaced; choose another folder", path.display())]
    OtherResults {
        /// The target.
        path: PathBuf,
        /// The command.
        command: &'static str,
    },
    /// Another process writes into the folder.
    #[error("another process writes into '{}'; wait for it or choose another folder", path.display())]
    Busy {
        /// The folder.
        path: PathBuf,
    },
    /// A path such as `..` or the empty one.
    #[error("'{}' names no file or folder; give a path that ends in a name", path.display())]
    NoName {
        /// The path as given.
        path: PathBuf,
    },
    /// The target, or a part of its path, is a file.
    #[error("results cannot be written to '{}': '{}' is a file, not a folder", path.display(), file.display())]
    NotAFolder {
        /// The target.
        path: PathBuf,
        /// The file.
        file: PathBuf,
    },
    /// A name inside the folder that leads out of it, or is [`MARKER`] or [`LIST`].
    #[error(
        "'{name}' cannot be a file of the result folder; use a relative path without control characters other than {MARKER} and {LIST}"
    )]
    Name {
        /// The name as given.
        name: String,
    },
    /// The results were abandoned by [`FolderHandle::abandon`](super::FolderHandle::abandon).
    #[error("the results for '{}' were abandoned", path.display())]
    Abandoned {
        /// The target.
        path: PathBuf,
    },
    /// The place for the results cannot be written.
    #[error("cannot write to '{}'; check that it exists, its permissions and the free space", path.display())]
    Unwritable {
        /// The file or folder that was to be written.
        path: PathBuf,
        /// The system's reason.
        #[source]
        cause: io::Error,
    },
    /// The new results could not be put in place; the target is as before.
    #[error(
        "the new results could not be put in '{}'; they are kept in '{}'",
        path.display(),
        kept.display()
    )]
    NotPlaced {
        /// The target.
        path: PathBuf,
        /// Where the new results are.
        kept: PathBuf,
        /// The system's reason.
        #[source]
        cause: io::Error,
    },
    /// Neither the new results nor, after that, the old ones could be put in place.
    #[error(
        "neither the new results, kept in '{}', nor the old ones, kept in '{}', could be put in '{}'; \
         move one of them there",
        kept.display(),
        old.display(),
        path.display()
    )]
    NotRestored {
        /// The target.
        path: PathBuf,
        /// Where the new results are.
        kept: PathBuf,
        /// Where the old results are.
        old: PathBuf,
        /// The system's reason.
        #[source]
        cause: io::Error,
    },
    /// The results are in place, but what they replaced could not be deleted.
    #[error("results are in '{}', but the old ones in '{}' could not be deleted", path.display(), old.display())]
    OldKept {
        /// The target, with the new results.
        path: PathBuf,
        /// Where what is left of the old results is.
        old: PathBuf,
        /// The system's reason.
        #[source]
        cause: io::Error,
    },
}

/// The first of some names, each on one line of printable text.
fn listed(names: &[String]) -> String {
    const MOST: usize = 8;
    let shown: Vec<String> = names
        .iter()
        .take(MOST)
        .map(|name| format!("'{}'", name.escape_debug()))
        .collect();
    let more = match names.len().saturating_sub(MOST) {
        0 => String::new(),
        count => format!(" and {count} more"),
    };
    shown.join(", ") + &more
}
