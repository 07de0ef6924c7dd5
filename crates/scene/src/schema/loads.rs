//! Loads and their histories.

use super::{BearingLaw, SetRef};
use crate::declaration::{
    REQUIRED, Range, Table, described, forces, numbers, stresses, table, temperatures, text,
};
use crate::units::{Force, Measure, Quantity, Stress, Temperature, UnitName};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use std::path::PathBuf;

/// A load and its history.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// Name in results.
    pub name: String,
    /// What loads what.
    pub kind: LoadKind,
}

/// What loads what. Every `steps` has one entry per load step, and all loads act at once.
#[derive(Debug, Clone, PartialEq)]
pub enum LoadKind {
    /// A total force on an edge of the whole body, spread evenly.
    Force {
        /// The edge.
        on: SetRef,
        /// Unit vector `[1]`.
        direction: [f64; 2],
        /// Magnitudes `[N]`.
        steps: Vec<f64>,
    },
    /// An assumed pressure on half of a hole, in the place of a pin.
    Bearing {
        /// The hole.
        on: SetRef,
        /// Unit vector `[1]` of the force on the body; the pressure's middle lies there.
        direction: [f64; 2],
        /// How the pressure is spread.
        law: BearingLaw,
        /// Magnitudes of the force on the whole hole `[N]`, at least 0.
        steps: Vec<f64>,
    },
    /// A pressure on an edge; positive pushes on the body, negative pulls.
    Pressure {
        /// The edge.
        on: SetRef,
        /// `[MPa]`
        steps: Vec<f64>,
    },
    /// Stresses on a circular edge, from a table.
    PolarTraction {
        /// The edge.
        on: SetRef,
        /// The table.
        table: PolarTable,
        /// Factors of the table's stresses `[1]`.
        steps: Vec<f64>,
    },
    /// A temperature change of a body.
    Temperature {
        /// The body.
        body: String,
        /// `[K]`
        steps: Vec<f64>,
    },
}

impl LoadKind {
    /// Name of the body that it acts on.
    pub fn body(&self) -> &str {
        match self {
            Self::Force { on, .. }
            | Self::Bearing { on, .. }
            | Self::Pressure { on, .. }
            | Self::PolarTraction { on, .. } => &on.body,
            Self::Temperature { body, .. } => body,
        }
    }

    /// The history, in the unit of the kind's `steps`.
    pub fn steps(&self) -> &[f64] {
        match self {
            Self::Force { steps, .. }
            | Self::Bearing { steps, .. }
            | Self::Pressure { steps, .. }
            | Self::PolarTraction { steps, .. }
            | Self::Temperature { steps, .. } => steps,
        }
    }
}

/// Stresses over the angle on a circle.
#[derive(Debug, Clone, PartialEq)]
pub struct PolarTable {
    /// The file that it was read from.
    pub file: PathBuf,
    /// Angles `[rad]`, strictly increasing.
    pub theta: Vec<f64>,
    /// σ_r `[MPa]`.
    pub radial: Vec<f64>,
    /// τ_rθ `[MPa]`.
    pub shear: Vec<f64>,
}

impl PolarTable {
    /// Whether the table ends at π and so stands for a load symmetric about the x axis.
    pub fn is_half(&self) -> bool {
        self.theta
            .last()
            .is_some_and(|last| (last - PI).abs() < 1e-9)
    }
}

/// `[[loads]]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LoadFormat {
    pub(crate) name: Option<String>,
    pub(crate) on: String,
    pub(crate) force: Option<ForceFormat>,
    pub(crate) bearing: Option<BearingFormat>,
    pub(crate) pressure: Option<PressureFormat>,
    pub(crate) polar_traction: Option<PolarTractionFormat>,
    pub(crate) temperature: Option<TemperatureFormat>,
}

impl LoadFormat {
    /// The load that stands at `index` of its list.
    pub(crate) fn load(&self, index: usize, kind: LoadKind) -> Load {
        let Self {
            name,
            on: _,
            force: _,
            bearing: _,
            pressure: _,
            polar_traction: _,
            temperature: _,
        } = self;
        Load {
            name: name.clone().unwrap_or_else(|| format!("load{}", index + 1)),
            kind,
        }
    }
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ForceFormat {
    pub(crate) direction: Vec<f64>,
    pub(crate) steps: Vec<Quantity<Force>>,
}

impl ForceFormat {
    pub(crate) fn kind(&self, on: SetRef, direction: [f64; 2]) -> LoadKind {
        let Self {
            direction: _,
            steps,
        } = self;
        LoadKind::Force {
            on,
            direction,
            steps: values(steps),
        }
    }
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct BearingFormat {
    pub(crate) direction: Vec<f64>,
    pub(crate) law: BearingLaw,
    pub(crate) steps: Vec<Quantity<Force>>,
}

impl BearingFormat {
    pub(crate) fn kind(&self, on: SetRef, direction: [f64; 2]) -> LoadKind {
        let Self {
            direction: _,
            law,
            steps,
        } = self;
        LoadKind::Bearing {
            on,
            direction,
            law: *law,
            steps: values(steps),
        }
    }
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PressureFormat {
    pub(crate) steps: Vec<Quantity<Stress>>,
}

impl PressureFormat {
    pub(crate) fn kind(&self, on: SetRef) -> LoadKind {
        let Self { steps } = self;
        LoadKind::Pressure {
            on,
            steps: values(steps),
        }
    }
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PolarTractionFormat {
    pub(crate) file: String,
    pub(crate) stress: UnitName<Stress>,
    #[serde(default = "default_theta")]
    pub(crate) theta: String,
    #[serde(default = "default_radial")]
    pub(crate) radial: String,
    #[serde(default = "default_shear")]
    pub(crate) shear: String,
    pub(crate) steps: Vec<f64>,
}

impl PolarTractionFormat {
    /// The tractions of `columns` (θ in degrees, σ_r and τ_rθ in the table's unit) of the file at `path`.
    pub(crate) fn kind(&self, on: SetRef, path: PathBuf, columns: [Vec<f64>; 3]) -> LoadKind {
        let Self {
            file: _,
            stress,
            theta: _,
            radial: _,
            shear: _,
            steps,
        } = self;
        let in_base = stress.unit().in_base;
        let scaled = |column: Vec<f64>| column.into_iter().map(|value| value * in_base).collect();
        let [theta, radial, shear] = columns;
        LoadKind::PolarTraction {
            on,
            table: PolarTable {
                file: path,
                theta: theta.into_iter().map(f64::to_radians).collect(),
                radial: scaled(radial),
                shear: scaled(shear),
            },
            steps: steps.clone(),
        }
    }
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TemperatureFormat {
    pub(crate) steps: Vec<Quantity<Temperature>>,
}

impl TemperatureFormat {
    pub(crate) fn kind(&self, body: String) -> LoadKind {
        let Self { steps } = self;
        LoadKind::Temperature {
            body,
            steps: values(steps),
        }
    }
}

fn values<M: Measure>(steps: &[Quantity<M>]) -> Vec<f64> {
    steps.iter().map(Quantity::value).collect()
}

fn default_theta() -> String {
    "theta_deg".to_owned()
}

fn default_radial() -> String {
    "sigma_r".to_owned()
}

fn default_shear() -> String {
    "tau_rtheta".to_owned()
}

const PUSHES: Range = numbers(
    " ≥ 0",
    "0 or more: a pin pushes; turn the direction to push the other way",
    |value| value >= 0.0,
);

const KINDS: &[&[&str]] = &[
    &["force"],
    &["bearing"],
    &["pressure"],
    &["polar_traction"],
    &["temperature"],
];

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("loads", &[
        text("name", "`load1`, `load2`, …", r#""pull""#, "name in the results"),
        described("on", "`body.set`, or the body of a temperature", REQUIRED, r#""plate.left""#, "the edge that is loaded; a force also on an area, such as `pin.section`, over which it is spread evenly, or on a point"),
        table("force", "one of the five", "a total force, spread evenly over an edge"),
        table("bearing", "one of the five", "a force on a hole without a pin, as pressure by an assumed law: cosine, uniform"),
        table("pressure", "one of the five", "a pressure on an edge"),
        table("polar_traction", "one of the five", "stresses on a circle, from a file"),
        table("temperature", "one of the five", "a temperature change of a body"),
    ]).one_of(KINDS, "force, bearing, pressure, polar_traction, temperature"),
    Table::new("loads.force", &[
        described("direction", "two numbers", REQUIRED, "[-1, 0]", "vector (x, y), of any length but zero"),
        forces("steps", REQUIRED, r#"["1 kN"]"#,
            "magnitudes of the force on the whole body, also in a half model, spread evenly over the edge"),
    ]),
    Table::new("loads.bearing", &[
        described("direction", "two numbers", REQUIRED, "[-1, 0]",
            "vector (x, y) of the force on the body, of any length but zero"),
        described("law", r#"`"cosine"`, `"uniform"`"#, REQUIRED, r#""cosine""#, "how the pressure is spread"),
        forces("steps", REQUIRED, r#"["2 kN", "4 kN"]"#,
            "magnitudes of the force on the whole hole, also in a half model").range(PUSHES),
    ]),
    Table::new("loads.pressure", &[
        stresses("steps", REQUIRED, r#"["1 MPa"]"#, "positive pushes on the body, negative pulls"),
    ]),
    Table::new("loads.polar_traction", &[
        described("file", "path", REQUIRED, r#""data/persson-ring5R-65deg.csv""#, "table, relative to the folder of the scene"),
        described("stress", "unit of stress", REQUIRED, r#""MPa""#, "unit of its stresses"),
        text("theta", r#"`"theta_deg"`"#, r#""theta_deg""#, "its column of angles in degrees"),
        text("radial", r#"`"sigma_r"`"#, r#""sigma_r""#, "its column of σ_r"),
        text("shear", r#"`"tau_rtheta"`"#, r#""tau_rtheta""#, "its column of τ_rθ"),
        described("steps", "list of numbers", REQUIRED, "[1.0]", "factors of its stresses"),
    ]),
    Table::new("loads.temperature", &[
        temperatures("steps", REQUIRED, r#"["-100 K"]"#,
            "change of the whole body's temperature since the stress-free state; its material needs an expansion"),
    ]),
];
