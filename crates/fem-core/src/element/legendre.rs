//! Rules of Gauss and Lobatto on [−1, 1], found when the crate is compiled.
//!
//! ```text
//! Gauss, n points:    P_n(x) = 0,                    w = 2 / [(1 − x²) P_n'(x)²]         exact to degree 2n − 1
//! Lobatto, n points:  x = ±1 or P_{n−1}'(x) = 0,     w = 2 / [n (n − 1) P_{n−1}(x)²]     exact to degree 2n − 3
//! ```
//!
//! Source: Abramowitz and Stegun (1964), 25.4.29 and 25.4.32.

/// Abscissa and weight of each point, ascending.
pub(super) type Rule<const N: usize> = [(f64, f64); N];

/// Most points of a rule: roots are searched in steps that hold one at most up to here.
const MOST: usize = 11;

/// Pₙ (`value[0]`) and Pₙ' (`value[1]`) at `x`: k Pₖ = (2k − 1) x Pₖ₋₁ − (k − 1) Pₖ₋₂ and Pₖ' = Pₖ₋₂' + (2k − 1) Pₖ₋₁.
const fn legendre(n: usize, x: f64) -> [f64; 2] {
    let (mut before, mut value) = ([1.0, 0.0], [x, 1.0]);
    if n == 0 {
        return before;
    }
    let mut k = 2;
    while k <= n {
        let (degree, odd) = (k as f64, (2 * k - 1) as f64);
        let next = [
            (odd * x * value[0] - (degree - 1.0) * before[0]) / degree,
            before[1] + odd * value[0],
        ];
        before = value;
        value = next;
        k += 1;
    }
    value
}

/// The roots above 0 of Pₙ (`part` 0) or Pₙ' (`part` 1), ascending; zeros after them.
const fn positive_roots(n: usize, part: usize) -> [f64; MOST] {
    const STEPS: usize = 64;
    assert!(n <= MOST);
    let mut roots = [0.0; MOST];
    let (mut found, mut step) = (0, 1);
    let mut low = 0.5 / STEPS as f64;
    while step < STEPS {
        let high = (step as f64 + 0.5) / STEPS as f64;
        let rising = legendre(n, high)[part] > 0.0;
        if (legendre(n, low)[part] > 0.0) != rising {
            roots[found] = bisected(n, part, low, high);
            found += 1;
        }
        low = high;
        step += 1;
    }
    roots
}

/// The root between `low` and `high`, to the last bit but that of the function's rounding.
const fn bisected(n: usize, part: usize, mut low: f64, mut high: f64) -> f64 {
    let rising = legendre(n, high)[part] > 0.0;
    let mut halvings = 0;
    while halvings < 53 {
        let middle = 0.5 * (low + high);
        if (legendre(n, middle)[part] > 0.0) == rising {
            high = middle;
        } else {
            low = middle;
        }
        halvings += 1;
    }
    0.5 * (low + high)
}

/// Number `index` of `count` values that are odd about the middle, of which `positive` are the ones above 0.
const fn mirrored(positive: &[f64; MOST], count: usize, index: usize) -> f64 {
    let half = count / 2;
    if index < half {
        -positive[half - 1 - index]
    } else if 2 * index + 1 == count {
        0.0
    } else {
        positive[index + half - count]
    }
}

/// The rule of Gauss with `N` points.
pub(super) const fn gauss<const N: usize>() -> Rule<N> {
    let positive = positive_roots(N, 0);
    let mut rule = [(0.0, 0.0); N];
    let mut k = 0;
    while k < N {
        let x = mirrored(&positive, N, k);
        let slope = legendre(N, x)[1];
        rule[k] = (x, 2.0 / ((1.0 - x * x) * slope * slope));
        k += 1;
    }
    rule
}

/// The rule of Lobatto with `N` ≥ 2 points: the ends are two of them.
pub(super) const fn lobatto<const N: usize>() -> Rule<N> {
    let inner = positive_roots(N - 1, 1);
    let mut rule = [(0.0, 0.0); N];
    let mut k = 0;
    while k < N {
        let x = if k == 0 {
            -1.0
        } else if k == N - 1 {
            1.0
        } else {
            mirrored(&inner, N - 2, k - 1)
        };
        let value = legendre(N - 1, x)[0];
        rule[k] = (x, 2.0 / ((N * (N - 1)) as f64 * value * value));
        k += 1;
    }
    rule
}

#[cfg(test)]
mod tests {
    use super::{gauss, lobatto};

    /// Abramowitz and Stegun, tables 25.4 and 25.6.
    #[test]
    fn rules_agree_with_the_tables() {
        let close = |(x, w): (f64, f64), at: f64, weight: f64| {
            assert!(
                (x - at).abs() < 2e-15 && (w - weight).abs() < 1e-14,
                "{x}, {w}"
            );
        };
        close(gauss::<2>()[1], 0.577_350_269_189_625_8, 1.0);
        close(gauss::<5>()[2], 0.0, 0.568_888_888_888_888_9);
        close(
            gauss::<10>()[9],
            0.973_906_528_517_171_7,
            0.066_671_344_308_688_14,
        );
        close(lobatto::<2>()[0], -1.0, 1.0);
        close(lobatto::<3>()[1], 0.0, 4.0 / 3.0);
        close(lobatto::<4>()[2], 0.447_213_595_499_957_9, 5.0 / 6.0);
        close(
            lobatto::<9>()[7],
            0.899_757_995_411_460_2,
            0.165_495_361_560_805_5,
        );
    }

    #[test]
    fn rules_are_exact_to_their_degree() {
        fn check<const N: usize>(rule: [(f64, f64); N], degree: usize) {
            for power in 0..=degree {
                let exact = if power % 2 == 0 {
                    2.0 / (power + 1) as f64
                } else {
                    0.0
                };
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(power as i32)).sum();
                // N terms of magnitude 2 at most, each with a few roundings.
                assert!(
                    (sum - exact).abs() < 8.0 * N as f64 * f64::EPSILON,
                    "{N}: x^{power}"
                );
            }
        }
        check(gauss::<3>(), 5);
        check(gauss::<8>(), 15);
        check(gauss::<11>(), 21);
        check(lobatto::<5>(), 7);
        check(lobatto::<9>(), 15);
    }
}
