//! Shear over pressure along the hole of a whole plate.

use super::WholeSolution;

/// A ratio is clear where the pressure is this many standard deviations, and this part of its largest.
const DEVIATIONS: f64 = 4.0;
const PART: f64 = 0.05;

impl WholeSolution {
    /// Standard deviation of the pressure (`0`) or the shear (`1`) at place `k` `[MPa]`.
    pub fn deviation(&self, which: usize, k: usize) -> f64 {
        self.tractions.deviation(which, k)
    }

    /// Angle `[rad]`, shear over pressure `[1]` and its standard deviation `[1]` of each place that bears a clear pressure.
    pub fn ratios(&self) -> Vec<(f64, f64, f64)> {
        let own = &self.tractions;
        let largest = own.pressure.iter().copied().fold(0.0, f64::max);
        (0..self.angle.len())
            .filter_map(|k| {
                let (p, deviation) = (own.pressure[k], self.deviation(0, k));
                let clear = p > DEVIATIONS * deviation && p > PART * largest;
                let (ratio, spread) = own.ratio(k);
                clear.then_some((self.angle[k], ratio, spread))
            })
            .collect()
    }
}
