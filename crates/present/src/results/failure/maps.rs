//! Pictures of the failure index over a body, ply by ply; of a half model both halves, because a ply and its mirror image differ.

use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_report::axis::extent;
use stickslip_report::chart::tile;
use stickslip_report::field::FieldPlot;

use super::{FailureView, criterion_name};
use crate::results::attempt::Attempt;
use crate::results::figures::fields::{around, distance, drawn, is_within};
use stickslip_results::{EdgeGeometry, EdgeKind, PlyMap};
use stickslip_text::significant;

/// Half of the window around a hole, in radii.
const WINDOW: f64 = 2.5;
/// Width of one picture of several in a row `[px]`.
const WIDTH: f64 = 520.0;

/// One picture per ply at the step of the map, with equal colours.
pub(crate) fn index_map(view: &FailureView<'_>, map: &PlyMap) -> Attempt {
    let (Some(mesh), Some(criterion)) = (
        &view.results.bodies[view.failure.body].mesh,
        view.failure.criteria.first(),
    ) else {
        return Ok(None);
    };
    let values = map.index.first().map_or(0, Vec::len);
    let whole = values == 2 * mesh.nodes().len();
    let (nodes, cells) = drawn_mesh(view, mesh, whole);
    let window = window(view, &nodes);
    let largest = largest(map, &nodes, window);
    let unit = view.results.units.length.name;
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
    let pictures = map.index.iter().enumerate().map(picture);
    let pictures = pictures.collect::<Result<Vec<_>, _>>()?;
    let name = criterion_name(criterion);
    let load = view.load().step_text(map.step);
    let title = format!("Failure index of '{}', {name}, at {load}", view.body());
    let columns = if pictures.len() == 4 { 2 } else { 3 };
    let caption = format!(
        "Index by {name} in each ply of {}; a ply fails where it is 1. The largest in sight is {}, and all pictures have its colours.{}",
        view.failure.layup,
        significant(largest, 4),
        if whole {
            " One half is modelled; the other is computed from its mirror image."
        } else {
            ""
        }
    );
    Ok(Some((tile(&title, columns, &pictures)?, caption)))
}

/// Nodes in display units and the loops of nodes around cells, of a half model as a `whole` with its mirror image.
fn drawn_mesh(view: &FailureView<'_>, mesh: &Mesh, whole: bool) -> (Vec<Point>, Vec<Vec<usize>>) {
    let shown = |node: &Point| node.map(|x| view.length(x));
    let mut nodes: Vec<Point> = mesh.nodes().iter().map(shown).collect();
    let mut cells: Vec<Vec<usize>> = (0..mesh.element_count())
        .flat_map(|cell| drawn(mesh, cell, 0))
        .collect();
    if whole {
        let across = mirror_axis(view);
        let images: Vec<Point> = nodes.iter().map(|node| mirrored(*node, across)).collect();
        // Nodes on the line of symmetry join the halves.
        let image = |&node: &usize| {
            if nodes[node][across] == 0.0 {
                node
            } else {
                node + images.len()
            }
        };
        let turned = |cell: &Vec<usize>| cell.iter().map(image).collect();
        let turned: Vec<Vec<usize>> = cells.iter().map(turned).collect();
        cells.extend(turned);
        nodes.extend(images);
    }
    (nodes, cells)
}

/// Coordinate in which the halves differ: y around a hole, x at a line.
fn mirror_axis(view: &FailureView<'_>) -> usize {
    let round = |edge: &EdgeGeometry| matches!(edge.kind, EdgeKind::Circle { .. });
    usize::from(view.failure.centre.is_some() || view.results.edges.iter().any(round))
}

fn mirrored(mut node: Point, axis: usize) -> Point {
    node[axis] = -node[axis];
    node
}

/// The neighbourhood of the hole, or the whole body `[display unit]`.
fn window(view: &FailureView<'_>, nodes: &[Point]) -> [f64; 4] {
    let all = extent(nodes.iter().copied());
    let Some(centre) = view.failure.centre else {
        return all;
    };
    let centre = centre.map(|x| view.length(x));
    let reach = WINDOW * distance(nodes, centre);
    around(all, centre, [reach; 2])
}

fn largest(map: &PlyMap, nodes: &[Point], window: [f64; 4]) -> f64 {
    let values = map.index.iter().flat_map(|values| values.iter().zip(nodes));
    let shown = values.filter(|(_, node)| is_within(window, node));
    shown.map(|(value, _)| *value).fold(0.0, f64::max)
}
