//! Whether a history tends to a limit as its steps get smaller, and how fast.
//!
//! ```text
//! e(n) ≈ C n⁻ᵖ      e: difference from the finest history, p: slope of a straight line through (log n, log e)
//! ```

/// Steps from which differences are looked at; before, they say how coarse one may be.
const FIRST: f64 = 10.0;
/// Part of the finest number of steps up to which the finest history may stand for the limit.
const LAST: f64 = 0.25;
/// Least order that counts as a limit.
const ORDER: f64 = 0.25;

/// One sentence on the `curve` of differences e over numbers of steps n of the history `name`.
pub(super) fn remark(name: &str, curve: &[[f64; 2]]) -> String {
    let percent = |number: f64| {
        let own = curve.iter().find(|point| point[0] == number);
        own.map_or_else(
            || "nothing measurable".to_owned(),
            |point| format!("{} %", significant(100.0 * point[1])),
        )
    };
    let sizes = format!(
        "{name}: one step per leg is off by {} of the largest contact force, ten by {}, a hundred by {}",
        percent(1.0),
        percent(10.0),
        percent(100.0)
    );
    format!("{sizes}; {}.", verdict(curve))
}

fn verdict(curve: &[[f64; 2]]) -> String {
    let finest = curve
        .iter()
        .fold(0.0, |most: f64, point| most.max(point[0]));
    let seen: Vec<[f64; 2]> = (curve.iter().copied())
        .filter(|point| point[0] >= FIRST && point[0] <= LAST.max(FIRST / finest) * finest)
        .collect();
    let (Some(order), [first, .., last]) = (slope(&seen), &seen[..]) else {
        return "too few histories to tell a limit".into();
    };
    if order >= ORDER {
        return format!(
            "from {} to {} steps the difference falls with order {order:.1}",
            first[0], last[0]
        );
    }
    let all = curve.iter().map(|point| point[1]);
    let (low, high) = all.fold((f64::INFINITY, 0.0_f64), |(low, high), error| {
        (low.min(error), high.max(error))
    });
    format!(
        "no limit found: from 1 to {finest} steps the difference stays between {} % and {} % of the finest history, without an order",
        significant(100.0 * low),
        significant(100.0 * high)
    )
}

/// Order p of e ≈ C n⁻ᵖ by least squares.
fn slope(points: &[[f64; 2]]) -> Option<f64> {
    let count = points.len() as f64;
    let logs = || points.iter().map(|[n, e]| [n.ln(), e.ln()]);
    let mean = |axis: usize| logs().map(|log| log[axis]).sum::<f64>() / count;
    let [x, y] = [mean(0), mean(1)];
    let spread: f64 = logs().map(|log| (log[0] - x).powi(2)).sum();
    let together: f64 = logs().map(|log| (log[0] - x) * (log[1] - y)).sum();
    (points.len() >= 3).then(|| -together / spread)
}

/// Two digits.
fn significant(value: f64) -> String {
    let digits = (1.0 - value.abs().max(f64::MIN_POSITIVE).log10().floor()).clamp(0.0, 12.0);
    format!("{value:.*}", digits as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_order_is_told_from_none() {
        let numbers = [1.0, 10.0, 100.0, 1000.0, 4000.0];
        let falling: Vec<[f64; 2]> = numbers.map(|n| [n, 0.5 / n]).to_vec();
        assert!(
            remark("a", &falling)
                .ends_with("from 10 to 1000 steps the difference falls with order 1.0.")
        );
        let staying: Vec<[f64; 2]> = numbers.map(|n| [n, 0.07 + 0.01 * (n % 3.0)]).to_vec();
        let text = remark("b", &staying);
        assert!(
            text.contains("no limit found: from 1 to 4000 steps"),
            "{text}"
        );
        assert!(text.contains("between 8.0 % and 8.0 %"), "{text}");
        assert!(verdict(&falling[..2]).contains("too few"));
    }
}
