//! Load steps on nodes of their own, chosen among those of a model.

use stickslip_engine::model::{Model, ModelEdge};
use stickslip_engine::results::{EdgeGeometry, EdgeKind, EdgeResults};
use stickslip_engine::run::Solved;

use crate::grading::Grading;

/// The nodes of every load step that `grading` chooses on each contact edge of `model`, all contacts alike. `None` where a contact is not one of equal nodes on a circle.
pub(super) fn chosen(model: &Model, grading: &Grading) -> Option<Vec<Vec<usize>>> {
    let mut edges = (0..model.pairs.len()).map(|pair| model.edge_of(pair));
    let first = &edges.next()??.geometry;
    let alike = |edge: Option<&ModelEdge>| {
        edge.is_some_and(|edge| edge.geometry.parameter == first.parameter)
    };
    let is_round = matches!(first.kind, EdgeKind::Circle { .. });
    let steps = 0..model.history.steps().len();
    (is_round && edges.all(alike)).then(|| {
        let of_step = |step| grading.chosen(step, &first.parameter, first.half);
        steps.map(of_step).collect()
    })
}

/// For every step and edge the rows of the nodes that the step has: the chosen ones, and all where nothing touches, whose values are as good.
pub(super) fn rows(
    solved: &Solved,
    model: &Model,
    steps: &[Vec<EdgeResults>],
) -> Vec<Vec<Vec<usize>>> {
    let of_edge = |step: usize, edge: usize| -> Vec<usize> {
        let rows = &steps[step][edge].rows;
        let pair = model.edges[edge].pair;
        let chosen = (solved.own.as_ref()).and_then(|own| Some(own.thinned[step].chosen(pair?)));
        let Some(chosen) = chosen else {
            return (0..rows.len()).collect();
        };
        let is_own = |k: &usize| !rows[*k].status.touches() || chosen.binary_search(k).is_ok();
        (0..rows.len()).filter(is_own).collect()
    };
    let edges = |step: usize| {
        (0..model.edges.len())
            .map(|edge| of_edge(step, edge))
            .collect()
    };
    (0..steps.len()).map(edges).collect()
}

/// Leaves those of `rows` in `steps`, and returns the edges with these nodes.
pub(super) fn own_rows(
    geometries: &[EdgeGeometry],
    rows: &[Vec<Vec<usize>>],
    steps: &mut [Vec<EdgeResults>],
) -> Vec<Vec<EdgeGeometry>> {
    let mut all = Vec::with_capacity(steps.len());
    for (step, rows) in steps.iter_mut().zip(rows) {
        let mut edges = Vec::with_capacity(step.len());
        for ((results, rows), geometry) in step.iter_mut().zip(rows).zip(geometries) {
            results.rows = rows.iter().map(|&k| results.rows[k]).collect();
            edges.push(EdgeGeometry {
                parameter: rows.iter().map(|&k| geometry.parameter[k]).collect(),
                corner: rows.iter().map(|&k| geometry.corner[k]).collect(),
                ..geometry.clone()
            });
        }
        all.push(edges);
    }
    all
}
