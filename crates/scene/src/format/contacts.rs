//! Contacts as a file spells them.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::declaration::choices::coded;
use crate::declaration::{REQUIRED, Table, flag, names, set, text, words};
use crate::schema::{GapKind, ProjectionChoice};

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ContactFormat {
    pub(crate) name: Option<String>,
    pub(crate) first: String,
    pub(crate) second: String,
    #[serde(default)]
    pub(crate) gap: GapKind,
    #[serde(default)]
    pub(crate) projection: ProjectionChoice,
    #[serde(default)]
    pub(crate) interference: bool,
    pub(crate) friction: Option<Value>,
}

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("contacts", &[
        text("name", "name of the second body", r#""pin""#, "name in the results, a different one for each contact"),
        set("first", REQUIRED, r#""plate.hole""#,
            "a hole, the `contact` edge of a cylinder, or an open edge; of an elastic body"),
        set("second", REQUIRED, r#""pin.rim""#,
            "the rim of a disk or the `outer` edge of a ring in the hole, the `contact` edge of a block under the cylinder, or another open edge"),
        words("gap", r#"`"exact"`, `"linearised"`, `"faceted"`"#, r#"`"exact"`"#, r#""linearised""#,
            "initial gap: of the true circles; to first order, c (1 − cos θ) with clearance c or x²/2R, as closed forms have \
            it; between the nodes of the mesh"),
        words("projection", r#"`"auto"`, `"nodes"`, `"mortar"`, `"dual-mortar"`"#, r#"`"auto"`"#, r#""dual-mortar""#,
            "how the edges are tied: by pairs of nodes, which the meshes must have; by a mortar projection with the shape \
            functions of the first edge, or with functions dual to them; auto pairs nodes where the meshes match and takes \
            dual mortar where they do not"),
        flag("interference", "`false`", "true",
            "allows a pin or bushing larger than its hole, by at most 10 % of the radius; it starts concentric, and the whole \
            overlap acts from the first sub-step"),
        names("friction", laws, REQUIRED, ".static_dynamic = { static = 0.35, dynamic = 0.25 }",
            "the friction law by name, with its parameters; those of other crates too"),
    ]),
];

/// The friction laws, each a table.
fn laws() -> String {
    format!(
        "table {}",
        coded(stickslip_friction::laws().map(|law| law.name))
    )
}
