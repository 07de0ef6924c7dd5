//! A checked scene.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::Deserialize;
use serde_json::Value;
use sha2::{Digest, Sha256};

use crate::diagnostic::{Finding, SceneError, SceneProblem, SourceText};
use crate::document::{Document, Format, Part};
use crate::format::SceneFormat;
use crate::host::Host;
use crate::limits::{Content, Limits};
use crate::read::Reader;
use crate::schema::{
    Analysis, Body, Contact, DisplayUnits, Failure, Load, LoadKind, Material, MeshSettings, Output,
    Platen, SetRef, Support,
};
use crate::units::{Dimension, Expected, parse};
use crate::{build, overrides};

/// Version of the scene format that this program reads.
pub const VERSION: u64 = 1;

/// A checked scene. Numbers are in mm, N, MPa, rad and K.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Title; the name of the file where the scene has none.
    pub title: String,
    /// What the scene shows, in the words of its author.
    pub description: Option<String>,
    /// Units that results are shown in.
    pub display: DisplayUnits,
    /// How the model is solved.
    pub analysis: Analysis,
    /// Materials by name.
    pub materials: BTreeMap<String, Material>,
    /// Bodies by name.
    pub bodies: BTreeMap<String, Body>,
    /// How finely the bodies are divided.
    pub mesh: MeshSettings,
    /// Pairs of edges that may touch.
    pub contacts: Vec<Contact>,
    /// Nodes with given displacements.
    pub supports: Vec<Support>,
    /// Rigid plates glued to edges.
    pub platens: Vec<Platen>,
    /// Loads; all have [`steps`](Self::steps) steps.
    pub loads: Vec<Load>,
    /// Edges to report besides those in contact.
    pub edges: Vec<SetRef>,
    /// Settings of the failure analysis of laminates.
    pub failure: Option<Failure>,
    /// What is written beside tables.
    pub output: Output,
    /// Path of the scene file as given.
    pub source_name: String,
    /// Folder that data files are relative to.
    pub base_dir: PathBuf,
    /// SHA-256 of the scene in hexadecimal digits: of all keys with defaults filled in, quantities in base units, and of
    /// its data files. Equal scenes have equal hashes whatever their layout, comments and units.
    pub hash: String,
    resolved: String,
    document: Document,
}

impl Scene {
    /// What its model may take.
    pub fn limits(&self) -> Limits {
        self.document.host.limits
    }

    /// The machine that it was read on.
    pub fn host(&self) -> Host {
        self.document.host
    }

    /// Reads and checks a file of `host`, JSON if its name ends in `.json` and otherwise TOML, with the overrides `key=value` applied in
    /// turn. The scene, its data files and its model may take no more than the host's limits.
    ///
    /// # Errors
    /// [`SceneError`] with everything that is wrong, each at its line or in its override; a file that is too large.
    pub fn from_file(
        path: &Path,
        overrides: &[impl AsRef<str>],
        host: Host,
    ) -> Result<Self, SceneError> {
        let name = path.display().to_string();
        let text = host.read_text(path, Content::Document).map_err(|error| {
            let problem = match error.kind() {
                std::io::ErrorKind::NotFound => SceneProblem::MissingFile { path: name.clone() },
                _ => SceneProblem::Unreadable {
                    path: name.clone(),
                    cause: error.to_string(),
                },
            };
            let source = Arc::new(SourceText {
                name: name.clone(),
                text: String::new(),
            });
            SceneError::new(
                Finding {
                    problem,
                    key: String::new(),
                    source,
                    span: None,
                },
                [],
            )
        })?;
        let base = path.parent().unwrap_or(Path::new(""));
        Self::from_text_on(&text, Format::of_path(path), &name, base, overrides, host)
    }

    /// Reads and checks a scene that names no files. `name` stands for the text in errors.
    ///
    /// # Errors
    /// As [`Scene::from_file`].
    pub fn from_text(
        text: &str,
        format: Format,
        name: &str,
        base_dir: &Path,
        overrides: &[impl AsRef<str>],
    ) -> Result<Self, SceneError> {
        Self::from_text_on(text, format, name, base_dir, overrides, Host::NONE)
    }

    /// As [`from_text`](Self::from_text), with data files of `host`, looked for in `base_dir`; they and the model may take no more than its
    /// limits.
    ///
    /// # Errors
    /// As [`Scene::from_file`].
    pub fn from_text_on(
        text: &str,
        format: Format,
        name: &str,
        base_dir: &Path,
        overrides: &[impl AsRef<str>],
        host: Host,
    ) -> Result<Self, SceneError> {
        let source = SourceText {
            name: name.to_owned(),
            text: text.to_owned(),
        };
        let mut document = Document::parse(source, format)?;
        document.host = host;
        for argument in overrides {
            overrides::apply(&mut document, argument.as_ref())?;
        }
        document.check_texts()?;
        check_version(&document)?;
        let mut spelled =
            SceneFormat::deserialize(Reader::new(&document.root, "")).map_err(|error| {
                let key = error.key.as_deref().unwrap_or_default();
                let problem = overrides::mistyped(&document, key, *error.problem);
                document.error(key, error.part, problem)
            })?;
        let parts = build::build(&document, &mut spelled, base_dir)?;
        let stem = Path::new(name)
            .file_stem()
            .map(|stem| stem.to_string_lossy().into_owned());
        Ok(Self {
            title: parts.title.or(stem).unwrap_or_default(),
            description: parts.description,
            display: parts.display,
            analysis: parts.analysis,
            materials: parts.materials,
            bodies: parts.bodies,
            mesh: parts.mesh,
            contacts: parts.contacts,
            supports: parts.supports,
            platens: parts.platens,
            hash: hash(&spelled, &parts.loads),
            loads: parts.loads,
            edges: parts.edges,
            failure: parts.failure,
            output: parts.output,
            source_name: name.to_owned(),
            base_dir: base_dir.to_owned(),
            resolved: resolved(&document, &spelled)?,
            document,
        })
    }

    /// How finely `body` is divided: by its own settings, or those of the scene.
    pub fn mesh_of(&self, body: &str) -> &MeshSettings {
        let own = self.bodies.get(body).and_then(|body| body.mesh.as_ref());
        own.unwrap_or(&self.mesh)
    }

    /// Number of load steps, at least 1.
    pub fn steps(&self) -> usize {
        self.loads.first().map_or(1, |load| load.kind.steps().len())
    }

    /// The scene in TOML with all overrides applied and all defaults filled in; it reads back to the same scene.
    pub fn resolved(&self) -> &str {
        &self.resolved
    }

    /// A problem that shows only later, such as a mesh that is too large, at the key that causes it: `mesh.spacing`.
    pub fn error_at(&self, key: &str, problem: SceneProblem) -> SceneError {
        self.document.error(key, Part::Value, problem)
    }
}

fn check_version(document: &Document) -> Result<(), SceneError> {
    let supported = VERSION;
    let problem = match document.get("version") {
        None => SceneProblem::MissingVersion { supported },
        Some(version) if version.as_u64() == Some(supported) => return Ok(()),
        Some(version) => SceneProblem::UnsupportedVersion {
            found: version.to_string(),
            supported,
        },
    };
    Err(document.error("version", Part::Value, problem))
}

fn resolved(document: &Document, spelled: &SceneFormat) -> Result<String, SceneError> {
    toml::to_string(spelled).map_err(|error| {
        let message = format!("the scene cannot be written as TOML: {error}");
        document.error("", Part::Key, SceneProblem::Refused { message })
    })
}

fn hash(spelled: &SceneFormat, loads: &[Load]) -> String {
    // Serialising plain structs with text keys does not fail; a scene without a hash would be no error either.
    let value = serde_json::to_value(spelled).unwrap_or_default();
    let mut digest = Sha256::new();
    digest.update(canonical(value).to_string());
    for load in loads {
        if let LoadKind::PolarTraction { table, .. } = &load.kind {
            for number in table.theta.iter().chain(&table.radial).chain(&table.shear) {
                digest.update(number.to_le_bytes());
            }
        }
    }
    digest
        .finalize()
        .iter()
        .fold(String::new(), |mut text, byte| {
            // Writing into a string does not fail.
            let _ = write!(text, "{byte:02x}");
            text
        })
}

/// The value with every quantity in base units.
fn canonical(value: Value) -> Value {
    match value {
        Value::String(text) => match parse(&text, &Expected::any(&Dimension::ALL)) {
            Ok((number, dimension)) => {
                Value::String(format!("{number:e} {}", dimension.base_unit()))
            }
            Err(_) => Value::String(text),
        },
        Value::Array(list) => list.into_iter().map(canonical).collect(),
        Value::Object(map) => Value::Object(
            map.into_iter()
                .map(|(key, value)| (key, canonical(value)))
                .collect(),
        ),
        other => other,
    }
}
