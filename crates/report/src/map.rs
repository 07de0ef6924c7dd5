//! Maps of outcomes: one coloured cell for each row and column, in groups of rows.
//!
//! Every category has a mark besides its colour, so that a map can be read without colours. Groups may have a line between
//! two columns, such as a bound beyond which something else is to be expected.

use crate::color::Color;
use crate::error::FigureError;
use crate::frame::{INK, LABEL_SIZE, OUTER, TICK_SIZE};
use crate::grid::{Grid, NAME_GAP};
use crate::legend;
pub use crate::legend::Category;
use crate::shape::{Anchor, Stroke, TextStyle};
use crate::svg::{Canvas, Svg};
use crate::text::{self, Weight};

/// Smallest width and the height of a cell \[px\].
const NARROWEST: f64 = 11.0;
const CELL_HEIGHT: f64 = 19.0;
const GROUP_HEIGHT: f64 = 25.0;

/// Rows that belong together, under a heading.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Group {
    /// Heading; may be empty.
    pub label: String,
    /// Name of each row, and the index of each cell's category; `None` leaves a cell empty.
    pub rows: Vec<(String, Vec<Option<usize>>)>,
    /// A line before the column with this index, with its name.
    pub divider: Option<(usize, String)>,
}

/// A map of outcomes.
#[derive(Debug, Clone, PartialEq)]
pub struct OutcomeMap {
    /// What the map shows.
    pub title: String,
    /// A second, smaller line; may be empty.
    pub subtitle: String,
    /// Name, symbol and unit of what the columns vary.
    pub x_label: String,
    /// Label of each column.
    pub columns: Vec<String>,
    /// Groups from top to bottom.
    pub groups: Vec<Group>,
    /// Categories; the legend shows those that occur, and of those with one name the first.
    pub categories: Vec<Category>,
    /// Width of the figure \[px\]; more if the columns need it.
    pub width: f64,
}

impl OutcomeMap {
    /// Draws the map.
    ///
    /// # Errors
    /// [`FigureError::NoData`] without a row or a column.
    pub fn render(&self) -> Result<Svg, FigureError> {
        if self.columns.is_empty() || self.groups.iter().all(|group| group.rows.is_empty()) {
            return Err(FigureError::NoData {
                axis: self.x_label.clone(),
            });
        }
        let grid = self.grid();
        let mut canvas = Canvas::default();
        grid.heading.draw(&mut canvas, [OUTER, OUTER]);
        let mut top = OUTER + grid.heading.height();
        for group in &self.groups {
            top = self.draw_group(&mut canvas, &grid, group, top);
        }
        let baseline = top + TICK_SIZE * 1.2;
        top = grid.draw_columns(&mut canvas, &self.columns, &self.x_label, baseline);
        let rows = self.groups.iter().flat_map(|group| &group.rows);
        let cells = rows.flat_map(|(_, cells)| cells);
        let met: Vec<usize> = cells.flatten().copied().collect();
        Ok(grid.finish(canvas, &self.categories, &met, (top, &self.title)))
    }

    fn grid(&self) -> Grid {
        let names = self.groups.iter().flat_map(|group| &group.rows);
        let widest = text::widest(names.map(|(name, _)| name.as_str()), TICK_SIZE);
        let left = OUTER + widest + NAME_GAP;
        let count = self.columns.len();
        let cell = ((self.width - left - OUTER) / count as f64).max(NARROWEST);
        Grid::new([&self.title, &self.subtitle], left, (count, cell), 0.0)
    }

    /// Draws a group below `top` and returns where it ends.
    fn draw_group(&self, canvas: &mut Canvas, grid: &Grid, group: &Group, top: f64) -> f64 {
        let headed = !group.label.is_empty() || group.divider.is_some();
        let first = top + if headed { GROUP_HEIGHT } else { 4.0 };
        if headed {
            let style = TextStyle::new(LABEL_SIZE, INK, Anchor::Start).bold();
            canvas.text([OUTER, first - 7.0], &group.label, &style);
        }
        let edge = Stroke::solid(Color::rgb(255, 255, 255), 1.0);
        for (index, (name, cells)) in group.rows.iter().enumerate() {
            let row = first + CELL_HEIGHT * index as f64;
            grid.draw_name(canvas, name, row + CELL_HEIGHT / 2.0);
            for (column, cell) in cells.iter().enumerate().take(self.columns.len()) {
                let area = grid.area(column, row, CELL_HEIGHT);
                match cell.and_then(|category| self.categories.get(category)) {
                    Some(category) => legend::draw_marked(canvas, &area, category, &edge),
                    None => canvas.rectangle(&area, Color::rgb(0xf6, 0xf6, 0xf6), Some(&edge)),
                }
            }
        }
        let bottom = first + CELL_HEIGHT * group.rows.len() as f64;
        if let Some((column, name)) = &group.divider {
            let x = grid.edge(*column);
            canvas.line(
                [x, first - 4.0],
                [x, bottom + 2.0],
                &Stroke::solid(INK, 2.0),
            );
            // The name stands on the side of the line that has room for it.
            let wide = text::width(name, TICK_SIZE, Weight::Regular) + 8.0;
            let (shift, anchor) = if x + wide > grid.width - OUTER {
                (-4.0, Anchor::End)
            } else {
                (4.0, Anchor::Start)
            };
            let style = TextStyle::new(TICK_SIZE, INK, anchor);
            canvas.text([x + shift, first - 6.0], name, &style);
        }
        bottom + 4.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map() -> OutcomeMap {
        let category = |label: &str, mark: &str, index| Category {
            label: label.into(),
            mark: mark.into(),
            color: Color::category(index),
        };
        OutcomeMap {
            title: "Friction".into(),
            subtitle: "one node".into(),
            x_label: "coefficient of friction μ [1]".into(),
            columns: vec!["0".into(), "1".into(), "2".into()],
            groups: vec![Group {
                label: "push".into(),
                rows: vec![("Newton".into(), vec![Some(0), Some(1), None])],
                divider: Some((2, "bound".into())),
            }],
            categories: vec![
                category("solved", "", 0),
                category("cycled", "c", 1),
                category("never met", "x", 2),
            ],
            width: 400.0,
        }
    }

    #[test]
    fn a_map_shows_its_cells_marks_and_the_categories_that_occur() {
        let svg = map().render().unwrap();
        let document = roxmltree::Document::parse(svg.as_str()).unwrap();
        let texts: Vec<&str> = document
            .descendants()
            .filter(|node| node.has_tag_name("text"))
            .filter_map(|node| node.text())
            .collect();
        for expected in [
            "Friction", "push", "Newton", "c", "bound", "solved", "cycled", "2",
        ] {
            assert!(texts.contains(&expected), "{expected}: {texts:?}");
        }
        assert!(!texts.contains(&"never met"));
        assert_eq!(svg, map().render().unwrap());
    }

    #[test]
    fn a_map_without_cells_is_refused() {
        let empty = OutcomeMap {
            columns: Vec::new(),
            ..map()
        };
        assert!(matches!(empty.render(), Err(FigureError::NoData { .. })));
        let empty = OutcomeMap {
            groups: vec![Group::default()],
            ..map()
        };
        assert!(empty.render().is_err());
    }
}
