//! Follows load histories, and reports how far they are.

use stickslip_contact::{ContactError, Interface, InterfaceSolver};
use stickslip_fem_core::InterfaceOperator;

use super::error::RunError;
use super::solved::{Operator, Solved};
use super::whole_motion::moving;
use crate::model::Model;

/// What a run reports while it goes on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Progress {
    /// A phase begins.
    Phase(&'static str),
    /// A load step is done.
    Step {
        /// Steps done.
        done: usize,
        /// Steps in all.
        total: usize,
    },
}

/// Follows the history of `model` with `solver`, on the `interface` of its condensed bodies `operators`.
///
/// # Errors
/// [`RunError::Contact`], [`RunError::Unbalanced`].
pub fn follow(
    model: &Model,
    operators: Vec<Operator>,
    interface: Interface,
    solver: &dyn InterfaceSolver,
    progress: &mut dyn FnMut(Progress),
) -> Result<Solved, RunError> {
    let (records, step_seconds, seconds) = timed(model, progress, |observe| {
        let faces: Vec<&dyn InterfaceOperator> =
            operators.iter().map(Operator::interface).collect();
        let kinematics = model.kinematics(&faces)?;
        let followed = (model.history).follow_parts(&interface, &kinematics, solver, observe);
        followed.map_err(|cause| explained(model, &operators, &interface, cause))
    })?;
    Ok(Solved {
        operators,
        interface,
        records,
        own: None,
        step_seconds,
        phases: vec![("contact", seconds)],
    })
}

/// The end `cause` of a history, with the bodies that the load moves where this is proved.
pub(super) fn explained(
    model: &Model,
    operators: &[Operator],
    interface: &Interface,
    cause: ContactError,
) -> RunError {
    match moving(model, operators, interface, &cause) {
        Some((part, moving)) if !moving.is_empty() => RunError::Unbalanced {
            cause,
            part,
            moving,
        },
        _ => cause.into(),
    }
}

/// What `walk` finds of the history of `model`, with the wall time of every load step and of all `[s]`; `walk` calls its argument when a step is done.
pub(super) fn timed<T>(
    model: &Model,
    progress: &mut dyn FnMut(Progress),
    walk: impl FnOnce(&mut dyn FnMut()) -> Result<T, RunError>,
) -> Result<(T, Vec<f64>, f64), RunError> {
    progress(Progress::Phase("contact"));
    let start = model.host.seconds();
    let total = model.history.steps().len();
    let (mut step_seconds, mut last) = (Vec::with_capacity(total), start);
    let found = walk(&mut || {
        let now = model.host.seconds();
        step_seconds.push(now - last);
        last = now;
        progress(Progress::Step {
            done: step_seconds.len(),
            total,
        });
    })?;
    Ok((found, step_seconds, model.host.seconds() - start))
}
