//! How often each outcome occurred.

use stickslip_report::table::{Column, Table};

use super::outcome::Outcome;
use super::row::Row;
use crate::study::record::fields;

/// The outcomes of each method as text, "3 solved, 1 cycled", in the order of first occurrence.
fn counts(rows: &[Row]) -> Vec<(&'static str, String)> {
    let mut methods: Vec<&'static str> = Vec::new();
    for row in rows {
        if !methods.contains(&row.method) {
            methods.push(row.method);
        }
    }
    let listed = |method: &'static str| {
        let count = |outcome: &Outcome| {
            let own = rows.iter().filter(|row| row.method == method);
            let count = own.filter(|row| row.outcome == *outcome).count();
            (count > 0).then(|| format!("{count} {}", outcome.name()))
        };
        let parts: Vec<String> = Outcome::ALL.iter().filter_map(count).collect();
        (method, parts.join(", "))
    };
    methods.into_iter().map(listed).collect()
}

/// The table of outcomes for the terminal.
pub(super) fn text(title: &str, rows: &[Row]) -> String {
    let columns = ["method", "outcomes"].map(|name| Column::new(name, ""));
    let mut table = Table::new(title, columns.to_vec());
    for (method, outcomes) in counts(rows) {
        table.push([method.to_owned(), outcomes]);
    }
    table.to_text(None) + "\n"
}

/// The same as rows of a table.
pub(super) fn records(study: &'static str, rows: &[Row]) -> impl Iterator<Item = toml::Table> {
    counts(rows).into_iter().map(|(method, outcomes)| {
        let own = fields([
            ("study", study.into()),
            ("method", method.into()),
            ("outcomes", outcomes.into()),
        ]);
        toml::Table::from_iter(own)
    })
}
