//! Load steps on nodes of their own.

use stickslip_contact::thinned::{EdgeNodes, Thinned, Whole};
use stickslip_contact::{Interface, InterfaceSolver, Kinematics};
use stickslip_fem_core::{InterfaceOperator, parallel};

use super::assembled::Assembled;
use super::error::RunError;
use super::follow::{Progress, explained, follow, timed};
use super::solved::{Operator, OwnNodes, Solved};
use crate::model::Model;

/// Follows the history of `model` with `solver` on the nodes `chosen` in each load step, the same on every contact edge; on all nodes where contact points are not
/// nodes.
///
/// # Errors
/// [`RunError::Contact`], [`RunError::Unbalanced`].
pub fn follow_thinned(
    model: &Model,
    assembled: Assembled,
    solver: &dyn InterfaceSolver,
    chosen: &[Vec<usize>],
    progress: &mut dyn FnMut(Progress),
) -> Result<Solved, RunError> {
    let Assembled {
        operators,
        interface,
        ..
    } = assembled;
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
        let thin = (model.history).follow_thinned(&whole, &thinned, solver, observe);
        let thin = thin.map_err(|cause| explained(model, &operators, &interface, cause))?;
        Ok(Some((thinned, thin)))
    })?;
    let (Some((thinned, thin)), step_seconds, seconds) = found else {
        return follow(model, operators, interface, solver, progress);
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
pub(super) fn whole<'a>(
    model: &Model,
    faces: &[&'a dyn InterfaceOperator],
    kinematics: &Kinematics<'a>,
    interface: &'a Interface,
) -> Option<Whole<'a>> {
    let edge = |pair: usize| {
        let geometry = &model.edge_of(pair)?.geometry;
        Some(EdgeNodes {
            parameter: geometry.parameter.clone(),
            closed: geometry.closed().filter(|_| !geometry.half),
            mirrored: [geometry.half; 2],
        })
    };
    let edges: Option<Vec<EdgeNodes>> = (0..model.pairs.len()).map(edge).collect();
    Whole::new(faces, interface, kinematics, edges?)
}
