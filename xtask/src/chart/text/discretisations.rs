//! What the contact discretisation changes.

use minijinja::{Value, context};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_laboratory::problems::Problem;

use super::super::bench::{Bench, Quantity};
use super::super::methods::{self, Method};
use super::{Rows, none, percent};

const QUANTITIES: [Quantity; 2] = [Quantity::PeakPressure, Quantity::Extent];

/// The true gap against the one between facets.
pub(super) fn gaps(bench: &Bench) -> Rows {
    let group = methods::gaps();
    let mut rows = Rows::new();
    for problem in Problem::ALL {
        let suited = |pair: &&[(String, Method)]| pair[0].1.suits(problem);
        for pair in group.methods.chunks_exact(2).filter(suited) {
            let [element, ..] = pair[0].1.columns();
            let is_apart = pair[0].1.pairing.apart();
            let meshes = if is_apart { "apart" } else { "matching" };
            let mut row = vec![problem.title().to_owned(), element, meshes.to_owned()];
            row.extend(
                QUANTITIES.map(|quantity| errors(bench, problem, pair, quantity).join(", ")),
            );
            rows.push(row);
        }
    }
    rows
}

/// Node pairs against mortar projections.
pub(super) fn projections(bench: &Bench) -> [Value; 2] {
    [ElementKind::Q8, ElementKind::Q4].map(|element| {
        let group = methods::projections(element);
        let labels: Vec<String> = group.methods.iter().map(|own| own.0.clone()).collect();
        let mut rows = Rows::new();
        for problem in Problem::ALL {
            for quantity in QUANTITIES {
                let mut row = vec![problem.title().to_owned(), quantity.name().to_owned()];
                row.extend(errors(bench, problem, &group.methods, quantity));
                rows.push(row);
            }
        }
        context! { element => format!("{element:?}"), title => group.title, key => group.key, labels, rows }
    })
}

/// Errors on the finest mesh.
fn errors(
    bench: &Bench,
    problem: Problem,
    methods: &[(String, Method)],
    quantity: Quantity,
) -> Vec<String> {
    let errors = methods
        .iter()
        .map(|(_, method)| bench.finest(problem, *method, quantity));
    errors
        .map(|error| error.map_or_else(none, percent))
        .collect()
}
