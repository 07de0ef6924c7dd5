//! Large meshes, painted into an indexed PNG.

use super::patch::Patch;
use super::shading::{NO_VALUE, Paint};
use crate::color::Color;

/// Image pixels per figure pixel.
pub(crate) const SCALE: f64 = 3.0;
/// Cells from which on a mesh is painted.
const MANY_CELLS: usize = 20_000;
/// Pieces from which on a mesh is painted; each takes about 30 bytes as a path.
const MANY_PIECES: usize = 30_000;
/// Palette: 0 is transparent, 1 is no value, the rest are colours.
const FIRST_COLOR: usize = 2;
const COLORS: usize = 254;
/// Slits of up to twice this between cells are closed \[image pixels\].
const SLIT: f64 = 0.75;

/// The field as a PNG over the frame's area, if the mesh is too large for paths.
/// The error is the reason why the PNG could not be written.
pub(crate) fn painted(paint: &Paint<'_>, patches: &[Patch]) -> Result<Option<Vec<u8>>, String> {
    let pieces: usize = patches.iter().map(|patch| paint.cuts(patch).pow(2)).sum();
    if patches.len() < MANY_CELLS && pieces < MANY_PIECES {
        return Ok(None);
    }
    let mut picture = Picture::new(paint);
    for patch in patches {
        patch.pieces(paint.cuts(patch), |corners| {
            for k in 1..corners.len() - 1 {
                picture.triangle(paint, [corners[0], corners[k], corners[k + 1]]);
            }
        });
    }
    picture
        .encode(paint)
        .map(Some)
        .map_err(|cause| cause.to_string())
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
            for column in triangle.reach(0, self.width) {
                let weights = triangle.weights([column as f64, row as f64]);
                let pixel = &mut self.indices[row * self.width + column];
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

    fn encode(&self, paint: &Paint<'_>) -> Result<Vec<u8>, png::EncodingError> {
        let channels = |color: Color| [color.red, color.green, color.blue];
        let colors = (0..COLORS).map(|k| paint.colormap.at((k as f64 + 0.5) / COLORS as f64));
        let palette: Vec<u8> = [Color::rgb(255, 255, 255), NO_VALUE]
            .into_iter()
            .chain(colors)
            .flat_map(channels)
            .collect();
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_palette(palette);
        encoder.set_trns(vec![0_u8]);
        encoder.set_compression(png::Compression::High);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.indices)?;
        writer.finish()?;
        Ok(file)
    }
}

/// A triangle in image pixels, for barycentric weights.
struct Triangle {
    points: [[f64; 2]; 3],
    /// Twice the area, with the sign of the corners' order.
    doubled: f64,
    /// The weight that [`SLIT`] pixels outside the side opposite to each corner stand for.
    margins: [f64; 3],
}

impl Triangle {
    /// A triangle, unless it has no area.
    fn new(points: [[f64; 2]; 3]) -> Option<Self> {
        let [a, b, c] = points;
        let doubled = cross(a, b, c);
        let side = |p: [f64; 2], q: [f64; 2]| (q[0] - p[0]).hypot(q[1] - p[1]);
        let margins = [side(b, c), side(c, a), side(a, b)].map(|s| SLIT * s / doubled.abs());
        (doubled != 0.0).then_some(Self {
            points,
            doubled,
            margins,
        })
    }

    /// The weight of each corner at `point`; they sum to one.
    fn weights(&self, point: [f64; 2]) -> [f64; 3] {
        let [a, b, c] = self.points;
        [cross(point, b, c), cross(a, point, c), cross(a, b, point)].map(|w| w / self.doubled)
    }

    fn is_near(&self, weights: [f64; 3]) -> bool {
        weights
            .iter()
            .zip(&self.margins)
            .all(|(weight, margin)| *weight >= -margin)
    }

    /// Rows (axis 1) or columns (axis 0) of the image that the triangle may reach.
    fn reach(&self, axis: usize, count: usize) -> std::ops::Range<usize> {
        let along = self.points.map(|point| point[axis]);
        let low = along.iter().copied().fold(f64::INFINITY, f64::min) - SLIT;
        let high = along.iter().copied().fold(f64::NEG_INFINITY, f64::max) + SLIT;
        // Casts saturate: what is left of the image becomes 0, what is right its end.
        let end = (high.floor() + 1.0) as usize;
        low.ceil() as usize..end.min(count)
    }
}

/// Twice the signed area of a triangle.
fn cross(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
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
