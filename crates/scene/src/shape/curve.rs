//! The exact curves of edges.

use std::f64::consts::TAU;

use stickslip_fem_core::mesh::Point;
use stickslip_mesher as mesher;
use stickslip_mesher::{Course, Stretch};

/// An exact curve.
#[derive(Debug, Clone, PartialEq)]
pub enum Curve {
    /// A closed circle.
    Circle {
        /// Its centre `[mm]`.
        centre: Point,
        /// Its radius `[mm]`.
        radius: f64,
    },
    /// A part of a circle.
    Arc {
        /// Centre of the circle `[mm]`.
        centre: Point,
        /// Radius of the circle `[mm]`.
        radius: f64,
        /// Its ends `[mm]`; on the way from the first to the second the body is on the left.
        ends: [Point; 2],
        /// The angle on that way, counter-clockwise positive `[rad]`, less than 2π in magnitude.
        turn: f64,
    },
    /// A straight line.
    Segment {
        /// Its ends `[mm]`; on the way from the first to the second the body is on the left.
        ends: [Point; 2],
    },
    /// Anything else: a spline, several lines, arcs and splines, or an edge of a mesh whose curve is not known.
    Chain {
        /// The smallest and the largest x and y of its points `[mm]`.
        bounds: [Point; 2],
        /// Its lines, arcs and splines with the body on their left; empty where they are not known.
        stretches: Vec<Stretch>,
    },
}

impl Curve {
    /// A curve of which the nodes `places` are known.
    pub(super) fn chain(places: &[Point]) -> Self {
        let start = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        let bounds = places.iter().fold(start, |[low, high], at| {
            let less = [0, 1].map(|axis| f64::min(low[axis], at[axis]));
            let more = [0, 1].map(|axis| f64::max(high[axis], at[axis]));
            [less, more]
        });
        Self::Chain {
            bounds,
            stretches: Vec::new(),
        }
    }

    /// The spline between `ends`; `None` where its points make no curve.
    pub(super) fn spline(ends: [Point; 2], course: &Course) -> Option<Self> {
        let stretches = vec![Stretch {
            ends,
            course: course.clone(),
        }];
        Some(Self::Chain {
            bounds: mesher::Path::new(&stretches)?.bounds(),
            stretches,
        })
    }

    /// The curve along all of `curves`, each of which begins where the one before ends.
    pub(super) fn joined(curves: &[&Self]) -> Self {
        let stretches: Vec<Stretch> = curves.iter().flat_map(|own| own.stretches()).collect();
        match (curves, stretches.as_slice()) {
            (&[only], _) => only.clone(),
            (_, [first, .., last]) if are_straight(&stretches) => Self::Segment {
                ends: [first.ends[0], last.ends[1]],
            },
            _ => {
                let range = |axis| {
                    let all = curves.iter().map(move |own| own.range(axis));
                    all.fold(
                        [f64::INFINITY, f64::NEG_INFINITY],
                        |[low, high], [least, most]| [low.min(least), high.max(most)],
                    )
                };
                let [x, y] = [range(0), range(1)];
                Self::Chain {
                    bounds: [[x[0], y[0]], [x[1], y[1]]],
                    stretches,
                }
            }
        }
    }

    /// The lines, arcs and splines of an open curve with the body on their left; `None` of a closed one, and where they are not known.
    pub fn path(&self) -> Option<mesher::Path> {
        let stretches = self.stretches();
        let (first, last) = (stretches.first()?, stretches.last()?);
        let is_open = first.ends[0] != last.ends[1];
        is_open.then(|| mesher::Path::new(&stretches)).flatten()
    }

    /// Its lines, arcs and splines where they are known, of a circle none.
    fn stretches(&self) -> Vec<Stretch> {
        match *self {
            Self::Segment { ends } => vec![Stretch {
                ends,
                course: Course::Line,
            }],
            Self::Arc {
                centre, ends, turn, ..
            } => {
                let (sin, cos) = (0.5 * turn).sin_cos();
                let [x, y] = [0, 1].map(|axis| ends[0][axis] - centre[axis]);
                let through = [centre[0] + cos * x - sin * y, centre[1] + sin * x + cos * y];
                vec![Stretch {
                    ends,
                    course: Course::Arc(through),
                }]
            }
            Self::Chain { ref stretches, .. } => stretches.clone(),
            Self::Circle { .. } => Vec::new(),
        }
    }

    /// The arc from `from` through `through` to `to`; `None` where they lie on a line.
    pub(super) fn through(from: Point, through: Point, to: Point) -> Option<Self> {
        // About the first point, whose distance from the centre is the radius.
        let [[ax, ay], [bx, by]] = [through, to].map(|at| [at[0] - from[0], at[1] - from[1]]);
        let twice_area = ax * by - ay * bx;
        let (a, b) = (ax * ax + ay * ay, bx * bx + by * by);
        let aside = [(by * a - ay * b), (ax * b - bx * a)].map(|part| 0.5 * part / twice_area);
        let centre = [from[0] + aside[0], from[1] + aside[1]];
        let angle = |at: Point| (at[1] - centre[1]).atan2(at[0] - centre[0]);
        let ahead = (angle(to) - angle(from)).rem_euclid(TAU);
        let turn = if twice_area > 0.0 { ahead } else { ahead - TAU };
        (centre[0].is_finite() && centre[1].is_finite()).then_some(Self::Arc {
            centre,
            radius: aside[0].hypot(aside[1]),
            ends: [from, to],
            turn,
        })
    }

    /// The circle that a closed chain of arcs runs along, if it is one.
    pub(super) fn as_circle(&self) -> Option<Self> {
        // Arcs from three points know their circle to rounding over their sagitta only.
        const SAME: f64 = 1e-6;
        let Self::Chain { stretches, .. } = self else {
            return None;
        };
        let arc = |own: &Stretch| match own.course {
            Course::Arc(through) => Self::through(own.ends[0], through, own.ends[1]),
            _ => None,
        };
        let arcs: Option<Vec<Self>> = stretches.iter().map(arc).collect();
        let arcs = arcs?;
        let (Some(&Self::Arc { centre, radius, .. }), Some(first), Some(last)) =
            (arcs.first(), stretches.first(), stretches.last())
        else {
            return None;
        };
        let apart = |a: Point, b: Point| (a[0] - b[0]).hypot(a[1] - b[1]);
        let same = |own: &Self| {
            matches!(*own, Self::Arc { centre: other, radius: size, .. }
                if apart(centre, other) + (size - radius).abs() <= SAME * radius)
        };
        let is_closed = apart(first.ends[0], last.ends[1]) <= SAME * radius;
        (is_closed && arcs.iter().all(same)).then_some(Self::Circle { centre, radius })
    }

    /// The same curve walked the other way.
    pub(super) fn reversed(&self) -> Self {
        let back = |own: &Stretch| Stretch {
            ends: [own.ends[1], own.ends[0]],
            course: own.course.reversed(),
        };
        match *self {
            Self::Circle { .. } => self.clone(),
            Self::Arc {
                centre,
                radius,
                ends: [from, to],
                turn,
            } => Self::Arc {
                centre,
                radius,
                ends: [to, from],
                turn: -turn,
            },
            Self::Segment { ends: [from, to] } => Self::Segment { ends: [to, from] },
            Self::Chain {
                bounds,
                ref stretches,
            } => Self::Chain {
                bounds,
                stretches: stretches.iter().rev().map(back).collect(),
            },
        }
    }

    /// The same curve moved by `by` `[mm]`.
    pub(super) fn moved(&self, by: Point) -> Self {
        let shifted = |[x, y]: Point| [x + by[0], y + by[1]];
        let stretch = |own: &Stretch| Stretch {
            ends: own.ends.map(shifted),
            course: own.course.mapped(shifted, |angle| angle),
        };
        match *self {
            Self::Circle { centre, radius } => Self::Circle {
                centre: shifted(centre),
                radius,
            },
            Self::Arc {
                centre,
                radius,
                ends,
                turn,
            } => Self::Arc {
                centre: shifted(centre),
                radius,
                ends: ends.map(shifted),
                turn,
            },
            Self::Segment { ends } => Self::Segment {
                ends: ends.map(shifted),
            },
            Self::Chain {
                bounds,
                ref stretches,
            } => Self::Chain {
                bounds: bounds.map(shifted),
                stretches: stretches.iter().map(stretch).collect(),
            },
        }
    }

    /// The least and the greatest coordinate along `axis` (0 for x, 1 for y).
    pub(super) fn range(&self, axis: usize) -> [f64; 2] {
        let points = match *self {
            Self::Circle { centre, radius } => {
                return [centre[axis] - radius, centre[axis] + radius];
            }
            Self::Segment { ends } | Self::Chain { bounds: ends, .. } => ends.to_vec(),
            Self::Arc {
                centre,
                radius,
                ends,
                turn,
            } => {
                let extremes = [-radius, radius].map(|step| {
                    let mut extreme = centre;
                    extreme[axis] += step;
                    extreme
                });
                let own = extremes
                    .into_iter()
                    .filter(|&at| is_passed(centre, ends[0], turn, at));
                own.chain(ends).collect()
            }
        };
        let along = points.iter().map(|point| point[axis]);
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], at| {
            [least.min(at), most.max(at)]
        })
    }
}

/// Whether lines that follow one another make one line.
fn are_straight(lines: &[Stretch]) -> bool {
    const STRAIGHT: f64 = 1e-9;
    let along = |own: &Stretch| [0, 1].map(|axis| own.ends[1][axis] - own.ends[0][axis]);
    lines.iter().all(|own| own.course == Course::Line)
        && lines.windows(2).all(|pair| {
            let [[ax, ay], [bx, by]] = [along(&pair[0]), along(&pair[1])];
            (ax * by - ay * bx).abs() <= STRAIGHT * ax.hypot(ay) * bx.hypot(by)
                && ax * bx + ay * by > 0.0
        })
}

/// Whether the way along a circle about `centre` from the point `from` through the angle `turn` passes its point `at`.
fn is_passed(centre: Point, from: Point, turn: f64, at: Point) -> bool {
    let angle = |point: Point| (point[1] - centre[1]).atan2(point[0] - centre[0]);
    let ahead = (angle(at) - angle(from)) * turn.signum();
    ahead.rem_euclid(TAU) < turn.abs()
}
