//! Where curves meet of which one at least is a spline, by halving both until they are straight.

use stickslip_fem_core::generate::unit_vector;
use stickslip_fem_core::mesh::Point;

use crate::cubic::{Cubic, angle_between, on_segment};
use crate::curve::{Bend, Track};
use crate::spline::Run;
use crate::vector::{along, cross, distance, middle, minus};

/// Angle of an arc that is first halved `[rad]`.
const STEP: f64 = 0.25;
/// Angle between the directions of neighbours at a joint `[rad]`, up to which their first parts, which turn by less than [`STEP`] each, meet nowhere else: together they turn by less than π.
const SMOOTH: f64 = 2.0;
/// Deviation from a chord that counts as straight over the distance at which curves meet, and over the shorter of two curves with a corner.
const STRAIGHT: [f64; 2] = [0.25, 2.5e-9];

/// A part of a curve.
#[derive(Clone, Copy)]
enum Part {
    Line([Point; 2]),
    Arc(Bend),
    Cubic(Cubic),
}

/// How near two curves are where they meet.
#[derive(Clone, Copy)]
struct Near {
    /// Distance at which they meet `[length]`.
    tolerance: f64,
    /// Deviation from a chord that counts as straight `[length]`.
    straight: f64,
}

/// A place that `is_free` where two curves come as near as `tolerance` to each other; `joints` say whether `b` begins where `a` ends, and `a` where `b` ends.
pub(crate) fn tracks(
    [a, b]: [&Track; 2],
    joints: [bool; 2],
    tolerance: f64,
    is_free: impl Fn(Point) -> bool,
) -> Option<Point> {
    let [own, other] = [a, b].map(parts);
    let [last, other_last] = [own.len() - 1, other.len() - 1];
    let ([from, to], [start, end]) = (a.tangents(), b.tangents());
    let turns = [angle_between(to, start), angle_between(end, from)];
    let shorter = a.length().min(b.length());
    for (i, p) in own.iter().enumerate() {
        for (j, q) in other.iter().enumerate() {
            let joint = [
                joints[0] && i == last && j == 0,
                joints[1] && i == 0 && j == other_last,
            ];
            let is_joint = joint[0] || joint[1];
            if (0..2).any(|k| joint[k] && turns[k] <= SMOOTH) {
                continue;
            }
            let near = Near {
                tolerance: if is_joint { 0.0 } else { tolerance },
                straight: (STRAIGHT[0] * tolerance).min(STRAIGHT[1] * shorter),
            };
            if let Some(at) = meet([*p, *q], near, &is_free) {
                return Some(at);
            }
        }
    }
    None
}

/// A place where a spline comes as near as `tolerance` to itself.
pub(crate) fn itself(run: &Run, tolerance: f64) -> Option<Point> {
    let parts: Vec<Part> = run.cubics().map(|cubic| Part::Cubic(*cubic)).collect();
    let near = Near {
        tolerance,
        straight: STRAIGHT[0] * tolerance,
    };
    let pairs = (0..parts.len()).flat_map(|i| (i + 2..parts.len()).map(move |j| [i, j]));
    let mut places = pairs.filter_map(|pair| meet(pair.map(|k| parts[k]), near, &|_| true));
    places.next()
}

fn parts(track: &Track) -> Vec<Part> {
    if let Some(run) = track.run() {
        return run.cubics().map(|cubic| Part::Cubic(*cubic)).collect();
    }
    let Some(bend) = track.bend() else {
        return vec![Part::Line([track.from, track.to])];
    };
    let count = (bend.sweep.abs() / STEP).ceil().max(1.0);
    let sweep = bend.sweep / count;
    let part = |k: usize| {
        let start = bend.start + k as f64 * sweep;
        Part::Arc(Bend {
            start,
            sweep,
            ..*bend
        })
    };
    (0..count as usize).map(part).collect()
}

fn meet([a, b]: [Part; 2], near: Near, is_free: &dyn Fn(Point) -> bool) -> Option<Point> {
    let [own, other] = [a.ends(), b.ends()];
    let sags = [a.sag(), b.sag()];
    let reach = near.tolerance + sags[0] + sags[1];
    let [radius, wide] = [own, other].map(|[from, to]| 0.5 * distance(from, to));
    let between = distance(middle(own[0], own[1]), middle(other[0], other[1]));
    if between > radius + wide + reach {
        return None;
    }
    let (at, apart) = closest(own, other);
    if apart > reach {
        return None;
    }
    if sags[0].max(sags[1]) <= near.straight {
        return is_free(at).then_some(at);
    }
    let pairs = if sags[0] >= sags[1] {
        a.halves().map(|half| [half, b])
    } else {
        b.halves().map(|half| [a, half])
    };
    pairs.into_iter().find_map(|pair| meet(pair, near, is_free))
}

impl Part {
    fn ends(&self) -> [Point; 2] {
        match self {
            Self::Line(ends) => *ends,
            Self::Arc(bend) => [bend.start, bend.start + bend.sweep]
                .map(|angle| along(bend.centre, bend.radius, unit_vector(angle))),
            Self::Cubic(cubic) => [cubic.0[0], cubic.0[3]],
        }
    }

    /// Distance from its chord that no point of it exceeds `[length]`.
    fn sag(&self) -> f64 {
        match self {
            Self::Line(_) => 0.0,
            Self::Arc(bend) => 2.0 * bend.radius * (0.25 * bend.sweep).sin().powi(2),
            Self::Cubic(cubic) => cubic.sag(),
        }
    }

    fn halves(&self) -> [Self; 2] {
        match self {
            Self::Line([from, to]) => {
                let half = middle(*from, *to);
                [Self::Line([*from, half]), Self::Line([half, *to])]
            }
            Self::Arc(bend) => {
                let sweep = 0.5 * bend.sweep;
                [bend.start, bend.start + sweep].map(|start| {
                    Self::Arc(Bend {
                        start,
                        sweep,
                        ..*bend
                    })
                })
            }
            Self::Cubic(cubic) => cubic.halves().map(Self::Cubic),
        }
    }
}

/// Where two segments come nearest to each other, and the distance.
fn closest(a: [Point; 2], b: [Point; 2]) -> (Point, f64) {
    let (u, v, w) = (minus(a[1], a[0]), minus(b[1], b[0]), minus(b[0], a[0]));
    let [s, t] = [cross(w, v), cross(w, u)].map(|part| part / cross(u, v));
    if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
        return (along(a[0], s, u), 0.0);
    }
    let feet = b.map(|end| (end, on_segment(a, end)));
    let feet = feet
        .into_iter()
        .chain(a.map(|end| (end, on_segment(b, end))));
    let places = feet.map(|(end, foot)| (middle(end, foot), distance(end, foot)));
    let nearest = places.min_by(|a, b| a.1.total_cmp(&b.1));
    nearest.unwrap_or((a[0], f64::INFINITY))
}
