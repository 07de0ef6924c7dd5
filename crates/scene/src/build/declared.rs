//! What the declarations of keys say: ranges, and keys of which one is given.

use serde_json::Value;

use super::Builder;
use crate::declaration::{Exclusive, Key, outside, tables_at};
use crate::diagnostic::SceneProblem;
use crate::document::Part;
use crate::keys::tables;

impl Builder<'_> {
    /// Checks every key that is written against its declaration.
    pub(super) fn declared(&mut self) {
        let document = self.document;
        for table in tables() {
            for (place, given) in tables_at(table.path, &document.root) {
                if let Some(exclusive) = table.exclusive {
                    self.one_of(&place, given, exclusive);
                }
                let ranges = table.keys.iter().filter_map(Key::ranged);
                for [key, value, allowed] in outside(&place, given, ranges) {
                    self.out_of_range(&key, &value, allowed);
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
            [_, _] if names.len() == 2 => vec!["both"],
            _ => found,
        };
        let problem = SceneProblem::one_of(place, exclusive.choices, found);
        self.report(place, Part::Key, problem);
    }
}
