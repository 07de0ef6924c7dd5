//! An experiment, read and checked: plain values in base units (mm, N, MPa, rad).

mod laws;
mod ranges;
mod read;
mod refuse;
mod settings;
mod specimen;
mod states;
mod unused;

use std::path::PathBuf;

use serde_json::{Map, Value};
use stickslip_hybrid::moire::Grating;

use super::{Fringes, Identify, LawPlan, Reduce, RegionPlan, Specimen, State};
use stickslip_scene::diagnostic::{SceneError, SceneProblem};
use stickslip_scene::document::{Document, Part};
use stickslip_scene::host::Host;
use stickslip_scene::limits::Limits;
use stickslip_scene::schema::DisplayUnits;

pub use unused::IgnoredKey;

/// Version of the experiment format that this program reads.
pub const VERSION: u64 = 1;

/// A checked experiment.
///
/// ```
/// use std::path::Path;
/// use stickslip_experiment::Experiment;
/// use stickslip_scene::Format;
/// use stickslip_scene::host::Host;
///
/// let text = r#"
///     version = 1
///     [specimen]
///     material.isotropic = { young = "70 GPa", poisson = 0.33 }
///     thickness = "1.5 mm"
///     hole = { centre = ["0 mm", "0 mm"], radius = "9.5 mm" }
///     [[states]]
///     name = "up"
///     table = { file = "up.csv", scale = "1 mm", y_axis = "up" }
/// "#;
/// let experiment = Experiment::from_text(text, Format::Toml, "mine.toml", Path::new("."), &[] as &[&str], Host::NONE)?;
/// assert_eq!(experiment.specimen.hole.radius, 9.5);
/// # Ok::<(), stickslip_scene::diagnostic::SceneError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Experiment {
    /// Title; the name of the file where it has none.
    pub title: String,
    /// What it shows, in the words of its author.
    pub description: Option<String>,
    /// Units that results are shown in.
    pub display: DisplayUnits,
    /// What was measured.
    pub specimen: Specimen,
    /// The virtual grating of fringe pictures and fringe lines.
    pub grating: Option<Grating>,
    /// How synthetic pictures are taken.
    pub fringes: Option<Fringes>,
    /// States in the order of the experiment; at least one.
    pub states: Vec<State>,
    /// How measured fields are made.
    pub reduce: Reduce,
    /// The region of the hybrid analysis.
    pub region: Option<RegionPlan>,
    /// How friction is identified.
    pub identify: Identify,
    /// Friction laws to fit by contact solves.
    pub laws: Vec<LawPlan>,
    /// Ignored keys: stated, but without effect.
    pub without_effect: Vec<IgnoredKey>,
    /// Path of the file as given.
    pub source_name: String,
    /// Folder that its files are relative to.
    pub folder: PathBuf,
    /// SHA-256 of the file with its overrides, and of its scene, in hexadecimal digits.
    pub hash: String,
    document: Document,
}

impl Experiment {
    /// Whether the model that is fitted to synthetic pictures has the very mesh that made them.
    pub fn is_fitted_to_its_own_mesh(&self) -> bool {
        let synthetic = self.states.iter().any(|state| state.source.is_synthetic());
        synthetic && self.specimen.shares_its_mesh()
    }

    /// What reading its files and its models may take.
    pub fn limits(&self) -> Limits {
        self.document.host.limits
    }

    /// The machine that it was read on.
    pub fn host(&self) -> Host {
        self.document.host
    }

    /// The file as it was spelled, with its overrides.
    pub fn spelled(&self) -> Map<String, Value> {
        self.document.root.as_object().cloned().unwrap_or_default()
    }

    /// A problem that shows only later, such as a file that lacks a column, at the key that causes it: `states.0.table.columns`.
    pub fn error_at(&self, key: &str, problem: SceneProblem) -> SceneError {
        self.document.error(key, Part::Value, problem)
    }
}
