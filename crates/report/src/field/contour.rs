//! The line along which a field has one value, straight within pieces of cells.

use crate::color::Color;
use crate::frame::Frame;
use crate::markup::push_point;
use crate::shape::Stroke;
use crate::svg::Canvas;

const LINE: Color = Color::rgb(0xd0, 0x10, 0x10);
const WIDTH: f64 = 1.6;
/// Pieces along each side of a cell whose nodes lie on both sides of the line.
pub(crate) const CUTS: usize = 4;

/// The line along which a field has the value `level`.
pub(crate) struct Contour<'a> {
    frame: &'a Frame,
    level: f64,
    data: String,
}

impl<'a> Contour<'a> {
    pub(crate) fn new(frame: &'a Frame, level: f64) -> Self {
        Self {
            frame,
            level,
            data: String::new(),
        }
    }

    /// Whether corners (x, y, value) lie on both sides of the line.
    pub(crate) fn meets(&self, corners: &[[f64; 3]]) -> bool {
        let above = |corner: &[f64; 3]| corner[2] > self.level;
        corners.iter().any(above) && !corners.iter().all(above)
    }

    /// Adds what lies in a convex piece of corners (x, y, value).
    pub(crate) fn add(&mut self, piece: &[[f64; 3]]) {
        for k in 1..piece.len() - 1 {
            let triangle = [piece[0], piece[k], piece[k + 1]];
            let Some(ends) = crossing(triangle, self.level) else {
                continue;
            };
            if let [Some(from), Some(to)] = ends.map(|end| self.frame.pixel(end)) {
                push_point(&mut self.data, 'M', from);
                push_point(&mut self.data, 'L', to);
            }
        }
    }

    pub(crate) fn draw(&self, canvas: &mut Canvas) {
        canvas.stroked_path(&self.data, &Stroke::solid(LINE, WIDTH));
    }
}

/// Where `level` crosses a triangle of corners (x, y, value).
fn crossing(triangle: [[f64; 3]; 3], level: f64) -> Option<[[f64; 2]; 2]> {
    let sides = (0..3).map(|k| [triangle[k], triangle[(k + 1) % 3]]);
    let mut ends = sides.filter_map(|[a, b]| {
        if (a[2] > level) == (b[2] > level) {
            return None;
        }
        let part = (level - a[2]) / (b[2] - a[2]);
        let point = [0, 1].map(|k| a[k] + part * (b[k] - a[k]));
        point.iter().all(|x| x.is_finite()).then_some(point)
    });
    Some([ends.next()?, ends.next()?])
}

#[cfg(test)]
mod tests {
    use super::crossing;

    #[test]
    fn a_level_crosses_two_sides_of_a_triangle() {
        let triangle = [[0.0, 0.0, 0.0], [2.0, 0.0, 2.0], [0.0, 2.0, 0.0]];
        assert_eq!(crossing(triangle, 1.0), Some([[1.0, 0.0], [1.0, 1.0]]));
        assert_eq!(crossing(triangle, 2.5), None);
    }
}
