//! Lines of files, for messages.

use std::fmt;
use std::sync::Arc;

/// A line of the text, or of a file that it includes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Name of the included file; none in the text itself.
    pub file: Option<Arc<str>>,
    /// Line number, counted from 1.
    pub line: usize,
}

impl fmt::Display for Place {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "line {}", self.line)?;
        match &self.file {
            Some(file) => write!(out, " of '{file}'"),
            None => Ok(()),
        }
    }
}

/// A [`Place`] in eight bytes: one is kept for every node and element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Spot {
    /// 0 is the text itself, k the k-th included file.
    pub(crate) file: u32,
    pub(crate) line: u32,
}

/// Names of the included files.
#[derive(Debug, Default)]
pub(crate) struct Files {
    names: Vec<Arc<str>>,
}

impl Files {
    /// Adds an included file and returns its number.
    pub(crate) fn add(&mut self, name: &str) -> u32 {
        self.names.push(name.into());
        self.names.len() as u32
    }

    /// How many files have been included.
    pub(crate) fn len(&self) -> usize {
        self.names.len()
    }

    /// The place to show for `spot`.
    pub(crate) fn place(&self, spot: Spot) -> Place {
        let file = (spot.file as usize).checked_sub(1);
        Place {
            file: file.and_then(|k| self.names.get(k).cloned()),
            line: spot.line as usize,
        }
    }
}
