//! Where the parts of a chart go.
//!
//! ```text
//! heading
//! names of vertical lines, strip of band names
//! y axis │ area inside the frame │ names of horizontal lines │ legend
//! x axis
//! legend
//! ```

use super::annotations::Annotations;
use super::legend::{LegendBox, empty_place};
use super::{Direction, Legend, LineChart, SeriesStyle};
use crate::axis::{Padding, Span};
use crate::error::FigureError;
use crate::frame::{Frame, Heading, OUTER, TITLE_SIZE};
use crate::shape::Area;

const LEGEND_GAP: f64 = 14.0;
/// Smallest side of the area inside the frame \[px\].
const SMALLEST_SIDE: f64 = 40.0;
/// Entries up to which a legend that finds no room inside goes below the chart.
const MOST_BELOW: usize = 8;

/// Least room around the area inside the frame, so that panels line up \[px\].
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Margins {
    pub(crate) left: f64,
    pub(crate) right: f64,
    pub(crate) top: f64,
}

impl Margins {
    pub(crate) fn covering(self, other: Self) -> Self {
        Self {
            left: self.left.max(other.left),
            right: self.right.max(other.right),
            top: self.top.max(other.top),
        }
    }
}

/// Every part of a chart, placed.
#[derive(Debug)]
pub(crate) struct Layout {
    pub(crate) heading: Heading,
    pub(crate) frame: Frame,
    pub(crate) annotations: Annotations,
    pub(crate) legend: Option<(LegendBox, [f64; 2])>,
    pub(crate) height: f64,
}

impl Layout {
    /// Lays out `chart` with at least the margins `least`.
    pub(crate) fn new(chart: &LineChart, least: Margins) -> Result<Self, FigureError> {
        let sized = chart.width.is_finite() && chart.width < 1e5 && chart.aspect.is_finite();
        if !sized || chart.aspect <= 0.0 {
            return Err(no_room(chart));
        }
        let placer = Placer {
            chart,
            spans: spans(chart)?,
            least,
        };
        match chart.legend {
            Legend::Hidden => placer.without_legend(),
            Legend::Right => placer.legend_right(),
            Legend::Below => placer.legend_below(),
            Legend::Automatic => placer.legend_inside()?.map_or_else(
                || {
                    if placer.entries()? <= MOST_BELOW {
                        placer.legend_below()
                    } else {
                        placer.legend_right()
                    }
                },
                Ok,
            ),
        }
    }

    /// The margins that this layout has.
    pub(crate) fn margins(&self, width: f64) -> Margins {
        Margins {
            left: self.frame.area.left,
            right: width - self.frame.area.right(),
            top: self.frame.area.top,
        }
    }
}

/// Tries places for the legend of one chart.
struct Placer<'a> {
    chart: &'a LineChart,
    spans: [Span; 2],
    least: Margins,
}

impl Placer<'_> {
    fn without_legend(&self) -> Result<Layout, FigureError> {
        self.place(0.0)
    }

    fn entries(&self) -> Result<usize, FigureError> {
        let layout = self.place(0.0)?;
        Ok(self.legend_of(&layout).map_or(0, |legend| legend.len()))
    }

    /// The layout with the legend inside the frame, if there is room (or no legend).
    fn legend_inside(&self) -> Result<Option<Layout>, FigureError> {
        let mut layout = self.place(0.0)?;
        let Some(mut legend) = self.legend_of(&layout) else {
            return Ok(Some(layout));
        };
        legend.enclose();
        let place = empty_place(self.chart, &layout.frame, legend.size());
        Ok(place.map(|at| {
            layout.legend = Some((legend, at));
            layout
        }))
    }

    fn legend_below(&self) -> Result<Layout, FigureError> {
        let mut layout = self.place(0.0)?;
        if let Some(mut legend) = self.legend_of(&layout) {
            let left = layout.frame.area.left;
            legend.spread(self.chart.width - OUTER - left);
            let top = layout.height - OUTER + LEGEND_GAP - 4.0;
            layout.height = top + legend.size()[1] + OUTER;
            layout.legend = Some((legend, [left, top]));
        }
        Ok(layout)
    }

    fn legend_right(&self) -> Result<Layout, FigureError> {
        let layout = self.place(0.0)?;
        let Some(legend) = self.legend_of(&layout) else {
            return Ok(layout);
        };
        let [width, _] = legend.size();
        let mut layout = self.place(width + LEGEND_GAP)?;
        // A narrower frame may leave more bands without a name.
        let Some(legend) = self.legend_of(&layout) else {
            return Ok(layout);
        };
        let [width, height] = legend.size();
        let area = layout.frame.area;
        layout.height = layout.height.max(area.top + height + OUTER);
        layout.legend = Some((legend, [self.chart.width - OUTER - width, area.top]));
        Ok(layout)
    }

    fn legend_of(&self, layout: &Layout) -> Option<LegendBox> {
        LegendBox::new(self.chart, &layout.annotations.unnamed(&layout.frame))
    }

    /// Everything but the legend, with `reserved` px free at the right.
    fn place(&self, reserved: f64) -> Result<Layout, FigureError> {
        let chart = self.chart;
        let below = chart.subtitle.as_deref().unwrap_or_default();
        let width = chart.width - 2.0 * OUTER;
        let heading = Heading::new(&chart.title, TITLE_SIZE, &[below], width);
        // The ticks, and with them the margins, depend on the area, the area on the
        // margins: the second pass has the margins of the first.
        let mut margins = Margins {
            left: 60.0,
            right: 12.0,
            top: 0.0,
        };
        let mut frame = self.frame(margins)?;
        for _ in 0..2 {
            let annotations = Annotations::new(chart, &frame);
            let beside = Annotations::width_right(chart).max(frame.right_margin()) + reserved;
            let above = annotations.height_above().max(frame.top_margin());
            let needed = Margins {
                left: OUTER + frame.left_margin(),
                right: OUTER + beside,
                top: OUTER + heading.height() + above,
            };
            margins = needed.covering(self.least);
            frame = self.frame(margins)?;
        }
        let height = frame.area.bottom() + frame.bottom_margin() + OUTER;
        let annotations = Annotations::new(chart, &frame);
        Ok(Layout {
            heading,
            frame,
            annotations,
            legend: None,
            height,
        })
    }

    fn frame(&self, margins: Margins) -> Result<Frame, FigureError> {
        let chart = self.chart;
        let width = chart.width - margins.left - margins.right;
        let height = width * chart.aspect;
        if width < SMALLEST_SIDE || !(SMALLEST_SIDE..1e5).contains(&height) {
            return Err(no_room(chart));
        }
        let area = Area::new([margins.left, margins.top], [width, height]);
        Frame::new([&chart.x, &chart.y], self.spans, area)
    }
}

fn no_room(chart: &LineChart) -> FigureError {
    FigureError::Size {
        title: chart.title.clone(),
        width: chart.width,
        aspect: chart.aspect,
    }
}

/// The ends of both axes: data and reference lines, markers with room around them.
fn spans(chart: &LineChart) -> Result<[Span; 2], FigureError> {
    let coordinate = |axis: usize| {
        chart
            .series
            .iter()
            .flat_map(move |series| series.points.iter().map(move |p| p[axis]))
    };
    let fixed = |direction: Direction| {
        chart
            .references
            .iter()
            .filter(move |line| line.direction == direction)
            .map(|line| line.value)
    };
    let marked = chart
        .series
        .iter()
        .any(|series| matches!(series.style, SeriesStyle::Markers | SeriesStyle::Both));
    let padding = if marked {
        Padding::Loose
    } else {
        Padding::Tight
    };
    let spreads = chart
        .series
        .iter()
        .flat_map(|series| series.spread.iter().flatten().copied());
    let values = coordinate(0)
        .chain(spreads)
        .chain(fixed(Direction::Vertical));
    let x = chart.x.span(values, padding)?;
    // A fitted y axis sees only what the x axis shows.
    let shown = chart.series.iter().flat_map(|series| {
        series
            .points
            .iter()
            .filter(|point| x.contains(point[0]))
            .map(|p| p[1])
    });
    let margins = chart.series.iter().flat_map(|series| {
        let pairs = series.points.iter().zip(&series.margin);
        let inside = pairs.filter(|(point, _)| x.contains(point[0]));
        inside.flat_map(|(_, margin)| *margin)
    });
    let shown = shown.chain(margins);
    let y = chart
        .y
        .span(shown.chain(fixed(Direction::Horizontal)), Padding::Loose)?;
    Ok([x, y])
}
