//! What halving increments leaves of a number, by the changes that it made.

/// The error that increments leave is at most so many times the change that halving them last made.
const SLOWEST: f64 = 4.0;

/// The error that given increments leave is at most so many times what four times as many change.
pub(super) fn of_four() -> f64 {
    let rate = SLOWEST / (1.0 + SLOWEST);
    1.0 / (1.0 - rate * rate)
}

/// The same of what twice as many change.
pub(super) fn of_two() -> f64 {
    1.0 + SLOWEST
}

/// The sum of the geometric series that goes on at the rate of the last two changes, between that of first order and that of [`SLOWEST`].
pub(super) fn error(change: Option<f64>, before: Option<f64>) -> Option<f64> {
    let change = change?;
    let slowest = SLOWEST / (1.0 + SLOWEST);
    let rate = before.map_or(slowest, |before| (change / before).clamp(0.5, slowest));
    // Equal numbers have no rate.
    let rate = if rate.is_finite() { rate } else { slowest };
    Some(change * rate / (1.0 - rate))
}
