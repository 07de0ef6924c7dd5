//! An experiment, read and checked: plain values in base units (mm, N, MPa, rad).

mod laws;
mod read;
mod settings;
mod specimen;
mod states;
mod unused;
mod values;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::Serialize;
use serde_json::{Map, Value};
use stickslip_fem_core::material::PlaneState;
use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::{self, LineReading, Reading};
use stickslip_hybrid::fringe;
use stickslip_hybrid::moire::Grating;

use crate::diagnostic::{Finding, SceneError, SceneProblem, SourceText};
use crate::document::{Document, Part};
use crate::host::Host;
use crate::limits::{Content, Limits};
use crate::schema::{DisplayUnits, Material, SetRef};
use crate::{Format, Scene};

pub use unused::Unheeded;
pub use values::{
    FreeMotion, FreeParameter, Identify, LawPlan, MeshPlan, Method, Reduce, RegionPlan,
    RegionShape, SectorPlan, SymmetryPlan, ZonePlan,
};

/// Version of the experiment format that this program reads.
pub const VERSION: u64 = 1;

/// A checked experiment.
///
/// ```
/// use std::path::Path;
/// use stickslip_scene::experiment::Experiment;
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
    pub without_effect: Vec<Unheeded>,
    /// Path of the file as given.
    pub source_name: String,
    /// Folder that its files are relative to.
    pub folder: PathBuf,
    /// SHA-256 of the file with its overrides, and of its scene, in hexadecimal digits.
    pub hash: String,
    document: Document,
}

/// What was measured.
#[derive(Clone, Debug)]
pub struct Specimen {
    /// Its material.
    pub material: Material,
    /// Plane stress or plane strain.
    pub plane: PlaneState,
    /// Thickness `[mm]`.
    pub thickness: f64,
    /// Its hole.
    pub hole: Hole,
    /// The scene that it is a body of, if it was given so: what synthetic pictures are taken of.
    pub scene: Option<SpecimenScene>,
    /// The same scene as laws are fitted with and the whole plate is analysed by; it may have overrides of its own.
    pub model: Option<SpecimenScene>,
}

impl Specimen {
    /// Whether the model that is fitted has the very mesh of the scene, so that errors of discretisation cancel in synthetic data.
    pub fn shares_its_mesh(&self) -> bool {
        match (&self.scene, &self.model) {
            (Some(scene), Some(model)) => scene.scene.mesh == model.scene.mesh,
            _ => false,
        }
    }
}

/// A circular hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hole {
    /// Its centre `[mm]`.
    pub centre: Point,
    /// Its radius `[mm]`.
    pub radius: f64,
}

impl Hole {
    /// Distance `[mm]` of `place` `[mm]` from the centre.
    pub fn from_centre(&self, [x, y]: Point) -> f64 {
        (x - self.centre[0]).hypot(y - self.centre[1])
    }
}

/// The scene of a specimen.
#[derive(Clone, Debug)]
pub struct SpecimenScene {
    /// The scene, with its overrides.
    pub scene: Arc<Scene>,
    /// Name of the body.
    pub body: String,
    /// Name of the hole's edge, without that of the body.
    pub edge: String,
}

impl SpecimenScene {
    /// Index of the contact of the scene at the hole's edge; `None` where nothing touches it.
    pub fn contact(&self) -> Option<usize> {
        let at_edge = |set: &SetRef| set.body == self.body && set.set == self.edge;
        let mut contacts = self.scene.contacts.iter();
        contacts.position(|contact| at_edge(&contact.first) || at_edge(&contact.second))
    }
}

/// How synthetic pictures are taken.
#[derive(Clone, Debug, PartialEq)]
pub struct Fringes {
    /// Lower left and upper right corner `[mm]`.
    pub window: [Point; 2],
    /// Edge of a pixel `[mm]`.
    pub pixel: f64,
    /// Carriers (k_x, k_y) of the U and the V field `[1/mm]`.
    pub carrier: [[f64; 2]; 2],
    /// Light, noise and grey levels.
    pub exposure: fringe::Exposure,
    /// Places without picture.
    pub missing: Vec<Area>,
    /// Whether each field has four pictures with shifted phase instead of one.
    pub four: bool,
    /// Kind of the files.
    pub format: fringe::Format,
    /// Grey levels of the files.
    pub depth: fringe::Depth,
    /// Seed of all noise.
    pub seed: u64,
}

/// A part of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Area {
    /// A disc.
    Disc {
        /// Its centre `[mm]`.
        centre: Point,
        /// Its radius `[mm]`.
        radius: f64,
    },
    /// An upright rectangle between its lower left and its upper right corner `[mm]`.
    Window([Point; 2]),
}

impl Area {
    /// Whether a place lies in it.
    pub fn contains(&self, place: Point) -> bool {
        match self {
            Self::Disc { centre, radius } => {
                (place[0] - centre[0]).hypot(place[1] - centre[1]) <= *radius
            }
            Self::Window([low, high]) => {
                (0..2).all(|axis| (low[axis]..=high[axis]).contains(&place[axis]))
            }
        }
    }
}

/// Whether the load was growing or falling.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Direction {
    /// Growing.
    Loading,
    /// Falling.
    Unloading,
}

impl Direction {
    /// "loading" or "unloading".
    pub const fn name(self) -> &'static str {
        match self {
            Self::Loading => "loading",
            Self::Unloading => "unloading",
        }
    }
}

/// One state of the experiment.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Its name, a part of file names.
    pub name: String,
    /// Whether the load was growing or falling.
    pub direction: Direction,
    /// Remote load `[N]`.
    pub load: Option<f64>,
    /// Known components along x and y of the force on the region through its edge `[N]`.
    pub edge_force: [Option<f64>; 2],
    /// Where its data come from.
    pub source: Source,
    /// The initial load's data, to be taken off.
    pub null: Option<Source>,
    /// Data of the back, for the check of symmetry.
    pub back: Option<Source>,
}

impl State {
    /// Whether any of its data are a table.
    pub fn has_table(&self) -> bool {
        let also = self.null.iter().chain(&self.back);
        (also.chain([&self.source])).any(|source| matches!(source, Source::Table(_)))
    }
}

/// Where data come from.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// Synthetic pictures of this load step of the scene, counted from 0.
    Step(usize),
    /// A table of displacements.
    Table(TableSource),
    /// Fringe pictures.
    Pictures(PictureSource),
    /// Tables of fringe centres along lines.
    Lines(LineSource),
}

impl Source {
    /// Whether it is made from the solution of the scene.
    pub const fn is_synthetic(&self) -> bool {
        matches!(self, Self::Step(_))
    }

    /// The files that it is read from.
    pub fn files(&self) -> Vec<&Path> {
        match self {
            Self::Step(_) => Vec::new(),
            Self::Table(table) => vec![&table.file],
            Self::Pictures(pictures) => pictures
                .files
                .iter()
                .flatten()
                .map(PathBuf::as_path)
                .collect(),
            Self::Lines(lines) => lines.files.iter().map(PathBuf::as_path).collect(),
        }
    }
}

/// A table of displacements.
#[derive(Clone, Debug, PartialEq)]
pub struct TableSource {
    /// The file.
    pub file: PathBuf,
    /// Its columns.
    pub format: data::Format,
    /// What its numbers are; the standard deviation is that below.
    pub reading: Reading,
    /// Where the origin of the body's frame is, in the table's own numbers.
    pub origin: [f64; 2],
    /// Standard deviation of either component `[mm]`; estimated from the scatter of neighbours where it is not stated.
    pub deviation: Option<f64>,
}

/// Fringe pictures of the two fields.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureSource {
    /// Files of the U and of the V field: one, or four with shifted phase; none where a field was not measured.
    pub files: [Vec<PathBuf>; 2],
    /// Edge of a pixel `[mm]`.
    pub pixel: f64,
    /// Corner of the picture at its top and its left, in the body's frame `[mm]`.
    pub top_left: Point,
    /// Whether the body's y points up in the picture.
    pub upright: bool,
    /// Carriers of the two fields `[1/mm]`, where they are known.
    pub carrier: Option<[[f64; 2]; 2]>,
    /// Directions in which the orders of the two fields rise, carrier included.
    pub rising: [[f64; 2]; 2],
    /// Pixels of at most this intensity are missing.
    pub dark: Option<f64>,
}

/// Tables of fringe centres along lines.
#[derive(Clone, Debug, PartialEq)]
pub struct LineSource {
    /// Files of the U and of the V field.
    pub files: [PathBuf; 2],
    /// What the numbers of each are.
    pub reading: [LineReading; 2],
    /// Standard deviation of an order `[fringes]`.
    pub deviation: f64,
}

impl Experiment {
    /// Reads and checks a file of `host`, JSON if its name ends in `.json` and otherwise TOML, with the overrides `key=value` applied in
    /// turn. The files with data are not read yet; they and the models may take no more than the host's limits.
    ///
    /// # Errors
    /// [`SceneError`] with what is wrong at its line, in the experiment or in its scene; a file that is too large.
    pub fn from_file(
        path: &Path,
        overrides: &[impl AsRef<str>],
        host: Host,
    ) -> Result<Self, SceneError> {
        let name = path.display().to_string();
        let text = host.read_text(path, Content::Document).map_err(|error| {
            let source = SourceText {
                name: name.clone(),
                text: String::new(),
            };
            let finding = Finding {
                problem: SceneProblem::Unreadable {
                    path: name.clone(),
                    cause: error.to_string(),
                },
                key: String::new(),
                source: Arc::new(source),
                span: None,
            };
            SceneError::new(finding, [])
        })?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let source = SourceText { name, text };
        read::experiment(source, Format::of_path(path), folder, overrides, host)
    }

    /// Reads and checks an experiment. `name` stands for the text in errors, and files of `host` are looked for in `folder`.
    ///
    /// # Errors
    /// As [`Experiment::from_file`].
    pub fn from_text(
        text: &str,
        format: Format,
        name: &str,
        folder: &Path,
        overrides: &[impl AsRef<str>],
        host: Host,
    ) -> Result<Self, SceneError> {
        let source = SourceText {
            name: name.to_owned(),
            text: text.to_owned(),
        };
        read::experiment(source, format, folder, overrides, host)
    }

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
