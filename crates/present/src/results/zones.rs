//! Zones of contact, stick and slip in display units, as seen from the bearing point.

use std::f64::consts::PI;

use stickslip_contact::Status;

use super::display::EdgeView;
use stickslip_results::ZoneRange;

/// Largest angle between two nodes of a closed circle `[rad]`.
const LARGEST_INTERVAL: f64 = 0.5;
/// A whole turn in display units.
const TURN: f64 = 360.0;

/// Whether the edge is a circle all of whose nodes are modelled.
pub(super) fn is_closed(view: &EdgeView<'_>) -> bool {
    let parameter = &view.geometry.parameter;
    let Some((first, last)) = parameter.first().zip(parameter.last()) else {
        return false;
    };
    // The last interval of a closed edge is as short as its others; an arc ends for good.
    let open = 2.0 * PI - (last - first);
    view.is_circle() && !view.geometry.half && open > 0.0 && open < LARGEST_INTERVAL
}

/// First and last place of the edge that is modelled, in display units.
pub(super) fn modelled(view: &EdgeView<'_>) -> Option<[f64; 2]> {
    if is_closed(view) {
        return Some([-0.5 * TURN, 0.5 * TURN]);
    }
    let places = || view.geometry.parameter.iter().map(|&at| view.place(at));
    Some([places().reduce(f64::min)?, places().reduce(f64::max)?])
}

/// Zones of a step on the whole edge, ascending, in display units; one across 180° ends beyond it.
pub(super) fn zone_ranges(view: &EdgeView<'_>, step: usize) -> Vec<ZoneRange> {
    let shown = |(status, ends): ZoneRange| (status, ends.map(|end| view.length(end)));
    let ranges = view.step(step).zones_seen(view.geometry);
    ranges.into_iter().map(shown).collect()
}

/// Zones within a part of the edge in display units: one across 180° is two.
pub(super) fn shown_ranges(view: &EdgeView<'_>, step: usize) -> Vec<ZoneRange> {
    let Some([low, high]) = modelled(view) else {
        return Vec::new();
    };
    let turns: &[f64] = if view.is_circle() {
        &[TURN, 0.0, -TURN]
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

/// Where the bodies stick.
pub(super) fn stick_ranges(view: &EdgeView<'_>, step: usize) -> Vec<[f64; 2]> {
    ranges_where(view, step, |status| status == Status::Stick)
}

/// Where the bodies touch, stick and slip joined.
pub(super) fn contact_ranges(view: &EdgeView<'_>, step: usize) -> Vec<[f64; 2]> {
    ranges_where(view, step, Status::touches)
}

/// What contact reaches over, gaps between its parts included: on a circle all but the longest opening.
pub(super) fn contact_reach(view: &EdgeView<'_>, step: usize) -> Option<[f64; 2]> {
    let touching = contact_ranges(view, step);
    let (first, last) = touching.first().zip(touching.last())?;
    if !view.is_circle() || touching.len() == 1 {
        return Some([first[0], last[1]]);
    }
    // The opening before each part, the first one's going around.
    let before = |k: usize| match k.checked_sub(1) {
        Some(before) => touching[k][0] - touching[before][1],
        None => first[0] + TURN - last[1],
    };
    let start = (0..touching.len()).max_by(|&a, &b| before(a).total_cmp(&before(b)))?;
    let end = match start.checked_sub(1) {
        Some(before) => touching[before][1] + TURN,
        None => last[1],
    };
    let middle = 0.5 * (touching[start][0] + end);
    let turn = if middle > 0.5 * TURN { TURN } else { 0.0 };
    Some([touching[start][0] - turn, end - turn])
}

/// Ranges of a kind, neighbours joined.
fn ranges_where(view: &EdgeView<'_>, step: usize, is_so: fn(Status) -> bool) -> Vec<[f64; 2]> {
    let ranges = zone_ranges(view, step);
    let runs = ranges.chunk_by(|(one, _), (other, _)| is_so(*one) == is_so(*other));
    let wanted = runs.filter(|run| run.iter().any(|(status, _)| is_so(*status)));
    let mut joined: Vec<[f64; 2]> = wanted
        .filter_map(|run| Some([run.first()?.1[0], run.last()?.1[1]]))
        .collect();
    if !view.is_circle() {
        return joined;
    }
    let meet = |end: f64, start: f64| (end - start - TURN).abs() < 1e-9 * TURN;
    match &mut joined[..] {
        // All around, whatever the status in which the walk starts.
        [all] if meet(all[1], all[0]) => *all = [-0.5 * TURN, 0.5 * TURN],
        [first, .., last] if meet(last[1], first[0]) => {
            last[1] = first[1] + TURN;
            joined.remove(0);
        }
        _ => {}
    }
    joined
}
