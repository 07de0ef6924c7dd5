//! Records: named values, of a case, of a row of a table, of a curve to draw.
//!
//! A tree of nodes says many records at once. A node's `each` lists axes, tables of lists of the same length whose values go together; the
//! node stands for the full product of its axes, the last running fastest. Nodes below it inherit its keys, and lists under `set` are
//! joined. `<key>` in a text is replaced by the value of that key. For quick plans an axis names the places that it keeps in `quick`, and
//! a node may have `quick = false`.

use stickslip::host::HOST;
use stickslip::results::Results;
use stickslip::run::run;
use stickslip::scene::Scene;
use stickslip_report::color::Color;
use toml::{Table, Value};

use super::{TaskError, root};

/// All records of a list of nodes whose children are under the key `below`.
pub(crate) fn expanded(
    nodes: &[Value],
    inherited: &Table,
    below: &str,
    quick: bool,
) -> Result<Vec<Table>, TaskError> {
    let mut all = Vec::new();
    for node in nodes {
        let node = node.as_table().ok_or("a node is no table")?;
        if quick && node.get("quick").and_then(Value::as_bool) == Some(false) {
            continue;
        }
        let mut records = vec![joined(inherited, node, &["each", "quick", below])];
        for axis in list(node, "each") {
            let axis = axis.as_table().ok_or("an axis is no table")?;
            let steps = steps(axis, quick)?;
            records = (records.iter())
                .flat_map(|record| steps.iter().map(|step| joined(record, step, &[])))
                .collect();
        }
        match node.get(below) {
            Some(_) => {
                for record in &records {
                    all.extend(expanded(list(node, below), record, below, quick)?);
                }
            }
            None => all.extend(records.iter().map(resolved)),
        }
    }
    Ok(all)
}

/// The list under a key; empty if there is none.
pub(crate) fn list<'a>(table: &'a Table, key: &str) -> &'a [Value] {
    let list = table.get(key).and_then(Value::as_array);
    list.map_or(&[], Vec::as_slice)
}

/// The values along an axis.
fn steps(axis: &Table, quick: bool) -> Result<Vec<Table>, TaskError> {
    let own = || axis.iter().filter(|(key, _)| *key != "quick");
    let lengths = own().map(|(_, values)| values.as_array().map_or(0, Vec::len));
    let length = lengths.min().ok_or("an axis is empty")?;
    let kept = |place: &usize| {
        let named = |value: &Value| value.as_integer() == Some(*place as i64);
        !quick || !axis.contains_key("quick") || list(axis, "quick").iter().any(named)
    };
    let step = |place: usize| {
        own()
            .filter_map(|(key, values)| Some((key.clone(), values.get(place)?.clone())))
            .collect()
    };
    Ok((0..length).filter(kept).map(step).collect())
}

/// `record` with the keys of `further` in the place of its own, and joined lists under `set`.
fn joined(record: &Table, further: &Table, without: &[&str]) -> Table {
    let mut both = record.clone();
    for (key, value) in further {
        if without.contains(&key.as_str()) {
            continue;
        }
        let mut value = value.clone();
        if key == "set" {
            value = Value::Array([list(record, key), list(further, key)].concat());
        }
        both.insert(key.clone(), value);
    }
    both
}

/// The record with its own values in its texts, also in those that come in by that.
pub(crate) fn resolved(record: &Table) -> Table {
    const DEPTH: usize = 4;
    let mut record = record.clone();
    for _ in 0..DEPTH {
        let values = record.clone();
        record
            .iter_mut()
            .for_each(|(_, value)| substitute(value, &values));
    }
    record
}

fn substitute(value: &mut Value, values: &Table) {
    match value {
        Value::String(text) if text.contains('<') => {
            for (key, other) in values {
                let name = format!("<{key}>");
                if *text == name {
                    *value = other.clone();
                    return;
                }
                if text.contains(&name) {
                    *text = text.replace(&name, &written(other, ""));
                }
            }
        }
        Value::Array(all) => all.iter_mut().for_each(|own| substitute(own, values)),
        Value::Table(all) => all.iter_mut().for_each(|(_, own)| substitute(own, values)),
        _ => {}
    }
}

/// A value as tables and sentences have it; `format` is that of a number: `.2`, with a sign `+.2`, in percent `.0%`, with an exponent
/// `.1e`, as a power of ten where it is one `^`.
pub(crate) fn written(value: &Value, format: &str) -> String {
    let number = |value: f64| {
        if format == "^" {
            return power(value);
        }
        let value = if format.ends_with('%') {
            100.0 * value
        } else {
            value
        };
        let digits = format.trim_matches(['+', '%', '.', 'e']).parse::<usize>();
        let text = match digits {
            Err(_) => value.to_string(),
            Ok(digits) if format.ends_with('e') => format!("{value:.digits$e}"),
            Ok(digits) => format!("{value:.digits$}"),
        };
        let sign = if format.starts_with('+') && value >= 0.0 {
            "+"
        } else {
            ""
        };
        format!("{sign}{text}")
    };
    match value {
        Value::String(text) => text.clone(),
        Value::Float(value) => number(*value),
        Value::Integer(value) => number(*value as f64),
        Value::Array(all) if all.first().is_some_and(Value::is_str) => value.to_string(),
        Value::Array(all) => {
            let texts: Vec<String> = all.iter().map(|value| written(value, format)).collect();
            texts.join("; ")
        }
        other => other.to_string(),
    }
}

/// A power of ten, or the plain number: 10⁻³, −10⁻⁸, 0, 0.5.
fn power(value: f64) -> String {
    let exponent = value.abs().log10();
    let rounded = exponent.round();
    if value == 0.0 || (exponent - rounded).abs() > 1e-6 || (-1.5..1.5).contains(&rounded) {
        return format!("{value}").replace('-', "−");
    }
    let digits: String = format!("{rounded}")
        .chars()
        .map(|character| match character {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            // The superscripts of 0 and 4 to 9 follow one another.
            digit => char::from_u32(0x2070 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
        })
        .collect();
    format!("{}10{digits}", if value < 0.0 { "−" } else { "" })
}

/// The text under a key.
pub(crate) fn text<'a>(record: &'a Table, key: &str) -> Result<&'a str, TaskError> {
    let text = record.get(key).and_then(Value::as_str);
    Ok(text.ok_or_else(|| format!("no text '{key}'"))?)
}

/// The number that a formula names: a column, a quotient `a / b`, or a root of a sum of squares `a ⊕ b ⊕ c`.
pub(crate) fn number(record: &Table, formula: &str) -> Option<f64> {
    if let Some((above, below)) = formula.split_once(" / ") {
        return Some(number(record, above)? / number(record, below)?);
    }
    if formula.contains(" ⊕ ") {
        let parts = formula.split(" ⊕ ").map(|part| number(record, part));
        let squares: Option<f64> = parts.map(|part| part.map(|value| value * value)).sum();
        return squares.map(f64::sqrt);
    }
    float(record.get(formula)?)
}

/// The numbers of the list under a key.
pub(crate) fn numbers(record: &Table, key: &str) -> Vec<f64> {
    list(record, key).iter().filter_map(float).collect()
}

fn float(value: &Value) -> Option<f64> {
    value
        .as_float()
        .or_else(|| value.as_integer().map(|value| value as f64))
}

/// The number under a key that must be there.
pub(crate) fn needed(record: &Table, key: &str) -> Result<f64, TaskError> {
    Ok(number(record, key).ok_or_else(|| format!("no number '{key}'"))?)
}

/// Whether a record has the values that `wanted` names; a list names several. Numbers are equal to nine digits.
pub(crate) fn matches(record: &Table, wanted: &Table) -> bool {
    let alike = |own: &Value, other: &Value| match (float(own), float(other)) {
        (Some(a), Some(b)) => (a - b).abs() <= 1e-9 * a.abs().max(b.abs()),
        _ => own == other,
    };
    wanted.iter().all(|(key, value)| {
        let own = record.get(key);
        own.is_some_and(|own| match value {
            Value::Array(all) => all.iter().any(|value| alike(own, value)),
            value => alike(own, value),
        })
    })
}

/// A record's keys and values.
pub(crate) fn fields<const N: usize>(fields: [(&str, Value); N]) -> [(String, Value); N] {
    fields.map(|(key, value)| (key.to_owned(), value))
}

/// Places `[x, y]` as a value.
pub(crate) fn curve(points: impl IntoIterator<Item = [f64; 2]>) -> Value {
    points
        .into_iter()
        .map(|point| Value::from(point.to_vec()))
        .collect::<Vec<_>>()
        .into()
}

/// The results of the scene that a case names under `scene`, with the changes under `set`.
pub(crate) fn solved(case: &Table) -> Result<Results, TaskError> {
    Ok(run(&scene(case)?, &mut |_| {})?)
}

/// The scene of a case.
pub(crate) fn scene(case: &Table) -> Result<Scene, TaskError> {
    let changes = list(case, "set").iter().map(|value| written(value, ""));
    let changes: Vec<String> = changes.collect();
    Ok(Scene::from_file(
        &root().join(text(case, "scene")?),
        &changes,
        HOST,
    )?)
}

/// A colour from `#rrggbb`.
pub(super) fn color(text: &str) -> Result<Color, TaskError> {
    let digits = text
        .strip_prefix('#')
        .ok_or_else(|| format!("no colour: {text}"))?;
    let [_, red, green, blue] = u32::from_str_radix(digits, 16)?.to_be_bytes();
    Ok(Color::rgb(red, green, blue))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_ten_are_short() {
        let texts = [1e-8, -1e-3, 0.0, 1.0, 1e12, 0.25].map(power);
        assert_eq!(texts, ["10⁻⁸", "−10⁻³", "0", "1", "10¹²", "0.25"]);
    }

    #[test]
    fn nodes_stand_for_products_and_hand_their_keys_down() {
        let text = "each = [{ a = [1, 2, 3], quick = [0, 2] }]\nset = ['x=<a>']\n\
                    [[cases]]\nname = '<a> and <b>'\neach = [{ b = [0.5, 1.0] }]\nset = ['y=<b>']";
        let node: Table = toml::from_str(text).expect("it reads");
        let of = |quick| {
            let found = expanded(&[Value::Table(node.clone())], &Table::new(), "cases", quick);
            found.expect("it is a tree")
        };
        assert_eq!((of(false).len(), of(true).len()), (6, 4));
        let last = of(true).pop().expect("there are some");
        assert_eq!(last["name"].as_str(), Some("3 and 1"));
        assert_eq!(written(&last["set"], ""), r#"["x=3", "y=1"]"#);
    }
}
