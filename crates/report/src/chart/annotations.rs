//! Bands and reference lines, and their names around the frame.
//!
//! From the frame upwards: one strip of band names, then rows of names of vertical
//! lines, as many as keep the names apart. Right of the frame: names of horizontal
//! lines, moved apart where they would overlap.

use super::{Band, Direction, LineChart, ReferenceLine};
use crate::color::Color;
use crate::frame::{Frame, LINE_HEIGHT};
use crate::shape::{Anchor, Area, Stroke, TextStyle};
use crate::svg::Canvas;
use crate::text::{self, Weight};

/// Strength of a band's tint behind the curves.
pub(crate) const SHADE: f64 = 0.13;
const SIZE: f64 = 10.5;
const STRIP: f64 = 17.0;
const ROW: f64 = 15.0;
const GAP: f64 = 8.0;
/// Horizontal names are wrapped at this width \[px\].
const WIDEST_NAME: f64 = 120.0;
const LEADER: f64 = 10.0;

/// Bands and lines that are to be drawn, with the rows that their names need.
#[derive(Debug)]
pub(crate) struct Annotations {
    bands: Vec<Band>,
    lines: Vec<ReferenceLine>,
    /// Whether each band's name fits above it.
    named: Vec<bool>,
    /// Rows of each line's name, 0 next to the frame.
    rows: Vec<Option<usize>>,
}

impl Annotations {
    /// The annotations of `chart` for its `frame`.
    pub(crate) fn new(chart: &LineChart, frame: &Frame) -> Self {
        let bands: Vec<Band> = chart.bands.clone();
        let named = bands.iter().map(|band| name_fits(band, frame)).collect();
        let lines = chart.references.clone();
        let rows = vertical_rows(&lines, frame);
        Self {
            bands,
            lines,
            named,
            rows,
        }
    }

    /// Names and colours of the visible bands that are too narrow for their names.
    pub(crate) fn unnamed(&self, frame: &Frame) -> Vec<(String, Color)> {
        let mut shades: Vec<(String, Color)> = Vec::new();
        for (band, named) in self.bands.iter().zip(&self.named) {
            let visible = extent(band, frame).is_some() && !band.label.trim().is_empty();
            let shade = (band.label.clone(), band.color);
            if visible && !named && !shades.contains(&shade) {
                shades.push(shade);
            }
        }
        shades
    }

    /// Room for the names above the frame \[px\].
    pub(crate) fn height_above(&self) -> f64 {
        let rows = self
            .rows
            .iter()
            .flatten()
            .map(|row| row + 1)
            .max()
            .unwrap_or(0);
        self.strip_height() + ROW * rows as f64
    }

    /// Room for the names right of the frame \[px\]; does not depend on the frame.
    pub(crate) fn width_right(chart: &LineChart) -> f64 {
        let names = chart
            .references
            .iter()
            .filter(|line| line.direction == Direction::Horizontal);
        let widest = names
            .map(|line| text::widest(wrapped(line).iter().map(String::as_str), SIZE))
            .fold(0.0, f64::max);
        if widest > 0.0 {
            widest + LEADER + 4.0
        } else {
            0.0
        }
    }

    pub(crate) fn draw_bands(&self, canvas: &mut Canvas, frame: &Frame) {
        for (band, named) in self.bands.iter().zip(&self.named) {
            let Some([left, right]) = extent(band, frame) else {
                continue;
            };
            let shade = Area {
                left,
                width: right - left,
                ..frame.area
            };
            canvas.rectangle(&shade, band.color.tint(SHADE), None);
            if self.strip_height() == 0.0 {
                continue;
            }
            let strip = Area {
                top: frame.area.top - STRIP,
                height: STRIP,
                ..shade
            };
            canvas.rectangle(&strip, band.color.tint(2.2 * SHADE), None);
            if *named {
                let style = TextStyle::new(SIZE, dark(band.color), Anchor::Middle);
                canvas.centred_text(strip.middle(), &band.label, &style);
            }
        }
    }

    pub(crate) fn draw_lines(&self, canvas: &mut Canvas, frame: &Frame) {
        for (line, row) in self.lines.iter().zip(&self.rows) {
            let Some([from, mut to]) = segment(line, frame) else {
                continue;
            };
            if let Some(row) = row {
                to[1] -= self.strip_height() + ROW * *row as f64 + 3.0;
            }
            canvas.line(from, to, &Stroke::dashed(line.color, 1.2, &[5.0, 3.0]));
        }
    }

    pub(crate) fn draw_labels(&self, canvas: &mut Canvas, frame: &Frame) {
        for (line, row) in self.lines.iter().zip(&self.rows) {
            let (Some(row), Some(x)) = (row, frame.pixel_x(line.value)) else {
                continue;
            };
            let middle =
                name_extent(line, x, frame).map_or(x, |[left, right]| f64::midpoint(left, right));
            let bottom = frame.area.top - self.strip_height() - ROW * *row as f64;
            let style = TextStyle::new(SIZE, dark(line.color), Anchor::Middle);
            canvas.centred_text([middle, bottom - ROW / 2.0], &line.label, &style);
        }
        self.draw_side_labels(canvas, frame);
    }

    fn draw_side_labels(&self, canvas: &mut Canvas, frame: &Frame) {
        let mut names: Vec<(f64, &ReferenceLine, Vec<String>)> = self
            .lines
            .iter()
            .filter(|line| line.direction == Direction::Horizontal && frame.y.contains(line.value))
            .filter(|line| !line.label.trim().is_empty())
            .filter_map(|line| Some((frame.pixel_y(line.value)?, line, wrapped(line))))
            .collect();
        names.sort_by(|a, b| a.0.total_cmp(&b.0));
        let wanted: Vec<[f64; 2]> = names
            .iter()
            .map(|(y, _, lines)| [*y, SIZE * LINE_HEIGHT * lines.len() as f64])
            .collect();
        let right = frame.area.right();
        for ((y, line, lines), middle) in names.iter().zip(moved_apart(&wanted, frame.area)) {
            canvas.line(
                [right, *y],
                [right + LEADER - 2.0, middle],
                &Stroke::solid(line.color, 0.8),
            );
            let first = middle - SIZE * LINE_HEIGHT * (lines.len() as f64 - 1.0) / 2.0;
            for (index, text) in lines.iter().enumerate() {
                let at = [right + LEADER, first + SIZE * LINE_HEIGHT * index as f64];
                super::curves::draw_name(canvas, at, text, SIZE, dark(line.color));
            }
        }
    }

    fn strip_height(&self) -> f64 {
        if self.named.contains(&true) {
            STRIP
        } else {
            0.0
        }
    }
}

/// The line inside the frame, from below or left, if its value is on the axis.
pub(crate) fn segment(line: &ReferenceLine, frame: &Frame) -> Option<[[f64; 2]; 2]> {
    let area = frame.area;
    match line.direction {
        Direction::Horizontal if frame.y.contains(line.value) => {
            let y = frame.pixel_y(line.value)?;
            Some([[area.left, y], [area.right(), y]])
        }
        Direction::Vertical if frame.x.contains(line.value) => {
            let x = frame.pixel_x(line.value)?;
            Some([[x, area.bottom()], [x, area.top]])
        }
        _ => None,
    }
}

/// Left and right pixel of the visible part of a band.
fn extent(band: &Band, frame: &Frame) -> Option<[f64; 2]> {
    let [a, b] = band.range;
    let (low, high) = (a.min(b).max(frame.x.low), a.max(b).min(frame.x.high));
    (low < high).then_some([frame.pixel_x(low)?, frame.pixel_x(high)?])
}

fn name_fits(band: &Band, frame: &Frame) -> bool {
    let needed = text::width(&band.label, SIZE, Weight::Regular) + GAP;
    let visible = extent(band, frame);
    !band.label.trim().is_empty() && visible.is_some_and(|[left, right]| right - left >= needed)
}

/// Left and right pixel of the name of a vertical line at `x`, kept over the frame.
fn name_extent(line: &ReferenceLine, x: f64, frame: &Frame) -> Option<[f64; 2]> {
    if line.direction == Direction::Horizontal || line.label.trim().is_empty() {
        return None;
    }
    let width = text::width(&line.label, SIZE, Weight::Regular);
    let left = (x - width / 2.0)
        .min(frame.area.right() - width)
        .max(frame.area.left);
    Some([left, left + width])
}

/// The first row, from the frame upwards, where each name meets neither another name
/// nor, further down, the line of another.
fn vertical_rows(lines: &[ReferenceLine], frame: &Frame) -> Vec<Option<usize>> {
    let mut placed: Vec<(usize, [f64; 2], f64)> = Vec::new();
    lines
        .iter()
        .map(|line| {
            let x = frame
                .pixel_x(line.value)
                .filter(|_| frame.x.contains(line.value))?;
            let [left, right] = name_extent(line, x, frame)?;
            let free = |row: usize| {
                placed.iter().all(|&(other, [a, b], line_x)| {
                    let meets_name = row == other && left < b + GAP && right > a - GAP;
                    let meets_line = row < other && line_x > left - 2.0 && line_x < right + 2.0;
                    let is_crossed = row > other && x > a - 2.0 && x < b + 2.0;
                    !(meets_name || meets_line || is_crossed)
                })
            };
            // Above all others a name is crossed only by its own line's way up; with
            // n names, n + 1 rows are always enough to try.
            let row = (0..=placed.len())
                .find(|&row| free(row))
                .unwrap_or(placed.len());
            placed.push((row, [left, right], x));
            Some(row)
        })
        .collect()
}

fn wrapped(line: &ReferenceLine) -> Vec<String> {
    text::wrap(&line.label, WIDEST_NAME, SIZE, Weight::Regular)
}

/// Middles for names at `wanted` (middle, height; in rising order) that do not overlap
/// and, where they fit at all, stay within `area`.
fn moved_apart(wanted: &[[f64; 2]], area: Area) -> Vec<f64> {
    let mut middles: Vec<f64> = Vec::with_capacity(wanted.len());
    let mut free = f64::NEG_INFINITY;
    for &[middle, height] in wanted {
        let placed = middle.max(free + height / 2.0);
        free = placed + height / 2.0;
        middles.push(placed);
    }
    let mut limit = area.bottom() + SIZE / 2.0;
    for (placed, &[_, height]) in middles.iter_mut().zip(wanted).rev() {
        *placed = placed.min(limit - height / 2.0);
        limit = *placed - height / 2.0;
    }
    middles
}

/// A colour dark enough for small text on white.
fn dark(color: Color) -> Color {
    let factor = (95.0 / color.luminance().max(1.0)).min(1.0);
    let scale = |channel: u8| (f64::from(channel) * factor).round() as u8;
    Color::rgb(scale(color.red), scale(color.green), scale(color.blue))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_moved_apart_and_kept_inside() {
        let area = Area::new([0.0, 0.0], [100.0, 100.0]);
        let places = moved_apart(
            &[[50.0, 14.0], [52.0, 14.0], [98.0, 14.0], [99.0, 14.0]],
            area,
        );
        assert!(
            places
                .windows(2)
                .all(|pair| pair[1] - pair[0] >= 14.0 - 1e-9),
            "{places:?}"
        );
        assert!(places[3] + 7.0 <= 100.0 + SIZE / 2.0);
        assert_eq!(places[0], 50.0);
    }

    #[test]
    fn light_colours_are_darkened_for_text() {
        let yellow = dark(Color::rgb(240, 228, 66));
        assert!(yellow.red < 120);
        assert_eq!(dark(Color::rgb(0, 0, 120)), Color::rgb(0, 0, 120));
    }
}
