//! Meshes of a scene's bodies, matching where they may touch.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use stickslip_fem_core::generate::{
    self, CylinderOnBlock, Disk, Extent, Generate, GenerateError, Growth, PlateWithHole, Rectangle,
};
use stickslip_fem_core::mesh::Mesh;

use super::{Meshes, ModelError};
use crate::results::Choice;
use crate::scene::Scene;
use crate::scene::schema::{Division, Grading, Outline, Shape, Substance};

/// Largest number of nodes of one body.
pub const NODE_LIMIT: usize = 4_000_000;
/// Bytes per node of mesh, matrix and factor, by which a mesh that is too large is reported: a factor of n unknowns of a
/// plane mesh holds about 8 n log₂ n numbers.
const BYTES_PER_NODE: f64 = 2.0 * 8.0 * 8.0 * 24.0;
/// Layers that start with square cells.
const SQUARE: Growth = Growth::Geometric { aspect: 1.0 };
/// Growth of cells from one to the next in line contacts.
const LINE_GROWTH: f64 = 1.12;
/// Growth of the angular spacing from one interval to the next.
const ANGLE_GROWTH: f64 = 1.15;

pub(super) fn build(
    scene: &Scene,
    half: bool,
    choices: &mut Vec<Choice>,
) -> Result<Meshes, ModelError> {
    let mut meshes = Meshes::new();
    let angles = if scene.bodies.values().any(|body| body.shape.is_round()) {
        hole_angles(scene, half)?
    } else {
        Vec::new()
    };
    let mut line_contact = None;
    for (name, body) in scene
        .bodies
        .iter()
        .filter(|(_, body)| body.substance != Substance::Rigid)
    {
        let refuse = |cause| refuse(name, cause);
        let mesh = match body.shape {
            Shape::PlateWithHole {
                hole_radius,
                outline,
            } => Arc::new(plate(scene, hole_radius, outline, &angles, half).map_err(refuse)?),
            Shape::Disk { radius } => {
                Arc::new(disk(scene, name, radius, &angles, half).map_err(refuse)?)
            }
            Shape::Rectangle { width, height } => {
                Arc::new(rectangle(scene, width, height).map_err(refuse)?)
            }
            Shape::Block { .. } | Shape::Cylinder { .. } => {
                if line_contact.is_none() {
                    let made = line_contact_meshes(scene, half)?
                        .generate_within(NODE_LIMIT)
                        .map_err(refuse)?;
                    line_contact = Some((Arc::new(made.lower), Arc::new(made.upper)));
                }
                let Some((lower, upper)) = &line_contact else {
                    continue;
                };
                Arc::clone(if matches!(body.shape, Shape::Block { .. }) {
                    lower
                } else {
                    upper
                })
            }
        };
        meshes.insert(name.clone(), mesh);
    }
    if !angles.is_empty() && scene.mesh.layers.is_none() {
        choices.push(Choice {
            what: "radial layers".into(),
            value: format!(
                "{} around the hole, {} in the pin",
                plate_layers(angles.len(), half, false),
                disk_layers(angles.len(), half)
            ),
            reason: format!(
                "cells about as deep as wide, with {} angles on the contact circle",
                angles.len()
            ),
        });
    }
    Ok(meshes)
}

fn refuse(body: &str, cause: GenerateError) -> ModelError {
    match cause {
        GenerateError::TooLarge { nodes, .. } => too_many(nodes as f64),
        cause => ModelError::Generate {
            body: body.to_owned(),
            cause,
        },
    }
}

fn too_many(nodes: f64) -> ModelError {
    ModelError::TooManyNodes {
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

fn plate_layers(angles: usize, half: bool, ring: bool) -> usize {
    let factor = if ring { 0.55 } else { 0.4 };
    ((factor * half_count(angles, half)).round() as usize).max(4)
}

fn disk_layers(angles: usize, half: bool) -> usize {
    ((0.22 * half_count(angles, half)).round() as usize).max(3)
}

fn plate(
    scene: &Scene,
    hole_radius: f64,
    outline: Outline,
    angles: &[f64],
    half: bool,
) -> Result<Mesh, GenerateError> {
    let ring = matches!(outline, Outline::Ring { .. });
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
        layers: scene
            .mesh
            .layers
            .unwrap_or_else(|| plate_layers(angles.len(), half, ring)),
        growth: SQUARE,
        far_cells: ((half_count(angles.len(), half) / 4.0).round() as usize).max(3),
        kind: scene.mesh.element,
    }
    .generate_within(NODE_LIMIT)
}

fn disk(
    scene: &Scene,
    name: &str,
    radius: f64,
    angles: &[f64],
    half: bool,
) -> Result<Mesh, GenerateError> {
    Disk {
        radius,
        centre: disk_centre(scene, name, radius),
        extent: extent(half),
        angles: angles.to_vec(),
        core: Disk::CORE,
        layers: disk_layers(angles.len(), half),
        growth: SQUARE,
        kind: scene.mesh.element,
    }
    .generate_within(NODE_LIMIT)
}

/// A pin with clearance starts where it touches at θ = 0, one with interference concentric.
pub(super) fn disk_centre(scene: &Scene, name: &str, radius: f64) -> [f64; 2] {
    let hole = scene
        .contacts
        .iter()
        .find(|contact| contact.second.body == name)
        .and_then(|contact| {
            scene
                .bodies
                .get(&contact.first.body)
                .and_then(|body| body.shape.circle(&contact.first.set))
        });
    [hole.map_or(0.0, |hole| (hole - radius).max(0.0)), 0.0]
}

fn rectangle(scene: &Scene, width: f64, height: f64) -> Result<Mesh, GenerateError> {
    let spacing = match scene.mesh.division {
        Division::Linear(grading) => grading.spacing,
        Division::AngleList(_) | Division::Angular(_) => width.min(height) / 20.0,
    };
    let cells = |length: f64| ((length / spacing).ceil().clamp(1.0, 1e7)) as usize;
    Rectangle::uniform(
        [-width / 2.0, width / 2.0],
        [-height, 0.0],
        [cells(width), cells(height)],
        scene.mesh.element,
    )?
    .generate_within(NODE_LIMIT)
}

fn line_contact_meshes(scene: &Scene, half: bool) -> Result<CylinderOnBlock, ModelError> {
    let Division::Linear(grading) = &scene.mesh.division else {
        return Err(ModelError::MeshSettings(
            "a line contact is divided by a length, such as spacing = \"0.02 mm\"".into(),
        ));
    };
    let mut radius = None;
    let (mut half_width, mut height): (f64, f64) = (f64::INFINITY, f64::INFINITY);
    for body in scene.bodies.values() {
        match body.shape {
            Shape::Cylinder {
                radius: r,
                half_length,
                depth,
            } => {
                radius = Some(r);
                (half_width, height) = (half_width.min(half_length), height.min(depth));
            }
            Shape::Block { half_length, depth } => {
                (half_width, height) = (half_width.min(half_length), height.min(depth));
            }
            _ => {}
        }
    }
    let radius = radius
        .ok_or_else(|| ModelError::MeshSettings("a block needs a cylinder to touch it".into()))?;
    let inner = grading.fine_to.unwrap_or(half_width / 8.0);
    let cells = inner / grading.spacing;
    if cells * cells > NODE_LIMIT as f64 {
        return Err(too_many(cells * cells * 3.0));
    }
    Ok(CylinderOnBlock {
        radius,
        half_width,
        height,
        inner,
        spacing: grading.spacing,
        growth: LINE_GROWTH,
        extent: extent(half),
        kind: scene.mesh.element,
    })
}

/// Angles of the corner nodes on the contact circle, from 0 to π (half) or to below 2π (whole).
fn hole_angles(scene: &Scene, half: bool) -> Result<Vec<f64>, ModelError> {
    let upper = match &scene.mesh.division {
        Division::AngleList(angles) => angles.clone(),
        Division::Angular(grading) => graded_angles(*grading)?,
        Division::Linear(_) => {
            return Err(ModelError::MeshSettings(
                "a round contact is divided by an angle, such as spacing = \"1 deg\"".into(),
            ));
        }
    };
    let Some(&last) = upper.last() else {
        return Err(ModelError::MeshSettings(
            "the list of angles is empty".into(),
        ));
    };
    let spans_half = (last - PI).abs() < 1e-9;
    if half && !spans_half {
        return Err(ModelError::MeshSettings(format!(
            "a half model needs angles from 0 to 180 deg; the last one is {:.6} deg",
            last.to_degrees()
        )));
    }
    if half || !spans_half {
        return Ok(upper);
    }
    let lower = upper[1..upper.len() - 1]
        .iter()
        .rev()
        .map(|angle| TAU - angle);
    Ok(upper.iter().copied().chain(lower).collect())
}

/// About how many intervals [`graded_angles`] makes: equal ones, growing ones, coarse ones.
fn interval_estimate(grading: Grading, fine_to: f64) -> f64 {
    let Grading {
        spacing,
        coarse_spacing,
        ..
    } = grading;
    let ratio = coarse_spacing.map_or(4.0, |coarse| (coarse / spacing).max(1.0));
    let growing = ratio.ln() / ANGLE_GROWTH.ln();
    fine_to / spacing + growing + (PI - fine_to) / (ratio * spacing)
}

/// Angles from 0 to π: equal spacing up to `fine_to`, then growing to the coarse spacing.
fn graded_angles(grading: Grading) -> Result<Vec<f64>, ModelError> {
    let fine_to = grading.fine_to.map_or(PI, |angle| angle.min(PI));
    let count = interval_estimate(grading, fine_to);
    if count * count * 0.7 > NODE_LIMIT as f64 {
        return Err(too_many(count * count * 3.0));
    }
    let fine = ((fine_to / grading.spacing) - 1e-9).ceil().max(1.0);
    let spacing = fine_to / fine;
    let mut angles: Vec<f64> = (0..=fine as usize).map(|k| spacing * k as f64).collect();
    let rest = PI - fine_to;
    if rest > 1e-9 {
        let largest = grading.coarse_spacing.unwrap_or(4.0 * spacing).max(spacing);
        let mut widths = Vec::new();
        let (mut width, mut sum) = (spacing, 0.0);
        while sum < rest {
            width = (width * ANGLE_GROWTH).min(largest);
            widths.push(width);
            sum += width;
        }
        if widths.len() > 1 && sum - rest > 0.5 * width {
            sum -= widths.pop().unwrap_or(0.0);
        }
        let mut at = fine_to;
        for width in widths {
            at += width * rest / sum;
            angles.push(at);
        }
    }
    if let Some(last) = angles.last_mut() {
        *last = PI;
    }
    Ok(angles)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn graded_angles_end_at_the_half_turn_and_grow_smoothly() {
        let grading = Grading {
            spacing: 1.125_f64.to_radians(),
            fine_to: Some(100.0_f64.to_radians()),
            coarse_spacing: Some(4.5_f64.to_radians()),
        };
        let angles = graded_angles(grading).unwrap();
        assert_eq!((angles[0], angles[angles.len() - 1]), (0.0, PI));
        let widths: Vec<f64> = angles.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!(
            widths
                .windows(2)
                .all(|pair| pair[1] / pair[0] < 1.3 && pair[1] / pair[0] > 0.75)
        );
        let uniform = graded_angles(Grading {
            fine_to: None,
            coarse_spacing: None,
            ..grading
        })
        .unwrap();
        assert_eq!(uniform.len(), 161);
    }

    #[test]
    fn a_billion_nodes_are_refused_before_anything_is_allocated() {
        let refused = graded_angles(Grading {
            spacing: 1e-5,
            fine_to: None,
            coarse_spacing: None,
        });
        assert!(
            matches!(refused, Err(ModelError::TooManyNodes { gigabytes, .. }) if gigabytes > 100.0)
        );
    }
}
