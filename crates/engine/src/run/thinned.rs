//! Load steps on nodes of their own.

use std::sync::Arc;

use stickslip_contact::thinned::{EdgeNodes, Thinned, Whole};
use stickslip_contact::{DeformedGaps, Interface, InterfaceSolver, Kinematics};
use stickslip_fem_core::{InterfaceOperator, parallel};

use super::assembled::Assembled;
use super::error::RunError;
use super::follow::{Progress, explained, follow, timed};
use super::solved::{Operator, OwnNodes, Seated, Solved};
use crate::model::Model;

/// Follows the history of `model` with `solver` on the nodes `chosen` in each load step, the same on every contact edge; on all nodes where contact points are not
/// nodes. Where bodies sit otherwise in a step than in the model, `seated` has them.
///
/// # Errors
/// [`RunError::Contact`], [`RunError::Unbalanced`].
pub fn follow_thinned(
    model: &Model,
    assembled: Assembled,
    solver: &dyn InterfaceSolver,
    (chosen, seated): (&[Vec<usize>], &[Option<Arc<Seated>>]),
    progress: &mut dyn FnMut(Progress),
) -> Result<Solved, RunError> {
    let Assembled {
        operators,
        interface,
        ..
    } = assembled;
    let found = timed(model, progress, |observe| {
        let faces = faces(&operators);
        let kinematics = model.kinematics(&faces)?;
        let pairs = model.pairs.len();
        let thin = with_wholes(model, (&faces, &kinematics), &interface, seated, |wholes| {
            let steps: Vec<(&Whole<'_>, &Vec<usize>)> = wholes.iter().zip(chosen).collect();
            let of_step = |(whole, nodes): &(&Whole<'_>, &Vec<usize>)| {
                Thinned::new(whole, &vec![(*nodes).clone(); pairs])
            };
            let thinned = parallel::map(&steps, of_step);
            let thinned = thinned.into_iter().collect::<Result<Vec<Thinned>, _>>()?;
            let thin = (model.history).follow_thinned(wholes, &thinned, solver, observe)?;
            Ok((thinned, thin))
        });
        let thin = thin?.transpose();
        thin.map_err(|cause| explained(model, &operators, &interface, cause))
    })?;
    let (Some((thinned, mut thin)), step_seconds, seconds) = found else {
        return follow(model, operators, interface, solver, progress);
    };
    for (record, seated) in thin.all.iter_mut().zip(seated) {
        if let Some(seated) = seated {
            seated.put_on_nodes_of(&operators, record);
        }
    }
    Ok(Solved {
        operators,
        interface,
        records: thin.all,
        own: Some(OwnNodes {
            thinned,
            records: thin.own,
            seated: seated.to_vec(),
        }),
        step_seconds,
        phases: vec![("contact", seconds)],
    })
}

fn faces(operators: &[Operator]) -> Vec<&dyn InterfaceOperator> {
    operators.iter().map(Operator::interface).collect()
}

/// What `with` makes of the bodies and contacts of every load step with all their nodes, those of `faces` and `kinematics` but where `seated` has others; `None` where contact points are not
/// nodes, or springs link bodies.
///
/// # Errors
/// [`RunError::Contact`].
pub(super) fn with_wholes<T>(
    model: &Model,
    (faces, kinematics): (&[&dyn InterfaceOperator], &Kinematics<'_>),
    interface: &Interface,
    seated: &[Option<Arc<Seated>>],
    with: impl FnOnce(&[Whole<'_>]) -> T,
) -> Result<Option<T>, RunError> {
    let edge = |pair: usize| {
        let geometry = &model.edge_of(pair)?.geometry;
        Some(EdgeNodes {
            parameter: geometry.parameter.clone(),
            closed: geometry.closed().filter(|_| !geometry.half),
            mirrored: [geometry.half; 2],
        })
    };
    let edges: Option<Vec<EdgeNodes>> = (0..model.pairs.len()).map(edge).collect();
    let Some(edges) = edges else {
        return Ok(None);
    };
    let Some(whole) = Whole::new(faces, interface, kinematics, edges.clone()) else {
        return Ok(None);
    };
    let mut wholes = Vec::new();
    for step in 0..model.history.steps().len() {
        let Some(seated) = seated.get(step).and_then(Option::as_deref) else {
            wholes.push(whole.clone());
            continue;
        };
        let own = self::faces(&seated.operators);
        let gaps = DeformedGaps::new(&own, &model.pairs, &seated.facings)?;
        let own = Whole::new(
            &own,
            interface,
            &Kinematics::DeformedGaps(gaps),
            edges.clone(),
        );
        let Some(own) = own else {
            return Ok(None);
        };
        wholes.push(own);
    }
    Ok(Some(with(&wholes)))
}
