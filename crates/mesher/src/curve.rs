//! Straight lines, arcs and splines by arc length.

use std::f64::consts::{FRAC_PI_2, TAU};

use stickslip_fem_core::generate::unit_vector;
use stickslip_fem_core::mesh::{Curve, Point};

use crate::course::Course;
use crate::cubic::Cubic;
use crate::error::{ContourError, SplineFlaw};
use crate::spline::{Run, plain_cubics};
use crate::vector::{
    NOWHERE, along, circumcircle, cross, distance, dot, grown, middle, minus, orient, turned,
};

/// Sine below which three points lie on a line.
const STRAIGHT: f64 = 1e-9;

/// A piece of outline, walked from `from` to `to` with arc length s `[length]`.
#[derive(Clone, Debug)]
pub(crate) struct Track {
    pub(crate) from: Point,
    pub(crate) to: Point,
    length: f64,
    form: Form,
}

#[derive(Clone, Debug)]
enum Form {
    Line,
    Arc(Bend),
    Spline(Run),
}

/// The circle of an arc.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bend {
    pub(crate) centre: Point,
    pub(crate) radius: f64,
    /// Direction of `from` seen from the centre `[rad]`.
    pub(crate) start: f64,
    /// Angle from there to `to` `[rad]`, positive counter-clockwise.
    pub(crate) sweep: f64,
}

/// Why two points and a course make no track.
#[derive(Clone, Debug)]
pub(crate) enum NoTrack {
    /// Three points on a line.
    Straight,
    Spline(SplineFlaw),
}

impl NoTrack {
    /// The error of the piece `piece`.
    pub(crate) fn of(self, piece: &str) -> ContourError {
        let piece = piece.to_owned();
        match self {
            Self::Straight => ContourError::StraightArc { piece },
            Self::Spline(flaw) => ContourError::Spline { piece, flaw },
        }
    }
}

impl Track {
    /// The way from `from` to `to`.
    pub(crate) fn new(from: Point, course: &Course, to: Point) -> Result<Self, NoTrack> {
        match course {
            Course::Line => Ok(Self::line(from, to)),
            Course::Arc(through) => Self::arc(from, *through, to).ok_or(NoTrack::Straight),
            Course::Spline(own) => {
                let cubics = plain_cubics(from, own, to).map_err(NoTrack::Spline)?;
                Ok(Self::along(cubics))
            }
        }
    }

    /// The curve along plain cubics, each from the end of the one before, one at least.
    pub(crate) fn along(cubics: Vec<Cubic>) -> Self {
        let (from, to) = (cubics[0].0[0], cubics[cubics.len() - 1].0[3]);
        let run = Run::of(cubics);
        Self {
            from,
            to,
            length: run.length(),
            form: Form::Spline(run),
        }
    }

    pub(crate) fn line(from: Point, to: Point) -> Self {
        let length = distance(from, to);
        Self {
            from,
            to,
            length,
            form: Form::Line,
        }
    }

    /// The arc through three points; none if they lie on a line or coincide.
    pub(crate) fn arc(from: Point, through: Point, to: Point) -> Option<Self> {
        let turn = orient(from, through, to);
        let sides = [(from, through), (through, to), (to, from)].map(|(a, b)| distance(a, b));
        let [shortest, longest] = [
            sides.into_iter().fold(f64::INFINITY, f64::min),
            sides.into_iter().fold(0.0, f64::max),
        ];
        // Written so that an overflow to NaN is refused too.
        if !(turn.abs() > STRAIGHT * shortest * longest && shortest > STRAIGHT * longest) {
            return None;
        }
        let (centre, radius) = circumcircle([from, through, to]);
        let direction = |point: Point| (point[1] - centre[1]).atan2(point[0] - centre[0]);
        let start = direction(from);
        let ccw = (direction(to) - start).rem_euclid(TAU);
        let sweep = if turn > 0.0 { ccw } else { ccw - TAU };
        let form = Form::Arc(Bend {
            centre,
            radius,
            start,
            sweep,
        });
        let length = radius * sweep.abs();
        Some(Self {
            from,
            to,
            length,
            form,
        })
    }

    /// The circle of an arc.
    pub(crate) fn bend(&self) -> Option<&Bend> {
        match &self.form {
            Form::Arc(bend) => Some(bend),
            _ => None,
        }
    }

    /// The curve of a spline.
    pub(crate) fn run(&self) -> Option<&Run> {
        match &self.form {
            Form::Spline(run) => Some(run),
            _ => None,
        }
    }

    /// Arc length `[length]`.
    pub(crate) fn length(&self) -> f64 {
        self.length
    }

    /// Radius of an arc `[length]`.
    pub(crate) fn radius(&self) -> Option<f64> {
        self.bend().map(|bend| bend.radius)
    }

    /// The plain parts of a spline; of lines and arcs none.
    pub(crate) fn cubics(&self) -> impl Iterator<Item = &Cubic> {
        self.run().into_iter().flat_map(Run::cubics)
    }

    /// Moves it by `by`.
    pub(crate) fn shift(&mut self, by: Point) {
        self.from = along(self.from, 1.0, by);
        self.to = along(self.to, 1.0, by);
        match &mut self.form {
            Form::Line => {}
            Form::Arc(bend) => bend.centre = along(bend.centre, 1.0, by),
            Form::Spline(run) => run.shift(by),
        }
    }

    /// Turned about the origin, so that what lay along x lies along `direction`.
    pub(crate) fn turned(&self, direction: Point) -> Self {
        let [from, to] = [self.from, self.to].map(|end| turned(end, direction));
        let form = match &self.form {
            Form::Line => Form::Line,
            Form::Arc(bend) => Form::Arc(Bend {
                centre: turned(bend.centre, direction),
                start: bend.start + direction[1].atan2(direction[0]),
                ..*bend
            }),
            Form::Spline(run) => {
                let cubics = run.cubics();
                let own = cubics.map(|cubic| Cubic(cubic.0.map(|at| turned(at, direction))));
                return Self::along(own.collect());
            }
        };
        Self {
            from,
            to,
            form,
            length: self.length,
        }
    }

    /// Walks it the other way.
    pub(crate) fn reverse(&mut self) {
        std::mem::swap(&mut self.from, &mut self.to);
        match &mut self.form {
            Form::Line => {}
            Form::Arc(bend) => {
                bend.start += bend.sweep;
                bend.sweep = -bend.sweep;
            }
            Form::Spline(run) => run.reverse(),
        }
    }

    /// Sum of the angles by which the walk turns to either side `[rad]`.
    pub(crate) fn turn(&self) -> f64 {
        match &self.form {
            Form::Line => 0.0,
            Form::Arc(bend) => bend.sweep.abs(),
            Form::Spline(run) => run.turn(),
        }
    }

    /// The exact geometry for an edge set; a spline has none there.
    pub(crate) fn curve(&self) -> Option<Curve> {
        match self.form {
            Form::Line => Some(Curve::Line),
            Form::Arc(Bend { centre, radius, .. }) => Some(Curve::Arc { centre, radius }),
            Form::Spline(_) => None,
        }
    }

    /// Point at arc length `s`, the ends exactly.
    pub(crate) fn at(&self, s: f64) -> Point {
        if s <= 0.0 {
            return self.from;
        }
        if s >= self.length {
            return self.to;
        }
        let t = s / self.length;
        match &self.form {
            Form::Arc(b) => along(b.centre, b.radius, unit_vector(b.start + t * b.sweep)),
            Form::Line => [0, 1].map(|c| {
                let (a, b) = (self.from[c], self.to[c]);
                if a == b { a } else { (1.0 - t) * a + t * b }
            }),
            Form::Spline(run) => run.at(s),
        }
    }

    /// Unit vectors along the walk at its beginning and end.
    pub(crate) fn tangents(&self) -> [Point; 2] {
        match &self.form {
            Form::Arc(b) => [b.start, b.start + b.sweep]
                .map(|angle| unit_vector(angle + FRAC_PI_2.copysign(b.sweep))),
            Form::Line => [minus(self.to, self.from).map(|c| c / self.length); 2],
            Form::Spline(run) => [0.0, self.length].map(|s| run.tangent(s)),
        }
    }

    /// Arc length from the place `at`, or back from it, to where the distance from there is `chord`, which is at most the
    /// length of a line or the diameter of an arc.
    pub(crate) fn chord_to_length(&self, chord: f64, at: f64, is_back: bool) -> f64 {
        match &self.form {
            Form::Arc(b) => 2.0 * b.radius * (chord / (2.0 * b.radius)).min(1.0).asin(),
            Form::Line => chord,
            Form::Spline(run) => run.chord_to_length(chord, at, is_back),
        }
    }

    /// The nearest point of the track.
    pub(crate) fn nearest(&self, point: Point) -> Point {
        let b = match &self.form {
            Form::Line => {
                let d = minus(self.to, self.from);
                let t = dot(minus(point, self.from), d) / (self.length * self.length);
                return self.at(t.clamp(0.0, 1.0) * self.length);
            }
            Form::Arc(bend) => bend,
            Form::Spline(run) => return run.nearest(point),
        };
        let v = minus(point, b.centre);
        let r = v[0].hypot(v[1]);
        if r > 0.0 && b.holds(v) {
            along(b.centre, b.radius / r, v)
        } else if distance(point, self.from) <= distance(point, self.to) {
            self.from
        } else {
            self.to
        }
    }

    /// Distance of a point from the track `[length]`.
    pub(crate) fn distance(&self, point: Point) -> f64 {
        match &self.form {
            Form::Spline(run) => run.distance(point),
            _ => distance(self.nearest(point), point),
        }
    }

    /// Box around the track.
    pub(crate) fn bounds(&self) -> [Point; 2] {
        let ends = grown(grown(NOWHERE, self.from), self.to);
        let b = match &self.form {
            Form::Line => return ends,
            Form::Arc(bend) => bend,
            Form::Spline(run) => return run.bounds(),
        };
        let extremes = (0..4).map(|k| unit_vector(f64::from(k) * FRAC_PI_2));
        extremes
            .filter(|&direction| b.holds(direction))
            .fold(ends, |all, direction| {
                grown(all, along(b.centre, b.radius, direction))
            })
    }

    /// ½ ∮ x × dx of the track about `origin` `[length²]`.
    pub(crate) fn area(&self, origin: Point) -> f64 {
        let chord = cross(minus(self.from, origin), minus(self.to, origin)) / 2.0;
        let b = match &self.form {
            Form::Line => return chord,
            Form::Arc(bend) => bend,
            Form::Spline(run) => return run.area(origin),
        };
        chord + b.radius * b.radius * (b.sweep - b.sweep.sin()) / 2.0
    }

    /// Angle by which the direction from `point` turns along the track `[rad]`.
    pub(crate) fn winding(&self, point: Point) -> f64 {
        let (u, v) = (minus(self.from, point), minus(self.to, point));
        let chord = cross(u, v).atan2(dot(u, v));
        let b = match &self.form {
            Form::Line => return chord,
            Form::Arc(bend) => bend,
            Form::Spline(run) => return run.winding(point),
        };
        if distance(point, b.centre) >= b.radius {
            return chord;
        }
        // From inside its circle the arc turns all the way round on its side of the chord, from 0 to 2π.
        (chord * b.sweep.signum()).rem_euclid(TAU) * b.sweep.signum()
    }

    /// Whether both lie on one line or one circle, to `tolerance` `[length]`.
    pub(crate) fn continues(&self, other: &Self, tolerance: f64) -> bool {
        match (&self.form, &other.form) {
            (Form::Arc(a), Form::Arc(b)) => {
                distance(a.centre, b.centre) <= tolerance
                    && (a.radius - b.radius).abs() <= tolerance
            }
            (Form::Line, Form::Line) => [other.from, other.to]
                .into_iter()
                .all(|p| orient(self.from, self.to, p).abs() <= tolerance * self.length),
            _ => false,
        }
    }

    /// Points where two lines or arcs meet, to `tolerance` `[length]`.
    pub(crate) fn meetings(&self, other: &Self, tolerance: f64) -> Vec<Point> {
        let mut points = match (self.bend(), other.bend()) {
            (None, None) => lines(self, other),
            (Some(b), None) => line_circle(other, b),
            (None, Some(b)) => line_circle(self, b),
            (Some(a), Some(b)) => circles(a, b),
        };
        points.extend([self.from, self.to, other.from, other.to]);
        points.retain(|&p| self.distance(p) <= tolerance && other.distance(p) <= tolerance);
        points
    }
}

impl Bend {
    /// Whether the arc passes through the direction `v` from the centre.
    fn holds(&self, v: Point) -> bool {
        let turn = (v[1].atan2(v[0]) - self.start) * self.sweep.signum();
        turn.rem_euclid(TAU) <= self.sweep.abs()
    }
}

/// Where two infinite lines cross.
fn lines(a: &Track, b: &Track) -> Vec<Point> {
    let (u, v) = (minus(a.to, a.from), minus(b.to, b.from));
    let t = cross(minus(b.from, a.from), v) / cross(u, v);
    if t.is_finite() {
        vec![along(a.from, t, u)]
    } else {
        Vec::new()
    }
}

/// Where an infinite line crosses a circle, or comes nearest to its centre.
fn line_circle(line: &Track, b: &Bend) -> Vec<Point> {
    let u = line.tangents()[0];
    let t = dot(minus(b.centre, line.from), u);
    let foot = along(line.from, t, u);
    let half = (b.radius.powi(2) - dot(minus(foot, b.centre), minus(foot, b.centre))).max(0.0);
    [-half.sqrt(), 0.0, half.sqrt()]
        .map(|t| along(foot, t, u))
        .into()
}

/// Where two circles cross, or come nearest to each other.
fn circles(a: &Bend, b: &Bend) -> Vec<Point> {
    let d = distance(a.centre, b.centre);
    if d == 0.0 {
        return Vec::new();
    }
    let u = minus(b.centre, a.centre).map(|c| c / d);
    let x = (d * d + a.radius * a.radius - b.radius * b.radius) / (2.0 * d);
    let y = (a.radius * a.radius - x * x).max(0.0).sqrt();
    let foot = along(a.centre, x, u);
    [y, -y].map(|y| along(foot, y, [-u[1], u[0]])).into()
}

/// Middle of the shortest way between a point and a track, and the way's length.
pub(crate) fn gap(track: &Track, point: Point) -> (Point, f64) {
    let nearest = track.nearest(point);
    (middle(nearest, point), distance(nearest, point))
}
