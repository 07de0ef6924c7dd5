//! At most 256 colours for a picture, so that a pixel of its PNG is one byte.
//!
//! Figures have few colours and the blends on their edges. The palette grows colour by colour, each time by the one with the
//! largest
//!
//! ```text
//! pixels of the colour · squared distance to its nearest colour in the palette
//! ```
//!
//! so grounds, lines and text keep their colours, and a picture of at most 256 colours is exact as a whole.

use std::collections::HashMap;

use foldhash::fast::FixedState;
use tiny_skia::PremultipliedColorU8;

use crate::color::Color;
use crate::image::Image;

/// Most colours of a palette.
const MOST: usize = 256;

/// The picture of opaque `pixels`, `width` in a row, with a palette.
pub(super) fn reduced(pixels: &[PremultipliedColorU8], width: usize) -> Image {
    let (occurring, runs) = counted(pixels);
    let (palette, nearest) = chosen(&occurring);
    let mut indices = Vec::with_capacity(pixels.len());
    for run in runs {
        indices.resize(indices.len() + run.pixels, nearest[run.color]);
    }
    Image {
        width,
        palette,
        is_first_transparent: false,
        indices,
    }
}

/// Neighbours of one colour.
struct Run {
    /// Its place among those that occur.
    color: usize,
    pixels: usize,
}

/// The colours in the order in which they are met, with how many pixels have each, and the runs of them.
fn counted(pixels: &[PremultipliedColorU8]) -> (Vec<(Color, u32)>, Vec<Run>) {
    let mut occurring: Vec<(Color, u32)> = Vec::new();
    let mut runs = Vec::new();
    let mut known: HashMap<u32, usize, FixedState> = HashMap::default();
    // Most pixels have the colour of the one before.
    for run in pixels.chunk_by(|a, b| a == b) {
        let [red, green, blue] = [run[0].red(), run[0].green(), run[0].blue()];
        let number = *known
            .entry(u32::from_be_bytes([0, red, green, blue]))
            .or_insert_with(|| {
                occurring.push((Color::rgb(red, green, blue), 0));
                occurring.len() - 1
            });
        occurring[number].1 += run.len() as u32;
        runs.push(Run {
            color: number,
            pixels: run.len(),
        });
    }
    (occurring, runs)
}

/// The palette, and the place in it of the nearest colour to each that occurs.
fn chosen(occurring: &[(Color, u32)]) -> (Vec<Color>, Vec<u8>) {
    let mut palette: Vec<Color> = Vec::new();
    let mut nearest = vec![0; occurring.len()];
    let mut distances = vec![u32::MAX; occurring.len()];
    let mut next = (0..occurring.len()).max_by_key(|&k| occurring[k].1);
    while let Some(found) = next.take_if(|_| palette.len() < MOST) {
        let color = occurring[found].0;
        let place = palette.len() as u8;
        palette.push(color);
        let mut worst = 0;
        let known = distances.iter_mut().zip(&mut nearest);
        for (k, ((one, pixels), (least, nearest))) in occurring.iter().zip(known).enumerate() {
            let distance = distance(*one, color);
            if distance < *least {
                (*least, *nearest) = (distance, place);
            }
            let loss = u64::from(*pixels) * u64::from(*least);
            if loss > worst {
                (worst, next) = (loss, Some(k));
            }
        }
    }
    (palette, nearest)
}

fn distance(a: Color, b: Color) -> u32 {
    let squared = |a: u8, b: u8| u32::from(a.abs_diff(b)).pow(2);
    squared(a.red, b.red) + squared(a.green, b.green) + squared(a.blue, b.blue)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pixel(red: usize, green: usize) -> PremultipliedColorU8 {
        PremultipliedColorU8::from_rgba(red as u8, green as u8, 0, 255).unwrap()
    }

    #[test]
    fn few_colours_stay_as_they_are() {
        let pixels: Vec<_> = (0..512).map(|k| pixel(k % 256, 7)).collect();
        let image = reduced(&pixels, 64);
        assert_eq!((image.palette.len(), image.height()), (256, 8));
        for (pixel, index) in pixels.iter().zip(&image.indices) {
            let color = image.palette[usize::from(*index)];
            assert_eq!(color, Color::rgb(pixel.red(), 7, 0));
        }
    }

    #[test]
    fn of_many_colours_the_frequent_ones_stay_and_the_rest_is_near() {
        let mut pixels: Vec<_> = (0..4096)
            .map(|k| pixel(4 * (k % 64), 4 * (k / 64)))
            .collect();
        pixels.extend(vec![pixel(1, 1); 5000]);
        let image = reduced(&pixels, pixels.len());
        assert_eq!(image.palette.len(), 256);
        assert_eq!(image.palette[0], Color::rgb(1, 1, 0));
        let farthest = pixels.iter().zip(&image.indices).map(|(pixel, index)| {
            let color = Color::rgb(pixel.red(), pixel.green(), 0);
            distance(color, image.palette[usize::from(*index)])
        });
        // 256 discs that cover a square of side 252 have at best a radius of 252 / 16 / √2 = 11; greedy ones at most twice that.
        assert!(farthest.max().unwrap() <= 22 * 22);
    }

    #[test]
    fn nothing_has_no_colours() {
        assert!(chosen(&[]).0.is_empty());
    }
}
