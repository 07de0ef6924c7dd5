//! Load steps on nodes of their own, chosen among those of a model.

use stickslip_contact::thinned::{EdgeNodes, Thinned, Whole};
use stickslip_contact::{Interface, InterfaceSolver, Kinematics};
use stickslip_fem_core::{InterfaceOperator, parallel};

use super::grading::Grading;
use crate::model::{Model, ModelEdge};
use crate::results::{EdgeGeometry, EdgeKind, EdgeResults};
use crate::run::solved::{Operator, OwnNodes, Solved};
use crate::run::{Progress, RunError, timed};

/// The nodes of every load step that `grading` chooses on each contact edge of `model`, all contacts alike. `None` where a contact is not one of equal nodes on a circle.
pub(super) fn chosen(model: &Model, grading: &Grading) -> Option<Vec<Vec<usize>>> {
    let mut edges = (0..model.pairs.len()).map(|pair| edge_of(model, pair));
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

fn edge_of(model: &Model, pair: usize) -> Option<&ModelEdge> {
    model.edges.iter().find(|edge| edge.pair == Some(pair))
}

/// Follows the history of `model` with the nodes `chosen` in each load step; on all nodes where contact points are not nodes.
pub(super) fn follow(
    model: &Model,
    operators: Vec<Operator>,
    interface: Interface,
    solver: &dyn InterfaceSolver,
    chosen: &[Vec<usize>],
    progress: &mut dyn FnMut(Progress),
) -> Result<Solved, RunError> {
    let found = timed(model, progress, |observe| {
        let faces: Vec<&dyn InterfaceOperator> =
            operators.iter().map(Operator::interface).collect();
        let kinematics = model.kinematics(&faces)?;
        let Some(whole) = whole(model, &faces, &kinematics, &interface) else {
            return Ok(None);
        };
        let pairs = model.pairs.len();
        let of_step = |nodes: &Vec<usize>| Thinned::new(&whole, &vec![nodes.clone(); pairs]);
        let thinned = parallel::map(chosen, of_step);
        let thinned = thinned.into_iter().collect::<Result<Vec<Thinned>, _>>()?;
        let thin = (model.history).follow_thinned(&whole, &thinned, solver, observe)?;
        Ok(Some((thinned, thin)))
    })?;
    let (Some((thinned, thin)), step_seconds, seconds) = found else {
        return crate::run::follow(model, operators, interface, solver, progress);
    };
    Ok(Solved {
        operators,
        interface,
        records: thin.all,
        own: Some(OwnNodes {
            thinned,
            records: thin.own,
        }),
        step_seconds,
        phases: vec![("contact", seconds)],
    })
}

/// All nodes of `model`; `None` where contact points are not nodes.
pub(in crate::run) fn whole<'a>(
    model: &Model,
    faces: &[&'a dyn InterfaceOperator],
    kinematics: &Kinematics<'a>,
    interface: &'a Interface,
) -> Option<Whole<'a>> {
    let edge = |pair: usize| {
        let geometry = &edge_of(model, pair)?.geometry;
        Some(EdgeNodes {
            parameter: geometry.parameter.clone(),
            closed: geometry.closed().filter(|_| !geometry.half),
            mirrored: [geometry.half; 2],
        })
    };
    let edges: Option<Vec<EdgeNodes>> = (0..model.pairs.len()).map(edge).collect();
    Whole::new(faces, interface, kinematics, edges?)
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
