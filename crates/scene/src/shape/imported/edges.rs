//! The edges of a mesh from a file, on the lines and circles that they approximate.

use std::borrow::Cow;

use stickslip_fem_core::mesh::{self, EdgePath, Mesh, Point};
use stickslip_mesh_files::{nearly_circle, recognise_pieces};

use super::splines::spline;
use crate::shape::curve::Curve;
use crate::shape::outline::{Edge, Role};

/// The edges of the sets `names`, of which `splines` are splines.
pub(super) fn edges<'a>(
    mesh: &Mesh,
    names: impl Iterator<Item = &'a str>,
    splines: &[String],
) -> Vec<Edge> {
    let edge = |name: &str| {
        let path = mesh.edge_path(name).ok();
        let is_known = mesh.edge_set(name).is_ok_and(|set| set.curve.is_some());
        let is_spline = !is_known && splines.iter().any(|own| own == name);
        let spline = path
            .as_ref()
            .filter(|_| is_spline)
            .and_then(|path| spline(mesh, path));
        spline.map_or_else(
            || edge(mesh, name, path.as_ref()),
            |curve| free(name, curve),
        )
    };
    names.map(edge).collect()
}

/// By how much the closed chain `path` of the set `name` is no circle, if it is nearly one.
pub(super) fn uneven(mesh: &Mesh, name: &str, path: &EdgePath) -> Option<String> {
    if mesh.edge_set(name).ok()?.curve.is_some() {
        return None;
    }
    let corners = path.nodes.iter().step_by(path.order);
    let corners: Vec<Point> = corners.map(|&node| mesh.nodes()[node]).collect();
    let found = nearly_circle(&corners)?;
    let mesh::Curve::Arc { radius, .. } = found.curve else {
        return None;
    };
    Some(format!(
        "its nodes leave their best circle, of radius {radius:.6} mm, by up to {:.2e} mm",
        found.residual
    ))
}

/// The edge of the set `name`, whose edges form the chain `path` if they form one.
fn edge(mesh: &Mesh, name: &str, path: Option<&EdgePath>) -> Edge {
    let at = |node: usize| mesh.nodes()[node];
    let set = mesh.edge_set(name).ok();
    let all = (set.iter().flat_map(|set| &set.edges))
        .flat_map(|&own| mesh.edge_nodes(own).walk().collect::<Vec<_>>());
    let places: Vec<Point> = match path {
        Some(path) => path.nodes.iter().map(|&node| at(node)).collect(),
        None => all.map(at).collect(),
    };
    let known = set.and_then(|set| set.curve).filter(|_| path.is_some());
    let closed = path.is_some_and(|path| path.closed);
    let (curve, role) = match known {
        Some(mesh::Curve::Arc { centre, radius }) if closed => {
            let is_hole = turned(centre, &places, closed) < 0.0;
            let role = if is_hole { Role::Hole } else { Role::Rim };
            (Curve::Circle { centre, radius }, role)
        }
        Some(known) => (open(known, &places), Role::Free),
        None => {
            let pieces = path
                .filter(|path| !path.closed)
                .and_then(|path| pieces(mesh, path));
            let curve = pieces.unwrap_or_else(|| Curve::chain(&places));
            (curve, Role::Free)
        }
    };
    Edge {
        role,
        ..free(name, curve)
    }
}

fn free(name: &str, curve: Curve) -> Edge {
    Edge {
        name: Cow::Owned(name.to_owned()),
        curve,
        role: Role::Free,
        size: None,
    }
}

/// The angle about `centre` through which a walk along `places` turns, counter-clockwise positive `[rad]`.
fn turned(centre: Point, places: &[Point], closed: bool) -> f64 {
    let step = |a: Point, b: Point| {
        let [u, v] = [a, b].map(|p| [p[0] - centre[0], p[1] - centre[1]]);
        (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1])
    };
    let along: f64 = places.windows(2).map(|pair| step(pair[0], pair[1])).sum();
    match (closed, places) {
        (true, [first, .., last]) => along + step(*last, *first),
        _ => along,
    }
}

/// The lines and arcs of an open chain, if it consists of some.
fn pieces(mesh: &Mesh, path: &EdgePath) -> Option<Curve> {
    let pieces = recognise_pieces(mesh.nodes(), &path.nodes, path.order)?;
    let curves = pieces.into_iter().map(|piece| {
        let nodes = path.nodes[piece.nodes].iter();
        let places: Vec<Point> = nodes.map(|&node| mesh.nodes()[node]).collect();
        open(piece.curve, &places)
    });
    let curves: Vec<Curve> = curves.collect();
    Some(Curve::joined(&curves.iter().collect::<Vec<_>>()))
}

/// The part of a line or a circle along `places`, which are two at least.
fn open(curve: mesh::Curve, places: &[Point]) -> Curve {
    let ends = [places[0], places[places.len() - 1]];
    match curve {
        mesh::Curve::Line => Curve::Segment { ends },
        mesh::Curve::Arc { centre, radius } => Curve::Arc {
            centre,
            radius,
            ends,
            turn: turned(centre, places, false),
        },
    }
}
