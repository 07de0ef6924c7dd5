//! Failures that are known and not mended, each with its reason. They are counted and shown, and do not fail a run.

use super::trial::Failure;

/// A known failure.
pub(super) struct Open {
    pub(super) kind: &'static str,
    pub(super) check: &'static str,
    pub(super) seeds: &'static [u64],
    pub(super) reason: &'static str,
}

/// All of them.
pub(super) const OPEN: &[Open] = &[];

/// Whether `failure` of `kind` is known.
pub(super) fn is_known(kind: &str, failure: &Failure) -> bool {
    OPEN.iter().any(|open| {
        open.kind == kind && open.check == failure.check && open.seeds.contains(&failure.seed)
    })
}
