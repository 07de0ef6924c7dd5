//! A friction law with free parameters.

use serde_json::Value;
use stickslip_friction::FrictionLaw;
use stickslip_hybrid::calibrate::Parameter;

use super::LawsError;
use crate::diagnostic::{SceneProblem, nearest};
use crate::experiment::plan::LawPlan;

/// Ranges with ends so far apart are divided evenly in the logarithm.
const DECADES: f64 = 20.0;

/// A friction law of any registered kind, some of whose parameters are free.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Its name in results.
    pub name: String,
    /// Kind of the law: its name in files.
    pub kind: String,
    /// Free parameters.
    pub parameters: Vec<Parameter>,
    /// The law in plain numbers, as it is read.
    table: Value,
    /// Where the free parameters stand in it (RFC 6901).
    pointers: Vec<String>,
}

impl Candidate {
    /// The law of a plan.
    ///
    /// # Errors
    /// The key below the law's table in the file, and what is wrong with it: a parameter that the law does not have.
    pub fn new(plan: &LawPlan) -> Result<Self, (String, SceneProblem)> {
        let free = plan
            .free
            .iter()
            .map(|free| (free.name.as_str(), free.bounds));
        Self::of_law(&plan.name, plan.law.as_ref(), &free.collect::<Vec<_>>())
            .map_err(|(name, problem)| (format!("free.{name}"), problem))
    }

    /// `law` with the parameters `free`, which keep its values nowhere: their names, with dots into tables, and ranges in base units.
    ///
    /// # Errors
    /// The name that the law does not have, and the names that it has.
    pub fn of_law(
        name: &str,
        law: &dyn FrictionLaw,
        free: &[(&str, [f64; 2])],
    ) -> Result<Self, (String, SceneProblem)> {
        let refused = |what: &str, message: String| {
            let law = law.name().to_owned();
            (what.to_owned(), SceneProblem::Friction { law, message })
        };
        let table = serde_json::to_value(law).map_err(|error| refused("", error.to_string()))?;
        let own = table.get(law.name()).unwrap_or(&Value::Null);
        let known = numbers_in(own, "");
        let mut pointers = Vec::new();
        let mut parameters = Vec::new();
        for &(path, range) in free {
            if !known.iter().any(|own| own == path) {
                let problem = SceneProblem::UnknownKey {
                    key: path.to_owned(),
                    nearest: nearest(path, known.iter().map(String::as_str)).map(str::to_owned),
                    known: known.clone(),
                };
                return Err((path.to_owned(), problem));
            }
            pointers.push(format!("/{}/{}", law.name(), path.replace('.', "/")));
            let parameter = Parameter::new(path, range);
            let [low, high] = range;
            parameters.push(if low > 0.0 && high / low >= DECADES {
                parameter.logarithmic()
            } else {
                parameter
            });
        }
        Ok(Self {
            name: name.to_owned(),
            kind: law.name().to_owned(),
            parameters,
            table,
            pointers,
        })
    }

    /// The law with these values of the free parameters, in base units.
    ///
    /// # Errors
    /// [`LawsError::Law`] where the law refuses them, such as a dynamic coefficient above the static one.
    pub fn law(&self, values: &[f64]) -> Result<Box<dyn FrictionLaw>, LawsError> {
        let mut table = self.table.clone();
        for (pointer, &value) in self.pointers.iter().zip(values) {
            if let Some(entry) = table.pointer_mut(pointer) {
                *entry = value.into();
            }
        }
        serde_json::from_value(table).map_err(|error| LawsError::Law(error.to_string()))
    }
}

/// Paths of all numbers below `value`.
fn numbers_in(value: &Value, path: &str) -> Vec<String> {
    let below = |name: &str| match path {
        "" => name.to_owned(),
        path => format!("{path}.{name}"),
    };
    match value {
        Value::Number(_) => vec![path.to_owned()],
        Value::Object(map) => (map.iter())
            .flat_map(|(name, value)| numbers_in(value, &below(name)))
            .collect(),
        Value::Array(list) => (list.iter().enumerate())
            .flat_map(|(index, value)| numbers_in(value, &below(&index.to_string())))
            .collect(),
        _ => Vec::new(),
    }
}
