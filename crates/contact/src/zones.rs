//! Where a pair is open, sticks and slips, with ends that do not sit on nodes.
//!
//! Near the end of contact of smooth bodies the pressure falls as the root of the distance to the end, so p² is linear
//! there, and the gap opens as distance^{3/2}, so g^{2/3} is. The end is where p² of the last touching points, extrapolated,
//! vanishes, kept between the last touching and the first open point. Stick ends half-way between a sticking and a
//! slipping point.

use std::ops::Range;

use crate::problem::InterfaceProblem;
use crate::state::{ContactState, Status};

/// A run of equal status along a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zone {
    /// Status of all its points.
    pub status: Status,
    /// Where it starts, in the parameter given.
    pub start: f64,
    /// Where it ends.
    pub end: f64,
}

/// Zones of pair `pair` in walk order. `parameter` is the place of each of its points along the contact (angle or length),
/// ascending.
pub fn zones(
    problem: &InterfaceProblem,
    state: &ContactState,
    pair: usize,
    parameter: &[f64],
) -> Vec<Zone> {
    let range = problem.pair_points(pair);
    let status = &seen_status(problem, state, range.clone());
    let squared: Vec<f64> = range
        .map(|k| (state.normal_force(k) / problem.points()[k].area).powi(2))
        .collect();
    let mut zones: Vec<Zone> = Vec::new();
    for k in 0..status.len() {
        match zones.last_mut() {
            Some(last) if last.status == status[k] => last.end = parameter[k],
            Some(last) => {
                let border = border(status, &squared, parameter, k - 1);
                last.end = border;
                zones.push(Zone {
                    status: status[k],
                    start: border,
                    end: parameter[k],
                });
            }
            None => zones.push(Zone {
                status: status[k],
                start: parameter[k],
                end: parameter[k],
            }),
        }
    }
    zones
}

/// Whether friction carries anything at the touching points of pair `pair`: under a law without friction it cannot, and then
/// there is no stick to speak of.
pub fn carries_friction(problem: &InterfaceProblem, state: &ContactState, pair: usize) -> bool {
    problem.pair_points(pair).any(|k| {
        let point = &problem.points()[k];
        let pressure = state.normal_force(k) / point.area;
        let bound = problem
            .law(k)
            .bound(pressure, 0.0, &point.place, &state.history[k]);
        state.status[k].touches() && (bound.stick > 0.0 || bound.slip > 0.0)
    })
}

/// Statuses of the points `range`; one that touches but cannot slide (on a line of symmetry) takes its neighbour's.
fn seen_status(
    problem: &InterfaceProblem,
    state: &ContactState,
    range: Range<usize>,
) -> Vec<Status> {
    let mut status = state.status[range.clone()].to_vec();
    let count = status.len();
    for (k, point) in problem.points()[range].iter().enumerate() {
        let neighbour = if k + 1 < count {
            k + 1
        } else {
            k.saturating_sub(1)
        };
        if status[k].touches() && !point.slides && status[neighbour].touches() {
            status[k] = status[neighbour];
        }
    }
    status
}

/// Place of the change of status between points `left` and `left + 1`.
fn border(status: &[Status], squared: &[f64], parameter: &[f64], left: usize) -> f64 {
    let (here, there) = (parameter[left], parameter[left + 1]);
    let middle = f64::midpoint(here, there);
    match (status[left].touches(), status[left + 1].touches()) {
        (true, false) => {
            let run = status[..=left]
                .iter()
                .rev()
                .take_while(|status| status.touches())
                .count();
            let inner = (0..run).map(|k| (parameter[left - k], squared[left - k]));
            end_of_contact(inner).clamp(here, there)
        }
        (false, true) => {
            let run = status[left + 1..]
                .iter()
                .take_while(|status| status.touches())
                .count();
            let inner = (0..run).map(|k| (parameter[left + 1 + k], squared[left + 1 + k]));
            end_of_contact(inner).clamp(here, there)
        }
        _ => middle,
    }
}

/// Root of p², extrapolated linearly from the touching points next to the end, the nearest first.
fn end_of_contact(mut inner: impl Iterator<Item = (f64, f64)>) -> f64 {
    let Some((x1, p1)) = inner.next() else {
        return f64::NAN;
    };
    let Some((x2, p2)) = inner.next() else {
        return x1;
    };
    if p2 > p1 {
        x1 + (x1 - x2) * p1 / (p2 - p1)
    } else {
        x1
    }
}
