//! The problem as the scene states it, in the scene's own words and units: enough to check and repeat it.

use stickslip_report::page::{Block, Figure, Section};
use stickslip_report::table::Table;
use toml::Value;

use super::figures::Drawing;
use stickslip_results::Results;

/// The section of the page; `None` of results without a scene.
pub(super) fn section(results: &Results, sketches: Vec<Drawing>) -> Option<Section> {
    let mut scene: toml::Table = toml::from_str(&results.scene).ok()?;
    if scene.is_empty() {
        return None;
    }
    state_clearances(&mut scene, results);
    let tables = [
        named(&scene, "bodies", "Bodies", "body | keys"),
        named(&scene, "materials", "Materials", "material | keys"),
        named(&scene, "plies", "Plies", "ply | keys"),
        listed(
            &scene,
            "contacts",
            "Contacts",
            "contact | first | second | radial clearance | friction",
            &["name", "first", "second", CLEARANCE, "friction"],
        ),
        named(&scene, "fasteners", "Fasteners", "fastener | keys"),
        listed(&scene, "supports", "Supports", "on", &["on"]),
        listed(&scene, "platens", "Platens", "on", &["on"]),
        listed(&scene, "loads", "Loads", "load | on", &["name", "on"]),
        whole(&scene, &["analysis", "mesh"], "Solution"),
    ];
    let figure = |own: Drawing| Figure::new(own.picture, own.caption, own.name);
    let section =
        (sketches.into_iter().map(figure)).fold(Section::new("The problem"), Section::with);
    let section = (tables.into_iter().flatten()).fold(section, Section::with);
    let code = Block::Code {
        title: "The scene with all defaults, as scene.toml in this folder".to_owned(),
        text: results.scene.clone(),
    };
    Some(section.with(code))
}

/// What is beside the keys of a contact.
const CLEARANCE: &str = "clearance";

/// Puts the radial clearance of two circles beside the keys of their contact.
fn state_clearances(scene: &mut toml::Table, results: &Results) {
    let contacts = scene.get_mut("contacts").and_then(Value::as_array_mut);
    let contacts = contacts.into_iter().flatten();
    // Edges of contacts are in the order of the contacts.
    let edges = results.edges.iter().filter(|edge| edge.contact);
    for (contact, edge) in contacts.filter_map(Value::as_table_mut).zip(edges) {
        let show = |own: f64| results.units.length.show(own.abs());
        let text = match edge.clearance {
            None => "–".to_owned(),
            Some(own) if own < 0.0 => format!("interference {}", show(own)),
            Some(own) => show(own),
        };
        contact.insert(CLEARANCE.to_owned(), Value::String(text));
    }
}

/// A table of the entries of the table `key`, by name.
fn named(scene: &toml::Table, key: &str, caption: &str, headings: &str) -> Option<Table> {
    let entries = scene.get(key)?.as_table()?;
    let row = |(name, value): (&String, &Value)| [name.clone(), assignments(value, &|_| false)];
    let rows = entries.iter().map(row);
    (!entries.is_empty()).then(|| Table::headed(caption, headings).with_rows(rows))
}

/// A table of the entries of the list `key`, whose keys `columns` have columns of their own.
fn listed(
    scene: &toml::Table,
    key: &str,
    caption: &str,
    headings: &str,
    columns: &[&str],
) -> Option<Table> {
    let entries = scene.get(key)?.as_array()?;
    let headings = format!("{headings} | keys");
    let is_own = |key: &str| {
        let is_in = |own: &&str| key == *own || key.starts_with(&format!("{own}."));
        columns.iter().any(is_in)
    };
    let row = |value: &Value| {
        let own = columns
            .iter()
            .map(|key| value.get(key).map_or_else(String::new, plain));
        own.chain([assignments(value, &is_own)]).collect::<Vec<_>>()
    };
    let rows = entries.iter().map(row);
    (!entries.is_empty()).then(|| Table::headed(caption, &headings).with_rows(rows))
}

/// One row for each of the tables `keys`.
fn whole(scene: &toml::Table, keys: &[&str], caption: &str) -> Option<Table> {
    let rows = keys.iter().filter_map(|key| {
        let text = assignments(scene.get(*key)?, &|_| false);
        (!text.is_empty()).then(|| [(*key).to_owned(), text])
    });
    let rows: Vec<_> = rows.collect();
    (!rows.is_empty()).then(|| Table::headed(caption, "table | keys").with_rows(rows))
}

/// All keys of `value` but those that are `left_out`, those of tables inside with dots: `disk.radius = 5 mm, thickness = 2 mm`.
fn assignments(value: &Value, left_out: &dyn Fn(&str) -> bool) -> String {
    let mut all = Vec::new();
    flatten("", value, &mut all);
    all.retain(|(key, _)| !left_out(key));
    let each = all.iter().map(|(key, value)| format!("{key} = {value}"));
    each.collect::<Vec<_>>().join(", ")
}

fn flatten(key: &str, value: &Value, all: &mut Vec<(String, String)>) {
    match value {
        Value::Table(table) => {
            for (name, value) in table {
                let below = if key.is_empty() {
                    name.clone()
                } else {
                    format!("{key}.{name}")
                };
                flatten(&below, value, all);
            }
        }
        value => all.push((key.to_owned(), plain(value))),
    }
}

/// A value as text, without quotes.
fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Array(list) => {
            let each: Vec<String> = list.iter().map(plain).collect();
            format!("({})", each.join(", "))
        }
        Value::Table(_) => assignments(value, &|_| false),
        value => value.to_string(),
    }
}
