//! From the file's spelling to a checked scene.
//!
//! Reading stops at the first entry that it does not understand. Here every entry has been understood, so all
//! problems are collected and shown at once.

mod accuracy;
mod bodies;
mod contacts;
mod declared;
mod failure;
mod fasteners;
mod holds;
mod idle;
mod laminates;
mod loads;
mod lumped;
mod mesh;
mod progressive;
mod written;

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::Value;

use super::document::{Document, Part, child};
use super::format::{EdgeFormat, SceneFormat};
use super::open::stem;
use super::overrides::mistyped;
use super::scene::Scene;
use super::schema::{
    Analysis, Body, Contact, Failure, Fastener, KinematicsChoice, Load, Material, MeshSettings,
    Platen, SetRef, SpringSupport, Support,
};
use super::shape::ShapeFormat;
use crate::diagnostic::{Finding, SceneError, SceneProblem, nearest, one_of};

/// Most letters of a name, which is a part of file names.
const LONGEST_NAME: usize = 64;

/// Which of a body's sets fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Fits {
    Edges,
    EdgesAndPoints,
}

/// What the tables of a scene say.
struct Parts {
    analysis: Analysis,
    materials: BTreeMap<String, Material>,
    is_divided: bool,
    mesh: MeshSettings,
    mesh_by_lengths: Option<MeshSettings>,
    contacts: Vec<Contact>,
    fasteners: Vec<Fastener>,
    supports: Vec<Support>,
    springs: Vec<SpringSupport>,
    platens: Vec<Platen>,
    loads: Vec<Load>,
    edges: Vec<SetRef>,
    failure: Option<Failure>,
}

/// Checks the scene. On the way the laws in `format` get their defaults.
pub(super) fn build(
    document: Document,
    mut format: SceneFormat,
    base: &Path,
) -> Result<Scene, SceneError> {
    let mut builder = Builder {
        document: &document,
        base,
        findings: Vec::new(),
        bodies: BTreeMap::new(),
    };
    builder.declared();
    if !leaves_increments(&format) {
        let analysis = &mut format.analysis;
        analysis.substeps = Some(analysis.substeps());
        analysis.ramp = Some(analysis.ramp());
    }
    let parts = builder.parts(&mut format);
    let bodies = builder.finished()?;
    scene(document, &format, base, bodies, parts)
}

/// The scene of `bodies` and `parts`, which the other tables of `format` describe.
fn scene(
    document: Document,
    format: &SceneFormat,
    base: &Path,
    bodies: BTreeMap<String, Body>,
    parts: Parts,
) -> Result<Scene, SceneError> {
    let source_name = document.source.name.clone();
    // The version has been checked, and the tables that are not named here have been built above.
    let SceneFormat {
        version: _,
        title,
        description,
        units,
        analysis: _,
        plies: _,
        materials: _,
        bodies: _,
        mesh: _,
        contacts: _,
        fasteners: _,
        supports: _,
        platens: _,
        loads: _,
        edges: _,
        failure: _,
        output,
    } = format;
    Ok(Scene {
        title: title.clone().unwrap_or_else(|| stem(&source_name)),
        description: description.clone(),
        display: units.display(),
        analysis: parts.analysis,
        materials: parts.materials,
        hash: written::hash(format, &bodies, &parts.loads),
        bodies,
        mesh: parts.mesh,
        mesh_by_lengths: parts.mesh_by_lengths,
        is_divided: parts.is_divided,
        contacts: parts.contacts,
        fasteners: parts.fasteners,
        supports: parts.supports,
        springs: parts.springs,
        platens: parts.platens,
        loads: parts.loads,
        edges: parts.edges,
        failure: parts.failure,
        output: *output,
        source_name,
        base_dir: base.to_owned(),
        resolved: written::resolved(&document, format)?,
        document,
    })
}

/// Whether increments of load steps that are not given are left to the program, as [`Scene::seeks_accuracy`] says.
fn leaves_increments(format: &SceneFormat) -> bool {
    let analysis = &format.analysis;
    let mut own = format.bodies.values().map(|body| &body.mesh);
    let mut shapes = format.bodies.values().map(|body| &body.shape);
    let is_divided =
        format.mesh.is_some() || own.any(Option::is_some) || shapes.any(ShapeFormat::has_own_mesh);
    analysis.accuracy.is_some()
        || !is_divided
        || analysis.kinematics == Some(KinematicsChoice::Auto)
}

/// What a scene's materials are, by their names.
type Materials = BTreeMap<String, Material>;

/// What has been built and found so far.
struct Builder<'a> {
    document: &'a Document,
    /// The folder that data files are relative to.
    base: &'a Path,
    findings: Vec<Finding>,
    bodies: BTreeMap<String, Body>,
}

/// What stands around the slices of fasteners.
struct BesideSlices<'a> {
    materials: &'a Materials,
    contacts: &'a [Contact],
    supports: &'a [Support],
    springs: &'a [SpringSupport],
    platens: &'a [Platen],
}

/// What surrounds the body whose plies fail.
struct Surroundings<'a> {
    contacts: &'a [Contact],
    supports: &'a [Support],
    springs: &'a [SpringSupport],
    platens: &'a [Platen],
    loads: &'a [Load],
    /// Their numbers in the scene.
    numbers: &'a [usize],
}

impl Builder<'_> {
    /// The bodies, or everything that was found wrong.
    fn finished(self) -> Result<BTreeMap<String, Body>, SceneError> {
        SceneError::of_all(self.findings)?;
        Ok(self.bodies)
    }

    /// What the tables of `format` say, each checked with those before it.
    fn parts(&mut self, format: &mut SceneFormat) -> Parts {
        let analysis = self.analysis(format);
        let plies = self.plies(format);
        let materials = self.materials(format, &plies, analysis.plane);
        self.bodies(format, &materials);
        let is_divided = format.mesh.is_some();
        let (mesh, mesh_by_lengths) = self.mesh(format);
        self.body_meshes(format, &mesh);
        self.models(format);
        let contacts = self.contacts(format, &materials);
        self.stand_once(&contacts);
        let (supports, springs) = self.supports(format);
        let platens = self.platens(format, &contacts);
        let beside = BesideSlices {
            materials: &materials,
            contacts: &contacts,
            supports: &supports,
            springs: &springs,
            platens: &platens,
        };
        let fasteners = self.fasteners(format, &beside);
        let loads = self.loads(format, &materials, self.base);
        let (numbers, loads): (Vec<_>, Vec<_>) = loads.into_iter().unzip();
        let edges = self.edges(format);
        let surroundings = Surroundings {
            contacts: &contacts,
            supports: &supports,
            springs: &springs,
            platens: &platens,
            loads: &loads,
            numbers: &numbers,
        };
        let failure = self.failure(format, &materials, &surroundings);
        self.loads_act(&surroundings);
        let held = (supports.iter().map(|own| &own.on))
            .chain(springs.iter().map(|own| &own.on))
            .chain(platens.iter().map(|own| &own.on));
        self.everything_is_held(&contacts, &fasteners, &held.collect::<Vec<_>>());
        if !failure.as_ref().is_some_and(Failure::is_driven) {
            self.something_happens(&contacts, &supports, &loads);
        }
        Parts {
            analysis,
            materials,
            is_divided,
            mesh,
            mesh_by_lengths,
            contacts,
            fasteners,
            supports,
            springs,
            platens,
            loads,
            edges,
            failure,
        }
    }

    fn report(&mut self, key: &str, part: Part, problem: SceneProblem) {
        let problem = mistyped(self.document, key, problem);
        self.findings
            .push(self.document.finding(key, part, problem));
    }

    fn conflict(&mut self, key: &str, message: impl Into<String>, remedy: impl Into<String>) {
        self.report(key, Part::Value, SceneProblem::conflict(message, remedy));
    }

    fn missing(&mut self, table: &str, name: &str) {
        let example = super::examples::example(&child(table, name));
        self.missing_as(table, name, example);
    }

    /// A missing name, of which the scene has `known`.
    fn missing_name(&mut self, table: &str, name: &str, known: &[String]) {
        self.missing_as(table, name, one_of(name, known));
    }

    fn missing_as(&mut self, table: &str, name: &str, example: String) {
        let problem = SceneProblem::MissingKey {
            key: name.to_owned(),
            table: table.to_owned(),
            example,
        };
        self.report(table, Part::Key, problem);
    }

    fn out_of_range(&mut self, key: &str, value: &str, allowed: impl Into<String>) {
        let problem = SceneProblem::out_of_range(key, value, allowed);
        self.report(key, Part::Value, problem);
    }

    /// Whether something below `key` has been refused, and needs no second message.
    fn is_refused(&self, key: &str) -> bool {
        let below = |finding: &Finding| {
            let rest = finding.key.strip_prefix(key);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        self.findings.iter().any(below)
    }

    /// Whether `key` itself has been refused.
    fn is_refused_at(&self, key: &str) -> bool {
        self.findings.iter().any(|finding| finding.key == key)
    }

    /// Entries of the list `name` as written; fewer were read where some are refused.
    fn written(&self, name: &str) -> usize {
        let list = self.document.get(name).and_then(Value::as_array);
        list.map_or(0, Vec::len)
    }

    /// Names are parts of keys and of file names.
    fn name(&mut self, table: &str, name: &str) {
        let plain = |letter: char| letter.is_ascii_alphanumeric() || letter == '_' || letter == '-';
        if name.is_empty() || name.len() > LONGEST_NAME || !name.chars().all(plain) {
            let allowed = "made of 1 to 64 letters a–z, digits, '_' and '-'";
            let problem = SceneProblem::OutOfRange {
                key: "name".to_owned(),
                value: format!("\"{name}\""),
                allowed: allowed.to_owned(),
            };
            self.report(&child(table, name), Part::Key, problem);
        }
    }

    fn undefined(&mut self, key: &str, what: &'static str, name: &str, known: Vec<String>) {
        let problem = SceneProblem::undefined(what, name, known);
        self.report(key, Part::Value, problem);
    }

    /// The set that `text` names, if it exists and fits.
    fn set(&mut self, key: &str, text: &str, fits: Fits) -> Option<SetRef> {
        let names: Vec<String> = self.bodies.keys().cloned().collect();
        let (name, set) = text.split_once('.').unwrap_or((text, ""));
        let Some(body) = self.bodies.get(name) else {
            self.undefined(key, "body", name, names);
            return None;
        };
        // Of a file that was refused no set is known, and that needs no second message.
        if body.shape.has_own_mesh() && self.is_refused(&format!("bodies.{name}.shape")) {
            return None;
        }
        let (points, areas) = match fits {
            Fits::Edges => (Vec::new(), &[][..]),
            Fits::EdgesAndPoints => (body.shape.points(), body.shape.areas()),
        };
        let edges = body.shape.edges().into_iter().map(|edge| edge.name);
        let points = points.into_iter().map(|(name, _)| name);
        let areas = areas.iter().map(|&name| name.into());
        let sets: Vec<_> = edges.chain(points).chain(areas).collect();
        if sets.iter().any(|known| known == set) {
            return Some(SetRef {
                body: name.to_owned(),
                set: set.to_owned(),
            });
        }
        let problem = SceneProblem::MissingSet {
            body: name.to_owned(),
            shape: body.shape.name(),
            what: match fits {
                Fits::Edges => "edge",
                Fits::EdgesAndPoints => "edge, point or area",
            },
            set: set.to_owned(),
            nearest: nearest(set, sets.iter().map(|known| &**known))
                .map(|set| format!("{name}.{set}")),
            known: sets.iter().map(|set| format!("{name}.{set}")).collect(),
            notes: body.shape.notes().iter().map(ToString::to_string).collect(),
        };
        self.report(key, Part::Value, problem);
        None
    }

    fn analysis(&mut self, format: &SceneFormat) -> Analysis {
        let analysis = format.analysis;
        let info = analysis.solver.info();
        if info.experimental && !analysis.experimental {
            self.conflict(
                "analysis.solver",
                format!(
                    "the solver \"{}\" is experimental: its answers may be inexact, or it may stop at few points",
                    info.name
                ),
                "set analysis.experimental = true, or leave the solver out",
            );
        }
        self.demand(&analysis);
        analysis
    }

    fn edges(&mut self, format: &SceneFormat) -> Vec<SetRef> {
        let mut edges = Vec::new();
        for (index, EdgeFormat { on }) in format.edges.iter().enumerate() {
            let key = format!("edges.{index}.on");
            let Some(found) = self.set(&key, on, Fits::Edges) else {
                continue;
            };
            if edges.contains(&found) {
                self.conflict(
                    &key,
                    format!("{found} is listed twice"),
                    "remove one of the two",
                );
            } else {
                edges.push(found);
            }
        }
        edges
    }

    fn something_happens(&mut self, contacts: &[Contact], supports: &[Support], loads: &[Load]) {
        let happens = !loads.is_empty()
            || contacts.iter().any(|contact| contact.interference)
            || supports.iter().any(|support| support.displacement != 0.0);
        // A load that could not be read has been reported already.
        let was_meant =
            matches!(self.document.get("loads"), Some(Value::Array(list)) if !list.is_empty());
        if !happens && !was_meant {
            let message =
                "nothing happens in this scene: no load, no interference, no given displacement";
            let remedy = "add a load, for example [[loads]] on = \"plate.left\", force = { direction = [-1, 0], steps = [\"1 kN\"] }";
            self.conflict("", message, remedy);
        }
    }
}
