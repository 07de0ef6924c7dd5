//! An experiment as a file spells it, key by key.

mod settings;
mod states;

use serde::Deserialize;
use serde_json::{Map, Value};
use stickslip_fem_core::material::PlaneState;

use stickslip_scene::open::UnitsFormat;
use stickslip_scene::units::{Angle, Length, PerLength, Quantity};

pub(super) use settings::{
    FreeFormat, IdentifyFormat, LawFormat, MaskFormat, MethodFormat, OutliersFormat, ReduceFormat,
    RegionFormat, SectorFormat, SmoothingFormat, SymmetryFormat,
};
pub(super) use states::{
    AxisFormat, ColumnsFormat, FilesFormat, ForceFormat, LinesFormat, PicturesFormat, PresetFormat,
    SourceFormat, StateFormat, TableFormat, TrackFormat,
};

/// A place.
pub(super) type PlaceFormat = [Quantity<Length>; 2];

/// The whole file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ExperimentFormat {
    /// Checked before the rest is read.
    #[serde(rename = "version")]
    pub(super) _version: u64,
    pub(super) title: Option<String>,
    pub(super) description: Option<String>,
    pub(super) units: Option<UnitsFormat>,
    /// Plies of a laminate under `[specimen]`, spelled as in scenes.
    #[serde(default)]
    pub(super) plies: Map<String, Value>,
    pub(super) specimen: SpecimenFormat,
    pub(super) grating: Option<GratingFormat>,
    pub(super) fringes: Option<FringesFormat>,
    #[serde(default)]
    pub(super) states: Vec<StateFormat>,
    #[serde(default)]
    pub(super) reduce: ReduceFormat,
    pub(super) region: Option<RegionFormat>,
    #[serde(default)]
    pub(super) identify: IdentifyFormat,
    #[serde(default)]
    pub(super) laws: Vec<LawFormat>,
}

/// `[specimen]`: a body of a scene, or what the analysis needs of one.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SpecimenFormat {
    pub(super) scene: Option<String>,
    pub(super) body: Option<String>,
    pub(super) edge: Option<String>,
    #[serde(default)]
    pub(super) overrides: Vec<String>,
    #[serde(default)]
    pub(super) model_overrides: Vec<String>,
    pub(super) material: Option<Value>,
    pub(super) thickness: Option<Quantity<Length>>,
    pub(super) plane: Option<PlaneState>,
    pub(super) hole: Option<HoleFormat>,
}

/// `specimen.hole`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct HoleFormat {
    pub(super) centre: PlaceFormat,
    pub(super) radius: Quantity<Length>,
}

/// `[grating]`: a frequency, or the light and its angle.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct GratingFormat {
    pub(super) frequency: Option<Quantity<PerLength>>,
    pub(super) wavelength: Option<Quantity<Length>>,
    pub(super) angle: Option<Quantity<Angle>>,
}

/// Carriers of the two fields.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CarriersFormat {
    pub(super) u: [Quantity<PerLength>; 2],
    pub(super) v: [Quantity<PerLength>; 2],
}

/// `[fringes]`: how synthetic pictures are taken.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FringesFormat {
    pub(super) window: [PlaceFormat; 2],
    pub(super) pixel: Quantity<Length>,
    pub(super) carrier: Option<CarriersFormat>,
    #[serde(default)]
    pub(super) order_error: f64,
    pub(super) speckle: Option<u32>,
    #[serde(default)]
    pub(super) camera_noise: f64,
    pub(super) background: Option<f64>,
    pub(super) modulation: Option<f64>,
    #[serde(default)]
    pub(super) missing: Vec<MaskFormat>,
    #[serde(default)]
    pub(super) pictures: SeriesFormat,
    #[serde(default)]
    pub(super) format: FileKindFormat,
    pub(super) bits: Option<u32>,
    pub(super) seed: Option<u64>,
}

/// How many pictures a field has.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(super) enum SeriesFormat {
    #[default]
    One,
    Four,
}

/// Kind of the picture files.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(super) enum FileKindFormat {
    #[default]
    Png,
    Tiff,
}
