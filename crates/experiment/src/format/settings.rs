//! `[reduce]`, `[region]`, `[identify]` and `[[laws]]`.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::Value;
use stickslip_fem_core::mesh::ElementKind;

use super::PlaceFormat;
use stickslip_scene::units::{Angle, Length, Quantity};

/// A part of the plane: a disc, or an upright rectangle.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct MaskFormat {
    pub(crate) centre: Option<PlaceFormat>,
    pub(crate) radius: Option<Quantity<Length>>,
    pub(crate) window: Option<[PlaceFormat; 2]>,
}

/// How displacements of nodes are made.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(crate) enum MethodFormat {
    Linear,
    Polynomial,
    Lines,
    #[default]
    Fit,
}

/// `[reduce]`.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct ReduceFormat {
    pub(crate) method: MethodFormat,
    pub(crate) longest_side: Option<Quantity<Length>>,
    pub(crate) order: Option<usize>,
    pub(crate) neighbours: Option<usize>,
    pub(crate) reach: Option<Quantity<Length>>,
    pub(crate) stride: Option<usize>,
    pub(crate) band: Option<f64>,
    pub(crate) least_modulation: Option<f64>,
    pub(crate) settled: Option<f64>,
    pub(crate) margin: Option<Quantity<Length>>,
    pub(crate) mask: Vec<MaskFormat>,
    pub(crate) common_places: Option<Quantity<Length>>,
    pub(crate) symmetry: Option<SymmetryFormat>,
    pub(crate) outliers: Option<OutliersFormat>,
    pub(crate) free: Vec<FreeFormat>,
}

/// One of `reduce.free`.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(crate) enum FreeFormat {
    Dilation,
    Tilt,
}

/// `reduce.outliers`: from what on displacements of tables are outliers, or whether any are looked for.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged, expecting = "a number, or false")]
pub(crate) enum OutliersFormat {
    Asked(bool),
    Beyond(f64),
}

/// `reduce.symmetry`: a line along which front and back are compared.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SymmetryFormat {
    pub(crate) from: PlaceFormat,
    pub(crate) to: PlaceFormat,
    pub(crate) tolerance: Option<f64>,
    pub(crate) places: Option<usize>,
}

/// `[region]`: a sector of arcs around the hole, or a mesh; and what is done with it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct RegionFormat {
    pub(crate) sector: Option<SectorFormat>,
    pub(crate) mesh: Option<MeshFormat>,
    #[serde(default)]
    pub(crate) interior: Vec<MaskFormat>,
    #[serde(default)]
    pub(crate) whole_plate: bool,
    pub(crate) smoothing: Option<SmoothingFormat>,
}

/// `region.mesh`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct MeshFormat {
    pub(crate) file: String,
    pub(crate) scale: Quantity<Length>,
}

/// `region.sector`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SectorFormat {
    pub(crate) angles: [Quantity<Angle>; 2],
    pub(crate) outer: Quantity<Length>,
    pub(crate) cells: [usize; 2],
    pub(crate) stand_off: Option<Quantity<Length>>,
    pub(crate) growth: Option<f64>,
    pub(crate) element: Option<ElementKind>,
}

/// `region.smoothing`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SmoothingFormat {
    pub(crate) order: Option<usize>,
    pub(crate) amount: Option<f64>,
    pub(crate) share: Option<f64>,
}

/// `[identify]`.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct IdentifyFormat {
    pub(crate) confidence: Option<f64>,
    pub(crate) samples: Option<usize>,
    pub(crate) seed: Option<u64>,
    pub(crate) bearing: Option<Quantity<Angle>>,
    pub(crate) zones: Vec<ZoneFormat>,
}

/// `[[identify.zones]]`: a zone given by hand.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ZoneFormat {
    pub(crate) state: String,
    pub(crate) from: Quantity<Angle>,
    pub(crate) to: Quantity<Angle>,
}

/// `[[laws]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LawFormat {
    pub(crate) name: Option<String>,
    pub(crate) friction: Value,
    #[serde(default)]
    pub(crate) free: BTreeMap<String, [Value; 2]>,
}
