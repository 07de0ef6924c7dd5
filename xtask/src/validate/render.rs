//! The table, for the terminal and as Markdown.

use stickslip_report::table::{Column, Table};

use super::Outcome;
use super::check::{Check, Verdict};

const COLUMNS: [&str; 8] = [
    "case", "quantity", "reference", "source", "computed", "error", "bound", "verdict",
];

/// Aligned text.
pub(crate) fn text(outcomes: &[Outcome]) -> String {
    let columns = COLUMNS.map(|name| Column::new(name, "")).to_vec();
    let mut table = Table::new("", columns);
    for outcome in outcomes {
        for (index, check) in outcome.checks.iter().enumerate() {
            let title = if index == 0 { outcome.title } else { "" };
            let mut row = vec![title.to_owned()];
            row.extend(cells(check));
            table.push(row);
        }
    }
    table.note(summary(outcomes)).to_text(None)
}

fn cells(check: &Check) -> [String; 7] {
    [
        check.quantity.clone(),
        check.reference.clone(),
        check.source.clone(),
        check.computed.clone(),
        check.error.clone(),
        check.bound.clone(),
        check.verdict.text().to_owned(),
    ]
}

fn summary(outcomes: &[Outcome]) -> String {
    let count = |verdict: Verdict| {
        let all = outcomes.iter().flat_map(|outcome| &outcome.checks);
        all.filter(|check| check.verdict == verdict).count()
    };
    format!(
        "{} pass, {} fail, {} shown without a bound",
        count(Verdict::Pass),
        count(Verdict::Fail),
        count(Verdict::Shown)
    )
}

/// A page with one table per case.
pub(crate) fn markdown(outcomes: &[Outcome]) -> String {
    let mut page = String::from(
        "# Validation\n\nWritten by `cargo xtask validate --write`; every number is measured. Signs, units and axes are those of the \
         scenes. An error is computed minus reference. *Shown* quantities have no bound. Quantities \"more than 2h from\" a place are \
         taken at all nodes farther from it than two node distances. References: the sources named, with the tables in \
         `xtask/data` and `scenes/data`.\n",
    );
    for outcome in outcomes {
        page.push_str(&format!("\n## {}\n\n", outcome.title));
        page.push_str(&row(&COLUMNS[1..].iter().map(ToString::to_string).collect::<Vec<_>>()));
        page.push_str(&row(&["---"; 7].map(String::from)));
        for check in &outcome.checks {
            page.push_str(&row(&cells(check)));
        }
    }
    page.push_str(&format!("\n{}.\n", summary(outcomes)));
    page
}

fn row(cells: &[String]) -> String {
    let escaped: Vec<String> = cells.iter().map(|cell| cell.replace('|', "\\|")).collect();
    format!("| {} |\n", escaped.join(" | "))
}
