//! Outlines of bodies and mesh lines. An edge that only one cell has is on an outline.

use std::collections::HashMap;

use super::FieldPlot;
use crate::color::Color;
use crate::frame::Frame;
use crate::markup::push_point;
use crate::shape::Stroke;
use crate::svg::Canvas;

const OUTLINE: Color = Color::rgb(0x22, 0x22, 0x22);
const MESH: Color = Color::rgb(0x44, 0x44, 0x44);
/// Mesh lines are drawn for cells of at least this mean size \[px\].
const SMALLEST_CELL: f64 = 3.0;

/// An edge from corner to corner, with its mid-side node if it is quadratic.
#[derive(Debug, Clone, Copy)]
struct Edge {
    ends: [usize; 2],
    middle: Option<usize>,
}

impl Edge {
    fn key(self) -> (usize, usize) {
        let [a, b] = self.ends;
        (a.min(b), a.max(b))
    }
}

fn edges(cell: &[usize]) -> Vec<Edge> {
    let count = cell.len();
    if count == 6 || count == 8 {
        let edge = |k: usize| Edge {
            ends: [cell[k], cell[(k + 2) % count]],
            middle: Some(cell[k + 1]),
        };
        (0..count).step_by(2).map(edge).collect()
    } else {
        let edge = |k: usize| Edge {
            ends: [cell[k], cell[(k + 1) % count]],
            middle: None,
        };
        (0..count).map(edge).collect()
    }
}

/// Draws the outlines, and under them the mesh lines if the plot asks for them and its
/// `visible` patches are large enough.
pub(crate) fn draw(canvas: &mut Canvas, plot: &FieldPlot<'_>, frame: &Frame, visible: usize) {
    let mut uses: HashMap<(usize, usize), usize> = HashMap::new();
    for edge in plot.cells.iter().flat_map(|cell| edges(cell)) {
        *uses.entry(edge.key()).or_default() += 1;
    }
    let (mut outline, mut mesh) = (String::new(), String::new());
    for edge in plot.cells.iter().flat_map(|cell| edges(cell)) {
        // The entry was made above; a second cell's edge finds it gone.
        let Some(count) = uses.remove(&edge.key()) else {
            continue;
        };
        let image = plot.mirror.map(|[x, y, _]| [x, y]);
        let stays = |factors: [f64; 2]| {
            let on_axis = |&node: &usize| scaled(plot.nodes[node], factors) == plot.nodes[node];
            edge.ends.iter().all(on_axis)
        };
        let inside = count > 1 || image.is_some_and(stays);
        let data = if inside { &mut mesh } else { &mut outline };
        add_edge(data, plot, frame, edge, [1.0; 2]);
        if let Some(factors) = image.filter(|&factors| !stays(factors)) {
            add_edge(data, plot, frame, edge, factors);
        }
    }
    let cell = (frame.area.width * frame.area.height / visible.max(1) as f64).sqrt();
    if plot.draw_mesh && cell >= SMALLEST_CELL {
        canvas.stroked_path(&mesh, &Stroke::solid(MESH, (cell / 40.0).clamp(0.15, 0.5)));
    }
    canvas.stroked_path(&outline, &Stroke::solid(OUTLINE, 1.0));
}

fn scaled([x, y]: [f64; 2], factors: [f64; 2]) -> [f64; 2] {
    [factors[0] * x, factors[1] * y]
}

/// Appends one edge, with x and y times `factors`. The parabola through a mid-side node is the
/// quadratic Bézier curve with control point 2 m − (a + b) / 2.
fn add_edge(data: &mut String, plot: &FieldPlot<'_>, frame: &Frame, edge: Edge, factors: [f64; 2]) {
    let pixel = |node: usize| frame.pixel(scaled(plot.nodes[node], factors));
    let (Some(a), Some(b)) = (pixel(edge.ends[0]), pixel(edge.ends[1])) else {
        return;
    };
    let middle = edge.middle.and_then(pixel);
    let shown = frame.area.grown(2.0);
    let reaches = |axis: usize, low: f64, high: f64| {
        let along = [a[axis], b[axis], middle.map_or(a[axis], |m| m[axis])];
        along.iter().any(|v| *v >= low) && along.iter().any(|v| *v <= high)
    };
    if !reaches(0, shown.left, shown.right()) || !reaches(1, shown.top, shown.bottom()) {
        return;
    }
    push_point(data, 'M', a);
    match middle {
        Some(m) => {
            push_point(
                data,
                'Q',
                std::array::from_fn(|k| 2.0 * m[k] - 0.5 * (a[k] + b[k])),
            );
            push_point(data, ' ', b);
        }
        None => push_point(data, 'L', b),
    }
}
