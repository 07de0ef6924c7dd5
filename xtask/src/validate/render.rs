//! The table, for the terminal and as Markdown.

use stickslip_report::table::{Column, Table};

use super::Outcome;
use super::check::Verdict;

/// One section per case, with its sources.
pub(crate) fn text(outcomes: &[Outcome]) -> String {
    let columns = [
        "quantity",
        "computed",
        "reference",
        "error",
        "bound",
        "verdict",
    ];
    let mut text = String::new();
    for outcome in outcomes.iter().filter(|outcome| !outcome.checks.is_empty()) {
        let columns = columns.map(|name| Column::new(name, "")).to_vec();
        let mut table = Table::new(caption(outcome), columns);
        for check in &outcome.checks {
            table.push([
                &check.quantity,
                &check.computed,
                &check.reference,
                &check.error,
                &check.bound,
                check.verdict.text(),
            ]);
        }
        text.push_str(&table.to_text(None));
        text.push('\n');
    }
    text + &summary(outcomes) + "\n"
}

/// Title and sources, each once.
fn caption(outcome: &Outcome) -> String {
    let mut sources: Vec<&str> = Vec::new();
    for check in &outcome.checks {
        if !check.source.is_empty() && !sources.contains(&check.source.as_str()) {
            sources.push(&check.source);
        }
    }
    if sources.is_empty() {
        outcome.title.clone()
    } else {
        format!("{} ({})", outcome.title, sources.join("; "))
    }
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
    let mut page = String::from(INTRODUCTION);
    let columns = [
        "quantity",
        "reference",
        "source",
        "computed",
        "error",
        "bound",
        "verdict",
    ];
    for outcome in outcomes.iter().filter(|outcome| !outcome.checks.is_empty()) {
        page += "\n## ";
        page += &outcome.title;
        page += "\n\n";
        page += &row(columns);
        page += &row(["---"; 7]);
        for check in &outcome.checks {
            page += &row([
                &check.quantity,
                &check.reference,
                &check.source,
                &check.computed,
                &check.error,
                &check.bound,
                check.verdict.text(),
            ]);
        }
    }
    page + "\n" + &summary(outcomes) + ".\n"
}

const INTRODUCTION: &str = "\
# Validation

Written by `cargo xtask validate --write`, the last section with `--mutate`; every number is measured. Axes and signs are those of the scenes. An error is \
computed minus reference. *Shown* quantities have no bound. h is the distance of corner nodes, and \"more than 2h from\" a place \
means all nodes farther from it than that. The references are the sources named; their tables are in `crates/laboratory/data`, with boundary \
data in `scenes/data`.
";

fn row(cells: [&str; 7]) -> String {
    format!(
        "| {} |\n",
        cells.map(|cell| cell.replace('|', "\\|")).join(" | ")
    )
}
