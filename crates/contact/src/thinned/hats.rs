//! Hats on chosen nodes of an edge.

use std::sync::Arc;

use crate::deformed::Facing;
use crate::error::ContactError;
use crate::problem::{ContactPair, ContactPoint, frame};
use nalgebra::Matrix2;
use stickslip_fem_core::mesh::Point;

/// Where the contact points of a pair stand along their edge.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgeNodes {
    /// Ascending places of the points, in any unit.
    pub parameter: Vec<f64>,
    /// Period after which a closed edge begins again, in the unit of `parameter`.
    pub closed: Option<f64>,
    /// Whether the first and the last point of an open edge lie on a line of symmetry.
    pub mirrored: [bool; 2],
}

/// The hat of a chosen node.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Hat {
    /// Points of the pair with their weights w.
    pub(crate) terms: Vec<(usize, f64)>,
    /// φ at the points of `terms`.
    values: Vec<f64>,
    area: f64,
    pub(crate) normal: [f64; 2],
    /// Whether it stands on a line of symmetry, where points move along the normal only.
    is_on_axis: bool,
}

impl Hat {
    /// That with the `values` at points of `pair`; `axis` is its node if that stands on a line of symmetry.
    fn new(pair: &ContactPair, values: &[(usize, f64)], axis: Option<usize>) -> Self {
        let areas = || (values.iter()).map(|&(k, value)| value * pair.points[k].area);
        let area: f64 = areas().sum();
        let sum = (values.iter().zip(areas())).fold([0.0; 2], |sum: [f64; 2], (&(k, _), own)| {
            [0, 1].map(|i| sum[i] + own * pair.points[k].normal[i])
        });
        let length = sum[0].hypot(sum[1]);
        let mean = sum.map(|part| part / length);
        Self {
            terms: (values.iter().zip(areas()))
                .map(|(&(k, _), own)| (k, own / area))
                .collect(),
            values: values.iter().map(|(_, value)| *value).collect(),
            area,
            normal: axis.map_or(mean, |node| pair.points[node].normal),
            is_on_axis: axis.is_some(),
        }
    }

    /// What takes the displacement of the point `term` into that of the hat, both along x and y.
    pub(crate) fn matrix(&self, pair: &ContactPair, term: usize) -> Matrix2<f64> {
        let (point, weight) = self.terms[term];
        let mut own = frame(pair.points[point].normal) * weight;
        if self.is_on_axis {
            own.row_mut(1).fill(0.0);
        }
        frame(self.normal).transpose() * own
    }
}

/// The hats of a pair.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Hats {
    chosen: Vec<usize>,
    all: Vec<Hat>,
    /// Places of the chosen nodes.
    parameter: Vec<f64>,
    /// For each point of the pair the hats that it is under and their values there.
    over: Vec<Vec<(usize, f64)>>,
}

impl Hats {
    pub(crate) fn new(
        pair: &ContactPair,
        edge: &EdgeNodes,
        chosen: &[usize],
    ) -> Result<Self, ContactError> {
        let count = pair.points.len();
        let refuse = |point: usize, what: &str| ContactError::InvalidPair {
            pair: pair.name.clone(),
            point,
            what: what.to_owned(),
        };
        if chosen.len() < 3 {
            return Err(refuse(0, "at least three nodes are chosen"));
        }
        let ascends = chosen.windows(2).all(|ends| ends[0] < ends[1]);
        if !ascends || chosen[chosen.len() - 1] >= count {
            return Err(refuse(chosen[0], "chosen nodes ascend and exist"));
        }
        let over = over(edge, chosen, count);
        let mut terms = vec![Vec::new(); chosen.len()];
        for (point, hats) in over.iter().enumerate() {
            for &(hat, value) in hats {
                terms[hat].push((point, value));
            }
        }
        let hat = |(index, own): (usize, &Vec<(usize, f64)>)| {
            let ends = [index == 0, index + 1 == chosen.len()];
            let is_on_axis =
                edge.closed.is_none() && (0..2).any(|end| ends[end] && edge.mirrored[end]);
            Hat::new(pair, own, is_on_axis.then_some(chosen[index]))
        };
        Ok(Self {
            all: terms.iter().enumerate().map(hat).collect(),
            parameter: chosen.iter().map(|&k| edge.parameter[k]).collect(),
            chosen: chosen.to_vec(),
            over,
        })
    }

    pub(crate) fn chosen(&self) -> &[usize] {
        &self.chosen
    }

    pub(crate) fn all(&self) -> &[Hat] {
        &self.all
    }

    /// For each point of the pair the hats that it is under and their values there, the largest first.
    pub(crate) fn over(&self) -> &[Vec<(usize, f64)>] {
        &self.over
    }

    /// `pair` with its chosen points, nodes of the two bodies from `offsets` on.
    pub(crate) fn pair(&self, pair: &ContactPair, offsets: [usize; 2]) -> ContactPair {
        let point = |(index, hat): (usize, &Hat)| ContactPoint {
            first: (offsets[0] + index).into(),
            second: (offsets[1] + index).into(),
            normal: hat.normal,
            gap: hat.mean(|k| pair.points[k].gap),
            area: hat.area,
            material_angle: pair.points[self.chosen[index]].material_angle,
        };
        ContactPair {
            name: pair.name.clone(),
            origin: pair.origin,
            first: pair.first,
            second: pair.second,
            points: self.all.iter().enumerate().map(point).collect(),
            law: Arc::clone(&pair.law),
        }
    }

    /// The edges of `thinned`, whose nodes are those of `facing`.
    pub(crate) fn facing(
        &self,
        facing: &Facing,
        thinned: &ContactPair,
    ) -> Result<Facing, ContactError> {
        let nodes = thinned.points.iter().map(|point| point.second.node());
        let nodes = nodes.map(Option::unwrap_or_default).collect();
        let places = facing.second.places();
        let means = |hat: &Hat| {
            // On an axis the other half of the hat mirrors its own.
            if hat.is_on_axis {
                places[hat.terms[hat.own()].0]
            } else {
                hat.mean_of_places(places, facing.second.period())
            }
        };
        let means = self.all.iter().map(means).collect();
        let second = facing.second.thinned(nodes, self.parameter.clone(), means);
        Ok(Facing {
            first: (self.all.iter())
                .map(|hat| hat.place(&facing.first, facing.centre))
                .collect(),
            centre: facing.centre,
            second: second.map_err(|cause| ContactError::InvalidPair {
                pair: thinned.name.clone(),
                point: 0,
                what: cause.to_string(),
            })?,
        })
    }
}

impl Hat {
    fn own(&self) -> usize {
        let values = self.values.iter().enumerate();
        let highest = values.max_by(|(_, one), (_, other)| one.total_cmp(other));
        highest.map_or(0, |(term, _)| term)
    }

    /// The mean of what `value` is at points.
    pub(crate) fn mean(&self, value: impl Fn(usize) -> f64) -> f64 {
        self.terms
            .iter()
            .map(|&(k, weight)| weight * value(k))
            .sum()
    }

    /// The mean of places along an edge that begins again after `period`.
    fn mean_of_places(&self, places: &[f64], period: Option<f64>) -> f64 {
        let own = places[self.terms[self.own()].0];
        let away = |k: usize| {
            let apart = places[k] - own;
            period.map_or(apart, |period| apart - period * (apart / period).round())
        };
        own + self.mean(away)
    }

    /// The mean of `places` of the points, about `centre` in frames that turn along the edge.
    fn place(&self, places: &[Point], centre: Option<Point>) -> Point {
        let Some(centre) = centre else {
            return [0, 1].map(|i| self.mean(|k| places[k][i]));
        };
        let away = |k: usize| [0, 1].map(|i| places[k][i] - centre[i]);
        let own = away(self.terms[self.own()].0);
        let radius = self.mean(|k| {
            let [x, y] = away(k);
            x.hypot(y)
        });
        let turn = if self.is_on_axis {
            0.0
        } else {
            self.mean(|k| {
                let [x, y] = away(k);
                (own[0] * y - own[1] * x).atan2(own[0] * x + own[1] * y)
            })
        };
        let (sine, cosine) = turn.sin_cos();
        let scale = radius / own[0].hypot(own[1]);
        [
            centre[0] + scale * (cosine * own[0] - sine * own[1]),
            centre[1] + scale * (sine * own[0] + cosine * own[1]),
        ]
    }
}

/// The hats that each of `count` points is under with their values there, the largest first.
fn over(edge: &EdgeNodes, chosen: &[usize], count: usize) -> Vec<Vec<(usize, f64)>> {
    let place = |k: usize| edge.parameter[k];
    let last = chosen.len() - 1;
    let under = |point: usize| -> Vec<(usize, f64)> {
        let next = chosen.partition_point(|&own| own < point);
        if chosen.get(next) == Some(&point) {
            return vec![(next, 1.0)];
        }
        let (before, after) = match (next.checked_sub(1), edge.closed) {
            (Some(before), _) if next <= last => (before, next),
            (_, Some(_)) => (last, 0),
            // Beyond the ends of an open edge the last hat goes on.
            (None, None) => return vec![(0, 1.0)],
            (Some(before), None) => return vec![(before, 1.0)],
        };
        let along = |from: usize, to: usize| {
            let apart = place(to) - place(from);
            edge.closed.map_or(apart, |period| apart.rem_euclid(period))
        };
        let part = along(chosen[before], point) / along(chosen[before], chosen[after]);
        let mut both = vec![(before, 1.0 - part), (after, part)];
        if part > 0.5 {
            both.reverse();
        }
        both
    };
    (0..count).map(under).collect()
}
