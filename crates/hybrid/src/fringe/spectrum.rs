//! Discrete Fourier transforms in two dimensions.

use std::fmt;
use std::sync::Arc;

use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use stickslip_fem_core::parallel;

/// X[m, n] = Σ_{c,r} x[r, c] exp(∓2πi (m c / columns + n r / rows)); pictures row by row, spectra column by column.
pub(super) struct Transform {
    columns: usize,
    rows: usize,
    forward: [Arc<dyn Fft<f64>>; 2],
    inverse: [Arc<dyn Fft<f64>>; 2],
}

impl fmt::Debug for Transform {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Transform")
            .field("columns", &self.columns)
            .field("rows", &self.rows)
            .finish_non_exhaustive()
    }
}

impl Transform {
    pub(super) fn new(columns: usize, rows: usize) -> Self {
        let mut planner = FftPlanner::new();
        let forward = [columns, rows].map(|length| planner.plan_fft_forward(length));
        let inverse = [columns, rows].map(|length| planner.plan_fft_inverse(length));
        Self {
            columns,
            rows,
            forward,
            inverse,
        }
    }

    /// Spectrum of a picture: frequency m of the columns and n of the rows at `m * rows + n`.
    pub(super) fn forward(&self, mut picture: Vec<Complex<f64>>) -> Vec<Complex<f64>> {
        lines(&mut picture, &self.forward[0]);
        let mut spectrum = transposed(&picture, self.columns);
        lines(&mut spectrum, &self.forward[1]);
        spectrum
    }

    /// Picture of a spectrum, scaled so that it undoes [`Transform::forward`].
    pub(super) fn inverse(&self, mut spectrum: Vec<Complex<f64>>) -> Vec<Complex<f64>> {
        lines(&mut spectrum, &self.inverse[1]);
        let mut picture = transposed(&spectrum, self.rows);
        lines(&mut picture, &self.inverse[0]);
        let scale = 1.0 / (self.columns * self.rows) as f64;
        for value in &mut picture {
            *value *= scale;
        }
        picture
    }

    /// Frequencies of an entry of a spectrum, in cycles per pixel between −½ and ½, along columns and rows.
    pub(super) fn frequency(&self, entry: usize) -> [f64; 2] {
        let signed = |index: usize, length: usize| {
            let cycles = if 2 * index > length {
                index as f64 - length as f64
            } else {
                index as f64
            };
            cycles / length as f64
        };
        [
            signed(entry / self.rows, self.columns),
            signed(entry % self.rows, self.rows),
        ]
    }
}

fn lines(values: &mut [Complex<f64>], transform: &Arc<dyn Fft<f64>>) {
    parallel::for_each_chunk(values, transform.len(), |_, line| transform.process(line));
}

/// Rows of `width` entries become columns.
fn transposed(values: &[Complex<f64>], width: usize) -> Vec<Complex<f64>> {
    let height = values.len() / width;
    let mut turned = vec![Complex::default(); values.len()];
    parallel::for_each_chunk(&mut turned, height, |column, line| {
        for (row, entry) in line.iter_mut().enumerate() {
            *entry = values[row * width + column];
        }
    });
    turned
}

/// Smallest length from `least` on that has no prime factors but 2, 3 and 5.
pub(super) fn smooth_length(least: usize) -> usize {
    let smooth = |length: &usize| {
        let mut rest = *length;
        for factor in [2_usize, 3, 5] {
            while rest.is_multiple_of(factor) {
                rest /= factor;
            }
        }
        rest == 1
    };
    let least = least.max(1);
    // There is a power of two up to twice the length.
    (least..=2 * least).find(smooth).unwrap_or(least)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of a sum of 84 terms of size one, in either transform: a few times 84 ε.
    #[test]
    fn agrees_with_the_sum_that_defines_it_and_undoes_itself() {
        let (columns, rows) = (12, 7);
        let picture: Vec<_> = (0..columns * rows)
            .map(|k| Complex::new((1.3 * k as f64).sin(), (0.7 * k as f64 + 0.2).cos()))
            .collect();
        let transform = Transform::new(columns, rows);
        let spectrum = transform.forward(picture.clone());
        for m in 0..columns {
            for n in 0..rows {
                let sum: Complex<f64> = (0..columns * rows)
                    .map(|pixel| {
                        let turns = m as f64 * (pixel % columns) as f64 / columns as f64
                            + n as f64 * (pixel / columns) as f64 / rows as f64;
                        picture[pixel] * Complex::from_polar(1.0, -std::f64::consts::TAU * turns)
                    })
                    .sum();
                assert!((sum - spectrum[m * rows + n]).norm() < 1e-12);
            }
        }
        let back = transform.inverse(spectrum);
        assert!(
            back.iter()
                .zip(&picture)
                .all(|(a, b)| (a - b).norm() < 1e-13)
        );
        assert_eq!(transform.frequency(3 * rows + 5), [0.25, -2.0 / 7.0]);
    }

    #[test]
    fn lengths_without_large_factors() {
        assert_eq!(
            [1, 7, 11, 97, 1001].map(smooth_length),
            [1, 8, 12, 100, 1024]
        );
    }
}
