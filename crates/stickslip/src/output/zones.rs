//! Zones of contact, stick and slip in display units.

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

/// Zones of a step on the whole edge; one across 180° ends beyond it.
pub(super) fn zone_ranges(view: &EdgeView<'_>, step: usize) -> Vec<(Status, [f64; 2])> {
    let zones = view.step(step).zones.iter();
    zones
        .map(|zone| (zone.status, [view.place(zone.start), view.place(zone.end)]))
        .collect()
}

/// The same as far as the edge is modelled, from its first node to its last: one across 180° is two.
pub(super) fn shown_ranges(view: &EdgeView<'_>, step: usize) -> Vec<(Status, [f64; 2])> {
    let parameter = &view.geometry.parameter;
    let Some((first, last)) = parameter.first().zip(parameter.last()) else {
        return Vec::new();
    };
    let low = view.place(*first);
    let high = closing_angle(view).unwrap_or(view.place(*last));
    let turns: &[f64] = if view.is_circle() {
        &[360.0, 0.0]
    } else {
        &[0.0]
    };
    let ranges = zone_ranges(view, step);
    let cut = |turn: &f64| {
        let turn = *turn;
        let within = ranges.iter().map(move |(status, [start, end])| {
            (*status, [(start - turn).max(low), (end - turn).min(high)])
        });
        within
            .filter(|(_, [start, end])| start < end)
            .collect::<Vec<_>>()
    };
    turns.iter().flat_map(cut).collect()
}

/// Where the bodies touch, stick and slip joined.
pub(super) fn contact_ranges(view: &EdgeView<'_>, step: usize) -> Vec<[f64; 2]> {
    let ranges = zone_ranges(view, step);
    let runs = ranges.chunk_by(|(one, _), (other, _)| one.touches() == other.touches());
    let touching = runs.filter(|run| run.iter().any(|(status, _)| status.touches()));
    let mut joined: Vec<[f64; 2]> = touching
        .filter_map(|run| Some([run.first()?.1[0], run.last()?.1[1]]))
        .collect();
    let Some(length) = view.geometry.closed().map(|length| view.place(length)) else {
        return joined;
    };
    let meet = |end: f64, start: f64| (end - start - length).abs() < 1e-9 * length;
    match &mut joined[..] {
        // All around, whatever the status in which the walk starts.
        [all] if meet(all[1], all[0]) => *all = [-0.5 * length, 0.5 * length],
        [first, .., last] if meet(last[1], first[0]) => {
            last[1] = first[1] + length;
            joined.remove(0);
        }
        _ => {}
    }
    joined
}
