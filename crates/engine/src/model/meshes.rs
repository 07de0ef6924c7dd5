//! Meshes of a scene's bodies, matching where they may touch unless the scene divides a body by itself.

mod angles;
mod partners;
mod turns;

use self::turns::Turned;
pub(super) use angles::on_circles;

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::Arc;

use stickslip_fem_core::generate::{Extent, GenerateError};
use stickslip_fem_core::mesh::Mesh;

use super::ModelError;
use super::plan::{BodyPlan, Plan};
use crate::results::Choice;
use stickslip_scene::limits::Limits;
use stickslip_scene::schema::{Division, MeshSettings};
use stickslip_scene::shape::{Divided, DivisionError, Meshing};

/// Largest number of nodes of one body.
pub const NODE_LIMIT: usize = 4_000_000;
/// Memory `[byte]` per node of mesh, matrix and factor, by which a mesh that is too large is reported: a factor of n unknowns of a
/// plane mesh holds about 8 n log₂ n numbers.
pub const BYTES_PER_NODE: f64 = 2.0 * 8.0 * 8.0 * 24.0;

/// Most radial layers of a body by series, whose mesh only shows fields, where cells can be so much deeper than wide.
const SHOWN_LAYERS: usize = 24;

/// Each elastic body's mesh by the index of the body.
pub(super) type Meshes = BTreeMap<usize, Arc<Mesh>>;

/// Each elastic body's mesh; none of them has more nodes, nor all together, than `limits` allow.
pub(super) fn build(
    plan: &Plan<'_>,
    limits: Limits,
    half: bool,
    choices: &mut Vec<Choice>,
) -> Result<Meshes, ModelError> {
    let partners = partners::of(plan)?;
    let turns = turns::of(plan);
    let mut meshes = Meshes::new();
    let mut layers = Vec::new();
    let mut counts = Vec::new();
    for (index, body) in plan.bodies.iter().enumerate() {
        if body.elastic.is_none() {
            continue;
        }
        let mut angles = if body.shape.is_round() {
            angles::on_circles(body, half)?
        } else {
            Vec::new()
        };
        let turn = turns[index];
        if let (Some(seat), None) = (&body.seat, &body.series) {
            for angle in &mut angles {
                *angle = seat.facing(*angle + turn) - turn;
            }
        }
        let partner = partners.get(&index).map(|&partner| &plan.bodies[partner]);
        let made = |most_layers| {
            let meshing = turned_meshing(body, partner, &angles, half, most_layers, turn)?;
            let mesh = meshing.generator.generate_within(most_nodes(limits))?;
            Ok((meshing.layers, mesh))
        };
        let shown = (body.series.as_ref()).and_then(|_| made(SHOWN_LAYERS).ok());
        let made = shown.map_or_else(|| made(usize::MAX), Ok);
        let (own, mesh) = made.map_err(|cause| refuse(limits, body.name, cause))?;
        if let (None, Some(count)) = (body.mesh.layers, own) {
            layers.push(format!("{count} in '{}'", body.name));
            counts.push(angles.len());
        }
        meshes.insert(index, Arc::new(mesh));
    }
    choices.extend(layers_chosen(&layers, counts));
    choices.extend(cells_chosen(plan));
    check_together(plan, limits, &meshes)?;
    Ok(meshes)
}

/// How `body` is divided, together with its partner if it has one.
fn meshing(
    body: &BodyPlan<'_>,
    partner: Option<&BodyPlan<'_>>,
    angles: &[f64],
    half: bool,
    most_layers: usize,
) -> Result<Meshing, DivisionError> {
    let grading = match body.mesh.division {
        Division::Linear(grading) => Some(grading),
        Division::AngleList(_) | Division::Angular(_) | Division::Places(_) => None,
    };
    let places = match &body.mesh.division {
        Division::Places(places) => Some(places.as_slice()),
        _ => None,
    };
    body.shape.meshing(&Divided {
        kind: body.mesh.element,
        angles,
        spacing: grading.map(|grading| grading.spacing),
        fine_to: grading.and_then(|grading| grading.fine_to),
        places,
        layers: body.mesh.layers,
        fineness: body.mesh.fineness,
        most_layers,
        extent: if half { Extent::Half } else { Extent::Whole },
        centre: body.centre,
        partner: partner.map(|partner| &**partner.shape),
        most: NODE_LIMIT,
    })
}

/// The same, with angles that count from `turn` `[rad]`.
fn turned_meshing(
    body: &BodyPlan<'_>,
    partner: Option<&BodyPlan<'_>>,
    angles: &[f64],
    half: bool,
    most_layers: usize,
    turn: f64,
) -> Result<Meshing, DivisionError> {
    if turn == 0.0 {
        return meshing(body, partner, angles, half, most_layers);
    }
    if body.shape.is_placed() {
        // The remainder of what rounding leaves below zero may be a full turn.
        let from_turn = angles.iter().map(|angle| (angle + turn).rem_euclid(TAU));
        let within = from_turn.map(|at| if at < TAU { at } else { 0.0 });
        let mut angles: Vec<f64> = within.collect();
        angles.sort_by(f64::total_cmp);
        return meshing(body, partner, &angles, half, most_layers);
    }
    let at_origin = BodyPlan {
        centre: [0.0; 2],
        ..body.clone()
    };
    let own = meshing(&at_origin, partner, angles, half, most_layers)?;
    let generator = Turned {
        generator: own.generator,
        turn,
        centre: body.centre,
    };
    Ok(Meshing {
        generator: Box::new(generator),
        ..own
    })
}

/// Places of the corner nodes along the contact edge `edge` of the line contact of `body`, divided as `mesh` says, ascending.
pub(super) fn on_line(
    plan: &Plan<'_>,
    index: usize,
    mesh: MeshSettings,
    edge: &str,
    half: bool,
) -> Result<Vec<f64>, ModelError> {
    let partners = partners::of(plan)?;
    let own = BodyPlan {
        mesh,
        ..plan.bodies[index].clone()
    };
    let partner = partners.get(&index).map(|&partner| &plan.bodies[partner]);
    let refused = |what: String| ModelError::MeshSettings {
        body: own.name.to_owned(),
        what,
    };
    let made = meshing(&own, partner, &[], half, SHOWN_LAYERS);
    let made = made.and_then(|made| Ok(made.generator.generate_within(NODE_LIMIT)?));
    let mesh = made.map_err(|cause| refused(cause.to_string()))?;
    let path = mesh
        .edge_path(edge)
        .map_err(|cause| refused(cause.to_string()))?;
    let x = path.nodes.iter().map(|&node| mesh.nodes()[node][0]);
    let mut places: Vec<f64> = x.collect();
    places.sort_by(f64::total_cmp);
    Ok(places)
}

/// The choice of radial layers, where any were chosen.
fn layers_chosen(layers: &[String], mut counts: Vec<usize>) -> Option<Choice> {
    counts.dedup();
    let counts: Vec<String> = counts.iter().map(usize::to_string).collect();
    (!layers.is_empty()).then(|| Choice {
        what: "radial layers".into(),
        value: layers.join(", "),
        reason: format!(
            "cells about as deep as wide, with {} angles on the contact circles",
            counts.join(" and ")
        ),
    })
}

/// The cells of bodies that are not divided into those that the scene asks for.
fn cells_chosen(plan: &Plan<'_>) -> Option<Choice> {
    let of_body = |body: &BodyPlan<'_>| {
        let asked = body.mesh.element;
        let own = (body.shape.cells(asked)).filter(|own| *own != asked && body.series.is_none())?;
        body.elastic?;
        Some(format!("{} in '{}'", own.name(), body.name))
    };
    let chosen: Vec<String> = plan.bodies.iter().filter_map(of_body).collect();
    (!chosen.is_empty()).then(|| Choice {
        what: "cells".into(),
        value: chosen.join(", "),
        reason:
            "an outline is divided into triangles, with edges of the order that the scene asks for"
                .into(),
    })
}

/// Most nodes of one body: a fixed number, or what there is memory for.
fn most_nodes(limits: Limits) -> usize {
    let room = limits.memory as f64 / BYTES_PER_NODE;
    (room as usize).min(NODE_LIMIT)
}

fn refuse(limits: Limits, body: &str, cause: DivisionError) -> ModelError {
    match cause {
        DivisionError::TooManyNodes { nodes } => too_many(body, nodes),
        DivisionError::Generate(GenerateError::TooLarge { nodes, .. }) if nodes > NODE_LIMIT => {
            too_many(body, nodes as f64)
        }
        DivisionError::Generate(GenerateError::TooLarge { nodes, .. }) => {
            // The generator has found that this is more than the memory holds.
            ModelError::TooLittleMemory {
                body: body.to_owned(),
                nodes: nodes as f64,
                together: false,
                cause: limits.exceeded_by(nodes as f64 * BYTES_PER_NODE),
            }
        }
        DivisionError::Generate(cause) => ModelError::Generate {
            body: body.to_owned(),
            cause,
        },
        cause => ModelError::MeshSettings {
            body: body.to_owned(),
            what: cause.to_string(),
        },
    }
}

/// Refuses meshes that fit into the memory one by one and not together.
fn check_together(plan: &Plan<'_>, limits: Limits, meshes: &Meshes) -> Result<(), ModelError> {
    let nodes: usize = meshes.values().map(|mesh| mesh.nodes().len()).sum();
    let largest = meshes.iter().max_by_key(|(_, mesh)| mesh.nodes().len());
    let (Err(cause), Some((&body, mesh))) = (limits.check(nodes as f64 * BYTES_PER_NODE), largest)
    else {
        return Ok(());
    };
    Err(ModelError::TooLittleMemory {
        body: plan.bodies[body].name.to_owned(),
        nodes: mesh.nodes().len() as f64,
        together: true,
        cause,
    })
}

fn too_many(body: &str, nodes: f64) -> ModelError {
    ModelError::TooManyNodes {
        body: body.to_owned(),
        nodes,
        gigabytes: nodes * BYTES_PER_NODE / 1e9,
        limit: NODE_LIMIT as f64,
    }
}
