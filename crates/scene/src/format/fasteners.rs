//! Fasteners as a file spells them.

use serde::{Deserialize, Serialize};

use crate::units::{Force, Length, Quantity};

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
