//! What is written beside tables.

use serde::{Deserialize, Serialize};

use crate::declaration::{Table, described, flag};

/// What is written beside tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Output {
    /// For which steps fields are written as VTU.
    pub fields: FieldOutput,
    /// Whether figures are drawn.
    pub figures: bool,
    /// Whether the meshes of bodies are written for other programs.
    pub meshes: bool,
}

impl Default for Output {
    fn default() -> Self {
        Self {
            fields: FieldOutput::Peak,
            figures: true,
            meshes: false,
        }
    }
}

/// For which load steps fields are computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FieldOutput {
    /// None.
    None,
    /// Where the load is largest that acts on a part of the scene which contact does not link to others, for every such part.
    Peak,
    /// The last.
    Last,
    /// Each.
    All,
}

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("output", &[
        described("fields", r#"`"none"`, `"peak"`, `"last"`, `"all"`"#, r#"`"peak"`"#, r#""all""#,
            "load steps whose displacements and stresses are written as VTU, and drawn: none, that of the largest load in \
            magnitude (the earliest of equals), of each load by which joints of their own are counted, the last, every one"),
        flag("figures", "`true`", "false", "whether figures are drawn, as SVG, as PNG and in `report.html`"),
        flag("meshes", "`false`", "true", "whether the meshes of bodies are written as `meshes/BODY.msh` and `.inp`, which `shape.mesh` reads"),
    ]),
];
