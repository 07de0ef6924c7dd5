//! Meshes of a scene's bodies, matching where they may touch unless the scene divides a body by itself.

mod angles;
pub(super) mod lines;

use std::f64::consts::PI;
use std::sync::Arc;

use stickslip_fem_core::generate::{
    self, Disk, Extent, Generate, GenerateError, Growth, PlateWithHole, Rectangle,
};
use stickslip_fem_core::mesh::{ElementKind, Mesh};

use super::{Meshes, ModelError, placement};
use crate::results::Choice;
use crate::scene::Scene;
use crate::scene::schema::{Division, MeshSettings, Outline, Shape, Substance};

/// Largest number of nodes of one body.
pub const NODE_LIMIT: usize = 4_000_000;
/// Bytes per node of mesh, matrix and factor, by which a mesh that is too large is reported: a factor of n unknowns of a
/// plane mesh holds about 8 n log₂ n numbers.
pub(crate) const BYTES_PER_NODE: f64 = 2.0 * 8.0 * 8.0 * 24.0;
/// Layers that start with square cells.
const SQUARE: Growth = Growth::Geometric { aspect: 1.0 };

pub(super) fn build(
    scene: &Scene,
    half: bool,
    choices: &mut Vec<Choice>,
) -> Result<Meshes, ModelError> {
    let most = most_nodes(scene);
    let mut meshes = lines::build(scene, half, most)?;
    let mut layers = Vec::new();
    let mut counts = Vec::new();
    for (name, body) in &scene.bodies {
        if body.substance == Substance::Rigid {
            // The partner of a rigid block or cylinder was meshed with it.
            meshes.remove(name);
            continue;
        }
        let refuse = |cause| refuse(scene, name, cause);
        let angles = if body.shape.is_round() {
            angles::on_circles(scene, name, half)?
        } else {
            Vec::new()
        };
        let settings = scene.mesh_of(name);
        let (kind, chosen) = (settings.element, settings.layers.is_none());
        let mesh = match body.shape {
            Shape::PlateWithHole {
                hole_radius,
                outline,
            } => {
                let count = layers_around(scene, name, hole_radius, outline, angles.len(), half);
                if chosen {
                    layers.push(format!("{count} in '{name}'"));
                    counts.push(angles.len());
                }
                let mesh = plate(kind, hole_radius, outline, &angles, count, half, most);
                let place = placement::centre(scene, name);
                let moved = mesh.map_err(refuse)?.translated(place);
                moved.map_err(|cause| ModelError::Mesh {
                    body: name.clone(),
                    cause,
                })?
            }
            Shape::Disk { radius } => {
                if chosen {
                    layers.push(format!("{} in '{name}'", disk_layers(angles.len(), half)));
                    counts.push(angles.len());
                }
                disk(scene, name, radius, &angles, half, most).map_err(refuse)?
            }
            Shape::Rectangle { width, height } => {
                rectangle(settings, width, height, most).map_err(refuse)?
            }
            Shape::Block { .. } | Shape::Cylinder { .. } => continue,
        };
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

fn refuse(scene: &Scene, body: &str, cause: GenerateError) -> ModelError {
    match cause {
        GenerateError::TooLarge { nodes, .. } if nodes > NODE_LIMIT => too_many(body, nodes as f64),
        GenerateError::TooLarge { nodes, .. } => {
            // The generator has found that this is more than the memory holds.
            let words = scene.limits().check(nodes as f64 * BYTES_PER_NODE);
            too_large(body, nodes, words.err().unwrap_or_default())
        }
        cause => ModelError::Generate {
            body: body.to_owned(),
            cause,
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

fn extent(half: bool) -> Extent {
    if half { Extent::Half } else { Extent::Whole }
}

/// Divisions of half the circle.
fn half_count(angles: usize, half: bool) -> f64 {
    if half {
        angles as f64 - 1.0
    } else {
        angles as f64 / 2.0
    }
}

/// Layers between a hole and its outline. A thin ring needs no more than square cells all through it do:
/// ln(R/r) / Δθ, and a tenth more.
fn layers_around(
    scene: &Scene,
    body: &str,
    hole_radius: f64,
    outline: Outline,
    angles: usize,
    half: bool,
) -> usize {
    let part = match outline {
        Outline::Strip { .. } => 0.4,
        Outline::Ring { radius } => f64::min(0.55, 1.1 * (radius / hole_radius).ln() / PI),
    };
    let chosen = (part * half_count(angles, half)).round() as usize;
    scene.mesh_of(body).layers.unwrap_or_else(|| chosen.max(4))
}

fn disk_layers(angles: usize, half: bool) -> usize {
    ((0.22 * half_count(angles, half)).round() as usize).max(3)
}

fn plate(
    kind: ElementKind,
    hole_radius: f64,
    outline: Outline,
    angles: &[f64],
    layers: usize,
    half: bool,
    most: usize,
) -> Result<Mesh, GenerateError> {
    let outline = match outline {
        Outline::Strip {
            half_width,
            left,
            right,
        } => generate::Outline::Strip {
            half_width,
            left,
            right,
        },
        Outline::Ring { radius } => generate::Outline::Ring {
            outer_radius: radius,
        },
    };
    PlateWithHole {
        hole_radius,
        outline,
        extent: extent(half),
        angles: angles.to_vec(),
        layers,
        growth: SQUARE,
        far_cells: ((half_count(angles.len(), half) / 4.0).round() as usize).max(3),
        kind,
    }
    .generate_within(most)
}

fn disk(
    scene: &Scene,
    name: &str,
    radius: f64,
    angles: &[f64],
    half: bool,
    most: usize,
) -> Result<Mesh, GenerateError> {
    Disk {
        radius,
        centre: placement::centre(scene, name),
        extent: extent(half),
        angles: angles.to_vec(),
        core: Disk::CORE,
        layers: disk_layers(angles.len(), half),
        growth: SQUARE,
        kind: scene.mesh_of(name).element,
    }
    .generate_within(most)
}

fn rectangle(
    settings: &MeshSettings,
    width: f64,
    height: f64,
    most: usize,
) -> Result<Mesh, GenerateError> {
    let spacing = match settings.division {
        Division::Linear(grading) => grading.spacing,
        Division::AngleList(_) | Division::Angular(_) => width.min(height) / 20.0,
    };
    let cells = |length: f64| ((length / spacing).ceil().clamp(1.0, 1e7)) as usize;
    Rectangle::uniform(
        [-width / 2.0, width / 2.0],
        [-height, 0.0],
        [cells(width), cells(height)],
        settings.element,
    )?
    .generate_within(most)
}
