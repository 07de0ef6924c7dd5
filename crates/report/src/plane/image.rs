//! Pixels as an image of the figure's own resolution.

use super::{Pixels, PlanePlot, no_value};
use crate::axis::Span;
use crate::color::{Color, Colormap};
use crate::image::Image;
use crate::shape::Area;

/// Palette: 0 is no value, the rest are colours.
const COLORS: usize = 255;
/// As many greys as the eye distinguishes in a pattern; fewer make smaller files.
const GREYS: usize = 32;

fn colors(colormap: Colormap) -> usize {
    if colormap == Colormap::Gray {
        GREYS
    } else {
        COLORS
    }
}

/// Where the pixels are in the figure, and their image.
pub(super) fn painted(plot: &PlanePlot<'_>, area: &Area, range: &Span) -> Option<(Area, Image)> {
    let pixels = plot.pixels.as_ref()?;
    let rows = pixels.values.len() / pixels.columns;
    if rows == 0 {
        return None;
    }
    let placed = placed(plot, pixels, area);
    let [width, height] = [(placed.width, pixels.columns), (placed.height, rows)]
        .map(|(length, count)| ((length * plot.sharpness) as usize).clamp(1, count));
    let source = Source {
        pixels,
        rows,
        nearest: plot.colormap == Colormap::Cyclic,
    };
    let colors = colors(plot.colormap);
    let mut indices = Vec::with_capacity(width * height);
    for row in 0..height {
        for column in 0..width {
            let value = source.value([column, row], [width, height]);
            let fraction = range.fraction(value).filter(|_| value.is_finite());
            indices.push(fraction.map_or(0, |fraction| {
                let fraction = fraction.clamp(0.0, 1.0);
                1 + ((fraction * colors as f64) as usize).min(colors - 1) as u8
            }));
        }
    }
    Some((
        placed,
        Image {
            width,
            palette: palette(plot.colormap),
            is_first_transparent: false,
            indices,
        },
    ))
}

/// The part of the figure that the picture covers; it may reach beyond the window.
fn placed(plot: &PlanePlot<'_>, pixels: &Pixels<'_>, area: &Area) -> Area {
    let [x_low, x_high, y_low, y_high] = plot.window;
    let [left, right, bottom, top] = pixels.edges;
    let scale = [
        area.width / (x_high - x_low),
        area.height / (y_high - y_low),
    ];
    Area::new(
        [
            area.left + (left - x_low) * scale[0],
            area.top + (y_high - top) * scale[1],
        ],
        [(right - left) * scale[0], (top - bottom) * scale[1]],
    )
}

struct Source<'a> {
    pixels: &'a Pixels<'a>,
    rows: usize,
    nearest: bool,
}

impl Source<'_> {
    /// Value of an image pixel of an image of some size.
    fn value(&self, at: [usize; 2], size: [usize; 2]) -> f64 {
        let counts = [self.pixels.columns, self.rows];
        let range = |axis: usize| {
            let first = at[axis] * counts[axis] / size[axis];
            let end = ((at[axis] + 1) * counts[axis]).div_ceil(size[axis]);
            first..end.clamp(first + 1, counts[axis])
        };
        let (columns, rows) = (range(0), range(1));
        if self.nearest {
            let middle =
                |range: &std::ops::Range<usize>| usize::midpoint(range.start, range.end - 1);
            return self.pixels.values[middle(&rows) * self.pixels.columns + middle(&columns)];
        }
        let (mut sum, mut count) = (0.0, 0.0);
        for row in rows {
            let start = row * self.pixels.columns;
            let values = &self.pixels.values[start + columns.start..start + columns.end];
            for value in values.iter().filter(|value| value.is_finite()) {
                sum += value;
                count += 1.0;
            }
        }
        // Nothing over nothing is no value.
        sum / count
    }
}

fn palette(colormap: Colormap) -> Vec<Color> {
    let count = colors(colormap);
    let colors = (0..count).map(|k| colormap.at((k as f64 + 0.5) / count as f64));
    std::iter::once(no_value(colormap)).chain(colors).collect()
}
