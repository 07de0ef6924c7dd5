//! `stickslip check`: the scene as it will be understood and modelled.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Value, json};
use stickslip_laminate::Curvature;

use super::SceneArguments;
use super::console::Console;
use super::experiment::{self, Kind, kind_of};
use super::failure::{CommandError, Failure};
use super::located::locate;
use crate::folder::write_new;
use stickslip_engine::model::{Model, ModelBody, ModelBodyKind, ModelError};
use stickslip_present::results::{SketchBody, findings_json, sentence, sketch};
use stickslip_report::axis::ends;
use stickslip_report::raster::{DEFAULT_SCALE, to_png};
use stickslip_scene::Scene;
use stickslip_scene::schema::{Accuracy, Body, Division, LoadKind, MeshSettings, Substance};
use stickslip_scene::units::{Dimension, Unit};
use stickslip_text::counted;

const DEGREE: Unit = Unit {
    name: "deg",
    dimension: Dimension::Angle,
    in_base: std::f64::consts::PI / 180.0,
};

#[derive(Debug, Args)]
pub(super) struct CheckArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Draw the scene as it would be modelled into a new file, PICTURE.svg or PICTURE.png
    #[arg(long, value_name = "PICTURE")]
    sketch: Option<PathBuf>,
}

/// Draws bodies, contacts, supports and loads into a file that must not exist.
fn draw(scene: &Scene, model: &Model, path: &Path) -> Result<(), CommandError> {
    let refused = |cause: String| CommandError::Sketch {
        path: path.display().to_string(),
        cause,
    };
    let body = |body: &ModelBody| {
        let own = body.elastic();
        let mesh = own
            .map(|own| model.placed(&body.name, own.mesh()))
            .transpose();
        Ok((body.name.clone(), mesh?))
    };
    let bodies: Result<Vec<SketchBody>, ModelError> = model.bodies.iter().map(body).collect();
    let bodies = bodies.map_err(|cause| refused(cause.to_string()))?;
    let picture = sketch(&scene.title, &bodies, &model.problem, scene.display);
    let picture = picture.map_err(|cause| refused(cause.to_string()))?;
    let picture = picture.ok_or_else(|| refused("no body of the scene has a mesh".to_owned()))?;
    let extension = path
        .extension()
        .map(|own| own.to_string_lossy().to_lowercase());
    let bytes = match extension.as_deref() {
        Some("svg") => picture.as_str().as_bytes().to_vec(),
        Some("png") => {
            to_png(&picture, DEFAULT_SCALE).map_err(|cause| refused(cause.to_string()))?
        }
        _ => {
            return Err(refused(
                "its name ends neither in .svg nor in .png".to_owned(),
            ));
        }
    };
    write_new(path, &bytes).map_err(|cause| refused(cause.to_string()))
}

/// Prints the resolved scene, or what an experiment says. The summary of a scene stands in comments, so that the output is a scene again.
pub(super) fn check(given: &CheckArguments, console: Console) -> Result<(), Failure> {
    let arguments = &given.scene;
    match kind_of(&arguments.scene) {
        Some(Kind::Experiment) if given.sketch.is_some() => {
            let path = arguments.scene.display().to_string();
            return Err(CommandError::ExperimentGiven { path }.into());
        }
        Some(Kind::Experiment) => {
            return experiment::check(&arguments.scene, &arguments.overrides, console);
        }
        Some(Kind::Sweep) => {
            let path = arguments.scene.display().to_string();
            return Err(CommandError::SweepGiven { path }.into());
        }
        Some(Kind::Scene) | None => {}
    }
    let scene = arguments.read()?;
    let model = Model::build(&scene).map_err(|error| locate(&scene, &error))?;
    if let Some(path) = &given.sketch {
        draw(&scene, &model, path)?;
    }
    let outline = outline(&scene, &model);
    let text = || {
        let comment = |(name, text): &(&str, String)| format!("# {name:8} {text}");
        let comments: Vec<_> = outline.iter().map(comment).collect();
        format!("{}\n\n{}", comments.join("\n"), scene.resolved())
    };
    console.result(text, &summary(&scene, &model, &outline))
}

fn summary(scene: &Scene, model: &Model, outline: &[(&str, String)]) -> Value {
    let lines: Vec<_> = outline
        .iter()
        .map(|(name, text)| json!({ "what": name, "text": text }))
        .collect();
    // The resolved text was written from a table a moment ago, so it is one.
    let resolved: Value = toml::from_str(scene.resolved()).unwrap_or_default();
    json!({
        "scene": scene.source_name,
        "title": scene.title,
        "hash": scene.hash,
        "steps": scene.steps(),
        "model": lines,
        "findings": findings_json(&model.findings, scene.display),
        "resolved": resolved,
    })
}

/// What would be modelled, line by line.
fn outline(scene: &Scene, model: &Model) -> Vec<(&'static str, String)> {
    let mut lines = vec![("scene", format!("{} – {}", scene.source_name, scene.title))];
    for (name, body) in &scene.bodies {
        lines.push(("body", format!("{name}: {}", body_line(scene, body))));
    }
    lines.extend(laminates(scene));
    let is_pinned = scene.is_divided_anywhere() || scene.analysis.contact_nodes.is_some();
    let asked = scene.analysis.accuracy;
    let asked = asked.or((!is_pinned).then_some(Accuracy::DEFAULT));
    lines.extend(asked.map(|asked| ("accuracy", accuracy_line(asked))));
    if scene.is_divided_anywhere() {
        lines.push(("mesh", mesh_line(scene, &scene.mesh)));
    } else {
        lines.push((
            "mesh",
            "chosen for the accuracy, of the coarsest model:".to_owned(),
        ));
    }
    for body in &model.bodies {
        if let ModelBodyKind::Elastic(elastic) = &body.kind {
            let own = scene
                .bodies
                .get(&body.name)
                .and_then(|body| body.mesh.as_ref());
            let own = own.map_or_else(String::new, |own| format!("; {}", mesh_line(scene, own)));
            let (nodes, elements) = (elastic.mesh().nodes().len(), elastic.mesh().element_count());
            lines.push((
                "mesh",
                format!("{}: {nodes} nodes, {elements} elements{own}", body.name),
            ));
        }
    }
    for choice in &model.choices {
        lines.push((
            "choice",
            format!("{}: {} – {}", choice.what, choice.value, choice.reason),
        ));
    }
    let notes = model.findings.iter();
    lines.extend(notes.map(|finding| ("note", sentence(finding, scene.display))));
    for contact in &scene.contacts {
        lines.push((
            "contact",
            format!(
                "{}: {} on {}, {}",
                contact.name,
                contact.first,
                contact.second,
                contact.law.name()
            ),
        ));
    }
    lines.extend(failure_line(scene).map(|line| ("failure", line)));
    for load in &scene.loads {
        lines.push((
            "load",
            format!("{}: {}", load.name, load_line(scene, &load.kind)),
        ));
    }
    let steps = counted(scene.steps(), "load step");
    let divided = match scene.analysis.substeps {
        None if scene.seeks_accuracy() => {
            "each in as many increments as its accuracy needs".to_owned()
        }
        _ => format!("each in {}", counted(scene.analysis.substeps(), "sub-step")),
    };
    lines.push(("history", format!("{steps}, {divided}")));
    lines.push(("hash", scene.hash.clone()));
    lines
}

fn body_line(scene: &Scene, body: &Body) -> String {
    let show = |value: f64| scene.display.length.show(value);
    let shape = body.shape.describe(&show);
    match &body.substance {
        Substance::Elastic {
            material,
            thickness,
        } => {
            format!("{shape}, {material}, {} thick", show(*thickness))
        }
        Substance::Rigid => format!("{shape}, rigid"),
    }
}

/// What is asked for.
fn accuracy_line(asked: Accuracy) -> String {
    match asked {
        Accuracy::Overall(error) => format!(
            "{error} of peak pressure, peak tangential stress, extent of contact and friction force"
        ),
        Accuracy::Named(bounds) => {
            let each = bounds
                .entries()
                .map(|(name, error)| format!("{error} of {name}"));
            each.collect::<Vec<_>>().join(", ")
        }
    }
}

fn mesh_line(scene: &Scene, settings: &MeshSettings) -> String {
    let element = settings.element;
    match &settings.division {
        Division::AngleList(angles) => format!("{element:?}, {} given angles", angles.len()),
        Division::Angular(grading) => {
            format!(
                "{element:?}, corner nodes every {} at θ = 0",
                DEGREE.show(grading.spacing)
            )
        }
        Division::Linear(grading) => {
            let spacing = scene.display.length.show(grading.spacing);
            format!("{element:?}, corner nodes every {spacing} at the contact point")
        }
        Division::Places(places) => format!("{element:?}, {} given places", places.len()),
    }
}

/// Thickness, moduli and coupling of every laminate, and what its cure leaves.
fn laminates(scene: &Scene) -> Vec<(&'static str, String)> {
    let mut lines = Vec::new();
    for (name, material) in &scene.materials {
        let Some(sheet) = material.laminate() else {
            continue;
        };
        let laminate = &sheet.laminate;
        let stress = |value: f64| scene.display.stress.show(value);
        let moduli = laminate.membrane_moduli(Curvature::Suppressed);
        let coupling = laminate.coupling();
        lines.push((
            "laminate",
            format!(
                "{name}: {}, {} plies, {} thick",
                sheet.layup,
                laminate.layers().len(),
                scene.display.length.show(laminate.thickness())
            ),
        ));
        lines.push((
            "laminate",
            format!(
                "{name}: Ex {}, Ey {}, Gxy {}, νxy {:.4}; coupling of stretching with bending {:.2e}, with shear {:.2e}",
                stress(moduli.ex),
                stress(moduli.ey),
                stress(moduli.gxy),
                moduli.nuxy,
                coupling.bending_extension,
                coupling.extension_shear
            ),
        ));
        if sheet.cure != 0.0 {
            let states = laminate.residual_states(sheet.cure);
            let largest = states
                .iter()
                .map(|state| state.stress[1])
                .fold(0.0, f64::max);
            lines.push((
                "laminate",
                format!(
                    "{name}: {} K since the cure leave up to {} across the fibres",
                    sheet.cure,
                    stress(largest)
                ),
            ));
        }
    }
    lines
}

fn failure_line(scene: &Scene) -> Option<String> {
    let failure = scene.failure.as_ref()?;
    let names: Vec<_> = failure
        .criteria
        .iter()
        .map(|criterion| criterion.name())
        .collect();
    let line = format!(
        "{} in the plies of {}",
        names.join(", "),
        failure.bodies.join(", ")
    );
    let show = |value: f64| scene.display.length.show(value);
    Some(match failure.characteristic {
        None => line,
        Some(distances) => format!(
            "{line}; characteristic distances {} (tension) and {} (compression)",
            show(distances.tension),
            show(distances.compression)
        ),
    })
}

/// Four digits after the point, without minus zero.
fn rounded(value: f64) -> f64 {
    (value * 1e4).round() / 1e4 + 0.0
}

fn load_line(scene: &Scene, kind: &LoadKind) -> String {
    let range = |steps: &[f64], show: &dyn Fn(f64) -> String| {
        let [least, greatest] = ends(steps.iter().copied());
        if least == greatest {
            show(least)
        } else {
            format!("{} to {}", show(least), show(greatest))
        }
    };
    let kelvin = |value: f64| format!("{value} {}", Dimension::Temperature.base_unit());
    match kind {
        LoadKind::Force {
            on,
            direction: [x, y],
            steps,
        } => {
            let force = range(steps, &|value| scene.display.force.show(value));
            format!(
                "force on {on} along [{}, {}], {force}",
                rounded(*x),
                rounded(*y)
            )
        }
        LoadKind::Bearing {
            on,
            direction: [x, y],
            law,
            steps,
        } => {
            let force = range(steps, &|value| scene.display.force.show(value));
            format!(
                "{} bearing pressure on {on} along [{}, {}], {force}",
                law.name(),
                rounded(*x),
                rounded(*y)
            )
        }
        LoadKind::Pressure { on, steps } => {
            format!(
                "pressure on {on}, {}",
                range(steps, &|value| scene.display.stress.show(value))
            )
        }
        LoadKind::PolarTraction { on, table, steps } => format!(
            "tractions on {on} from {} ({} rows), factor {}",
            table.file.display(),
            table.theta.len(),
            range(steps, &|value| value.to_string())
        ),
        LoadKind::Temperature { body, steps } => {
            format!("temperature change of {body}, {}", range(steps, &kelvin))
        }
    }
}
