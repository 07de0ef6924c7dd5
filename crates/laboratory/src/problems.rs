//! Reference problems: scenes with a mesh of the caller's choice, and the errors of what they yield.
//!
//! ```text
//! error of a number:    |computed / reference − 1|
//! error of a profile:   √(∫ (computed − reference)² ds / ∫ ds) over the contact, divided by its largest value
//! ```
//!
//! | problem | answer |
//! | --- | --- |
//! | Persson | closed form, pin without friction in an infinite plate, three loads |
//! | Hertz | closed form for half-planes |
//! | Cattaneo–Mindlin | closed form for half-planes, partial slip over half a cycle |
//! | orthotropic pin | tables of a semi-analytic solution, rigid pin with friction |
//! | aluminium, two cases | the same history of 14 load steps on a much finer mesh |
//!
//! Where a problem has several load steps with known answers, an error is the largest over these.

mod expected;
mod pairing;

use std::path::PathBuf;

use stickslip::host::HOST;
use stickslip::results::{EdgeResults, Results};
use stickslip::scene::{Format, Scene};
use stickslip_fem_core::mesh::ElementKind;

use crate::error::LaboratoryError;
use expected::{Expected, expected};
pub use pairing::Pairing;

/// A problem with a known answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Problem {
    /// Frictionless pin of the plate's material in an infinite plate (Persson 1964).
    Persson,
    /// Cylinder on a block (Hertz 1882).
    Hertz,
    /// Cylinder on a block, pushed to and fro (Cattaneo 1938, Mindlin 1949).
    CattaneoMindlin,
    /// Rigid pin with friction in an infinite orthotropic plate.
    OrthotropicPin,
    /// Elastic pin in an aluminium plate, 14 load steps without friction.
    AluminiumFrictionless,
    /// The same with friction 0.25.
    AluminiumFrictional,
}

/// Relative errors, none negative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Of the largest pressure `[1]`.
    pub peak_pressure: f64,
    /// Of the contact's half-angle or half-width `[1]`.
    pub contact_extent: f64,
    /// Of the pressure over the contact, root mean square `[1]`.
    pub pressure_profile: f64,
    /// Of the shear over the contact, root mean square `[1]`; `None` without friction.
    pub shear: Option<f64>,
    /// Of σ_θ at 90° `[1]`; `None` on a line.
    pub hoop: Option<f64>,
}

impl Problem {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Persson,
        Self::Hertz,
        Self::CattaneoMindlin,
        Self::OrthotropicPin,
        Self::AluminiumFrictionless,
        Self::AluminiumFrictional,
    ];

    /// Name, fit for a file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Persson => "persson",
            Self::Hertz => "hertz",
            Self::CattaneoMindlin => "cattaneo-mindlin",
            Self::OrthotropicPin => "orthotropic-pin",
            Self::AluminiumFrictionless => "aluminium-frictionless",
            Self::AluminiumFrictional => "aluminium-frictional",
        }
    }

    /// Name, fit for a caption.
    pub fn title(self) -> &'static str {
        match self {
            Self::Persson => "Persson: frictionless pin, infinite plate",
            Self::Hertz => "Hertz: cylinder on a block",
            Self::CattaneoMindlin => "Cattaneo–Mindlin: partial slip",
            Self::OrthotropicPin => "Rigid pin, orthotropic plate, μ = 0.2",
            Self::AluminiumFrictionless => "Aluminium plate, 14 load steps, μ = 0",
            Self::AluminiumFrictional => "Aluminium plate, 14 load steps, μ = 0.25",
        }
    }

    /// Node spacings from coarse to fine, each half of the one before, in [`unit`](Self::unit). On each of them 90° is a node.
    pub fn spacings(self) -> &'static [f64] {
        match self {
            Self::Persson => &[6.0, 3.0, 1.5, 0.75],
            Self::Hertz | Self::CattaneoMindlin => &[0.16, 0.08, 0.04, 0.02],
            Self::OrthotropicPin => &[5.0, 2.5, 1.25, 0.625],
            Self::AluminiumFrictionless | Self::AluminiumFrictional => &[9.0, 4.5, 2.25, 1.125],
        }
    }

    /// Unit of the spacing.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Hertz | Self::CattaneoMindlin => "mm",
            _ => "deg",
        }
    }

    /// Name of the body that the contact's first body is pressed against.
    fn second_body(self) -> &'static str {
        match self {
            Self::Hertz | Self::CattaneoMindlin => "lower",
            _ => "pin",
        }
    }

    /// Whether both bodies have meshes, which can then be apart.
    pub fn two_meshes(self) -> bool {
        self != Self::OrthotropicPin
    }

    /// Whether there is friction.
    pub fn friction(self) -> bool {
        matches!(
            self,
            Self::CattaneoMindlin | Self::OrthotropicPin | Self::AluminiumFrictional
        )
    }

    /// The scene with node spacing `spacing` in [`unit`](Self::unit).
    ///
    /// # Errors
    /// [`LaboratoryError::Scene`] if the spacing is not positive.
    pub fn build(
        self,
        spacing: f64,
        element: ElementKind,
        pairing: Pairing,
    ) -> Result<Scene, LaboratoryError> {
        self.build_with(spacing, element, pairing, &[])
    }

    /// The scene with node spacing `spacing` in [`unit`](Self::unit) and further settings `key=value`, as the command's `--set` takes them.
    ///
    /// # Errors
    /// [`LaboratoryError::Scene`] if a setting does not read.
    pub fn build_with(
        self,
        spacing: f64,
        element: ElementKind,
        pairing: Pairing,
        overrides: &[String],
    ) -> Result<Scene, LaboratoryError> {
        let mut settings = vec![
            format!("mesh.element={element:?}"),
            format!("mesh.spacing=\"{spacing} {}\"", self.unit()),
        ];
        settings.extend(pairing.settings(self, spacing));
        match self {
            Self::AluminiumFrictionless => {
                settings.push("contacts.0.friction.coulomb.mu=0".into());
            }
            // Without clearance the answer does not depend on how the load grows.
            Self::OrthotropicPin => settings.push("analysis.substeps=1".into()),
            _ => {}
        }
        settings.extend_from_slice(overrides);
        let (name, text) = self.scene();
        let file = scenes().join(name);
        let folder = file.parent().unwrap_or(&file);
        let shown = file.display().to_string();
        Scene::from_text_on(text, Format::Toml, &shown, folder, &settings, HOST).map_err(|cause| {
            LaboratoryError::Scene {
                scene: self.name().into(),
                cause: Box::new(cause),
            }
        })
    }

    /// Path under `scenes`, and text.
    fn scene(self) -> (&'static str, &'static str) {
        macro_rules! scene {
            ($name:literal) => {
                ($name, include_str!(concat!("../../../scenes/", $name)))
            };
        }
        match self {
            Self::Persson => scene!("pin-infinite-plate.toml"),
            Self::Hertz => scene!("hertz-cylinder.toml"),
            Self::CattaneoMindlin => scene!("cattaneo-mindlin.toml"),
            Self::OrthotropicPin => scene!("validation/rigid-pin-orthotropic.toml"),
            Self::AluminiumFrictionless | Self::AluminiumFrictional => {
                scene!("pin-benchmark.toml")
            }
        }
    }

    /// How well the known answer is known, by the same measures. A curve of errors that flattens here has met the end of the
    /// reference, not of its mesh.
    ///
    /// Closed forms are exact, but the block and cylinder end 45 contact half-widths away, where the half-plane goes on. That a
    /// limit of the errors is that and nothing else shows in its fall to a quarter with half the half-width (the test
    /// `half_plane.rs`). Tables of the rigid pin: their own estimates, and rounding. Aluminium: what changes when the spacing is halved from 0.5625° to that of
    /// the reference.
    pub fn known(self) -> Errors {
        match self {
            Self::Persson => Errors::default(),
            Self::Hertz | Self::CattaneoMindlin => Errors {
                peak_pressure: 2e-4,
                contact_extent: 7e-4,
                pressure_profile: 1.5e-3,
                shear: self.friction().then_some(1.5e-3),
                hoop: None,
            },
            Self::OrthotropicPin => Errors {
                peak_pressure: 1e-5,
                contact_extent: 5e-4,
                pressure_profile: 1e-5,
                shear: Some(2e-5),
                hoop: Some(1e-5),
            },
            Self::AluminiumFrictionless => Errors {
                peak_pressure: 6e-6,
                contact_extent: 1.2e-3,
                pressure_profile: 6e-4,
                shear: None,
                hoop: Some(2e-6),
            },
            Self::AluminiumFrictional => Errors {
                peak_pressure: 8e-6,
                contact_extent: 9e-4,
                pressure_profile: 1.3e-3,
                shear: Some(4.6e-3),
                hoop: Some(7e-6),
            },
        }
    }

    /// The errors of `results`: of each quantity the largest over the load steps with a known answer.
    ///
    /// # Errors
    /// [`LaboratoryError::Missing`] if a load step or contact is missing.
    pub fn measure(self, results: &Results) -> Result<Errors, LaboratoryError> {
        let steps = self.measure_each(results)?;
        Ok(steps.into_iter().fold(Errors::default(), Errors::or_worse))
    }

    /// The errors of each load step with a known answer, in their order.
    ///
    /// # Errors
    /// [`LaboratoryError::Missing`] if a load step or contact is missing.
    pub fn measure_each(self, results: &Results) -> Result<Vec<Errors>, LaboratoryError> {
        let steps = expected(self)?;
        steps
            .iter()
            .map(|step| self.errors(results, step))
            .collect()
    }

    fn errors(self, results: &Results, expected: &Expected) -> Result<Errors, LaboratoryError> {
        let missing = |what: &str| {
            let step = expected.step + 1;
            LaboratoryError::Missing(format!("{}: no {what} in load step {step}", self.name()))
        };
        let step = results
            .steps
            .get(expected.step)
            .ok_or_else(|| missing("results"))?;
        let (edge, geometry) = (&step.edges[0], &results.edges[0]);
        let (peak, _) = edge.peak_pressure.ok_or_else(|| missing("contact"))?;
        let extent = edge.contact_half_extent.ok_or_else(|| missing("contact"))?;
        let relative = |computed: f64, reference: f64| (computed / reference - 1.0).abs();
        let [pressure, shear] = expected.profile_errors(&geometry.parameter, edge);
        let hoop = expected
            .hoop
            .map(|(angle, value)| {
                at(&geometry.parameter, edge, angle, |row| row.sigma_tangential)
                    .map(|found| relative(found, value))
                    .ok_or_else(|| missing("stress at 90°"))
            })
            .transpose()?;
        Ok(Errors {
            peak_pressure: relative(peak, expected.peak_pressure),
            contact_extent: relative(extent, expected.extent),
            pressure_profile: pressure,
            shear: self.friction().then_some(shear),
            hoop,
        })
    }
}

impl Errors {
    /// The larger of each; NaN counts as the largest.
    fn or_worse(self, other: Self) -> Self {
        let worse = |a: f64, b: f64| if a >= b || a.is_nan() { a } else { b };
        let both = |a: Option<f64>, b: Option<f64>| match (a, b) {
            (Some(a), Some(b)) => Some(worse(a, b)),
            (a, b) => a.or(b),
        };
        Self {
            peak_pressure: worse(self.peak_pressure, other.peak_pressure),
            contact_extent: worse(self.contact_extent, other.contact_extent),
            pressure_profile: worse(self.pressure_profile, other.pressure_profile),
            shear: both(self.shear, other.shear),
            hoop: both(self.hoop, other.hoop),
        }
    }
}

/// A quantity of the rows at `place`, linear between nodes.
fn at(
    parameter: &[f64],
    edge: &EdgeResults,
    place: f64,
    value: impl Fn(&stickslip::results::EdgeRow) -> f64,
) -> Option<f64> {
    let values: Vec<f64> = edge.rows.iter().map(value).collect();
    expected::interpolate(parameter, &values, place)
}

/// The folder of scenes, which data files are relative to.
fn scenes() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}
