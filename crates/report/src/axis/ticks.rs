//! Ticks at round values and their labels.
//!
//! Linear axes step by 1, 2 or 5 times a power of ten. Where labels would have many
//! zeros, a common factor 10³ᵏ is taken out and written once at the axis's end.
//! Log axes label decades, short ones also 2 and 5.

use super::{Axis, Scale, Span};
use crate::error::FigureError;
use crate::text;

/// Ticks that a user's spacing may ask for.
const MOST_TICKS: usize = 200;

/// The ticks of one axis, in rising order.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Ticks {
    pub(crate) major: Vec<Tick>,
    /// Values of ticks without a label.
    pub(crate) minor: Vec<f64>,
    /// The factor that every label is to be multiplied with, as `×10⁻³`.
    pub(crate) factor: Option<String>,
}

/// A labelled tick.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    pub(crate) value: f64,
    /// Empty where a label would not fit.
    pub(crate) label: String,
}

impl Ticks {
    /// Ticks for `span`: as the axis asks, otherwise about `wanted` of them.
    pub(crate) fn new(axis: &Axis, span: &Span, wanted: usize) -> Result<Self, FigureError> {
        if let Some(spacing) = axis.tick_spacing {
            let count = span.length() / spacing;
            if spacing.is_nan() || spacing <= 0.0 || count > MOST_TICKS as f64 {
                return Err(FigureError::TickSpacing {
                    axis: axis.label.clone(),
                    spacing,
                    low: span.low,
                    high: span.high,
                    limit: MOST_TICKS,
                });
            }
        }
        Ok(match axis.scale {
            Scale::Linear => {
                let rough = span.length() / wanted.max(1) as f64;
                linear(span, axis.tick_spacing.unwrap_or_else(|| round_step(rough)))
            }
            Scale::Log => logarithmic(span, axis.tick_spacing, wanted),
        })
    }

    /// Width of the widest label, the factor apart \[px\].
    pub(crate) fn widest(&self, size: f64) -> f64 {
        text::widest(self.major.iter().map(|tick| tick.label.as_str()), size)
    }

    /// Empties labels so that those left are `count` or fewer and evenly spaced.
    pub(crate) fn thin_labels(&mut self, count: usize) {
        let stride = self.major.len().div_ceil(count.max(1)).max(1);
        for (index, tick) in self.major.iter_mut().enumerate() {
            if index % stride != 0 {
                tick.label.clear();
            }
        }
    }
}

/// The smallest of 1, 2, 5 × 10ᵏ that is not below `rough` (> 0).
fn round_step(rough: f64) -> f64 {
    let decade = 10_f64.powf(rough.log10().floor());
    [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|digit| digit * decade)
        .find(|step| *step >= rough * (1.0 - 1e-9))
        .unwrap_or(10.0 * decade)
}

fn linear(span: &Span, step: f64) -> Ticks {
    let exponent = common_exponent(span);
    let unit = 10_f64.powi(exponent);
    let decimals = decimals_of(step / unit);
    let values = multiples(span, step);
    let major = values
        .iter()
        .map(|&value| Tick {
            value,
            label: fixed(value / unit, decimals),
        })
        .collect();
    let factor = (exponent != 0).then(|| format!("×10{}", superscript(exponent)));
    Ticks {
        major,
        minor: Vec::new(),
        factor,
    }
}

/// The multiples of `step` on the axis, zero exactly zero.
fn multiples(span: &Span, step: f64) -> Vec<f64> {
    let slack = 1e-9;
    let first = (span.low / step - slack).ceil();
    let last = (span.high / step + slack).floor();
    let count = ((last - first).max(-1.0) + 1.0) as usize;
    (0..count.min(MOST_TICKS + 1))
        .map(|k| (first + k as f64) * step + 0.0)
        .collect()
}

/// The multiple of three that labels are relieved of; 0 where they are short anyway.
fn common_exponent(span: &Span) -> i32 {
    let magnitude = span.low.abs().max(span.high.abs());
    let exponent = magnitude.log10().floor() as i32;
    if (-2..5).contains(&exponent) {
        0
    } else {
        3 * exponent.div_euclid(3)
    }
}

/// Decimals needed to write multiples of `step` exactly, at most 9.
fn decimals_of(step: f64) -> usize {
    (0..9)
        .find(|&decimals| {
            let scaled = step * 10_f64.powi(decimals);
            scaled >= 0.5 && (scaled - scaled.round()).abs() < 1e-6 * scaled
        })
        .unwrap_or(9) as usize
}

/// `value` with `decimals`, a true minus sign, and no sign on zero.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().all(|c| matches!(c, '0' | '.')) => digits.to_owned(),
        Some(digits) => format!("−{digits}"),
        None => text,
    }
}

/// `value` with `digits` significant digits, as `1.23×10⁻⁵` where that is shorter.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.abs().to_string();
    }
    // The rounded number decides: 9.999 with three digits is 10.0.
    let written = format!("{value:.*e}", digits.saturating_sub(1));
    let (mantissa, exponent) = written.split_once('e').unwrap_or((&written, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-3..6).contains(&exponent) {
        fixed(value, (digits as i32 - 1 - exponent).max(0) as usize)
    } else {
        format!("{}×10{}", mantissa.replace('-', "−"), superscript(exponent))
    }
}

/// Decades, with 2 and 5 between them where `wanted` allows, or linear ticks on an
/// axis too short for either.
fn logarithmic(span: &Span, spacing: Option<f64>, wanted: usize) -> Ticks {
    let decades = span.length();
    if spacing.is_none() && decades < 0.7 {
        let step = round_step((span.high - span.low) / wanted.max(1) as f64);
        return linear(
            &Span {
                scale: Scale::Linear,
                ..*span
            },
            step,
        );
    }
    let automatic = (decades / wanted.max(1) as f64).ceil();
    let stride = spacing.unwrap_or(automatic).round().max(1.0) as i32;
    let with_parts = spacing.is_none() && decades * 3.0 <= wanted as f64 + 1.0;
    let (first, last) = (
        span.low.log10().floor() as i32,
        span.high.log10().floor() as i32,
    );
    let plain = span.low.log10().ceil() >= -3.0 && last <= 3;
    let mut ticks = Ticks::default();
    for exponent in first..=last {
        for digit in 1..10 {
            // Parsed rather than multiplied, so that 10⁻³ is the f64 next to it.
            let value: f64 = format!("{digit}e{exponent}").parse().unwrap_or(f64::NAN);
            if !span.contains(value) {
                continue;
            }
            let labelled = if digit == 1 {
                exponent.rem_euclid(stride) == 0
            } else {
                with_parts && matches!(digit, 2 | 5)
            };
            if labelled {
                ticks.major.push(Tick {
                    value,
                    label: power_label(digit, exponent, plain),
                });
            } else if stride == 1 || digit == 1 {
                ticks.minor.push(value);
            }
        }
    }
    ticks
}

fn power_label(digit: i32, exponent: i32, plain: bool) -> String {
    if plain {
        return fixed(
            f64::from(digit) * 10_f64.powi(exponent),
            (-exponent).max(0) as usize,
        );
    }
    let power = format!("10{}", superscript(exponent));
    if digit == 1 {
        power
    } else {
        format!("{digit}×{power}")
    }
}

/// `exponent` in superscript digits.
pub(crate) fn superscript(exponent: i32) -> String {
    exponent
        .to_string()
        .chars()
        .map(|character| match character {
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            '4' => '⁴',
            '5' => '⁵',
            '6' => '⁶',
            '7' => '⁷',
            '8' => '⁸',
            '9' => '⁹',
            '-' => '⁻',
            _ => '⁰',
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::axis::Padding;

    fn labels(axis: &Axis, wanted: usize) -> (Vec<String>, Option<String>) {
        let span = axis.span(std::iter::empty(), Padding::Tight).unwrap();
        let ticks = Ticks::new(axis, &span, wanted).unwrap();
        (
            ticks.major.into_iter().map(|tick| tick.label).collect(),
            ticks.factor,
        )
    }

    #[test]
    fn linear_labels_are_round_and_use_a_true_minus() {
        let (texts, factor) = labels(&Axis::linear("x").between(-1.0, 1.0), 5);
        assert_eq!(texts, ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
        assert_eq!(factor, None);
        let (texts, _) = labels(&Axis::linear("θ").between(0.0, 90.0).every(22.5), 5);
        assert_eq!(texts, ["0.0", "22.5", "45.0", "67.5", "90.0"]);
    }

    #[test]
    fn small_and_large_values_share_a_power_of_a_thousand() {
        let (texts, factor) = labels(&Axis::linear("slip").between(0.0, 4e-5), 4);
        assert_eq!(
            (texts[1].as_str(), factor.as_deref()),
            ("10", Some("×10⁻⁶"))
        );
        let (texts, factor) = labels(&Axis::linear("E").between(0.0, 2e11), 4);
        assert_eq!((texts[1].as_str(), factor.as_deref()), ("50", Some("×10⁹")));
    }

    #[test]
    fn log_labels_are_powers_or_plain_where_short() {
        let (texts, _) = labels(&Axis::log("e").between(1e-7, 1e-1), 8);
        assert_eq!(texts.first().map(String::as_str), Some("10⁻⁷"));
        assert_eq!(texts.len(), 7);
        let (texts, _) = labels(&Axis::log("h").between(0.01, 1.0), 8);
        assert_eq!(texts, ["0.01", "0.02", "0.05", "0.1", "0.2", "0.5", "1"]);
        let (texts, _) = labels(&Axis::log("h").between(1e-30, 1e30), 6);
        assert_eq!(texts.len(), 7);
        let (texts, _) = labels(&Axis::log("h").between(2.1, 2.9), 4);
        assert!(texts.len() >= 3, "{texts:?}");
    }

    #[test]
    fn a_spacing_that_cannot_be_drawn_is_refused() {
        for spacing in [0.0, -1.0, f64::NAN, 1e-9] {
            let axis = Axis::linear("x").between(0.0, 1.0).every(spacing);
            let span = axis.span(std::iter::empty(), Padding::Tight).unwrap();
            let error = Ticks::new(&axis, &span, 5).unwrap_err();
            assert!(matches!(
                error,
                FigureError::TickSpacing {
                    limit: MOST_TICKS,
                    ..
                }
            ));
        }
    }

    #[test]
    fn extreme_ranges_give_bounded_ticks() {
        for (low, high) in [(1e-300, 1e300), (5e-324, 1e-323), (1e307, 1.7e308)] {
            for axis in [Axis::linear("x"), Axis::log("x")] {
                let axis = axis.between(low, high);
                let span = axis.span(std::iter::empty(), Padding::Tight).unwrap();
                let ticks = Ticks::new(&axis, &span, 6).unwrap();
                assert!(ticks.major.len() <= MOST_TICKS + 1, "{low} {high}");
            }
        }
    }

    #[test]
    fn significant_digits_survive_rounding_up() {
        assert_eq!(significant(9.9996, 4), "10.00");
        assert_eq!(significant(-412.34, 4), "−412.3");
        assert_eq!(significant(1.234e-7, 3), "1.23×10⁻⁷");
        assert_eq!(significant(0.0, 4), "0");
    }
}
