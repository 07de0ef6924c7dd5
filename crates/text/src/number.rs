//! Numbers and counts for a reader.

/// "1 state", "2 states".
pub fn counted(count: usize, one: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {one}{plural}")
}

/// Four significant digits of a number in any unit, without an exponent where the number is of ordinary size.
pub fn short(value: f64) -> String {
    significant(value, 4)
}

/// `digits` significant digits of a number in any unit, for a reader; whole numbers are not cut below 10⁶.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if value < 0.0 {
        return format!("−{}", significant(-value, digits));
    }
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let exponent = scientific
        .split_once('e')
        .and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    match exponent {
        Some(exponent @ -4..=5) => {
            let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
            let text = format!("{value:.decimals$}");
            if text.contains('.') {
                text.trim_end_matches('0').trim_end_matches('.').to_owned()
            } else {
                text
            }
        }
        Some(_) => scientific,
        None => "–".into(),
    }
}

/// A fixed number of decimals of a number in any unit, "–" where there is no value.
pub fn decimals(value: Option<f64>, count: usize) -> String {
    match value {
        Some(value) if value.is_finite() => {
            let scale = 10_f64.powi(count as i32);
            let rounded = (value * scale).round() / scale;
            format!(
                "{}{:.count$}",
                if rounded < 0.0 { "−" } else { "" },
                rounded.abs()
            )
        }
        _ => "–".into(),
    }
}

/// A value in its own unit with at most twelve significant digits, so that a change of units leaves no tail of nines, and without a negative
/// zero; `None` if not finite.
pub fn tidy(value: f64) -> Option<f64> {
    let positive_zero = value + 0.0;
    value.is_finite().then(|| {
        let digits = format!("{positive_zero:.11e}");
        digits.parse().unwrap_or(positive_zero)
    })
}

#[cfg(test)]
mod tests {
    use super::{decimals, short, significant, tidy};

    #[test]
    fn numbers_are_short_and_keep_their_size() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (1240.0, "1240"),
            (123_456.0, "123456"),
            (82.061_2, "82.06"),
            (-0.012_345, "−0.01235"),
            (2e-7, "2.000e-7"),
            (1.5e9, "1.500e9"),
            (f64::NAN, "–"),
            (f64::INFINITY, "–"),
        ];
        for (value, text) in cases {
            assert_eq!(short(value), text);
        }
        assert_eq!(significant(9.999_99, 3), "10");
    }

    #[test]
    fn rounding_leaves_no_negative_zero_and_no_tail() {
        assert_eq!(decimals(Some(-0.04), 1), "0.0");
        assert_eq!(decimals(Some(-0.06), 1), "−0.1");
        assert_eq!(decimals(None, 1), "–");
        assert_eq!(tidy(79.999_999_999_999_99), Some(80.0));
        assert_eq!(tidy(-0.0).map(f64::is_sign_negative), Some(false));
        assert_eq!(tidy(f64::NAN), None);
    }
}
