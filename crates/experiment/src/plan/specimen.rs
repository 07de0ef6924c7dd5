//! What was measured: a body of a scene, or material, thickness and hole alone.

use std::path::Path;
use std::sync::Arc;

use serde_json::{Map, Value, json};
use stickslip_fem_core::material::PlaneState;

use super::refuse::{Refuse, place};
use crate::format::{ExperimentFormat, HoleFormat, SpecimenFormat};
use crate::{Hole, Specimen, SpecimenScene};
use stickslip_scene::diagnostic::{SceneError, SceneProblem, one_of};
use stickslip_scene::document::Part;
use stickslip_scene::placement::circle_centre as centre_of;
use stickslip_scene::schema::Substance;
use stickslip_scene::shape::Role;
use stickslip_scene::{Format, Scene};

/// Name of the material and body in the scene that a specimen without one is read through.
const OWN: &str = "specimen";

pub(super) fn read(
    refuse: Refuse<'_>,
    given: &ExperimentFormat,
    folder: &Path,
) -> Result<Specimen, SceneError> {
    let specimen = &given.specimen;
    let own = [
        ("material", specimen.material.is_some()),
        ("thickness", specimen.thickness.is_some()),
        ("hole", specimen.hole.is_some()),
        ("plane", specimen.plane.is_some()),
    ];
    let Some(scene) = &specimen.scene else {
        return alone(refuse, specimen, &given.plies);
    };
    if let Some((name, _)) = own.iter().find(|(_, given)| *given) {
        let message = format!("the specimen's {name} is that of its scene");
        let remedy = "leave it out, or change it by overrides = [\"key=value\"]";
        return Err(refuse.conflict(&format!("specimen.{name}"), message, remedy));
    }
    of_scene(refuse, specimen, &folder.join(scene))
}

fn of_scene(
    refuse: Refuse<'_>,
    given: &SpecimenFormat,
    path: &Path,
) -> Result<Specimen, SceneError> {
    if refuse.0.host.system.length(path).is_err() {
        let message = format!("there is no scene file '{}'", path.display());
        let remedy = "the path is relative to the folder of the experiment file";
        return Err(refuse.conflict("specimen.scene", message, remedy));
    }
    let scene = Scene::from_file(path, &given.overrides, refuse.0.host)?;
    has_mesh(refuse, &scene)?;
    let body = body_of(refuse, given, &scene)?;
    let Some(found) = scene.bodies.get(&body) else {
        let known = scene.bodies.keys().cloned();
        return Err(refuse.undefined("body", "specimen.body", &body, known));
    };
    let hole = || found.shape.only_hole();
    let edge = given.edge.clone();
    let edge = edge.unwrap_or_else(|| hole().map_or("hole".into(), |edge| edge.name).into_owned());
    let Some(radius) = found.shape.circle(&edge) else {
        let edges = found.shape.edges().into_iter();
        let round = edges.filter(|edge| edge.circle().is_some());
        let known = round.map(|edge| edge.name.into_owned());
        return Err(refuse.undefined("circular edge", "specimen.edge", &edge, known));
    };
    let Substance::Elastic {
        material,
        thickness,
    } = &found.substance
    else {
        let message = format!("body '{body}' is rigid and shows no displacements");
        let remedy = "name an elastic body";
        return Err(refuse.conflict("specimen.body", message, remedy));
    };
    let Some(material) = scene.materials.get(material).cloned() else {
        let known = scene.materials.keys().cloned();
        return Err(refuse.undefined("material", "specimen.body", material, known));
    };
    let (plane, thickness) = (scene.analysis.plane, *thickness);
    let own = SpecimenScene {
        scene: Arc::new(scene),
        body,
        edge,
    };
    Ok(Specimen {
        material,
        plane,
        thickness,
        hole: Hole {
            centre: centre_of(&own.scene, &own.body, &own.edge),
            radius,
        },
        model: Some(model_of(refuse, given, path, &own)?),
        scene: Some(own),
    })
}

/// The body that is named, or the only one with a hole.
fn body_of(
    refuse: Refuse<'_>,
    given: &SpecimenFormat,
    scene: &Scene,
) -> Result<String, SceneError> {
    let bodies = scene.bodies.iter();
    let holes: Vec<&String> = bodies
        .filter(|(_, body)| body.shape.edge_with(Role::Hole).is_some())
        .map(|(name, _)| name)
        .collect();
    match (&given.body, &holes[..]) {
        (Some(name), _) => Ok(name.clone()),
        (None, [only]) => Ok((*only).clone()),
        (None, []) => Err(refuse.missing("specimen", "body", "body = \"plate\"")),
        (None, several) => Err(refuse.missing("specimen", "body", &one_of("body", several))),
    }
}

/// Measured displacements are compared with those of finite elements.
fn has_mesh(refuse: Refuse<'_>, scene: &Scene) -> Result<(), SceneError> {
    let mut bodies = scene.bodies.values();
    let by_series = bodies.any(|body| body.model.is_closed_form());
    if scene.is_divided_anywhere() && !by_series {
        return Ok(());
    }
    let message =
        "the scene of a specimen needs a mesh, on which measured displacements are compared";
    let remedy = "add [mesh] to the scene, or specimen.overrides = [\"mesh.spacing=2 deg\"], without model = \"series\" or \"half-plane\"";
    Err(refuse.conflict("specimen.scene", message, remedy))
}

/// The scene as it is fitted: with `model_overrides` on top of the others. Its hole and its loads are those of the experiment.
fn model_of(
    refuse: Refuse<'_>,
    given: &SpecimenFormat,
    path: &Path,
    own: &SpecimenScene,
) -> Result<SpecimenScene, SceneError> {
    if given.model_overrides.is_empty() {
        return Ok(own.clone());
    }
    let overrides = given.overrides.iter().chain(&given.model_overrides);
    let scene = Scene::from_file(path, &overrides.collect::<Vec<_>>(), refuse.0.host)?;
    has_mesh(refuse, &scene)?;
    let circle = |scene: &Scene| {
        let body = scene.bodies.get(&own.body)?;
        let centre = centre_of(scene, &own.body, &own.edge);
        Some((centre, body.shape.circle(&own.edge)?))
    };
    if circle(&scene) != circle(&own.scene) {
        return Err(refuse.conflict(
            "specimen.model_overrides",
            format!(
                "the model's '{}.{}' is not the circle of the scene",
                own.body, own.edge
            ),
            "override the model's mesh or constants, and leave its hole alone",
        ));
    }
    if let Some(difference) = other_load(&scene, &own.scene) {
        let message = format!(
            "the model is not loaded as the scene: {difference}; states would be fitted under loads that they were not made with"
        );
        let remedy = "override the model's mesh or constants, and leave its loads alone; overrides = [\"key=value\"] changes the loads of both";
        return Err(refuse.conflict("specimen.model_overrides", message, remedy));
    }
    Ok(SpecimenScene {
        scene: Arc::new(scene),
        body: own.body.clone(),
        edge: own.edge.clone(),
    })
}

/// The first load of a model that is not that of the scene, as text.
fn other_load(model: &Scene, scene: &Scene) -> Option<String> {
    let [of_model, of_scene] = [model.loads.len(), scene.loads.len()];
    if of_model != of_scene {
        return Some(format!("it has {of_model} loads, and the scene {of_scene}"));
    }
    let mut pairs = model.loads.iter().zip(&scene.loads);
    let (own, load) = pairs.find(|(own, load)| own.kind != load.kind)?;
    let [steps, expected] = [own, load].map(|load| load.kind.steps());
    if steps.len() != expected.len() {
        let [steps, expected] = [steps, expected].map(<[f64]>::len);
        return Some(format!(
            "its load '{}' has {steps} steps, and that of the scene {expected}",
            own.name
        ));
    }
    let other = (0..steps.len()).find(|&step| steps[step] != expected[step]);
    Some(other.map_or_else(
        || format!("its load '{}' is another one", own.name),
        |step| {
            format!(
                "its load '{}' is another one in step {}",
                own.name,
                step + 1
            )
        },
    ))
}

/// A specimen without a scene. Its material is read as one of a small scene, so that it has the grammar of scenes to the last key.
fn alone(
    refuse: Refuse<'_>,
    given: &SpecimenFormat,
    plies: &Map<String, Value>,
) -> Result<Specimen, SceneError> {
    needs_no_scene(refuse, given)?;
    let Some(material) = &given.material else {
        let example = "material.isotropic = { young = \"70 GPa\", poisson = 0.33 }, or a scene = \"scene.toml\"";
        return Err(refuse.missing("specimen", "material", example));
    };
    let Some(hole) = &given.hole else {
        let example = "hole = { centre = [\"0 mm\", \"0 mm\"], radius = \"9.5 mm\" }";
        return Err(refuse.missing("specimen", "hole", example));
    };
    let text = small_scene(given, material, hole, plies);
    let none: [&str; 0] = [];
    let scene = Scene::from_text(&text.to_string(), Format::Json, OWN, Path::new(""), &none)
        .map_err(|error| relocated(refuse, &error))?;
    let (Some(material), Some(Substance::Elastic { thickness, .. })) = (
        scene.materials.get(OWN).cloned(),
        scene.bodies.get(OWN).map(|body| &body.substance),
    ) else {
        return Err(refuse.missing("specimen", "thickness", "thickness = \"1.5 mm\""));
    };
    Ok(Specimen {
        material,
        plane: scene.analysis.plane,
        thickness: *thickness,
        hole: Hole {
            centre: place(&hole.centre),
            radius: hole.radius.value(),
        },
        scene: None,
        model: None,
    })
}

/// Refuses keys that belong to a scene.
fn needs_no_scene(refuse: Refuse<'_>, given: &SpecimenFormat) -> Result<(), SceneError> {
    for (name, unfit) in [
        ("body", given.body.is_some()),
        ("edge", given.edge.is_some()),
        ("overrides", !given.overrides.is_empty()),
        ("model_overrides", !given.model_overrides.is_empty()),
    ] {
        if unfit {
            let message = format!("'{name}' belongs to a scene, and none is given");
            let remedy = "add scene = \"scene.toml\", or leave it out";
            return Err(refuse.conflict(&format!("specimen.{name}"), message, remedy));
        }
    }
    Ok(())
}

/// A scene of a disk of this material and thickness.
fn small_scene(
    given: &SpecimenFormat,
    material: &Value,
    hole: &HoleFormat,
    plies: &Map<String, Value>,
) -> Value {
    let mut body = json!({
        "material": OWN,
        "shape": { "disk": { "radius": hole.radius.text() } },
    });
    if let Some(thickness) = &given.thickness {
        body["thickness"] = thickness.text().into();
    }
    json!({
        "version": stickslip_scene::VERSION,
        "analysis": { "plane": given.plane.unwrap_or(PlaneState::Stress) },
        "plies": plies,
        "materials": { OWN: material },
        "bodies": { OWN: body },
        "mesh": { "spacing": "30 deg" },
        "supports": [{ "on": format!("{OWN}.centre"), "fix": ["x", "y"] }],
        "loads": [{ "on": format!("{OWN}.rim"), "pressure": { "steps": ["1 MPa"] } }],
    })
}

/// What the small scene says of a material, at the key of the experiment that it came from.
fn relocated(refuse: Refuse<'_>, error: &SceneError) -> SceneError {
    let findings = error.findings().iter().map(|finding| {
        let rest = |prefix: &str| finding.key.strip_prefix(prefix).map(str::to_owned);
        let key = match rest("materials.specimen") {
            Some(rest) => format!("specimen.material{rest}"),
            None => rest("bodies.").unwrap_or_else(|| finding.key.clone()),
        };
        let mut problem = finding.problem.clone();
        if let SceneProblem::MissingKey { table, .. } = &mut problem {
            key.clone_into(table);
        }
        refuse.0.finding(&key, Part::Value, problem)
    });
    let mut findings = findings.collect::<Vec<_>>().into_iter();
    match findings.next() {
        Some(first) => SceneError::new(first, findings),
        None => error.clone(),
    }
}
