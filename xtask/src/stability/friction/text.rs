//! What the study of friction says in words.

use super::{CASES, Entry, Fact, PIN, PUNCH, PUSHED, STUCK_PIN, STUCK_PUNCH, WEDGED};
use crate::stability::methods::CHAIN;
use crate::stability::outcome::Outcome;
use crate::stability::row::Row;

pub(super) fn remarks(
    rows: &[Row],
    facts: &[Entry],
    dividers: &[(String, f64, String)],
) -> Vec<String> {
    let mut remarks = vec![bounds(facts, dividers)];
    remarks
        .extend([WEDGED, STUCK_PUNCH, PUNCH, PIN, STUCK_PIN].map(|case| wedged(rows, facts, case)));
    remarks.push(nearest(rows, facts));
    for method in ["status iteration", "Tresca fixed point"] {
        let failing =
            |row: &&Row| row.method == method && row.case == PIN && !row.outcome.is_answer();
        let first = rows.iter().filter(failing).map(|row| row.value);
        if let Some(mu) = first.reduce(f64::min) {
            remarks.push(format!(
                "On the pin the {method} first fails at μ = {mu:.1}."
            ));
        }
    }
    let bound = |case: &str| {
        let own = dividers.iter().find(|(of, _, _)| of == case);
        own.map_or(f64::INFINITY, |(_, mu, _)| *mu)
    };
    let several = |row: &&Row| row.outcome == Outcome::Other && row.value < bound(&row.case);
    let below = rows.iter().filter(several).count();
    remarks.push(format!(
        "Second solutions below the bound or its estimate: {below}."
    ));
    remarks
}

/// The bounds that no μ reaches, and how far the estimates vary with μ.
fn bounds(facts: &[Entry], dividers: &[(String, f64, String)]) -> String {
    let range = |case: &str| {
        let own = facts.iter().filter(|(of, _, _)| *of == case);
        let bounds: Vec<f64> = own.filter_map(|(_, _, fact)| fact.bound).collect();
        let low = bounds.iter().copied().reduce(f64::min)?;
        Some((low, bounds.into_iter().fold(low, f64::max)))
    };
    let estimated = CASES
        .into_iter()
        .filter(|case| ![PUSHED, WEDGED].contains(case));
    let list: Vec<String> = estimated
        .filter_map(|case| {
            let (low, high) = range(case)?;
            let reached = dividers.iter().any(|(of, _, _)| of == case);
            let rest = if reached { "" } else { ", reached by no μ" };
            Some(format!("{case}: {low:.2} to {high:.2}{rest}"))
        })
        .collect();
    format!(
        "The bound of uniqueness is estimated at each μ, as the least of all steps ({}).",
        list.join("; ")
    )
}

/// From which μ on a case holds without load: by all solutions where these are known, else by the default chain's answer.
fn wedged(rows: &[Row], facts: &[Entry], case: &str) -> String {
    let least = |values: &mut dyn Iterator<Item = f64>| values.reduce(f64::min);
    let own = |fact: &&(&str, f64, Fact)| fact.0 == case;
    let enumerated = facts
        .iter()
        .filter(own)
        .any(|(_, _, fact)| fact.solutions > 0);
    let exists = least(
        &mut facts
            .iter()
            .filter(own)
            .filter(|(_, _, fact)| fact.wedged > 0)
            .map(|(_, mu, _)| *mu),
    );
    let taken = least(
        &mut rows
            .iter()
            .filter(|row| row.case == case && row.note.contains("wedged"))
            .map(|row| row.value),
    );
    let answer = taken.map_or_else(
        || "is free of force at every μ".to_owned(),
        |mu| format!("stays wedged from μ = {mu:.1} on"),
    );
    let all = match (enumerated, exists) {
        (true, Some(mu)) => {
            format!("by enumeration states without load hold from μ = {mu:.1} on; ")
        }
        (true, None) => "by enumeration no state holds without load; ".into(),
        (false, _) => "only what the default chain finds is shown; ".into(),
    };
    format!(
        "{}: {all}the default chain's answer {answer}.",
        capital(case)
    )
}

/// How often each method takes the solution nearest to the committed state, where all are known and there are several.
fn nearest(rows: &[Row], facts: &[Entry]) -> String {
    let several = |row: &&Row| {
        let mut own = facts.iter();
        own.any(|(case, mu, fact)| *case == row.case && *mu == row.value && fact.solutions > 1)
    };
    let rows: Vec<&Row> = rows.iter().filter(several).collect();
    let mut names: Vec<&str> = Vec::new();
    for row in &rows {
        if !names.contains(&row.method) {
            names.push(row.method);
        }
    }
    let share = |name: &str| {
        let own = rows.iter().filter(|row| row.method == name);
        let taken = own.clone().filter(|row| row.outcome == Outcome::Solved);
        (taken.count(), own.count())
    };
    let (chain, all) = share(CHAIN);
    let others: Vec<String> = names
        .into_iter()
        .filter(|name| *name != CHAIN)
        .map(|name| format!("{name} {}", share(name).0))
        .collect();
    format!(
        "Where all solutions are enumerated and there are several ({all} problems), the nearest to the committed state is taken by the \
         default chain in {chain} of them, by the others in: {}.",
        others.join(", ")
    )
}

fn capital(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(characters).collect()
    })
}
