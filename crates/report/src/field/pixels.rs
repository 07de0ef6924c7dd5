//! Large meshes, painted into an image of indexed colours.

use std::ops::Range;

use super::patch::Patch;
use super::shading::{NO_VALUE, Paint};
use crate::axis::ends;
use crate::color::Color;
use crate::image::Image;

/// Image pixels per figure pixel, as many as a PNG file has, so that none of its pixels blends two of these.
pub(crate) const SCALE: f64 = crate::raster::DEFAULT_SCALE;
/// Pieces from which on a mesh is painted: as paths each takes about 40 bytes and 10 µs to draw, an image some 100 kB and 50 ms.
const MANY_PIECES: usize = 16_000;
/// Palette: 0 is transparent, 1 is no value, the rest are colours.
const FIRST_COLOR: usize = 2;
const COLORS: usize = 254;
/// Slits of up to twice this between cells are closed \[image pixels\].
const SLIT: f64 = 0.75;

/// The field as an image over the frame's area, if the mesh is too large for paths.
pub(crate) fn painted(paint: &Paint<'_>, patches: &[Patch]) -> Option<Image> {
    let pieces: usize = patches.iter().map(|patch| paint.cuts(patch).pow(2)).sum();
    if pieces < MANY_PIECES {
        return None;
    }
    let mut picture = Picture::new(paint);
    for patch in patches {
        patch.pieces(paint.cuts_for_pixels(patch), |corners| {
            for k in 1..corners.len() - 1 {
                picture.triangle(paint, [corners[0], corners[k], corners[k + 1]]);
            }
        });
    }
    Some(picture.image(paint))
}

struct Picture {
    width: usize,
    height: usize,
    indices: Vec<u8>,
}

impl Picture {
    fn new(paint: &Paint<'_>) -> Self {
        let area = paint.frame.area;
        let width = (area.width * SCALE).ceil().max(1.0) as usize;
        let height = (area.height * SCALE).ceil().max(1.0) as usize;
        Self {
            width,
            height,
            indices: vec![0; width * height],
        }
    }

    /// Paints the pixels whose centres lie in the triangle, and empty ones beside it: a
    /// curved edge may be cut differently on its two sides, which leaves slits.
    fn triangle(&mut self, paint: &Paint<'_>, corners: [[f64; 3]; 3]) {
        let area = paint.frame.area;
        let stretch = [
            self.width as f64 / area.width,
            self.height as f64 / area.height,
        ];
        let points = corners.map(|corner| {
            let [x, y] = paint.pixel(corner);
            [
                (x - area.left) * stretch[0] - 0.5,
                (y - area.top) * stretch[1] - 0.5,
            ]
        });
        let Some(triangle) = Triangle::new(points) else {
            return;
        };
        for row in triangle.reach(1, self.height) {
            let along = triangle.along_row(row as f64);
            let pixels = &mut self.indices[row * self.width..][..self.width];
            for column in triangle.columns(along, self.width) {
                let weights = along.map(|[rise, start]| rise * column as f64 + start);
                let pixel = &mut pixels[column];
                let inside = weights.iter().all(|weight| *weight >= 0.0);
                if inside || (*pixel == 0 && triangle.is_near(weights)) {
                    let value = weights
                        .iter()
                        .zip(&corners)
                        .map(|(w, corner)| w * corner[2])
                        .sum();
                    *pixel = index_of(paint, value);
                }
            }
        }
    }

    fn image(self, paint: &Paint<'_>) -> Image {
        let colors = (0..COLORS).map(|k| paint.colormap.at((k as f64 + 0.5) / COLORS as f64));
        let ends = [Color::rgb(255, 255, 255), NO_VALUE];
        Image {
            width: self.width,
            palette: ends.into_iter().chain(colors).collect(),
            is_first_transparent: true,
            indices: self.indices,
        }
    }
}

/// A triangle in image pixels, for barycentric weights.
struct Triangle {
    points: [[f64; 2]; 3],
    /// The weight of each corner at (x, y), a x + b y + c, as (a, b, c).
    weights: [[f64; 3]; 3],
    /// The weight that [`SLIT`] pixels outside the side opposite to each corner stand for.
    margins: [f64; 3],
}

impl Triangle {
    /// A triangle, unless it has no area.
    fn new(points: [[f64; 2]; 3]) -> Option<Self> {
        let [a, b, c] = points;
        let doubled = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        // Zero on the side from p to q.
        let weight = |p: [f64; 2], q: [f64; 2]| {
            [p[1] - q[1], q[0] - p[0], p[0] * q[1] - q[0] * p[1]].map(|part| part / doubled)
        };
        let weights = [weight(b, c), weight(c, a), weight(a, b)];
        // The weight rises across the side by the length of its gradient.
        let margins = weights.map(|[x, y, _]| SLIT * (x * x + y * y).sqrt());
        (doubled != 0.0).then_some(Self {
            points,
            weights,
            margins,
        })
    }

    /// The weight of each corner at (x, `y`), a x + b, as (a, b).
    fn along_row(&self, y: f64) -> [[f64; 2]; 3] {
        self.weights.map(|[a, b, c]| [a, b * y + c])
    }

    fn is_near(&self, weights: [f64; 3]) -> bool {
        weights
            .iter()
            .zip(&self.margins)
            .all(|(weight, margin)| *weight >= -margin)
    }

    /// Rows (axis 1) or columns (axis 0) of the image that the triangle may reach.
    fn reach(&self, axis: usize, count: usize) -> Range<usize> {
        let [low, high] = ends(self.points.map(|point| point[axis]));
        whole(low - SLIT, high + SLIT, count)
    }

    /// Columns of the row with the weights `along` that may be near.
    fn columns(&self, along: [[f64; 2]; 3], count: usize) -> Range<usize> {
        let [mut low, mut high] = ends(self.points.map(|point| point[0]));
        (low, high) = (low - SLIT, high + SLIT);
        for ([rise, start], margin) in along.into_iter().zip(self.margins) {
            let end = -(margin + start) / rise;
            if rise > 0.0 {
                low = low.max(end - 1.0);
            } else if rise < 0.0 {
                high = high.min(end + 1.0);
            }
        }
        whole(low, high, count)
    }
}

/// Pixels of a line of `count` from `low` to `high`.
fn whole(low: f64, high: f64, count: usize) -> Range<usize> {
    // Casts saturate: what is before the line becomes 0, what is after it its end.
    let end = (high.floor() + 1.0) as usize;
    low.ceil() as usize..end.min(count)
}

fn index_of(paint: &Paint<'_>, value: f64) -> u8 {
    match paint.fraction(value) {
        Some(fraction) => {
            let color = ((fraction * COLORS as f64) as usize).min(COLORS - 1);
            (FIRST_COLOR + color) as u8
        }
        None => 1,
    }
}
