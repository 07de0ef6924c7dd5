//! How much the errors of data exceed what their standard deviations say, in the mean over neighbours.

use std::collections::{BTreeMap, BTreeSet};

use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_hybrid::calibrate::{self, Correlation};
use stickslip_hybrid::data::Measurement;
use stickslip_hybrid::region::locate::Locator;

use crate::ends::span;

/// Data in a block, about: three by three.
pub(crate) const IN_A_BLOCK: f64 = 9.0;

/// A residual over its stated standard deviation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Residual {
    pub(crate) place: Point,
    pub(crate) axis: usize,
    pub(crate) value: f64,
}

/// Measured less calculated displacements over the stated standard deviations, of all valid data in `mesh`, whose nodes have the
/// `displacements` `[mm]`.
pub(crate) fn residuals(mesh: &Mesh, data: &Measurement, displacements: &[f64]) -> Vec<Residual> {
    let locator = Locator::new(mesh);
    let mut residuals = Vec::new();
    for (k, &place) in data.places.iter().enumerate() {
        let Some(located) = locator.locate(place) else {
            continue;
        };
        for axis in (0..2).filter(|&axis| data.valid[axis][k]) {
            let calculated = located.displacement(axis, displacements);
            residuals.push(Residual {
                place,
                axis,
                value: (data.displacements[axis][k] - calculated) / data.deviation[axis],
            });
        }
    }
    residuals
}

/// By what correlated errors must exceed those of blocks to count: their own scatter is about a third.
const BEYOND_BLOCKS: f64 = 1.5;

/// How much the variance of means of neighbouring `residuals` exceeds that of independent data with their standard deviations, by a fit
/// with `parameters`; 1 where there are too few data to say.
///
/// Independent errors give 1. Errors that are correlated over less than a block of data give, by the means of blocks, the factor by which
/// they count in everything smoother. Where the fit leaves blocks too few degrees of freedom, or errors are correlated farther than a block
/// reaches, the sum of their covariances gives it.
pub(crate) fn scale(residuals: &[Residual], parameters: f64) -> f64 {
    let summed = by_covariances(residuals, parameters);
    match by_blocks(residuals, parameters) {
        Some(blocks) if summed <= BEYOND_BLOCKS * blocks => blocks,
        _ => summed,
    }
}

/// The sum of the covariances of neighbouring residuals, as large as their own variance at least.
fn by_covariances(residuals: &[Residual], parameters: f64) -> f64 {
    let count = residuals.len() as f64;
    let squares: f64 = residuals.iter().map(|own| own.value.powi(2)).sum();
    if squares <= 0.0 || count <= parameters {
        return 1.0;
    }
    let size = (squares / count).sqrt();
    let relative = residuals.iter().map(|own| calibrate::Residual {
        place: own.place,
        field: own.axis,
        value: own.value / size,
    });
    let inflation = Correlation::of(&relative.collect::<Vec<_>>()).inflation;
    squares / (count - parameters) * inflation
}

/// χ² of the block means of `residuals` over its degrees of freedom; none where these are less than half of the blocks.
fn by_blocks(residuals: &[Residual], parameters: f64) -> Option<f64> {
    let mut squares = 0.0;
    let mut blocks = 0.0;
    for axis in 0..2 {
        let own: Vec<&Residual> = residuals.iter().filter(|one| one.axis == axis).collect();
        let Some(size) = block_size(&own) else {
            continue;
        };
        let mut sums: BTreeMap<[i64; 2], [f64; 2]> = BTreeMap::new();
        for one in own {
            let key = one.place.map(|x| (x / size).floor() as i64);
            let [sum, count] = sums.entry(key).or_insert([0.0; 2]);
            *sum += one.value;
            *count += 1.0;
        }
        squares += sums
            .values()
            .map(|[sum, count]| sum * sum / count)
            .sum::<f64>();
        blocks += sums.len() as f64;
    }
    let degrees = blocks - parameters;
    (degrees > 0.5 * blocks).then(|| squares / degrees)
}

/// The scale at which errors have the standard deviations `floor`, where `deviation` are those that residuals were divided by.
pub(crate) fn least_scale(deviation: [f64; 2], floor: [f64; 2]) -> f64 {
    let parts = floor.into_iter().zip(deviation);
    let squares = parts.map(|(least, deviation)| (least / deviation).powi(2));
    squares.fold(0.0, f64::max)
}

/// Edge of a square that holds as many data as a block should.
fn block_size(residuals: &[&Residual]) -> Option<f64> {
    let mut area = 0.0;
    let mut cells = BTreeSet::new();
    let extent = |axis: usize| span(residuals.iter().map(|one| one.place[axis]));
    // The area that data cover, from a coarse grid: a sector fills its box only in part.
    let grid = extent(0).max(extent(1)) / 60.0;
    if grid > 0.0 && grid.is_finite() {
        for one in residuals {
            cells.insert(one.place.map(|x| (x / grid).floor() as i64));
        }
        area = cells.len() as f64 * grid * grid;
    }
    (area > 0.0).then(|| (area * IN_A_BLOCK / residuals.len() as f64).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A number between −√3 and √3, uniform: standard deviation 1.
    fn noise(k: usize) -> f64 {
        let bits = (k as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let bits = (bits ^ (bits >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let part = ((bits ^ (bits >> 32)) >> 11) as f64 / (1_u64 << 53) as f64;
        (2.0 * part - 1.0) * 3.0_f64.sqrt()
    }

    fn field(side: usize, value: impl Fn(usize, usize) -> f64) -> Vec<Residual> {
        let all = (0..side * side).map(|k| (k % side, k / side));
        all.map(|(i, j)| Residual {
            place: [i as f64, j as f64],
            axis: 0,
            value: value(i, j),
        })
        .collect()
    }

    #[test]
    fn independent_errors_have_the_scale_one() {
        let found = scale(&field(120, |i, j| noise(121 * i + j)), 0.0);
        // About 1600 blocks: √(2/1600), to three standard deviations.
        assert!((found - 1.0).abs() < 0.11, "{found}");
    }

    #[test]
    fn the_least_scale_is_that_of_the_component_that_needs_it_most() {
        assert_eq!(least_scale([2.0, 4.0], [1.0, 4.0]), 1.0);
        assert_eq!(least_scale([2.0, 4.0], [0.0, 1.0]), 0.0625);
        assert_eq!(least_scale([1e-4; 2], [0.0; 2]), 0.0);
    }

    #[test]
    fn errors_that_go_together_count_in_full() {
        // Each error serves two by two data, so that their means have four times the variance of independent ones, less at blocks'
        // rims.
        let found = scale(&field(120, |i, j| noise(61 * (i / 2) + j / 2)), 0.0);
        assert!((2.2..4.2).contains(&found), "{found}");
    }

    #[test]
    fn errors_that_go_together_beyond_blocks_count_in_full() {
        // Means over five by five neighbours: 25 times the variance in everything smoother, of which blocks of nine see about eight.
        let mean = |i: usize, j: usize| {
            let near = (0..25).map(|k| noise(131 * (i + k / 5) + j + k % 5));
            near.sum::<f64>() / 5.0
        };
        let field = field(120, mean);
        let blocks = by_blocks(&field, 0.0).unwrap();
        let found = scale(&field, 0.0);
        assert!(
            blocks < 10.0 && (16.0..34.0).contains(&found),
            "{blocks} {found}"
        );
        // With as many parameters as blocks the residuals still say so.
        assert!(by_blocks(&field, 1500.0).is_none());
        assert!(scale(&field, 1500.0) > 16.0);
    }
}
