//! Least and greatest values.

/// Least and greatest of `values`; infinite, and the wrong way round, of none.
pub(crate) fn ends(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    values.fold(none, |[low, high], x| [low.min(x), high.max(x)])
}

/// The greatest less the least of `values`; 0 of none.
pub(crate) fn span(values: impl Iterator<Item = f64>) -> f64 {
    let [low, high] = ends(values);
    (high - low).max(0.0)
}
