//! Types of keys, and a constructor of rows for each.

use std::fmt;

use super::Key;
use crate::units::{Dimension, Expected};

/// The type of a key.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// A quantity of one of these dimensions.
    Quantity(&'static [Dimension]),
    /// A list of quantities.
    List(Dimension),
    /// One of the names that are registered or listed.
    Names(fn() -> String),
    /// Anything else, as text.
    Described(&'static str),
}

impl Kind {
    /// The units that fit, with commas; nothing without a unit.
    pub fn units(&self) -> String {
        match self {
            Self::Quantity(dimensions) => Expected::any(dimensions).unit_list(),
            Self::List(dimension) => Expected::one(*dimension).unit_list(),
            Self::Names(_) | Self::Described(_) => String::new(),
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Quantity(dimensions) => {
                let names: Vec<_> = dimensions.iter().map(|own| own.noun()).collect();
                formatter.write_str(&names.join(" or "))
            }
            Self::List(dimension) => {
                let name = dimension.noun();
                let plural = if name.ends_with('s') { "es" } else { "s" };
                write!(formatter, "list of {name}{plural}")
            }
            Self::Names(names) => formatter.write_str(&names()),
            Self::Described(text) => formatter.write_str(text),
        }
    }
}

/// Makes constructors of rows: `length(name, default, example, meaning)`.
macro_rules! rows {
    ($($name:ident = $kind:expr;)+) => {$(
        pub(crate) const fn $name(
            name: &'static str,
            default: &'static str,
            example: &'static str,
            meaning: &'static str,
        ) -> Key {
            row(name, $kind, default, example, meaning)
        }
    )+};
}

rows! {
    length = Kind::Quantity(&[Dimension::Length]);
    stress = Kind::Quantity(&[Dimension::Stress]);
    angle = Kind::Quantity(&[Dimension::Angle]);
    spacing = Kind::Quantity(&[Dimension::Angle, Dimension::Length]);
    temperature = Kind::Quantity(&[Dimension::Temperature]);
    expansion = Kind::Quantity(&[Dimension::PerTemperature]);
    energy = Kind::Quantity(&[Dimension::FractureEnergy]);
    force = Kind::Quantity(&[Dimension::Force]);
    spring_stiffness = Kind::Quantity(&[Dimension::SpringStiffness]);
    bed_stiffness = Kind::Quantity(&[Dimension::BedStiffness]);
    angles = Kind::List(Dimension::Angle);
    lengths = Kind::List(Dimension::Length);
    forces = Kind::List(Dimension::Force);
    stresses = Kind::List(Dimension::Stress);
    temperatures = Kind::List(Dimension::Temperature);
    number = Kind::Described("number");
    integer = Kind::Described("integer");
    flag = Kind::Described("`true`, `false`");
    text = Kind::Described("text");
    set = Kind::Described("`body.set`");
    table_as = Kind::Described("table");
}

const fn row(
    name: &'static str,
    kind: Kind,
    default: &'static str,
    example: &'static str,
    meaning: &'static str,
) -> Key {
    Key {
        name,
        kind,
        default,
        meaning,
        example,
        noted: "",
        range: None,
    }
}

/// A key of the type that `kind` names.
pub(crate) const fn described(
    name: &'static str,
    kind: &'static str,
    default: &'static str,
    example: &'static str,
    meaning: &'static str,
) -> Key {
    row(name, Kind::Described(kind), default, example, meaning)
}

/// A key whose choices are what `names` lists.
pub(crate) const fn names(
    name: &'static str,
    names: fn() -> String,
    default: &'static str,
    example: &'static str,
    meaning: &'static str,
) -> Key {
    row(name, Kind::Names(names), default, example, meaning)
}

/// A table with keys of its own.
pub(crate) const fn table(name: &'static str, default: &'static str, meaning: &'static str) -> Key {
    table_as(name, default, "", meaning)
}

/// A table of tables by name.
pub(crate) const fn tables_of(
    name: &'static str,
    default: &'static str,
    meaning: &'static str,
) -> Key {
    described(name, "table of tables", default, "", meaning)
}

/// A list of tables.
pub(crate) const fn lists(name: &'static str, default: &'static str, meaning: &'static str) -> Key {
    described(name, "list of tables", default, "", meaning)
}
