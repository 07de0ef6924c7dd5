//! Errors of the model builder, at the line of the scene that causes them.

use crate::diagnostic::{SceneError, SceneProblem};
use crate::model::ModelError;
use crate::scene::Scene;
use crate::scene::schema::Division;

/// The error at the key that it is about, with a remedy.
pub(super) fn locate(scene: &Scene, error: &ModelError) -> SceneError {
    let (key, remedy) = match error {
        ModelError::TooManyNodes { body, .. } | ModelError::TooLittleMemory { body, .. } => (
            mesh_key(scene, body),
            "make mesh.spacing larger, or let it grow with mesh.fine_to and mesh.coarse_spacing; mesh.layers counts too",
        ),
        ModelError::InterfaceTooLarge { contact, .. } => (
            contact_key(scene, contact),
            "make mesh.spacing larger, or let it grow with mesh.fine_to and mesh.coarse_spacing; split the scene where its bodies allow it",
        ),
        ModelError::HistoryTooLong { .. } => (
            "loads".to_owned(),
            "take fewer load steps; analysis.substeps divides them without results of their own",
        ),
        ModelError::Generate { body, .. }
        | ModelError::Mesh { body, .. }
        | ModelError::Body { body, .. } => (
            format!("bodies.{body}"),
            "change the body's sizes, or the mesh settings that divide it",
        ),
        ModelError::Material { material, .. } => (
            format!("materials.{material}"),
            "check the material's constants",
        ),
        ModelError::Pairing { contact, .. } => (
            contact_key(scene, contact),
            "change the two bodies so that they can touch",
        ),
        ModelError::Projection { contact, .. } => (
            contact_key(scene, contact) + ".projection",
            "say projection = \"auto\" or \"dual-mortar\", or divide both bodies alike: remove their own mesh tables",
        ),
        ModelError::NotSymmetric(_) => (
            "analysis.model".to_owned(),
            "say model = \"auto\" or leave it out",
        ),
        ModelError::Unsupported { key, .. } => (
            key.clone(),
            "`stickslip check` shows the scene as it is understood; docs/scene-format.md lists what each key can do",
        ),
        ModelError::MeshSettings { body, .. } => (
            mesh_key(scene, body),
            "`stickslip init` writes scenes with mesh settings that fit",
        ),
        // The contact problem as a whole, and whatever else may come.
        _ => (
            String::new(),
            "`stickslip check` shows the scene as it is understood",
        ),
    };
    let problem = SceneProblem::Model {
        message: error.to_string(),
        remedy: remedy.to_owned(),
    };
    scene.error_at(&key, problem)
}

fn contact_key(scene: &Scene, contact: &str) -> String {
    let index = scene.contacts.iter().position(|own| own.name == *contact);
    format!("contacts.{}", index.unwrap_or_default())
}

/// What divides `body`.
fn mesh_key(scene: &Scene, body: &str) -> String {
    let own = scene
        .bodies
        .get(body)
        .is_some_and(|body| body.mesh.is_some());
    let table = if own {
        format!("bodies.{body}.mesh")
    } else {
        "mesh".to_owned()
    };
    match scene.mesh_of(body).division {
        Division::AngleList(_) => table + ".angles",
        Division::Angular(_) | Division::Linear(_) => table + ".spacing",
    }
}
