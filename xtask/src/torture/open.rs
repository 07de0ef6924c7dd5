//! Failures that are known and not mended, from `open.toml`.

use std::sync::LazyLock;

use serde::Deserialize;

use super::trial::Failure;
use crate::publish::listed;

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
    LazyLock::new(|| listed(include_str!("open.toml"), "open").expect("tests read it"));

/// Whether `failure` of `kind` is known.
pub(super) fn is_known(kind: &str, failure: &Failure) -> bool {
    OPEN.iter().any(|open| {
        open.kind == kind && open.check == failure.check && open.seeds.contains(&failure.seed)
    })
}
