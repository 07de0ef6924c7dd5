//! Nodes on a straight edge, and the hats on them.
//!
//! As on a circle ([`Nodes`](crate::Nodes)): q(x) = Σ q_i N_i(x), w_i = ∫ N_i dx, and the displacement of a node is the mean ⟨u⟩_i over its hat. Hats at the ends
//! are half ones.
//!
//! ```text
//! L_ij = (1/(w_i w_j)) ∬ −ln|x − ξ| N_i N_j,     S_ij = (1/(w_i w_j)) ∬ (π/2) sign(x − ξ) N_i N_j
//! ```

use std::f64::consts::PI;

use nalgebra::DMatrix;

use crate::error::SeriesError;
use crate::gauss::{Rules, rule};
use crate::kernel::pairs::{OnLine, apart, log_of_one};

/// Nodes on a straight edge along x, in the order of their places.
///
/// ```
/// use stickslip_series::LineNodes;
///
/// let half = LineNodes::mirrored(vec![0.0, 0.1, 0.3])?;
/// // Half of a hat stands on the axis, another ends the edge.
/// assert!((half.weights()[0] - 0.05).abs() < 1e-15);
/// assert!((half.weights()[2] - 0.1).abs() < 1e-15);
/// # Ok::<(), stickslip_series::SeriesError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LineNodes {
    places: Vec<f64>,
    mirrored: bool,
    /// Places of the whole edge, ascending.
    knots: Vec<f64>,
}

impl LineNodes {
    /// Nodes of a whole edge at strictly increasing places x `[length]`.
    ///
    /// # Errors
    /// [`SeriesError::Place`] for places that do not increase or are not finite, [`SeriesError::Count`] for fewer than two.
    pub fn whole(places: Vec<f64>) -> Result<Self, SeriesError> {
        check(&places)?;
        Ok(Self {
            knots: places.clone(),
            places,
            mirrored: false,
        })
    }

    /// The half x ≥ 0 of an edge of a body and of loads that mirror each other in the y axis, at strictly increasing places `[length]`, the first of which is
    /// 0. Forces are those on the half, as in a half model of finite elements. The node at 0 moves along y only.
    ///
    /// # Errors
    /// As [`LineNodes::whole`], and [`SeriesError::Place`] for another first place.
    pub fn mirrored(places: Vec<f64>) -> Result<Self, SeriesError> {
        check(&places)?;
        if places[0] != 0.0 {
            let place = places[0];
            return Err(SeriesError::Place { node: 0, place });
        }
        let images = places.iter().skip(1).rev();
        let knots = images.map(|place| -place).chain(places.iter().copied());
        Ok(Self {
            knots: knots.collect(),
            places,
            mirrored: true,
        })
    }

    /// Places x `[length]`.
    pub fn places(&self) -> &[f64] {
        &self.places
    }

    /// Number of nodes n.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// Whether there is no node; never.
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// Whether the nodes are one half of an edge that mirrors itself in the y axis.
    pub fn is_mirrored(&self) -> bool {
        self.mirrored
    }

    /// Whether the node stands on the axis of symmetry, where it moves along y only.
    pub(crate) fn on_axis(&self, node: usize) -> bool {
        self.mirrored && node == 0
    }

    /// Weights w_i = ∫ N_i dx `[length]`, n; in a half model over the half. The area that node i stands for is t w_i.
    pub fn weights(&self) -> Vec<f64> {
        let whole = self.knot_weights();
        let weight = |node: usize| {
            let own = whole[self.knot(node)];
            if self.on_axis(node) { 0.5 * own } else { own }
        };
        (0..self.len()).map(weight).collect()
    }

    /// Mean ⟨f⟩_i of the function `f` of the place `[length]` over each hat, n, in the unit of `f`; in a half model over the half of the hat on the axis. Exact for polynomials of degree 14 on each side of a node.
    pub fn mean(&self, f: impl Fn(f64) -> f64) -> Vec<f64> {
        let points = rule(8);
        let [mut sums, mut weights] = [(); 2].map(|()| vec![0.0; self.len()]);
        for (first, ends) in self.places.windows(2).enumerate() {
            let length = ends[1] - ends[0];
            for [x, w] in &points {
                let value = f(ends[0] + x * length);
                for (node, hat) in [(first, 1.0 - x), (first + 1, *x)] {
                    sums[node] += w * length * hat * value;
                    weights[node] += w * length * hat;
                }
            }
        }
        for (sum, weight) in sums.iter_mut().zip(weights) {
            *sum /= weight;
        }
        sums
    }

    /// Places of the whole edge.
    pub(crate) fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The number of a node among the places of the whole edge.
    pub(crate) fn knot(&self, node: usize) -> usize {
        self.knots.len() - self.places.len() + node
    }

    /// That of its mirror image; its own where it has none.
    pub(crate) fn image(&self, node: usize) -> usize {
        if self.mirrored {
            self.places.len() - 1 - node
        } else {
            self.knot(node)
        }
    }

    /// w of every place of the whole edge.
    pub(crate) fn knot_weights(&self) -> Vec<f64> {
        let mut weights = vec![0.0; self.knots.len()];
        for (first, ends) in self.knots.windows(2).enumerate() {
            let half = 0.5 * (ends[1] - ends[0]);
            weights[first] += half;
            weights[first + 1] += half;
        }
        weights
    }

    /// L_ij and S_ij of all places i and j of the whole edge.
    pub(crate) fn means(&self) -> [DMatrix<f64>; 2] {
        let (knots, rules) = (&self.knots, Rules::new());
        let count = knots.len();
        let lengths: Vec<f64> = knots.windows(2).map(|ends| ends[1] - ends[0]).collect();
        let [mut log, mut odd] = [(); 2].map(|()| DMatrix::zeros(count, count));
        for (i, &h) in lengths.iter().enumerate() {
            for (a, row) in log_of_one::<OnLine>(&rules, h).into_iter().enumerate() {
                for (b, value) in row.into_iter().enumerate() {
                    log[(i + a, i + b)] += value;
                }
            }
            // ∬ (π/2) sign(x − ξ) of the two half hats.
            odd[(i + 1, i)] += PI * h * h / 12.0;
            odd[(i, i + 1)] -= PI * h * h / 12.0;
            for (j, &k) in lengths.iter().enumerate().skip(i + 1) {
                let gap = if j == i + 1 {
                    0.0
                } else {
                    knots[j] - knots[i + 1]
                };
                // The near end of the earlier is its second.
                let block = apart::<OnLine>(&rules, h, k, gap);
                let sign = 0.125 * PI * h * k;
                for (near, row) in block.into_iter().enumerate() {
                    for (far, value) in row.into_iter().enumerate() {
                        let [earlier, later] = [i + 1 - near, j + far];
                        log[(earlier, later)] += value;
                        log[(later, earlier)] += value;
                        odd[(later, earlier)] += sign;
                        odd[(earlier, later)] -= sign;
                    }
                }
            }
        }
        let weights = self.knot_weights();
        for matrix in [&mut log, &mut odd] {
            for (column, weight) in weights.iter().enumerate() {
                for (row, other) in weights.iter().enumerate() {
                    matrix[(row, column)] /= weight * other;
                }
            }
        }
        [log, odd]
    }
}

fn check(places: &[f64]) -> Result<(), SeriesError> {
    if places.len() < 2 {
        let count = places.len();
        return Err(SeriesError::Count { count });
    }
    let wrong = |node: &usize| {
        let before = node.checked_sub(1).map(|before| places[before]);
        !places[*node].is_finite() || before.is_some_and(|before| before >= places[*node])
    };
    match (0..places.len()).find(wrong) {
        Some(node) => Err(SeriesError::Place {
            node,
            place: places[node],
        }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hat of coarse nodes is a sum of hats on a finer grid, whose pairs of elements are others.
    #[test]
    fn means_agree_with_those_of_a_refinement() {
        let coarse = vec![-3.0, -0.4, -0.399, -0.3985, 0.0, 0.01, 0.3, 2.0, 40.0];
        let mut fine = Vec::new();
        for ends in coarse.windows(2) {
            fine.extend([ends[0], ends[0] + 0.37 * (ends[1] - ends[0])]);
        }
        fine.push(40.0);
        let [coarse, fine] = [coarse, fine].map(|places| LineNodes::whole(places).unwrap());
        let [means, finer] = [&coarse, &fine].map(LineNodes::means);
        let [weights, finer_weights] = [&coarse, &fine].map(LineNodes::knot_weights);
        let parts = |i: usize| {
            let around = [
                (2 * i).checked_sub(1).map(|k| (k, 0.37)),
                Some((2 * i, 1.0)),
                Some((2 * i + 1, 0.63)),
            ];
            let all = around.into_iter().flatten();
            all.filter(|(k, _)| *k < finer_weights.len())
                .collect::<Vec<_>>()
        };
        for kernel in 0..2 {
            for i in 0..coarse.len() {
                for j in 0..coarse.len() {
                    let mut sum = 0.0;
                    for (a, part) in parts(i) {
                        for (b, other) in parts(j) {
                            let both = part * other * finer_weights[a] * finer_weights[b];
                            sum += both * finer[kernel][(a, b)];
                        }
                    }
                    let (found, value) = (sum / (weights[i] * weights[j]), means[kernel][(i, j)]);
                    let error = (found - value).abs() / value.abs().max(0.1);
                    assert!(error < 2e-12, "{kernel} {i} {j} {value} {error:e}");
                }
            }
        }
    }

    #[test]
    fn places_that_no_hats_stand_on_are_refused() {
        let error = LineNodes::whole(vec![0.0, 0.0]).unwrap_err();
        let second = SeriesError::Place {
            node: 1,
            place: 0.0,
        };
        assert_eq!(error, second);
        assert!(error.to_string().starts_with("node 2 stands at 0: "));
        let error = LineNodes::mirrored(vec![-1.0, 0.0]).unwrap_err();
        let first = SeriesError::Place {
            node: 0,
            place: -1.0,
        };
        assert_eq!(error, first);
        assert!(LineNodes::whole(vec![0.0, f64::NAN]).is_err());
        assert!(LineNodes::whole(vec![0.0]).is_err());
    }
}
