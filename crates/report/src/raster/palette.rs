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

use tiny_skia::PremultipliedColorU8;

use crate::color::Color;
use crate::image::Image;

/// Most colours of a palette.
const MOST: usize = 256;

/// A colour that occurs, and what stands for it.
struct Occurring {
    color: Color,
    pixels: u64,
    /// Place in the palette of the nearest colour, and its squared distance.
    index: usize,
    distance: u64,
}

/// The picture of opaque `pixels`, `width` in a row, with a palette.
pub(super) fn reduced(pixels: &[PremultipliedColorU8], width: usize) -> Image {
    let (mut occurring, numbers) = counted(pixels);
    let palette = chosen(&mut occurring);
    let index = |number: u32| occurring[number as usize].index as u8;
    Image {
        width,
        palette,
        is_first_transparent: false,
        indices: numbers.into_iter().map(index).collect(),
    }
}

/// The colours in the order in which they are met, and the number of each pixel's among them.
fn counted(pixels: &[PremultipliedColorU8]) -> (Vec<Occurring>, Vec<u32>) {
    let mut occurring: Vec<Occurring> = Vec::new();
    let mut numbers = Vec::with_capacity(pixels.len());
    let mut known: HashMap<Color, u32> = HashMap::new();
    let mut last: Option<(Color, u32)> = None;
    for pixel in pixels {
        let color = Color::rgb(pixel.red(), pixel.green(), pixel.blue());
        let number = match last {
            // Most pixels have the colour of the one before.
            Some((same, number)) if same == color => number,
            _ => *known.entry(color).or_insert_with(|| {
                occurring.push(Occurring {
                    color,
                    pixels: 0,
                    index: 0,
                    distance: u64::MAX,
                });
                occurring.len() as u32 - 1
            }),
        };
        occurring[number as usize].pixels += 1;
        numbers.push(number);
        last = Some((color, number));
    }
    (occurring, numbers)
}

/// The palette; every occurring colour learns its nearest one.
fn chosen(occurring: &mut [Occurring]) -> Vec<Color> {
    let mut palette = Vec::new();
    let mut next = occurring
        .iter()
        .max_by_key(|one| one.pixels)
        .map(|one| one.color);
    while let Some(color) = next.take_if(|_| palette.len() < MOST) {
        let mut worst = 0;
        for one in occurring.iter_mut() {
            let distance = distance(one.color, color);
            if distance < one.distance {
                (one.distance, one.index) = (distance, palette.len());
            }
            let loss = one.pixels * one.distance;
            if loss > worst {
                (worst, next) = (loss, Some(one.color));
            }
        }
        palette.push(color);
    }
    palette
}

fn distance(a: Color, b: Color) -> u64 {
    let squared = |a: u8, b: u8| u64::from(a.abs_diff(b)).pow(2);
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
        assert!(chosen(&mut []).is_empty());
    }
}
