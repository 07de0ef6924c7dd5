//! Who wins where, in a sentence for each quantity.

use stickslip_laboratory::problems::Problem;

use super::super::bench::{Bench, Cost, Quantity};
use super::super::methods;
use super::{TARGETS, number, percent, ranking};

/// What a quantity's fastest elements are, over all problems.
pub(super) fn lines(bench: &Bench) -> Vec<String> {
    let line = |quantity: Quantity| {
        let parts = TARGETS
            .iter()
            .filter_map(|&target| sentence(bench, quantity, target));
        let parts: Vec<String> = parts.collect();
        (!parts.is_empty()).then(|| format!("{}: {}", quantity.name(), parts.join("; ")))
    };
    Quantity::ALL.into_iter().filter_map(line).collect()
}

fn sentence(bench: &Bench, quantity: Quantity, target: f64) -> Option<String> {
    let group = methods::elements();
    let mut wins: Vec<(String, usize)> = Vec::new();
    let mut behind = Vec::new();
    for problem in Problem::ALL {
        let known = quantity.of(&problem.known()).unwrap_or(f64::INFINITY);
        if target < known {
            continue;
        }
        let order = ranking(bench, problem, &group, Cost::Whole, quantity, target);
        let Some((winner, best)) = order.first() else {
            continue;
        };
        match wins.iter_mut().find(|(label, _)| label == winner) {
            Some((_, count)) => *count += 1,
            None => wins.push((winner.clone(), 1)),
        }
        let default = order.iter().find(|(label, _)| label == DEFAULT);
        behind.extend(default.map(|(_, cost)| cost / best));
    }
    if wins.is_empty() {
        return None;
    }
    wins.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    let wins: Vec<String> = wins
        .iter()
        .map(|(label, count)| format!("{label} {count}"))
        .collect();
    behind.sort_by(f64::total_cmp);
    let default = behind.get(behind.len() / 2).map_or_else(
        || format!("{DEFAULT} reaches it nowhere"),
        |&times| format!("{DEFAULT} {} ×", number(times)),
    );
    Some(format!(
        "at {} {}, {default}",
        percent(target),
        wins.join(", ")
    ))
}

/// Label of the default element in the group of elements.
const DEFAULT: &str = "Q8";
