//! What is asked of the results: how accurate, and how soon.

use std::fmt;
use std::marker::PhantomData;

use serde::de::{Deserialize, Deserializer, Error, Visitor};
use serde::{Serialize, Serializer};

/// Units of time with their length in seconds.
const TIMES: [(&str, f64); 4] = [("ms", 1e-3), ("s", 1.0), ("min", 60.0), ("h", 3600.0)];

/// Largest error that is asked for, relative to the quantity: `"1 %"` or `0.01`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accuracy(f64);

/// Time that a run may take: `"10 s"`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget(f64);

impl Accuracy {
    /// What is taken where neither an accuracy nor a mesh is given: 1 %.
    pub const DEFAULT: Self = Self(0.01);
    /// Least and largest accuracy that can be asked for.
    pub const RANGE: [f64; 2] = [1e-8, 0.5];

    /// The accuracy `share`, relative; `None` outside of [`RANGE`](Self::RANGE).
    pub fn of(share: f64) -> Option<Self> {
        let [least, most] = Self::RANGE;
        (least..=most).contains(&share).then_some(Self(share))
    }

    /// Relative error.
    pub fn share(self) -> f64 {
        self.0
    }

    /// Whether it can be asked for.
    pub(crate) fn is_in_range(self) -> bool {
        Self::of(self.0).is_some()
    }
}

impl Budget {
    /// The time `[s]`.
    pub fn seconds(self) -> f64 {
        self.0
    }
}

impl fmt::Display for Accuracy {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} %", 100.0 * self.0)
    }
}

impl fmt::Display for Budget {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} s", self.0)
    }
}

/// A number that scenes write as a text with its unit.
trait Written: Sized {
    const EXPECTED: &'static str;

    /// Reads a text; `None` for one that is not understood.
    fn read(text: &str) -> Option<Self>;
}

impl Written for Accuracy {
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
        let text = text.trim();
        let end = text.find(|letter: char| letter.is_alphabetic() && letter != 'e')?;
        let (number, unit) = text.split_at(end);
        let (_, length) = TIMES.iter().find(|(name, _)| *name == unit.trim())?;
        let value = number.trim().parse::<f64>().ok()?;
        value.is_finite().then_some(Self(length * value))
    }
}

impl Serialize for Accuracy {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.to_string())
    }
}

impl Serialize for Budget {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.to_string())
    }
}

impl<'de> Deserialize<'de> for Accuracy {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Text(PhantomData))
    }
}

impl<'de> Deserialize<'de> for Budget {
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
    fn shares_and_times_are_read_with_their_units() {
        assert_eq!(Accuracy::read("1 %"), Some(Accuracy(0.01)));
        assert_eq!(Accuracy::read("0.002"), Some(Accuracy(0.002)));
        assert_eq!(Accuracy::read("1e-3 %"), Some(Accuracy(1e-5)));
        assert_eq!(Budget::read("1.5e1 ms"), Some(Budget(0.015)));
        assert_eq!(Budget::read("2 min"), Some(Budget(120.0)));
        for text in ["", "%", "one", "NaN", "inf %"] {
            assert_eq!(Accuracy::read(text), None, "{text}");
        }
        for text in ["", "10", "10 parsecs", "s"] {
            assert_eq!(Budget::read(text), None, "{text}");
        }
    }
}
