//! Pictures of the damage at the end of a history, ply by ply; of a half model both halves.

use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_laminate::FailureMode;
use stickslip_report::axis::extent;
use stickslip_report::chart::tile;
use stickslip_report::color::Color;
use stickslip_report::map::Category;
use stickslip_report::mesh_map::MeshMap;

use super::ProgressiveView;
use crate::results::attempt::Attempt;
use crate::results::figures::fields::{around, distance, drawn};
use stickslip_results::ProgressiveFailure;
use stickslip_text::significant;

/// Room around the damage and the hole, in radii.
const ROOM: f64 = 0.5;
/// Half of the smallest window, in radii.
const WINDOW: f64 = 2.0;
const WIDTH: f64 = 480.0;

/// What a cell can show, from what outranks all others.
const MODES: [(Option<FailureMode>, &str, Color); 6] = [
    (
        Some(FailureMode::FibreTension),
        "fibre, tension",
        Color::rgb(0xc0, 0x39, 0x2b),
    ),
    (
        Some(FailureMode::FibreCompression),
        "fibre, compression",
        Color::rgb(0x6c, 0x34, 0x83),
    ),
    (
        Some(FailureMode::MatrixTension),
        "matrix, tension",
        Color::rgb(0x2e, 0x86, 0xc1),
    ),
    (
        Some(FailureMode::MatrixCompression),
        "matrix, compression",
        Color::rgb(0x1e, 0x84, 0x49),
    ),
    (
        Some(FailureMode::Shear),
        "matrix, shear",
        Color::rgb(0xf1, 0xb0, 0x2c),
    ),
    (None, "flows", Color::rgb(0xe5, 0x98, 0x66)),
];

/// One picture per ply direction.
pub(crate) fn damage_map(view: &ProgressiveView<'_>) -> Attempt {
    let failure = view.failure.failure;
    let (Some(mesh), Some(centre)) = (
        &view.failure.results.bodies[failure.body].mesh,
        failure.centre,
    ) else {
        return Ok(None);
    };
    let own = view.progressive;
    if own.losses.is_empty() || mesh.element_count() != own.cells {
        return Ok(None);
    }
    let nodes = nodes(view, mesh);
    let categories = categories(own);
    let window = window(view, &nodes, centre);
    let unit = view.length_unit();
    let picture = |group: usize| {
        MeshMap {
            title: format!("{} plies", failure.ply_name(group)),
            axes: ["x", "y"].map(|name| format!("{name} [{unit}]")),
            nodes: &nodes,
            cells: &cells(view, mesh, group, &categories),
            categories: &categories,
            window,
            width: WIDTH,
        }
        .render()
    };
    let pictures = (0..failure.plies.len())
        .map(picture)
        .collect::<Result<Vec<_>, _>>()?;
    let title = format!(
        "Damage of '{}' at the end of its history",
        view.failure.body()
    );
    let columns = if pictures.len() == 4 { 2 } else { 3 };
    Ok(Some((tile(&title, columns, &pictures)?, caption(view))))
}

fn caption(view: &ProgressiveView<'_>) -> String {
    let own = view.progressive;
    let displacement = own.curve.last().map_or(0.0, |point| point.displacement);
    format!(
        "Cells of {} in which a ply has failed, by the gravest mode, at a displacement of {} {}.{}",
        view.failure.failure.layup,
        significant(view.failure.length(displacement), 4),
        view.length_unit(),
        if own.half {
            " One half was followed; in the other the ply of opposite angle has failed alike."
        } else {
            ""
        }
    )
}

/// Nodes in display units, and of a half model their mirror images behind them.
fn nodes(view: &ProgressiveView<'_>, mesh: &Mesh) -> Vec<Point> {
    let shown = |node: &Point| node.map(|x| view.failure.length(x));
    let mut nodes: Vec<Point> = mesh.nodes().iter().map(shown).collect();
    if view.progressive.half {
        let images: Vec<Point> = nodes.iter().map(|&[x, y]| [x, -y]).collect();
        nodes.extend(images);
    }
    nodes
}

/// The modes that occur.
fn categories(own: &ProgressiveFailure) -> Vec<Category> {
    let occurs = |mode| own.losses.iter().any(|loss| loss.mode == mode);
    let modes = MODES.iter().filter(|(mode, _, _)| occurs(*mode));
    modes
        .map(|(_, label, color)| Category {
            label: (*label).to_owned(),
            mark: String::new(),
            color: *color,
        })
        .collect()
}

/// The parts of all cells with what the plies `group` show there, and of a half model those of its image.
fn cells(
    view: &ProgressiveView<'_>,
    mesh: &Mesh,
    group: usize,
    categories: &[Category],
) -> Vec<(Vec<usize>, Option<usize>)> {
    let own = view.progressive;
    let half = |group: usize, first: usize| {
        let damage = damage(view, group, categories).into_iter().enumerate();
        // The parts of a cell are damaged alike.
        damage.flat_map(move |(cell, damage)| {
            let parts = drawn(mesh, cell, first).into_iter();
            parts.map(move |part| (part, damage))
        })
    };
    let mut all: Vec<_> = half(group, 0).collect();
    if own.half {
        all.extend(half(partner(view, group), mesh.nodes().len()));
    }
    all
}

/// The gravest mode of every cell, as an index of `categories`.
fn damage(view: &ProgressiveView<'_>, group: usize, categories: &[Category]) -> Vec<Option<usize>> {
    let mut cells = vec![None; view.progressive.cells];
    let losses = view.progressive.losses.iter();
    for loss in losses.filter(|loss| loss.ply == group) {
        let label = MODES.iter().find(|(mode, _, _)| *mode == loss.mode);
        let index = label.and_then(|(_, label, _)| {
            categories
                .iter()
                .position(|category| category.label == *label)
        });
        let known: &mut Option<usize> = &mut cells[loss.cell];
        *known = match (*known, index) {
            (Some(old), Some(new)) => Some(old.min(new)),
            (old, new) => old.or(new),
        };
    }
    cells
}

/// The plies that are the mirror image of those of `group`.
fn partner(view: &ProgressiveView<'_>, group: usize) -> usize {
    let plies = &view.failure.failure.plies;
    let own = &plies[group];
    let image = |angle: f64| (angle + own.angle).rem_euclid(180.0);
    let opposite = |angle: f64| image(angle).min(180.0 - image(angle)) < 1e-6;
    let found = (plies.iter()).position(|other| other.ply == own.ply && opposite(other.angle));
    found.unwrap_or(group)
}

/// The hole and all damage, with some room, within the body `[display unit]`.
fn window(view: &ProgressiveView<'_>, nodes: &[Point], centre: Point) -> [f64; 4] {
    let centre = centre.map(|x| view.failure.length(x));
    let radius = distance(nodes, centre);
    let reach = [0, 1].map(|axis| {
        let damaged = view.progressive.losses.iter().map(|loss| {
            (view.failure.length(loss.position[axis]) - centre[axis]).abs() + ROOM * radius
        });
        damaged.fold(WINDOW * radius, f64::max)
    });
    around(extent(nodes.iter().copied()), centre, reach)
}
