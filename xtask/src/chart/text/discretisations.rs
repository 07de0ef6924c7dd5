//! What the contact discretisation changes.

use std::fmt::Write as _;

use stickslip_fem_core::mesh::ElementKind;
use stickslip_laboratory::problems::Problem;

use super::super::bench::{Bench, Quantity};
use super::super::methods::{self, Group, Method};
use super::{none, percent};

const QUANTITIES: [Quantity; 2] = [Quantity::PeakPressure, Quantity::Extent];

/// The true gap against the one between facets.
pub(super) fn gaps(page: &mut String, bench: &Bench) {
    page.push_str(
        "## Initial gap\n\nError on the finest mesh with the gap of the true shapes, and with that between straight facets. Nodes of \
         matching meshes lie on the true shapes, so there is little between the two; where the meshes are apart a node faces the \
         middle of a facet, and its sagitta is as large as a small clearance.\n\n\
         | problem | element | meshes | peak pressure: true, faceted | extent: true, faceted |\n| --- | --- | --- | ---: | ---: |\n",
    );
    let group = methods::gaps();
    for problem in Problem::ALL {
        let suited = |pair: &&[(String, Method)]| pair[0].1.suits(problem);
        for pair in group.methods.chunks_exact(2).filter(suited) {
            let errors = |quantity| {
                pair.iter()
                    .map(move |(_, method)| bench.finest(problem, *method, quantity))
            };
            let cells = QUANTITIES.map(|quantity| listed(errors(quantity), ", "));
            let [element, ..] = pair[0].1.columns();
            let meshes = if pair[0].1.pairing.apart() {
                "apart"
            } else {
                "matching"
            };
            let _ = writeln!(
                page,
                "| {} | {element} | {meshes} | {} |",
                problem.title(),
                cells.join(" | ")
            );
        }
    }
    pictures(page, &group);
}

/// Node pairs against mortar projections.
pub(super) fn projections(page: &mut String, bench: &Bench) {
    page.push_str(
        "## Mortar projections\n\nErrors on the finest mesh. *Apart*: the second body's nodes are 1.5 times as far from each other, \
         so that two of three have no partner; a rigid pin has no nodes of its own.\n\n",
    );
    for element in [ElementKind::Q8, ElementKind::Q4] {
        let group = methods::projections(element);
        let labels: Vec<&str> = group.methods.iter().map(|(label, _)| &**label).collect();
        let _ = write!(
            page,
            "| problem, {element:?} | error of | {} |\n| --- | --- |{}\n",
            labels.join(" | "),
            " ---: |".repeat(labels.len())
        );
        for problem in Problem::ALL {
            for quantity in QUANTITIES {
                let errors = group
                    .methods
                    .iter()
                    .map(|(_, method)| bench.finest(problem, *method, quantity));
                let _ = writeln!(
                    page,
                    "| {} | {} | {} |",
                    problem.title(),
                    quantity.name(),
                    listed(errors, " | ")
                );
            }
        }
        pictures(page, &group);
    }
}

fn listed(errors: impl Iterator<Item = Option<f64>>, between: &str) -> String {
    let cells: Vec<String> = errors
        .map(|error| error.map_or_else(none, percent))
        .collect();
    cells.join(between)
}

fn pictures(page: &mut String, group: &Group) {
    let (title, key) = (group.title, group.key);
    let _ = write!(
        page,
        "\n![{title}: error of the peak pressure]({key}-peak-pressure.png)\n\n\
         ![{title}: error of the extent of contact]({key}-extent.png)\n\n"
    );
}
