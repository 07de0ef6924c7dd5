//! Pressure that stands for a pin.
//!
//! ```text
//! cosine    p(a) = 4P/(π D t) cos a        uniform   p(a) = P/(D t),        |a| < 90°,
//! ```
//!
//! at the angle a from the direction of the force P on a hole of diameter D in a plate of thickness t; ∫ p cos a (D/2) t da = P.

use std::f64::consts::{FRAC_PI_2, PI};

use serde::{Deserialize, Serialize};

/// Where a pressure ends, to rounding `[rad]`.
const END: f64 = 1e-9;

/// How an assumed bearing pressure is spread over half of a hole.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BearingLaw {
    /// With the cosine of the angle from the force.
    Cosine,
    /// Evenly; with a step at both ends.
    Uniform,
}

impl BearingLaw {
    /// Pressure over P/(D t) `[1]` at `angle` `[rad]` from the direction of the force; at the end of the uniform one half of it, the mean
    /// of both sides.
    pub fn pressure(self, angle: f64) -> f64 {
        let turned = (angle + PI).rem_euclid(2.0 * PI) - PI;
        let beyond = turned.abs() - FRAC_PI_2;
        match self {
            Self::Cosine if beyond < 0.0 => 4.0 / PI * turned.cos(),
            Self::Uniform if beyond.abs() < END => 0.5,
            Self::Uniform if beyond < 0.0 => 1.0,
            Self::Cosine | Self::Uniform => 0.0,
        }
    }

    /// Name in scenes.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Cosine => "cosine",
            Self::Uniform => "uniform",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_resultant_is_the_force() {
        const POINTS: u32 = 100_000;
        let step = 2.0 * PI / f64::from(POINTS);
        for law in [BearingLaw::Cosine, BearingLaw::Uniform] {
            let along: f64 = (0..POINTS)
                .map(|k| (f64::from(k) + 0.5) * step - PI)
                .map(|angle| 0.5 * law.pressure(angle) * angle.cos() * step)
                .sum();
            // The midpoint rule with its nodes symmetric about the kinks: error of second order.
            assert!((along - 1.0).abs() < 1e-8, "{law:?}: {along}");
        }
    }

    #[test]
    fn the_peak_and_the_ends_are_known() {
        assert_eq!(BearingLaw::Cosine.pressure(0.0), 4.0 / PI);
        assert_eq!(BearingLaw::Cosine.pressure(2.0), 0.0);
        assert_eq!(BearingLaw::Cosine.pressure(-2.0 * PI), 4.0 / PI);
        assert_eq!(BearingLaw::Uniform.pressure(FRAC_PI_2), 0.5);
        assert_eq!(BearingLaw::Uniform.pressure(-1.5), 1.0);
        assert_eq!(BearingLaw::Uniform.pressure(PI), 0.0);
    }
}
