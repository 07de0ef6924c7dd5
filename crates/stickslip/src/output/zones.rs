//! Zones of contact, stick and slip in display units, closed where the edge is a full circle.

use std::f64::consts::TAU;

use stickslip_contact::Status;

use super::display::EdgeView;

/// Largest angle between two nodes of a closed circle `[rad]`.
const LARGEST_INTERVAL: f64 = 0.5;

/// Where a closed circle that starts at its first node ends again `[deg]`; `None` for every other edge.
pub(super) fn closing_angle(view: &EdgeView<'_>) -> Option<f64> {
    let parameter = &view.geometry.parameter;
    let (first, last) = parameter.first().zip(parameter.last())?;
    // The last interval of a closed edge is as short as its others; an arc ends for good.
    let open = TAU - (last - first);
    let closed = view.is_circle() && !view.geometry.half && open > 0.0 && open < LARGEST_INTERVAL;
    closed.then(|| view.place(first + TAU))
}

/// Zones of a step along the place axis, the last one up to where a closed circle ends.
pub(super) fn zone_ranges(view: &EdgeView<'_>, step: usize) -> Vec<(Status, [f64; 2])> {
    let zones = view.step(step).zones.iter();
    let mut ranges: Vec<_> = zones
        .map(|zone| (zone.status, [view.place(zone.start), view.place(zone.end)]))
        .collect();
    if let (Some(end), Some((_, range))) = (closing_angle(view), ranges.last_mut()) {
        range[1] = end;
    }
    ranges
}

/// Where the bodies touch, stick and slip joined.
pub(super) fn contact_ranges(view: &EdgeView<'_>, step: usize) -> Vec<[f64; 2]> {
    let ranges = zone_ranges(view, step);
    let runs = ranges.chunk_by(|(one, _), (other, _)| one.touches() == other.touches());
    let touching = runs.filter(|run| run.iter().any(|(status, _)| status.touches()));
    touching
        .filter_map(|run| Some([run.first()?.1[0], run.last()?.1[1]]))
        .collect()
}
