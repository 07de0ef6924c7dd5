//! Why the parameters of a law are refused.

use std::fmt;

use thiserror::Error;

/// Parameters that no friction law can be made of. Messages name the law and the parameter as a file does.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FrictionError {
    /// A number lies outside its range, or is not a finite number.
    #[error("friction law '{law}': {parameter} = {value} is outside {allowed}")]
    OutOfRange {
        /// Name of the law.
        law: &'static str,
        /// Name of the parameter; `plies[2].fraction` is that of the third ply.
        parameter: String,
        /// The number given, in the unit of the parameter.
        value: f64,
        /// The numbers allowed.
        allowed: Interval,
    },
    /// The coefficient during slip exceeds the one before it, and this is not declared as intended.
    #[error(
        "friction law '{law}': dynamic = {dynamic_coefficient} is greater than static = {static_coefficient}; \
         if slip is meant to strengthen the contact, say allow_strengthening = true"
    )]
    Strengthening {
        /// Name of the law.
        law: &'static str,
        /// Static coefficient given, dimensionless.
        static_coefficient: f64,
        /// Dynamic coefficient given, dimensionless.
        dynamic_coefficient: f64,
    },
    /// A lay-up without plies.
    #[error("friction law '{law}': plies is empty")]
    NoPlies {
        /// Name of the law.
        law: &'static str,
    },
    /// The thickness fractions do not make up the laminate.
    #[error(
        "friction law '{law}': the fractions of the {plies} plies sum to {sum}, not to 1 within {tolerance:e}"
    )]
    FractionSum {
        /// Name of the law.
        law: &'static str,
        /// Number of plies given.
        plies: usize,
        /// Sum of their fractions, dimensionless.
        sum: f64,
        /// Largest accepted distance of the sum from 1, dimensionless.
        tolerance: f64,
    },
}

/// A range of real numbers. An infinite end is never included, so infinity is always outside, and so is NaN.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    lower: f64,
    lower_included: bool,
    upper: f64,
    upper_included: bool,
}

impl Interval {
    /// `[0, ∞)`
    pub const NON_NEGATIVE: Self = Self {
        lower: 0.0,
        lower_included: true,
        upper: f64::INFINITY,
        upper_included: false,
    };
    /// `(0, ∞)`
    pub const POSITIVE: Self = Self {
        lower_included: false,
        ..Self::NON_NEGATIVE
    };
    /// `(−∞, ∞)`
    pub const FINITE: Self = Self {
        lower: f64::NEG_INFINITY,
        ..Self::POSITIVE
    };

    /// `[lower, upper]`, in the unit of the parameter.
    pub const fn closed(lower: f64, upper: f64) -> Self {
        Self {
            lower,
            lower_included: lower != f64::NEG_INFINITY,
            upper,
            upper_included: upper != f64::INFINITY,
        }
    }

    /// `(lower, upper]`, in the unit of the parameter.
    pub const fn open_closed(lower: f64, upper: f64) -> Self {
        Self {
            lower_included: false,
            ..Self::closed(lower, upper)
        }
    }

    /// Whether `value`, in the unit of the range, is a finite number of this range.
    pub fn contains(self, value: f64) -> bool {
        (value > self.lower || self.lower_included && value == self.lower)
            && (value < self.upper || self.upper_included && value == self.upper)
    }

    /// Hands `value`, in any unit, back if this range contains it.
    ///
    /// # Errors
    /// [`FrictionError::OutOfRange`] with the names given.
    pub fn check(
        self,
        law: &'static str,
        parameter: &str,
        value: f64,
    ) -> Result<f64, FrictionError> {
        if self.contains(value) {
            Ok(value)
        } else {
            Err(FrictionError::OutOfRange {
                law,
                parameter: parameter.to_owned(),
                value,
                allowed: self,
            })
        }
    }
}

impl fmt::Display for Interval {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(if self.lower_included { "[" } else { "(" })?;
        write_end(formatter, self.lower)?;
        formatter.write_str(", ")?;
        write_end(formatter, self.upper)?;
        formatter.write_str(if self.upper_included { "]" } else { ")" })
    }
}

fn write_end(formatter: &mut fmt::Formatter<'_>, end: f64) -> fmt::Result {
    if end == f64::INFINITY {
        formatter.write_str("∞")
    } else if end == f64::NEG_INFINITY {
        formatter.write_str("−∞")
    } else {
        write!(formatter, "{end}")
    }
}

/// Refuses coefficients that are negative or not finite, and `dynamic > static` unless it is allowed.
pub(crate) fn check_coefficients(
    law: &'static str,
    [static_coefficient, dynamic_coefficient]: [f64; 2],
    allowed: bool,
) -> Result<(), FrictionError> {
    Interval::NON_NEGATIVE.check(law, "static", static_coefficient)?;
    Interval::NON_NEGATIVE.check(law, "dynamic", dynamic_coefficient)?;
    if dynamic_coefficient > static_coefficient && !allowed {
        return Err(FrictionError::Strengthening {
            law,
            static_coefficient,
            dynamic_coefficient,
        });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_and_special_numbers() {
        let unit = Interval::open_closed(0.0, 1.0);
        assert!(unit.contains(1.0) && unit.contains(f64::MIN_POSITIVE));
        assert!(!unit.contains(0.0) && !unit.contains(1.0 + f64::EPSILON));
        assert!(Interval::NON_NEGATIVE.contains(0.0) && Interval::NON_NEGATIVE.contains(f64::MAX));
        assert!(!Interval::POSITIVE.contains(0.0) && Interval::FINITE.contains(-1e300));
        let everything = Interval::closed(f64::NEG_INFINITY, f64::INFINITY);
        for range in [unit, Interval::NON_NEGATIVE, Interval::FINITE, everything] {
            for special in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                assert!(!range.contains(special), "{range} contains {special}");
            }
        }
    }

    #[test]
    fn prints_as_in_a_textbook() {
        assert_eq!(Interval::NON_NEGATIVE.to_string(), "[0, ∞)");
        assert_eq!(Interval::FINITE.to_string(), "(−∞, ∞)");
        assert_eq!(Interval::open_closed(0.0, 1.0).to_string(), "(0, 1]");
        assert_eq!(Interval::closed(0.0, 0.5).to_string(), "[0, 0.5]");
    }

    #[test]
    fn message_carries_the_numbers() {
        let refused = Interval::NON_NEGATIVE
            .check("coulomb", "mu", -0.1)
            .unwrap_err();
        assert_eq!(
            refused.to_string(),
            "friction law 'coulomb': mu = -0.1 is outside [0, ∞)"
        );
    }
}
