//! Plane cubics in Bézier's form, x(t) = Σ B_k(t) c_k with 0 ≤ t ≤ 1.

use std::f64::consts::PI;

use stickslip_fem_core::element::edge_rule;
use stickslip_fem_core::mesh::Point;

use crate::vector::{NOWHERE, along, cross, distance, dot, grown, middle, minus};

/// Angle by which the control polygon of a plain cubic turns at most `[rad]`: the Gauss rule has its length to rounding.
const TURN: f64 = 0.25;
/// How many times the longest leg of that polygon is as long as the shortest at most.
const UNEVEN: f64 = 2.0;
/// Steps of a root before its interval is only rounding.
const STEPS: usize = 100;
/// Halvings of a cubic around a point before this lies on it.
const DEPTH: usize = 48;

/// A cubic by its control points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cubic(pub(crate) [Point; 4]);

/// ∫ f(t) dt from 0 to `end`.
fn integral(end: f64, value: impl Fn(f64) -> f64) -> f64 {
    let half = 0.5 * end;
    let rule = edge_rule(8).iter();
    rule.map(|&(xi, weight)| half * weight * value(half * (1.0 + xi)))
        .sum()
}

impl Cubic {
    pub(crate) fn at(&self, t: f64) -> Point {
        let [a, b, c, d] = self.0;
        [0, 1].map(|axis| bernstein([a[axis], b[axis], c[axis], d[axis]], t))
    }

    /// dx/dt.
    pub(crate) fn slope(&self, t: f64) -> Point {
        let [a, b, c] = self.legs();
        let s = 1.0 - t;
        [0, 1].map(|axis| 3.0 * (s * s * a[axis] + 2.0 * s * t * b[axis] + t * t * c[axis]))
    }

    /// d²x/dt².
    fn bend(&self, t: f64) -> Point {
        let [a, b, c] = self.legs();
        [0, 1].map(|axis| 6.0 * ((1.0 - t) * (b[axis] - a[axis]) + t * (c[axis] - b[axis])))
    }

    /// Unit vector along the walk.
    pub(crate) fn tangent(&self, t: f64) -> Point {
        let slope = self.slope(t);
        let speed = dot(slope, slope).sqrt();
        slope.map(|part| part / speed)
    }

    /// Radius of curvature `[length]`; not finite where it is straight.
    pub(crate) fn radius(&self, t: f64) -> f64 {
        let (slope, bend) = (self.slope(t), self.bend(t));
        dot(slope, slope).powf(1.5) / cross(slope, bend).abs()
    }

    fn legs(&self) -> [Point; 3] {
        let [a, b, c, d] = self.0;
        [minus(b, a), minus(c, b), minus(d, c)]
    }

    /// Angles by which the control polygon turns at its two inner points, summed to either side `[rad]`.
    pub(crate) fn turn(&self) -> f64 {
        let [a, b, c] = self.legs();
        let between = |u: Point, v: Point| cross(u, v).atan2(dot(u, v)).abs();
        between(a, b) + between(b, c)
    }

    /// Whether it turns little and its speed changes little.
    pub(crate) fn is_plain(&self) -> bool {
        let sizes = self.legs().map(|leg| dot(leg, leg).sqrt());
        let least = sizes.iter().copied().fold(f64::INFINITY, f64::min);
        let most = sizes.iter().copied().fold(0.0, f64::max);
        least > 0.0 && most <= UNEVEN * least && self.turn() <= TURN
    }

    /// Its parts before and after t = ½.
    pub(crate) fn halves(&self) -> [Self; 2] {
        let [a, b, c, d] = self.0;
        let [ab, bc, cd] = [middle(a, b), middle(b, c), middle(c, d)];
        let [before, after] = [middle(ab, bc), middle(bc, cd)];
        let half = middle(before, after);
        [Self([a, ab, before, half]), Self([half, after, cd, d])]
    }

    pub(crate) fn reversed(&self) -> Self {
        let [a, b, c, d] = self.0;
        Self([d, c, b, a])
    }

    pub(crate) fn moved(&self, by: Point) -> Self {
        Self(self.0.map(|at| along(at, 1.0, by)))
    }

    /// Arc length from t = 0 to `end` of a plain cubic `[length]`.
    pub(crate) fn length(&self, end: f64) -> f64 {
        integral(end, |t| {
            let slope = self.slope(t);
            dot(slope, slope).sqrt()
        })
    }

    /// t at the arc length `s` of a plain cubic with the length `length`.
    pub(crate) fn place(&self, s: f64, length: f64) -> f64 {
        if s <= 0.0 || s >= length {
            return if s <= 0.0 { 0.0 } else { 1.0 };
        }
        root([0.0, 1.0], |t| {
            let slope = self.slope(t);
            (self.length(t) - s, dot(slope, slope).sqrt())
        })
    }

    /// ½ ∫ x × dx about `origin` `[length²]`.
    pub(crate) fn area(&self, origin: Point) -> f64 {
        0.5 * integral(1.0, |t| cross(minus(self.at(t), origin), self.slope(t)))
    }

    /// The nearest point of a plain cubic to one that is nearer to it than the centres of its curvature: t, and the distance.
    pub(crate) fn nearest(&self, point: Point) -> (f64, f64) {
        let ahead = |t: f64| dot(minus(self.at(t), point), self.slope(t));
        let inner = (ahead(0.0) < 0.0 && ahead(1.0) > 0.0).then(|| {
            root([0.0, 1.0], |t| {
                let (slope, bend) = (self.slope(t), self.bend(t));
                let away = minus(self.at(t), point);
                (dot(away, slope), dot(slope, slope) + dot(away, bend))
            })
        });
        let places = [0.0, 1.0].into_iter().chain(inner);
        let places = places.map(|t| (t, distance(self.at(t), point)));
        let nearest = places.min_by(|a, b| a.1.total_cmp(&b.1));
        nearest.unwrap_or((0.0, f64::INFINITY))
    }

    /// t where the straight line through `from` along the unit vector `direction` crosses it.
    pub(crate) fn crossings(&self, from: Point, direction: Point) -> Vec<f64> {
        roots(self.0.map(|at| cross(direction, minus(at, from))))
    }

    /// Box around it.
    pub(crate) fn bounds(&self) -> [Point; 2] {
        let [a, b, c] = self.legs();
        let inner = [0, 1].map(|axis| quadratic_roots([a[axis], b[axis], c[axis]]));
        let places = inner.into_iter().flatten().chain([0.0, 1.0]);
        places.fold(NOWHERE, |all, t| grown(all, self.at(t)))
    }

    /// Distance of a point from the box around the control points `[length]`, which it is at least away.
    pub(crate) fn beyond(&self, point: Point) -> f64 {
        let [low, high] = self.hull();
        let out = [0, 1].map(|axis| {
            let beyond = f64::max(low[axis] - point[axis], point[axis] - high[axis]);
            beyond.max(0.0)
        });
        dot(out, out).sqrt()
    }

    fn hull(&self) -> [Point; 2] {
        self.0.iter().fold(NOWHERE, |all, &at| grown(all, at))
    }

    /// Angle by which the direction from `point`, which is not on it, turns along it `[rad]`.
    pub(crate) fn winding(&self, point: Point) -> f64 {
        self.winding_within(point, DEPTH)
    }

    fn winding_within(&self, point: Point, depth: usize) -> f64 {
        if depth > 0 && self.beyond(point) <= 0.0 {
            let halves = self.halves();
            return halves
                .iter()
                .map(|half| half.winding_within(point, depth - 1))
                .sum();
        }
        let (u, v) = (minus(self.0[0], point), minus(self.0[3], point));
        cross(u, v).atan2(dot(u, v))
    }

    /// Distance of its farthest control point from the chord `[length]`, which no point of it exceeds.
    pub(crate) fn sag(&self) -> f64 {
        let [a, b, c, d] = self.0;
        let away = |at: Point| distance(at, on_segment([a, d], at));
        away(b).max(away(c))
    }
}

/// The nearest point of a segment.
pub(crate) fn on_segment([from, to]: [Point; 2], point: Point) -> Point {
    let d = minus(to, from);
    let size = dot(d, d);
    if size <= 0.0 {
        return from;
    }
    along(from, (dot(minus(point, from), d) / size).clamp(0.0, 1.0), d)
}

fn bernstein([a, b, c, d]: [f64; 4], t: f64) -> f64 {
    let s = 1.0 - t;
    s * s * (s * a + 3.0 * t * b) + t * t * (3.0 * s * c + t * d)
}

/// The root in [low, high] of a function with the sign of its slope at `high`; it returns its value and its slope.
pub(crate) fn root([mut low, mut high]: [f64; 2], function: impl Fn(f64) -> (f64, f64)) -> f64 {
    let mut t = f64::midpoint(low, high);
    for _ in 0..STEPS {
        let (value, slope) = function(t);
        if value == 0.0 {
            break;
        }
        if value < 0.0 {
            low = t;
        } else {
            high = t;
        }
        let newton = t - value / slope;
        let next = if newton >= low && newton <= high {
            newton
        } else {
            f64::midpoint(low, high)
        };
        let step = (next - t).abs();
        t = next;
        if step <= f64::EPSILON * t {
            break;
        }
    }
    t
}

/// Zeros in [0, 1] of a cubic polynomial by its Bernstein coefficients.
fn roots(g: [f64; 4]) -> Vec<f64> {
    let all = |is: fn(&f64) -> bool| g.iter().all(is);
    if all(|own| *own > 0.0) || all(|own| *own < 0.0) {
        return Vec::new();
    }
    let steps = [g[1] - g[0], g[2] - g[1], g[3] - g[2]];
    let mut ends = vec![0.0];
    ends.extend(quadratic_roots(steps));
    ends.push(1.0);
    let mut found = Vec::new();
    for pair in ends.windows(2) {
        let [low, high] = [pair[0], pair[1]].map(|t| bernstein(g, t));
        if low == 0.0 {
            found.push(pair[0]);
        } else if low * high < 0.0 {
            let sign = high.signum();
            found.push(root([pair[0], pair[1]], |t| {
                let s = 1.0 - t;
                let slope = s * s * steps[0] + 2.0 * s * t * steps[1] + t * t * steps[2];
                (sign * bernstein(g, t), 3.0 * sign * slope)
            }));
        }
    }
    if g[3] == 0.0 {
        found.push(1.0);
    }
    found
}

/// Zeros in (0, 1) of a quadratic polynomial by its Bernstein coefficients, ascending.
fn quadratic_roots([p, q, r]: [f64; 3]) -> Vec<f64> {
    let (a, half, c) = (p - 2.0 * q + r, q - p, p);
    let under = half * half - a * c;
    if under < 0.0 {
        return Vec::new();
    }
    let sum = -(half + under.sqrt().copysign(half));
    let mut found: Vec<f64> = [sum / a, c / sum]
        .into_iter()
        .filter(|t| *t > 0.0 && *t < 1.0)
        .collect();
    found.sort_by(f64::total_cmp);
    found
}

/// Angle between two directions `[rad]`, up to π.
pub(crate) fn angle_between(u: Point, v: Point) -> f64 {
    cross(u, v).atan2(dot(u, v)).abs().min(PI)
}
