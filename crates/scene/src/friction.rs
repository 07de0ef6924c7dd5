//! Friction laws of a scene, with units.
//!
//! The laws take plain numbers and their registry says which parameter is a length, a stress or an angle. So a parameter is
//! checked against the registry, its quantity becomes a number in base units, and the law reads the rest. A law of another
//! crate needs nothing else to be used in a scene.

mod choice;
mod registered;

use serde_json::{Map, Value};
use stickslip_friction::{
    Dimension as Kind, FrictionLaw, LawInfo, ParameterInfo, PlyFraction, laws,
};

pub(super) use choice::Choice;
use registered::{below, has_parameter, holds_one, names_below};

use super::document::{Document, Part, child};
use super::read::{described, quantity};
use crate::diagnostic::{Finding, SceneProblem};
use crate::units::{Dimension, Expected};

/// A law, and its table with all defaults filled in.
pub(super) struct ReadLaw {
    pub(super) law: Box<dyn FrictionLaw>,
    pub(super) shown: Value,
}

/// A table in numbers, and the same as a file would spell it.
struct Converted {
    plain: Value,
    shown: Value,
}

fn find(name: &str) -> Option<&'static LawInfo> {
    laws().find(|law| law.name == name)
}

/// Reads the table `friction` that stands at `key`; `plies` are those of the laminate that it acts on, if it is one.
pub(super) fn read(
    document: &Document,
    key: &str,
    table: &Value,
    plies: Option<Vec<PlyFraction>>,
) -> Result<ReadLaw, Box<Finding>> {
    // A list of two plain numbers per ply is what the law itself reads.
    let plies = plies.and_then(|plies| serde_json::to_value(plies).ok());
    let reader = LawReader { document, plies };
    let Converted { plain, shown } = reader.law(key, table)?;
    serde_json::from_value(plain)
        .map(|law| ReadLaw { law, shown })
        .map_err(|error| {
            let law = table
                .as_object()
                .and_then(|map| map.keys().next())
                .cloned()
                .unwrap_or_default();
            reader.refused(&child(key, &law), law, error.to_string())
        })
}

/// Reads the friction law of the table `friction` that stands at `key` of any document; `plies` are those of the laminate that it acts on, if it is one.
///
/// # Errors
/// What is wrong with the table, at its place: an unknown law, a parameter that is missing, without its unit or out of its range.
pub fn law(
    document: &Document,
    key: &str,
    table: &Value,
    plies: Option<Vec<PlyFraction>>,
) -> Result<Box<dyn FrictionLaw>, Box<Finding>> {
    read(document, key, table, plies).map(|read| read.law)
}

/// Reads the parameters of `info` in the table `given` that stands at `key`, in numbers.
pub(super) fn parameters(
    document: &Document,
    key: &str,
    info: &LawInfo,
    given: &Map<String, Value>,
) -> Result<Value, Box<Finding>> {
    let reader = LawReader {
        document,
        plies: None,
    };
    Ok(reader.group(info, "", key, given)?.plain)
}

struct LawReader<'a> {
    document: &'a Document,
    /// Ply fractions for a law that needs `plies` where the scene gives none.
    plies: Option<Value>,
}

impl LawReader<'_> {
    fn finding(&self, key: &str, part: Part, problem: SceneProblem) -> Box<Finding> {
        Box::new(self.document.finding(key, part, problem))
    }

    fn wrong_kind(&self, key: &str, expected: &str, found: &Value) -> Box<Finding> {
        let problem = SceneProblem::wrong_kind(expected, described(found));
        self.finding(key, Part::Value, problem)
    }

    /// The words of the law itself, at the parameter that they name if there is one.
    fn refused(&self, key: &str, law: String, message: String) -> Box<Finding> {
        let parameter = self
            .document
            .get(key)
            .and_then(Value::as_object)
            .and_then(|map| {
                map.keys()
                    .find(|name| message.contains(&format!(" {name} = ")))
            });
        let place = parameter.map_or_else(|| key.to_owned(), |name| child(key, name));
        self.finding(&place, Part::Value, SceneProblem::Friction { law, message })
    }

    fn law(&self, key: &str, value: &Value) -> Result<Converted, Box<Finding>> {
        let choice = Choice {
            what: "friction law",
            owner: "law",
            example: "{ coulomb = { mu = 0.3 } }",
            known: laws().map(|law| (law.name, law)).collect(),
        };
        let (info, parameters) = choice.of(self.document, key, value)?;
        let converted = self.group(info, "", &child(key, info.name), parameters)?;
        let tagged = |value| Value::Object(Map::from_iter([(info.name.to_owned(), value)]));
        Ok(Converted {
            plain: tagged(converted.plain),
            shown: tagged(converted.shown),
        })
    }

    /// The table of `info` whose registered path is `prefix`.
    fn group(
        &self,
        info: &LawInfo,
        prefix: &str,
        key: &str,
        map: &Map<String, Value>,
    ) -> Result<Converted, Box<Finding>> {
        let names = names_below(info, prefix);
        let (mut plain, mut shown) = (Map::new(), Map::new());
        for (name, value) in map {
            let key = child(key, name);
            if !names.contains(&name.as_str()) {
                let problem = SceneProblem::unknown_key(name, names);
                return Err(self.finding(&key, Part::Key, problem));
            }
            let converted = self.entry(info, &child(prefix, name), &key, value)?;
            plain.insert(name.clone(), converted.plain);
            shown.insert(name.clone(), converted.shown);
        }
        if holds_one(info, prefix) {
            if map.len() != 1 {
                let found = map.keys().map(String::as_str);
                let problem = SceneProblem::one_of(key, names.join(", "), found);
                return Err(self.finding(key, Part::Key, problem));
            }
        } else {
            for name in names.iter().filter(|name| !map.contains_key(**name)) {
                if let Some(plies) = self.plies_for(info, prefix, name) {
                    plain.insert((*name).to_owned(), plies.clone());
                    continue;
                }
                let default = self.default_of(info, &child(prefix, name), key, name)?;
                shown.extend(default.map(|value| ((*name).to_owned(), value)));
            }
        }
        Ok(Converted {
            plain: Value::Object(plain),
            shown: Value::Object(shown),
        })
    }

    /// The laminate's plies, where the law `info` asks for them under this name.
    fn plies_for(&self, info: &LawInfo, prefix: &str, name: &str) -> Option<&Value> {
        let asks = prefix.is_empty() && name == "plies" && has_parameter(info, "plies[].fraction");
        self.plies.as_ref().filter(|_| asks)
    }

    /// What stands for the parameter that `table` lacks; an error if nothing does.
    fn default_of(
        &self,
        info: &LawInfo,
        path: &str,
        table: &str,
        name: &str,
    ) -> Result<Option<Value>, Box<Finding>> {
        let below: Vec<_> = below(info, path).collect();
        match info
            .parameters
            .iter()
            .find(|parameter| parameter.path == path)
        {
            Some(ParameterInfo {
                default: Some(default),
                ..
            }) => {
                return Ok(Some(written(default)));
            }
            None if below.iter().any(|parameter| parameter.default.is_some()) => return Ok(None),
            _ => {}
        }
        let dimension = below.first().map(|parameter| parameter.dimension);
        let example = match dimension {
            Some(Kind::Length) => "\"0.1 mm\"",
            Some(Kind::Stress) => "\"10 MPa\"",
            Some(Kind::Angle) => "\"5 deg\"",
            Some(Kind::Dimensionless) if below.first().is_some_and(|own| own.path == path) => "0.3",
            Some(Kind::Flag) => "false",
            Some(Kind::Law) => "{ coulomb = { mu = 0.3 } }",
            _ => "…",
        };
        let problem = SceneProblem::MissingKey {
            key: name.to_owned(),
            table: table.to_owned(),
            example: format!("{name} = {example}"),
        };
        Err(self.finding(table, Part::Key, problem))
    }

    fn entry(
        &self,
        info: &LawInfo,
        path: &str,
        key: &str,
        value: &Value,
    ) -> Result<Converted, Box<Finding>> {
        if let Some(parameter) = info
            .parameters
            .iter()
            .find(|parameter| parameter.path == path)
        {
            return self.parameter(parameter.dimension, key, value);
        }
        match value {
            Value::Object(map) => self.group(info, path, key, map),
            Value::Array(list) => {
                let (mut plain, mut shown) = (Vec::new(), Vec::new());
                for (index, value) in list.iter().enumerate() {
                    let converted =
                        self.entry(info, &format!("{path}[]"), &child(key, index), value)?;
                    plain.push(converted.plain);
                    shown.push(converted.shown);
                }
                Ok(Converted {
                    plain: Value::Array(plain),
                    shown: Value::Array(shown),
                })
            }
            other => Err(self.wrong_kind(key, "a table or a list", other)),
        }
    }

    fn parameter(&self, kind: Kind, key: &str, value: &Value) -> Result<Converted, Box<Finding>> {
        let plain = match (kind, value) {
            (Kind::Law, value) => return self.law(key, value),
            (Kind::Length, value) => self.quantity(Dimension::Length, key, value)?,
            (Kind::Stress, value) => self.quantity(Dimension::Stress, key, value)?,
            (Kind::Angle, value) => self.quantity(Dimension::Angle, key, value)?,
            (Kind::Dimensionless, Value::Number(_))
            | (Kind::Text, Value::String(_))
            | (Kind::Flag, Value::Bool(_)) => value.clone(),
            (Kind::Dimensionless, other) => {
                return Err(self.wrong_kind(key, "a number without unit or quotes", other));
            }
            (Kind::Text, other) => return Err(self.wrong_kind(key, "a word in quotes", other)),
            (Kind::Flag, other) => return Err(self.wrong_kind(key, "true or false", other)),
        };
        Ok(Converted {
            plain,
            shown: value.clone(),
        })
    }

    fn quantity(
        &self,
        dimension: Dimension,
        key: &str,
        value: &Value,
    ) -> Result<Value, Box<Finding>> {
        match quantity(value, &Expected::one(dimension)) {
            Ok(number) => Ok(number.into()),
            Err(problem) => Err(self.finding(key, Part::Value, *problem)),
        }
    }
}

/// Whether the key names a table inside a friction law that holds exactly one entry: a nested law, or a choice such as `kernel`.
pub(super) fn is_choice(key: &str) -> bool {
    let mut segments = key.split('.');
    let (Some("contacts"), Some(_), Some("friction")) =
        (segments.next(), segments.next(), segments.next())
    else {
        return false;
    };
    let mut law: Option<&LawInfo> = None;
    let mut path = String::new();
    for segment in segments {
        let Some(info) = law else {
            law = find(segment);
            if law.is_none() {
                return false;
            }
            continue;
        };
        if segment.parse::<usize>().is_ok() {
            path.push_str("[]");
        } else {
            path = child(&path, segment);
        }
        let is_law =
            |parameter: &ParameterInfo| parameter.path == path && parameter.dimension == Kind::Law;
        if info.parameters.iter().any(is_law) {
            law = None;
            path.clear();
        }
    }
    law.is_none_or(|info| holds_one(info, &path))
}

/// A default of the registry, which is TOML.
fn written(default: &str) -> Value {
    let table: Result<toml::Table, _> = toml::from_str(&format!("value = {default}"));
    table
        .ok()
        .and_then(|mut table| table.remove("value"))
        .and_then(|value| serde_json::to_value(value).ok())
        .unwrap_or_else(|| Value::String(default.to_owned()))
}

#[cfg(test)]
mod tests;
