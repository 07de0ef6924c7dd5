//! `[[states]]`: what was measured, and where it stands.

use std::collections::BTreeMap;
use std::fmt;

use serde::de::{self, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::{CarriersFormat, PlaceFormat};
use crate::Direction;
use stickslip_scene::units::{Force, Length, Quantity};

/// One state of the experiment.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct StateFormat {
    pub(crate) name: String,
    pub(crate) direction: Option<Direction>,
    pub(crate) load: Option<Quantity<Force>>,
    pub(crate) edge_force: Option<ForceFormat>,
    pub(crate) step: Option<usize>,
    pub(crate) table: Option<TableFormat>,
    pub(crate) pictures: Option<PicturesFormat>,
    pub(crate) lines: Option<LinesFormat>,
    pub(crate) null: Option<SourceFormat>,
    pub(crate) back: Option<SourceFormat>,
}

/// Known components of a force.
#[derive(Debug, Default, Deserialize)]
#[serde(
    default,
    deny_unknown_fields,
    expecting = "a table, such as { x = \"5516 N\" }"
)]
pub(crate) struct ForceFormat {
    pub(crate) x: Option<Quantity<Force>>,
    pub(crate) y: Option<Quantity<Force>>,
}

/// Data that a state, its null field or its back is read from: exactly one of these.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SourceFormat {
    pub(crate) step: Option<usize>,
    pub(crate) table: Option<TableFormat>,
    pub(crate) pictures: Option<PicturesFormat>,
    pub(crate) lines: Option<LinesFormat>,
}

/// Where an axis y points.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(crate) enum AxisFormat {
    Up,
    Down,
}

/// Programs whose tables are known.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(crate) enum PresetFormat {
    #[default]
    Plain,
    Dice,
    Mudic,
}

/// Column names that differ from those of the preset.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct ColumnsFormat {
    pub(crate) x: Option<String>,
    pub(crate) y: Option<String>,
    pub(crate) u: Option<String>,
    pub(crate) v: Option<String>,
    pub(crate) flag: Option<String>,
    pub(crate) line: Option<String>,
    pub(crate) order: Option<String>,
}

/// Displacements at scattered places.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TableFormat {
    pub(crate) file: String,
    #[serde(default)]
    pub(crate) preset: PresetFormat,
    #[serde(default)]
    pub(crate) columns: ColumnsFormat,
    pub(crate) scale: Quantity<Length>,
    pub(crate) displacement_scale: Option<Quantity<Length>>,
    pub(crate) y_axis: AxisFormat,
    pub(crate) origin: Option<[f64; 2]>,
    #[serde(default)]
    pub(crate) reversed: [bool; 2],
    pub(crate) deviation: Option<Quantity<Length>>,
}

/// Names of one picture, or of four with shifted phase.
#[derive(Debug)]
pub(crate) enum FilesFormat {
    One(String),
    Four([String; 4]),
}

impl<'de> Deserialize<'de> for FilesFormat {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(FilesVisitor)
    }
}

/// Reports a list that does not have four entries, where serde's untagged choice would only say that nothing matches.
struct FilesVisitor;

impl<'de> Visitor<'de> for FilesVisitor {
    type Value = FilesFormat;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(
            "the name of a picture file, \"up-u.png\", or a list of four with phase steps of ¼, \
             [\"up-u-1.png\", \"up-u-2.png\", \"up-u-3.png\", \"up-u-4.png\"]",
        )
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<FilesFormat, E> {
        Ok(FilesFormat::One(name.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<FilesFormat, A::Error> {
        let mut names = Vec::new();
        while let Some(name) = list.next_element()? {
            names.push(name);
        }
        let four = names.try_into().map_err(|names: Vec<String>| {
            let expected: &dyn de::Expected = &self;
            de::Error::invalid_length(names.len(), expected)
        })?;
        Ok(FilesFormat::Four(four))
    }
}

/// Directions in which fringe orders rise.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct RisingFormat {
    pub(crate) u: [f64; 2],
    pub(crate) v: [f64; 2],
}

/// Fringe pictures.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PicturesFormat {
    pub(crate) u: Option<FilesFormat>,
    pub(crate) v: Option<FilesFormat>,
    pub(crate) pixel: Quantity<Length>,
    pub(crate) top_left: PlaceFormat,
    pub(crate) y_axis: AxisFormat,
    pub(crate) carrier: Option<CarriersFormat>,
    pub(crate) rising: Option<RisingFormat>,
    pub(crate) dark: Option<f64>,
}

/// What curve the fringe centres of a line lie on.
#[derive(Debug, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum TrackFormat {
    #[default]
    Straight,
    Drawn,
    Circle(CircleFormat),
}

/// `track.circle`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CircleFormat {
    pub(crate) centre: PlaceFormat,
    #[serde(default)]
    pub(crate) closed: bool,
}

/// Tracks of single lines by name, in the table of either field.
#[derive(Debug, Default, Deserialize)]
#[serde(
    default,
    deny_unknown_fields,
    expecting = "a table, such as { u = { ring = \"drawn\" } }"
)]
pub(crate) struct TracksFormat {
    pub(crate) u: BTreeMap<String, TrackFormat>,
    pub(crate) v: BTreeMap<String, TrackFormat>,
}

/// Fringe centres along lines.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LinesFormat {
    pub(crate) u: String,
    pub(crate) v: String,
    #[serde(default)]
    pub(crate) columns: ColumnsFormat,
    pub(crate) scale: Quantity<Length>,
    pub(crate) y_axis: AxisFormat,
    #[serde(default)]
    pub(crate) reversed: [bool; 2],
    pub(crate) tolerance: Option<Quantity<Length>>,
    #[serde(default)]
    pub(crate) track: TrackFormat,
    #[serde(default)]
    pub(crate) tracks: TracksFormat,
    pub(crate) deviation: Option<f64>,
}
