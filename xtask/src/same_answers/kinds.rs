//! Which parts of results are compared in which way.

use serde::Deserialize;

/// Keys and columns that are not compared value by value.
#[derive(Debug, Deserialize)]
pub(super) struct Kinds {
    /// What belongs to a run and not to its answers, as times: not compared.
    pub(super) ignored: Vec<String>,
    /// Texts for readers, whose words may change and whose numbers may not.
    pub(super) prose: Vec<String>,
}
