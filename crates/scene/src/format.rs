//! The scene as a file spells it: the tables that [`schema`](super::schema) holds, and those that are nothing but spelling.
//!
//! Serialising gives the scene with all defaults filled in.

use std::collections::BTreeMap;

use super::material::{MaterialFormat, PlyFormat};
use super::schema::{
    Analysis, BodyFormat, ContactFormat, DisplayUnits, FailureFormat, FastenerFormat, LoadFormat,
    MeshFormat, Output, PlatenFormat, SupportFormat,
};
use crate::declaration::{
    NONE, REQUIRED, Table, described, integer, lists, set, table, tables_of, text,
};
use crate::units::{Force, Length, Stress, UnitName};
use serde::{Deserialize, Serialize};

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
        described("length", "unit of length", r#"`"mm"`"#, r#""in""#, "lengths, gaps, slips"),
        described("force", "unit of force", r#"`"N"`"#, r#""lbf""#, "forces"),
        described("stress", "unit of stress", r#"`"MPa"`"#, r#""psi""#, "stresses, pressures"),
    ]),
    Table::new("edges", &[
        set("on", REQUIRED, r#""plate.left""#,
            "an edge of an elastic body: a circle, reported over θ, an edge along x, reported over x, or any other open edge of \
            outlines, rectangles and meshes whose curve is known, reported over the arc length s; not the second edge of a \
            contact; one that a half model lacks makes auto choose the whole"),
    ]),
];
