//! Failures that are known and not mended, from `open.toml`.

use std::sync::LazyLock;

use serde::Deserialize;

use super::trial::Failure;
use crate::publish::{compiled_in, listed};

/// A known failure.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Open {
    pub(super) kind: String,
    pub(super) check: String,
    pub(super) seeds: Vec<u64>,
    pub(super) reason: String,
}

/// All of them.
pub(super) static OPEN: LazyLock<Vec<Open>> =
    LazyLock::new(|| compiled_in(listed(include_str!("open.toml"), "open")));

/// Whether `failure` of `kind` is known.
pub(super) fn is_known(kind: &str, failure: &Failure) -> bool {
    OPEN.iter().any(|open| {
        open.kind == kind && open.check == failure.check && open.seeds.contains(&failure.seed)
    })
}

#[cfg(test)]
mod tests {
    use super::OPEN;

    #[test]
    fn every_known_failure_has_seeds_and_a_reason() {
        assert!(!OPEN.is_empty());
        assert!((OPEN.iter()).all(|open| !open.seeds.is_empty() && !open.reason.is_empty()));
    }
}
