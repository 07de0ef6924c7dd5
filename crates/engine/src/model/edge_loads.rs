//! Tractions on reported edges, of loads and of reactions.

use stickslip_fem_core::mesh::Mesh;
use stickslip_scene::schema::{LoadKind, SetRef};

use super::ModelEdge;
use super::loads::sign;
use super::plan::{Placed, Plan};
use super::polar_table::PolarField;
use crate::results::EdgeKind;

/// −1 where the normal of results on the reported edge points into the body, as along every path, otherwise 1.
fn outward(placed: &Placed<'_, SetRef>, edge: &ModelEdge) -> f64 {
    match edge.geometry.kind {
        EdgeKind::Path => -1.0,
        EdgeKind::Circle { .. } | EdgeKind::Line => sign(placed),
    }
}

/// Tractions (σ_nn, τ_nt) of unit loads on a reported edge, in the edge's frame (n, t), t being n turned by +90°.
pub(super) fn edge_tractions(
    plan: &Plan<'_>,
    placed: &Placed<'_, SetRef>,
    edge: &ModelEdge,
) -> Vec<(usize, Vec<[f64; 2]>)> {
    let on = placed.of;
    // n is e_r or +y, which points into a hole's body and out of the body above a lower side.
    let outward = outward(placed, edge);
    let area: f64 = edge.areas.iter().sum::<f64>() * if edge.geometry.half { 2.0 } else { 1.0 };
    let mut all = Vec::new();
    for (case, load) in plan.loads.iter().enumerate() {
        let at_node: Box<dyn Fn(usize) -> [f64; 2]> = match &load.of.kind {
            LoadKind::Pressure { on: loaded, .. } if loaded == on => Box::new(|_| [-1.0, 0.0]),
            LoadKind::Bearing {
                on: loaded,
                direction: [x, y],
                law,
                ..
            } if loaded == on => {
                let middle = y.atan2(*x);
                let mean = 1.0 / edge.geometry.bearing_area.unwrap_or(area);
                Box::new(move |k| {
                    [
                        -mean * law.pressure(edge.geometry.parameter[k] - middle),
                        0.0,
                    ]
                })
            }
            LoadKind::PolarTraction {
                on: loaded, table, ..
            } if loaded == on => {
                let field = PolarField::new(table);
                Box::new(move |k| field.at(edge.geometry.parameter[k]))
            }
            LoadKind::Force {
                on: loaded,
                direction,
                ..
            } if loaded == on => Box::new(move |k| {
                let [nx, ny] = edge.normals[k];
                let along = |x: f64, y: f64| outward * (direction[0] * x + direction[1] * y) / area;
                [along(nx, ny), along(-ny, nx)]
            }),
            _ => continue,
        };
        all.push((case, (0..edge.nodes.len()).map(at_node).collect()));
    }
    all
}

/// Tractions (σ_nn, τ_nt) at each node of a reported edge of a unit reaction there along x and along y `[1/mm²]`, as far as supports
/// and platens of this edge take it; empty where none does.
pub(super) fn edge_reactions(
    plan: &Plan<'_>,
    placed: &Placed<'_, SetRef>,
    edge: &ModelEdge,
) -> Vec<[[f64; 2]; 2]> {
    let held = plan.held_along(placed.of);
    let Some(&first) = held.first() else {
        return Vec::new();
    };
    let outward = outward(placed, edge);
    let parallel = |other: &[f64; 2]| (first[0] * other[1] - first[1] * other[0]).abs() < 1e-9;
    let all = !held.iter().all(parallel);
    let taken = |force: [f64; 2]| {
        let share = first[0] * force[0] + first[1] * force[1];
        if all {
            force
        } else {
            first.map(|part| share * part)
        }
    };
    // On the line of symmetry of a half the other part of the reaction is what that line takes.
    let ends = edge.nodes.len() - 1;
    let round = edge.geometry.closed().is_some();
    let symmetric = |k: usize| edge.geometry.half && (k == 0 || (round && k == ends));
    let of_node = |k: usize| {
        let ([nx, ny], area) = (edge.normals[k], edge.areas[k]);
        [[1.0, 0.0], [0.0, 1.0]].map(|unit| {
            let [x, y] = taken(unit).map(|force| outward * force / area);
            let along = if symmetric(k) { 0.0 } else { y * nx - x * ny };
            [x * nx + y * ny, along]
        })
    };
    (0..=ends).map(of_node).collect()
}

/// Whether the first and the last node of a reported edge that is held are held by another set of the body too.
pub(super) fn shared_ends(
    plan: &Plan<'_>,
    placed: &Placed<'_, SetRef>,
    edge: &ModelEdge,
    mesh: &Mesh,
) -> [bool; 2] {
    let ([first, .., last], None, false) = (
        &edge.nodes[..],
        edge.geometry.closed(),
        edge.reactions.is_empty(),
    ) else {
        return [false; 2];
    };
    let supports = plan.supports.iter().map(|own| &own.of.on);
    let springs = plan.springs.iter().map(|own| &own.of.on);
    let platens = plan.platens.iter().map(|own| &own.of.on);
    let others = supports.chain(springs).chain(platens);
    let others = others.filter(|on| on.body == placed.of.body && *on != placed.of);
    // What another edge takes across is not taken here.
    let own = plan.held_along(placed.of);
    let is_along = |other: &[f64; 2]| {
        let mut parts = own.iter().map(|own| own[0] * other[0] + own[1] * other[1]);
        parts.any(|part| part.abs() > 1e-9)
    };
    let others = others.filter(|on| plan.held_along(on).iter().any(is_along));
    let held: Vec<&[usize]> = others
        .filter_map(|on| mesh.node_set(&on.set).ok())
        .collect();
    [first, last].map(|node| held.iter().any(|nodes| nodes.contains(node)))
}
