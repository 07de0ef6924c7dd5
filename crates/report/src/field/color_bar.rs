//! The colour bar: a strip of colours with ticks and the field's name.

use crate::axis::ticks::Ticks;
use crate::axis::{Axis, Padding, Span};
use crate::color::Colormap;
use crate::error::FigureError;
use crate::frame::{INK, LABEL_SIZE, LINE_HEIGHT, TICK_SIZE};
use crate::markup::Px;
use crate::shape::{Anchor, Area, Stroke, TextStyle};
use crate::svg::Canvas;
use crate::text::{self, Weight};

const WIDTH: f64 = 15.0;
const STRIPS: usize = 128;
const TICK: f64 = 4.0;
const POINT: f64 = 11.0;
const LABEL_GAP: f64 = 8.0;
/// Without three ticks a colour's value cannot be read.
const LEAST_TICKS: usize = 3;
const MOST_WANTED: usize = 12;

/// A colour bar, placed.
#[derive(Debug)]
pub(crate) struct ColorBar {
    area: Area,
    span: Span,
    ticks: Ticks,
    label: Vec<String>,
}

impl ColorBar {
    /// A bar for `axis` with the ends `span` at `left`, `top`, `height` px high.
    ///
    /// # Errors
    /// [`FigureError::TickSpacing`].
    pub(crate) fn new(
        axis: &Axis,
        span: &Span,
        [left, top]: [f64; 2],
        height: f64,
    ) -> Result<Self, FigureError> {
        let mut wanted = (height / 38.0).clamp(3.0, 9.0) as usize;
        let mut ticks = Ticks::new(axis, span, wanted)?;
        // Round steps may leave a short bar with its zero alone.
        while ticks.major.len() < LEAST_TICKS && wanted < MOST_WANTED {
            wanted += 1;
            ticks = Ticks::new(axis, span, wanted)?;
        }
        Ok(Self {
            area: Area::new([left, top], [WIDTH, height]),
            span: *span,
            ticks,
            label: text::wrap(&axis.label, height, LABEL_SIZE, Weight::Regular),
        })
    }

    /// Room for bar, ticks and name \[px\].
    pub(crate) fn width(&self) -> f64 {
        let name = LABEL_GAP + LABEL_SIZE * LINE_HEIGHT * self.label.len() as f64;
        WIDTH + TICK + 3.0 + self.tick_width() + name
    }

    fn tick_width(&self) -> f64 {
        let labels = self.ticks.major.iter().map(|tick| tick.label.as_str());
        text::widest(labels.chain(self.ticks.factor.as_deref()), TICK_SIZE)
    }
}

/// The values at the ends of a bar: those of `axis`, or of the `values`, equally far from zero where colours diverge from there.
///
/// # Errors
/// Those of [`Axis::span`].
pub(crate) fn span(
    axis: &Axis,
    colormap: Colormap,
    values: impl Iterator<Item = f64>,
) -> Result<Span, FigureError> {
    let flipped = if colormap.is_diverging() { -1.0 } else { 1.0 };
    let all = values.flat_map(|value| [value, flipped * value]);
    axis.span(all, Padding::Tight)
}

/// Draws the bar; `beyond` says whether values lie below and above it, which points
/// its ends.
pub(crate) fn draw(canvas: &mut Canvas, bar: &ColorBar, colormap: Colormap, beyond: [bool; 2]) {
    let area = bar.area;
    let height = area.height / STRIPS as f64;
    for strip in 0..STRIPS {
        let color = colormap.at((strip as f64 + 0.5) / STRIPS as f64);
        let top = area.bottom() - height * (strip + 1) as f64;
        // Each strip reaches under the one above it, which is drawn later.
        let overlap = if strip == 0 { 0.0 } else { 0.5 };
        let strip = Area::new([area.left, top], [area.width, height + overlap]);
        canvas.rectangle(&strip, color, None);
    }
    draw_border(canvas, &area, colormap, beyond);
    let style = TextStyle::new(TICK_SIZE, INK, Anchor::Start);
    let text_left = area.right() + TICK + 3.0;
    for tick in &bar.ticks.major {
        let Some(fraction) = bar.span.fraction(tick.value) else {
            continue;
        };
        let y = area.bottom() - fraction * area.height;
        canvas.line(
            [area.right(), y],
            [area.right() + TICK, y],
            &Stroke::solid(INK, 1.0),
        );
        canvas.centred_text([text_left, y], &tick.label, &style);
    }
    if let Some(factor) = &bar.ticks.factor {
        canvas.text([text_left, area.top - 0.9 * TICK_SIZE], factor, &style);
    }
    let name = TextStyle::new(LABEL_SIZE, INK, Anchor::Middle).upwards();
    let first = text_left + bar.tick_width() + LABEL_GAP + 0.85 * LABEL_SIZE;
    for (index, line) in bar.label.iter().enumerate() {
        let x = first + LABEL_SIZE * LINE_HEIGHT * index as f64;
        canvas.text([x, area.middle()[1]], line, &name);
    }
}

/// The border, with a point at an end that values lie beyond.
fn draw_border(canvas: &mut Canvas, area: &Area, colormap: Colormap, [below, above]: [bool; 2]) {
    let border = Stroke::solid(INK, 0.8);
    let (left, right, half) = (Px(area.left), Px(area.right()), Px(WIDTH / 2.0));
    let mut point = |y: f64, reach: f64, end: f64| {
        let data = format!(
            "M{left} {y}l{half} {reach}L{right} {y}z",
            y = Px(y),
            reach = Px(reach)
        );
        canvas.filled_path(&data, colormap.at(end), &border);
    };
    if below {
        point(area.bottom(), POINT, 0.0);
    }
    if above {
        point(area.top, -POINT, 1.0);
    }
    let data = format!(
        "M{left} {}V{}H{right}V{}z",
        Px(area.bottom()),
        Px(area.top),
        Px(area.bottom())
    );
    canvas.stroked_path(&data, &border);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::axis::Scale;

    #[test]
    fn bars_of_any_range_and_height_have_ticks_enough_to_read_a_value() {
        for height in [40.0, 90.0, 200.0, 500.0] {
            for k in 10..100 {
                let end = 0.1 * f64::from(k);
                for low in [-end, 0.0, 0.9 * end] {
                    let span = Span {
                        scale: Scale::Linear,
                        low,
                        high: end,
                    };
                    let bar = ColorBar::new(&Axis::linear("σ"), &span, [0.0; 2], height).unwrap();
                    let count = bar.ticks.major.len();
                    assert!((3..=13).contains(&count), "{low} … {end}: {count}");
                }
            }
        }
    }
}
