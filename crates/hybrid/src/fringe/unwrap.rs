//! Orders without jumps, from orders up to a whole number.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::order::wrap;
use super::{Frame, FringeError, PixelMap};

/// Pixels that hang together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    /// Pixel of best quality, whose order is the wrapped one.
    pub seed: usize,
    /// Number of pixels.
    pub pixels: usize,
}

/// A loop of four neighbouring pixels around which wrapped differences do not add up to zero: unwrapping across it depends on the
/// path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Residue {
    /// Pixel of the loop with the smallest column and row.
    pub pixel: usize,
    /// Sum of the differences: column + 1, then row + 1, and back `[fringes]`.
    pub charge: i8,
}

/// Orders without jumps, and where they are not to be trusted.
#[derive(Clone, Debug)]
pub struct Unwrapped {
    /// Orders, each region up to a constant of its own.
    pub orders: PixelMap,
    /// Regions, the one with the best pixel first.
    pub regions: Vec<Region>,
    /// Region of each pixel.
    pub region_of: Vec<Option<u32>>,
    /// Inconsistent loops.
    pub residues: Vec<Residue>,
    /// Neighbouring pixels that differ by half a fringe or more. If there are none, no path through the pixels gives other orders,
    /// not even around a hole.
    pub cuts: Vec<[usize; 2]>,
}

/// A pixel that can be reached; the best of all goes first, among equals the one that comes first in the picture.
#[derive(PartialEq)]
struct Front {
    quality: f64,
    pixel: usize,
    from: usize,
}

impl Eq for Front {}

impl Ord for Front {
    fn cmp(&self, other: &Self) -> Ordering {
        let later = |front: &Self| (front.pixel, front.from);
        self.quality
            .total_cmp(&other.quality)
            .then_with(|| later(other).cmp(&later(self)))
    }
}

impl PartialOrd for Front {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Orders `[fringes]` without jumps: the flood starts at the best pixel of a region and goes on at the best pixel that it touches, adding whole
/// numbers so that neighbours differ by at most ½ (quality-guided path following, Ghiglia & Pritt 1998, chapter 4). `quality` has one
/// number per pixel, greater where the phase is better.
///
/// # Errors
///
/// Qualities of another number than pixels, or not finite where an order is there.
pub fn unwrap(wrapped: &PixelMap, quality: &[f64]) -> Result<Unwrapped, FringeError> {
    let frame = *wrapped.frame();
    if quality.len() != frame.pixels() {
        return Err(frame.unlike(quality.len()));
    }
    if let Some((pixel, _)) = wrapped
        .present()
        .find(|&(pixel, _)| !quality[pixel].is_finite())
    {
        return Err(frame.not_finite(pixel, quality[pixel]));
    }
    let mut seeds: Vec<_> = wrapped.present().map(|(pixel, _)| pixel).collect();
    seeds.sort_by(|&a, &b| quality[b].total_cmp(&quality[a]).then(a.cmp(&b)));
    let mut flood = Flood {
        wrapped,
        quality,
        whole: vec![0.0; frame.pixels()],
        region_of: vec![None; frame.pixels()],
    };
    let mut regions = Vec::new();
    for seed in seeds {
        if flood.region_of[seed].is_none() {
            let pixels = flood.run(seed, regions.len() as u32);
            regions.push(Region { seed, pixels });
        }
    }
    let Flood {
        whole, region_of, ..
    } = flood;
    let orders = wrapped.mapped(|pixel, order| order + whole[pixel])?;
    let residues = residues(wrapped);
    let cuts = cuts(wrapped, &whole);
    Ok(Unwrapped {
        orders,
        regions,
        region_of,
        residues,
        cuts,
    })
}

struct Flood<'a> {
    wrapped: &'a PixelMap,
    quality: &'a [f64],
    whole: Vec<f64>,
    region_of: Vec<Option<u32>>,
}

impl Flood<'_> {
    /// Floods a region from its seed; returns its number of pixels.
    fn run(&mut self, seed: usize, region: u32) -> usize {
        let mut front = BinaryHeap::from([Front {
            quality: self.quality[seed],
            pixel: seed,
            from: seed,
        }]);
        let mut pixels = 0;
        while let Some(Front { pixel, from, .. }) = front.pop() {
            if self.region_of[pixel].is_some() {
                continue;
            }
            self.region_of[pixel] = Some(region);
            self.whole[pixel] = self.whole[from] + jump(self.wrapped, from, pixel);
            pixels += 1;
            for next in neighbours(self.wrapped.frame(), pixel) {
                if self.wrapped.valid()[next] && self.region_of[next].is_none() {
                    front.push(Front {
                        quality: self.quality[next],
                        pixel: next,
                        from: pixel,
                    });
                }
            }
        }
        pixels
    }
}

/// Whole number that brings the order of `to` nearest to that of `from`.
fn jump(wrapped: &PixelMap, from: usize, to: usize) -> f64 {
    (wrapped.values()[from] - wrapped.values()[to]).round()
}

fn neighbours(frame: &Frame, pixel: usize) -> impl Iterator<Item = usize> {
    let (columns, pixels) = (frame.columns(), frame.pixels());
    let column = pixel % columns;
    let left = (column > 0).then(|| pixel - 1);
    let right = (column + 1 < columns).then_some(pixel + 1);
    let above = pixel.checked_sub(columns);
    let below = Some(pixel + columns).filter(|&next| next < pixels);
    [left, right, above, below].into_iter().flatten()
}

fn residues(wrapped: &PixelMap) -> Vec<Residue> {
    let (frame, values, valid) = (wrapped.frame(), wrapped.values(), wrapped.valid());
    let columns = frame.columns();
    let inner = wrapped.present().map(|(pixel, _)| pixel);
    let inner =
        inner.filter(|pixel| pixel % columns + 1 < columns && pixel / columns + 1 < frame.rows());
    let charged = inner.filter_map(|pixel| {
        let corners = [pixel, pixel + 1, pixel + columns + 1, pixel + columns];
        let whole = corners.iter().all(|&corner| valid[corner]);
        let sum: f64 = (0..4)
            .map(|k| wrap(values[corners[(k + 1) % 4]] - values[corners[k]]))
            .sum();
        (whole && sum.round() != 0.0).then(|| Residue {
            pixel,
            charge: sum.round() as i8,
        })
    });
    charged.collect()
}

/// Neighbours whose whole numbers do not differ as their wrapped orders ask.
fn cuts(wrapped: &PixelMap, whole: &[f64]) -> Vec<[usize; 2]> {
    let frame = wrapped.frame();
    let pairs = wrapped
        .present()
        .flat_map(|(pixel, _)| neighbours(frame, pixel).map(move |next| [pixel, next]));
    let once = pairs.filter(|&[pixel, next]| next > pixel && wrapped.valid()[next]);
    once.filter(|&[pixel, next]| whole[next] - whole[pixel] != jump(wrapped, pixel, next))
        .collect()
}
