//! Between the nodes of an edge.

use super::{EdgeGeometry, EdgeRow, RowErrors};

/// Pressure, shear and σ_t `[MPa]` of a node, or their errors.
pub type Values = [f64; 3];

/// Where the nodes of an edge are.
#[derive(Clone, Debug, PartialEq)]
pub struct Nodes {
    /// Their places along the edge, ascending `[rad or mm]`.
    pub parameter: Vec<f64>,
    closed: Option<f64>,
}

impl Nodes {
    /// Those of the edge `geometry`.
    pub fn of(geometry: &EdgeGeometry) -> Self {
        Self {
            parameter: geometry.parameter.clone(),
            closed: geometry.closed().filter(|_| !geometry.half),
        }
    }

    fn count(&self) -> usize {
        self.parameter.len()
    }

    /// The nodes on both sides of the place `at` `[rad or mm]`.
    pub fn around(&self, at: f64) -> [usize; 2] {
        let first = self.parameter[0];
        let at = self
            .closed
            .map_or(at, |length| first + (at - first).rem_euclid(length));
        let next = self.parameter.partition_point(|own| *own < at);
        let last = self.count() - 1;
        if self.closed.is_some() {
            [(next + last) % self.count(), next % self.count()]
        } else {
            let to = next.clamp(1, last.max(1));
            [to - 1, to.min(last)]
        }
    }

    /// From the node `from` ahead to a place.
    fn ahead(&self, from: usize, at: f64) -> f64 {
        let apart = at - self.parameter[from];
        self.closed.map_or(apart, |length| apart.rem_euclid(length))
    }

    /// How far apart the nodes on both sides of a place are; at a node the longer of its two distances `[rad or mm]`.
    pub fn spacing(&self, at: f64) -> f64 {
        let [from, to] = self.around(at);
        let own = self.ahead(from, self.parameter[to]);
        let next = match self.closed {
            Some(_) => (to + 1) % self.count(),
            None => (to + 1).min(self.count() - 1),
        };
        let beyond = self.ahead(to, self.parameter[next]);
        let is_node = self.ahead(from, at) >= own * (1.0 - 1e-9);
        if is_node { own.max(beyond) } else { own }
    }

    /// The largest errors `[MPa]` of nodes no farther from the node `k` than `reach` `[rad or mm]`.
    pub fn largest_near(&self, errors: &[Values], k: usize, reach: f64) -> Values {
        let count = self.count();
        let near = |node: usize| {
            let ahead = self.ahead(k, self.parameter[node % count]).abs();
            let apart = (self.closed).map_or(ahead, |length| ahead.min(length - ahead));
            (apart <= reach).then_some(node % count)
        };
        // An open edge ends at its last node, and on the way back, a period on, at its first.
        let [end, start] = match self.closed {
            Some(_) => [k + count, k + 1],
            None => [count, count],
        };
        let ahead = (k + 1..end).map_while(near);
        let back = (start..k + count).rev().map_while(near);
        ahead.chain(back).fold(errors[k], |largest, node| {
            joined(largest, errors[node], f64::max)
        })
    }

    /// The values `[MPa]` of `rows` at the place `at` `[rad or mm]`.
    pub fn interpolated(&self, rows: &[EdgeRow], at: f64) -> Values {
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

    /// The larger errors `[MPa]` of the nodes on both sides of a `place` of the edge's parameter, of pressure, shear and stress along the edge; `None` where none were estimated.
    pub fn errors_at(&self, errors: &[RowErrors], place: f64) -> Option<[f64; 3]> {
        let [one, other] = Nodes::of(self).around(place).map(|node| {
            let own = errors.get(node)?;
            Some([own.pressure, own.shear, own.sigma_tangential])
        });
        Some(joined(one?, other?, f64::max))
    }
}

/// Pressure, shear and stress along the edge `[MPa]` at a node.
pub fn values(row: &EdgeRow) -> Values {
    [row.pressure, row.shear, row.sigma_tangential]
}

/// Pressures, shears and stresses `[MPa]` joined, each by `join`.
pub fn joined(one: Values, other: Values, join: impl Fn(f64, f64) -> f64) -> Values {
    std::array::from_fn(|k| join(one[k], other[k]))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use stickslip_contact::Status;

    use super::*;

    fn row(value: f64, status: Status) -> EdgeRow {
        EdgeRow {
            pressure: value,
            shear: -value,
            gap: 0.0,
            slip: 0.0,
            status,
            sigma_normal: 0.0,
            sigma_tangential: 2.0 * value,
            tau: 0.0,
        }
    }

    fn open(parameter: &[f64]) -> Nodes {
        Nodes {
            parameter: parameter.to_vec(),
            closed: None,
        }
    }

    /// Exact for cubic polynomials between nodes of one status; linear across a change.
    #[test]
    fn values_between_nodes_are_those_of_a_cubic() {
        let at = [0.0, 0.3, 0.7, 1.2, 1.5, 2.1];
        let cubic = |x: f64| 1.0 - x + 0.5 * x * x * x;
        let rows: Vec<EdgeRow> = (at.iter()).map(|&x| row(cubic(x), Status::Stick)).collect();
        let nodes = open(&at);
        for place in [0.45, 0.7, 1.0, 1.3] {
            let [pressure, shear, stress] = nodes.interpolated(&rows, place);
            assert!((pressure - cubic(place)).abs() < 1e-13);
            assert!((shear + cubic(place)).abs() < 1e-13);
            assert!((stress - 2.0 * cubic(place)).abs() < 1e-13);
        }
        let mut rows = rows;
        rows[3].status = Status::Open;
        let [pressure, ..] = nodes.interpolated(&rows, 0.5);
        assert!((pressure - 0.5 * (cubic(0.3) + cubic(0.7))).abs() < 1e-13);
    }

    #[test]
    fn a_closed_edge_goes_on_across_its_start() {
        let parameter: Vec<f64> = (0..12).map(|k| TAU / 12.0 * f64::from(k)).collect();
        let rows: Vec<EdgeRow> = (parameter.iter())
            .map(|at| row(at.cos(), Status::Open))
            .collect();
        let nodes = Nodes {
            parameter,
            closed: Some(TAU),
        };
        assert_eq!(nodes.around(TAU - 0.1), [11, 0]);
        assert!((nodes.spacing(TAU - 0.1) - TAU / 12.0).abs() < 1e-12);
        let [pressure, ..] = nodes.interpolated(&rows, TAU - 0.1);
        assert!((pressure - 0.1_f64.cos()).abs() < 2e-3, "{pressure}");
        let errors: Vec<Values> = (0..12).map(|k| [f64::from(k); 3]).collect();
        assert_eq!(nodes.largest_near(&errors, 0, 0.6), [11.0; 3]);
        assert_eq!(nodes.largest_near(&errors, 3, 0.6), [4.0; 3]);
    }

    /// The ends of an open edge have neighbours on one side.
    #[test]
    fn an_open_edge_ends() {
        let nodes = open(&[0.0, 1.0, 3.0]);
        assert_eq!(nodes.around(0.0), [0, 1]);
        assert_eq!(nodes.around(3.5), [1, 2]);
        assert!((nodes.spacing(0.0) - 1.0).abs() < 1e-15);
        let errors = [[5.0; 3], [1.0; 3], [2.0; 3]];
        assert_eq!(nodes.largest_near(&errors, 2, 2.0), [2.0; 3]);
        assert_eq!(nodes.largest_near(&errors, 2, 10.0), [5.0; 3]);
        assert_eq!(nodes.largest_near(&errors, 0, 0.5), [5.0; 3]);
    }
}
