//! Cells of a mesh in the colours of categories, such as modes of failure, with a legend.

use crate::color::Color;
use crate::error::{FigureError, check_cells};
use crate::frame::{Frame, Heading, OUTER, TITLE_SIZE};
use crate::legend::{self, Category};
use crate::markup::push_point;
use crate::shape::{Area, Stroke};
use crate::svg::{Canvas, Svg};

const MESH: Color = Color::rgb(0xc4, 0xc4, 0xc4);
const GROUND: Color = Color::rgb(0xf4, 0xf4, 0xf4);

/// Cells by category.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshMap<'a> {
    /// What the picture shows.
    pub title: String,
    /// Names and units of the x and y axes.
    pub axes: [String; 2],
    /// Coordinates of the nodes \[length\].
    pub nodes: &'a [[f64; 2]],
    /// Node indices around each cell, mid-side nodes included, and the index of its category; `None` leaves it pale.
    pub cells: &'a [(Vec<usize>, Option<usize>)],
    /// Categories; the legend shows all of them, so that pictures compare.
    pub categories: &'a [Category],
    /// The part to show, `[x_low, x_high, y_low, y_high]` \[length\].
    pub window: [f64; 4],
    /// Width of the figure \[px\].
    pub width: f64,
}

impl MeshMap<'_> {
    /// Draws the map, with equal scales on both axes.
    ///
    /// # Errors
    /// [`FigureError::Cell`] for a cell with fewer than three nodes or nodes that do not exist, [`FigureError::Range`] and
    /// [`FigureError::Size`] for a window or width that cannot be drawn.
    pub fn render(&self) -> Result<Svg, FigureError> {
        let cells = self.cells.iter().map(|(cell, _)| cell);
        check_cells(&self.title, self.nodes.len(), cells)?;
        let heading = Heading::new(&self.title, TITLE_SIZE, &[], self.width - 2.0 * OUTER);
        let area = Area::new(
            [62.0, OUTER + heading.height()],
            [self.width - 62.0 - OUTER - 12.0, 0.0],
        );
        let frame = Frame::to_scale(&self.axes, self.window, area, (&self.title, self.width))?;
        let mut canvas = Canvas::default();
        heading.draw(&mut canvas, [OUTER, OUTER]);
        canvas.clipped(&frame.area, |canvas| self.draw_cells(canvas, &frame));
        frame.draw_axes(&mut canvas);
        let top = frame.area.bottom() + frame.bottom_margin() + 8.0;
        let all: Vec<usize> = (0..self.categories.len()).collect();
        let bottom = legend::draw(&mut canvas, self.categories, &all, self.width, top);
        Ok(canvas.finish(self.width, bottom + OUTER, &self.title))
    }

    fn draw_cells(&self, canvas: &mut Canvas, frame: &Frame) {
        let edge = Stroke::solid(MESH, 0.5);
        for (cell, category) in self.cells {
            let mut path = String::new();
            for (k, &node) in cell.iter().enumerate() {
                if let Some(pixel) = frame.pixel(self.nodes[node]) {
                    push_point(&mut path, if k == 0 { 'M' } else { 'L' }, pixel);
                }
            }
            path.push('Z');
            let known = category.and_then(|index| self.categories.get(index));
            let fill = known.map_or(GROUND, |category| category.color);
            canvas.filled_path(&path, fill, &edge);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_have_the_colours_of_their_categories() {
        let nodes = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let cells = [(vec![0, 1, 2], Some(0)), (vec![0, 2, 3], None)];
        let categories = [Category {
            label: "fibre, tension".into(),
            mark: String::new(),
            color: Color::rgb(0x12, 0x34, 0x56),
        }];
        let mut map = MeshMap {
            title: "0° ply".into(),
            axes: ["x [mm]".into(), "y [mm]".into()],
            nodes: &nodes,
            cells: &cells,
            categories: &categories,
            window: [0.0, 1.0, 0.0, 1.0],
            width: 300.0,
        };
        let svg = map.render().unwrap();
        // One cell and one swatch.
        assert_eq!(svg.as_str().matches("#123456").count(), 2);
        assert!(svg.as_str().contains("fibre, tension"));
        let broken = [(vec![0, 9, 1], None)];
        map.cells = &broken;
        assert!(matches!(
            map.render(),
            Err(FigureError::Cell { cell: 0, .. })
        ));
    }
}
