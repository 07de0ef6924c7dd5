//! The legend of maps: a swatch with its mark and a name for each category that occurs.

use crate::color::Color;
use crate::frame::{INK, MUTED, OUTER, TICK_SIZE};
use crate::shape::{Anchor, Area, Stroke, TextStyle};
use crate::svg::Canvas;
use crate::text::{self, Weight};

/// Size of a category's mark \[px\].
pub(crate) const MARK_SIZE: f64 = 9.5;
/// Height of a swatch and its least width \[px\].
const SWATCH: f64 = 16.0;
const ROW: f64 = 22.0;
const GAP: f64 = 20.0;

/// What a cell can say.
#[derive(Debug, Clone, PartialEq)]
pub struct Category {
    /// Name in the legend.
    pub label: String,
    /// One or two characters in the cell; may be empty.
    pub mark: String,
    /// Ground of the cell.
    pub color: Color,
}

/// Draws the categories with an index in `met` below `top`, in lines of `width`, of those with one name and colour the first; returns
/// where they end.
pub(crate) fn draw(
    canvas: &mut Canvas,
    categories: &[Category],
    met: &[usize],
    width: f64,
    top: f64,
) -> f64 {
    let style = TextStyle::new(TICK_SIZE, INK, Anchor::Start);
    let [mut left, mut line] = [OUTER, top];
    let mut named: Vec<(&str, Color)> = Vec::new();
    for (index, category) in categories.iter().enumerate() {
        let name = (category.label.as_str(), category.color);
        if !met.contains(&index) || named.contains(&name) {
            continue;
        }
        named.push(name);
        let marked = text::width(&category.mark, MARK_SIZE, Weight::Regular);
        let swatch = SWATCH.max(marked + 8.0);
        let needed = swatch + 6.0 + text::width(&category.label, TICK_SIZE, Weight::Regular);
        if left > OUTER && left + needed > width - OUTER {
            [left, line] = [OUTER, line + ROW];
        }
        let area = Area::new([left, line], [swatch, SWATCH]);
        draw_marked(canvas, &area, category, &Stroke::solid(MUTED, 0.5));
        let at = [left + swatch + 6.0, line + SWATCH / 2.0];
        canvas.centred_text(at, &category.label, &style);
        left += needed + GAP;
    }
    line + SWATCH
}

/// A cell in the category's colour with its mark in the middle.
pub(crate) fn draw_marked(canvas: &mut Canvas, area: &Area, category: &Category, edge: &Stroke) {
    canvas.rectangle(area, category.color, Some(edge));
    let style = TextStyle::new(MARK_SIZE, ink_on(category.color), Anchor::Middle);
    canvas.centred_text(area.middle(), &category.mark, &style);
}

/// Dark ink on light grounds, white on dark ones.
pub(crate) fn ink_on(ground: Color) -> Color {
    if ground.luminance() > 140.0 {
        INK
    } else {
        Color::rgb(255, 255, 255)
    }
}
