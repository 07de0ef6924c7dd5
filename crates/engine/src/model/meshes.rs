//! Meshes of a scene's bodies, matching where they may touch unless the scene divides a body by itself.

mod angles;
mod partners;

use std::sync::Arc;

use stickslip_fem_core::generate::{Extent, GenerateError};

use super::{Meshes, ModelError};
use crate::results::Choice;
use stickslip_scene::Scene;
use stickslip_scene::placement;
use stickslip_scene::schema::{Division, Substance};
use stickslip_scene::shape::{Divided, DivisionError};

/// Largest number of nodes of one body.
pub const NODE_LIMIT: usize = 4_000_000;
/// Bytes per node of mesh, matrix and factor, by which a mesh that is too large is reported: a factor of n unknowns of a
/// plane mesh holds about 8 n log₂ n numbers.
pub const BYTES_PER_NODE: f64 = 2.0 * 8.0 * 8.0 * 24.0;

pub(super) fn build(
    scene: &Scene,
    half: bool,
    choices: &mut Vec<Choice>,
) -> Result<Meshes, ModelError> {
    let most = most_nodes(scene);
    let partners = partners::of(scene)?;
    let mut meshes = Meshes::new();
    let mut layers = Vec::new();
    let mut counts = Vec::new();
    for (name, body) in &scene.bodies {
        if body.substance == Substance::Rigid {
            continue;
        }
        let angles = if body.shape.is_round() {
            angles::on_circles(scene, name, half)?
        } else {
            Vec::new()
        };
        let settings = scene.mesh_of(name);
        let grading = match settings.division {
            Division::Linear(grading) => Some(grading),
            Division::AngleList(_) | Division::Angular(_) => None,
        };
        let partner = partners.get(name.as_str());
        let partner = partner.and_then(|partner| scene.bodies.get(*partner));
        let divided = Divided {
            kind: settings.element,
            angles: &angles,
            spacing: grading.map(|grading| grading.spacing),
            fine_to: grading.and_then(|grading| grading.fine_to),
            layers: settings.layers,
            extent: if half { Extent::Half } else { Extent::Whole },
            centre: placement::centre(scene, name),
            partner: partner.map(|partner| &*partner.shape),
            most: NODE_LIMIT,
        };
        let meshing = body.shape.meshing(&divided);
        let meshing = meshing.map_err(|cause| refuse(scene, name, cause))?;
        if let (None, Some(count)) = (settings.layers, meshing.layers) {
            layers.push(format!("{count} in '{name}'"));
            counts.push(angles.len());
        }
        let mesh = meshing.generator.generate_within(most);
        let mesh = mesh.map_err(|cause| refuse(scene, name, cause.into()))?;
        meshes.insert(name.clone(), Arc::new(mesh));
    }
    if !layers.is_empty() {
        counts.dedup();
        let counts: Vec<String> = counts.iter().map(usize::to_string).collect();
        choices.push(Choice {
            what: "radial layers".into(),
            value: layers.join(", "),
            reason: format!(
                "cells about as deep as wide, with {} angles on the contact circles",
                counts.join(" and ")
            ),
        });
    }
    check_together(scene, &meshes)?;
    Ok(meshes)
}

/// Most nodes of one body: a fixed number, or what there is memory for.
fn most_nodes(scene: &Scene) -> usize {
    let room = scene.limits().memory as f64 / BYTES_PER_NODE;
    (room as usize).min(NODE_LIMIT)
}

fn refuse(scene: &Scene, body: &str, cause: DivisionError) -> ModelError {
    match cause {
        DivisionError::TooManyNodes { nodes } => too_many(body, nodes),
        DivisionError::Generate(GenerateError::TooLarge { nodes, .. }) if nodes > NODE_LIMIT => {
            too_many(body, nodes as f64)
        }
        DivisionError::Generate(GenerateError::TooLarge { nodes, .. }) => {
            // The generator has found that this is more than the memory holds.
            let words = scene.limits().check(nodes as f64 * BYTES_PER_NODE);
            too_large(body, nodes, words.err().unwrap_or_default())
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

fn too_large(body: &str, nodes: usize, words: String) -> ModelError {
    ModelError::TooLittleMemory {
        body: body.to_owned(),
        nodes: nodes as f64,
        words,
    }
}

/// Refuses meshes that fit into the memory one by one and not together.
fn check_together(scene: &Scene, meshes: &Meshes) -> Result<(), ModelError> {
    let nodes: usize = meshes.values().map(|mesh| mesh.nodes().len()).sum();
    let largest = meshes.iter().max_by_key(|(_, mesh)| mesh.nodes().len());
    let (Err(words), Some((body, mesh))) =
        (scene.limits().check(nodes as f64 * BYTES_PER_NODE), largest)
    else {
        return Ok(());
    };
    let words = format!("with the other bodies {words}");
    Err(too_large(body, mesh.nodes().len(), words))
}

fn too_many(body: &str, nodes: f64) -> ModelError {
    ModelError::TooManyNodes {
        body: body.to_owned(),
        nodes,
        gigabytes: nodes * BYTES_PER_NODE / 1e9,
        limit: NODE_LIMIT as f64,
    }
}
