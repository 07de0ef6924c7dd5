//! The scene as a file spells it, key by key.
//!
//! Field names are the keys. Unknown keys are refused, every quantity carries its unit, and choices are externally tagged
//! (`shape.disk = { … }`). Serialising gives the scene with all defaults filled in.

pub(super) mod bodies;
pub(super) mod contacts;
pub(super) mod failure;
pub(super) mod fasteners;
pub(super) mod loads;
pub(super) mod materials;
pub(super) mod progressive;
pub(super) mod supports;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use stickslip_contact::solver::SOLVERS;

use super::schema::{Analysis, DisplayUnits, Output};
use crate::declaration::choices::quoted;
use crate::declaration::{
    NONE, REQUIRED, Table, counts, flag, integer, lists, names, set, table, tables_of, text, words,
};
use crate::units::{Force, Length, Stress, UnitName};
pub(super) use bodies::{BodyFormat, MeshFormat};
pub(super) use contacts::ContactFormat;
pub(super) use failure::{
    CharacteristicFormat, DiscountFormat, EnvelopesFormat, FailureFormat, default_interaction,
    default_shear_weight,
};
pub(super) use fasteners::{
    EndFormat, FastenerFormat, FormulaFormat, JointFormat, LumpedFormat, SpringsFormat,
};
pub(super) use loads::{
    BearingFormat, ForceFormat, LoadFormat, PolarTractionFormat, PressureFormat, TemperatureFormat,
};
pub(super) use materials::{
    IsotropicFormat, LaminateFormat, MaterialFormat, OrthotropicFormat, PlyFormat, StrengthsFormat,
};
pub(super) use progressive::{
    ControlFormat, CrackBandFormat, DisplacementFormat, LoadsFormat, ProgressiveFormat,
};
pub(super) use supports::{PlatenFormat, SupportFormat};

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SceneFormat {
    pub(super) version: u64,
    pub(super) title: Option<String>,
    pub(super) description: Option<String>,
    #[serde(default)]
    pub(super) units: UnitsFormat,
    #[serde(default)]
    pub(super) analysis: Analysis,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(super) plies: BTreeMap<String, PlyFormat>,
    #[serde(default)]
    pub(super) materials: BTreeMap<String, MaterialFormat>,
    pub(super) bodies: BTreeMap<String, BodyFormat>,
    pub(super) mesh: Option<MeshFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) contacts: Vec<ContactFormat>,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(super) fasteners: BTreeMap<String, FastenerFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) supports: Vec<SupportFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) platens: Vec<PlatenFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) loads: Vec<LoadFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) edges: Vec<EdgeFormat>,
    pub(super) failure: Option<FailureFormat>,
    #[serde(default)]
    pub(super) output: Output,
}

/// `[units]`: what results are shown in; base units where a key is missing.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct UnitsFormat {
    length: UnitName<Length>,
    force: UnitName<Force>,
    stress: UnitName<Stress>,
}

impl UnitsFormat {
    /// The units of results.
    pub fn display(&self) -> DisplayUnits {
        let Self {
            length,
            force,
            stress,
        } = self;
        DisplayUnits {
            length: length.unit(),
            force: force.unit(),
            stress: stress.unit(),
        }
    }
}

impl Default for UnitsFormat {
    fn default() -> Self {
        Self {
            length: UnitName::base(),
            force: UnitName::base(),
            stress: UnitName::base(),
        }
    }
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EdgeFormat {
    pub(super) on: String,
}

/// The scene itself, and its tables without names.
#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("", &[
        integer("version", REQUIRED, "1", "version of this format; 1 is the only one"),
        text("title", "name of the file", r#""Pin-loaded plate""#, "headline of the results"),
        text("description", NONE, r#""Clearance 0.01 mm.""#, "what the scene shows"),
        table("units", "mm, N, MPa", "units of the results"),
        table("analysis", "all its defaults", "how the scene is solved"),
        tables_of("plies", NONE, "plies of laminates by name"),
        tables_of("materials", NONE, "elastic constants by name"),
        tables_of("bodies", REQUIRED, "bodies by name, at least one"),
        table("mesh", "chosen by the accuracy", "how finely the bodies are divided"),
        lists("contacts", NONE, "edges that may touch"),
        tables_of("fasteners", NONE, "fasteners through several plates by name"),
        lists("supports", NONE, "given displacements"),
        lists("platens", NONE, "rigid plates glued to edges"),
        lists("loads", NONE, "loads and their history"),
        lists("edges", NONE, "further edges to report"),
        table("failure", NONE, "failure of the plies of laminates"),
        table("output", "all its defaults", "what is written beside the tables"),
    ]),
    Table::new("units", &[
        words("length", "unit of length", r#"`"mm"`"#, r#""in""#, "lengths, gaps, slips"),
        words("force", "unit of force", r#"`"N"`"#, r#""lbf""#, "forces"),
        words("stress", "unit of stress", r#"`"MPa"`"#, r#""psi""#, "stresses, pressures"),
    ]),
    Table::new("analysis", &[
        words("plane", r#"`"stress"`, `"strain"`"#, r#"`"stress"`"#, r#""strain""#, "plane stress or plane strain"),
        words("model", r#"`"auto"`, `"half"`, `"whole"`"#, r#"`"auto"`"#, r#""whole""#,
            "half: y ≥ 0 of round shapes, x ≥ 0 of a line contact; auto takes it where shapes, materials, supports, platens, \
            loads and friction laws are symmetric and it has all `edges`; half is refused where they are not; a rectangle has \
            no half"),
        words("kinematics", r#"`"small"`, `"deformed-gaps"`, `"auto"`"#, r#"`"small"` with a mesh or fasteners, `"auto"` without"#, r#""deformed-gaps""#,
            "small: contact is found on the undeformed geometry; deformed-gaps: gaps, normals and closest points follow the displacement, \
            between linear bodies, for exact gaps and matching meshes; not for progressive failure and experiments; auto: deformed-gaps where it \
            changes more than three tenths of the accuracy, otherwise small with the change among the errors"),
        words("compliance", r#"`"auto"`, `"matrix"`, `"blocks"`"#, r#"`"auto"`"#, r#""blocks""#,
            "how the compliance of a body with contact on several edges is held: matrix: as one; blocks: as a matrix for each edge and few shapes \
            of forces, harmonics on a hole, by which edges act on each other, with the error in tractions among the choices; auto: blocks beyond \
            4000 components where solver and kinematics allow them"),
        names("solver", solvers,
            r#"`"auto"`"#, r#""pivoting""#,
            "auto and newton: semismooth Newton, then pivoting where it fails; status: iteration of statuses before these \
            two; the others alone. All but experimental ones ask first for a proof that the load cannot be balanced, and stop \
            at stated work"),
        flag("experimental", "`false`", "true",
            "allows solvers whose answers may be inexact (penalty) or that are limited to few points or to small friction \
            (enumeration, Tresca)"),
        integer("substeps", "`1`; by the accuracy where one is sought", "4",
            "equal sub-steps of every load step; one that fails is halved by itself").range(counts(1, 100_000)),
        words("ramp", r#"`"linear"`, `"quadratic"`"#, r#"`"linear"`, `"quadratic"` where the program chooses sub-steps"#, r#""quadratic""#,
            "load at sub-step k of n in the first load step, from nothing to its value P: P k/n, or P (k/n)², finer where \
            contact spreads fastest; the same of what a later step adds if it begins with all points open; others are linear"),
        words("accuracy", "percentage or number, 1e-8 to 0.5, or a table of these", "`\"1 %\"` without a mesh", r#"{ peak_pressure = "0.1 %" }"#,
            "largest relative error that is asked for; bodies and steps are divided until the estimated errors of peak pressure, peak \
            tangential stress, extent of contact and friction force, or of displacements in a scene without edges, are below it; or those of the numbers that a table names, each \
            with its own: `peak_pressure`, `peak_hoop`, `contact_extent`, `stick_extent`, `friction_force`, `normal_force`, \
            `hoop_at_bearing`, `displacement` and `stiffness` of what is loaded, `tangent_stiffness`, `reaction`"),
        words("budget", "time", r#"`"60 s"` without `accuracy`, no limit with it"#, r#""10 s""#,
            "time after which no finer model is tried, and one that is not ready is given up; the result then states the error that it has; needs `accuracy`"),
        words("memory", "memory", r#"`"4 GB"`"#, r#""16 GB""#,
            "estimated memory above which no finer model of elements is tried; the result then states the error that it has; for scenes whose mesh is left to the program"),
        integer("contact_nodes", "by the accuracy", "61",
            "nodes on half of each contact circle of bodies by series; pins them").range(counts(9, 2049)),
    ]),
    Table::new("edges", &[
        set("on", REQUIRED, r#""plate.left""#,
            "an edge of an elastic body: a circle, reported over θ, an edge along x, reported over x, or any other open edge of \
            outlines, rectangles and meshes whose curve is known, reported over the arc length s; not the second edge of a \
            contact; one that a half model lacks makes auto choose the whole"),
    ]),
    Table::new("output", &[
        words("fields", r#"`"none"`, `"peak"`, `"last"`, `"all"`"#, r#"`"peak"`"#, r#""all""#,
            "load steps whose displacements and stresses are written as VTU, and drawn: none, that of the largest load in \
            magnitude (the earliest of equals), of each load by which joints of their own are counted, the last, every one"),
        flag("figures", "`true`", "false", "whether figures are drawn, as SVG, as PNG and in `report.html`"),
        flag("meshes", "`false`", "true", "whether the meshes of bodies are written as `meshes/BODY.msh` and `.inp`, which `shape.mesh` reads"),
    ]),
];

/// The names of the contact solvers.
fn solvers() -> String {
    let of = |experimental: bool| {
        let own = SOLVERS
            .iter()
            .filter(|own| own.experimental == experimental);
        quoted(own.map(|own| own.name))
    };
    format!("{}; experimental {}", of(false), of(true))
}
