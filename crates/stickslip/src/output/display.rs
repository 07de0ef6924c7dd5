//! Results as a reader wants them: places in degrees or lengths, stresses and loads in the scene's units, short numbers.

use crate::results::{EdgeGeometry, EdgeKind, EdgeResults, Results};
use crate::scene::schema::DisplayUnits;

/// Resultant of balanced pressures relative to their sum: rounding of a sum of some thousand terms, with a margin.
const ROUNDING: f64 = 1e-9;

/// An edge with its results of all steps, in display units.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeView<'a> {
    pub(super) geometry: &'a EdgeGeometry,
    results: &'a Results,
    index: usize,
}

impl<'a> EdgeView<'a> {
    /// All edges in their order. The results are consistent: every step has every edge.
    pub(super) fn all(results: &'a Results) -> Vec<Self> {
        let view = |(index, geometry)| Self {
            geometry,
            results,
            index,
        };
        results.edges.iter().enumerate().map(view).collect()
    }

    /// The edge that tables show: the first contact edge, or the first edge without contact.
    pub(super) fn main(results: &'a Results) -> Option<Self> {
        let edges = Self::all(results);
        edges
            .iter()
            .find(|edge| edge.geometry.contact)
            .or(edges.first())
            .copied()
    }

    pub(super) fn step(&self, step: usize) -> &'a EdgeResults {
        &self.results.steps[step].edges[self.index]
    }

    pub(super) fn results(&self) -> &'a Results {
        self.results
    }

    pub(super) fn units(&self) -> DisplayUnits {
        self.results.units
    }

    pub(super) fn is_circle(&self) -> bool {
        matches!(self.geometry.kind, EdgeKind::Circle { .. })
    }

    /// A place or an extent along the edge `[rad or mm]`, in degrees or the display unit.
    pub(super) fn place(&self, parameter: f64) -> f64 {
        if self.is_circle() {
            parameter.to_degrees()
        } else {
            self.units().length.from_base(parameter)
        }
    }

    /// "deg" or the unit of lengths.
    pub(super) fn place_unit(&self) -> &'static str {
        if self.is_circle() {
            "deg"
        } else {
            self.units().length.name
        }
    }

    /// "θ" or "x".
    pub(super) fn place_symbol(&self) -> &'static str {
        if self.is_circle() { "θ" } else { "x" }
    }

    /// "at θ = 12.3°" or "at x = 1.23 mm".
    pub(super) fn at(&self, parameter: f64) -> String {
        format!("{} = {}", self.place_symbol(), self.extent(parameter))
    }

    /// "12.3°" or "1.23 mm".
    pub(super) fn extent(&self, parameter: f64) -> String {
        let value = short(self.place(parameter));
        if self.is_circle() {
            format!("{value}°")
        } else {
            format!("{value} {}", self.place_unit())
        }
    }

    /// A stress `[MPa]` in the display unit.
    pub(super) fn stress(&self, stress: f64) -> f64 {
        self.units().stress.from_base(stress)
    }

    /// Bearing stress `[MPa]` in a step; `None` where the pressures balance each other, as around an unloaded pin with interference.
    pub(super) fn bearing(&self, step: usize) -> Option<f64> {
        let edge = self.step(step);
        let [x, y] = edge.resultant;
        let balanced = x.hypot(y) <= ROUNDING * edge.normal_force;
        edge.bearing_stress(self.geometry).filter(|_| !balanced)
    }

    /// Whether any step has a bearing stress; a press fit without a pull has none.
    pub(super) fn bears(&self) -> bool {
        (0..self.results().steps.len()).any(|step| self.bearing(step).is_some())
    }

    /// Names of the normal, the tangential and the shear stress.
    pub(super) fn stress_symbols(&self) -> [&'static str; 3] {
        if self.is_circle() {
            ["σ_r", "σ_θ", "τ_rθ"]
        } else {
            ["σ_yy", "σ_xx", "τ_xy"]
        }
    }

    /// Friction over pressure, ∫q dA / ∫p dA; `None` without pressure.
    pub(super) fn friction_ratio(&self, step: usize) -> Option<f64> {
        let edge = self.step(step);
        (edge.normal_force > 0.0).then(|| edge.friction_force / edge.normal_force)
    }

    /// What [`Self::friction_ratio`] is called.
    pub(super) fn friction_symbol(&self) -> &'static str {
        if self.is_circle() {
            "∫q dA / ∫p dA"
        } else {
            "Q/N"
        }
    }

    /// Total length of the zones of a kind `[rad or mm]`; `None` without contact.
    pub(super) fn zone_extent(&self, step: usize, kind: impl Fn(f64) -> bool) -> Option<f64> {
        let edge = self.step(step);
        edge.contact_half_extent?;
        let touching = edge.zones.iter().filter(|zone| zone.status.touches());
        Some(
            touching
                .filter(|zone| kind(zone.status.slip_sign()))
                .map(|zone| zone.end - zone.start)
                .sum(),
        )
    }

    /// Largest half of the contact's extent over all steps `[rad or mm]`.
    pub(super) fn widest_contact(&self) -> Option<f64> {
        let steps = 0..self.results.steps.len();
        steps
            .filter_map(|step| self.step(step).contact_half_extent)
            .reduce(f64::max)
    }
}

/// "1 state", "2 states".
pub(crate) fn counted(count: usize, one: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {one}{plural}")
}

/// Four significant digits, without an exponent where the number is of ordinary size.
pub(crate) fn short(value: f64) -> String {
    significant(value, 4)
}

/// `digits` significant digits for a reader; whole numbers are not cut below 10⁶.
pub(crate) fn significant(value: f64, digits: usize) -> String {
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

/// A fixed number of decimals, "–" where there is no value.
pub(super) fn decimals(value: Option<f64>, count: usize) -> String {
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

/// A value with at most twelve significant digits, so that a change of units leaves no tail of nines, and without a negative
/// zero; `None` if not finite.
pub(super) fn tidy(value: f64) -> Option<f64> {
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
