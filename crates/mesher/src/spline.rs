//! Cubic splines through points, by arc length.
//!
//! Between neighbouring points x(t) is a cubic, with t the length of the chords up to a point, and x, x′ and x″ are continuous:
//!
//! ```text
//! h_k m_{k−1} + 2 (h_{k−1} + h_k) m_k + h_{k−1} m_{k+1} = 3 (h_k d_{k−1} + h_{k−1} d_k)
//! ```
//!
//! for m = x′ at the points, chords h and divided differences d (de Boor 2001, ch. IV). With t by chords the curve approaches a smooth one with the fourth power of h (Floater 2006).
//!
//! Sources: de Boor, A Practical Guide to Splines (2001); Floater, IMA J. Numer. Anal. 26 (2006) 25–33.

use stickslip_fem_core::generate::unit_vector;
use stickslip_fem_core::mesh::Point;

use crate::course::Spline;
use crate::cubic::{Cubic, root};
use crate::error::SplineFlaw;
use crate::vector::{NOWHERE, along, distance, grown, minus};

/// Least chord over the sum of all.
const LEAST_CHORD: f64 = 1e-6;
/// Least radius of curvature over the chord between the two points beside it.
const TIGHT: f64 = 0.05;
/// Deepest halving of a cubic into plain ones.
const DEPTH: usize = 16;

/// A spline by arc length s `[length]`.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    spans: Vec<Span>,
}

/// A plain part of a spline.
#[derive(Clone, Copy, Debug)]
struct Span {
    /// Arc length where it begins.
    begin: f64,
    length: f64,
    cubic: Cubic,
}

impl Run {
    /// The curve along plain cubics, each from the end of the one before.
    pub(crate) fn of(cubics: Vec<Cubic>) -> Self {
        let mut begin = 0.0;
        let span = |cubic: Cubic| {
            let length = cubic.length(1.0);
            let own = Span {
                begin,
                length,
                cubic,
            };
            begin += length;
            own
        };
        Self {
            spans: cubics.into_iter().map(span).collect(),
        }
    }

    /// Its plain parts in walk order, one at least.
    pub(crate) fn cubics(&self) -> impl Iterator<Item = &Cubic> {
        self.spans.iter().map(|span| &span.cubic)
    }

    /// Arc length `[length]`.
    pub(crate) fn length(&self) -> f64 {
        self.spans.last().map_or(0.0, |own| own.begin + own.length)
    }

    fn place(&self, s: f64) -> (&Cubic, f64) {
        let after = self.spans.partition_point(|span| span.begin <= s);
        let span = &self.spans[after.max(1) - 1];
        (&span.cubic, span.cubic.place(s - span.begin, span.length))
    }

    /// Point at arc length `s`.
    pub(crate) fn at(&self, s: f64) -> Point {
        let (cubic, t) = self.place(s);
        cubic.at(t)
    }

    /// Unit vector along the walk at arc length `s`.
    pub(crate) fn tangent(&self, s: f64) -> Point {
        let (cubic, t) = self.place(s);
        cubic.tangent(t)
    }

    /// The part with the nearest point, t there and the distance.
    fn foot(&self, point: Point) -> (&Span, f64, f64) {
        let away = |span: &Span| distance(span.cubic.0[0], point);
        let known = self.spans.iter().map(away).fold(f64::INFINITY, f64::min);
        let mut best = (&self.spans[0], 0.0, f64::INFINITY);
        for span in &self.spans {
            if span.cubic.beyond(point) > known.min(best.2) {
                continue;
            }
            let (t, away) = span.cubic.nearest(point);
            if away < best.2 {
                best = (span, t, away);
            }
        }
        best
    }

    /// The nearest point.
    pub(crate) fn nearest(&self, point: Point) -> Point {
        let (span, t, _) = self.foot(point);
        span.cubic.at(t)
    }

    /// Distance of a point `[length]`.
    pub(crate) fn distance(&self, point: Point) -> f64 {
        self.foot(point).2
    }

    /// Arc length of the nearest point, and the distance.
    pub(crate) fn nearest_place(&self, point: Point) -> (f64, f64) {
        let (span, t, away) = self.foot(point);
        (span.begin + span.cubic.length(t), away)
    }

    /// Where a straight line crosses it: the signed way along the unit vector `direction` and the arc length; an end within `tolerance` of the line is on it.
    pub(crate) fn crossings(
        &self,
        from: Point,
        direction: Point,
        tolerance: f64,
    ) -> Vec<(f64, f64)> {
        let way = |at: Point| {
            let apart = minus(at, from);
            apart[0] * direction[0] + apart[1] * direction[1]
        };
        let mut found = Vec::new();
        for Span { begin, cubic, .. } in &self.spans {
            for t in cubic.crossings(from, direction) {
                found.push((way(cubic.at(t)), begin + cubic.length(t)));
            }
        }
        let length = self.length();
        for s in [0.0, length] {
            let at = self.at(s);
            let apart = distance(at, along(from, way(at), direction));
            let is_new = found.iter().all(|own| (own.1 - s).abs() > tolerance);
            if apart <= tolerance && is_new {
                found.push((way(at), s));
            }
        }
        found
    }

    /// Arc length from the place `at`, or back from it, to where the distance from there first is `chord`.
    pub(crate) fn chord_to_length(&self, chord: f64, at: f64, is_back: bool) -> f64 {
        if is_back {
            let mut back = self.clone();
            back.reverse();
            return back.chord_to_length(chord, self.length() - at, false);
        }
        let start = self.at(at);
        let ahead = self
            .spans
            .iter()
            .filter(|span| span.begin + span.length > at);
        let reached = |span: &&Span| distance(span.cubic.0[3], start) >= chord;
        let Some(span) = ahead.into_iter().find(reached) else {
            return self.length() - at;
        };
        let cubic = span.cubic;
        let from = cubic.place(at - span.begin, span.length);
        let t = root([from, 1.0], |t| {
            let (away, slope) = (minus(cubic.at(t), start), cubic.slope(t));
            let size = distance(cubic.at(t), start);
            let grows = (away[0] * slope[0] + away[1] * slope[1]) / size;
            (size - chord, grows)
        });
        span.begin + cubic.length(t) - at
    }

    /// Sum of the angles by which it turns to either side `[rad]`.
    pub(crate) fn turn(&self) -> f64 {
        self.cubics().map(Cubic::turn).sum()
    }

    /// Places along it with the radius of curvature there `[length]`, two at least of every part.
    pub(crate) fn radii(&self) -> impl Iterator<Item = (Point, f64)> {
        let places = |cubic: &Cubic| [0.0, 0.5].map(|t| (cubic.at(t), cubic.radius(t)));
        let last = self.spans[self.spans.len() - 1].cubic;
        let end = (last.0[3], last.radius(1.0));
        self.cubics().flat_map(places).chain([end])
    }

    /// Box around it.
    pub(crate) fn bounds(&self) -> [Point; 2] {
        let boxes = self.cubics().map(Cubic::bounds);
        boxes.fold(NOWHERE, |all, [low, high]| grown(grown(all, low), high))
    }

    /// ½ ∫ x × dx about `origin` `[length²]`.
    pub(crate) fn area(&self, origin: Point) -> f64 {
        self.cubics().map(|cubic| cubic.area(origin)).sum()
    }

    /// Angle by which the direction from `point` turns along it `[rad]`.
    pub(crate) fn winding(&self, point: Point) -> f64 {
        self.cubics().map(|cubic| cubic.winding(point)).sum()
    }

    /// Moves it by `by`.
    pub(crate) fn shift(&mut self, by: Point) {
        for span in &mut self.spans {
            span.cubic = span.cubic.moved(by);
        }
    }

    /// Walks it the other way.
    pub(crate) fn reverse(&mut self) {
        let length = self.length();
        self.spans.reverse();
        for span in &mut self.spans {
            span.begin = length - span.begin - span.length;
            span.cubic = span.cubic.reversed();
        }
        self.spans[0].begin = 0.0;
    }
}

/// The spline from `from` to `to` in plain parts, one at least.
///
/// # Errors
/// [`SplineFlaw`] of its points, but for a spline that meets itself.
pub(crate) fn plain_cubics(
    from: Point,
    course: &Spline,
    to: Point,
) -> Result<Vec<Cubic>, SplineFlaw> {
    if course.points.is_empty() {
        return Err(SplineFlaw::NoPoint);
    }
    let inner = course.points.iter().copied();
    let points: Vec<Point> = std::iter::once(from).chain(inner).chain([to]).collect();
    let chords: Vec<f64> = points.windows(2).map(|p| distance(p[0], p[1])).collect();
    let least = LEAST_CHORD * chords.iter().sum::<f64>();
    if let Some(k) = chords.iter().position(|chord| *chord <= least) {
        return Err(SplineFlaw::RepeatedPoint { at: points[k] });
    }
    let slopes = slopes(&points, &chords, [course.leaves, course.arrives]);
    let mut plain = Vec::new();
    for (k, &chord) in chords.iter().enumerate() {
        let [a, d] = [points[k], points[k + 1]];
        let b = along(a, chord / 3.0, slopes[k]);
        let c = along(d, -chord / 3.0, slopes[k + 1]);
        divide(Cubic([a, b, c, d]), chord, DEPTH, &mut plain)?;
    }
    Ok(plain)
}

/// dx/dt at the points, with unit vectors at ends of given directions.
fn slopes(points: &[Point], chords: &[f64], ends: [Option<f64>; 2]) -> Vec<Point> {
    let last = chords.len() - 1;
    let rise = |k: usize| minus(points[k + 1], points[k]).map(|part| part / chords[k]);
    // Each row holds the factors of the slopes before, at and after a point, and the right side.
    let mut rows = vec![end_row(ends[0], [0, 1], chords, rise, ends == [None; 2])];
    for k in 1..=last {
        let [h, next] = [chords[k - 1], chords[k]];
        let [before, after] = [rise(k - 1), rise(k)];
        let right = [0, 1].map(|axis| 3.0 * (next * before[axis] + h * after[axis]));
        rows.push(([next, 2.0 * (h + next), h], right));
    }
    let ([_, own, other], right) =
        end_row(ends[1], [last, last - 1], chords, rise, ends == [None; 2]);
    rows.push(([other, own, 0.0], right));
    solved(rows)
}

/// The row of an end beside the chords `near` and `far`.
fn end_row(
    direction: Option<f64>,
    [near, far]: [usize; 2],
    chords: &[f64],
    rise: impl Fn(usize) -> Point,
    are_free: bool,
) -> ([f64; 3], Point) {
    if let Some(angle) = direction {
        return ([0.0, 1.0, 0.0], unit_vector(angle));
    }
    let [a, b] = [rise(near), rise(far)];
    if chords.len() == 2 && are_free {
        // A parabola, where two free ends at one point would ask for the same.
        return ([0.0, 1.0, 1.0], a.map(|part| 2.0 * part));
    }
    let [h, next] = [chords[near], chords[far]];
    let both = h + next;
    let right = [0, 1].map(|axis| ((h + 2.0 * both) * next * a[axis] + h * h * b[axis]) / both);
    ([0.0, next, both], right)
}

/// The solution of a tridiagonal system without exchanges of rows.
fn solved(rows: Vec<([f64; 3], Point)>) -> Vec<Point> {
    let mut reduced: Vec<(f64, Point)> = Vec::with_capacity(rows.len());
    for ([before, own, after], right) in rows {
        let (factor, known) = reduced.last().copied().unwrap_or_default();
        let pivot = own - before * factor;
        let value = [0, 1].map(|axis| (right[axis] - before * known[axis]) / pivot);
        reduced.push((after / pivot, value));
    }
    let mut found = Vec::with_capacity(reduced.len());
    let mut next = [0.0; 2];
    for (factor, value) in reduced.into_iter().rev() {
        next = along(value, -factor, next);
        found.push(next);
    }
    found.reverse();
    found
}

/// Adds the plain parts of a cubic between two points `chord` apart.
fn divide(
    cubic: Cubic,
    chord: f64,
    depth: usize,
    plain: &mut Vec<Cubic>,
) -> Result<(), SplineFlaw> {
    let is_plain = cubic.is_plain();
    let radii = [0.0, 0.5, 1.0].map(|t| (cubic.radius(t), cubic.at(t)));
    let [first, others @ ..] = radii;
    let (radius, at) = others.into_iter().fold(
        first,
        |least, own| if own.0 < least.0 { own } else { least },
    );
    if is_plain && radius < TIGHT * chord || depth == 0 {
        return Err(SplineFlaw::Tight { at, radius, chord });
    }
    if is_plain {
        plain.push(cubic);
        return Ok(());
    }
    for half in cubic.halves() {
        divide(half, chord, depth - 1, plain)?;
    }
    Ok(())
}
