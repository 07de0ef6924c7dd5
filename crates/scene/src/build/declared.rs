//! What the declarations of keys say: ranges, and keys of which one is given.

use serde_json::Value;

use super::Builder;
use crate::declaration::{Exclusive, each};
use crate::diagnostic::SceneProblem;
use crate::document::{Part, child};
use crate::keys::tables;

impl Builder<'_> {
    /// Checks every key that is written against its declaration.
    pub(super) fn declared(&mut self) {
        let document = self.document;
        for table in tables() {
            for (place, given) in table.written(&document.root) {
                if let Some(exclusive) = table.exclusive {
                    self.one_of(&place, given, exclusive);
                }
                for key in table.keys {
                    let (Some(range), Some(value)) = (key.range, given.get(key.name)) else {
                        continue;
                    };
                    let place = child(&place, key.name);
                    let values = if range.is_of_lists() {
                        vec![(place, value)]
                    } else {
                        each(place, value)
                    };
                    for (place, value) in values {
                        if let Some((text, allowed)) = range.refusal(value) {
                            self.out_of_range(&place, &text, allowed);
                        }
                    }
                }
            }
        }
    }

    fn one_of(&mut self, place: &str, given: &Value, exclusive: Exclusive) {
        let names = exclusive.names();
        let is_absent = |name: &str| {
            matches!(
                given.get(name),
                None | Some(Value::Null | Value::Bool(false))
            )
        };
        let found: Vec<&str> = (names.iter().copied())
            .filter(|name| !is_absent(name))
            .collect();
        let found = match found.as_slice() {
            [_] => return,
            [] if exclusive.optional => return,
            [] => "none".to_owned(),
            [_, _] if names.len() == 2 => "both".to_owned(),
            several => several.join(", "),
        };
        let problem = SceneProblem::OneOf {
            table: place.to_owned(),
            choices: exclusive.choices.to_owned(),
            found,
        };
        self.report(place, Part::Key, problem);
    }
}
