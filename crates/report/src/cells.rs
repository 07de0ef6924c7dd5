//! Maps over two variables: one coloured cell with a number for each pair of values.
//!
//! The colour and a mark say what kind of outcome a cell is, the number how much; the first row stands at the bottom, as values do
//! along an axis.

use crate::color::Color;
use crate::error::FigureError;
use crate::frame::{INK, LABEL_SIZE, LINE_HEIGHT, OUTER, TICK_SIZE};
use crate::grid::{Grid, NAME_GAP};
use crate::legend::{Category, MARK_SIZE, ink_on};
use crate::shape::{Anchor, Area, Stroke, TextStyle};
use crate::svg::{Canvas, Svg};
use crate::text;

/// Smallest width of a cell, and its height \[px\].
const NARROWEST: f64 = 34.0;
const HEIGHT: f64 = 38.0;
/// Widest cell \[px\]: a map of few columns need not fill the figure.
const WIDEST: f64 = 110.0;

/// One cell.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Cell {
    /// Index of its category; `None` leaves it grey.
    pub category: Option<usize>,
    /// What it says, such as a number; may be empty.
    pub text: String,
}

/// A map over two variables.
#[derive(Debug, Clone, PartialEq)]
pub struct CellMap {
    /// What the map shows.
    pub title: String,
    /// A second, smaller line; may be empty.
    pub subtitle: String,
    /// Name, symbol and unit of what the columns vary.
    pub x_label: String,
    /// The same of the rows; may be empty.
    pub y_label: String,
    /// Label of each column.
    pub columns: Vec<String>,
    /// Label and cells of each row, from the bottom.
    pub rows: Vec<(String, Vec<Cell>)>,
    /// Categories; the legend shows those that occur.
    pub categories: Vec<Category>,
    /// Width of the figure \[px\]; more if the columns need it.
    pub width: f64,
}

impl CellMap {
    /// Draws the map.
    ///
    /// # Errors
    /// [`FigureError::NoData`] without a row or a column.
    pub fn render(&self) -> Result<Svg, FigureError> {
        if self.columns.is_empty() || self.rows.is_empty() {
            return Err(FigureError::NoData {
                axis: self.x_label.clone(),
            });
        }
        let grid = self.grid();
        let mut canvas = Canvas::default();
        grid.heading.draw(&mut canvas, [OUTER, OUTER]);
        let top = OUTER + grid.heading.height() + 4.0;
        self.draw_rows(&mut canvas, &grid, top);
        let baseline = top + HEIGHT * self.rows.len() as f64 + TICK_SIZE * 1.4;
        let bottom = grid.draw_columns(&mut canvas, &self.columns, &self.x_label, baseline);
        let cells = self.rows.iter().flat_map(|(_, cells)| cells);
        let met: Vec<usize> = cells.filter_map(|cell| cell.category).collect();
        Ok(grid.finish(canvas, &self.categories, &met, (bottom, &self.title)))
    }

    fn grid(&self) -> Grid {
        let names = self.rows.iter().map(|(name, _)| name.as_str());
        let label = if self.y_label.is_empty() {
            0.0
        } else {
            LABEL_SIZE * LINE_HEIGHT
        };
        let left = OUTER + label + text::widest(names, TICK_SIZE) + NAME_GAP;
        let cells = self.rows.iter().flat_map(|(_, cells)| cells);
        let texts = cells.map(|cell| cell.text.as_str());
        let texts = texts.chain(self.columns.iter().map(String::as_str));
        let needed = text::widest(texts, TICK_SIZE) + 8.0;
        let count = self.columns.len();
        let room = (self.width - left - OUTER) / count as f64;
        let cell = room.clamp(NARROWEST, WIDEST).max(needed);
        let titles = [self.title.as_str(), &self.subtitle];
        Grid::new(titles, left, (count, cell), self.width)
    }

    fn draw_rows(&self, canvas: &mut Canvas, grid: &Grid, first: f64) {
        for (index, (name, cells)) in self.rows.iter().rev().enumerate() {
            let top = first + HEIGHT * index as f64;
            grid.draw_name(canvas, name, top + HEIGHT / 2.0);
            for (column, cell) in cells.iter().enumerate().take(self.columns.len()) {
                let category = cell.category.and_then(|index| self.categories.get(index));
                draw_cell(
                    canvas,
                    &grid.area(column, top, HEIGHT),
                    category,
                    &cell.text,
                );
            }
        }
        if !self.y_label.is_empty() {
            let middle = first + HEIGHT * self.rows.len() as f64 / 2.0;
            let style = TextStyle::new(LABEL_SIZE, INK, Anchor::Middle).upwards();
            canvas.text([OUTER + LABEL_SIZE, middle], &self.y_label, &style);
        }
    }
}

/// The number above the mark.
fn draw_cell(canvas: &mut Canvas, area: &Area, category: Option<&Category>, text: &str) {
    let ground = category.map_or(Color::rgb(0xee, 0xee, 0xee), |category| category.color);
    let edge = Stroke::solid(Color::rgb(255, 255, 255), 1.0);
    canvas.rectangle(area, ground, Some(&edge));
    let [x, y] = area.middle();
    let mark = category.map_or("", |category| category.mark.as_str());
    let number = TextStyle::new(TICK_SIZE, ink_on(ground), Anchor::Middle);
    if mark.is_empty() {
        canvas.centred_text([x, y], text, &number);
        return;
    }
    canvas.centred_text([x, y - 6.0], text, &number);
    let small = TextStyle::new(MARK_SIZE, ink_on(ground), Anchor::Middle);
    canvas.centred_text([x, y + 9.0], mark, &small);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map() -> CellMap {
        let category = |label: &str, mark: &str, index| Category {
            label: label.into(),
            mark: mark.into(),
            color: Color::category(index),
        };
        let cell = |category, text: &str| Cell {
            category,
            text: text.into(),
        };
        CellMap {
            title: "Modes".into(),
            subtitle: "loads in kN".into(),
            x_label: "e/D".into(),
            y_label: "W/D".into(),
            columns: vec!["1".into(), "2".into()],
            rows: vec![
                ("3".into(), vec![cell(Some(0), "1.5"), cell(Some(1), "2.5")]),
                ("4".into(), vec![cell(Some(1), "3.5"), cell(None, "")]),
            ],
            categories: vec![
                category("bearing", "B", 0),
                category("shear-out", "S", 1),
                category("net tension", "T", 2),
            ],
            width: 400.0,
        }
    }

    #[test]
    fn a_map_shows_numbers_marks_and_the_categories_that_occur() {
        let svg = map().render().unwrap();
        let document = roxmltree::Document::parse(svg.as_str()).unwrap();
        let texts: Vec<(&str, f64)> = document
            .descendants()
            .filter(|node| node.has_tag_name("text"))
            .filter_map(|node| Some((node.text()?, node.attribute("y")?.parse().ok()?)))
            .collect();
        let height = |wanted: &str| {
            texts
                .iter()
                .find(|(text, _)| *text == wanted)
                .map(|at| at.1)
        };
        for expected in ["Modes", "e/D", "W/D", "1.5", "2.5", "3.5", "bearing", "S"] {
            assert!(height(expected).is_some(), "{expected}: {texts:?}");
        }
        assert_eq!(height("net tension"), None);
        // The first row is the lowest.
        assert!(height("1.5") > height("3.5"));
        assert_eq!(svg, map().render().unwrap());
    }

    #[test]
    fn a_map_without_cells_is_refused() {
        let empty = CellMap {
            rows: Vec::new(),
            ..map()
        };
        assert!(matches!(empty.render(), Err(FigureError::NoData { .. })));
    }
}
