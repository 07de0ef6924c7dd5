//! What maps have in common: columns of equal cells below a heading, their labels, and a legend.

use crate::frame::{Heading, INK, LABEL_SIZE, LINE_HEIGHT, OUTER, TICK_SIZE, TITLE_SIZE};
use crate::legend::{self, Category};
use crate::shape::{Anchor, Area, TextStyle};
use crate::svg::{Canvas, Svg};
use crate::text::{self, Weight};

/// Room between the name of a row and its first cell \[px\].
pub(crate) const NAME_GAP: f64 = 8.0;
/// Room between column labels \[px\].
const LABEL_ROOM: f64 = 5.0;

/// Columns of cells, placed.
#[derive(Debug)]
pub(crate) struct Grid {
    pub(crate) left: f64,
    pub(crate) width: f64,
    pub(crate) heading: Heading,
    cell: f64,
}

impl Grid {
    /// `count` columns of cells of the width `cell` from `left`, below the titles, in a figure of at least the width `least`.
    pub(crate) fn new(
        titles: [&str; 2],
        left: f64,
        (count, cell): (usize, f64),
        least: f64,
    ) -> Self {
        let width = (left + cell * count as f64 + OUTER).max(least);
        let [title, subtitle] = titles;
        Self {
            left,
            width,
            heading: Heading::new(title, TITLE_SIZE, &[subtitle], width - 2.0 * OUTER),
            cell,
        }
    }

    /// Where the column with an index begins.
    pub(crate) fn edge(&self, column: usize) -> f64 {
        self.left + self.cell * column as f64
    }

    pub(crate) fn area(&self, column: usize, top: f64, height: f64) -> Area {
        Area::new([self.edge(column), top], [self.cell, height])
    }

    /// Draws the name of a row with its middle at `y`.
    pub(crate) fn draw_name(&self, canvas: &mut Canvas, name: &str, y: f64) {
        let style = TextStyle::new(TICK_SIZE, INK, Anchor::End);
        canvas.centred_text([self.left - NAME_GAP, y], name, &style);
    }

    /// Draws column labels and what they mean; returns where they end.
    pub(crate) fn draw_columns(
        &self,
        canvas: &mut Canvas,
        labels: &[String],
        meaning: &str,
        baseline: f64,
    ) -> f64 {
        let style = TextStyle::new(TICK_SIZE, INK, Anchor::Middle);
        let mut free = f64::NEG_INFINITY;
        for (index, label) in labels.iter().enumerate() {
            let x = self.left + self.cell * (index as f64 + 0.5);
            let half = text::width(label, TICK_SIZE, Weight::Regular) / 2.0;
            if x - half >= free {
                canvas.text([x, baseline], label, &style);
                free = x + half + LABEL_ROOM;
            }
        }
        let middle = self.left + self.cell * labels.len() as f64 / 2.0;
        let at = [middle, baseline + LABEL_SIZE * LINE_HEIGHT + 4.0];
        let style = TextStyle::new(LABEL_SIZE, INK, Anchor::Middle);
        canvas.text(at, meaning, &style);
        at[1] + 6.0
    }

    /// Draws the legend of the categories that are `met`, below `top`, and finishes the map.
    pub(crate) fn finish(
        &self,
        mut canvas: Canvas,
        categories: &[Category],
        met: &[usize],
        (top, title): (f64, &str),
    ) -> Svg {
        let bottom = legend::draw(&mut canvas, categories, met, self.width, top + 10.0);
        canvas.finish(self.width, bottom + OUTER, title)
    }
}
