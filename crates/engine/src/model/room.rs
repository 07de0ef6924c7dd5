//! Memory of the interface problem and of a load history, counted before either is made.

use std::collections::BTreeSet;

use stickslip_contact::interface::{Group, groups};
use stickslip_fem_core::InterfaceOperator;

use super::{Model, ModelBody, ModelBodyKind, ModelError, ModelFastener};
use stickslip_scene::limits::Limits;

/// Bytes of a number.
const NUMBER: f64 = 8.0;
/// Matrices of the size of a part's compliance that a solver holds at most: itself, the equations of an iteration, their factors, and
/// the tableau of pivoting, of one and a half times its order.
const OF_PART: f64 = 5.0;
/// Shapes of forces by which an edge acts on others, at most, where compliances are in blocks.
const SHAPES: f64 = 120.0;
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
    let of_parts: f64 = parts.iter().map(|part| of_part(model, part)).sum();
    let of_bodies: f64 = model.bodies.iter().map(of_body).sum();
    let bytes = NUMBER * (of_parts + of_bodies);
    if let (Err(cause), Some(largest)) = (
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
            cause,
        });
    }
    let steps = model.history.steps().len();
    let places: usize = (model.edges.iter())
        .map(|edge| edge.geometry.parameter.len())
        .sum();
    let bytes = steps as f64 * (BYTES_PER_STEP + places as f64 * BYTES_PER_PLACE);
    limits
        .check(bytes)
        .map_err(|cause| ModelError::HistoryTooLong { steps, cause })
}

/// Numbers that a body's condensation leaves for its interface.
fn of_body(body: &ModelBody) -> f64 {
    OF_BODY
        * match body.ends.len() {
            0 => square(body.interface.len()),
            edges => of_blocks(edges, body.interface.len()),
        }
}

/// Numbers that a solver holds of `part`. Where compliances are in blocks, it makes matrices of the points that touch, at most half of all.
fn of_part(model: &Model, part: &Group) -> f64 {
    let pairs = part.pairs.iter().map(|&pair| &model.pairs[pair]);
    let points = pairs.map(|pair| pair.points.len()).sum();
    let in_blocks = |&body: &usize| !model.bodies[body].ends.is_empty();
    if part.bodies.iter().any(in_blocks) {
        of_blocks(part.pairs.len(), points) + OF_PART * square(points / 2)
    } else {
        OF_PART * square(points)
    }
}

/// Numbers of a compliance of `points` points on `edges` edges in blocks.
fn of_blocks(edges: usize, points: usize) -> f64 {
    edges as f64 * square(points / edges.max(1)) + (SHAPES * edges as f64).powi(2)
}

fn square(points: usize) -> f64 {
    (2.0 * points as f64).powi(2)
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
    let together: Vec<&[usize]> = (model.fasteners.iter())
        .map(ModelFastener::slices)
        .collect();
    groups(&links, &ends, &together)
}
