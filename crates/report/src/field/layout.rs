//! Where the parts of a field plot go: heading, frame of equal scales, colour bar.

use super::FieldPlot;
use super::color_bar::ColorBar;
use crate::axis::ticks::significant;
use crate::axis::{Axis, Span};
use crate::error::FigureError;
use crate::frame::{Frame, Heading, OUTER, TITLE_SIZE};
use crate::shape::Area;

const BAR_GAP: f64 = 18.0;
/// Room for a point at either end of the colour bar \[px\].
const BAR_ENDS: f64 = 13.0;
const SMALLEST_BAR: f64 = 150.0;
const LARGEST_HEIGHT: f64 = 560.0;
const SMALLEST_SIDE: f64 = 20.0;
const SMALLEST_WIDTH: f64 = 380.0;

/// Every part of a field plot, placed.
#[derive(Debug)]
pub(crate) struct Layout {
    pub(crate) heading: Heading,
    pub(crate) frame: Frame,
    pub(crate) bar: ColorBar,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

/// Room left of, right of and above the frame \[px\].
#[derive(Debug, Clone, Copy)]
struct Margins {
    left: f64,
    right: f64,
    top: f64,
}

impl Layout {
    /// Lays out `plot` over `extent` (x, y), with the bar for `range` and the places of
    /// the least and largest value, if any, below the title.
    pub(crate) fn new(
        plot: &FieldPlot<'_>,
        extent: [Span; 2],
        bar_axis: &Axis,
        range: &Span,
        extremes: Option<&[[f64; 3]; 2]>,
    ) -> Result<Self, FigureError> {
        let placer = Placer {
            plot,
            extent,
            bar_axis,
            range,
            stated: match &plot.stated {
                Some(text) => text.clone(),
                None => describe(extremes, &unit(&plot.label), extent),
            },
        };
        // Ticks and margins depend on each other: each pass has the margins of the last.
        let guess = Margins {
            left: 60.0,
            right: 110.0,
            top: OUTER,
        };
        let (_, margins) = placer.place(guess)?;
        let (_, margins) = placer.place(margins)?;
        Ok(placer.place(margins)?.0)
    }
}

struct Placer<'a> {
    plot: &'a FieldPlot<'a>,
    extent: [Span; 2],
    bar_axis: &'a Axis,
    range: &'a Span,
    stated: String,
}

impl Placer<'_> {
    /// The layout with given margins, and the margins that it needs.
    fn place(&self, margins: Margins) -> Result<(Layout, Margins), FigureError> {
        let plot = self.plot;
        let [width, height] = self.frame_size(margins)?;
        let bar_height = height.max(SMALLEST_BAR);
        // A flat frame stands at the middle of its bar.
        let spare = (bar_height - height) / 2.0;
        let area = Area::new([margins.left, margins.top + spare], [width, height]);
        let axes = plot.coordinate_axes();
        let frame = Frame::new([&axes[0], &axes[1]], self.extent, area)?;
        let gap = frame.right_margin().max(BAR_GAP);
        let at = [area.right() + gap, margins.top + BAR_ENDS];
        let bar = ColorBar::new(self.bar_axis, self.range, at, bar_height - 2.0 * BAR_ENDS)?;
        let right = gap + bar.width() + OUTER;
        let total = (area.right() + right).max(SMALLEST_WIDTH);
        let lines = [plot.subtitle.as_deref().unwrap_or_default(), &self.stated];
        let heading = Heading::new(&plot.title, TITLE_SIZE, &lines, total - 2.0 * OUTER);
        let needed = Margins {
            left: OUTER + frame.left_margin(),
            right,
            top: OUTER + heading.height() + frame.top_margin(),
        };
        let height = area.bottom() + frame.bottom_margin().max(spare) + OUTER;
        Ok((
            Layout {
                heading,
                frame,
                bar,
                width: total,
                height,
            },
            needed,
        ))
    }

    /// Width and height inside the frame, equal scales on both axes.
    fn frame_size(&self, margins: Margins) -> Result<[f64; 2], FigureError> {
        let [dx, dy] = self.extent.map(|span| span.high - span.low);
        let aspect = dy / dx;
        let room = self.plot.width - margins.left - margins.right;
        let width = room.min(LARGEST_HEIGHT / aspect);
        let height = width * aspect;
        let drawable = SMALLEST_SIDE..1e5;
        if drawable.contains(&width) && drawable.contains(&height) {
            Ok([width, height])
        } else {
            let title = self.plot.title.clone();
            Err(FigureError::Size {
                title,
                width: self.plot.width,
                aspect,
            })
        }
    }
}

/// What the first brackets of a label hold, after a space; empty without brackets or a unit.
fn unit(label: &str) -> String {
    let inside = label
        .split_once('[')
        .and_then(|(_, rest)| rest.split_once(']'));
    let named = inside.filter(|(unit, _)| !matches!(*unit, "–" | "-"));
    named.map_or_else(String::new, |(unit, _)| format!(" {unit}"))
}

/// The least and largest value as text with `unit` and their places, to a ten-thousandth of `extent` or finer; empty if there are none.
fn describe(extremes: Option<&[[f64; 3]; 2]>, unit: &str, extent: [Span; 2]) -> String {
    let Some([least, largest]) = extremes else {
        return String::new();
    };
    let place = |[x, y, _]: &[f64; 3]| {
        let [dx, dy] = extent.map(|span| span.high - span.low);
        let grain = 10_f64.powf((1e-4 * dx.max(dy)).log10().floor());
        let coordinate = |value: f64| significant((value / grain).round() * grain, 4);
        format!("at ({}, {})", coordinate(*x), coordinate(*y))
    };
    let stated = |node: &[f64; 3]| format!("{}{unit} {}", significant(node[2], 4), place(node));
    format!("min {}, max {}", stated(least), stated(largest))
}
