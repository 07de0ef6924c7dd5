//! Curves of several lines, arcs and splines, one after another.

use stickslip_fem_core::mesh::Point;

use crate::course::Course;
use crate::curve::Track;
use crate::vector::{NOWHERE, cross, dot, grown, minus};

/// Part of the length by which a place may lie beyond an end and still belong to the path.
const END: f64 = 1e-9;

/// An open curve of lines, arcs and splines, walked with the arc length s `[length]`.
#[derive(Clone, Debug)]
pub struct Path {
    /// Each with the arc length at its beginning.
    tracks: Vec<(f64, Track)>,
    length: f64,
}

/// A line, an arc or a spline between two points.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// Its ends `[length]`.
    pub ends: [Point; 2],
    /// Its way between them.
    pub course: Course,
}

impl Path {
    /// The curve along `stretches`, each from the end of the one before; `None` without any, or with one that has no length or makes no arc or spline.
    pub fn new(stretches: &[Stretch]) -> Option<Self> {
        let mut length = 0.0;
        let mut tracks = Vec::with_capacity(stretches.len());
        for Stretch { ends, course } in stretches {
            let [from, to] = *ends;
            let track = Track::new(from, course, to).ok()?;
            let begin = length;
            length += track.length();
            if length <= begin {
                return None;
            }
            tracks.push((begin, track));
        }
        (length > 0.0 && length.is_finite()).then_some(Self { tracks, length })
    }

    /// Its length `[length]`.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Sum of the angles by which it turns, to either side `[rad]`.
    pub fn turn(&self) -> f64 {
        let along: f64 = self.tracks.iter().map(|(_, track)| track.turn()).sum();
        let kinks = self.tracks.windows(2).map(|pair| {
            let ([_, before], [after, _]) = (pair[0].1.tangents(), pair[1].1.tangents());
            cross(before, after).atan2(dot(before, after)).abs()
        });
        along + kinks.sum::<f64>()
    }

    /// Smallest and largest corner of the box around it `[length]`.
    pub fn bounds(&self) -> [Point; 2] {
        let boxes = self.tracks.iter().map(|(_, track)| track.bounds());
        boxes.fold(NOWHERE, |all, [low, high]| grown(grown(all, low), high))
    }

    /// Arc lengths where one stretch ends and the next begins `[length]`.
    pub fn joints(&self) -> impl Iterator<Item = f64> {
        self.tracks.iter().skip(1).map(|(begin, _)| *begin)
    }

    /// The point at arc length `s` `[length]`; before the start and beyond the end those.
    pub fn at(&self, s: f64) -> Point {
        let (begin, track) = self.stretch(s);
        track.at(s - begin)
    }

    /// Unit vector `[1]` along the walk at arc length `s` `[length]`.
    pub fn tangent(&self, s: f64) -> Point {
        let (begin, track) = self.stretch(s);
        track.tangent(s - begin)
    }

    /// Unit vector `[1]` to the left of the walk at arc length `s` `[length]`.
    pub fn left(&self, s: f64) -> Point {
        let [x, y] = self.tangent(s);
        [-y, x]
    }

    /// Arc length of the nearest point `[length]`.
    pub fn nearest(&self, point: Point) -> f64 {
        let places = self.tracks.iter().map(|(begin, track)| {
            let (s, away) = track.nearest_place(point);
            (begin + s, away)
        });
        let nearest = places.min_by(|a, b| a.1.total_cmp(&b.1));
        nearest.map_or(0.0, |(s, _)| s)
    }

    /// Where the straight line through `from` along the unit vector `direction` crosses it: the signed way along `direction` `[length]` and the arc length `[length]`.
    pub fn crossings(&self, from: Point, direction: Point) -> impl Iterator<Item = (f64, f64)> {
        let tolerance = END * self.length;
        self.tracks.iter().flat_map(move |(begin, track)| {
            let places = track.crossings(from, direction, tolerance);
            places.into_iter().map(move |(way, s)| (way, begin + s))
        })
    }

    /// The same curve moved by `by` `[length]`.
    #[must_use]
    pub fn moved(&self, by: Point) -> Self {
        let mut own = self.clone();
        for (_, track) in &mut own.tracks {
            track.shift(by);
        }
        own
    }

    fn stretch(&self, s: f64) -> (f64, &Track) {
        let after = self.tracks.partition_point(|(begin, _)| *begin <= s);
        let (begin, track) = &self.tracks[after.max(1) - 1];
        (*begin, track)
    }
}

impl Track {
    /// Unit vector along the walk at arc length `s`.
    pub(crate) fn tangent(&self, s: f64) -> Point {
        if let Some(run) = self.run() {
            return run.tangent(s);
        }
        let along = match self.bend() {
            None => minus(self.to, self.from),
            Some(bend) => {
                let [x, y] = minus(self.at(s), bend.centre);
                let turn = bend.sweep.signum();
                [-turn * y, turn * x]
            }
        };
        let size = dot(along, along).sqrt();
        along.map(|part| part / size)
    }

    /// Arc length of the nearest point, and the distance.
    fn nearest_place(&self, point: Point) -> (f64, f64) {
        if let Some(run) = self.run() {
            return run.nearest_place(point);
        }
        let nearest = self.nearest(point);
        (self.place(nearest), self.distance(point))
    }

    /// Arc length of a point on a line or an arc.
    fn place(&self, point: Point) -> f64 {
        let length = self.length();
        let place = match self.bend() {
            None => {
                let along = minus(self.to, self.from);
                dot(minus(point, self.from), along) / length
            }
            Some(bend) => {
                let (a, b) = (minus(self.from, bend.centre), minus(point, bend.centre));
                let ahead = bend.sweep.signum() * cross(a, b).atan2(dot(a, b));
                // Beside its beginning an angle of rounding is no whole turn.
                let turned = if ahead < -1e-9 {
                    ahead + std::f64::consts::TAU
                } else {
                    ahead
                };
                turned * (length / bend.sweep.abs())
            }
        };
        place.clamp(0.0, length)
    }

    /// Where a straight line crosses it, as [`Path::crossings`] says.
    pub(crate) fn crossings(
        &self,
        from: Point,
        direction: Point,
        tolerance: f64,
    ) -> Vec<(f64, f64)> {
        if let Some(run) = self.run() {
            return run.crossings(from, direction, tolerance);
        }
        let ways = match self.bend() {
            None => {
                let along = minus(self.to, self.from);
                vec![cross(minus(self.from, from), along) / cross(direction, along)]
            }
            Some(bend) => {
                let to_centre = minus(bend.centre, from);
                let (ahead, aside) = (dot(to_centre, direction), cross(direction, to_centre));
                let radius = bend.radius;
                let half = ((radius - aside) * (radius + aside)).sqrt();
                let [near, far] = [-1.0, 1.0].map(|side| {
                    let sum = ahead + side * half;
                    // The smaller root from the product of both, which keeps its digits.
                    let product = (dot(to_centre, to_centre).sqrt() - radius)
                        * (dot(to_centre, to_centre).sqrt() + radius);
                    if side * ahead >= 0.0 {
                        sum
                    } else {
                        product / (ahead - side * half)
                    }
                });
                vec![near, far]
            }
        };
        let on_track = |way: f64| {
            let point = [from[0] + way * direction[0], from[1] + way * direction[1]];
            let is_on = way.is_finite() && self.distance(point) <= tolerance;
            is_on.then(|| (way, self.place(point)))
        };
        ways.into_iter().filter_map(on_track).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A flat between two arcs of radius 2 that turn down by 90°... seen from above: from (-3, 2) down to (-1, 0), along to (1, 0), up to (3, 2).
    fn bowl() -> Path {
        let root = 2.0 * std::f64::consts::FRAC_1_SQRT_2;
        let arc = |ends, through| Stretch {
            ends,
            course: Course::Arc(through),
        };
        Path::new(&[
            arc([[-3.0, 2.0], [-1.0, 0.0]], [-1.0 - root, 2.0 - root]),
            Stretch {
                ends: [[-1.0, 0.0], [1.0, 0.0]],
                course: Course::Line,
            },
            arc([[1.0, 0.0], [3.0, 2.0]], [1.0 + root, 2.0 - root]),
        ])
        .unwrap()
    }

    fn close(a: Point, b: Point) {
        assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-12, "{a:?} {b:?}");
    }

    #[test]
    fn places_along_a_path_lead_there_and_back() {
        let path = bowl();
        let quarter = std::f64::consts::PI;
        assert!((path.length() - 2.0 * quarter - 2.0).abs() < 1e-12);
        close(path.at(quarter + 1.0), [0.0, 0.0]);
        close(path.tangent(quarter + 1.0), [1.0, 0.0]);
        close(path.left(path.length()), [-1.0, 0.0]);
        for k in 0..=40 {
            let s = path.length() * f64::from(k) / 40.0;
            let inside = path.left(s);
            let place = [0, 1].map(|axis| path.at(s)[axis] + 0.1 * inside[axis]);
            assert!((path.nearest(place) - s).abs() < 1e-9, "{s}");
        }
    }

    #[test]
    fn a_line_crosses_a_path_where_both_are() {
        let path = bowl();
        let crossings =
            |from, direction| -> Vec<(f64, f64)> { path.crossings(from, direction).collect() };
        let [(way, s)] = crossings([0.5, -0.25], [0.0, 1.0])[..] else {
            panic!("one crossing of the flat");
        };
        assert!((way - 0.25).abs() < 1e-14 && (s - std::f64::consts::PI - 1.5).abs() < 1e-12);
        let [(way, _)] = crossings([2.0, 0.0], [0.0, 1.0])[..] else {
            panic!("one crossing of the arc");
        };
        assert!((way - (2.0 - 3.0_f64.sqrt())).abs() < 1e-13, "{way}");
        assert_eq!(crossings([3.5, 0.0], [0.0, 1.0]), []);
        assert_eq!(crossings([0.0, 1.0], [1.0, 0.0]).len(), 2);
        // A gap of 1e-12 has its digits.
        let ways = crossings([0.99, -1e-12], [0.0, 1.0]);
        assert!((ways[0].0 / 1e-12 - 1.0).abs() < 1e-3, "{ways:?}");
        let there = path.moved([5.0, 1.0]);
        close(
            there.at(1.0),
            [path.at(1.0)[0] + 5.0, path.at(1.0)[1] + 1.0],
        );
    }
}
