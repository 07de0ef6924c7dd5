//! Line charts: curves over one variable, with shaded zones, reference lines and a
//! legend that stays off the curves.
//!
//! Text never stands on data: names of bands and vertical lines stand above the
//! frame, names of horizontal lines to its right, and the legend goes inside only
//! where it finds an empty place.
//!
//! This module draws for itself, with the same frame that [`field`](crate::field)
//! needs, because the plotting crates tried would have misled a reader: plotters
//! 0.3.7 moves points outside the range onto the frame, and kuva 0.6.0 numbers its
//! clip paths by a global counter (equal charts differ in their bytes), writes NaN
//! into paths and mixes `0.0020` with `1e-2` on log axes.

mod annotations;
mod curves;
mod layout;
mod legend;
mod line_chart;
mod panels;

pub use line_chart::{
    Band, Dash, Direction, Legend, LineChart, ReferenceLine, Series, SeriesStyle,
};
pub use panels::{Panels, tile};

use crate::error::FigureError;
use crate::frame::OUTER;
use crate::svg::{Canvas, Svg};
use layout::{Layout, Margins};

impl LineChart {
    /// Draws the chart.
    ///
    /// # Errors
    /// [`FigureError::NoData`] if an axis without a range has no value to show,
    /// [`FigureError::Range`] and [`FigureError::TickSpacing`] for an axis that cannot
    /// be drawn, [`FigureError::Size`] if there is no room.
    pub fn render(&self) -> Result<Svg, FigureError> {
        Ok(self.draw(&Layout::new(self, Margins::default())?))
    }

    fn draw(&self, layout: &Layout) -> Svg {
        let mut canvas = Canvas::default();
        let frame = &layout.frame;
        layout.heading.draw(&mut canvas, [OUTER, OUTER]);
        layout.annotations.draw_bands(&mut canvas, frame);
        if self.series.iter().any(|series| !series.margin.is_empty()) {
            canvas.clipped(&frame.area, |canvas| {
                for (index, series) in self.series.iter().enumerate() {
                    curves::draw_margin(canvas, frame, series, self.color_of(index));
                }
            });
        }
        frame.draw_grid(&mut canvas);
        layout.annotations.draw_lines(&mut canvas, frame);
        canvas.clipped(&frame.area, |canvas| {
            for (index, series) in self.series.iter().enumerate() {
                curves::draw_line(canvas, frame, series, self.color_of(index));
                curves::draw_spread(canvas, frame, series, self.color_of(index));
            }
        });
        frame.draw_axes(&mut canvas);
        for (index, series) in self.series.iter().enumerate() {
            curves::draw_markers(&mut canvas, frame, series, self.color_of(index), index);
        }
        layout.annotations.draw_labels(&mut canvas, frame);
        if let Some((legend, at)) = &layout.legend {
            legend.draw(&mut canvas, *at);
        }
        canvas.finish(self.width, layout.height, &self.title)
    }
}
