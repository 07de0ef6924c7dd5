//! One line of fringe centres: its track, the order along it, interpolation.
//!
//! Between neighbouring centres the fringe order is linear in the distance along the track, N(s) = (1 − t) N_i + t N_i+1.

use std::f64::consts::TAU;

use stickslip_fem_core::mesh::Point;
use stickslip_fem_core::vector::{cross, dot, minus};

use super::DataError;
use super::centres::{Origin, Written};
use crate::order_statistics::median;

/// Fraction of a line's length by which a place may lie beyond its end and still count as its end: rounding, no more.
const SLACK: f64 = 1e-9;

/// What curve the fringe centres of a line lie on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Track {
    /// The straight line that fits the centres best; centres are sorted along it.
    Straight,
    /// The circle around a centre; fringe centres are sorted by angle, open ones from the largest gap on.
    Circle {
        /// Where `[length]`.
        centre: Point,
        /// Whether the last fringe centre is followed by the first.
        closed: bool,
    },
    /// Straight steps from centre to centre as they were digitised; a line that turns back is refused, because the order of its centres is
    /// unknown.
    Drawn,
}

/// Fringe centres in order along a line.
#[derive(Clone, Debug, PartialEq)]
pub struct FringeLine {
    name: String,
    curve: Curve,
    places: Vec<Point>,
    orders: Vec<f64>,
    /// Distance along the line, or angle on a circle, ascending.
    parameters: Vec<f64>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Curve {
    Straight {
        origin: Point,
        direction: Point,
    },
    Circle {
        centre: Point,
        radius: f64,
        closed: bool,
    },
    Drawn,
}

/// A place between two fringe centres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Located {
    /// Indices of the centres before and after it.
    pub centres: [usize; 2],
    /// Their weights `[1]`, which sum to 1.
    pub weights: [f64; 2],
    /// Distance of the place from the line `[length]`.
    pub distance: f64,
}

/// A step between neighbouring fringe centres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Orders at its ends `[fringes]`.
    pub orders: [f64; 2],
    /// Length along the track `[length]`.
    pub length: f64,
    /// Its middle on the track `[length]`.
    pub middle: Point,
}

impl FringeLine {
    /// Puts `centres` (place `[length]`, order `[fringes]`) in order along a track; `source` and `name` are what errors call them.
    ///
    /// # Errors
    /// [`DataError`]: fewer than 2 centres, a centre more than `tolerance` `[length]` off a straight or circular track (or not
    /// finite), two at one place, a drawn line that turns back by more than a right angle.
    pub fn new(
        source: &str,
        name: &str,
        track: Track,
        centres: &[(Point, f64)],
        tolerance: f64,
    ) -> Result<Self, DataError> {
        let written: Vec<Written> = centres
            .iter()
            .map(|&(place, order)| Written {
                row: None,
                place,
                order,
            })
            .collect();
        let origin = Origin {
            file: source,
            name,
            centres: &written,
            scale: 1.0,
            tolerance,
        };
        Self::along(&origin, track, centres)
    }

    /// As [`new`](Self::new), of centres that were written elsewhere, as `origin` says.
    pub(super) fn along(
        origin: &Origin<'_>,
        track: Track,
        centres: &[(Point, f64)],
    ) -> Result<Self, DataError> {
        if centres.len() < 2 {
            return Err(origin.short());
        }
        let curve = Curve::fit(track, centres);
        for (centre, &(place, order)) in centres.iter().enumerate() {
            let distance = curve.distance(place);
            // A distance that is not a number is off the line as well.
            if !(distance <= origin.tolerance && order.is_finite()) {
                return Err(origin.off(centre, distance));
            }
        }
        let sorted = curve.sorted(centres);
        let line = Self {
            name: origin.name.into(),
            curve,
            places: sorted.iter().map(|&(_, k)| centres[k].0).collect(),
            orders: sorted.iter().map(|&(_, k)| centres[k].1).collect(),
            parameters: sorted.iter().map(|&(parameter, _)| parameter).collect(),
        };
        line.check_steps(origin, &sorted)?;
        Ok(line)
    }

    /// Refuses centres at one place and drawn lines that turn back; `sorted` has the indices of the centres as given.
    fn check_steps(&self, origin: &Origin<'_>, sorted: &[(f64, usize)]) -> Result<(), DataError> {
        for ((i, j), step) in self.pairs().zip(self.steps()) {
            // Centres at that of a circle have angles by the signs of their zeros, and no length between them.
            if step.length <= 0.0 {
                return Err(origin.repeated([sorted[i].1, sorted[j].1]));
            }
        }
        if self.curve == Curve::Drawn {
            for (k, triple) in self.places.windows(3).enumerate() {
                let (before, after) = (minus(triple[1], triple[0]), minus(triple[2], triple[1]));
                let angle = cross(before, after).atan2(dot(before, after)).abs();
                if angle > std::f64::consts::FRAC_PI_2 {
                    return Err(origin.back(sorted[k + 1].1, angle.to_degrees()));
                }
            }
        }
        Ok(())
    }

    /// Distance of a place from the track `[length]`; 0 for a drawn line.
    pub(super) fn off(&self, place: Point) -> f64 {
        self.curve.distance(place)
    }

    /// Median distance along the track of neighbouring fringe centres `[length]`.
    pub fn spacing(&self) -> f64 {
        median(self.steps().map(|step| step.length).collect()).unwrap_or(0.0)
    }

    /// Name of the line.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Places of the fringe centres in order along the line `[length]`.
    pub fn places(&self) -> &[Point] {
        &self.places
    }

    /// Orders of the fringe centres `[fringes]`, one for each of [`places`](Self::places).
    pub fn orders(&self) -> &[f64] {
        &self.orders
    }

    /// The same line with the orders `orders`, one per centre.
    pub(super) fn with_orders(&self, kept: &[usize], orders: Vec<f64>) -> Self {
        Self {
            places: kept.iter().map(|&k| self.places[k]).collect(),
            parameters: kept.iter().map(|&k| self.parameters[k]).collect(),
            orders,
            ..self.clone()
        }
    }

    /// Finds where `place` `[length]` lies along the line; `None` beyond its ends.
    pub fn locate(&self, place: Point) -> Option<Located> {
        match self.curve {
            Curve::Drawn => self.nearest(place),
            Curve::Straight { origin, direction } => {
                self.bracket(dot(minus(place, origin), direction), place)
            }
            Curve::Circle { centre, closed, .. } => {
                let first = self.parameters[0];
                let turned = (angle(place, centre) - first).rem_euclid(TAU);
                // An angle just before the first one is the first but for rounding.
                let past = !closed && turned > TAU * (1.0 - SLACK);
                self.bracket(first + if past { 0.0 } else { turned }, place)
            }
        }
    }

    /// Interpolates the fringe order `[fringes]` at `place` `[length]`, linear between the centres around it; `None` beyond the ends of
    /// the line.
    pub fn order_at(&self, place: Point) -> Option<f64> {
        let Located {
            centres, weights, ..
        } = self.locate(place)?;
        Some(weights[0] * self.orders[centres[0]] + weights[1] * self.orders[centres[1]])
    }

    /// Steps between neighbouring fringe centres.
    pub fn steps(&self) -> impl Iterator<Item = Step> + '_ {
        self.pairs().map(|(i, j)| {
            let gap = self.gap(i, j);
            let (length, middle) = match self.curve {
                Curve::Circle { centre, radius, .. } => {
                    let (sine, cosine) = (self.parameters[i] + 0.5 * gap).sin_cos();
                    let middle = [centre[0] + radius * cosine, centre[1] + radius * sine];
                    (radius * gap, middle)
                }
                Curve::Straight { .. } | Curve::Drawn => {
                    let middle =
                        std::array::from_fn(|c| 0.5 * (self.places[i][c] + self.places[j][c]));
                    (gap, middle)
                }
            };
            Step {
                orders: [self.orders[i], self.orders[j]],
                length,
                middle,
            }
        })
    }

    /// Neighbours along the line.
    fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let count = self.places.len();
        let closed = matches!(self.curve, Curve::Circle { closed: true, .. });
        (0..count - usize::from(!closed)).map(move |i| (i, (i + 1) % count))
    }

    /// Distance along the line from centre `i` to its neighbour `j`, as an angle on a circle.
    fn gap(&self, i: usize, j: usize) -> f64 {
        let turn = if j > i { 0.0 } else { TAU };
        self.parameters[j] + turn - self.parameters[i]
    }

    fn bracket(&self, parameter: f64, place: Point) -> Option<Located> {
        let distance = self.curve.distance(place);
        let last = self.places.len() - 1;
        let slack = SLACK * (self.parameters[last] - self.parameters[0]);
        self.pairs().find_map(|(i, j)| {
            let (from, gap) = (self.parameters[i], self.gap(i, j));
            let before = if i == 0 { slack } else { 0.0 };
            let after = if j == last { slack } else { 0.0 };
            (parameter >= from - before && parameter <= from + gap + after).then(|| {
                let t = ((parameter - from) / gap).clamp(0.0, 1.0);
                Located {
                    centres: [i, j],
                    weights: [1.0 - t, t],
                    distance,
                }
            })
        })
    }

    /// The nearest place on the straight steps, unless it is an end beyond which the place lies.
    fn nearest(&self, place: Point) -> Option<Located> {
        let last = self.places.len() - 1;
        let mut best: Option<(Located, bool)> = None;
        for (i, j) in self.pairs() {
            let along = minus(self.places[j], self.places[i]);
            let raw = dot(minus(place, self.places[i]), along) / dot(along, along);
            let t = raw.clamp(0.0, 1.0);
            let foot = [
                self.places[i][0] + t * along[0],
                self.places[i][1] + t * along[1],
            ];
            let off = minus(place, foot);
            let located = Located {
                centres: [i, j],
                weights: [1.0 - t, t],
                distance: off[0].hypot(off[1]),
            };
            let beyond = (i == 0 && raw < -SLACK) || (j == last && raw > 1.0 + SLACK);
            if best.is_none_or(|(other, _)| located.distance < other.distance) {
                best = Some((located, beyond));
            }
        }
        best.and_then(|(located, beyond)| (!beyond).then_some(located))
    }
}

impl Curve {
    fn fit(track: Track, centres: &[(Point, f64)]) -> Self {
        let count = centres.len() as f64;
        match track {
            Track::Drawn => Self::Drawn,
            Track::Circle { centre, closed } => {
                let sum: f64 = centres
                    .iter()
                    .map(|&(place, _)| distance(place, centre))
                    .sum();
                Self::Circle {
                    centre,
                    radius: sum / count,
                    closed,
                }
            }
            Track::Straight => {
                let mean =
                    |c: usize| centres.iter().map(|(place, _)| place[c]).sum::<f64>() / count;
                let origin = [mean(0), mean(1)];
                let [xx, yy, xy] = centres.iter().fold([0.0; 3], |[xx, yy, xy], &(place, _)| {
                    let [x, y] = minus(place, origin);
                    [xx + x * x, yy + y * y, xy + x * y]
                });
                // The direction of largest spread.
                let (sine, cosine) = (0.5 * (2.0 * xy).atan2(xx - yy)).sin_cos();
                let ends = minus(centres[centres.len() - 1].0, centres[0].0);
                let sign = if dot(ends, [cosine, sine]) < 0.0 {
                    -1.0
                } else {
                    1.0
                };
                Self::Straight {
                    origin,
                    direction: [sign * cosine, sign * sine],
                }
            }
        }
    }

    /// Distance of a place from the curve; 0 for a drawn line, which goes through its places.
    fn distance(&self, place: Point) -> f64 {
        match *self {
            Self::Drawn => 0.0 * (place[0] + place[1]),
            Self::Straight { origin, direction } => cross(direction, minus(place, origin)).abs(),
            Self::Circle { centre, radius, .. } => (distance(place, centre) - radius).abs(),
        }
    }

    /// Parameters of the centres in order along the curve, each with the index of its centre.
    fn sorted(&self, centres: &[(Point, f64)]) -> Vec<(f64, usize)> {
        let mut length = 0.0;
        let mut before = centres[0].0;
        let mut list: Vec<(f64, usize)> = centres
            .iter()
            .enumerate()
            .map(|(index, &(place, _))| {
                let parameter = match *self {
                    Self::Straight { origin, direction } => dot(minus(place, origin), direction),
                    Self::Circle { centre, .. } => angle(place, centre),
                    Self::Drawn => {
                        length += distance(place, before);
                        before = place;
                        length
                    }
                };
                (parameter, index)
            })
            .collect();
        list.sort_by(|a, b| a.0.total_cmp(&b.0));
        if let Self::Circle { closed: false, .. } = self {
            let count = list.len();
            let gap = |k: usize| (list[(k + 1) % count].0 - list[k].0).rem_euclid(TAU);
            let widest = (0..count)
                .max_by(|&a, &b| gap(a).total_cmp(&gap(b)))
                .unwrap_or(0);
            let start = (widest + 1) % count;
            for centre in &mut list[..start] {
                centre.0 += TAU;
            }
            list.rotate_left(start);
        }
        list
    }
}

fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn angle(place: Point, centre: Point) -> f64 {
    (place[1] - centre[1]).atan2(place[0] - centre[0])
}
