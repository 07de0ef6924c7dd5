//! Quantities with units.
//!
//! ```text
//! value in base units = number × factor of the unit,     base units: mm, N, MPa, rad, K
//! ```
//!
//! The base units are consistent: 1 MPa · 1 mm² = 1 N. Factors are exact by definition (1 in = 25.4 mm and 1 lbf = 4.4482216152605 N:
//! NIST Special Publication 811, 2008, appendix B) up to rounding in `f64`. Temperatures are differences, so 1 degF is 5/9 K and
//! no zero point enters.
//!
//! | dimension         | units                          |
//! |-------------------|--------------------------------|
//! | length            | m, cm, mm, um (µm), in, ft, mil |
//! | force             | N, kN, MN, lbf (lb), kip       |
//! | stress            | Pa, kPa, MPa, GPa, psi, ksi, Msi |
//! | angle             | deg, rad                       |
//! | temperature       | K, degC, degF                  |
//! | per temperature   | 1/K, 1/degC, 1/degF (or /K, …)  |

mod quantity;

use std::f64::consts::PI;
use std::fmt;

use miette::Diagnostic;
use thiserror::Error;

pub use quantity::{
    Angle, AngleOrLength, Force, Length, Measure, PerTemperature, Quantity, Stress, Temperature,
    UnitName,
};
pub(crate) use quantity::{QUANTITY_TAG, UNIT_TAG, dimensions_of_tag};

/// What a quantity measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// Base unit mm.
    Length,
    /// Base unit N.
    Force,
    /// Base unit MPa.
    Stress,
    /// Base unit rad.
    Angle,
    /// Temperature difference, base unit K.
    Temperature,
    /// Thermal expansion, base unit 1/K.
    PerTemperature,
}

impl Dimension {
    /// All dimensions.
    pub const ALL: [Self; 6] = [
        Self::Length,
        Self::Force,
        Self::Stress,
        Self::Angle,
        Self::Temperature,
        Self::PerTemperature,
    ];

    /// The dimension with its article: "a length".
    pub const fn with_article(self) -> &'static str {
        match self {
            Self::Length => "a length",
            Self::Force => "a force",
            Self::Stress => "a stress",
            Self::Angle => "an angle",
            Self::Temperature => "a temperature difference",
            Self::PerTemperature => "a thermal expansion",
        }
    }

    /// Name of the base unit.
    pub const fn base_unit(self) -> &'static str {
        match self {
            Self::Length => "mm",
            Self::Force => "N",
            Self::Stress => "MPa",
            Self::Angle => "rad",
            Self::Temperature => "K",
            Self::PerTemperature => "1/K",
        }
    }

    const fn tag(self) -> &'static str {
        match self {
            Self::Length => "length",
            Self::Force => "force",
            Self::Stress => "stress",
            Self::Angle => "angle",
            Self::Temperature => "temperature",
            Self::PerTemperature => "per temperature",
        }
    }

    /// Names of the units of this dimension, the base unit first; other spellings of the same unit are left out.
    pub fn unit_names(self) -> impl Iterator<Item = &'static str> {
        let plain = |unit: &&Unit| unit.name.is_ascii() && !unit.name.starts_with('/');
        UNITS
            .iter()
            .filter(move |unit| unit.dimension == self)
            .filter(plain)
            .map(|unit| unit.name)
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(self.tag())
    }
}

/// A unit and its size in base units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Name as written in a scene.
    pub name: &'static str,
    /// What it measures.
    pub dimension: Dimension,
    /// One of this unit, in base units.
    pub in_base: f64,
}

impl Unit {
    /// `value`, given in base units, in this unit.
    pub fn from_base(&self, value: f64) -> f64 {
        value / self.in_base
    }

    /// `value`, given in base units, in this unit with its name: six digits, for people.
    pub fn show(&self, value: f64) -> String {
        let digits = format!("{:.5e}", self.from_base(value));
        // Formatted by this function's own pattern, so it is a number.
        let rounded = digits.parse::<f64>().unwrap_or(value);
        format!("{rounded} {}", self.name)
    }

    /// The unit called `name`.
    ///
    /// # Errors
    /// [`UnitError::UnknownUnit`] if there is none, [`UnitError::WrongDimension`] if it measures something else.
    pub fn named(name: &str, dimension: Dimension) -> Result<&'static Self, UnitError> {
        match UNITS.iter().find(|unit| unit.name == name) {
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

const POUND_FORCE: f64 = 4.448_221_615_260_5;
const PSI: f64 = POUND_FORCE / (25.4 * 25.4);

const fn unit(name: &'static str, dimension: Dimension, in_base: f64) -> Unit {
    Unit {
        name,
        dimension,
        in_base,
    }
}

/// Every unit that a scene may use. Within a dimension the first is the base unit.
pub const UNITS: [Unit; 36] = [
    unit("mm", Dimension::Length, 1.0),
    unit("cm", Dimension::Length, 10.0),
    unit("m", Dimension::Length, 1000.0),
    unit("um", Dimension::Length, 1e-3),
    unit("µm", Dimension::Length, 1e-3),
    unit("μm", Dimension::Length, 1e-3),
    unit("in", Dimension::Length, 25.4),
    unit("ft", Dimension::Length, 304.8),
    unit("mil", Dimension::Length, 0.0254),
    unit("N", Dimension::Force, 1.0),
    unit("kN", Dimension::Force, 1e3),
    unit("MN", Dimension::Force, 1e6),
    unit("lbf", Dimension::Force, POUND_FORCE),
    unit("lb", Dimension::Force, POUND_FORCE),
    unit("kip", Dimension::Force, 1e3 * POUND_FORCE),
    unit("MPa", Dimension::Stress, 1.0),
    unit("GPa", Dimension::Stress, 1e3),
    unit("kPa", Dimension::Stress, 1e-3),
    unit("Pa", Dimension::Stress, 1e-6),
    unit("psi", Dimension::Stress, PSI),
    unit("ksi", Dimension::Stress, 1e3 * PSI),
    unit("Msi", Dimension::Stress, 1e6 * PSI),
    unit("rad", Dimension::Angle, 1.0),
    unit("deg", Dimension::Angle, PI / 180.0),
    unit("°", Dimension::Angle, PI / 180.0),
    unit("K", Dimension::Temperature, 1.0),
    unit("degC", Dimension::Temperature, 1.0),
    unit("°C", Dimension::Temperature, 1.0),
    unit("degF", Dimension::Temperature, 5.0 / 9.0),
    unit("°F", Dimension::Temperature, 5.0 / 9.0),
    unit("1/K", Dimension::PerTemperature, 1.0),
    unit("/K", Dimension::PerTemperature, 1.0),
    unit("1/degC", Dimension::PerTemperature, 1.0),
    unit("/degC", Dimension::PerTemperature, 1.0),
    unit("1/degF", Dimension::PerTemperature, 9.0 / 5.0),
    unit("/degF", Dimension::PerTemperature, 9.0 / 5.0),
];

/// The dimensions that fit in one place of a scene: one, or one of two.
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

/// Why a text is not a quantity of the dimension asked for.
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
    #[error("expected {expected}, but \"{text}\" is {}", found.with_article())]
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
    let Some(unit) = UNITS.iter().find(|unit| unit.name == name) else {
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

#[cfg(test)]
mod tests;
