//! The line along which a field has one value, straight within pieces of cells.

use super::patch::Patch;
use crate::color::Color;
use crate::frame::Frame;
use crate::markup::push_point;
use crate::shape::Stroke;
use crate::svg::Canvas;

const LINE: Color = Color::rgb(0xd0, 0x10, 0x10);
const WIDTH: f64 = 1.6;
/// Pieces along each side of a cell.
const CUTS: usize = 4;

/// Draws the line where the value of `patches` is `level`.
pub(crate) fn draw(canvas: &mut Canvas, frame: &Frame, patches: &[Patch], level: f64) {
    let mut data = String::new();
    for patch in patches {
        let above = |corner: &[f64; 3]| corner[2] > level;
        let corners = patch.corners();
        // Between its nodes a field departs little from their values.
        if corners.iter().all(above) || !corners.iter().any(above) {
            continue;
        }
        patch.pieces(CUTS, |piece| {
            for k in 1..piece.len() - 1 {
                if let Some(ends) = crossing([piece[0], piece[k], piece[k + 1]], level) {
                    add(&mut data, frame, ends);
                }
            }
        });
    }
    canvas.stroked_path(&data, &Stroke::solid(LINE, WIDTH));
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

fn add(data: &mut String, frame: &Frame, [from, to]: [[f64; 2]; 2]) {
    if let (Some(from), Some(to)) = (frame.pixel(from), frame.pixel(to)) {
        push_point(data, 'M', from);
        push_point(data, 'L', to);
    }
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
