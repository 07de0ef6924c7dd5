//! Edges of a mesh from a file that are declared to be splines: smooth curves through their nodes.

use stickslip_fem_core::mesh::{EdgePath, Mesh, Point};
use stickslip_mesher::{Course, Spline};

use crate::shape::curve::Curve;
use crate::shape::note::{FileCurve, FileNote};

/// Angle between neighbouring chords `[rad]` from which on an edge has a corner.
const CORNER: f64 = std::f64::consts::FRAC_PI_6;

/// The spline through the nodes of the open chain `path`: through all of them, or through its corners where no cell is curved.
pub(super) fn spline(mesh: &Mesh, path: &EdgePath) -> Option<Curve> {
    through(
        mesh,
        path,
        if is_curved(mesh, path) { 1 } else { path.order },
    )
}

/// The spline through every `step`th node of the open chain `path`.
fn through(mesh: &Mesh, path: &EdgePath, step: usize) -> Option<Curve> {
    let places = path.nodes.iter().step_by(step);
    let places: Vec<Point> = places.map(|&node| mesh.nodes()[node]).collect();
    let [from, inner @ .., to] = places.as_slice() else {
        return None;
    };
    let course = Course::Spline(Spline {
        points: inner.to_vec(),
        ..Spline::default()
    });
    Curve::spline([*from, *to], &course)
}

/// The mesh with the mid nodes of the edges `names` on their splines; `notes` get what was moved, and which edges are lines or circles instead.
///
/// # Errors
/// What is wrong with an edge, and what to do.
pub(super) fn put_on(
    mesh: Mesh,
    names: &[String],
    notes: &mut Vec<FileNote>,
) -> Result<Mesh, [String; 2]> {
    let mut places = mesh.nodes().to_vec();
    for name in names {
        let Some(path) = checked(&mesh, name)? else {
            notes.push(FileNote::NoSpline { edge: name.clone() });
            continue;
        };
        let curve = spline(&mesh, &path).and_then(|own| own.path());
        let curve = curve.ok_or_else(|| {
            let cause = format!("no spline passes the nodes of edge '{name}'");
            [
                cause,
                format!(
                    "remove '{name}' from `splines`, or give the edge more and evenly spaced cells"
                ),
            ]
        })?;
        if path.order == 1 || is_curved(&mesh, &path) {
            continue;
        }
        let middles = path.nodes.iter().enumerate();
        let middles = middles.filter(|(k, _)| k % path.order != 0);
        for (_, &node) in middles {
            places[node] = curve.at(curve.nearest(places[node]));
        }
        notes.push(FileNote::MidNodes {
            edge: name.clone(),
            moved: path.edges.len() * (path.order - 1),
            onto: FileCurve::Spline,
        });
    }
    let mut parts = mesh.into_parts();
    parts.nodes = places;
    Mesh::new(parts).map_err(|cause| {
        let cause = format!("its cells along splines are not valid: {cause}");
        [cause, "give these edges more cells".to_owned()]
    })
}

/// The open chain of an edge without a corner; none of a line or a circle.
fn checked(mesh: &Mesh, name: &str) -> Result<Option<EdgePath>, [String; 2]> {
    let set = mesh.edge_set(name).map_err(|_| {
        let known: Vec<&str> = mesh.edge_set_names().collect();
        let remedy = format!("edges of the file: {}", known.join(", "));
        [format!("it has no edge '{name}'"), remedy]
    })?;
    if set.curve.is_some() {
        return Ok(None);
    }
    let path = mesh
        .edge_path(name)
        .map_err(|cause| [cause.to_string(), format!("remove '{name}' from `splines`")])?;
    if path.closed {
        let cause = format!("edge '{name}' is closed, and splines have ends");
        return Err([
            cause,
            "divide it into two edges in the program that made the mesh".to_owned(),
        ]);
    }
    let corners = path.nodes.iter().step_by(path.order);
    let corners: Vec<Point> = corners.map(|&node| mesh.nodes()[node]).collect();
    for three in corners.windows(3) {
        let [u, v] = [0, 1].map(|k| [0, 1].map(|axis| three[k + 1][axis] - three[k][axis]));
        let turn = (u[0] * v[1] - u[1] * v[0])
            .atan2(u[0] * v[0] + u[1] * v[1])
            .abs();
        if turn > CORNER {
            let cause = format!(
                "edge '{name}' turns by {:.1}° at ({:.6}, {:.6}) mm, where it is no smooth curve",
                turn.to_degrees(),
                three[1][0],
                three[1][1]
            );
            return Err([
                cause,
                "give the parts on both sides names of their own, or give it more cells".to_owned(),
            ]);
        }
    }
    Ok(Some(path))
}

/// Whether mid nodes lie nearer to the spline through the corners of the chain than to its chords, all in all: the digits of a file leave single ones on neither.
fn is_curved(mesh: &Mesh, path: &EdgePath) -> bool {
    let Some(curve) = through(mesh, path, path.order).and_then(|own| own.path()) else {
        return false;
    };
    let at = |k: usize| mesh.nodes()[path.nodes[k]];
    let mut sums = [0.0; 2];
    for edge in 0..path.edges.len() {
        let ends = [edge * path.order, (edge + 1) * path.order];
        let [a, b] = ends.map(at);
        let off = |p: Point| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
        for k in ends[0] + 1..ends[1] {
            let (own, on) = (off(at(k)), off(curve.at(curve.nearest(at(k)))));
            sums[0] += own * on;
            sums[1] += on * on;
        }
    }
    sums[0] > 0.5 * sums[1]
}
