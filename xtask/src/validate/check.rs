//! One line of the validation table: a quantity, what it should be, what it is, and whether that will do.

use stickslip::results::Results;

use super::laboratory::Worst;

/// Whether a check was met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// Within the bound.
    Pass,
    /// Outside the bound.
    Fail,
    /// Without a bound; shown for information.
    Shown,
}

impl Verdict {
    fn of(met: bool) -> Self {
        if met { Self::Pass } else { Self::Fail }
    }

    /// As the table shows it.
    pub(crate) fn text(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Fail => "FAIL",
            Self::Shown => "shown",
        }
    }
}

/// A compared quantity, formatted.
#[derive(Clone, Debug)]
pub(crate) struct Check {
    pub(crate) quantity: String,
    pub(crate) reference: String,
    pub(crate) source: String,
    pub(crate) computed: String,
    pub(crate) error: String,
    pub(crate) bound: String,
    pub(crate) verdict: Verdict,
    /// Whether it is about a physical quantity, not about how a solver got there.
    pub(crate) physical: bool,
}

/// How far a number may be from its reference.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Tolerance {
    /// Fraction of the reference, and the unit of both numbers.
    Relative(f64, &'static str),
    /// In the unit of both numbers.
    Absolute(f64, &'static str),
}

/// The checks of a case, in the order of the table.
#[derive(Debug, Default)]
pub(crate) struct Checks {
    list: Vec<Check>,
    source: String,
}

impl Checks {
    /// No checks yet; references come from `source`.
    pub(crate) fn against(source: &str) -> Self {
        Self {
            list: Vec::new(),
            source: source.to_owned(),
        }
    }

    /// References of further checks come from `source`.
    pub(crate) fn now_against(&mut self, source: &str) {
        source.clone_into(&mut self.source);
    }

    /// The checks.
    pub(crate) fn into_list(self) -> Vec<Check> {
        self.list
    }

    /// What is computed is close enough to the reference.
    pub(crate) fn near(
        &mut self,
        quantity: impl Into<String>,
        [computed, reference]: [f64; 2],
        tolerance: Tolerance,
    ) {
        let difference = computed - reference;
        let (Tolerance::Relative(_, unit) | Tolerance::Absolute(_, unit)) = tolerance;
        let (error, bound, met) = match tolerance {
            Tolerance::Relative(limit, _) => {
                let relative = difference / reference;
                let met = relative.abs() <= limit;
                (signed_percent(relative), percent(limit), met)
            }
            Tolerance::Absolute(limit, _) => (
                format!("{}{unit}", signed(difference)),
                format!("{}{unit}", number(limit)),
                difference.abs() <= limit,
            ),
        };
        let [reference, computed] =
            [reference, computed].map(|own| format!("{}{unit}", number(own)));
        self.push(
            quantity.into(),
            reference,
            computed,
            error,
            bound,
            Verdict::of(met),
        );
    }

    /// The same where it `is_bounded`, else both numbers to look at.
    pub(crate) fn near_if(
        &mut self,
        is_bounded: bool,
        quantity: impl Into<String>,
        pair: [f64; 2],
        tolerance: Tolerance,
    ) {
        self.near(quantity, pair, tolerance);
        if !is_bounded {
            self.only_show();
        }
    }

    /// A run has all of its load steps.
    pub(crate) fn converges(&mut self, what: &str, results: &Results, steps: usize) {
        let found = results.steps.len();
        let quantity = format!("{what}: load steps that converge");
        self.completes(
            quantity,
            steps.to_string(),
            found.to_string(),
            found == steps,
        );
    }

    /// Takes the bound off the last check.
    fn only_show(&mut self) {
        if let Some(check) = self.list.last_mut() {
            check.error.clear();
            check.bound.clear();
            check.verdict = Verdict::Shown;
        }
    }

    /// The `worst` error, a fraction, is below `limit`.
    pub(crate) fn error_below(
        &mut self,
        quantity: impl Into<String>,
        worst: impl Into<Worst>,
        limit: f64,
    ) {
        let Worst { value, place } = worst.into();
        let (error, bound) = (percent(value), percent(limit));
        let verdict = Verdict::of(value <= limit);
        self.push(quantity.into(), String::new(), place, error, bound, verdict);
    }

    /// The `worst` value, zero up to rounding, is below `limit`.
    pub(crate) fn rounding_below(
        &mut self,
        quantity: impl Into<String>,
        worst: impl Into<Worst>,
        limit: f64,
    ) {
        let Worst { value, place } = worst.into();
        let (error, bound) = (format!("{value:.1e}"), format!("{limit:.0e}"));
        let verdict = Verdict::of(value <= limit);
        self.push(quantity.into(), "0".into(), place, error, bound, verdict);
    }

    /// `computed`, as text, is as `reference` demands.
    pub(crate) fn holds(
        &mut self,
        quantity: impl Into<String>,
        reference: impl Into<String>,
        computed: impl Into<String>,
        met: bool,
    ) {
        let (reference, computed) = (reference.into(), computed.into());
        let (error, bound) = (String::new(), "as stated".into());
        self.push(
            quantity.into(),
            reference,
            computed,
            error,
            bound,
            Verdict::of(met),
        );
    }

    /// `computed`, something that a solver did, is as `reference` demands. Says nothing about a physical quantity.
    pub(crate) fn completes(
        &mut self,
        quantity: impl Into<String>,
        reference: impl Into<String>,
        computed: impl Into<String>,
        met: bool,
    ) {
        self.holds(quantity, reference, computed, met);
        if let Some(check) = self.list.last_mut() {
            check.physical = false;
        }
    }

    /// A quantity beside its reference, without a bound.
    pub(crate) fn show(
        &mut self,
        quantity: impl Into<String>,
        reference: impl Into<String>,
        computed: impl Into<String>,
    ) {
        self.holds(quantity, reference, computed, true);
        self.only_show();
    }

    fn push(
        &mut self,
        quantity: String,
        reference: String,
        computed: String,
        error: String,
        bound: String,
        verdict: Verdict,
    ) {
        self.list.push(Check {
            quantity,
            reference,
            source: self.source.clone(),
            computed,
            error,
            bound,
            verdict,
            physical: true,
        });
    }
}

/// Six significant digits, without trailing zeros.
pub(crate) fn number(value: f64) -> String {
    let magnitude = value.abs();
    if value == 0.0 {
        return "0".into();
    }
    if !(1e-3..1e7).contains(&magnitude) {
        return format!("{value:.5e}");
    }
    let text = format!("{value:.*}", decimals(value, 6));
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// A fraction in percent, two significant digits.
pub(crate) fn percent(fraction: f64) -> String {
    let value = 100.0 * fraction;
    format!("{value:.*} %", decimals(value, 2))
}

fn signed(value: f64) -> String {
    format!("{value:+.*}", decimals(value, 2))
}

fn signed_percent(fraction: f64) -> String {
    let value = 100.0 * fraction;
    format!("{value:+.*} %", decimals(value, 2))
}

/// Decimals that show `digits` significant digits, at most 7.
fn decimals(value: f64, digits: i32) -> usize {
    if value == 0.0 || !value.is_finite() {
        return 0;
    }
    // The exponent of a finite number is small.
    let exponent = value.abs().log10().floor() as i32;
    (digits - 1 - exponent).clamp(0, 7) as usize
}

#[cfg(test)]
mod tests {
    use super::Tolerance::{Absolute, Relative};
    use super::*;

    #[test]
    fn numbers_have_their_digits() {
        let texts = [31501.0, 0.880936481, -1500.5, 3.52965e-4, 0.0].map(number);
        assert_eq!(texts, ["31501", "0.880936", "-1500.5", "3.52965e-4", "0"]);
        assert_eq!(percent(1e-3), "0.10 %");
        assert_eq!(signed_percent(-0.000_064_2), "-0.0064 %");
    }

    #[test]
    fn a_number_that_is_none_fails() {
        let mut checks = Checks::default();
        checks.near("", [f64::NAN, 1.0], Relative(1.0, ""));
        checks.error_below("", ("", f64::NAN), 1.0);
        checks.rounding_below("", ("", f64::NAN), 1.0);
        checks.near("", [1.1, 1.0], Absolute(0.05, ""));
        let list = checks.into_list();
        assert!(list.iter().all(|check| check.verdict == Verdict::Fail));
    }
}
