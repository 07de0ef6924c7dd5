//! Experiments as files: what was measured, and what is asked of it.

mod candidate;
mod format;
pub mod history;
mod plan;

pub use candidate::{Candidate, RefusedLaw};
pub use plan::*;
