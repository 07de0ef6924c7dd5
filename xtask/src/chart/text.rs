//! The page beside the charts: who wins where, in numbers. Its words are those of `page.jinja`.

mod discretisations;
mod programs;
mod rows;
mod verdict;

use minijinja::{Environment, context};
use rows::{Rows, TARGETS, none, number, percent, ranking};
use stickslip_laboratory::problems::Problem;

use super::Charts;
use super::bench::{Bench, Cost, Quantity};
use super::data::{machine, seconds, today};
use super::methods::{self, Group, Method};
use crate::publish::TaskError;

/// What stands in place of a method where the reference is not known so well.
const BEYOND: &str = "reference less exact";

/// A few lines for the terminal.
pub(super) fn short(charts: &Charts) -> String {
    format!(
        "{}\n{}\n",
        programs::sentence(charts),
        paths_sentence(charts)
    )
}

/// The whole page.
pub(super) fn page(charts: &Charts) -> Result<String, TaskError> {
    let bench = &charts.bench;
    let problems = Problem::ALL.map(|own| context! { title => own.title(), name => own.name() });
    let groups = [methods::direct_solvers(), methods::iterative_solvers()];
    let named = |group: &Group| context! { title => group.title, key => group.key };
    let values = context! {
        today => today(),
        machine => machine(),
        minutes => format!("{:.1}", charts.elapsed / 60.0),
        verdict => verdict::lines(bench),
        programs => programs::sentence(charts),
        duels => programs::duel_rows(charts),
        machines => programs::machines(charts),
        yardstick_unknowns => charts.yardstick.unknowns,
        yardstick => seconds(charts.yardstick.seconds),
        wrong => programs::wrong(charts),
        paths => paths_sentence(charts),
        factors => factors(charts),
        contact => charts.contact.iter().map(super::ContactCost::cells).collect::<Rows>(),
        elements => elements(bench),
        quantities => Quantity::ALL.map(Quantity::name),
        known => known(),
        problems,
        gaps => discretisations::gaps(bench),
        gaps_title => methods::gaps().title,
        projections => discretisations::projections(bench),
        solvers => solvers(bench, &groups),
        solver_groups => groups.each_ref().map(named),
        failures => failures(bench),
    };
    Ok(Environment::new().render_str(include_str!("page.jinja"), values)?)
}

fn paths_sentence(charts: &Charts) -> String {
    let factors = charts.factors.iter().map(super::PathFactor::factor);
    programs::range(factors.collect()).map_or_else(
        || "The conventional path solved nothing that can be compared.".to_owned(),
        |[least, middle, most]| {
            format!(
                "On equal meshes, with equal answers, the conventional path (Newton on the whole finite-element system, refactorised at \
                 every contact iteration) takes {} to {} times as long as the condensed one, {} in the median.",
                number(least),
                number(most),
                number(middle)
            )
        },
    )
}

fn factors(charts: &Charts) -> Rows {
    let row = |factor: &super::PathFactor| {
        vec![
            factor.problem.title().to_owned(),
            factor.unknowns.to_string(),
            seconds(factor.condensed),
            seconds(factor.conventional),
            factor.factorisations.to_string(),
            number(factor.factor()),
        ]
    };
    charts.factors.iter().map(row).collect()
}

/// Fastest elements at both errors, and the one with the fewest unknowns, for each problem and quantity.
fn elements(bench: &Bench) -> Rows {
    let group = methods::elements();
    let mut rows = Rows::new();
    for problem in Problem::ALL {
        for quantity in bench.known(problem) {
            let mut cells = vec![problem.title().to_owned(), quantity.name().to_owned()];
            let known = quantity.of(&problem.known()).unwrap_or(0.0);
            for target in TARGETS {
                if target < known {
                    cells.extend([BEYOND.to_owned(), none()]);
                    continue;
                }
                let order = ranking(bench, problem, &group, Cost::Whole, quantity, target);
                let fastest = order.first();
                cells.push(
                    fastest
                        .map_or_else(none, |(label, cost)| format!("{label}, {}", seconds(*cost))),
                );
                cells.push(match order.as_slice() {
                    [first, second, ..] => format!("{} × {}", second.0, number(second.1 / first.1)),
                    _ => none(),
                });
            }
            let sparse = ranking(bench, problem, &group, Cost::Unknowns, quantity, TARGETS[1]);
            let sparsest = sparse.first().filter(|_| TARGETS[1] >= known);
            cells.push(
                sparsest.map_or_else(none, |(label, cost)| format!("{label}, {}", cost.round())),
            );
            rows.push(cells);
        }
    }
    rows
}

/// How well the references are known.
fn known() -> Rows {
    let row = |problem: Problem| {
        let limits = problem.known();
        let cell = |quantity: Quantity| match quantity.of(&limits) {
            None => none(),
            Some(0.0) => "exact".to_owned(),
            Some(limit) => format!("{limit:.0e}"),
        };
        let cells = Quantity::ALL.into_iter().map(cell);
        std::iter::once(problem.title().to_owned())
            .chain(cells)
            .collect()
    };
    Problem::ALL.into_iter().map(row).collect()
}

fn solvers(bench: &Bench, groups: &[Group]) -> Rows {
    let solvers = groups.iter().flat_map(|group| &group.methods);
    let row = |(label, method): &(String, Method)| {
        let cells = Problem::ALL
            .into_iter()
            .map(|problem| against_default(bench, problem, *method));
        std::iter::once(label.clone()).chain(cells).collect()
    };
    solvers
        .filter(|(_, method)| *method != Method::DEFAULT)
        .map(row)
        .collect()
}

fn against_default(bench: &Bench, problem: Problem, method: Method) -> String {
    let default = bench.curve(problem, Method::DEFAULT);
    let Some((spacing, found)) = bench.curve(problem, method).pop() else {
        return "not solved".to_owned();
    };
    let Some((_, own)) = default.iter().find(|(other, _)| *other == spacing) else {
        return none();
    };
    let ratio = |cost: Cost| number(cost.of(found) / cost.of(own));
    let mut cell = format!("{} ({})", ratio(Cost::Solve), ratio(Cost::Contact));
    let shift = (found.errors.peak_pressure - own.errors.peak_pressure).abs();
    if shift > 1e-4 {
        cell.extend([", error ", &percent(found.errors.peak_pressure)]);
    }
    let finest = default.last().map(|(finest, _)| *finest);
    if finest != Some(spacing) {
        cell.extend([", ", &spacing.to_string(), " ", problem.unit()]);
    }
    cell
}

/// One row for each problem, discretisation and solver that did not solve all meshes.
fn failures(bench: &Bench) -> Rows {
    let mut rows = Rows::new();
    for sample in bench.samples() {
        let Some(cause) = sample.outcome.as_ref().err() else {
            continue;
        };
        let [element, pairing, solver] = sample.method.columns();
        let key = [
            sample.problem.title().to_owned(),
            format!("{element}, {pairing}"),
            solver,
        ];
        let spacing = format!("{} {}", sample.spacing, sample.problem.unit());
        match rows.iter_mut().find(|row| row[..3] == key) {
            Some(row) => row[3].extend([", ", &spacing]),
            None => rows.push([&key[..], &[spacing, first_clause(cause)]].concat()),
        }
    }
    rows
}
/// Up to the first end of a clause after a hundred characters.
fn first_clause(cause: &str) -> String {
    let cause = cause.replace('|', "/");
    let end = cause.match_indices(';').map(|(at, _)| at);
    let end = end.into_iter().find(|&at| at > 100);
    end.map_or(cause.clone(), |at| cause[..at].to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::yardstick::Yardstick;

    #[test]
    fn a_page_is_made_of_whatever_was_measured() {
        let charts = Charts {
            bench: Bench::new(true),
            factors: Vec::new(),
            contact: Vec::new(),
            unmeshed: Vec::new(),
            yardstick: Yardstick {
                unknowns: 41_000,
                seconds: 0.5,
            },
            peers: Vec::new(),
            elapsed: 60.0,
        };
        let page = page(&charts).expect("the template is one");
        let start = "## Beside other programs\n\n![Error of the peak pressure over time](summary.png)\n\nNo run of another program";
        assert!(page.contains(start));
        assert!(page.contains("one thread, 1.0 minutes)") && page.contains("500 ms here"));
        let heads = page.matches("| --- |").count();
        assert!(heads >= 5 && !page.contains("{{") && !page.contains("## Not solved"));
    }
}
