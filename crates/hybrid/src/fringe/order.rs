//! Arithmetic of fringe orders.

/// A number less its nearest whole number.
pub(super) fn wrap(value: f64) -> f64 {
    value - value.round()
}

/// Upper median; NaN of nothing.
pub(super) fn median(mut values: Vec<f64>) -> f64 {
    let middle = values.len() / 2;
    if values.is_empty() {
        f64::NAN
    } else {
        *values.select_nth_unstable_by(middle, f64::total_cmp).1
    }
}
