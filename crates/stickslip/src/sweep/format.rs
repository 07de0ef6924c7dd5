//! A sweep as a file spells it.

use serde::Deserialize;
use serde_json::Value;

/// The whole file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SweepFormat {
    /// Checked before the rest is read.
    #[serde(rename = "version")]
    pub(super) _version: u64,
    pub(super) title: Option<String>,
    pub(super) description: Option<String>,
    pub(super) scene: String,
    #[serde(default)]
    pub(super) joint: JointFormat,
    #[serde(default)]
    pub(super) axes: Vec<AxisFormat>,
    #[serde(default)]
    pub(super) map: MapFormat,
}

/// `[joint]`: what the named axes mean in this scene.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct JointFormat {
    pub(super) contact: Option<String>,
    pub(super) criterion: Option<String>,
}

/// `[[axes]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct AxisFormat {
    pub(super) key: String,
    pub(super) label: Option<String>,
    pub(super) values: Option<Vec<Value>>,
    pub(super) from: Option<Value>,
    pub(super) to: Option<Value>,
    pub(super) count: Option<usize>,
}

/// `[map]`: the axes that pictures are drawn over.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct MapFormat {
    pub(super) x: Option<String>,
    pub(super) y: Option<String>,
}
