//! Random histories.

use serde_json::Value;

use super::Draft;
use crate::torture::scenes::draw::digits;
use crate::torture::scenes::quantity::text;

impl Draft {
    /// Values of a load over the steps, the largest being `most`: growing, growing and going back, reversing, or anything.
    pub(super) fn history(&mut self, most: f64, unit: &str) -> Value {
        let kind = self
            .draw
            .weighted(&[(0.3, 0), (0.3, 1), (0.2, 2), (0.2, 3)]);
        let steps = self.steps;
        let values = (0..steps).map(|step| {
            let done = (step + 1) as f64 / steps as f64;
            match kind {
                0 => done,
                1 => (1.0 - (2.0 * done - 1.2).abs()).clamp(0.05, 1.0),
                2 if step % 2 == 1 => -self.draw.between(0.1, 1.0),
                2 => self.draw.between(0.3, 1.0),
                _ => self.draw.between(-0.3, 1.0),
            }
        });
        scaled(&values.collect::<Vec<f64>>(), most, unit)
    }

    /// The same, but never below nothing.
    pub(super) fn one_sided(&mut self, most: f64, unit: &str) -> Value {
        let shares = (0..self.steps).map(|_| self.draw.between(0.1, 1.0));
        scaled(&shares.collect::<Vec<f64>>(), most, unit)
    }

    /// Changes of temperature.
    pub(super) fn heat(&mut self) -> Value {
        let most = self.draw.between(10.0, 120.0).round();
        let sign = if self.draw.chance(0.5) { 1.0 } else { -1.0 };
        self.history(sign * most, "K")
    }

    /// A direction: mostly along −x, as pulled plates have it.
    pub(super) fn direction(&mut self) -> [f64; 2] {
        let turn = self.draw.between(-180.0, 180.0).to_radians();
        let any = [digits(turn.cos(), 4), digits(turn.sin(), 4)];
        self.draw.weighted(&[
            (0.55, [-1.0, 0.0]),
            (0.06, [1.0, 0.0]),
            (0.08, [0.0, 1.0]),
            (0.06, [0.0, -1.0]),
            (0.25, any),
        ])
    }
}

/// Parts of the largest value.
fn scaled(shares: &[f64], most: f64, unit: &str) -> Value {
    let steps = shares
        .iter()
        .map(|share| text(digits(most * share, 4), unit));
    Value::Array(steps.collect())
}
