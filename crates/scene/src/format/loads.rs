//! Loads as a file spells them.

use serde::{Deserialize, Serialize};

use crate::declaration::{
    REQUIRED, Range, Table, forces, numbers, stresses, table, temperatures, text, words,
};
use crate::schema::BearingLaw;
use crate::units::{Force, Quantity, Stress, Temperature, UnitName};

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

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ForceFormat {
    pub(crate) direction: Vec<f64>,
    pub(crate) steps: Vec<Quantity<Force>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct BearingFormat {
    pub(crate) direction: Vec<f64>,
    pub(crate) law: BearingLaw,
    pub(crate) steps: Vec<Quantity<Force>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PressureFormat {
    pub(crate) steps: Vec<Quantity<Stress>>,
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

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TemperatureFormat {
    pub(crate) steps: Vec<Quantity<Temperature>>,
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
        words("on", "`body.set`, or the body of a temperature", REQUIRED, r#""plate.left""#, "the edge that is loaded; a force also on an area, such as `pin.section`, over which it is spread evenly, or on a point"),
        table("force", "one of the five", "a total force, spread evenly over an edge"),
        table("bearing", "one of the five", "a force on a hole without a pin, as pressure by an assumed law: cosine, uniform"),
        table("pressure", "one of the five", "a pressure on an edge"),
        table("polar_traction", "one of the five", "stresses on a circle, from a file"),
        table("temperature", "one of the five", "a temperature change of a body"),
    ]).one_of(KINDS, "force, bearing, pressure, polar_traction, temperature"),
    Table::new("loads.force", &[
        words("direction", "two numbers", REQUIRED, "[-1, 0]", "vector (x, y), of any length but zero"),
        forces("steps", REQUIRED, r#"["1 kN"]"#,
            "magnitudes of the force on the whole body, also in a half model, spread evenly over the edge"),
    ]),
    Table::new("loads.bearing", &[
        words("direction", "two numbers", REQUIRED, "[-1, 0]",
            "vector (x, y) of the force on the body, of any length but zero"),
        words("law", r#"`"cosine"`, `"uniform"`"#, REQUIRED, r#""cosine""#, "how the pressure is spread"),
        forces("steps", REQUIRED, r#"["2 kN", "4 kN"]"#,
            "magnitudes of the force on the whole hole, also in a half model").range(PUSHES),
    ]),
    Table::new("loads.pressure", &[
        stresses("steps", REQUIRED, r#"["1 MPa"]"#, "positive pushes on the body, negative pulls"),
    ]),
    Table::new("loads.polar_traction", &[
        words("file", "path", REQUIRED, r#""data/persson-ring5R-65deg.csv""#, "table, relative to the folder of the scene"),
        words("stress", "unit of stress", REQUIRED, r#""MPa""#, "unit of its stresses"),
        text("theta", r#"`"theta_deg"`"#, r#""theta_deg""#, "its column of angles in degrees"),
        text("radial", r#"`"sigma_r"`"#, r#""sigma_r""#, "its column of σ_r"),
        text("shear", r#"`"tau_rtheta"`"#, r#""tau_rtheta""#, "its column of τ_rθ"),
        words("steps", "list of numbers", REQUIRED, "[1.0]", "factors of its stresses"),
    ]),
    Table::new("loads.temperature", &[
        temperatures("steps", REQUIRED, r#"["-100 K"]"#,
            "change of the whole body's temperature since the stress-free state; its material needs an expansion"),
    ]),
];
