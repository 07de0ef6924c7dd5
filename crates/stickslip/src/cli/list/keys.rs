//! Every key of scenes, as it is declared.

use std::fmt::Write as _;

use serde_json::{Value, json};
use stickslip_scene::declaration::Key;
use stickslip_scene::keys::tables;

/// The loads that a scene may hold: name and meaning.
pub(super) fn loads() -> impl Iterator<Item = (&'static str, &'static str)> {
    let keys = tables()
        .filter(|table| table.path == "loads")
        .flat_map(|table| table.keys);
    let kinds = keys.filter(|key| key.assignment().is_none());
    kinds.map(|key| (key.name, key.meaning))
}

pub(super) fn text() -> String {
    let mut text = "Keys of scenes; NAME stands for a name of one's own\n".to_owned();
    for table in tables() {
        let title = if table.path.is_empty() {
            "top level"
        } else {
            table.path
        };
        // Writing into a string does not fail.
        let _ = writeln!(text, "\n  {title}");
        for key in table.keys {
            let _ = writeln!(text, "    {}\n        {}", shown(key), key.meaning);
        }
    }
    text
}

/// Name or example, type, units and default.
fn shown(key: &Key) -> String {
    let start = key.assignment().unwrap_or_else(|| key.name.to_owned());
    let units = match key.kind.units() {
        units if units.is_empty() => units,
        units => format!(" in {units}"),
    };
    let default = match key.default {
        _ if key.is_required() => key.default.to_owned(),
        default => format!("default {default}"),
    };
    format!("{start}  ({}{units}; {default})", key.type_text()).replace('`', "")
}

pub(super) fn value() -> Value {
    let rows = tables().flat_map(|table| table.keys.iter().map(move |key| (table.path, key)));
    rows.map(|(table, key)| {
        json!({
            "table": table,
            "key": key.name,
            "type": key.type_text(),
            "units": key.kind.units(),
            "default": key.default,
            "example": key.assignment(),
            "meaning": key.meaning,
        })
    })
    .collect()
}
