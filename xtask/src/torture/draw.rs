//! Random numbers from one seed.

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};

/// A source of random choices.
pub(super) struct Draw(StdRng);

impl Draw {
    /// The source of `seed`, whose choices for different `purpose`s do not depend on each other.
    pub(super) fn new(seed: u64, purpose: u64) -> Self {
        Self::seeded(seed ^ purpose.wrapping_mul(0x9E37_79B9_7F4A_7C15))
    }

    /// The source of `seed` alone.
    pub(super) fn seeded(seed: u64) -> Self {
        Self(StdRng::seed_from_u64(seed))
    }

    /// A whole number below `end`.
    pub(super) fn below(&mut self, end: usize) -> usize {
        self.0.random_range(0..end.max(1))
    }

    /// Whether something of this probability happens.
    pub(super) fn chance(&mut self, probability: f64) -> bool {
        self.0.random_range(0.0..1.0) < probability
    }

    /// A whole number from `low` to `high`, both included.
    pub(super) fn whole(&mut self, low: usize, high: usize) -> usize {
        self.0.random_range(low..=high)
    }

    /// A number between `low` and `high`, of four digits.
    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        digits(self.0.random_range(low..high), 4)
    }

    /// A number between `low` and `high` whose logarithm is evenly spread, of four digits.
    pub(super) fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        digits(self.0.random_range(low.ln()..high.ln()).exp(), 4)
    }

    /// One of `choices`, which are not empty.
    pub(super) fn pick<'a, T: ?Sized>(&mut self, choices: &[&'a T]) -> &'a T {
        choices[self.whole(0, choices.len() - 1)]
    }

    /// One of `choices` with their weights.
    pub(super) fn weighted<T: Copy>(&mut self, choices: &[(f64, T)]) -> T {
        let sum: f64 = choices.iter().map(|(weight, _)| weight).sum();
        let mut left = self.0.random_range(0.0..sum);
        for (weight, choice) in choices {
            left -= weight;
            if left < 0.0 {
                return *choice;
            }
        }
        choices[choices.len() - 1].1
    }
}

/// `value` rounded to `count` significant digits.
pub(super) fn digits(value: f64, count: i32) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    // By way of the text, so that the number is the one that a scene would spell.
    format!("{value:.*e}", usize::try_from(count - 1).unwrap_or(0))
        .parse()
        .unwrap_or(value)
}
