//! What is asked of the results: how accurate, how soon, and in how much memory.

use std::fmt;
use std::marker::PhantomData;

use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, Error, MapAccess, Visitor};
use serde::{Deserialize, Serialize, Serializer};
use stickslip_text::tidy;

/// Units of time with their length in seconds.
const TIMES: [(&str, f64); 4] = [("ms", 1e-3), ("s", 1.0), ("min", 60.0), ("h", 3600.0)];

/// Units of memory with their length in bytes.
const SIZES: [(&str, f64); 4] = [
    ("MB", 1e6),
    ("GB", 1e9),
    ("MiB", 1_048_576.0),
    ("GiB", 1_073_741_824.0),
];

/// An error relative to its number `[1]`: `"1 %"` or `0.01`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelativeError(f64);

/// Largest errors that are asked for.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Accuracy {
    /// One for peak pressure, peak tangential stress, extent of contact and friction force; of a scene without edges, for displacements of what is loaded.
    Overall(RelativeError),
    /// Those of named numbers; others are not bounded.
    Named(Bounds),
}

/// Errors of numbers of contacts, loads and supports that are asked for, under the names that scenes give them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Bounds {
    /// Largest pressure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_pressure: Option<RelativeError>,
    /// Largest tangential stress.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_hoop: Option<RelativeError>,
    /// Extent of contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact_extent: Option<RelativeError>,
    /// Extent of stick.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stick_extent: Option<RelativeError>,
    /// Friction force.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction_force: Option<RelativeError>,
    /// Normal force.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normal_force: Option<RelativeError>,
    /// Tangential stress at the bearing point.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hoop_at_bearing: Option<RelativeError>,
    /// Displacement of what is loaded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub displacement: Option<RelativeError>,
    /// Force over displacement of what is loaded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<RelativeError>,
    /// The same of their changes from step to step.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tangent_stiffness: Option<RelativeError>,
    /// Force of a support.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reaction: Option<RelativeError>,
}

/// Time `[s]` that a run may take: `"10 s"`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget(f64);

/// Memory `[byte]` that a run may take: `"4 GB"`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Memory(f64);

impl RelativeError {
    /// Least and largest one that can be asked for `[1]`.
    pub const RANGE: [f64; 2] = [1e-8, 0.5];

    /// The error as a part of its number `[1]`.
    pub fn share(self) -> f64 {
        self.0
    }

    /// Whether it can be asked for.
    pub(crate) fn is_in_range(self) -> bool {
        let [least, most] = Self::RANGE;
        (least..=most).contains(&self.0)
    }
}

impl Accuracy {
    /// What is taken where neither an accuracy nor a mesh is given: 1 %.
    pub const DEFAULT: Self = Self::Overall(RelativeError(0.01));
}

impl Bounds {
    /// What is asked for, each with its name in scenes.
    pub fn entries(&self) -> impl Iterator<Item = (&'static str, RelativeError)> {
        let all = [
            ("peak_pressure", self.peak_pressure),
            ("peak_hoop", self.peak_hoop),
            ("contact_extent", self.contact_extent),
            ("stick_extent", self.stick_extent),
            ("friction_force", self.friction_force),
            ("normal_force", self.normal_force),
            ("hoop_at_bearing", self.hoop_at_bearing),
            ("displacement", self.displacement),
            ("stiffness", self.stiffness),
            ("tangent_stiffness", self.tangent_stiffness),
            ("reaction", self.reaction),
        ];
        all.into_iter()
            .filter_map(|(name, error)| Some((name, error?)))
    }
}

impl Budget {
    /// The time `[s]`.
    pub fn seconds(self) -> f64 {
        self.0
    }
}

impl Memory {
    /// What is taken where none is given: 4 GB.
    pub const DEFAULT: Self = Self(4e9);

    /// The memory `[byte]`.
    pub fn bytes(self) -> f64 {
        self.0
    }
}

impl fmt::Display for RelativeError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Not the tail of digits that a hundredth leaves.
        let percent = 100.0 * self.0;
        write!(formatter, "{} %", tidy(percent).unwrap_or(percent))
    }
}

impl fmt::Display for Budget {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} s", self.0)
    }
}

impl fmt::Display for Memory {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} GB", self.0 / 1e9)
    }
}

/// A number that scenes write as a text with its unit.
trait Written: Sized {
    const EXPECTED: &'static str;

    /// Reads a text; `None` for one that is not understood.
    fn read(text: &str) -> Option<Self>;
}

impl Written for RelativeError {
    const EXPECTED: &'static str = "a relative error such as \"1 %\" or 0.01";

    fn read(text: &str) -> Option<Self> {
        let text = text.trim();
        let (number, unit) = text
            .strip_suffix('%')
            .map_or((text, 1.0), |own| (own, 0.01));
        let value = number.trim().parse::<f64>().ok()?;
        value.is_finite().then_some(Self(unit * value))
    }
}

impl Written for Budget {
    const EXPECTED: &'static str =
        "a time with its unit in quotes such as \"10 s\" (ms, s, min, h)";

    fn read(text: &str) -> Option<Self> {
        with_unit(text, &TIMES).map(Self)
    }
}

impl Written for Memory {
    const EXPECTED: &'static str =
        "an amount of memory with its unit in quotes such as \"4 GB\" (MB, GB, MiB, GiB)";

    fn read(text: &str) -> Option<Self> {
        with_unit(text, &SIZES).map(Self)
    }
}

/// The number that stands before one of `units`, times its length.
fn with_unit(text: &str, units: &[(&str, f64)]) -> Option<f64> {
    let text = text.trim();
    let end = text.find(|letter: char| letter.is_alphabetic() && letter != 'e')?;
    let (number, unit) = text.split_at(end);
    let (_, length) = units.iter().find(|(name, _)| *name == unit.trim())?;
    let value = number.trim().parse::<f64>().ok()?;
    value.is_finite().then_some(length * value)
}

impl Serialize for RelativeError {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.to_string())
    }
}

impl Serialize for Budget {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.to_string())
    }
}

impl Serialize for Memory {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.to_string())
    }
}

impl<'de> Deserialize<'de> for RelativeError {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Text(PhantomData))
    }
}

impl<'de> Deserialize<'de> for Accuracy {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(OneOrNamed)
    }
}

struct OneOrNamed;

impl<'de> Visitor<'de> for OneOrNamed {
    type Value = Accuracy;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "{}, or a table of these",
            RelativeError::EXPECTED
        )
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Accuracy, E> {
        Text(PhantomData).visit_str(text).map(Accuracy::Overall)
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Accuracy, E> {
        self.visit_str(&value.to_string())
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Accuracy, E> {
        self.visit_str(&value.to_string())
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Accuracy, E> {
        self.visit_str(&value.to_string())
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Accuracy, A::Error> {
        Bounds::deserialize(MapAccessDeserializer::new(map)).map(Accuracy::Named)
    }
}

impl<'de> Deserialize<'de> for Budget {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Text(PhantomData))
    }
}

impl<'de> Deserialize<'de> for Memory {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Text(PhantomData))
    }
}

struct Text<W>(PhantomData<W>);

impl<W: Written> Visitor<'_> for Text<W> {
    type Value = W;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(W::EXPECTED)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<W, E> {
        W::read(text).ok_or_else(|| E::custom(format!("'{text}' is not {}", W::EXPECTED)))
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<W, E> {
        self.visit_str(&value.to_string())
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<W, E> {
        self.visit_str(&value.to_string())
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<W, E> {
        self.visit_str(&value.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_times_and_sizes_are_read_with_their_units() {
        assert_eq!(RelativeError::read("1 %"), Some(RelativeError(0.01)));
        assert_eq!(RelativeError::read("0.002"), Some(RelativeError(0.002)));
        assert_eq!(RelativeError::read("1e-3 %"), Some(RelativeError(1e-5)));
        assert_eq!(RelativeError(0.07).to_string(), "7 %");
        assert_eq!(Budget::read("1.5e1 ms"), Some(Budget(0.015)));
        assert_eq!(Budget::read("2 min"), Some(Budget(120.0)));
        for text in ["", "%", "one", "NaN", "inf %"] {
            assert_eq!(RelativeError::read(text), None, "{text}");
        }
        for text in ["", "10", "10 parsecs", "s"] {
            assert_eq!(Budget::read(text), None, "{text}");
        }
        assert_eq!(Memory::read("1.5e1 GB"), Some(Memory(15e9)));
        assert_eq!(Memory::read("1 GiB").unwrap().to_string(), "1.073741824 GB");
        assert_eq!(Memory::read("500 MB").unwrap().to_string(), "0.5 GB");
        for text in ["", "4", "4 gb", "4 TB", "GB"] {
            assert_eq!(Memory::read(text), None, "{text}");
        }
    }
}
