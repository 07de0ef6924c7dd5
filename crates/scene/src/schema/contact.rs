//! Edges that may touch.

use super::SetRef;
use crate::declaration::choices::coded;
use crate::declaration::{REQUIRED, Table, described, flag, names, set, text};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use stickslip_friction::FrictionLaw;

/// Two edges that may touch.
#[derive(Debug, Clone)]
pub struct Contact {
    /// Name in results.
    pub name: String,
    /// The edge that the normal points into: hole, or cylinder.
    pub first: SetRef,
    /// The other edge: rim of a pin, outer edge of a ring, or block.
    pub second: SetRef,
    /// How the initial gap is computed.
    pub gap: GapKind,
    /// How the two edges are tied to each other.
    pub projection: ProjectionChoice,
    /// Whether an initial overlap is meant.
    pub interference: bool,
    /// Its friction.
    pub law: Box<dyn FrictionLaw>,
}

impl Contact {
    /// What its model depends on, as a text: equal texts are equal models up to friction laws.
    pub fn geometry(&self) -> String {
        // Without `..`, so that no key is forgotten: what is named `_` changes no model.
        let Self {
            name,
            first,
            second,
            gap,
            projection,
            interference: _,
            law: _,
        } = self;
        format!("{name} {first} {second} {gap:?} {projection:?}")
    }
}

/// How the initial gap between two circles is computed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum GapKind {
    /// From the circles.
    #[default]
    Exact,
    /// c (1 − cos θ), clearance c: what closed forms assume.
    Linearised,
    /// From the nodes and straight facets of the mesh.
    Faceted,
}

/// How two edges in contact are tied to each other.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ProjectionChoice {
    /// Pairs of nodes where the meshes match, dual mortar where they do not.
    #[default]
    Auto,
    /// Pairs of nodes; the meshes must match.
    Nodes,
    /// Mortar projection with the shape functions of the first edge.
    Mortar,
    /// Mortar projection with functions biorthogonal to them.
    DualMortar,
}

impl ProjectionChoice {
    /// Whether it asks for a mortar projection.
    pub fn is_mortar(self) -> bool {
        matches!(self, Self::Mortar | Self::DualMortar)
    }
}

/// `[[contacts]]`.
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

impl ContactFormat {
    /// The contact of two edges that exist.
    pub(crate) fn contact(
        &self,
        name: String,
        [first, second]: [SetRef; 2],
        law: Box<dyn FrictionLaw>,
    ) -> Contact {
        // Without `..`, here and in other tables, so that no key is forgotten.
        let Self {
            name: _,
            first: _,
            second: _,
            gap,
            projection,
            interference,
            friction: _,
        } = *self;
        Contact {
            name,
            first,
            second,
            gap,
            projection,
            interference,
            law,
        }
    }
}

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("contacts", &[
        text("name", "name of the second body", r#""pin""#, "name in the results, a different one for each contact"),
        set("first", REQUIRED, r#""plate.hole""#,
            "a hole, the `contact` edge of a cylinder, or an open edge; of an elastic body"),
        set("second", REQUIRED, r#""pin.rim""#,
            "the rim of a disk or the `outer` edge of a ring in the hole, the `contact` edge of a block under the cylinder, or another open edge"),
        described("gap", r#"`"exact"`, `"linearised"`, `"faceted"`"#, r#"`"exact"`"#, r#""linearised""#,
            "initial gap: of the true circles; to first order, c (1 − cos θ) with clearance c or x²/2R, as closed forms have \
            it; between the nodes of the mesh"),
        described("projection", r#"`"auto"`, `"nodes"`, `"mortar"`, `"dual-mortar"`"#, r#"`"auto"`"#, r#""dual-mortar""#,
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
