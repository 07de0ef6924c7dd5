//! A checked scene.

use std::collections::BTreeMap;
use std::path::PathBuf;

use crate::diagnostic::{SceneError, SceneProblem};
use crate::document::{Document, Part};
use crate::host::Host;
use crate::limits::Limits;
use crate::schema::{
    Analysis, Body, Contact, DisplayUnits, Failure, Fastener, KinematicsChoice, Load, Material,
    MeshSettings, Output, Platen, SetRef, SpringSupport, Support,
};

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
    /// How finely those that are not round are divided, where others are and the program divides them.
    pub mesh_by_lengths: Option<MeshSettings>,
    /// Whether the scene itself says so, and not the program.
    pub is_divided: bool,
    /// Pairs of edges that may touch.
    pub contacts: Vec<Contact>,
    /// Fasteners through several plates, in the order of their names.
    pub fasteners: Vec<Fastener>,
    /// Nodes with given displacements.
    pub supports: Vec<Support>,
    /// Springs between edges or points and the ground.
    pub springs: Vec<SpringSupport>,
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
    pub(crate) resolved: String,
    pub(crate) document: Document,
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

    /// How finely `body` is divided: by its own settings, or those of the scene.
    pub fn mesh_of(&self, body: &str) -> &MeshSettings {
        let body = self.bodies.get(body);
        let own = body.and_then(|body| body.mesh.as_ref());
        let by_lengths = self.mesh_by_lengths.as_ref();
        let by_lengths = by_lengths.filter(|_| body.is_some_and(|body| !body.shape.is_round()));
        own.or(by_lengths).unwrap_or(&self.mesh)
    }

    /// Whether the scene says how finely `body` is divided, or gives its mesh.
    pub fn divides(&self, body: &str) -> bool {
        let own = self.bodies.get(body);
        let own = own.is_some_and(|body| body.mesh.is_some() || body.shape.has_own_mesh());
        own || self.is_divided
    }

    /// Whether the scene says how finely any body is divided.
    pub fn is_divided_anywhere(&self) -> bool {
        self.bodies.keys().any(|name| self.divides(name))
    }

    /// Whether models are tried until their errors meet what is asked: with an accuracy, without a mesh, and where the kinematics are chosen.
    pub fn seeks_accuracy(&self) -> bool {
        let analysis = &self.analysis;
        analysis.accuracy.is_some()
            || !self.is_divided_anywhere()
            || analysis.kinematics == Some(KinematicsChoice::Auto)
    }

    /// On which geometry contact is found; left to the program where the scene has no mesh and no fasteners, and the undeformed one otherwise.
    pub fn kinematics(&self) -> KinematicsChoice {
        let is_free = !self.is_divided_anywhere() && self.fasteners.is_empty();
        let default = if is_free {
            KinematicsChoice::Auto
        } else {
            KinematicsChoice::Small
        };
        self.analysis.kinematics.unwrap_or(default)
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
