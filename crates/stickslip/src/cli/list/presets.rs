//! Presets of tables of measured displacements.

use serde_json::{Value, json};
use stickslip_hybrid::data::{Format, Places};

fn presets() -> [(&'static str, &'static str, Format); 3] {
    [
        (
            "plain",
            "a table of places and displacements (default)",
            Format::plain(),
        ),
        ("dice", "text output of DICe", Format::dice()),
        ("mudic", "a table of muDIC's fields", Format::mudic()),
    ]
}

fn columns(format: &Format) -> Vec<(&'static str, String)> {
    let [x, y] = format.places.clone();
    let [u, v] = format.displacements.clone().map(Option::unwrap_or_default);
    let mut columns = vec![("x", x), ("y", y), ("u", u), ("v", v)];
    columns.extend(format.flag.clone().map(|flag| ("flag", flag)));
    columns
}

pub(super) fn text() -> String {
    let mut rows = Vec::new();
    for (name, summary, format) in presets() {
        let unit = if format.pixels {
            "in pixels: origin must be stated"
        } else {
            "in any length: scale says which"
        };
        let moved = if format.moved == Places::Deformed {
            "; places are those after the deformation"
        } else {
            ""
        };
        let names: Vec<String> = columns(&format)
            .into_iter()
            .map(|(key, column)| format!("{key} = {column}"))
            .collect();
        rows.push((name.to_owned(), format!("{summary}; {unit}{moved}")));
        rows.push((String::new(), names.join(", ")));
    }
    super::table(
        "Presets of measured tables, for states.N.table.preset; columns = { u = \"…\" } names others",
        rows.into_iter(),
    )
}

pub(super) fn value() -> Value {
    let preset = |(name, summary, format): (&str, &str, Format)| {
        let columns: serde_json::Map<String, Value> = columns(&format)
            .into_iter()
            .map(|(key, column)| (key.to_owned(), column.into()))
            .collect();
        json!({ "name": name, "summary": summary, "columns": columns, "pixels": format.pixels })
    };
    presets().into_iter().map(preset).collect()
}
