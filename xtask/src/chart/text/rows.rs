//! Rows of tables and their numbers.

use stickslip_laboratory::problems::Problem;

use crate::chart::bench::{Bench, Cost, Quantity};
use crate::chart::curve::cost_of;
use crate::chart::methods::{Group, Method};

/// Errors at which methods are compared.
pub(super) const TARGETS: [f64; 2] = [1e-2, 1e-3];

/// The cells of a table.
pub(super) type Rows = Vec<Vec<String>>;

/// Labels of the group's methods that reach `target`, the cheapest first.
pub(super) fn ranking(
    bench: &Bench,
    problem: Problem,
    group: &Group,
    cost: Cost,
    quantity: Quantity,
    target: f64,
) -> Vec<(String, f64)> {
    let cost_of = |(label, method): &(String, Method)| {
        let points = bench.points(problem, *method, cost, quantity);
        Some((label.clone(), cost_of(&points, target)?))
    };
    let mut ranking: Vec<(String, f64)> = group.methods.iter().filter_map(cost_of).collect();
    ranking.sort_by(|a, b| a.1.total_cmp(&b.1));
    ranking
}

pub(super) fn none() -> String {
    "–".to_owned()
}

/// Two digits, or all before the point.
pub(super) fn number(value: f64) -> String {
    if value >= 9.95 {
        format!("{value:.0}")
    } else {
        format!("{value:.1}")
    }
}

pub(super) fn percent(value: f64) -> String {
    let value = 100.0 * value;
    if value >= 0.1 {
        format!("{value:.2} %")
    } else {
        format!("{value:.3} %")
    }
}
