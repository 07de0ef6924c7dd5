//! Zones of contact, stick and slip in display units, as seen from the bearing point.
//!
//! About a bearing point, slip is named by its direction relative to the point: [`Status::SlipPositive`] stands for slip of the first
//! body's edge away from the bearing point of the step, [`Status::SlipNegative`] for slip towards it. This is independent of the side of
//! the point on which the zone lies, and of how the scene is turned or mirrored. Elsewhere both mean slip along ±e_t.

use std::f64::consts::PI;

use stickslip_contact::Status;

use super::display::EdgeView;
use stickslip_engine::results::wrapped;

/// Largest angle between two nodes of a closed circle `[rad]`.
const LARGEST_INTERVAL: f64 = 0.5;
/// Ranges of this length `[rad]` are rounding.
const ROUNDING: f64 = 1e-9;
/// A whole turn in display units.
const TURN: f64 = 360.0;

/// A range of places `[rad or mm]` of one status.
type Range = (Status, [f64; 2]);

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

/// Zones of a step on the whole edge, ascending; one across 180° ends beyond it.
pub(super) fn zone_ranges(view: &EdgeView<'_>, step: usize) -> Vec<Range> {
    let frame = &view.geometry.frame;
    let zones = view.step(step).zones.iter();
    let mut ranges: Vec<Range> = if view.is_circle() {
        let seen = zones.map(|zone| (zone.status, frame.range([zone.start, zone.end])));
        about_bearing(view, step, seen.collect())
    } else {
        zones
            .map(|zone| (zone.status, [zone.start, zone.end]))
            .collect()
    };
    ranges.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
    ranges
        .into_iter()
        .map(|(status, ends)| (status, ends.map(|end| view.length(end))))
        .collect()
}

/// Slip zones of a circle by where they go from the bearing point; those on both sides of it are two.
fn about_bearing(view: &EdgeView<'_>, step: usize, mut ranges: Vec<Range>) -> Vec<Range> {
    let Some(bearing) = view.judged_from(step) else {
        return ranges;
    };
    ranges.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
    let from = view.geometry.frame.turned(bearing);
    for cut in [from - PI, from, from + PI] {
        turn_at(&mut ranges, cut, interval(view, bearing + (cut - from)));
    }
    let cut = |(status, [start, end]): Range| {
        let cuts = (-2..=2).map(|k| from + f64::from(k) * PI);
        let mut ends = vec![start];
        if status.slip_sign() != 0.0 {
            ends.extend(cuts.filter(|cut| start + ROUNDING < *cut && *cut < end - ROUNDING));
        }
        ends.push(end);
        let parts = ends.windows(2).map(move |ends| {
            let middle = wrapped(0.5 * (ends[0] + ends[1]) - from);
            let status = match status {
                Status::SlipPositive | Status::SlipNegative => {
                    Status::slip_along(middle * status.slip_sign())
                }
                other => other,
            };
            let turn = if ends[0] > PI - ROUNDING {
                -2.0 * PI
            } else {
                0.0
            };
            (status, [ends[0] + turn, ends[1] + turn])
        });
        parts.collect::<Vec<_>>()
    };
    ranges.into_iter().flat_map(cut).collect()
}

/// Slip turns at a node; where that is the node nearest to `cut`, it turns there.
fn turn_at(ranges: &mut [Range], cut: f64, reach: f64) {
    let near = |place: f64| (place - cut).abs() <= reach;
    let turns = |one: Status, other: Status| one.slip_sign() * other.slip_sign() < 0.0;
    for k in 1..ranges.len() {
        let (before, after) = ranges.split_at_mut(k);
        if let (Some(one), Some(other)) = (before.last_mut(), after.first_mut())
            && turns(one.0, other.0)
            && near(other.1[0])
            && one.1[0] < cut
            && cut < other.1[1]
        {
            one.1[1] = cut;
            other.1[0] = cut;
        }
    }
    if let [first, .., last] = ranges
        && turns(last.0, first.0)
        && near(last.1[1])
        && last.1[0] < cut
        && cut < first.1[1] + 2.0 * PI
    {
        last.1[1] = cut;
        first.1[0] = cut - 2.0 * PI;
    }
}

/// The longer of the intervals between nodes beside the place `theta`.
fn interval(view: &EdgeView<'_>, theta: f64) -> f64 {
    let away = || (view.geometry.parameter.iter()).map(|&at| wrapped(at - theta).abs());
    let mut near: Vec<f64> = away().collect();
    near.sort_by(f64::total_cmp);
    // On a node its neighbours follow; between two nodes both stand first.
    match near[..] {
        [first, second, third, ..] if first <= ROUNDING => second.max(third.min(2.0 * second)),
        [first, second, ..] => first + second,
        _ => 0.0,
    }
}

/// Zones within a part of the edge in display units: one across 180° is two.
pub(super) fn shown_ranges(view: &EdgeView<'_>, step: usize) -> Vec<Range> {
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

/// Total length of the zones of a status in display units; `None` without contact.
pub(super) fn zone_length(view: &EdgeView<'_>, step: usize, status: Status) -> Option<f64> {
    let ranges = zone_ranges(view, step);
    let touches = ranges.iter().any(|(status, _)| status.touches());
    let own = ranges.iter().filter(|zone| zone.0 == status);
    touches.then(|| own.map(|(_, [start, end])| end - start).sum())
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
