//! Zones of contact, stick and slip as seen from the bearing point.
//!
//! About a bearing point, slip is named by its direction relative to the point: [`Status::SlipPositive`] stands for slip of the first
//! body's edge away from the bearing point of the step, [`Status::SlipNegative`] for slip towards it. This is independent of the side of
//! the point on which the zone lies, and of how the scene is turned or mirrored. Elsewhere both mean slip along ±e_t.

use std::f64::consts::PI;

use stickslip_contact::Status;

use super::{EdgeGeometry, EdgeKind, EdgeResults, wrapped};

/// Ranges of this length `[rad]` are rounding.
const ROUNDING: f64 = 1e-9;

/// A range of places `[rad or mm]` of one status.
pub type ZoneRange = (Status, [f64; 2]);

impl EdgeResults {
    /// The place from which slip and friction are judged `[rad or mm]`: the step's own bearing point, or that of the frame of `geometry`.
    pub fn judged_from(&self, geometry: &EdgeGeometry) -> Option<f64> {
        self.bearing.or(geometry.frame.bearing)
    }

    /// Zones of the whole edge as a reader sees them, ascending; one across 180° ends beyond it.
    pub fn zones_seen(&self, geometry: &EdgeGeometry) -> Vec<ZoneRange> {
        let zones = self.zones.iter();
        let mut ranges: Vec<ZoneRange> = match geometry.kind {
            EdgeKind::Circle { .. } => {
                let frame = &geometry.frame;
                let seen = zones.map(|zone| (zone.status, frame.range([zone.start, zone.end])));
                about_bearing(geometry, self.judged_from(geometry), seen.collect())
            }
            EdgeKind::Line | EdgeKind::Path => zones
                .map(|zone| (zone.status, [zone.start, zone.end]))
                .collect(),
        };
        ranges.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
        ranges
    }

    /// Total lengths of the zones that slip away from the bearing point and towards it, or along ±e_t `[rad or mm]`; `None` without contact.
    pub fn lengths_of_slip(&self, geometry: &EdgeGeometry) -> Option<[f64; 2]> {
        let ranges = self.zones_seen(geometry);
        let length = |status| {
            let own = ranges.iter().filter(|zone| zone.0 == status);
            own.map(|(_, [start, end])| end - start).sum()
        };
        let touches = ranges.iter().any(|(status, _)| status.touches());
        touches.then(|| [Status::SlipPositive, Status::SlipNegative].map(length))
    }
}

/// Slip zones of a circle by where they go from the bearing point; those on both sides of it are two.
fn about_bearing(
    geometry: &EdgeGeometry,
    bearing: Option<f64>,
    mut ranges: Vec<ZoneRange>,
) -> Vec<ZoneRange> {
    let Some(bearing) = bearing else {
        return ranges;
    };
    ranges.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
    let from = geometry.frame.turned(bearing);
    for cut in [from - PI, from, from + PI] {
        turn_at(&mut ranges, cut, interval(geometry, bearing + (cut - from)));
    }
    let cut = |(status, [start, end]): ZoneRange| {
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
fn turn_at(ranges: &mut [ZoneRange], cut: f64, reach: f64) {
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
fn interval(geometry: &EdgeGeometry, theta: f64) -> f64 {
    let away = || (geometry.parameter.iter()).map(|&at| wrapped(at - theta).abs());
    let mut near: Vec<f64> = away().collect();
    near.sort_by(f64::total_cmp);
    // On a node its neighbours follow; between two nodes both stand first.
    match near[..] {
        [first, second, third, ..] if first <= ROUNDING => second.max(third.min(2.0 * second)),
        [first, second, ..] => first + second,
        _ => 0.0,
    }
}
