//! Axes: what a figure says about x or y, and where a value lies on it.
//!
//! ```text
//! linear   s(v) = (v − low) / (high − low)
//! log      s(v) = (log₁₀ v − log₁₀ low) / (log₁₀ high − log₁₀ low)
//! ```
//!
//! s is 0 at the low end and 1 at the high end. A value without a place (NaN,
//! infinite, or not positive on a log axis) interrupts a line.

pub(crate) mod ticks;

use crate::error::FigureError;

/// Largest ratio of a linear axis's magnitude to its length that f64 resolves.
const RESOLUTION: f64 = 1e-12;
/// Part of the data's length that is left free at both ends of an axis.
const PADDING: f64 = 0.05;

/// How values are laid out along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps for equal differences.
    Linear,
    /// Equal steps for equal ratios, base 10.
    Log,
}

impl Scale {
    fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Log => "log",
        }
    }
}

/// One axis of a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Name, symbol and unit: `Contact pressure CPRESS [MPa]`.
    pub label: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// Distance of the labelled ticks in the axis's unit, on a log axis in decades;
    /// chosen from the data if not given.
    pub tick_spacing: Option<f64>,
    /// Low and high end in the axis's unit; chosen from the data if not given.
    pub range: Option<[f64; 2]>,
}

impl Axis {
    /// Makes a linear axis that fits its data.
    pub fn linear(label: impl Into<String>) -> Self {
        Self {
            label: label.into(),
            scale: Scale::Linear,
            tick_spacing: None,
            range: None,
        }
    }

    /// Makes a logarithmic axis that fits its data.
    pub fn log(label: impl Into<String>) -> Self {
        Self {
            scale: Scale::Log,
            ..Self::linear(label)
        }
    }

    /// Labels a tick every `spacing` in the axis's unit (on a log axis: decades).
    #[must_use]
    pub fn every(mut self, spacing: f64) -> Self {
        self.tick_spacing = Some(spacing);
        self
    }

    /// Sets the ends of the axis, in its unit.
    #[must_use]
    pub fn between(mut self, low: f64, high: f64) -> Self {
        self.range = Some([low, high]);
        self
    }

    /// The axis's ends for the data in `values`, which `padding` widens.
    pub(crate) fn span(
        &self,
        values: impl Iterator<Item = f64>,
        padding: Padding,
    ) -> Result<Span, FigureError> {
        let [low, high] = match self.range {
            Some(range) => range,
            None => self.fitted(values, padding)?,
        };
        let positive = self.scale == Scale::Linear || low > 0.0;
        let span = Span {
            scale: self.scale,
            low,
            high,
        };
        let resolved = span.length() > RESOLUTION * span.magnitude();
        if low.is_finite() && high.is_finite() && positive && resolved && span.length().is_finite()
        {
            Ok(span)
        } else {
            let axis = self.label.clone();
            Err(FigureError::Range {
                axis,
                low,
                high,
                scale: self.scale.name(),
            })
        }
    }

    fn fitted(
        &self,
        values: impl Iterator<Item = f64>,
        padding: Padding,
    ) -> Result<[f64; 2], FigureError> {
        let drawable =
            |value: &f64| value.is_finite() && (self.scale == Scale::Linear || *value > 0.0);
        let [low, high] = ends(values.filter(drawable));
        if low > high {
            return Err(FigureError::NoData {
                axis: self.label.clone(),
            });
        }
        Ok(match self.scale {
            Scale::Linear => padded_linear(low, high, padding),
            Scale::Log => padded_log(low, high, padding),
        })
    }
}

/// How much room an axis leaves beyond its data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Padding {
    /// None: curves run from edge to edge.
    Tight,
    /// A little at both ends, none below zero for values that start there.
    Loose,
}

fn padded_linear(low: f64, high: f64, padding: Padding) -> [f64; 2] {
    let magnitude = low.abs().max(high.abs());
    // Differences in the last digits are rounding, not a curve.
    if high - low <= 1e-9 * magnitude || high == low {
        let half = if magnitude > 0.0 {
            0.1 * magnitude
        } else {
            1.0
        };
        return [low - half, high + half];
    }
    match padding {
        Padding::Tight => [low, high],
        Padding::Loose => {
            let room = PADDING * (high - low);
            let below = if low == 0.0 { 0.0 } else { room };
            let above = if high == 0.0 { 0.0 } else { room };
            [low - below, high + above]
        }
    }
}

fn padded_log(low: f64, high: f64, padding: Padding) -> [f64; 2] {
    let ratio = high / low;
    if ratio <= 1.0 + 1e-9 {
        return [low / 2.0, high * 2.0];
    }
    match padding {
        Padding::Tight => [low, high],
        Padding::Loose => [low / ratio.powf(PADDING), high * ratio.powf(PADDING)],
    }
}

/// The least and the largest of `values`, in their unit; of none, +∞ and −∞.
pub fn ends(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let values = values.into_iter();
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    })
}

/// The ends of `points` along x and along y, `[x_low, x_high, y_low, y_high]`, in the units of the points.
pub fn extent(points: impl IntoIterator<Item = [f64; 2]>) -> [f64; 4] {
    let [low, high] = ends([]);
    points.into_iter().fold(
        [low, high, low, high],
        |[left, right, bottom, top], [x, y]| [left.min(x), right.max(x), bottom.min(y), top.max(y)],
    )
}

/// An axis's ends, checked: finite, low < high, positive where logarithmic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Span {
    pub(crate) scale: Scale,
    pub(crate) low: f64,
    pub(crate) high: f64,
}

impl Span {
    /// The place of `value`, 0 at the low and 1 at the high end.
    pub(crate) fn fraction(&self, value: f64) -> Option<f64> {
        let coordinate = self.coordinate(value);
        coordinate
            .is_finite()
            .then(|| (coordinate - self.coordinate(self.low)) / self.length())
    }

    pub(crate) fn contains(&self, value: f64) -> bool {
        value >= self.low && value <= self.high
    }

    fn coordinate(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => value,
            Scale::Log => value.log10(),
        }
    }

    fn length(&self) -> f64 {
        self.coordinate(self.high) - self.coordinate(self.low)
    }

    fn magnitude(&self) -> f64 {
        self.coordinate(self.low)
            .abs()
            .max(self.coordinate(self.high).abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fit(axis: &Axis, values: &[f64]) -> Result<Span, FigureError> {
        axis.span(values.iter().copied(), Padding::Loose)
    }

    #[test]
    fn a_fitted_axis_leaves_room_except_at_zero() {
        let span = fit(&Axis::linear("p"), &[0.0, 10.0, f64::NAN, f64::INFINITY]).unwrap();
        assert_eq!([span.low, span.high], [0.0, 10.5]);
        let span = fit(&Axis::linear("p"), &[-10.0, 10.0]).unwrap();
        assert_eq!([span.low, span.high], [-11.0, 11.0]);
    }

    #[test]
    fn a_constant_is_shown_in_the_middle() {
        for value in [0.0, 3.0, -1e300, 1e-300] {
            let span = fit(&Axis::linear("p"), &[value]).unwrap();
            assert!((span.fraction(value).unwrap() - 0.5).abs() < 1e-9);
        }
        let span = fit(&Axis::log("p"), &[3.0]).unwrap();
        assert!((span.fraction(3.0).unwrap() - 0.5).abs() < 1e-9);
    }

    #[test]
    fn values_without_a_place_are_left_out() {
        let span = fit(&Axis::log("h"), &[1.0, 100.0, 0.0, -5.0]).unwrap();
        assert!(span.low > 0.5);
        assert_eq!([span.fraction(0.0), span.fraction(-1.0)], [None, None]);
        assert_eq!(span.fraction(f64::NAN), None);
    }

    #[test]
    fn bad_ranges_are_refused_with_their_numbers() {
        for (low, high) in [
            (1.0, 1.0),
            (2.0, 1.0),
            (f64::NAN, 1.0),
            (0.0, f64::INFINITY),
        ] {
            let error = fit(&Axis::linear("x").between(low, high), &[]).unwrap_err();
            assert!(matches!(error, FigureError::Range { .. }), "{error}");
        }
        assert!(fit(&Axis::linear("x").between(-f64::MAX, f64::MAX), &[]).is_err());
        assert!(fit(&Axis::log("x").between(0.0, 1.0), &[]).is_err());
        let error = fit(&Axis::linear("gap"), &[f64::NAN]).unwrap_err();
        assert_eq!(
            error,
            FigureError::NoData {
                axis: "gap".to_owned()
            }
        );
    }
}
