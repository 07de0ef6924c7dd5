//! Stated numbers and their errors, in results.

use stickslip_engine::results::{EdgeResults, Results, RowErrors};

use super::numbers::Table;

/// Puts the numbers of edges `fitted` between nodes, with their `errors` and those `along` the nodes, into `found`, whose coordinates have their origin at `origin` of the scene's `[mm]`.
pub(super) fn put(
    found: &mut Results,
    fitted: Vec<Vec<EdgeResults>>,
    errors: Table,
    along: Vec<Vec<Vec<RowErrors>>>,
    origin: [f64; 2],
) {
    for ((step, fitted), errors) in found.steps.iter_mut().zip(fitted).zip(errors) {
        let fitted = fitted.into_iter().zip(&found.edges);
        for ((edge, (mut fitted, geometry)), errors) in
            step.edges.iter_mut().zip(fitted).zip(errors)
        {
            fitted.place(geometry, origin);
            let rows = std::mem::take(&mut edge.rows);
            *edge = EdgeResults {
                rows,
                errors,
                ..fitted
            };
        }
    }
    for (step, along) in found.steps.iter_mut().zip(along) {
        for (edge, along) in step.edges.iter_mut().zip(along) {
            edge.row_errors = along;
        }
    }
}
