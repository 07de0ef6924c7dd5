//! A sweep file, read and checked, and the scenes of its cases.

mod joint;
mod problem;
mod read;

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::axis::{Axis, AxisKey, tidy};
use stickslip_scene::diagnostic::{SceneError, SceneProblem};
use stickslip_scene::document::{Document, Part};
use stickslip_scene::host::Host;
use stickslip_scene::schema::Substance;
use stickslip_scene::shape::Role;
use stickslip_scene::{Format, Scene, open};

/// Version of the sweep format that this program reads.
const VERSION: u64 = 1;

/// A checked sweep: every value of every axis gives a scene that reads well, at least with some values of the other axes.
///
/// ```
/// use std::path::Path;
/// use stickslip::host::HOST;
/// use stickslip::sweep::Sweep;
///
/// # let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
/// let sweep = Sweep::from_file(&scenes.join("sweeps/mode-map.toml"), &["mesh.spacing=6 deg"], HOST)?;
/// assert_eq!(sweep.cases(), 30);
/// assert_eq!(sweep.name_of(0), "e/D = 1.5, W/D = 2");
/// # Ok::<(), stickslip::diagnostic::SceneError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Sweep {
    /// Title; the name of the file where it has none.
    pub title: String,
    /// What it shows, in the words of its author.
    pub description: Option<String>,
    /// Path of the sweep file as given.
    pub source_name: String,
    /// Its axes; the cases are their full product, the last one running fastest.
    pub axes: Vec<Axis>,
    /// The scene that all cases start from, with the overrides of the command line.
    pub scene: Scene,
    /// Index of the contact whose pressure is reported.
    pub contact: usize,
    /// Name of the body with the hole, the first of that contact.
    pub plate: String,
    /// Its index among the bodies of every case.
    pub plate_index: Option<usize>,
    /// Name of the body in the hole.
    pub pin: String,
    /// Unit of the loads of all cases: that of what the steps of the joint are counted by.
    pub load_unit: String,
    /// Criterion of the failure load and mode on the characteristic curve; `None` where the scene asks for no curve.
    pub criterion: Option<String>,
    /// Axes along x and y of maps, where there are as many.
    pub map: [Option<usize>; 2],
    /// SHA-256 of everything that the results depend on, in hexadecimal digits.
    pub hash: String,
    base: Base,
    document: Document,
}

/// The text of the scene that cases start from.
#[derive(Clone, Debug)]
struct Base {
    text: String,
    format: Format,
    name: String,
    folder: PathBuf,
    overrides: Vec<String>,
    host: Host,
}

impl Base {
    fn scene(&self, further: &[String]) -> Result<Scene, SceneError> {
        let all: Vec<&String> = self.overrides.iter().chain(further).collect();
        Scene::from_text_on(
            &self.text,
            self.format,
            &self.name,
            &self.folder,
            &all,
            self.host,
        )
    }
}

impl Sweep {
    /// Reads and checks a file of `host`, JSON if its name ends in `.json` and otherwise TOML. The `overrides` `key=value` are those of its
    /// scene. Each case may take no more than the host's limits.
    ///
    /// # Errors
    /// [`SceneError`] with the first thing that is wrong at its line, in the sweep or in its scene; a file that is too large.
    pub fn from_file(
        path: &Path,
        overrides: &[impl AsRef<str>],
        host: Host,
    ) -> Result<Self, SceneError> {
        let source = open::text_of(path, host, SceneProblem::unreadable)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let overrides = overrides.iter().map(|one| one.as_ref().to_owned());
        let overrides = overrides.collect();
        read::sweep(source, Format::of_path(path), folder, overrides, host)
    }

    /// Number of cases.
    pub fn cases(&self) -> usize {
        self.axes.iter().map(|axis| axis.values.len()).product()
    }

    /// Whether cases state errors of their numbers: those that find their own model for an accuracy.
    pub fn states_errors(&self) -> bool {
        let mut axes = self.axes.iter();
        self.scene.seeks_accuracy() || axes.any(|axis| axis.key.name() == "analysis.accuracy")
    }

    /// Index of the value on each axis in a case.
    pub fn values_of(&self, case: usize) -> Vec<usize> {
        let mut rest = case;
        let mut values: Vec<usize> = (self.axes.iter().rev())
            .map(|axis| {
                let count = axis.values.len();
                let value = rest % count;
                rest /= count;
                value
            })
            .collect();
        values.reverse();
        values
    }

    /// "e/D = 2, W/D = 4".
    pub fn name_of(&self, case: usize) -> String {
        let values = self.values_of(case);
        let assignments = self.axes.iter().zip(values);
        let texts: Vec<String> = assignments
            .map(|(axis, value)| axis.assignment(value))
            .collect();
        texts.join(", ")
    }

    /// The scene of a case, without fields, figures and envelopes, which a sweep does not keep.
    ///
    /// # Errors
    /// [`SceneError`] where these values do not make a scene together.
    pub fn scene_of(&self, case: usize) -> Result<Scene, SceneError> {
        let chosen: Vec<(usize, usize)> = self.values_of(case).into_iter().enumerate().collect();
        let mut scene = self.scene_with(&chosen)?;
        scene.output.fields = stickslip_scene::schema::FieldOutput::None;
        scene.output.figures = false;
        if let Some(failure) = &mut scene.failure {
            failure.envelopes = None;
        }
        Ok(scene)
    }

    /// The scene with these values: (axis, value).
    fn scene_with(&self, chosen: &[(usize, usize)]) -> Result<Scene, SceneError> {
        let overrides = self.overrides_of(chosen)?.into_iter();
        let overrides: Vec<String> = overrides.map(|(_, text)| text).collect();
        self.base.scene(&overrides)
    }

    /// What these values set: (axis, override). Keys of the scene come first, because e/D, W/D and clearance need the hole's size.
    fn overrides_of(&self, chosen: &[(usize, usize)]) -> Result<Vec<(usize, String)>, SceneError> {
        let mut overrides = Vec::new();
        let mut derived = Vec::new();
        for &(axis, value) in chosen {
            let given = &self.axes[axis].values[value];
            match &self.axes[axis].key {
                AxisKey::Scene(key) => overrides.push((axis, assignment(key, given))),
                AxisKey::Friction => {
                    let key = format!("contacts.{}.friction.coulomb.mu", self.contact);
                    overrides.push((axis, assignment(&key, given)));
                }
                _ => derived.push((axis, value)),
            }
        }
        if derived.is_empty() {
            return Ok(overrides);
        }
        // Only other bodies have other holes.
        let reshaped =
            |key: &AxisKey| matches!(key, AxisKey::Scene(key) if key.starts_with("bodies"));
        let other = if self.axes.iter().any(|axis| reshaped(&axis.key)) {
            let texts: Vec<String> = overrides.iter().map(|(_, text)| text.clone()).collect();
            Some(self.base.scene(&texts)?)
        } else {
            None
        };
        let scene = other.as_ref().unwrap_or(&self.scene);
        for (axis, value) in derived {
            overrides.push((axis, self.derived(scene, axis, value)?));
        }
        Ok(overrides)
    }

    /// The override that a named axis makes in `scene`.
    fn derived(&self, scene: &Scene, axis: usize, value: usize) -> Result<String, SceneError> {
        let own = &self.axes[axis];
        let body = scene.bodies.get(&self.plate);
        let touched = scene.contacts.get(self.contact).map(|own| &own.first);
        let hole = touched.and_then(|on| scene.bodies.get(&on.body)?.shape.edge(&on.set));
        let Some(hole_radius) = hole.and_then(|hole| hole.circle()) else {
            return Err(self.needs(axis, "a plate with a hole"));
        };
        // The key of the distance from the hole to a side of the plate.
        let side = |role: Role| {
            let size = body.and_then(|body| body.shape.edge_with(role)?.size);
            let key = size.map(|size| format!("bodies.{}.shape.{size}", self.plate));
            key.ok_or_else(|| self.needs(axis, "a plate with outline.strip"))
        };
        let number = own.numbers.as_ref().and_then(|numbers| numbers.get(value));
        let length = |key: String, value: f64| format!("{key}={} mm", tidy(value));
        match (&own.key, number) {
            (AxisKey::EndDistance, Some(ratio)) => {
                Ok(length(side(Role::End)?, 2.0 * ratio * hole_radius))
            }
            (AxisKey::Width, Some(ratio)) => Ok(length(side(Role::Side)?, ratio * hole_radius)),
            (AxisKey::Clearance, Some(clearance)) => {
                let clearance = own.unit.map_or(*clearance, |unit| clearance * unit.in_base);
                let pin = scene.bodies.get(&self.pin);
                let size = pin.and_then(|pin| pin.shape.edge_with(Role::Rim)?.size);
                let size = size.ok_or_else(|| self.needs(axis, "a pin in its hole"))?;
                let key = format!("bodies.{}.shape.{size}", self.pin);
                // To the last digit: a clearance is a small difference of radii.
                Ok(format!("{key}={} mm", hole_radius - clearance))
            }
            (AxisKey::LayUp, _) => {
                let material = body.and_then(|body| match &body.substance {
                    Substance::Elastic { material, .. } => Some(material),
                    Substance::Rigid => None,
                });
                let material = material.ok_or_else(|| self.needs(axis, "an elastic plate"))?;
                let key = format!("materials.{material}.laminate.layup");
                Ok(assignment(&key, &own.values[value]))
            }
            _ => Err(self.needs(axis, "numbers")),
        }
    }

    fn needs(&self, axis: usize, what: &str) -> SceneError {
        let name = self.axes[axis].key.name();
        let problem = SceneProblem::Conflict {
            message: format!(
                "the axis '{name}' needs {what}, which body '{}' of '{}' does not have",
                self.plate, self.base.name
            ),
            remedy: format!(
                "give {what}, name another contact under [joint], or leave the axis out"
            ),
        };
        self.document
            .error(&format!("axes.{axis}.key"), Part::Value, problem)
    }
}

/// `key=value` as `--set` takes it.
fn assignment(key: &str, value: &Value) -> String {
    // A value that came from TOML or JSON and holds no null can be written as TOML.
    let text =
        toml::Value::try_from(value).map_or_else(|_| value.to_string(), |value| value.to_string());
    format!("{key}={text}")
}
