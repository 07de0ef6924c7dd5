//! Memory of the interface problem and of a load history, counted before either is made.

use std::collections::BTreeSet;

use stickslip_contact::interface::{Group, groups};
use stickslip_fem_core::InterfaceOperator;

use super::{Model, ModelBodyKind, ModelError};
use stickslip_scene::limits::Limits;

/// Bytes of a number.
const NUMBER: f64 = 8.0;
/// Matrices of the size of a part's compliance that a solver holds at most: itself, the equations of an iteration, their factors, and
/// the tableau of pivoting, of one and a half times its order.
const OF_PART: f64 = 5.0;
/// Matrices of the size of a body's compliance that its condensation leaves: itself, and the inverse that it comes from.
const OF_BODY: f64 = 2.0;
/// Bytes of what is known of a contact point or of a place on an edge at the end of a load step, on its way to the files.
const BYTES_PER_PLACE: f64 = 600.0;
/// Bytes of what else a load step leaves, on its way to the files.
const BYTES_PER_STEP: f64 = 12_000.0;

/// Refuses what does not fit into `limits`.
pub(super) fn check(limits: Limits, model: &Model) -> Result<(), ModelError> {
    let parts = parts(model);
    let points = |part: &Group| -> usize {
        let own = part
            .pairs
            .iter()
            .map(|&pair| model.pairs[pair].points.len());
        own.sum()
    };
    let square = |points: usize| (2.0 * points as f64).powi(2);
    let of_parts: f64 = parts.iter().map(|part| square(points(part))).sum();
    let bodies = model.bodies.iter().map(|body| body.interface.len());
    let of_bodies: f64 = bodies.map(square).sum();
    let bytes = NUMBER * (OF_PART * of_parts + OF_BODY * of_bodies);
    if let (Err(message), Some(largest)) = (
        limits.check(bytes),
        parts.iter().max_by_key(|part| points(part)),
    ) {
        let names: BTreeSet<&str> = (largest.pairs.iter())
            .map(|&pair| &*model.pairs[pair].name)
            .collect();
        return Err(ModelError::InterfaceTooLarge {
            contact: names.first().copied().unwrap_or_default().to_owned(),
            points: points(largest),
            contacts: largest.pairs.len(),
            message,
        });
    }
    let steps = model.history.steps().len();
    let places: usize = (model.edges.iter())
        .map(|edge| edge.geometry.parameter.len())
        .sum();
    let bytes = steps as f64 * (BYTES_PER_STEP + places as f64 * BYTES_PER_PLACE);
    limits
        .check(bytes)
        .map_err(|message| ModelError::HistoryTooLong { steps, message })
}

/// The bodies and pairs that are solved together.
pub(crate) fn parts(model: &Model) -> Vec<Group> {
    let links: Vec<bool> = (model.bodies.iter())
        .map(|body| match &body.kind {
            ModelBodyKind::Elastic(_) => true,
            ModelBodyKind::Rigid(rigid) => rigid.modes().ncols() > 0,
        })
        .collect();
    let ends: Vec<[usize; 2]> = (model.pairs.iter())
        .map(|pair| [pair.first, pair.second])
        .collect();
    groups(&links, &ends)
}
