//! Phase of fringes, and four-step phase shifting.

use std::f64::consts::TAU;

use super::check::not_negative;
use super::order::wrap;
use super::{FringeError, PixelMap, Plane, Unwrapped, unwrap};
use crate::order_statistics::median;

/// Fringe orders up to a whole number, with the amplitude of the fringes that they come from.
#[derive(Clone, Debug)]
pub struct Phase {
    wrapped: PixelMap,
    modulation: Vec<f64>,
    noise_gain: f64,
}

impl Phase {
    pub(super) fn new(wrapped: PixelMap, modulation: Vec<f64>, noise_gain: f64) -> Self {
        Self {
            wrapped,
            modulation,
            noise_gain,
        }
    }

    /// Orders up to a whole number, in −½ … ½.
    pub fn wrapped(&self) -> &PixelMap {
        &self.wrapped
    }

    /// Amplitude b of the fringes at each pixel `[intensity]`, which is the phase's quality; 0 where it is missing.
    pub fn modulation(&self) -> &[f64] {
        &self.modulation
    }

    /// Standard deviation of an order `[fringes]` for additive noise, independent from pixel to pixel, of standard deviation
    /// `noise` where the fringes have the amplitude `modulation` (same unit). First order in their ratio.
    pub fn deviation(&self, noise: f64, modulation: f64) -> f64 {
        self.noise_gain * noise / modulation
    }

    /// Median amplitude of the fringes `[intensity]`.
    pub fn median_modulation(&self) -> f64 {
        let present = self.wrapped.present();
        let amplitudes = present.map(|(pixel, _)| self.modulation[pixel]);
        median(amplitudes.collect()).unwrap_or(f64::NAN)
    }

    /// The phase without the pixels whose fringes have at most the amplitude `least` `[intensity]`.
    ///
    /// # Errors
    ///
    /// No pixel is left.
    pub fn above(&self, least: f64) -> Result<Self, FringeError> {
        let frame = *self.wrapped.frame();
        let valid: Vec<_> = self
            .wrapped
            .valid()
            .iter()
            .zip(&self.modulation)
            .map(|(&valid, &b)| valid && b > least)
            .collect();
        if !valid.contains(&true) {
            return Err(FringeError::Modulation {
                greatest: self.modulation.iter().copied().fold(0.0, f64::max),
                least,
            });
        }
        let modulation = self
            .modulation
            .iter()
            .zip(&valid)
            .map(|(&b, &valid)| if valid { b } else { 0.0 })
            .collect();
        Ok(Self {
            wrapped: PixelMap::new(frame, self.wrapped.values().to_vec(), valid)?,
            modulation,
            ..*self
        })
    }

    /// Phase of N − carrier: flatter, so that noise disturbs its unwrapping less.
    ///
    /// # Errors
    ///
    /// A carrier that is not finite.
    pub fn demodulated(&self, carrier: &Plane) -> Result<Self, FringeError> {
        let frame = *self.wrapped.frame();
        let wrapped = self
            .wrapped
            .mapped(|pixel, order| wrap(order - carrier.at(frame.place(pixel))))?;
        Ok(Self {
            wrapped,
            modulation: self.modulation.clone(),
            noise_gain: self.noise_gain,
        })
    }

    /// Orders without jumps, see [`unwrap`], by the modulation as quality.
    ///
    /// # Errors
    ///
    /// As [`unwrap`].
    pub fn unwrapped(&self) -> Result<Unwrapped, FringeError> {
        unwrap(&self.wrapped, &self.modulation)
    }
}

/// Phase of four pictures I_k = a + b cos 2π(N + k/4), k = 0 … 3 (Creath 1988):
///
/// ```text
/// 2πN = arg [(I₀ − I₂) + i (I₃ − I₁)],   2b = |(I₀ − I₂) + i (I₃ − I₁)|
/// ```
///
/// Pixels that one picture lacks, or whose amplitude b is at most `least_modulation` `[intensity]`, are missing.
///
/// # Errors
///
/// Pictures of unlike frames; a `least_modulation` below 0; fringes at no pixel.
pub fn four_step(pictures: &[PixelMap; 4], least_modulation: f64) -> Result<Phase, FringeError> {
    not_negative("least modulation", least_modulation)?;
    for other in &pictures[1..] {
        pictures[0].same_frame(other)?;
    }
    let pixels = pictures[0].frame().pixels();
    let (mut orders, mut modulation, mut valid) = (
        vec![f64::NAN; pixels],
        vec![0.0; pixels],
        vec![false; pixels],
    );
    let mut greatest = 0.0_f64;
    for pixel in 0..pixels {
        let [Some(i0), Some(i1), Some(i2), Some(i3)] =
            pictures.each_ref().map(|picture| picture.get(pixel))
        else {
            continue;
        };
        let amplitude = 0.5 * (i0 - i2).hypot(i3 - i1);
        greatest = greatest.max(amplitude);
        if amplitude > least_modulation {
            orders[pixel] = wrap((i3 - i1).atan2(i0 - i2) / TAU);
            modulation[pixel] = amplitude;
            valid[pixel] = true;
        }
    }
    if !valid.contains(&true) {
        return Err(FringeError::Modulation {
            greatest,
            least: least_modulation,
        });
    }
    // Either difference of two pictures has the variance 2σ², so the direction of their vector of length 2b has σ²/2b².
    Ok(Phase::new(
        PixelMap::new(*pictures[0].frame(), orders, valid)?,
        modulation,
        std::f64::consts::FRAC_1_SQRT_2 / TAU,
    ))
}
