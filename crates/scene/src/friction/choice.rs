//! Tables that hold one entry, named after a choice, with its parameters.

use serde_json::{Map, Value};

use crate::diagnostic::{Finding, SceneProblem};
use crate::document::{Document, Part, child};
use crate::read::described;

/// What may be chosen by its name, and the words for it.
pub(crate) struct Choice<'a, T> {
    /// "friction law".
    pub(crate) what: &'a str,
    /// Whose the parameters are: "law".
    pub(crate) owner: &'a str,
    /// A table that would do.
    pub(crate) example: &'a str,
    /// All of them by their names.
    pub(crate) known: Vec<(&'static str, T)>,
}

impl<T: Copy> Choice<'_, T> {
    /// What the table `table` at `key` chooses, and its parameters.
    pub(crate) fn of<'v>(
        &self,
        document: &Document,
        key: &str,
        table: &'v Value,
    ) -> Result<(T, &'v Map<String, Value>), Box<Finding>> {
        let refused = |key: &str, part, problem| Box::new(document.finding(key, part, problem));
        let wrong_kind = |key: &str, expected: String, found: &Value| {
            let problem = SceneProblem::wrong_kind(expected, described(found));
            refused(key, Part::Value, problem)
        };
        let names = || self.known.iter().map(|&(name, _)| name);
        let Value::Object(map) = table else {
            let expected = format!("a {}, for example {}", self.what, self.example);
            return Err(wrong_kind(key, expected, table));
        };
        let mut entries = map.iter();
        let (Some((name, parameters)), None) = (entries.next(), entries.next()) else {
            let choices = names().collect::<Vec<_>>().join(", ");
            let problem = SceneProblem::one_of(key, choices, map.keys().map(String::as_str));
            return Err(refused(key, Part::Key, problem));
        };
        let key = child(key, name);
        let Some(&(_, chosen)) = self.known.iter().find(|(known, _)| known == name) else {
            let problem = SceneProblem::unknown_name(&format!("a {}", self.what), name, names());
            return Err(refused(&key, Part::Key, problem));
        };
        match parameters {
            Value::Object(parameters) => Ok((chosen, parameters)),
            other => {
                let expected = format!("a table of the {}'s parameters", self.owner);
                Err(wrong_kind(&key, expected, other))
            }
        }
    }
}
