//! Reading of quantities, and what can be wrong with one.

use std::fmt;

use miette::Diagnostic;
use thiserror::Error;

use super::unit::unit_called;
use super::{Dimension, UNITS, Unit};

/// The dimensions that fit in one place: one, or one of several.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Expected(Vec<Dimension>);

impl Expected {
    /// Only this dimension.
    pub fn one(dimension: Dimension) -> Self {
        Self(vec![dimension])
    }

    /// Any of these.
    pub fn any(dimensions: &[Dimension]) -> Self {
        Self(dimensions.to_vec())
    }

    /// The dimensions.
    pub fn dimensions(&self) -> &[Dimension] {
        &self.0
    }

    /// The units that fit, with commas.
    pub fn unit_list(&self) -> String {
        let names: Vec<_> = self
            .0
            .iter()
            .flat_map(|dimension| dimension.unit_names())
            .collect();
        names.join(", ")
    }

    fn first_unit(&self) -> &'static str {
        match self.0.first() {
            // Nobody divides a circle in radians.
            Some(Dimension::Angle) => "deg",
            Some(dimension) => dimension.base_unit(),
            None => Dimension::Length.base_unit(),
        }
    }
}

impl fmt::Display for Expected {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<_> = self
            .0
            .iter()
            .map(|dimension| dimension.with_article())
            .collect();
        formatter.write_str(&names.join(" or "))
    }
}

/// Why a text is not a quantity of the requested dimension.
#[derive(Debug, Clone, PartialEq, Error, Diagnostic)]
#[non_exhaustive]
pub enum UnitError {
    /// A number alone.
    #[error("{value} has no unit; {expected} is expected")]
    #[diagnostic(
        code(unit::missing),
        help("write the number with its unit in quotes, for example \"{value} {}\"; units: {}", expected.first_unit(), expected.unit_list())
    )]
    MissingUnit {
        /// The number as written.
        value: String,
        /// What fits here.
        expected: Expected,
    },
    /// A unit that is not in [`UNITS`].
    #[error("'{unit}' in \"{text}\" is not a known unit; {expected} is expected")]
    #[diagnostic(code(unit::unknown), help("units that fit here: {}", expected.unit_list()))]
    UnknownUnit {
        /// The whole text.
        text: String,
        /// Its unit.
        unit: String,
        /// What fits here.
        expected: Expected,
    },
    /// A quantity of another dimension.
    #[error("\"{text}\" has the unit of {}; {expected} is expected", of_unit(text, *found))]
    #[diagnostic(code(unit::dimension), help("units that fit here: {}", expected.unit_list()))]
    WrongDimension {
        /// The whole text.
        text: String,
        /// What fits here.
        expected: Expected,
        /// What it is.
        found: Dimension,
    },
    /// A text that does not begin with a number.
    #[error("\"{text}\" does not begin with a number; {expected} is expected")]
    #[diagnostic(
        code(unit::number),
        help("write a number and a unit, for example \"1.5 {}\"", expected.first_unit())
    )]
    NotANumber {
        /// The whole text.
        text: String,
        /// What fits here.
        expected: Expected,
    },
    /// An infinite number, or none at all.
    #[error("\"{text}\" is not a finite number")]
    #[diagnostic(code(unit::finite), help("give a finite value with its unit"))]
    NotFinite {
        /// The whole text.
        text: String,
    },
}

/// What the unit of `text`, which has the dimension `found`, says to a person: N/mm may be of a stiffness or of a line load too.
fn of_unit(text: &str, found: Dimension) -> &'static str {
    match (found, unit_of(text)) {
        (Dimension::FractureEnergy, Some(unit)) if unit.name.contains("J/") => "an energy per area",
        (Dimension::FractureEnergy, _) => "a force per length",
        _ => found.with_article(),
    }
}

/// Reads a number with a unit: its value in base units, and which of the `expected` dimensions it has.
///
/// # Errors
/// [`UnitError`]: no number, a number that is not finite, no unit, an unknown unit, or one of another dimension.
pub fn parse(text: &str, expected: &Expected) -> Result<(f64, Dimension), UnitError> {
    let trimmed = text.trim();
    let unsigned = trimmed.trim_start_matches(['+', '-']).to_ascii_lowercase();
    if unsigned.starts_with("nan") || unsigned.starts_with("inf") {
        return Err(UnitError::NotFinite {
            text: text.to_owned(),
        });
    }
    let (digits, name) = trimmed.split_at(number_length(trimmed));
    let Ok(number) = digits.parse::<f64>() else {
        return Err(UnitError::NotANumber {
            text: text.to_owned(),
            expected: expected.clone(),
        });
    };
    let name = name.trim();
    if name.is_empty() {
        return Err(UnitError::MissingUnit {
            value: trimmed.to_owned(),
            expected: expected.clone(),
        });
    }
    let Some(unit) = unit_called(name, expected.dimensions()) else {
        return Err(UnitError::UnknownUnit {
            text: text.to_owned(),
            unit: name.to_owned(),
            expected: expected.clone(),
        });
    };
    if !expected.0.contains(&unit.dimension) {
        return Err(UnitError::WrongDimension {
            text: text.to_owned(),
            expected: expected.clone(),
            found: unit.dimension,
        });
    }
    let value = number * unit.in_base;
    if value.is_finite() {
        Ok((value, unit.dimension))
    } else {
        Err(UnitError::NotFinite {
            text: text.to_owned(),
        })
    }
}

/// The unit that a quantity is written in, if it is one.
pub fn unit_of(text: &str) -> Option<&'static Unit> {
    let trimmed = text.trim();
    let name = trimmed[number_length(trimmed)..].trim();
    UNITS.iter().find(|unit| unit.name == name)
}

/// Bytes of the decimal number at the start of `text`; an `e` belongs to it only if digits follow.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits_from = |start: usize| {
        bytes[start..]
            .iter()
            .take_while(|byte| byte.is_ascii_digit() || **byte == b'.')
            .count()
    };
    let sign_at = |at: usize| usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));
    let sign = sign_at(0);
    let mantissa = sign + digits_from(sign);
    if !matches!(bytes.get(mantissa), Some(b'e' | b'E')) {
        return mantissa;
    }
    let start = mantissa + 1 + sign_at(mantissa + 1);
    match digits_from(start.min(bytes.len())) {
        0 => mantissa,
        count => start + count,
    }
}

impl Unit {
    /// The unit called `name`.
    ///
    /// # Errors
    /// [`UnitError::UnknownUnit`] if there is none, [`UnitError::WrongDimension`] if it measures something else.
    pub fn named(name: &str, dimension: Dimension) -> Result<&'static Self, UnitError> {
        match unit_called(name, &[dimension]) {
            Some(unit) if unit.dimension == dimension => Ok(unit),
            Some(unit) => Err(UnitError::WrongDimension {
                text: name.to_owned(),
                expected: Expected::one(dimension),
                found: unit.dimension,
            }),
            None => Err(UnitError::UnknownUnit {
                text: name.to_owned(),
                unit: name.to_owned(),
                expected: Expected::one(dimension),
            }),
        }
    }
}
