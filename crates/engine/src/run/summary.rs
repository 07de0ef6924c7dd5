//! Sums, extents and zones of an edge at the end of a load step.

use stickslip_contact::zones::{
    Zone, carries_friction, ends_of_contact, half_extent, mirrored, zones,
};
use stickslip_contact::{ContactState, Contacts};

use super::reported::Reported;
use super::solved::Solved;
use crate::model::{Model, ModelEdge};
use crate::results::{EdgeGeometry, EdgeKind, EdgeResults, EdgeRow, Errors, wrapped};

/// Uncertainty of the largest tangential stress if it lies within four nodes of an end of contact.
fn cusp_uncertainty(rows: &[EdgeRow], ends: &[f64], geometry: &EdgeGeometry) -> Option<f64> {
    const REACH: usize = 4;
    let (count, parameter) = (rows.len(), &geometry.parameter);
    let stress = |k: usize| rows[k].sigma_tangential;
    let peak = (0..count).max_by(|&a, &b| stress(a).total_cmp(&stress(b)))?;
    let round = geometry.closed().is_some();
    let walk_closes = round && !geometry.half;
    let away = |place: f64| {
        let apart = place - parameter[peak];
        if round { wrapped(apart) } else { apart }
    };
    let before = |offset: usize| match peak.checked_sub(offset) {
        None if walk_closes => Some((peak + count - offset % count) % count),
        found => found,
    };
    let after = |offset: usize| match peak + offset {
        k if walk_closes => Some(k % count),
        k => Some(k).filter(|&k| k < count),
    };
    let near = away(parameter[before(REACH).unwrap_or(0)])
        ..=away(parameter[after(REACH).unwrap_or(count - 1)]);
    if !ends.iter().any(|&end| near.contains(&away(end))) {
        return None;
    }
    let neighbours = [before(1), after(1)];
    neighbours
        .into_iter()
        .flatten()
        .map(|k| (stress(peak) - stress(k)).abs())
        .reduce(f64::max)
}

/// Zones of the whole edge, of which the model may be half.
fn whole_zones(
    contacts: &Contacts,
    state: &ContactState,
    pair: usize,
    geometry: &EdgeGeometry,
) -> Vec<Zone> {
    let (parameter, closed) = (&geometry.parameter, geometry.closed());
    if geometry.half {
        mirrored(&zones(contacts, state, pair, parameter, None), closed)
    } else {
        zones(contacts, state, pair, parameter, closed)
    }
}

/// What does not depend on the bearing point, which `bearing::find` adds.
pub(super) fn summarise(
    model: &Model,
    solved: &Solved,
    edge: &ModelEdge,
    rows: Vec<EdgeRow>,
    reported: &Reported,
) -> EdgeResults {
    let (half, contacts, state) = (model.half, solved.interface.contacts(), &reported.state);
    let zones = edge.pair.map_or_else(Vec::new, |pair| {
        whole_zones(contacts, state, pair, &edge.geometry)
    });
    let closed = edge.geometry.closed();
    let rubs = edge
        .pair
        .is_some_and(|pair| carries_friction(contacts, state, pair));
    let extent = half_extent(&zones, closed);
    let (resultant, normal, work) = edge.pair.map_or_else(Default::default, |pair| {
        let [x, y] = reported.sums[pair].resultant;
        let whole = match (half, edge.geometry.kind) {
            (false, _) => [x, y],
            (true, EdgeKind::Circle { .. }) => [2.0 * x, 0.0],
            (true, EdgeKind::Line | EdgeKind::Path) => [0.0, 2.0 * y],
        };
        let work = reported.friction_work[pair];
        (whole, reported.sums[pair].normal, work)
    });
    let both = if half { 2.0 } else { 1.0 };
    let is_bounded = !edge.corners_that_press(&rows).contains(&true);
    EdgeResults {
        contact_half_extent: extent,
        stick_half_extent: extent.filter(|_| rubs),
        peak_hoop_uncertainty: cusp_uncertainty(
            &rows,
            &ends_of_contact(&zones, closed),
            &edge.geometry,
        )
        .filter(|_| is_bounded),
        resultant,
        normal_force: both * normal,
        friction_work: both * work,
        rows,
        zones,
        // What `bearing::find` and the ladder fill; without `..`, so that a new number is computed somewhere.
        bearing: None,
        slip_lengths: None,
        peak_pressure: None,
        peak_hoop: None,
        hoop_at_bearing_point: None,
        friction_force: 0.0,
        errors: Errors::default(),
        row_errors: Vec::new(),
    }
}
