//! Deserialises a tree of values so that every error knows its key and its kind.
//!
//! Existing deserialisers report errors as text. This one returns a typed [`SceneProblem`] with the key at which it arose:
//! an unknown key with its neighbours, a missing key with its table, a quantity with its dimension.

mod error;

use serde::de::value::StrDeserializer;
use serde::de::{
    self, DeserializeSeed, Deserializer, EnumAccess, IntoDeserializer, MapAccess, SeqAccess,
    Unexpected, VariantAccess, Visitor,
};
use serde_json::Value;

use super::document::{Part, child};
use crate::diagnostic::SceneProblem;
use crate::units::{QUANTITY_TAG, UNIT_TAG, Unit, dimensions_of_tag};

pub use error::quantity;
pub(crate) use error::{ReadError, described};

/// A value and the key under which it stands.
#[derive(Clone, Copy, Debug)]
pub struct Reader<'a> {
    value: &'a Value,
    key: &'a str,
}

impl<'a> Reader<'a> {
    /// A reader of `value`, which stands at `key`.
    pub fn new(value: &'a Value, key: &'a str) -> Self {
        Self { value, key }
    }

    fn quantity(self, tags: &str) -> Result<(), ReadError> {
        let read = quantity(self.value, &dimensions_of_tag(tags));
        let refused = |problem: Box<_>| ReadError::new(*problem, Part::Value).at(self.key);
        read.map(|_| ()).map_err(refused)
    }

    /// Refuses a list where a table is wanted: serde's own visitors would take its values for the table's, in the order of the keys.
    fn no_list<'de, V: Visitor<'de>>(self, visitor: &V) -> Result<(), ReadError> {
        match self.value {
            Value::Array(_) => {
                let error: ReadError = de::Error::invalid_type(Unexpected::Seq, visitor);
                Err(error.at(self.key))
            }
            _ => Ok(()),
        }
    }

    /// Refuses a list of another length than `wanted`, which serde's visitors would read as far as they need it.
    fn has_length(self, wanted: usize) -> Result<(), ReadError> {
        match self.value {
            Value::Array(list) if list.len() != wanted => {
                let found = list.len();
                let problem = SceneProblem::WrongLength { wanted, found };
                Err(ReadError::new(problem, Part::Value).at(self.key))
            }
            _ => Ok(()),
        }
    }

    fn unit(self, tags: &str) -> Result<(), ReadError> {
        let expected = dimensions_of_tag(tags);
        // Anything that is not a text is left to the visitor, which says what it wants.
        let (Value::String(name), Some(dimension)) = (self.value, expected.dimensions().first())
        else {
            return Ok(());
        };
        Unit::named(name, *dimension)
            .map(|_| ())
            .map_err(|error| ReadError::new(error.into(), Part::Value).at(self.key))
    }
}

impl<'de> Deserializer<'de> for Reader<'_> {
    type Error = ReadError;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        let read = match self.value {
            Value::Null => visitor.visit_unit(),
            Value::Bool(flag) => visitor.visit_bool(*flag),
            Value::String(text) => visitor.visit_str(text),
            Value::Number(number) => match (number.as_u64(), number.as_i64()) {
                (Some(unsigned), _) => visitor.visit_u64(unsigned),
                (None, Some(signed)) => visitor.visit_i64(signed),
                // Without arbitrary precision a number that is no integer is an f64.
                (None, None) => visitor.visit_f64(number.as_f64().unwrap_or(f64::NAN)),
            },
            Value::Array(list) => visitor.visit_seq(List {
                values: list,
                next: 0,
                key: self.key,
            }),
            Value::Object(map) => visitor.visit_map(Table {
                entries: map.iter(),
                value: None,
                key: self.key,
            }),
        };
        read.map_err(|error| error.at(self.key))
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, ReadError> {
        match self.value {
            Value::Null => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        visitor: V,
    ) -> Result<V::Value, ReadError> {
        if let Some(tags) = name.strip_prefix(QUANTITY_TAG) {
            self.quantity(tags)?;
        }
        if let Some(tags) = name.strip_prefix(UNIT_TAG) {
            self.unit(tags)?;
        }
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, ReadError> {
        let read = match self.value {
            Value::String(name) => visitor.visit_enum(Variant {
                name,
                content: None,
                key: self.key,
            }),
            Value::Object(map) if map.len() == 1 => match map.iter().next() {
                Some((name, content)) => visitor.visit_enum(Variant {
                    name,
                    content: Some(content),
                    key: self.key,
                }),
                None => Err(not_one(self.key, map.keys(), variants)),
            },
            Value::Object(map) => Err(not_one(self.key, map.keys(), variants)),
            other => {
                let expected = format!("one of {}", variants.join(", "));
                let problem = SceneProblem::wrong_kind(expected, described(other));
                Err(ReadError::new(problem, Part::Value))
            }
        };
        read.map_err(|error| error.at(self.key))
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, ReadError> {
        self.no_list(&visitor)?;
        self.deserialize_any(visitor)
    }

    fn deserialize_tuple<V: Visitor<'de>>(
        self,
        length: usize,
        visitor: V,
    ) -> Result<V::Value, ReadError> {
        self.has_length(length)?;
        self.deserialize_any(visitor)
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        length: usize,
        visitor: V,
    ) -> Result<V::Value, ReadError> {
        self.deserialize_tuple(length, visitor)
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit
        unit_struct seq map identifier ignored_any
    }
}

fn not_one<'a>(key: &str, found: impl Iterator<Item = &'a String>, variants: &[&str]) -> ReadError {
    let found = found.map(String::as_str);
    let problem = SceneProblem::one_of(key, variants.join(", "), found);
    ReadError::new(problem, Part::Key)
}

struct List<'a> {
    values: &'a [Value],
    next: usize,
    key: &'a str,
}

impl<'de> SeqAccess<'de> for List<'_> {
    type Error = ReadError;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, ReadError> {
        let Some(value) = self.values.get(self.next) else {
            return Ok(None);
        };
        let key = child(self.key, self.next);
        self.next += 1;
        seed.deserialize(Reader::new(value, &key))
            .map(Some)
            .map_err(|error| error.at(&key))
    }
}

struct Table<'a> {
    entries: serde_json::map::Iter<'a>,
    value: Option<(&'a str, &'a Value)>,
    key: &'a str,
}

impl<'de> MapAccess<'de> for Table<'_> {
    type Error = ReadError;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, ReadError> {
        let Some((name, value)) = self.entries.next() else {
            return Ok(None);
        };
        self.value = Some((name, value));
        let name: StrDeserializer<'_, ReadError> = name.as_str().into_deserializer();
        let named = |error: ReadError| match &self.value {
            Some((name, _)) => error.at(&child(self.key, name)),
            None => error,
        };
        seed.deserialize(name).map(Some).map_err(named)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, ReadError> {
        let Some((name, value)) = self.value.take() else {
            return Err(de::Error::custom("a value was read before its key"));
        };
        let key = child(self.key, name);
        seed.deserialize(Reader::new(value, &key))
            .map_err(|error| error.at(&key))
    }
}

/// An externally tagged choice: a word, or a table of one entry.
struct Variant<'a> {
    name: &'a str,
    content: Option<&'a Value>,
    key: &'a str,
}

impl<'de, 'a> EnumAccess<'de> for Variant<'a> {
    type Error = ReadError;
    type Variant = Content<'a>;

    fn variant_seed<V: DeserializeSeed<'de>>(
        self,
        seed: V,
    ) -> Result<(V::Value, Content<'a>), ReadError> {
        let name: StrDeserializer<'_, ReadError> = self.name.into_deserializer();
        let key = match self.content {
            Some(_) => child(self.key, self.name),
            None => self.key.to_owned(),
        };
        let in_table = self.content.is_some();
        let chosen = seed.deserialize(name).map_err(|mut error| {
            error.part = if in_table { Part::Key } else { Part::Value };
            error.at(&key)
        })?;
        Ok((
            chosen,
            Content {
                value: self.content,
                key,
            },
        ))
    }
}

struct Content<'a> {
    value: Option<&'a Value>,
    key: String,
}

impl<'de> VariantAccess<'de> for Content<'_> {
    type Error = ReadError;

    fn unit_variant(self) -> Result<(), ReadError> {
        match self.value {
            None | Some(Value::Null) => Ok(()),
            Some(value) => {
                let problem = SceneProblem::wrong_kind("a bare name", described(value));
                Err(ReadError::new(problem, Part::Value).at(&self.key))
            }
        }
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, ReadError> {
        let value = self.value.unwrap_or(&Value::Null);
        seed.deserialize(Reader::new(value, &self.key))
            .map_err(|error| error.at(&self.key))
    }

    fn tuple_variant<V: Visitor<'de>>(
        self,
        length: usize,
        visitor: V,
    ) -> Result<V::Value, ReadError> {
        let value = self.value.unwrap_or(&Value::Null);
        Reader::new(value, &self.key).deserialize_tuple(length, visitor)
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, ReadError> {
        let value = self.value.unwrap_or(&Value::Null);
        Reader::new(value, &self.key).deserialize_struct("", fields, visitor)
    }
}
