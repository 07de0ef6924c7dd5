//! Names of sets.

use std::fmt;

/// A set of a body, written `body.set`.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SetRef {
    /// The body.
    pub body: String,
    /// Its edge or point.
    pub set: String,
}

impl fmt::Display for SetRef {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}.{}", self.body, self.set)
    }
}
