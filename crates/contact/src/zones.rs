//! Where a pair is open, sticks and slips, with ends that do not sit on nodes.
//!
//! Near the end of contact of smooth bodies the pressure falls as the root of the distance to the end, so p² is linear
//! there; the gap opens as distance^{3/2}, so g^{2/3} is linear. The end is where p² of the last touching points, extrapolated,
//! vanishes, kept between the last touching and the first open point. Stick ends half-way between a sticking and a
//! slipping point. A single point that sticks between slips of opposite signs marks the reversal of slip and is not a zone.
//!
//! A closed contact has no first point: its zones are joined across the place where its walk starts, and a mirrored half
//! ([`mirrored`]) has the zones of the whole.

use crate::problem::Contacts;
use crate::state::{ContactState, Status};

/// A run of equal status along a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zone {
    /// Status of all its points.
    pub status: Status,
    /// Where it starts, in the unit of the parameter.
    pub start: f64,
    /// Where it ends, in the unit of the parameter. On a closed contact a zone across the place where the walk starts ends beyond that place's second visit.
    pub end: f64,
}

impl Zone {
    /// Its length, in the unit of the parameter.
    pub fn length(&self) -> f64 {
        self.end - self.start
    }
}

/// Zones of pair `pair` in walk order. `parameter` is the place of each of its points along the contact (angle or length),
/// ascending; `closed` is the length after which the contact closes on itself, in the unit of `parameter` (2π for angles), if it does.
pub fn zones(
    contacts: &Contacts,
    state: &ContactState,
    pair: usize,
    parameter: &[f64],
    closed: Option<f64>,
) -> Vec<Zone> {
    let range = contacts.pair_points(pair);
    let slides: Vec<bool> = contacts.points()[range.clone()]
        .iter()
        .map(|point| point.slides)
        .collect();
    let squared = range
        .clone()
        .map(|k| (state.normal_force(k) / contacts.points()[k].area).powi(2))
        .collect();
    Course::new(
        state.status[range].to_vec(),
        &slides,
        squared,
        parameter,
        closed,
    )
    .zones()
}

/// Zones of the whole contact from those of its half, which lies at places ≥ 0; the mirror turns the direction of slip.
/// `closed` as in [`zones`]: then the half ends at half of that length, in the unit of the zones.
pub fn mirrored(half: &[Zone], closed: Option<f64>) -> Vec<Zone> {
    let image = |zone: &Zone| Zone {
        status: match zone.status {
            Status::SlipPositive => Status::SlipNegative,
            Status::SlipNegative => Status::SlipPositive,
            status => status,
        },
        start: 0.0 - zone.end,
        end: 0.0 - zone.start,
    };
    joined(
        half.iter().rev().map(image).chain(half.iter().copied()),
        closed,
    )
}

/// Half of what the contact reaches over, in the unit of the zones, gaps between its parts included: half of the distance from its first to its last place,
/// on a closed one half of all but the longest opening. `None` where nothing touches.
pub fn half_extent(zones: &[Zone], closed: Option<f64>) -> Option<f64> {
    let mut touching = zones.iter().filter(|zone| zone.status.touches());
    let first = touching.next()?;
    let last = touching.next_back().unwrap_or(first);
    let reach = match closed {
        Some(length) => {
            let open = zones.iter().filter(|zone| !zone.status.touches());
            length - open.map(Zone::length).fold(0.0, f64::max)
        }
        None => last.end - first.start,
    };
    Some(0.5 * reach)
}

/// Places where contact begins or ends, in the unit of the zones and in the order of the walk; on a `closed` line, as in [`zones`], its start comes last. The ends of
/// an open line do not count.
pub fn ends_of_contact(zones: &[Zone], closed: Option<f64>) -> Vec<f64> {
    let differ = |one: &Zone, other: &Zone| one.status.touches() != other.status.touches();
    let pairs = zones.windows(2).filter(|pair| differ(&pair[0], &pair[1]));
    let mut ends: Vec<f64> = pairs.map(|pair| pair[1].start).collect();
    if let (Some(_), [first, .., last]) = (closed, zones)
        && differ(last, first)
    {
        ends.push(first.start);
    }
    ends
}

/// Joins neighbours of equal status, also the last with the first where they meet.
fn joined(zones: impl IntoIterator<Item = Zone>, closed: Option<f64>) -> Vec<Zone> {
    let mut joined: Vec<Zone> = Vec::new();
    for zone in zones {
        match joined.last_mut() {
            Some(last) if last.status == zone.status => last.end = zone.end,
            _ => joined.push(zone),
        }
    }
    if let (Some(length), [first, .., last]) = (closed, &mut joined[..])
        && first.status == last.status
    {
        last.end = first.end + length;
        // A zone that starts where the walk ends starts where it begins.
        if last.start >= first.start + length {
            last.start -= length;
            last.end -= length;
            *first = *last;
            joined.pop();
        } else {
            joined.remove(0);
        }
    }
    joined
}

/// Whether friction carries anything at the touching points of pair `pair`: under a law without friction it cannot, and then
/// there is no stick to speak of.
pub fn carries_friction(contacts: &Contacts, state: &ContactState, pair: usize) -> bool {
    contacts.pair_points(pair).any(|k| {
        let point = &contacts.points()[k];
        let pressure = state.normal_force(k) / point.area;
        let bound = contacts
            .law(k)
            .bound(pressure, 0.0, &point.place, &state.history[k]);
        state.status[k].touches() && (bound.stick > 0.0 || bound.slip > 0.0)
    })
}

/// The points of a pair in walk order.
struct Course<'a> {
    /// Statuses; a point without one of its own has that of a neighbour.
    status: Vec<Status>,
    /// Where slip turns at a point.
    turns: Vec<bool>,
    /// p² of each point.
    squared: Vec<f64>,
    parameter: &'a [f64],
    closed: Option<f64>,
}

impl<'a> Course<'a> {
    fn new(
        status: Vec<Status>,
        slides: &[bool],
        squared: Vec<f64>,
        parameter: &'a [f64],
        closed: Option<f64>,
    ) -> Self {
        let mut course = Self {
            turns: vec![false; status.len()],
            status,
            squared,
            parameter,
            closed,
        };
        course.see(slides);
        course
    }

    /// Gives a point that touches but cannot slide (on a line of symmetry), and one where slip turns, the status of a neighbour.
    fn see(&mut self, slides: &[bool]) {
        let count = self.status.len();
        let given = self.status.clone();
        let neighbours = |k: usize| match self.closed {
            Some(_) => [Some((k + count - 1) % count), Some((k + 1) % count)],
            None => [k.checked_sub(1), Some(k + 1).filter(|&k| k < count)],
        };
        for k in (0..count).filter(|&k| given[k].touches()) {
            let [before, after] = neighbours(k).map(|neighbour| neighbour.map(|k| given[k]));
            let sign = |status: Option<Status>| status.map_or(0.0, Status::slip_sign);
            if given[k] == Status::Stick && sign(before) * sign(after) < 0.0 {
                self.turns[k] = true;
                self.status[k] = before.unwrap_or_default();
            } else if !slides[k]
                && let Some(seen) = after.or(before).filter(|status| status.touches())
            {
                self.status[k] = seen;
            }
        }
    }

    fn zones(&self) -> Vec<Zone> {
        let (Some(&first), Some(&last)) = (self.parameter.first(), self.parameter.last()) else {
            return Vec::new();
        };
        let count = self.status.len();
        let (end, borders) = match self.closed {
            Some(length) => (first + length, count),
            None => (last, count - 1),
        };
        let mut start = first;
        let mut runs = Vec::new();
        for left in (0..borders).filter(|&k| self.status[k] != self.status[(k + 1) % count]) {
            let border = self.border(left);
            runs.push(Zone {
                status: self.status[left],
                start,
                end: border,
            });
            start = border;
        }
        runs.push(Zone {
            status: self.status[borders % count],
            start,
            end,
        });
        joined(runs, self.closed)
    }

    /// Status, p² and place of the point `offset` points from `from`, if the contact goes that far.
    fn point(&self, from: usize, offset: isize) -> Option<(Status, f64, f64)> {
        let count = self.status.len() as isize;
        let at = from as isize + offset;
        let turn = at.div_euclid(count);
        let length = self.closed.or((turn == 0).then_some(0.0))?;
        let k = at.rem_euclid(count) as usize;
        let place = self.parameter[k] + turn as f64 * length;
        Some((self.status[k], self.squared[k], place))
    }

    /// Place of the change of status between points `left` and `left + 1`.
    fn border(&self, left: usize) -> f64 {
        let place = |offset| self.point(left, offset).map(|(_, _, place)| place);
        let touching = |offset| {
            let point = self.point(left, offset);
            point
                .filter(|(status, _, _)| status.touches())
                .map(|(_, squared, place)| (place, squared))
        };
        let (Some(here), Some(there)) = (place(0), place(1)) else {
            return self.parameter[left];
        };
        match (touching(0), touching(1)) {
            (Some(end), None) => end_of_contact(end, touching(-1)).clamp(here, there),
            (None, Some(end)) => end_of_contact(end, touching(2)).clamp(here, there),
            _ if self.turns[left] => here,
            _ => f64::midpoint(here, there),
        }
    }
}

/// Root of p², extrapolated linearly from the last touching point and the one before it, each as place and p².
fn end_of_contact((x1, p1): (f64, f64), before: Option<(f64, f64)>) -> f64 {
    match before {
        Some((x2, p2)) if p2 > p1 => x1 + (x1 - x2) * p1 / (p2 - p1),
        _ => x1,
    }
}
