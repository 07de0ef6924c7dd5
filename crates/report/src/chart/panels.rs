//! Several figures in one picture.

use super::layout::{Layout, Margins};
use super::legend::LegendBox;
use super::{Legend, LineChart};
use crate::error::FigureError;
use crate::frame::{Heading, OUTER};
use crate::svg::{Canvas, Svg};

const GAP: f64 = 6.0;
/// Room above a common legend \[px\].
const LEGEND_GAP: f64 = 8.0;
/// The common title is larger than those of the parts.
const TITLE_SIZE: f64 = 18.0;

/// Charts in rows and columns whose frames line up.
#[derive(Debug, Clone, PartialEq)]
pub struct Panels {
    /// Title over all charts; may be empty.
    pub title: String,
    /// Number of columns; charts fill row after row.
    pub columns: usize,
    /// The charts, each with its own title and width.
    pub charts: Vec<LineChart>,
    /// Whether one legend below all charts, that of the first, stands for the legends of all.
    pub common_legend: bool,
}

impl Panels {
    /// Charts under a common title.
    pub fn new(title: impl Into<String>, columns: usize, charts: Vec<LineChart>) -> Self {
        Self {
            title: title.into(),
            columns,
            charts,
            common_legend: false,
        }
    }

    /// One legend below all charts, that of the first: for charts with the same series in the same order.
    #[must_use]
    pub fn with_common_legend(mut self) -> Self {
        for chart in &mut self.charts {
            chart.legend = Legend::Hidden;
        }
        self.common_legend = true;
        self
    }

    /// Draws all charts. Charts of one column share their left and right margins,
    /// charts of one row their upper margin.
    ///
    /// # Errors
    /// Those of [`LineChart::render`], and [`FigureError::NoPanels`].
    pub fn render(&self) -> Result<Svg, FigureError> {
        let columns = self.columns.max(1);
        let mut column_margins = vec![Margins::default(); columns];
        let mut row_tops = vec![0.0_f64; self.charts.len().div_ceil(columns)];
        for (index, chart) in self.charts.iter().enumerate() {
            let margins = Layout::new(chart, Margins::default())?.margins(chart.width);
            let shared = &mut column_margins[index % columns];
            *shared = shared.covering(Margins {
                top: 0.0,
                ..margins
            });
            let top = &mut row_tops[index / columns];
            *top = top.max(margins.top);
        }
        let mut pictures = Vec::with_capacity(self.charts.len());
        for (index, chart) in self.charts.iter().enumerate() {
            let least = Margins {
                top: row_tops[index / columns],
                ..column_margins[index % columns]
            };
            pictures.push(chart.draw(&Layout::new(chart, least)?));
        }
        let legend = self
            .charts
            .first()
            .filter(|_| self.common_legend)
            .and_then(|chart| LegendBox::new(chart, &[]));
        place(&self.title, self.columns, &pictures, legend)
    }
}

/// Places finished pictures in rows of `columns` under a common title.
///
/// # Errors
/// [`FigureError::NoPanels`] without pictures or columns.
pub fn tile(title: &str, columns: usize, pictures: &[Svg]) -> Result<Svg, FigureError> {
    place(title, columns, pictures, None)
}

fn place(
    title: &str,
    columns: usize,
    pictures: &[Svg],
    legend: Option<LegendBox>,
) -> Result<Svg, FigureError> {
    if columns == 0 || pictures.is_empty() {
        let panels = pictures.len();
        return Err(FigureError::NoPanels {
            title: title.to_owned(),
            panels,
            columns,
        });
    }
    let columns = columns.min(pictures.len());
    let mut widths = vec![0.0_f64; columns];
    for (index, picture) in pictures.iter().enumerate() {
        widths[index % columns] = widths[index % columns].max(picture.width());
    }
    let width = widths.iter().sum::<f64>() + GAP * (columns - 1) as f64;
    let heading = Heading::new(title, TITLE_SIZE, &[], width - 2.0 * OUTER);
    let mut canvas = Canvas::default();
    heading.draw(&mut canvas, [OUTER, OUTER]);
    let mut top = if heading.height() > 0.0 {
        OUTER + heading.height()
    } else {
        0.0
    };
    for row in pictures.chunks(columns) {
        let mut left = 0.0;
        for (picture, width) in row.iter().zip(&widths) {
            canvas.place([left, top], picture);
            left += width + GAP;
        }
        top += row.iter().map(Svg::height).fold(0.0, f64::max) + GAP;
    }
    let mut height = top - GAP;
    if let Some(mut legend) = legend {
        legend.spread(width - 2.0 * OUTER);
        legend.draw(&mut canvas, [OUTER, height + LEGEND_GAP]);
        height += LEGEND_GAP + legend.size()[1] + OUTER;
    }
    Ok(canvas.finish(width, height, title))
}
