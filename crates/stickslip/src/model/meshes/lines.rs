//! Cylinders on blocks: each pair is meshed together, twice where the scene divides the two differently.

use std::collections::BTreeMap;
use std::sync::Arc;

use stickslip_fem_core::generate::{CylinderOnBlock, Generate};
use stickslip_fem_core::mesh::Mesh;

use super::{NODE_LIMIT, extent, refuse, too_many};
use crate::model::ModelError;
use crate::scene::Scene;
use crate::scene::schema::{Division, Shape};

/// Growth of cells from one to the next.
const GROWTH: f64 = 1.12;
/// Half of the fine zone where the scene does not say, as a part of the half length.
const FINE_PART: f64 = 1.0 / 8.0;

/// Half of the zone of equal spacing `[mm]`.
pub(in crate::model) fn fine_to(given: Option<f64>, half_length: f64) -> f64 {
    given.unwrap_or(half_length * FINE_PART)
}

/// Meshes of all cylinders and blocks by body.
pub(super) fn build(
    scene: &Scene,
    half: bool,
    most: usize,
) -> Result<BTreeMap<String, Arc<Mesh>>, ModelError> {
    let mut meshes = BTreeMap::new();
    for [cylinder, block] in pairs(scene)? {
        let divided_as = |name: &str| {
            together(scene, [cylinder, block], name, half)?
                .generate_within(most)
                .map_err(|cause| refuse(scene, name, cause))
        };
        let made = divided_as(cylinder)?;
        let lower = if scene.mesh_of(cylinder) == scene.mesh_of(block) {
            made.lower
        } else {
            divided_as(block)?.lower
        };
        meshes.insert(cylinder.to_owned(), Arc::new(made.upper));
        meshes.insert(block.to_owned(), Arc::new(lower));
    }
    Ok(meshes)
}

/// Cylinders with their blocks: those in contact, or the only cylinder with the only block.
fn pairs(scene: &Scene) -> Result<Vec<[&str; 2]>, ModelError> {
    let of = |fits: fn(&Shape) -> bool| -> Vec<&str> {
        let bodies = scene.bodies.iter().filter(|(_, body)| fits(&body.shape));
        bodies.map(|(name, _)| name.as_str()).collect()
    };
    let mut cylinders = of(|shape| matches!(shape, Shape::Cylinder { .. }));
    let mut blocks = of(|shape| matches!(shape, Shape::Block { .. }));
    let mut pairs = Vec::new();
    for contact in &scene.contacts {
        let pair = [contact.first.body.as_str(), contact.second.body.as_str()];
        if cylinders.contains(&pair[0]) && blocks.contains(&pair[1]) {
            cylinders.retain(|name| *name != pair[0]);
            blocks.retain(|name| *name != pair[1]);
            pairs.push(pair);
        }
    }
    match (cylinders.as_slice(), blocks.as_slice()) {
        ([], []) => {}
        (&[cylinder], &[block]) => pairs.push([cylinder, block]),
        ([alone, ..], _) => {
            return Err(ModelError::MeshSettings {
                body: (*alone).to_owned(),
                what: format!("the cylinder '{alone}' needs a block that it touches"),
            });
        }
        ([], [alone, ..]) => {
            return Err(ModelError::MeshSettings {
                body: (*alone).to_owned(),
                what: format!("the block '{alone}' needs a cylinder to touch it"),
            });
        }
    }
    Ok(pairs)
}

/// The pair divided as `body`, one of the two, is.
fn together(
    scene: &Scene,
    pair: [&str; 2],
    body: &str,
    half: bool,
) -> Result<CylinderOnBlock, ModelError> {
    let settings = scene.mesh_of(body);
    let Division::Linear(grading) = &settings.division else {
        return Err(ModelError::MeshSettings {
            body: body.to_owned(),
            what: "a line contact is divided by a length, such as spacing = \"0.02 mm\"".into(),
        });
    };
    let mut curvature = f64::INFINITY;
    let (mut half_width, mut height) = (f64::INFINITY, f64::INFINITY);
    for name in pair {
        match scene.bodies[name].shape {
            Shape::Cylinder {
                radius,
                half_length,
                depth,
            } => {
                curvature = radius;
                (half_width, height) = (half_length.min(half_width), depth.min(height));
            }
            Shape::Block { half_length, depth } => {
                (half_width, height) = (half_length.min(half_width), depth.min(height));
            }
            _ => {}
        }
    }
    let inner = fine_to(grading.fine_to, half_width);
    let cells = inner / grading.spacing;
    if cells * cells > NODE_LIMIT as f64 {
        return Err(too_many(body, cells * cells * 3.0));
    }
    Ok(CylinderOnBlock {
        radius: curvature,
        half_width,
        height,
        inner,
        spacing: grading.spacing,
        growth: GROWTH,
        extent: extent(half),
        kind: settings.element,
    })
}
