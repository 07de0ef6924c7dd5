//! Fasteners: disks in several layers that springs couple.

use crate::declaration::{
    POSITIVE, REQUIRED, Table, described, filled, force, length, lengths, table, table_as,
};
use crate::units::{Force, Length, Quantity};
use serde::{Deserialize, Serialize};

/// A fastener through several plates, in each of which one of its slices stands.
#[derive(Debug, Clone, PartialEq)]
pub struct Fastener {
    /// Name in results.
    pub name: String,
    /// Its slices, disks in the order of the layers.
    pub slices: Vec<String>,
    /// What couples them.
    pub springs: Springs,
}

/// What couples the slices of a fastener.
#[derive(Debug, Clone, PartialEq)]
pub enum Springs {
    /// They move and turn as one.
    Rigid,
    /// The shank as a beam of the slices' material, loaded evenly along the thickness of each plate.
    Beam {
        /// Whether head and nut, at the outer faces of the first and of the last slice, keep it from tilting.
        clamped: [bool; 2],
    },
    /// Given compliances between adjacent slices, which turn as one.
    Given {
        /// Displacement per force between each slice and the next `[mm/N]`.
        compliance: Vec<f64>,
    },
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FastenerFormat {
    pub(crate) slices: Vec<String>,
    pub(crate) springs: SpringsFormat,
}

/// `springs.rigid`, `springs.beam`, `springs.given` or `springs.lumped`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum SpringsFormat {
    Rigid(RigidFormat),
    Beam(BeamFormat),
    Given(GivenFormat),
    Lumped(LumpedFormat),
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct RigidFormat {}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct BeamFormat {
    #[serde(default)]
    pub(crate) head: EndFormat,
    #[serde(default)]
    pub(crate) nut: EndFormat,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum EndFormat {
    #[default]
    Free,
    Clamped,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct GivenFormat {
    pub(crate) force: Quantity<Force>,
    pub(crate) displacements: Vec<Quantity<Length>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LumpedFormat {
    pub(crate) formula: FormulaFormat,
    pub(crate) joint: Option<JointFormat>,
    pub(crate) force: Quantity<Force>,
    pub(crate) resolved: Quantity<Length>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum FormulaFormat {
    Huth,
    Boeing,
    Swift,
    Grumman,
    TateRosenfeld,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum JointFormat {
    BoltedMetal,
    RivetedMetal,
    BoltedComposite,
}

const FORMULAS: &str = r#"`"huth"`, `"boeing"`, `"swift"`, `"grumman"`, `"tate-rosenfeld"`"#;
const JOINTS: &str = r#"`"bolted-metal"`, `"riveted-metal"`, `"bolted-composite"`"#;
const ENDS: &str = r#"`"free"`, `"clamped"`"#;

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("fasteners.NAME", &[
        described("slices", "list of bodies", REQUIRED, r#"["bolt-1", "bolt-2", "bolt-3"]"#,
            "its disks, one in each plate and as thick as it, in the order of the layers").range(filled("two or more disks")),
        table_as("springs", REQUIRED, ".beam = {}", "what couples the slices"),
    ]),
    Table::new("fasteners.NAME.springs", &[
        table_as("rigid", "one of the four", "{}", "nothing gives: the slices move and turn as one; without keys"),
        table("beam", "one of the four", "the shank as a beam of the slices' material, in shear, bending and torsion"),
        table("given", "one of the four", "a displacement between each slice and the next; all turn as one"),
        table("lumped", "one of the four", "a formula for the whole fastener, less what contact resolves of it; all turn as one"),
    ]).choice(),
    Table::new("fasteners.NAME.springs.beam", &[
        described("head", ENDS, r#"`"free"`"#, r#""clamped""#, "whether the outer face of the first slice may tilt"),
        described("nut", ENDS, r#"`"free"`"#, r#""clamped""#, "whether the outer face of the last slice may tilt"),
    ]),
    Table::new("fasteners.NAME.springs.given", &[
        force("force", REQUIRED, r#""1 kN""#, "a force that one slice hands to the next").range(POSITIVE),
        lengths("displacements", REQUIRED, r#"["0.01 mm", "0.01 mm"]"#,
            "by how much that moves each slice against the next, one number fewer than slices").range(POSITIVE),
    ]),
    Table::new("fasteners.NAME.springs.lumped", &[
        described("formula", FORMULAS, REQUIRED, r#""huth""#, "whose formula"),
        described("joint", JOINTS, "required with `huth`", r#""bolted-metal""#, "the kind of joint to which Huth fitted his"),
        force("force", REQUIRED, r#""1 kN""#, "a force that a joint of this one fastener carries").range(POSITIVE),
        length("resolved", REQUIRED, r#""0.012 mm""#,
            "what contact and plates resolve of the fastener's displacement at that force").range(POSITIVE),
    ]),
];
