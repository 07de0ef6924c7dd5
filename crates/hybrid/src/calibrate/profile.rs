//! Profiles of χ²: one parameter held at one value after another, all others free.
//!
//! ```text
//! χ²ⱼ(t) = min χ²(θ),  θⱼ = t;     from the best fit outwards in growing steps to both ends of the range
//! ```

use super::CalibrateError;
use super::search::{Point, ROUGHLY, Search};
use crate::identify::Bounds;

/// First step where the curvature of χ² suggests none, and the largest first step.
const FIRST_STEP: f64 = 0.05;
const SMALLEST_STEP: f64 = 1e-5;
const GROWTH: f64 = 1.7;
/// How much below the best fit a profile may fall before it counts as a better one.
const BETTER: f64 = 1e-2;
/// Ends of intervals are found to this part of their distance from the best fit.
const ACCURACY: f64 = 5e-3;
const BISECTIONS: usize = 12;
/// A model that refuses so close beyond the end of an interval, in parts of the range, ends it itself.
const BEYOND: f64 = 2e-3;

pub(super) enum Outcome {
    Profile {
        bounds: Bounds,
        /// Values and increase of χ².
        points: Vec<(f64, f64)>,
    },
    /// A point with a smaller χ² than the one the profile started from.
    Better(Point),
}

/// A place of the profile: part of the range, and the point there if the model predicts.
struct Place {
    part: f64,
    point: Option<Point>,
}

impl Place {
    fn increase(&self, best: &Point) -> f64 {
        self.point.as_ref().map_or(f64::INFINITY, |point| {
            (point.chi_squared - best.chi_squared).max(0.0)
        })
    }
}

impl Search<'_> {
    /// Whether the model refuses to go on from `edge` along `axis` to the side of `sign` when all others stay: then it is the model that
    /// ends there, and not the data that say so.
    fn refuses_beyond(
        &mut self,
        edge: &Point,
        axis: usize,
        sign: f64,
    ) -> Result<bool, CalibrateError> {
        let mut parts = edge.parts.clone();
        parts[axis] = (parts[axis] + sign * BEYOND).clamp(0.0, 1.0);
        Ok(self.at(&parts)?.is_none())
    }

    /// The profile of parameter `axis` about `best`, whose standard deviation in parts is `deviation`, with the interval in which χ²
    /// increases by at most `limit`; [`Outcome::Better`] where it meets a better point, unless this is the `last` round.
    pub(super) fn profile(
        &mut self,
        best: &Point,
        grid: &[Point],
        (axis, deviation): (usize, Option<f64>),
        limit: f64,
        last: bool,
    ) -> Result<Outcome, CalibrateError> {
        let step = deviation.map_or(FIRST_STEP, |own| {
            (0.5 * own).clamp(SMALLEST_STEP, FIRST_STEP)
        });
        let mut places = vec![Place {
            part: best.parts[axis],
            point: Some(best.clone()),
        }];
        let mut ends = [None, None];
        for (side, end) in ends.iter_mut().enumerate() {
            let sign = if side == 0 { -1.0 } else { 1.0 };
            let mut walk: Vec<Place> = Vec::new();
            for part in outwards(best.parts[axis], sign, step) {
                let near = walk.iter().rev().find_map(|place| place.point.as_ref());
                let point = self.least_at(near.unwrap_or(best), grid, axis, part)?;
                let better = |own: &&Point| !last && own.chi_squared < best.chi_squared - BETTER;
                if let Some(point) = point.as_ref().filter(better) {
                    return Ok(Outcome::Better(point.clone()));
                }
                walk.push(Place { part, point });
            }
            let inside = walk.iter().rposition(|place| place.increase(best) <= limit);
            let outside = inside.map_or(0, |k| k + 1);
            if outside < walk.len() {
                let from = inside.map_or(best, |k| walk[k].point.as_ref().unwrap_or(best));
                let from = from.clone();
                let (part, edge) = self.crossing(best, &from, grid, axis, &walk[outside], limit)?;
                if !self.refuses_beyond(&edge, axis, sign)? {
                    *end = Some(part);
                }
            }
            places.extend(walk);
        }
        places.sort_by(|a, b| a.part.total_cmp(&b.part));
        let value = |part: f64| self.parameters()[axis].at(part);
        let bounds = Bounds::of(ends.map(|end| end.map(value)));
        let finite = places.iter().filter(|place| place.point.is_some());
        let points = finite
            .map(|place| (value(place.part), place.increase(best)))
            .collect();
        Ok(Outcome::Profile { bounds, points })
    }

    /// The least χ² with parameter `axis` at `part`, from the others of `near` and from the best of the grid beside.
    fn least_at(
        &mut self,
        near: &Point,
        grid: &[Point],
        axis: usize,
        part: f64,
    ) -> Result<Option<Point>, CalibrateError> {
        const MORE_STARTS: usize = 6;
        let moved = |point: &Point| {
            let mut parts = point.parts.clone();
            parts[axis] = part;
            parts
        };
        let mut start = self.at(&moved(near))?;
        if near.parts.len() == 1 {
            return Ok(start);
        }
        let distance = |point: &&Point| (point.parts[axis] - part).abs();
        let nearest = grid
            .iter()
            .map(|point| distance(&point))
            .fold(f64::INFINITY, f64::min);
        let beside = grid
            .iter()
            .filter(|point| distance(point) <= nearest + 1e-12);
        for other in beside.take(MORE_STARTS) {
            let found = self.at(&moved(other))?;
            if let Some(found) = found {
                let better = start
                    .as_ref()
                    .is_none_or(|own| found.chi_squared < own.chi_squared);
                start = if better { Some(found) } else { start };
                break;
            }
        }
        start
            .map(|start| self.descend(start, &[axis], ROUGHLY))
            .transpose()
    }

    /// Part of the range at which the profile passes `limit` between `inside` and `outside`: false position on the root of the
    /// increase, which is nearly linear, and bisection where that does not help. Where the model refuses outside, bisection alone, until
    /// the bracket is so narrow that the refusal shows from inside. With the last point inside.
    fn crossing(
        &mut self,
        best: &Point,
        inside: &Point,
        grid: &[Point],
        axis: usize,
        outside: &Place,
        limit: f64,
    ) -> Result<(f64, Point), CalibrateError> {
        let root = limit.sqrt();
        let excess = |increase: f64| increase.sqrt() - root;
        let mut from = inside.clone();
        let mut low = (
            inside.parts[axis],
            excess((inside.chi_squared - best.chi_squared).max(0.0)),
        );
        let mut high = (outside.part, excess(outside.increase(best)));
        let mut turn = 0;
        loop {
            let width = (high.0 - low.0).abs();
            let refused = high.1.is_infinite();
            if refused && width < 0.5 * BEYOND || !refused && turn >= BISECTIONS {
                break;
            }
            if !refused && width <= ACCURACY * (low.0 - best.parts[axis]).abs().max(SMALLEST_STEP) {
                break;
            }
            let straight = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
            // A bracket of numbers is narrowed from two sides; that of a refusal halves, which ends of itself.
            let part = if !refused && straight.is_finite() && turn % 3 != 2 {
                // A little to the side of the farther end, so that the bracket closes from both.
                let margin = 0.25 * ACCURACY * (high.0 - low.0);
                let [least, most] = [(low.0 + margin), (high.0 - margin)];
                straight.clamp(least.min(most), least.max(most))
            } else {
                f64::midpoint(low.0, high.0)
            };
            turn += usize::from(!refused);
            let place = Place {
                part,
                point: self.least_at(&from, grid, axis, part)?,
            };
            let above = excess(place.increase(best));
            if above > 0.0 {
                high = (part, above);
            } else {
                low = (part, above);
                from = place.point.unwrap_or(from);
            }
        }
        let straight = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
        let end = if high.1.is_finite() && straight.is_finite() {
            straight
        } else {
            f64::midpoint(low.0, high.0)
        };
        Ok((end, from))
    }
}

/// Parts from `start` to the end of the range in direction `sign`: some steps of `step`, so that the profile is well seen where it matters,
/// and growing ones beyond.
fn outwards(start: f64, sign: f64, step: f64) -> Vec<f64> {
    const EQUAL: usize = 6;
    let end = if sign < 0.0 { 0.0 } else { 1.0 };
    let mut parts = Vec::new();
    let (mut part, mut step) = (start, step);
    while (end - part) * sign > SMALLEST_STEP {
        part += sign * step;
        if (end - part) * sign < 0.5 * step {
            part = end;
        }
        parts.push(part);
        if parts.len() >= EQUAL {
            step *= GROWTH;
        }
    }
    parts
}
