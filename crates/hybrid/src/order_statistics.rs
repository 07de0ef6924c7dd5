//! Values by their place in the order of all.

/// Median of |x| over the standard deviation of a normal distribution.
pub(crate) const NORMAL_MEDIAN: f64 = 0.674_489_750_196_082;

/// Median, the upper one of two; `None` of nothing.
pub(crate) fn median(values: Vec<f64>) -> Option<f64> {
    above(values, 0.5)
}

/// The value that a `part`, below 1, of all are less than; `None` of nothing.
pub(crate) fn above(mut values: Vec<f64>, part: f64) -> Option<f64> {
    // Less than the length, as `part` is below 1.
    let index = (part * values.len() as f64) as usize;
    if values.is_empty() {
        return None;
    }
    Some(*values.select_nth_unstable_by(index, f64::total_cmp).1)
}
