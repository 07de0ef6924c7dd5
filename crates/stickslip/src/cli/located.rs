//! Errors of models and runs, at the line of the scene that causes them.

use stickslip_contact::ContactError;
use stickslip_contact::solver::FailureCause;
use stickslip_engine::model::{LoadTable, ModelError};
use stickslip_engine::results::LoadValue;
use stickslip_engine::run::{MovingBody, RunError, WholeMotion};
use stickslip_fem_core::BodyError;
use stickslip_present::results::quoted;
use stickslip_scene::Scene;
use stickslip_scene::diagnostic::{SceneError, SceneProblem};
use stickslip_scene::schema::{BodyModel, Division, KinematicsChoice, SolverChoice};

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
        ModelError::NotSeries { body, .. } => {
            let own = format!("bodies.{body}");
            let own = match scene.bodies.get(body).map(|body| body.model) {
                Some(BodyModel::Auto) | None => own,
                Some(_) => own + ".model",
            };
            (own, "say model = \"elements\" or \"auto\", and give a mesh")
        }
        ModelError::Contradiction { index, .. } => (
            format!("supports.{index}"),
            "move both alike, hold one of them along the other direction alone, or let it end before the other by an edge of its own between them",
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
        Division::Angular(_) | Division::Linear(_) | Division::Places(_) => table + ".spacing",
    }
}

fn has_own_mesh(scene: &Scene, body: &str) -> bool {
    let body = scene.bodies.get(body);
    body.is_some_and(|body| body.shape.has_own_mesh())
}

/// The names of `bodies`. A model numbers its bodies in the order of their names.
fn names<'a>(scene: &'a Scene, bodies: &[usize]) -> Vec<&'a str> {
    let all: Vec<&String> = scene.bodies.keys().collect();
    let own = bodies.iter().filter_map(|&body| all.get(body));
    own.map(|name| name.as_str()).collect()
}

/// Indices of the loads that act on `bodies`; all where these are all bodies.
fn loads_on(scene: &Scene, bodies: &[usize]) -> Vec<usize> {
    let names = names(scene, bodies);
    let loads = scene.loads.iter().enumerate();
    loads
        .filter(|(_, load)| bodies.is_empty() || names.contains(&load.kind.body()))
        .map(|(index, _)| index)
        .collect()
}

/// Indices of the supports that move on `bodies`; all where these are all bodies.
fn drives_on(scene: &Scene, bodies: &[usize]) -> Vec<usize> {
    let names = names(scene, bodies);
    let moving = scene
        .supports
        .iter()
        .filter(|held| held.displacement != 0.0);
    moving
        .filter(|held| bodies.is_empty() || names.contains(&held.on.body.as_str()))
        .map(|held| held.index)
        .collect()
}

/// The key of what drives a history that came to an end for `bodies`: its load or all loads, or where it has none the support that moves.
fn key_of_drive(scene: &Scene, bodies: &[usize]) -> String {
    let loads = loads_on(scene, bodies);
    match (&loads[..], &drives_on(scene, bodies)[..]) {
        ([only], _) => format!("loads.{only}"),
        ([], [only]) => format!("supports.{only}"),
        ([], [_, ..]) => "supports".to_owned(),
        _ => "loads".to_owned(),
    }
}

/// ", for 'pin' and 'plate'", if these are not all bodies.
fn among(scene: &Scene, bodies: &[usize]) -> String {
    let quoted = quoted(names(scene, bodies));
    if quoted.is_empty() {
        quoted
    } else {
        format!(", for {quoted}")
    }
}

/// The error in words, with the load that a history reached.
fn message(scene: &Scene, error: &RunError) -> String {
    let Some(ContactError::StepFailed {
        step,
        reached,
        bodies,
        cause,
    }) = error.contact()
    else {
        return error.to_string();
    };
    let reached_loads = LoadTable::of(scene).reached(*step, *reached);
    let acting = loads_on(scene, bodies);
    let loads: Vec<&LoadValue> = acting.iter().map(|&index| &reached_loads[index]).collect();
    if loads.is_empty() {
        return error.to_string();
    }
    let value = |load: &&LoadValue| {
        let unit = if load.unit == "1" { "" } else { &load.unit };
        let text = format!("{} {} {unit}", load.name, stickslip_text::short(load.value));
        text.trim_end().to_owned()
    };
    let loads: Vec<String> = loads.iter().map(value).collect();
    let why = match error {
        RunError::Unbalanced { moving, part, .. } => {
            let what = if *part < FailureCause::ROUNDED {
                format!("the loads miss their balance by {part:.0e} of their size")
            } else {
                "the load cannot be balanced".to_owned()
            };
            format!("{what}: {} (proved)", described(moving))
        }
        _ => cause.to_string(),
    };
    format!(
        "load step {} was not solved beyond {}, {reached:.4} of its increment{}{}: {why}",
        step + 1,
        loads.join(", "),
        among(scene, bodies),
        if cause.is_unresolved() {
            " and is unresolved"
        } else {
            ""
        }
    )
}

/// "'pin' slides along x and 'plate' turns clockwise".
fn described(moving: &[MovingBody]) -> String {
    let mut each: Vec<String> = moving.iter().map(MovingBody::describe).collect();
    let last = each.pop().unwrap_or_default();
    if each.is_empty() {
        last
    } else {
        format!("{} and {last}", each.join(", "))
    }
}

/// What stops the bodies that the part `part` of a load moves.
fn against(scene: &Scene, moving: &[MovingBody], part: f64) -> String {
    if part < FailureCause::ROUNDED {
        return "hold the bodies against this motion by a support or springs, or give coordinates and directions with more digits: loads may miss their \
                balance by 1e-10 of their size"
            .to_owned();
    }
    let moves = |body: &String| moving.iter().any(|own| own.body == *body);
    let mut contacts = scene.contacts.iter();
    if contacts.any(|own| moves(&own.first.body) || moves(&own.second.body)) {
        return "let the load's line of action pass through the contact (beside it, it turns the body), add friction or a support against the \
                motion, or turn the load"
            .to_owned();
    }
    let Some(MovingBody { body, motion }) = moving.first() else {
        return "add a support against the motion".to_owned();
    };
    let shape = scene.bodies.get(body).map(|body| &body.shape);
    let set = shape.and_then(|shape| shape.edges().into_iter().next());
    let set = set.map_or_else(|| "edge".into(), |edge| edge.name);
    let fix = match motion {
        WholeMotion::Slides([x, _]) if x.abs() < 1e-6 => "\"y\"",
        WholeMotion::Slides([_, y]) if y.abs() < 1e-6 => "\"x\"",
        _ => "\"x\", \"y\"",
    };
    format!(
        "hold the body against this motion, for example [[supports]] on = \"{body}.{set}\", fix = [{fix}], or by springs, or turn the load"
    )
}

/// What helps where a contact solver finds no answer.
fn against_no_convergence(scene: &Scene) -> &'static str {
    let analysis = &scene.analysis;
    if analysis.kinematics == Some(KinematicsChoice::DeformedGaps) {
        "find contact on the undeformed geometry (--set analysis.kinematics=small), or take smaller steps (--set analysis.substeps=4)"
    } else if analysis.solver == SolverChoice::Auto {
        "take smaller steps (--set analysis.substeps=4) or another solver (--set analysis.solver=pivoting)"
    } else {
        "take smaller steps (--set analysis.substeps=4), or leave analysis.solver out, which tries several"
    }
}

/// The error at the key of the scene that it is about.
pub(super) fn located(scene: &Scene, error: &RunError) -> SceneError {
    let (key, remedy) = match error {
        RunError::Model(error) => return locate(scene, error),
        RunError::Body {
            body,
            cause: BodyError::LoosePart { parts: 2.., .. },
        } if has_own_mesh(scene, body) => (
            format!("bodies.{body}.shape.mesh"),
            "support every part of the mesh that nothing joins to the others, or name the element set that is the body as `elements`; \
             `stickslip check --sketch` draws its parts",
        ),
        RunError::Body {
            body,
            cause: BodyError::ContradictingSupports { .. },
        } => (
            format!("bodies.{body}"),
            "several supports of the body, or a support and its platen, hold one node, a corner or a point, by displacements that cannot all be: move them alike, or let one end before the other by an edge of its own between them",
        ),
        RunError::Body { body, .. } => (
            format!("bodies.{body}"),
            "check the body's supports: it must not be able to move as a whole without contact",
        ),
        RunError::Unbalanced {
            cause,
            part,
            moving,
        } => {
            let key = match cause {
                ContactError::StepFailed { bodies, .. } => key_of_drive(scene, bodies),
                _ => "loads".to_owned(),
            };
            return scene.error_at(
                &key,
                SceneProblem::Model {
                    message: message(scene, error),
                    remedy: against(scene, moving, *part),
                },
            );
        }
        RunError::Contact(ContactError::StepFailed { bodies, .. }) => {
            (key_of_drive(scene, bodies), against_no_convergence(scene))
        }
        RunError::Contact(_) => ("loads".to_owned(), against_no_convergence(scene)),
        RunError::Failure { .. } => (
            "failure".to_owned(),
            "choose other criteria, remove failure.envelopes, or check the strengths of the plies",
        ),
        RunError::Progressive { .. } => (
            "failure.progressive".to_owned(),
            "take smaller increments, a coarser mesh, or hold the bodies so that no load moves them freely",
        ),
        _ => ("mesh".to_owned(), "change the mesh settings"),
    };
    let problem = SceneProblem::Model {
        message: message(scene, error),
        remedy: remedy.to_owned(),
    };
    scene.error_at(&key, problem)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::key_of_drive;
    use stickslip_scene::{Format, Scene};

    /// Two cylinders on blocks: one is loaded, the other, the second of its supports, is driven.
    #[test]
    fn the_key_is_that_of_what_drives_the_bodies() {
        let body = |name: &str, shape: &str| {
            format!("[bodies.{name}]\nmaterial = \"metal\"\nthickness = \"1 mm\"\nshape.{shape}\n")
        };
        let block = "block = { half_length = \"12 mm\", depth = \"12 mm\" }";
        let roller =
            "cylinder = { radius = \"50 mm\", half_length = \"12 mm\", depth = \"12 mm\" }";
        let contact = |first: &str, second: &str| {
            format!(
                "[[contacts]]\nfirst = \"{first}.contact\"\nsecond = \"{second}.contact\"\nfriction.coulomb = {{ mu = 0.4 }}\n"
            )
        };
        let support = |on: &str, fix: &str, more: &str| {
            format!("[[supports]]\non = \"{on}\"\nfix = [{fix}]\n{more}")
        };
        let text = [
            "version = 1\n[materials.metal.isotropic]\nyoung = \"70 GPa\"\npoisson = 0.33\n",
            &body("block", block),
            &body("roller", roller),
            &body("slab", block),
            &body("wheel", roller),
            "[mesh]\nspacing = \"1 mm\"\n",
            &contact("roller", "block"),
            &contact("wheel", "slab"),
            &support("block.bottom", "\"x\", \"y\"", ""),
            &support("slab.bottom", "\"x\", \"y\"", ""),
            &support("wheel.top", "\"x\"", ""),
            &support("wheel.top", "\"y\"", "displacement = \"-0.01 mm\"\n"),
            "[[platens]]\non = \"roller.top\"\nfree = [\"x\", \"y\"]\n",
            "[[loads]]\non = \"roller.top\"\nforce = { direction = [0, -1], steps = [\"300 N\"] }\n",
        ]
        .concat();
        let nothing: [&str; 0] = [];
        let scene =
            Scene::from_text(&text, Format::Toml, "lines.toml", Path::new("."), &nothing).unwrap();
        // Bodies are numbered by name: block, roller, slab, wheel.
        assert_eq!(key_of_drive(&scene, &[0, 1]), "loads.0");
        assert_eq!(key_of_drive(&scene, &[2, 3]), "supports.3");
        assert_eq!(key_of_drive(&scene, &[]), "loads.0");
    }
}
