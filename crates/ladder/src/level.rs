//! A model of the ladder that was solved, and its numbers.

use stickslip_friction::History;

use stickslip_engine::model::Model;
use stickslip_engine::results::{EdgeGeometry, EdgeResults};
use stickslip_engine::run::{Operator, OwnNodes, RunError, Solved, comparable};

use super::limits::Missing;
use super::motions::Motions;
use super::numbers::Numbers;
use super::{peaks, thinning};

/// Overlap as a part of the size of bodies that is rounding.
const ROUNDING: f64 = 1e-9;
/// Memory of elastic bodies per entry of their factors, in bytes: that entry, and its part of mesh, stiffness and stresses.
const BYTES_PER_ENTRY: f64 = 14.0;
/// Memory of a contact problem per pair of its components, in bytes: a few dense matrices.
const BYTES_PER_PAIR: f64 = 32.0;

/// A model that was solved.
pub(super) struct Level {
    pub(super) rung: usize,
    /// Increments of each load step.
    pub(super) substeps: Vec<usize>,
    pub(super) model: Model,
    pub(super) solved: Solved,
    pub(super) numbers: Numbers,
    pub(super) seconds: f64,
    /// What it would have taken if nothing had been ready for it `[s]`.
    pub(super) seconds_anew: f64,
    /// How it is divided, for a reader.
    pub(super) division: String,
}

impl Level {
    /// Memory that it takes, in bytes: that of factors and of dense compliances is most of it.
    pub(super) fn bytes(&self) -> f64 {
        let elastic = self.solved.operators.iter().filter_map(Operator::elastic);
        let entries: usize = elastic.map(|own| own.structure().factor_entries()).sum();
        let rows = 2.0 * self.solved.interface.contacts().points().len() as f64;
        let own = self.solved.own.as_ref();
        let matrices = own.map_or(0, OwnNodes::matrices) as f64;
        BYTES_PER_ENTRY * entries as f64 + (BYTES_PER_PAIR + 8.0 * matrices) * rows * rows
    }

    /// What a virgin point in the middle of a contact edge holds under `pressure`, as a part of it.
    pub(super) fn friction(&self, edge: usize, pressure: f64) -> f64 {
        let contacts = self.solved.interface.contacts();
        let Some(pair) = self.model.edges[edge].pair.filter(|_| pressure > 0.0) else {
            return 0.0;
        };
        let points = contacts.pair_points(pair);
        let middle = points.start + points.len() / 2;
        let place = &contacts.points()[middle].place;
        let bound = contacts
            .law(middle)
            .bound(pressure, 0.0, place, &History::default());
        bound.stick / pressure
    }

    /// Whether bodies overlap before they are loaded.
    pub(super) fn overlaps(&self) -> bool {
        let points = self.solved.interface.contacts().points();
        let far = points.iter().map(|point| {
            let [x, y] = point.place.position;
            x.hypot(y)
        });
        let size = far.fold(0.0, f64::max);
        points.iter().any(|point| point.gap < -ROUNDING * size)
    }

    /// Whether friction acts anywhere in its history.
    pub(super) fn rubs(&self) -> bool {
        let mut edges = self.numbers.steps.iter().flatten();
        edges.any(|edge| edge.rows.iter().any(|row| row.shear != 0.0))
    }
}

/// The numbers of `model`, whose history is `solved`.
pub(super) fn numbers(model: &Model, solved: &Solved) -> Result<Numbers, RunError> {
    let found = comparable(model, solved)?;
    let (geometries, mut steps) = (found.geometries, found.edges);
    let rows = thinning::rows(solved, model, &steps);
    let own = thinning::own_rows(&geometries, &rows, &mut steps);
    let fitted = peaks::between_nodes(model, solved, &geometries, (&own, &rows), &mut steps);
    Ok(Numbers {
        missing: missing(model, solved, &own, &steps),
        spacings: geometries.iter().map(spacing).collect(),
        fitted,
        geometries,
        own,
        steps,
        sets: Motions::of(&found.sets),
    })
}

/// A division where each load step has nodes of its own.
pub(super) fn described(division: String, solved: &Solved) -> String {
    let own = solved.own.as_ref();
    let steps = own.map(|own| own.thinned.iter().map(|step| step.chosen(0).len()));
    match steps.and_then(Iterator::max) {
        Some(most) => format!("{division}, up to {most} in a step"),
        None => division,
    }
}

/// Numbers without a limit, per step and edge; `own` are the edges with the nodes of each step.
fn missing(
    model: &Model,
    solved: &Solved,
    own: &[Vec<EdgeGeometry>],
    steps: &[Vec<EdgeResults>],
) -> Vec<Vec<Missing>> {
    let contacts = solved.interface.contacts();
    let steps = solved.records.iter().zip(own).zip(steps);
    let edges = steps.map(|((record, own), step)| {
        let edges = own.iter().zip(step).enumerate();
        edges
            .map(|(edge, (geometry, results))| {
                Missing::of(model, contacts, record, (edge, geometry, results))
            })
            .collect()
    });
    edges.collect()
}

/// Largest spacing of nodes along an edge.
fn spacing(geometry: &EdgeGeometry) -> f64 {
    let gaps = geometry.parameter.windows(2).map(|pair| pair[1] - pair[0]);
    gaps.fold(0.0, f64::max)
}
