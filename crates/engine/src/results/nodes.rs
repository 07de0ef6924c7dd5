//! Between the nodes of an edge.

use super::{EdgeGeometry, EdgeRow};

/// Pressure, shear and σ_t `[MPa]` of a node, or their errors.
pub(crate) type Values = [f64; 3];

/// Where the nodes of an edge are.
#[derive(Clone)]
pub(crate) struct Nodes {
    pub(crate) parameter: Vec<f64>,
    closed: Option<f64>,
}

impl Nodes {
    pub(crate) fn of(geometry: &EdgeGeometry) -> Self {
        Self {
            parameter: geometry.parameter.clone(),
            closed: geometry.closed().filter(|_| !geometry.half),
        }
    }

    fn count(&self) -> usize {
        self.parameter.len()
    }

    /// The nodes on both sides of a place.
    pub(crate) fn around(&self, at: f64) -> [usize; 2] {
        let next = self.parameter.partition_point(|own| *own < at);
        let last = self.count() - 1;
        match self.closed {
            Some(_) => [(next + last) % self.count(), next % self.count()],
            None => {
                let to = next.clamp(1, last.max(1));
                [to - 1, to.min(last)]
            }
        }
    }

    /// From the node `from` ahead to a place.
    fn ahead(&self, from: usize, at: f64) -> f64 {
        let apart = at - self.parameter[from];
        self.closed.map_or(apart, |length| apart.rem_euclid(length))
    }

    /// How far apart the nodes on both sides of a place are.
    pub(crate) fn spacing(&self, at: f64) -> f64 {
        let [from, to] = self.around(at);
        self.ahead(from, self.parameter[to])
    }

    /// The largest errors of nodes no farther from the node `k` than `reach`.
    pub(crate) fn largest_near(&self, errors: &[Values], k: usize, reach: f64) -> Values {
        let count = self.count();
        let mut largest = errors[k];
        let ahead = (1..count).map(|step| k + step);
        let back = (1..count).map(|step| k + count - step);
        let is_inside = |node: usize| self.closed.is_some() || (count..2 * count).contains(&node);
        // Open edges are counted from the second period, so that walks leave it at their ends.
        let shift = if self.closed.is_some() { 0 } else { count };
        for node in ahead.take_while(|node| is_inside(node + shift)) {
            if self.ahead(k, self.parameter[node % count]) > reach {
                break;
            }
            largest = joined(largest, errors[node % count], f64::max);
        }
        for node in back.take_while(|node| is_inside(*node)) {
            if self.ahead(node % count, self.parameter[k]) > reach {
                break;
            }
            largest = joined(largest, errors[node % count], f64::max);
        }
        largest
    }

    /// The values of `rows` at a place.
    pub(crate) fn interpolated(&self, rows: &[EdgeRow], at: f64) -> Values {
        let [from, to] = self.around(at);
        let count = self.count();
        let [before, after] = match self.closed {
            Some(_) => [(from + count - 1) % count, (to + 1) % count],
            None => [from.saturating_sub(1), (to + 1).min(count - 1)],
        };
        let wide = [before, from, to, after];
        let alike = wide.iter().all(|&k| rows[k].status == rows[from].status);
        let distinct = wide.windows(2).all(|pair| pair[0] != pair[1]);
        let near = [from, to];
        let chosen = if alike && distinct {
            &wide[..]
        } else if from != to {
            &near[..]
        } else {
            &near[..1]
        };
        let start = self.parameter[chosen[0]];
        let places: Vec<f64> = chosen
            .iter()
            .map(|&k| self.ahead(chosen[0], self.parameter[k]))
            .collect();
        let at = self
            .closed
            .map_or(at - start, |length| (at - start).rem_euclid(length));
        let weights: Vec<f64> = (0..chosen.len())
            .map(|own| {
                let others = (0..chosen.len()).filter(|&other| other != own);
                let factors =
                    others.map(|other| (at - places[other]) / (places[own] - places[other]));
                factors.product()
            })
            .collect();
        let terms = chosen.iter().zip(&weights);
        let terms = terms.map(|(&k, weight)| values(&rows[k]).map(|value| weight * value));
        terms.fold([0.0; 3], |sum, term| {
            joined(sum, term, |sum, term| sum + term)
        })
    }
}

impl EdgeGeometry {
    /// Pressure, shear and stress along the edge `[MPa]` of `rows`, one per node, at a `place` of the edge's parameter: by the cubic polynomial of four nodes of
    /// one status, and linear elsewhere.
    pub fn values_at(&self, rows: &[EdgeRow], place: f64) -> [f64; 3] {
        Nodes::of(self).interpolated(rows, place)
    }
}

pub(crate) fn values(row: &EdgeRow) -> Values {
    [row.pressure, row.shear, row.sigma_tangential]
}

pub(crate) fn joined(one: Values, other: Values, join: impl Fn(f64, f64) -> f64) -> Values {
    std::array::from_fn(|k| join(one[k], other[k]))
}
