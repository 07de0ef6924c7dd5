//! Dimensions and units.

use std::f64::consts::PI;
use std::fmt;

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
    /// Energy per area of a crack, base unit N/mm.
    FractureEnergy,
    /// Lines or fringes per length, base unit 1/mm.
    PerLength,
    /// Force per displacement, base unit N/mm.
    SpringStiffness,
    /// Force per displacement and area, base unit N/mm³.
    BedStiffness,
}

impl Dimension {
    /// All dimensions.
    pub const ALL: [Self; 10] = [
        Self::Length,
        Self::Force,
        Self::Stress,
        Self::Angle,
        Self::Temperature,
        Self::PerTemperature,
        Self::FractureEnergy,
        Self::PerLength,
        Self::SpringStiffness,
        Self::BedStiffness,
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
            Self::FractureEnergy => "a fracture energy",
            Self::PerLength => "a number per length",
            Self::SpringStiffness => "a spring stiffness",
            Self::BedStiffness => "a bed stiffness",
        }
    }

    /// The dimension without its article: "length".
    pub fn noun(self) -> &'static str {
        let named = self.with_article();
        named.split_once(' ').map_or(named, |(_, noun)| noun)
    }

    /// Name of the base unit.
    pub fn base_unit(self) -> &'static str {
        self.base().name
    }

    pub(super) fn base(self) -> &'static Unit {
        let mut own = UNITS.iter().filter(|unit| unit.dimension == self);
        // Every dimension has units, and its first one is the base unit: a test of the table holds this.
        own.next().unwrap_or(&UNITS[0])
    }

    pub(super) const fn tag(self) -> &'static str {
        match self {
            Self::Length => "length",
            Self::Force => "force",
            Self::Stress => "stress",
            Self::Angle => "angle",
            Self::Temperature => "temperature",
            Self::PerTemperature => "per temperature",
            Self::FractureEnergy => "fracture energy",
            Self::PerLength => "per length",
            Self::SpringStiffness => "spring stiffness",
            Self::BedStiffness => "bed stiffness",
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
}

/// The unit called `name`, of one of `dimensions` where several dimensions have it.
pub(super) fn unit_called(name: &str, dimensions: &[Dimension]) -> Option<&'static Unit> {
    let named = || UNITS.iter().filter(|unit| unit.name == name);
    let own = named().find(|unit| dimensions.contains(&unit.dimension));
    own.or_else(|| named().next())
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
pub static UNITS: [Unit; 63] = [
    unit("mm", Dimension::Length, 1.0),
    unit("cm", Dimension::Length, 10.0),
    unit("m", Dimension::Length, 1000.0),
    unit("um", Dimension::Length, 1e-3),
    unit("µm", Dimension::Length, 1e-3),
    unit("μm", Dimension::Length, 1e-3),
    unit("nm", Dimension::Length, 1e-6),
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
    unit("N/mm", Dimension::FractureEnergy, 1.0),
    unit("kJ/m2", Dimension::FractureEnergy, 1.0),
    unit("kJ/m²", Dimension::FractureEnergy, 1.0),
    unit("J/m2", Dimension::FractureEnergy, 1e-3),
    unit("J/m²", Dimension::FractureEnergy, 1e-3),
    unit("lbf/in", Dimension::FractureEnergy, POUND_FORCE / 25.4),
    unit("1/mm", Dimension::PerLength, 1.0),
    unit("/mm", Dimension::PerLength, 1.0),
    unit("1/cm", Dimension::PerLength, 0.1),
    unit("1/m", Dimension::PerLength, 1e-3),
    unit("1/um", Dimension::PerLength, 1e3),
    unit("1/µm", Dimension::PerLength, 1e3),
    unit("1/in", Dimension::PerLength, 1.0 / 25.4),
    unit("/in", Dimension::PerLength, 1.0 / 25.4),
    unit("N/mm", Dimension::SpringStiffness, 1.0),
    unit("kN/mm", Dimension::SpringStiffness, 1e3),
    unit("N/m", Dimension::SpringStiffness, 1e-3),
    unit("kN/m", Dimension::SpringStiffness, 1.0),
    unit("lbf/in", Dimension::SpringStiffness, POUND_FORCE / 25.4),
    unit(
        "kip/in",
        Dimension::SpringStiffness,
        1e3 * POUND_FORCE / 25.4,
    ),
    unit("N/mm3", Dimension::BedStiffness, 1.0),
    unit("N/mm³", Dimension::BedStiffness, 1.0),
    unit("MPa/mm", Dimension::BedStiffness, 1.0),
    unit("MPa/m", Dimension::BedStiffness, 1e-3),
    unit("lbf/in3", Dimension::BedStiffness, PSI / 25.4),
    unit("psi/in", Dimension::BedStiffness, PSI / 25.4),
];
