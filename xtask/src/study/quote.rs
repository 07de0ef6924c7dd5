//! Sentences with numbers from tables: findings of a run, and a guard of the numbers that a page quotes.
//!
//! ```text
//! {column}  {column:.2}  {a / b:+.1%}            of the row, or of the first
//! {count}  {mean column:.3}  {deviation column:.3}  {min column:.1}  {max column:.1}      of all rows
//! {row column:.2}                                  of all rows, with | between them
//! ```

use serde::Deserialize;
use toml::{Table, Value};

use super::record::{matches, number, written};
use super::table::Tables;

/// A sentence that is filled in with numbers.
#[derive(Debug, Deserialize)]
pub(crate) struct Quote {
    table: String,
    /// Which rows.
    #[serde(default, rename = "where")]
    wanted: Table,
    /// Only the row at which a column is least or largest: `min column`, `max column`.
    at: Option<String>,
    /// One sentence for every row.
    #[serde(default)]
    every: bool,
    text: String,
    /// Bounds of the first number of the sentence, on which the study insists.
    within: Option<[f64; 2]>,
}

impl Quote {
    /// The sentences by the tables of a run; none without its table, or where no row is wanted.
    pub(crate) fn sentences(&self, tables: &Tables) -> Vec<String> {
        let Some(all) = tables.get(&self.table) else {
            return Vec::new();
        };
        let mut rows: Vec<&Table> = all
            .iter()
            .filter(|row| matches(row, &self.wanted))
            .collect();
        if let Some((which, column)) = self.at.as_deref().and_then(|at| at.split_once(' ')) {
            let factor = if which == "max" { -1.0 } else { 1.0 };
            let key = |row: &&Table| number(row, column).map_or(f64::INFINITY, |v| factor * v);
            rows = rows
                .into_iter()
                .min_by(|a, b| key(a).total_cmp(&key(b)))
                .into_iter()
                .collect();
        }
        if self.every {
            return rows.iter().map(|row| filled(&self.text, &[row])).collect();
        }
        if rows.is_empty() && self.within.is_none() {
            return Vec::new();
        }
        vec![filled(&self.text, &rows)]
    }

    /// What is wrong with a sentence: its first number is outside the bounds.
    pub(crate) fn fault(&self, sentence: &str) -> Option<String> {
        let [low, high] = self.within?;
        let digits = |c: char| !c.is_ascii_digit() && c != '.';
        let mut numbers = sentence
            .split(digits)
            .filter_map(|part| part.parse::<f64>().ok());
        let first = numbers.next();
        let held = first.is_some_and(|value| (low..=high).contains(&value));
        (!held).then(|| format!("not within {low} to {high}: {sentence}"))
    }
}

/// The text with the numbers of `rows` in its placeholders.
pub(crate) fn filled(text: &str, rows: &[&Table]) -> String {
    let mut parts = text.split('{');
    let mut whole = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (inside, rest) = part.split_once('}').unwrap_or((part, ""));
        let (formula, format) = inside.split_once(':').unwrap_or((inside, ""));
        if let Some(column) = formula.strip_prefix("row ") {
            let cells = rows.iter().filter_map(|row| value(column, &[row]));
            let cells: Vec<String> = cells.map(|value| written(&value, format)).collect();
            whole += &cells.join(" | ");
        } else {
            let value = value(formula, rows);
            whole += &value.map_or_else(|| "–".to_owned(), |value| written(&value, format));
        }
        whole += rest;
    }
    whole
}

fn value(formula: &str, rows: &[&Table]) -> Option<Value> {
    if formula == "count" {
        return Some(Value::Integer(rows.len() as i64));
    }
    let (name, column) = formula.split_once(' ').unwrap_or(("", formula));
    let all: Vec<f64> = rows.iter().filter_map(|row| number(row, column)).collect();
    let mean = || all.iter().sum::<f64>() / all.len() as f64;
    let reduced = match name {
        "mean" => mean(),
        "deviation" => {
            let squares: f64 = all.iter().map(|value| (value - mean()).powi(2)).sum();
            (squares / (all.len() as f64 - 1.0)).sqrt()
        }
        "min" => all.iter().copied().fold(f64::INFINITY, f64::min),
        "max" => all.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        _ => {
            let first = rows.first()?;
            let own = number(first, formula).map(Value::Float);
            return own.or_else(|| first.get(formula).cloned());
        }
    };
    Some(Value::Float(reduced))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn placeholders_name_columns_quotients_and_reductions() {
        let row = |a: f64, b: f64| {
            Table::from_iter([("a".to_owned(), a.into()), ("b".to_owned(), b.into())])
        };
        let rows = [row(1.0, 4.0), row(3.0, 5.0)];
        let rows: Vec<&Table> = rows.iter().collect();
        let text = "{count}, {a}, {a / b:.2}, {a / b:+.0%}, {mean a:.1}, {deviation a:.3}, {min b}, {max b}, {c}, {a ⊕ b:.3}, {row a:.1}";
        assert_eq!(
            filled(text, &rows),
            "2, 1, 0.25, +25, 2.0, 1.414, 4, 5, –, 4.123, 1.0 | 3.0"
        );
    }

    #[test]
    fn bounds_are_those_of_the_first_number() {
        let quote: Quote =
            toml::from_str("table = \"t\"\ntext = \"{count} of 3\"\nwithin = [0, 1]")
                .expect("it reads");
        let mut tables = Tables::new();
        assert_eq!(quote.sentences(&tables), [""; 0]);
        tables.insert("t".into(), Vec::new());
        assert_eq!(quote.sentences(&tables), ["0 of 3"]);
        assert_eq!(quote.fault("0 of 3"), None);
        tables.insert("t".into(), vec![Table::new(); 2]);
        assert!(quote.fault(&quote.sentences(&tables)[0]).is_some());
    }
}
