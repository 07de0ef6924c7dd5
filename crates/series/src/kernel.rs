//! Double means of the two kernels of a circle over hats.
//!
//! ```text
//! L(x) = Σ cos kx / k = −ln |2 sin x/2|,     S(x) = Σ sin kx / k = (π − x)/2 on 0 < x < 2π
//! L_ij = (1/(w_i w_j)) ∬ N_i(θ) N_j(φ) L(θ − φ) dθ dφ,   S_ij likewise
//! ```
//!
//! S is linear, so its means are closed forms. L is split into −ln|x| and a smooth remainder where hats touch; the logarithm is integrated in closed
//! form in coordinates that are scaled by the lengths of the elements, which keeps all digits where a spacing of 1e-4 stands beside one of
//! 0.05. Elements apart are integrated by Gauss's rule, and cut in half where they are longer than their distance.

pub(crate) mod pairs;

use std::f64::consts::PI;

use nalgebra::DMatrix;

use crate::gauss::Rules;
use crate::nodes::Nodes;
use pairs::any;

/// L_ij and S_ij of nodes i and knots j.
#[derive(Clone, Debug)]
pub(crate) enum Means {
    /// By the difference j − i, modulo the number of knots: L, even, and S, odd.
    Even(Vec<[f64; 2]>),
    /// By node and knot.
    Any([DMatrix<f64>; 2]),
}

impl Means {
    pub(crate) fn new(nodes: &Nodes) -> Self {
        match nodes.step() {
            Some(step) => Self::Even(even(step, nodes.knots().len())),
            None => Self::Any(any(nodes)),
        }
    }

    /// L and S of node `node` under a traction at knot `knot`.
    pub(crate) fn at(&self, node: usize, knot: usize) -> [f64; 2] {
        match self {
            Self::Even(by_difference) => {
                let count = by_difference.len();
                by_difference[(node + count - knot) % count]
            }
            Self::Any([log, odd]) => [log[(node, knot)], odd[(node, knot)]],
        }
    }
}

/// Means for equal spacings: the product of two hats is the cubic B-spline of the difference.
fn even(step: f64, count: usize) -> Vec<[f64; 2]> {
    let rules = Rules::new();
    let mut means = vec![[0.0; 2]; count];
    for difference in 0..=count / 2 {
        let at = difference as f64;
        let log = if difference < 3 {
            let remainder = |s: f64| remainder(step * (at + s));
            -step.ln() - spline_of_log(at) + spline_mean(rules.longest(), remainder)
        } else {
            spline_mean(rules.at(at - 2.0), |s| log_kernel(step * (at + s)))
        };
        // Mean of sign(d + s) under the spline.
        let sign = [0.0, 11.0 / 12.0, 1.0][difference.min(2)];
        let odd = 0.5 * (PI * sign - step * at);
        means[difference] = [log, odd];
        if difference > 0 {
            means[count - difference] = [log, -odd];
        }
    }
    if count.is_multiple_of(2) {
        means[count / 2][1] = 0.0;
    }
    means
}

/// Mean of ln|d + s| under the cubic B-spline B(s): δ⁴[x⁴ ln|x|/24] − 25/12 at x = d.
fn spline_of_log(at: f64) -> f64 {
    let antiderivative = |x: f64| {
        if x == 0.0 {
            0.0
        } else {
            x.powi(4) * x.abs().ln() / 24.0
        }
    };
    let sum: f64 = [
        (0.0, 6.0),
        (1.0, -4.0),
        (-1.0, -4.0),
        (2.0, 1.0),
        (-2.0, 1.0),
    ]
    .iter()
    .map(|(shift, factor)| factor * antiderivative(at + shift))
    .sum();
    sum - 25.0 / 12.0
}

/// Mean of `f` under the cubic B-spline on −2 to 2.
fn spline_mean(rule: &[[f64; 2]], f: impl Fn(f64) -> f64) -> f64 {
    let mut sum = 0.0;
    for [x, w] in rule {
        let outer = x * x * x / 6.0;
        let inner = 2.0 / 3.0 - 0.5 * (1.0 - x) * (1.0 - x) * (1.0 + x);
        sum += w * outer * (f(x - 2.0) + f(2.0 - x));
        sum += w * inner * (f(x - 1.0) + f(1.0 - x));
    }
    sum
}

fn log_kernel(x: f64) -> f64 {
    -(2.0 * (0.5 * x).sin().abs()).ln()
}

/// L(x) + ln|x|, smooth within a turn.
fn remainder(x: f64) -> f64 {
    let half = 0.5 * x;
    if half.abs() < 1e-3 {
        let square = half * half;
        square * (1.0 / 6.0 + square / 180.0)
    } else {
        -(half.sin() / half).ln()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Σ cos and sin kx / k with the means of hats, by modes up to an order from which on the rest is estimated by its bound.
    fn by_modes(nodes: &Nodes, node: usize, knot: usize, orders: i64) -> [f64; 2] {
        let mut sums = [0.0; 2];
        let turned = |k: usize| nodes.knots()[k].node;
        for order in 1..=orders {
            let means = nodes.mode_means(order);
            let mut other = means[turned(knot)];
            if turned(knot) != knot {
                other = other.conj();
            }
            let product = means[node] * other.conj() / order as f64;
            sums[0] += product.re;
            sums[1] += product.im;
        }
        sums
    }

    #[test]
    fn even_means_are_sums_of_modes() {
        let nodes = Nodes::uniform_half(13).unwrap();
        let means = Means::new(&nodes);
        for node in [0, 1, 5, 12] {
            for knot in 0..24 {
                // The rest of the sum is below Σ_{k > n} (2/kh)⁴/k = 4/(h n)⁴: 2e-11.
                let [log, odd] = by_modes(&nodes, node, knot, 3000);
                let found = means.at(node, knot);
                assert!(
                    (found[0] - log).abs() < 3e-11,
                    "{node} {knot} {:e}",
                    found[0] - log
                );
                assert!((found[1] - odd).abs() < 3e-11, "{node} {knot}");
            }
        }
    }

    #[test]
    fn both_ways_to_the_means_agree() {
        for nodes in [
            Nodes::uniform_half(31).unwrap(),
            Nodes::uniform_circle(24).unwrap(),
        ] {
            let even = Means::new(&nodes);
            let any = Means::Any(any(&nodes));
            for node in 0..nodes.len() {
                for knot in 0..nodes.knots().len() {
                    let (a, b) = (even.at(node, knot), any.at(node, knot));
                    assert!((a[0] - b[0]).abs() < 2e-13, "{node} {knot} {a:?} {b:?}");
                    assert!((a[1] - b[1]).abs() < 2e-13, "{node} {knot} {a:?} {b:?}");
                }
            }
        }
    }

    /// A graded hat is a sum of hats on a finer grid, so means on both must agree; the finer grid has other pairs of elements.
    #[test]
    fn graded_means_agree_with_those_of_a_refinement() {
        let coarse: Vec<f64> = vec![
            0.0, 0.3, 0.35, 0.3501, 0.3502, 0.3503, 0.4, 0.45, 0.46, 0.9, 1.4, 2.0,
        ];
        let mut fine = Vec::new();
        for ends in coarse.windows(2) {
            fine.extend([ends[0], ends[0] + 0.37 * (ends[1] - ends[0])]);
        }
        fine.push(2.0);
        let [coarse, fine] = [coarse, fine].map(|angles| Nodes::arc(angles).unwrap());
        let [means, finer] = [&coarse, &fine].map(Means::new);
        // Hat i of the coarse nodes in terms of hats of the fine ones: itself and parts of its two neighbours.
        let parts = |i: usize| {
            let mut parts = vec![(2 * i, 1.0)];
            if i > 0 {
                parts.push((2 * i - 1, 0.37));
            }
            if 2 * i + 1 < fine.len() {
                parts.push((2 * i + 1, 0.63));
            }
            parts
        };
        let weight = |nodes: &Nodes, i: usize| nodes.knots()[i].weight;
        for i in 0..coarse.len() {
            for j in 0..coarse.len() {
                let mut sums = [0.0; 2];
                for (a, part_a) in parts(i) {
                    for (b, part_b) in parts(j) {
                        let factor = part_a * part_b * weight(&fine, a) * weight(&fine, b);
                        for (sum, value) in sums.iter_mut().zip(finer.at(a, b)) {
                            *sum += factor * value;
                        }
                    }
                }
                let product = weight(&coarse, i) * weight(&coarse, j);
                for (sum, value) in sums.iter().zip(means.at(i, j)) {
                    let error = sum / product - value;
                    assert!(
                        error.abs() < 2e-12 * value.abs().max(0.1),
                        "{i} {j} {value} {error:e}"
                    );
                }
            }
        }
    }
}
