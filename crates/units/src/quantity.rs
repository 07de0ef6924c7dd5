//! Quantities as fields of serde structs.

use std::fmt;
use std::marker::PhantomData;

use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{Dimension, Expected, Unit, parse};

/// Prefix of the newtype name under which a [`Quantity`] asks to be read. A reader that knows it answers a bad
/// quantity with a typed error; any other format reads the text as usual.
pub const QUANTITY_TAG: &str = "$quantity/";
/// The same for a [`UnitName`].
pub const UNIT_TAG: &str = "$unit/";

/// The dimensions that a tag lists after its prefix.
pub fn dimensions_of_tag(list: &str) -> Expected {
    let named = |name| {
        Dimension::ALL
            .into_iter()
            .find(|dimension| dimension.tag() == name)
    };
    Expected::any(&list.split('|').filter_map(named).collect::<Vec<_>>())
}

/// What a [`Quantity`] may measure, at compile time.
pub trait Measure {
    /// The dimensions that fit.
    const DIMENSIONS: &'static [Dimension];
    /// The tags of those dimensions after the quantity prefix.
    const QUANTITY: &'static str;
    /// The tags of those dimensions after the unit prefix.
    const UNIT: &'static str;
}

macro_rules! measures {
    ($($(#[$doc:meta])* $name:ident = $tags:literal: $($dimension:ident),+;)+) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub struct $name;

        impl Measure for $name {
            const DIMENSIONS: &'static [Dimension] = &[$(Dimension::$dimension),+];
            const QUANTITY: &'static str = concat!("$quantity/", $tags);
            const UNIT: &'static str = concat!("$unit/", $tags);
        }
    )+};
}

measures! {
    /// Lengths.
    Length = "length": Length;
    /// Forces.
    Force = "force": Force;
    /// Stresses, pressures and moduli.
    Stress = "stress": Stress;
    /// Angles.
    Angle = "angle": Angle;
    /// Temperature differences.
    Temperature = "temperature": Temperature;
    /// Coefficients of thermal expansion.
    PerTemperature = "per temperature": PerTemperature;
    /// Energies per area of a crack.
    FractureEnergy = "fracture energy": FractureEnergy;
    /// Lines or fringes per length.
    PerLength = "per length": PerLength;
    /// Force per displacement.
    SpringStiffness = "spring stiffness": SpringStiffness;
    /// Force per displacement and area.
    BedStiffness = "bed stiffness": BedStiffness;
    /// Spacings: angles on circles, else lengths.
    AngleOrLength = "angle|length": Angle, Length;
}

/// A quantity of dimension `M`, kept with the text that it was written as.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity<M> {
    value: f64,
    dimension: Dimension,
    text: String,
    measure: PhantomData<M>,
}

impl<M: Measure> Quantity<M> {
    /// Value in base units.
    pub fn value(&self) -> f64 {
        self.value
    }

    /// The dimension, where `M` allows several.
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// The text as written.
    pub fn text(&self) -> &str {
        &self.text
    }
}

impl<M> Serialize for Quantity<M> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.text)
    }
}

impl<'de, M: Measure> Deserialize<'de> for Quantity<M> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_newtype_struct(M::QUANTITY, QuantityVisitor(PhantomData))
    }
}

struct QuantityVisitor<M>(PhantomData<M>);

impl<'de, M: Measure> Visitor<'de> for QuantityVisitor<M> {
    type Value = Quantity<M>;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "{} with its unit in quotes",
            Expected::any(M::DIMENSIONS)
        )
    }

    fn visit_newtype_struct<D: Deserializer<'de>>(self, inner: D) -> Result<Self::Value, D::Error> {
        inner.deserialize_any(self)
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
        let (value, dimension) = parse(text, &Expected::any(M::DIMENSIONS)).map_err(E::custom)?;
        Ok(Quantity {
            value,
            dimension,
            text: text.to_owned(),
            measure: PhantomData,
        })
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Self::Value, E> {
        self.visit_str(&value.to_string())
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Self::Value, E> {
        self.visit_str(&value.to_string())
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Self::Value, E> {
        self.visit_str(&value.to_string())
    }
}

/// The name of a unit of dimension `M`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnitName<M> {
    unit: &'static Unit,
    measure: PhantomData<M>,
}

impl<M: Measure> UnitName<M> {
    /// The unit.
    pub fn unit(self) -> &'static Unit {
        self.unit
    }

    /// The base unit.
    pub fn base() -> Self {
        Self {
            unit: M::DIMENSIONS[0].base(),
            measure: PhantomData,
        }
    }

    /// The unit `name`.
    ///
    /// # Errors
    /// As [`Unit::named`].
    pub fn new(name: &str) -> Result<Self, super::UnitError> {
        let unit = Unit::named(name, M::DIMENSIONS[0])?;
        Ok(Self {
            unit,
            measure: PhantomData,
        })
    }
}

impl<M> Serialize for UnitName<M> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.unit.name)
    }
}

impl<'de, M: Measure> Deserialize<'de> for UnitName<M> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_newtype_struct(M::UNIT, UnitVisitor(PhantomData))
    }
}

struct UnitVisitor<M>(PhantomData<M>);

impl<'de, M: Measure> Visitor<'de> for UnitVisitor<M> {
    type Value = UnitName<M>;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "the name of a unit, one of {}",
            Expected::any(M::DIMENSIONS).unit_list()
        )
    }

    fn visit_newtype_struct<D: Deserializer<'de>>(self, inner: D) -> Result<Self::Value, D::Error> {
        inner.deserialize_str(self)
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<Self::Value, E> {
        UnitName::new(name).map_err(E::custom)
    }
}
