//! Integrals of the kernels over pairs of elements.

use std::f64::consts::PI;

use nalgebra::DMatrix;

use super::{log_kernel, remainder};
use crate::gauss::Rules;
use crate::nodes::{Element, Nodes};

/// A logarithmic kernel.
pub(crate) trait LogKernel {
    /// L(x).
    fn log(x: f64) -> f64;
    /// L(x) + ln|x|; `None` where that is zero.
    const REMAINDER: Option<fn(f64) -> f64>;
    /// Elements that are closer touch.
    const TOUCHING: f64;
}

/// L = −ln |2 sin x/2|.
pub(crate) struct OnCircle;
/// L = −ln |x|.
pub(crate) struct OnLine;

impl LogKernel for OnCircle {
    fn log(x: f64) -> f64 {
        log_kernel(x)
    }
    const REMAINDER: Option<fn(f64) -> f64> = Some(remainder);
    const TOUCHING: f64 = TOUCHING;
}

impl LogKernel for OnLine {
    fn log(x: f64) -> f64 {
        -x.abs().ln()
    }
    const REMAINDER: Option<fn(f64) -> f64> = None;
    const TOUCHING: f64 = f64::MIN_POSITIVE;
}

/// A distance of elements below this one `[rad]` is rounding, of angles up to two turns.
const TOUCHING: f64 = 1e-13;

/// Means for any spacings, from integrals over pairs of elements.
pub(super) fn any(nodes: &Nodes) -> [DMatrix<f64>; 2] {
    let (knots, elements) = (nodes.knots(), nodes.elements());
    let count = knots.len();
    let rules = Rules::new();
    let [mut log, mut odd] = [(); 2].map(|()| DMatrix::zeros(count, count));
    let mirrored = mirror(nodes);
    for (i, e) in elements.iter().enumerate() {
        for (j, f) in elements.iter().enumerate().skip(i) {
            // The mirror image of a pair has the same L and the opposite S.
            let mut image = [mirrored[i], mirrored[j]];
            image.sort_unstable();
            if image < [i, j] {
                continue;
            }
            let (logs, odds) = pair(&rules, e, f);
            let mut add = |row: usize, column: usize, [a, b]: [usize; 2], sign: f64| {
                log[(row, column)] += logs[a][b];
                odd[(row, column)] += sign * odds[a][b];
            };
            for ends in [[0, 0], [0, 1], [1, 0], [1, 1]] {
                let [row, column] = [e.knots[ends[0]], f.knots[ends[1]]];
                let across = [row, column].map(|knot| knots[knot].image);
                add(row, column, ends, 1.0);
                if i != j {
                    add(column, row, ends, -1.0);
                }
                if image != [i, j] {
                    add(across[0], across[1], ends, -1.0);
                    if i != j {
                        add(across[1], across[0], ends, 1.0);
                    }
                }
            }
        }
    }
    for matrix in [&mut log, &mut odd] {
        for (column, knot) in knots.iter().enumerate() {
            for row in 0..count {
                matrix[(row, column)] /= knots[row].weight * knot.weight;
            }
        }
    }
    [log, odd].map(|matrix| matrix.rows(0, nodes.len()).into_owned())
}

/// The mirror image of each element, itself without symmetry.
fn mirror(nodes: &Nodes) -> Vec<usize> {
    let (knots, elements) = (nodes.knots(), nodes.elements());
    let mut of_ends: Vec<([usize; 2], usize)> = elements
        .iter()
        .enumerate()
        .map(|(k, element)| (element.knots, k))
        .collect();
    of_ends.sort_unstable();
    let image = |(k, element): (usize, &Element)| {
        let [a, b] = element.knots.map(|knot| knots[knot].image);
        let found = of_ends.binary_search_by_key(&[b, a], |(ends, _)| *ends);
        if nodes.is_mirrored() {
            found.map_or(k, |at| of_ends[at].1)
        } else {
            k
        }
    };
    elements.iter().enumerate().map(image).collect()
}

/// Integrals over an element by the knots of its ends, and over another by those of its own.
pub(crate) type Block = [[f64; 2]; 2];

/// ∬ of L and of S over θ in `e` and φ in `f`.
fn pair(rules: &Rules, e: &Element, f: &Element) -> (Block, Block) {
    let (h, k) = (e.length, f.length);
    if e == f {
        return (
            log_of_one::<OnCircle>(rules, h),
            [
                [0.0, -h * h / 12.0 * PI + h * h * h / 24.0],
                [h * h / 12.0 * PI - h * h * h / 24.0, 0.0],
            ],
        );
    }
    // Distance from the end of the earlier to the start of the later, the shorter way around.
    let turn = 2.0 * PI;
    let after = (e.start - f.start - k).rem_euclid(turn);
    let before = (f.start - e.start - h).rem_euclid(turn);
    let [after, before] = [after, before].map(|gap| if turn - gap < TOUCHING { 0.0 } else { gap });
    let centre = [1.0 / 3.0, 2.0 / 3.0];
    // Differences of the mean places of two half hats, on 0 to a turn.
    let forward = after + k;
    let odd = |a: usize, b: usize| 0.125 * h * k * (PI - (forward + centre[a] * h - centre[b] * k));
    let odds = [[odd(0, 0), odd(0, 1)], [odd(1, 0), odd(1, 1)]];
    let logs = if after <= before {
        let [[nn, nf], [fnear, ff]] = apart::<OnCircle>(rules, h, k, after);
        // The near end of the later is its first, that of the earlier its second.
        [[nf, nn], [ff, fnear]]
    } else {
        let [[nn, nf], [fnear, ff]] = apart::<OnCircle>(rules, h, k, before);
        [[fnear, ff], [nn, nf]]
    };
    (logs, odds)
}

/// Over one element of length `h` twice: ∬ −ln|x − y| of the half hats on a unit length is 7/16 for equal ones and 5/16 for the two.
pub(crate) fn log_of_one<K: LogKernel>(rules: &Rules, h: f64) -> Block {
    let (equal, other) = (7.0 / 16.0 - 0.25 * h.ln(), 5.0 / 16.0 - 0.25 * h.ln());
    let mut block = [
        [equal * h * h, other * h * h],
        [other * h * h, equal * h * h],
    ];
    if let Some(remainder) = K::REMAINDER {
        gauss(rules.longest(), h, h, |u, v| remainder(u - v), &mut block);
    }
    block
}

/// Over two elements of lengths `h` and `k` at the distance `gap`, 0 where they touch, by their near and far ends: ∬ L(gap + u + v) du dv, u and v from the near
/// ends.
pub(crate) fn apart<K: LogKernel>(rules: &Rules, h: f64, k: f64, gap: f64) -> Block {
    let longer = h.max(k);
    if gap >= longer {
        let mut block = Block::default();
        let rule = rules.at(gap / longer);
        gauss(rule, h, k, |u, v| K::log(gap + u + v), &mut block);
        block
    } else if gap < K::TOUCHING {
        let mut block = touching(rules, h, k);
        if let Some(remainder) = K::REMAINDER {
            gauss(rules.longest(), h, k, |u, v| remainder(u + v), &mut block);
        }
        block
    } else if h >= k {
        let near = apart::<K>(rules, 0.5 * h, k, gap);
        let far = apart::<K>(rules, 0.5 * h, k, gap + 0.5 * h);
        halves(near, far)
    } else {
        let near = apart::<K>(rules, h, 0.5 * k, gap);
        let far = apart::<K>(rules, h, 0.5 * k, gap + 0.5 * k);
        transposed(halves(transposed(near), transposed(far)))
    }
}

/// The integrals over an element from those over its near and its far half.
fn halves(near: Block, far: Block) -> Block {
    let mut whole = Block::default();
    for b in 0..2 {
        let middle = near[1][b] + far[0][b];
        whole[0][b] = near[0][b] + 0.5 * middle;
        whole[1][b] = far[1][b] + 0.5 * middle;
    }
    whole
}

fn transposed([[a, b], [c, d]]: Block) -> Block {
    [[a, c], [b, d]]
}

/// Adds ∬ N_a(u) N_b(v) f(u, v) over 0 ≤ u ≤ h, 0 ≤ v ≤ k.
fn gauss(rule: &[[f64; 2]], h: f64, k: f64, f: impl Fn(f64, f64) -> f64, block: &mut Block) {
    for [x, weight_x] in rule {
        let mut sums = [0.0; 2];
        for [y, weight_y] in rule {
            let value = weight_y * f(x * h, y * k);
            sums[0] += (1.0 - y) * value;
            sums[1] += y * value;
        }
        for (b, sum) in sums.into_iter().enumerate() {
            let value = weight_x * h * k * sum;
            block[0][b] += (1.0 - x) * value;
            block[1][b] += x * value;
        }
    }
}

/// ∬ −ln(u + v) over two elements that touch, by Duffy's substitution: u = hs, v = kst and u = hst, v = ks.
///
/// ```text
/// ∬ (u/h)^a (v/k)^b ln(u + v) du dv = hk [c_ab + (G_b(h, k) + G_a(k, h)) / (a + b + 2)]
/// c_ab = −(1/(a + 1) + 1/(b + 1)) / (a + b + 2)²,    G_b(h, k) = ∫ t^b ln(h + kt) dt on 0 to 1
/// ```
fn touching(rules: &Rules, h: f64, k: f64) -> Block {
    let moment = |a: usize, b: usize| {
        let order = (a + b + 2) as f64;
        let parts = 1.0 / (a as f64 + 1.0) + 1.0 / (b as f64 + 1.0);
        let logs = log_moment(rules, b, h, k) + log_moment(rules, a, k, h);
        -h * k * (logs / order - parts / (order * order))
    };
    let [m00, m01, m10, m11] = [moment(0, 0), moment(0, 1), moment(1, 0), moment(1, 1)];
    [[m00 - m01 - m10 + m11, m01 - m11], [m10 - m11, m11]]
}

/// G_b(h, k) = ∫ t^b ln(h + kt) dt on 0 to 1, b = 0 or 1.
fn log_moment(rules: &Rules, b: usize, h: f64, k: f64) -> f64 {
    let a = h / k;
    if a > 1.0 {
        let rest: f64 = (rules.longest().iter())
            .map(|[t, w]| w * t.powi(b as i32) * (t / a).ln_1p())
            .sum();
        h.ln() / (b as f64 + 1.0) + rest
    } else if b == 0 {
        k.ln() + (1.0 + a) * a.ln_1p() - a * a.ln() - 1.0
    } else {
        let square = a * a;
        0.5 * (k.ln() + (1.0 - square) * a.ln_1p() + square * a.ln() - 0.5 + a)
    }
}
