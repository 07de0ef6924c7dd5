//! Pieces of one colour, gathered into one path per colour.

use std::fmt::Write as _;

use super::patch::Patch;
use crate::axis::{Span, ends};
use crate::color::{Color, Colormap};
use crate::frame::Frame;
use crate::shape::Stroke;
use crate::svg::Canvas;

/// Colours between the ends of the bar.
pub(crate) const LEVELS: usize = 128;
/// Colour of pieces without a value.
pub(crate) const NO_VALUE: Color = Color::rgb(0xd8, 0xd8, 0xd8);
/// Sides of pieces are not made shorter than this \[px\].
const SMALLEST_PIECE: f64 = 3.0;
/// Sides of a cell are cut at most so often.
const MOST_CUTS: f64 = 100.0;
/// Sides of a curved cell are cut at least so often.
const CURVED_CUTS: f64 = 4.0;
/// Pieces overlap their neighbours by half of this, so that no seam shows \[px\].
const OVERLAP: f64 = 0.6;

/// How values and places become colours and pixels.
#[derive(Debug)]
pub(crate) struct Paint<'a> {
    pub(crate) frame: &'a Frame,
    range: &'a Span,
    pub(crate) colormap: Colormap,
}

impl<'a> Paint<'a> {
    pub(crate) fn new(frame: &'a Frame, range: &'a Span, colormap: Colormap) -> Self {
        Self {
            frame,
            range,
            colormap,
        }
    }

    /// The part of the colour bar below `value`, 0 to 1; nothing for no value.
    pub(crate) fn fraction(&self, value: f64) -> Option<f64> {
        if value.is_nan() || value.is_infinite() {
            return None;
        }
        self.range
            .fraction(value)
            .map(|fraction| fraction.clamp(0.0, 1.0))
    }

    /// The pixel of a node. Its coordinates are finite, so it has one.
    pub(crate) fn pixel(&self, node: [f64; 3]) -> [f64; 2] {
        self.frame
            .pixel([node[0], node[1]])
            .unwrap_or([self.frame.area.left, self.frame.area.top])
    }

    /// Into how many parts the sides of `patch` are cut for pieces of one colour: enough for one colour step per
    /// piece, and for smooth curves, but no smaller than can be seen.
    pub(crate) fn cuts(&self, patch: &Patch) -> usize {
        let values = patch
            .corners()
            .iter()
            .filter_map(|node| self.fraction(node[2]));
        let steps = LEVELS as f64 * spread(values);
        let needed = if patch.is_quadratic() {
            (1.5 * steps).max(CURVED_CUTS)
        } else {
            steps
        };
        self.cuts_of(patch, needed)
    }

    /// Into how many parts the sides of `patch` are cut for pieces with a value in each pixel: enough that interpolation between their
    /// corners, whose error falls with the square of the number, stays within about half a pixel and half a colour step.
    pub(crate) fn cuts_for_pixels(&self, patch: &Patch) -> usize {
        let seen = |node: [f64; 3]| {
            let [x, y] = self.pixel(node);
            [x, y, LEVELS as f64 * self.fraction(node[2]).unwrap_or(0.0)]
        };
        let error = patch.departures().map(|[from, to]| {
            let ([x, y, value], [u, v, other]) = (seen(from), seen(to));
            (x - u).hypot(y - v).max((value - other).abs())
        });
        self.cuts_of(patch, (2.0 * error.fold(0.0, f64::max)).sqrt())
    }

    /// `needed` cuts, at most so many that each piece can be seen.
    fn cuts_of(&self, patch: &Patch, needed: f64) -> usize {
        let pixels: Vec<[f64; 2]> = patch
            .corners()
            .iter()
            .map(|&node| self.pixel(node))
            .collect();
        let reach = |axis: usize| spread(pixels.iter().map(|pixel| pixel[axis]));
        let most = (reach(0).max(reach(1)) / SMALLEST_PIECE)
            .ceil()
            .clamp(1.0, MOST_CUTS);
        needed.ceil().clamp(1.0, most) as usize
    }
}

fn spread(values: impl Iterator<Item = f64>) -> f64 {
    let [low, high] = ends(values);
    if low > high { 0.0 } else { high - low }
}

/// Draws all patches, colour by colour.
pub(crate) fn fill(canvas: &mut Canvas, paint: &Paint<'_>, patches: &[Patch]) {
    let mut without_value = String::new();
    let mut levels = vec![String::new(); LEVELS];
    for patch in patches {
        patch.pieces(paint.cuts(patch), |corners| {
            let mean = corners.iter().map(|corner| corner[2]).sum::<f64>() / corners.len() as f64;
            let data = match paint.fraction(mean) {
                // At fraction 1 the index would be one too large.
                Some(fraction) => {
                    &mut levels[((fraction * LEVELS as f64) as usize).min(LEVELS - 1)]
                }
                None => &mut without_value,
            };
            add_polygon(data, corners.iter().map(|&corner| paint.pixel(corner)));
        });
    }
    canvas.filled_path(&without_value, NO_VALUE, &Stroke::solid(NO_VALUE, OVERLAP));
    for (level, data) in levels.iter().enumerate() {
        let color = paint.colormap.at((level as f64 + 0.5) / LEVELS as f64);
        canvas.filled_path(data, color, &Stroke::solid(color, OVERLAP));
    }
}

/// Appends a closed polygon with coordinates in tenths of a pixel, relative to the
/// rounded point before, so that rounding does not add up.
fn add_polygon(data: &mut String, points: impl Iterator<Item = [f64; 2]>) {
    let mut before = [0_i64; 2];
    for (index, point) in points.enumerate() {
        let rounded = point.map(|coordinate| (coordinate * 10.0).round() as i64);
        data.push_str(match index {
            0 => "M",
            1 => "l",
            _ => " ",
        });
        push_tenths(data, rounded[0] - before[0]);
        if rounded[1] >= before[1] {
            data.push(' ');
        }
        push_tenths(data, rounded[1] - before[1]);
        before = rounded;
    }
    data.push('z');
}

fn push_tenths(data: &mut String, tenths: i64) {
    if tenths < 0 {
        data.push('-');
    }
    // Writing to a String cannot fail.
    let _ = match (tenths.abs() / 10, tenths.abs() % 10) {
        (whole, 0) => write!(data, "{whole}"),
        (0, part) => write!(data, ".{part}"),
        (whole, part) => write!(data, "{whole}.{part}"),
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_are_written_short_and_relative() {
        let mut data = String::new();
        add_polygon(
            &mut data,
            [[1.04, 2.0], [1.54, 1.0], [0.0, 12.34]].into_iter(),
        );
        assert_eq!(data, "M1 2l.5-1 -1.5 11.3z");
    }
}
