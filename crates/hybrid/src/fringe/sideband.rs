//! Where the carrier lies in the spectrum of a picture.

use rustfft::num_complex::Complex;

use super::carrier::{Carrier, FourierOptions};
use super::order::wrap;
use super::spectrum::Transform;
use super::{Frame, FringeError, PixelMap};
use crate::order_statistics::median;

/// Least number of fringes across the picture that can be separated from its background.
const LEAST_FRINGES: f64 = 4.0;

/// Probability that white noise alone shows a peak that counts as a carrier.
const FALSE_ALARM: f64 = 1e-6;

/// Part of a band's radius within which it passes everything.
const FLAT: f64 = 0.6;

/// Band of the spectrum that holds the fringes; frequencies in cycles per pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sideband {
    pub(super) centre: [f64; 2],
    pub(super) radius: f64,
    /// Greatest power in the band over that of the noise.
    pub(super) strength: f64,
    /// Part of the power of all fringes that lies in the band, less that of the noise.
    pub(super) share: f64,
}

impl Sideband {
    fn around(centre: [f64; 2], band: f64) -> Self {
        // The spectrum of a sampled picture is periodic; half way to the mirrored sideband lies the background or the Nyquist line.
        let radius = 0.5 * band * wrap(2.0 * centre[0]).hypot(wrap(2.0 * centre[1]));
        Self {
            centre,
            radius,
            strength: 0.0,
            share: 0.0,
        }
    }

    /// Smooth weight of a frequency: 1 around the centre, 0 outside the band.
    pub(super) fn weight(&self, frequency: [f64; 2]) -> f64 {
        rolled(distance(frequency, self.centre) / self.radius)
    }

    /// Weight of everything that a picture of such fringes has: background, band and mirrored band.
    pub(super) fn picture_weight(&self, frequency: [f64; 2]) -> f64 {
        let mirrored = self.weight([-frequency[0], -frequency[1]]);
        self.weight(frequency)
            + mirrored
            + rolled(distance(frequency, [0.0; 2]) / self.background_radius())
    }

    fn background_radius(&self) -> f64 {
        (distance(self.centre, [0.0; 2]) - self.radius).max(0.0)
    }
}

fn rolled(relative: f64) -> f64 {
    if relative <= FLAT {
        1.0
    } else if relative < 1.0 {
        (std::f64::consts::FRAC_PI_2 * (relative - FLAT) / (1.0 - FLAT))
            .cos()
            .powi(2)
    } else {
        0.0
    }
}

/// Mean power of white noise, whose power is exponentially distributed, from the median, which a few frequencies of something else do
/// not move.
pub(super) fn white(power: Vec<f64>) -> f64 {
    median(power).unwrap_or(f64::NAN) / std::f64::consts::LN_2
}

fn distance(first: [f64; 2], second: [f64; 2]) -> f64 {
    wrap(first[0] - second[0]).hypot(wrap(first[1] - second[1]))
}

/// Power of the picture's spectrum, seen through a Hann window.
struct Power {
    transform: Transform,
    values: Vec<f64>,
    /// Mean power of the noise.
    floor: f64,
    /// Power that is rounding.
    rounding: f64,
}

impl Power {
    fn new(picture: &PixelMap) -> Self {
        let frame = picture.frame();
        let hann = |index: usize, length: usize| {
            (std::f64::consts::PI * (index as f64 + 0.5) / length as f64)
                .sin()
                .powi(2)
        };
        let window = |pixel: usize| {
            hann(pixel % frame.columns(), frame.columns())
                * hann(pixel / frame.columns(), frame.rows())
        };
        let (mut weights, mut weighted, mut greatest) = (0.0, 0.0, 0.0_f64);
        for (pixel, value) in picture.present() {
            let weight = window(pixel);
            weights += weight;
            weighted += weight * value;
            greatest = greatest.max(value.abs());
        }
        let mut seen = vec![Complex::default(); frame.pixels()];
        for (pixel, value) in picture.present() {
            seen[pixel].re = window(pixel) * (value - weighted / weights);
        }
        let transform = Transform::new(frame.columns(), frame.rows());
        let values: Vec<_> = transform
            .forward(seen)
            .iter()
            .map(Complex::norm_sqr)
            .collect();
        let floor = white(values.clone());
        Self {
            transform,
            values,
            floor,
            rounding: (1e-12 * weights * greatest).powi(2),
        }
    }

    /// Frequencies on the side of `direction` (in cycles per pixel) that are no background.
    fn candidates(&self, frame: &Frame, direction: [f64; 2]) -> Vec<(usize, [f64; 2])> {
        let beyond = |frequency: [f64; 2]| {
            (frequency[0] * frame.columns() as f64).hypot(frequency[1] * frame.rows() as f64)
                >= LEAST_FRINGES
        };
        let towards =
            |frequency: [f64; 2]| frequency[0] * direction[0] + frequency[1] * direction[1] > 0.0;
        let all = (0..self.values.len()).map(|entry| (entry, self.transform.frequency(entry)));
        all.filter(|&(_, frequency)| beyond(frequency) && towards(frequency))
            .collect()
    }

    /// The frequency of the greatest power.
    fn strongest(&self, candidates: &[(usize, [f64; 2])]) -> Result<[f64; 2], FringeError> {
        let power = |entry: usize| self.values[entry];
        let greatest = candidates
            .iter()
            .max_by(|a, b| power(a.0).total_cmp(&power(b.0)));
        greatest
            .map(|&(_, centre)| centre)
            .ok_or(FringeError::NoCarrier {
                strength: 0.0,
                least: -FALSE_ALARM.ln(),
            })
    }

    /// Power-weighted mean of a band's frequencies; noise has no weight.
    fn centroid(&self, band: &Sideband, candidates: &[(usize, [f64; 2])]) -> [f64; 2] {
        let (mut sum, mut moment) = (0.0, [0.0; 2]);
        for &(entry, frequency) in candidates
            .iter()
            .filter(|(_, frequency)| distance(*frequency, band.centre) < band.radius)
        {
            let weight = (self.values[entry] - 4.0 * self.floor).max(0.0);
            sum += weight;
            moment[0] += weight * (frequency[0] - band.centre[0]);
            moment[1] += weight * (frequency[1] - band.centre[1]);
        }
        if sum > 0.0 {
            [
                band.centre[0] + moment[0] / sum,
                band.centre[1] + moment[1] / sum,
            ]
        } else {
            band.centre
        }
    }

    fn measured(&self, band: &mut Sideband, candidates: &[(usize, [f64; 2])]) {
        let (mut inside, mut all, mut peak) = (0.0, 0.0, 0.0_f64);
        let background = band.background_radius();
        for &(entry, frequency) in candidates {
            let excess = self.values[entry] - self.floor;
            if distance(frequency, band.centre) < band.radius {
                inside += excess;
                peak = peak.max(self.values[entry]);
            }
            if distance(frequency, [0.0; 2]) >= background {
                all += excess;
            }
        }
        band.strength = if peak > self.rounding {
            peak / self.floor
        } else {
            0.0
        };
        band.share = if all > 0.0 {
            (inside / all).clamp(0.0, 1.0)
        } else {
            0.0
        };
    }
}

/// Fringes per pixel of a carrier `[fringes/length]` that the pixels can show.
fn seen(frame: &Frame, gradient: [f64; 2]) -> Result<[f64; 2], FringeError> {
    let step = frame.step();
    let cycles = [gradient[0] * step[0], gradient[1] * step[1]];
    let fringes = (cycles[0] * frame.columns() as f64).hypot(cycles[1] * frame.rows() as f64);
    if cycles.iter().all(|cycles| cycles.abs() < 0.5) && fringes >= LEAST_FRINGES {
        return Ok(cycles);
    }
    Err(FringeError::CarrierRange {
        gradient,
        cycles,
        fringes,
        least: LEAST_FRINGES,
    })
}

/// The band of the carrier that `options` give or ask to find.
pub(super) fn sideband(
    picture: &PixelMap,
    options: &FourierOptions,
) -> Result<Sideband, FringeError> {
    let frame = picture.frame();
    let step = frame.step();
    let spectrum = Power::new(picture);
    let (mut band, candidates) = match options.carrier {
        Carrier::Given(gradient) => {
            let centre = seen(frame, gradient)?;
            let band = Sideband::around(centre, options.band);
            (band, spectrum.candidates(frame, centre))
        }
        Carrier::Found { towards } => {
            let direction = [towards[0] / step[0], towards[1] / step[1]];
            let candidates = spectrum.candidates(frame, direction);
            let first = Sideband::around(spectrum.strongest(&candidates)?, options.band);
            let centre = spectrum.centroid(&first, &candidates);
            (Sideband::around(centre, options.band), candidates)
        }
    };
    spectrum.measured(&mut band, &candidates);
    // The power of white noise at a frequency is exponentially distributed, so n of them exceed x times the mean with probability
    // n exp(−x) at most.
    let least = (candidates.len().max(1) as f64 / FALSE_ALARM).ln();
    if band.strength.is_nan() || band.strength < least {
        return Err(FringeError::NoCarrier {
            strength: band.strength,
            least,
        });
    }
    if band.share < options.least_share {
        return Err(FringeError::Crowded {
            share: band.share,
            least: options.least_share,
        });
    }
    Ok(band)
}
