//! `[reduce]`, `[region]`, `[identify]` and `[[laws]]`.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::Value;
use stickslip_fem_core::mesh::ElementKind;

use super::PlaceFormat;
use crate::units::{Angle, Length, Quantity};

/// A part of the plane: a disc, or an upright rectangle.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct MaskFormat {
    pub(in crate::experiment) centre: Option<PlaceFormat>,
    pub(in crate::experiment) radius: Option<Quantity<Length>>,
    pub(in crate::experiment) window: Option<[PlaceFormat; 2]>,
}

/// How displacements of nodes are made.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(in crate::experiment) enum MethodFormat {
    Linear,
    Polynomial,
    Lines,
    #[default]
    Fit,
}

/// `[reduce]`.
#[derive(Debug, Default, Deserialize)]
#[serde(
    default,
    deny_unknown_fields,
    expecting = "a table, such as { key = value }"
)]
pub(in crate::experiment) struct ReduceFormat {
    pub(in crate::experiment) method: MethodFormat,
    pub(in crate::experiment) longest_side: Option<Quantity<Length>>,
    pub(in crate::experiment) order: Option<usize>,
    pub(in crate::experiment) neighbours: Option<usize>,
    pub(in crate::experiment) reach: Option<Quantity<Length>>,
    pub(in crate::experiment) stride: Option<usize>,
    pub(in crate::experiment) band: Option<f64>,
    pub(in crate::experiment) least_modulation: Option<f64>,
    pub(in crate::experiment) settled: Option<f64>,
    pub(in crate::experiment) margin: Option<Quantity<Length>>,
    pub(in crate::experiment) mask: Vec<MaskFormat>,
    pub(in crate::experiment) common_places: Option<Quantity<Length>>,
    pub(in crate::experiment) symmetry: Option<SymmetryFormat>,
    pub(in crate::experiment) outliers: Option<OutliersFormat>,
    pub(in crate::experiment) free: Vec<FreeFormat>,
}

/// One of `reduce.free`.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(in crate::experiment) enum FreeFormat {
    Dilation,
    Tilt,
}

/// `reduce.outliers`: from what on displacements of tables are outliers, or whether any are looked for.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged, expecting = "a number, or false")]
pub(in crate::experiment) enum OutliersFormat {
    Asked(bool),
    Beyond(f64),
}

/// `reduce.symmetry`: a line along which front and back are compared.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct SymmetryFormat {
    pub(in crate::experiment) from: PlaceFormat,
    pub(in crate::experiment) to: PlaceFormat,
    #[serde(default = "quarter")]
    pub(in crate::experiment) tolerance: f64,
    #[serde(default = "places")]
    pub(in crate::experiment) places: usize,
}

fn quarter() -> f64 {
    0.25
}

fn places() -> usize {
    41
}

/// `[region]`: a sector of arcs around the hole, or a mesh; and what is done with it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct RegionFormat {
    pub(in crate::experiment) sector: Option<SectorFormat>,
    pub(in crate::experiment) mesh: Option<MeshFormat>,
    #[serde(default)]
    pub(in crate::experiment) interior: Vec<MaskFormat>,
    #[serde(default)]
    pub(in crate::experiment) whole_plate: bool,
    pub(in crate::experiment) smoothing: Option<SmoothingFormat>,
}

/// `region.mesh`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct MeshFormat {
    pub(in crate::experiment) file: String,
    pub(in crate::experiment) scale: Quantity<Length>,
}

/// `region.sector`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct SectorFormat {
    pub(in crate::experiment) angles: [Quantity<Angle>; 2],
    pub(in crate::experiment) outer: Quantity<Length>,
    pub(in crate::experiment) cells: [usize; 2],
    pub(in crate::experiment) stand_off: Option<Quantity<Length>>,
    #[serde(default = "one")]
    pub(in crate::experiment) growth: f64,
    #[serde(default = "quadratic")]
    pub(in crate::experiment) element: ElementKind,
}

fn one() -> f64 {
    1.0
}

fn quadratic() -> ElementKind {
    ElementKind::Q8
}

/// `region.smoothing`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct SmoothingFormat {
    #[serde(default = "second")]
    pub(in crate::experiment) order: usize,
    pub(in crate::experiment) amount: Option<f64>,
    pub(in crate::experiment) share: Option<f64>,
}

fn second() -> usize {
    2
}

/// `[identify]`.
#[derive(Debug, Default, Deserialize)]
#[serde(
    default,
    deny_unknown_fields,
    expecting = "a table, such as { key = value }"
)]
pub(in crate::experiment) struct IdentifyFormat {
    pub(in crate::experiment) confidence: Option<f64>,
    pub(in crate::experiment) samples: Option<usize>,
    pub(in crate::experiment) seed: Option<u64>,
    pub(in crate::experiment) bearing: Option<Quantity<Angle>>,
    pub(in crate::experiment) zones: Vec<ZoneFormat>,
}

/// `[[identify.zones]]`: a zone given by hand.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct ZoneFormat {
    pub(in crate::experiment) state: String,
    pub(in crate::experiment) from: Quantity<Angle>,
    pub(in crate::experiment) to: Quantity<Angle>,
}

/// `[[laws]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct LawFormat {
    pub(in crate::experiment) name: Option<String>,
    pub(in crate::experiment) friction: Value,
    #[serde(default)]
    pub(in crate::experiment) free: BTreeMap<String, [Value; 2]>,
}
