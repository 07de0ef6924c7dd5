//! How often statements of one kind hold, beside what they promise.
//!
//! ```text
//! P(X ≤ k) = Σ for i ≤ k of C(n, i) pⁱ (1 − p)ⁿ⁻ⁱ;     interval of p: where neither tail beyond k is below 2.5 % (Clopper & Pearson 1934)
//! ```

use crate::torture::trial::Tally;

/// A kind that falls short of its promise with less than this probability by chance fails.
pub(super) const LEVEL: f64 = 0.01;

/// Probability of at most `held` of `stated` where each holds with probability `p`.
pub(super) fn at_most(held: u64, stated: u64, p: f64) -> f64 {
    if p >= 1.0 {
        return if held < stated { 0.0 } else { 1.0 };
    }
    let odds = (p / (1.0 - p)).ln();
    let mut log = stated as f64 * (1.0 - p).ln();
    let mut sum = log.exp();
    for i in 0..held.min(stated) {
        log += ((stated - i) as f64 / (i + 1) as f64).ln() + odds;
        sum += log.exp();
    }
    sum.min(1.0)
}

/// The interval of 95 % of the probability with which statements hold.
pub(super) fn interval(held: u64, stated: u64) -> [f64; 2] {
    const TAIL: f64 = 0.025;
    let solved = |at: &dyn Fn(f64) -> bool| {
        let [mut low, mut high] = [0.0, 1.0];
        for _ in 0..50 {
            let middle = f64::midpoint(low, high);
            if at(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        f64::midpoint(low, high)
    };
    let low = match held {
        0 => 0.0,
        _ => solved(&|p| 1.0 - at_most(held - 1, stated, p) < TAIL),
    };
    let high = if held == stated {
        1.0
    } else {
        solved(&|p| at_most(held, stated, p) > TAIL)
    };
    [low, high]
}

/// Statements of a kind that were made, and those that hold.
pub(super) fn counts(tally: Tally) -> [u64; 2] {
    [tally.held + tally.failed, tally.held]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tails_and_intervals_are_those_of_tables() {
        // Of 10 tosses at most 2 heads: 56 of 1024.
        assert!((at_most(2, 10, 0.5) - 56.0 / 1024.0).abs() < 1e-12);
        // Clopper & Pearson's interval of 0 of 10 ends at 1 − 0.025^(1/10).
        let [low, high] = interval(0, 10);
        assert!(low.abs() < 1e-12 && (high - (1.0 - 0.025_f64.powf(0.1))).abs() < 1e-9);
        let [low, high] = interval(10, 10);
        assert!((low - 0.025_f64.powf(0.1)).abs() < 1e-9 && (high - 1.0).abs() < 1e-12);
    }
}
