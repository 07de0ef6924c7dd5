//! Phase of one picture with carrier fringes, by Fourier transform.

use std::f64::consts::TAU;

use rustfft::num_complex::Complex;

use super::carrier::FourierOptions;
use super::sideband::{Sideband, sideband, white};
use super::spectrum::{Transform, smooth_length};
use super::{FringeError, Phase, PixelMap};

/// Phase of one picture, and what its spectrum says.
#[derive(Clone, Debug)]
pub struct FourierPhase {
    /// Orders with the carrier, up to a whole number.
    pub phase: Phase,
    /// Centre of the band `[fringes/length]`: the carrier as given, or carrier and mean displacement gradient as found.
    pub carrier: [f64; 2],
    /// Greatest power in the band over the power of the noise `[1]`.
    pub strength: f64,
    /// Part of the fringes' power that lies in the band `[1]`.
    pub share: f64,
    /// Standard deviation of the pixels' noise, taken as white `[intensity]`.
    pub noise: f64,
    /// Length over which errors of the orders depend on each other `[length]`: half a wave of the band's rim.
    pub resolution: f64,
    /// Passes that filled missing pixels.
    pub passes: usize,
    /// Change of missing pixels in the last pass, over the fringes' amplitude (root mean square) `[1]`.
    pub change: f64,
}

impl FourierPhase {
    /// Standard deviation of an order `[fringes]` that the noise of the picture causes, at the median amplitude of the fringes.
    pub fn deviation(&self) -> f64 {
        self.phase
            .deviation(self.noise, self.phase.median_modulation())
    }
}

/// Phase of a picture I = a + b cos 2πN, N = f u + k·x, whose background a and amplitude b vary slowly (Takeda, Ina & Kobayashi
/// 1982; in two dimensions Bone, Bachor & Sandeman 1986): the transform of the picture, times a band H around the carrier, is that of c below.
///
/// ```text
/// c = F⁻¹ H F I ≈ (b/2) exp 2πiN,     N = arg c / 2π,     |k + f ∂u/∂x − k_c| < β |k_c|
/// ```
///
/// Missing pixels and a margin around the picture are first filled with what the band and the background have to say about them
/// (Gerchberg 1974, Papoulis 1975), so that neither edges nor holes ring.
///
/// # Errors
///
/// Options out of range; a carrier that the pixels cannot show; no carrier, or fringes that turn back and leave its band.
pub fn fourier(picture: &PixelMap, options: &FourierOptions) -> Result<FourierPhase, FringeError> {
    options.check()?;
    let band = sideband(picture, options)?;
    let mut filled = Filled::new(picture, &band);
    let (mut passes, mut change) = (0, f64::INFINITY);
    while passes < options.passes && change > options.settled {
        change = filled.pass();
        passes += 1;
    }
    let Demodulated {
        fringes,
        energy,
        noise,
    } = filled.demodulated(&band);
    let frame = *picture.frame();
    let mut valid = picture.valid().to_vec();
    let (mut orders, mut modulation) = (vec![f64::NAN; frame.pixels()], vec![0.0; frame.pixels()]);
    for (pixel, _) in picture.present() {
        let value = fringes[filled.entry(pixel)];
        modulation[pixel] = 2.0 * value.norm();
        orders[pixel] = value.arg() / TAU;
        valid[pixel] = modulation[pixel] > 0.0;
    }
    // White noise of variance σ² leaves the variance σ² ΣH²/n in c, half of it across (b/2) exp 2πiN.
    let phase = Phase::new(
        PixelMap::new(frame, orders, valid)?,
        modulation,
        (2.0 * energy).sqrt() / TAU,
    );
    let step = frame.step();
    Ok(FourierPhase {
        phase,
        carrier: [band.centre[0] / step[0], band.centre[1] / step[1]],
        strength: band.strength,
        share: band.share,
        noise,
        resolution: 0.5 / band.radius * step[0].abs().max(step[1].abs()),
        passes,
        change: if passes > 0 { change } else { 0.0 },
    })
}

/// A picture with margin in which missing pixels are filled.
#[derive(Debug)]
struct Filled {
    transform: Transform,
    width: usize,
    columns: usize,
    values: Vec<Complex<f64>>,
    missing: Vec<usize>,
    weights: Vec<f64>,
    amplitude: f64,
}

impl Filled {
    fn new(picture: &PixelMap, band: &Sideband) -> Self {
        let frame = picture.frame();
        // The picture repeats itself beyond the margin, which therefore serves opposite edges at once. Next to the Nyquist frequency
        // bands are narrow without end.
        let margin = (2.0 / band.radius).ceil() as usize;
        let [width, height] = [frame.columns(), frame.rows()]
            .map(|length| smooth_length(length + margin.min(length)));
        let count = picture.present().count() as f64;
        let mean = picture.present().map(|(_, value)| value).sum::<f64>() / count;
        let variance = picture
            .present()
            .map(|(_, value)| (value - mean).powi(2))
            .sum::<f64>()
            / count;
        let transform = Transform::new(width, height);
        let weights = (0..width * height)
            .map(|entry| band.picture_weight(transform.frequency(entry)))
            .collect();
        let amplitude = (2.0 * variance).sqrt();
        let values = vec![Complex::default(); width * height];
        let mut filled = Self {
            transform,
            width,
            columns: frame.columns(),
            values,
            missing: Vec::new(),
            weights,
            amplitude,
        };
        let mut known = vec![false; width * height];
        for (pixel, value) in picture.present() {
            let entry = filled.entry(pixel);
            filled.values[entry].re = value - mean;
            known[entry] = true;
        }
        filled.missing = (0..known.len()).filter(|&entry| !known[entry]).collect();
        filled
    }

    fn entry(&self, pixel: usize) -> usize {
        pixel / self.columns * self.width + pixel % self.columns
    }

    /// One pass of filling; returns the change over the fringes' amplitude (root mean square).
    fn pass(&mut self) -> f64 {
        let mut spectrum = self.transform.forward(self.values.clone());
        spectrum
            .iter_mut()
            .zip(&self.weights)
            .for_each(|(value, weight)| *value *= *weight);
        let limited = self.transform.inverse(spectrum);
        let mut squares = 0.0;
        for &entry in &self.missing {
            squares += (limited[entry].re - self.values[entry].re).powi(2);
            self.values[entry].re = limited[entry].re;
        }
        let mean = squares / self.missing.len().max(1) as f64;
        if mean > 0.0 {
            mean.sqrt() / self.amplitude
        } else {
            0.0
        }
    }

    fn demodulated(&self, band: &Sideband) -> Demodulated {
        let mut spectrum = self.transform.forward(self.values.clone());
        let empty = spectrum
            .iter()
            .zip(&self.weights)
            .filter(|&(_, &weight)| weight == 0.0);
        let outside: Vec<_> = empty.map(|(value, _)| value.norm_sqr()).collect();
        let known = (spectrum.len() - self.missing.len()) as f64;
        let noise = if outside.is_empty() {
            0.0
        } else {
            (white(outside) / known).sqrt()
        };
        let mut energy = 0.0;
        for (entry, value) in spectrum.iter_mut().enumerate() {
            let weight = band.weight(self.transform.frequency(entry));
            energy += weight * weight;
            *value *= weight;
        }
        energy /= spectrum.len() as f64;
        Demodulated {
            fringes: self.transform.inverse(spectrum),
            energy,
            noise,
        }
    }
}

/// The fringes' complex amplitude c at all pixels, ΣH²/n, and the noise that the frequencies without background and fringes show:
/// filled pixels have none there.
struct Demodulated {
    fringes: Vec<Complex<f64>>,
    energy: f64,
    noise: f64,
}
