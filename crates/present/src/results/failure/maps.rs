//! Pictures of the failure index over a body, ply by ply; of a half model both halves, because a ply and its mirror image differ.

use stickslip_fem_core::mesh::Point;
use stickslip_report::chart::tile;
use stickslip_report::field::FieldPlot;

use super::{FailureView, criterion_name};
use crate::results::attempt::Attempt;
use crate::results::figures::fields::drawn;
use stickslip_engine::results::{EdgeKind, PlyMap};
use stickslip_text::significant;

/// Half of the window around a hole, in radii.
const WINDOW: f64 = 2.5;
/// Width of one picture of several in a row `[px]`.
const WIDTH: f64 = 520.0;

/// One picture per ply at the step of the map, with equal colours.
pub(crate) fn index_map(view: &FailureView<'_>, map: &PlyMap) -> Attempt {
    let results = view.results;
    let (Some(mesh), Some(criterion)) = (
        &results.bodies[view.failure.body].mesh,
        view.failure.criteria.first(),
    ) else {
        return Ok(None);
    };
    let count = mesh.nodes().len();
    let halves = map
        .index
        .first()
        .map_or(1, |values| values.len() / count.max(1));
    let across = mirror_axis(view);
    let mut nodes: Vec<Point> = mesh
        .nodes()
        .iter()
        .map(|node| node.map(|x| view.length(x)))
        .collect();
    let mut cells: Vec<Vec<usize>> = (0..mesh.element_count())
        .flat_map(|cell| drawn(mesh, cell, 0))
        .collect();
    if halves == 2 {
        let images: Vec<Point> = nodes.iter().map(|node| mirrored(*node, across)).collect();
        // Nodes on the line of symmetry join the halves.
        let image = |node: &usize| {
            if nodes[*node][across] == 0.0 {
                *node
            } else {
                node + count
            }
        };
        let turned: Vec<Vec<usize>> = cells
            .iter()
            .map(|cell| cell.iter().map(image).collect())
            .collect();
        cells.extend(turned);
        nodes.extend(images);
    }
    let window = window(view, &nodes);
    let largest = largest(map, &nodes, window);
    let name = criterion_name(criterion);
    let unit = results.units.length.name;
    let picture = |(group, values): (usize, &Vec<f64>)| {
        let title = format!("{} ply", view.failure.ply_name(group));
        let mut plot =
            FieldPlot::new(title, "index [–]", unit, &nodes, &cells, values).window(window);
        if largest > 0.0 {
            plot = plot.between(0.0, largest);
        }
        plot.width = WIDTH;
        plot.render()
    };
    let pictures = map
        .index
        .iter()
        .enumerate()
        .map(picture)
        .collect::<Result<Vec<_>, _>>()?;
    let load = view.load().step_text(map.step);
    let title = format!("Failure index of '{}', {name}, at {load}", view.body());
    let columns = if pictures.len() == 4 { 2 } else { 3 };
    let caption = format!(
        "Index by {name} in each ply of {}; a ply fails where it is 1. The largest in sight is {}, and all pictures have its colours.{}",
        view.failure.layup,
        significant(largest, 4),
        if halves == 2 {
            " One half is modelled; the other is computed from its mirror image."
        } else {
            ""
        }
    );
    Ok(Some((tile(&title, columns, &pictures)?, caption)))
}

/// Coordinate in which the halves differ: y around a hole, x at a line.
fn mirror_axis(view: &FailureView<'_>) -> usize {
    let round = |edge: &stickslip_engine::results::EdgeGeometry| {
        matches!(edge.kind, EdgeKind::Circle { .. })
    };
    usize::from(view.failure.centre.is_some() || view.results.edges.iter().any(round))
}

fn mirrored(mut node: Point, axis: usize) -> Point {
    node[axis] = -node[axis];
    node
}

/// The neighbourhood of the hole, or the whole body `[display unit]`.
fn window(view: &FailureView<'_>, nodes: &[Point]) -> [f64; 4] {
    let ends = |axis: usize| {
        let along = nodes.iter().map(|node| node[axis]);
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
            [low.min(x), high.max(x)]
        })
    };
    let ([left, right], [bottom, top]) = (ends(0), ends(1));
    let Some(centre) = view.failure.centre else {
        return [left, right, bottom, top];
    };
    let centre = centre.map(|x| view.length(x));
    let distance = |node: &Point| (node[0] - centre[0]).hypot(node[1] - centre[1]);
    let radius = nodes.iter().map(distance).fold(f64::INFINITY, f64::min);
    let reach = WINDOW * radius;
    [
        left.max(centre[0] - reach),
        right.min(centre[0] + reach),
        bottom.max(centre[1] - reach),
        top.min(centre[1] + reach),
    ]
}

fn largest(map: &PlyMap, nodes: &[Point], [left, right, bottom, top]: [f64; 4]) -> f64 {
    let seen =
        |node: &Point| (left..=right).contains(&node[0]) && (bottom..=top).contains(&node[1]);
    let values = map.index.iter().flat_map(|values| values.iter().zip(nodes));
    let shown = values
        .filter(|(_, node)| seen(node))
        .map(|(value, _)| *value);
    shown.fold(0.0, f64::max)
}
