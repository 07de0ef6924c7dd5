//! Several figures in one picture.

use super::layout::{Layout, Margins};
use super::legend::LegendBox;
use super::{Legend, LineChart};
use crate::error::FigureError;
use crate::frame::{Heading, OUTER};
use crate::svg::{Canvas, Svg};

const GAP: f64 = 6.0;
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
    /// Whether the legend of the first chart stands below all of them, in place of their own.
    pub common_legend: bool,
}

impl Panels {
    /// Puts charts under a common title, `columns` side by side.
    pub fn new(title: impl Into<String>, columns: usize, charts: Vec<LineChart>) -> Self {
        Self {
            title: title.into(),
            columns,
            charts,
            common_legend: false,
        }
    }

    /// Shows one legend, that of the first chart, below all charts.
    #[must_use]
    pub fn common_legend(mut self) -> Self {
        self.common_legend = true;
        self
    }

    /// Draws all charts. All share their left and right margins, so that charts of equal width have frames of equal width;
    /// charts of one row share their upper margin.
    ///
    /// # Errors
    /// Those of [`LineChart::render`], and [`FigureError::NoPanels`].
    pub fn render(&self) -> Result<Svg, FigureError> {
        let columns = self.columns.max(1);
        let mut charts = self.charts.clone();
        let legend = charts
            .first()
            .filter(|_| self.common_legend)
            .and_then(|first| LegendBox::new(first, &[]));
        if self.common_legend {
            for chart in &mut charts {
                chart.legend = Legend::Hidden;
            }
        }
        let mut sides = Margins::default();
        let mut row_tops = vec![0.0_f64; charts.len().div_ceil(columns)];
        for (index, chart) in charts.iter().enumerate() {
            let margins = Layout::new(chart, Margins::default())?.margins(chart.width);
            sides = sides.covering(Margins {
                top: 0.0,
                ..margins
            });
            let top = &mut row_tops[index / columns];
            *top = top.max(margins.top);
        }
        let mut pictures = Vec::with_capacity(charts.len());
        for (index, chart) in charts.iter().enumerate() {
            let least = Margins {
                top: row_tops[index / columns],
                ..sides
            };
            pictures.push(chart.draw(&Layout::new(chart, least)?));
        }
        tile_above(&self.title, self.columns, &pictures, legend, sides.left)
    }
}

/// Places finished pictures in rows of `columns` under a common title.
///
/// # Errors
/// [`FigureError::NoPanels`] without pictures or columns.
pub fn tile(title: &str, columns: usize, pictures: &[Svg]) -> Result<Svg, FigureError> {
    tile_above(title, columns, pictures, None, OUTER)
}

/// Pictures in rows of `columns`, and below them a legend that starts at `left`.
fn tile_above(
    title: &str,
    columns: usize,
    pictures: &[Svg],
    legend: Option<LegendBox>,
    left: f64,
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
        let mut across = 0.0;
        for (picture, width) in row.iter().zip(&widths) {
            canvas.place([across, top], picture);
            across += width + GAP;
        }
        top += row.iter().map(Svg::height).fold(0.0, f64::max) + GAP;
    }
    let mut height = top - GAP;
    if let Some(mut legend) = legend {
        legend.spread(width - OUTER - left);
        legend.draw(&mut canvas, [left, height]);
        height += legend.size()[1] + OUTER;
    }
    Ok(canvas.finish(width, height, title))
}
