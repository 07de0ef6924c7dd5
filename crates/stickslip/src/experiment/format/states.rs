//! `[[states]]`: what was measured, and where it stands.

use std::collections::BTreeMap;
use std::fmt;

use serde::de::{self, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::{CarriersFormat, PlaceFormat};
use crate::units::{Force, Length, Quantity};

/// One state of the experiment.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct StateFormat {
    pub(in crate::experiment) name: String,
    pub(in crate::experiment) direction: Option<DirectionFormat>,
    pub(in crate::experiment) load: Option<Quantity<Force>>,
    pub(in crate::experiment) edge_force: Option<ForceFormat>,
    pub(in crate::experiment) step: Option<usize>,
    pub(in crate::experiment) table: Option<TableFormat>,
    pub(in crate::experiment) pictures: Option<PicturesFormat>,
    pub(in crate::experiment) lines: Option<LinesFormat>,
    pub(in crate::experiment) null: Option<SourceFormat>,
    pub(in crate::experiment) back: Option<SourceFormat>,
}

/// Known components of a force.
#[derive(Debug, Default, Deserialize)]
#[serde(
    default,
    deny_unknown_fields,
    expecting = "a table, such as { x = \"5516 N\" }"
)]
pub(in crate::experiment) struct ForceFormat {
    pub(in crate::experiment) x: Option<Quantity<Force>>,
    pub(in crate::experiment) y: Option<Quantity<Force>>,
}

/// Data that a state, its null field or its back is read from: exactly one of these.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct SourceFormat {
    pub(in crate::experiment) step: Option<usize>,
    pub(in crate::experiment) table: Option<TableFormat>,
    pub(in crate::experiment) pictures: Option<PicturesFormat>,
    pub(in crate::experiment) lines: Option<LinesFormat>,
}

/// Whether the load was growing or falling.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(in crate::experiment) enum DirectionFormat {
    Loading,
    Unloading,
}

/// Where an axis y points.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(in crate::experiment) enum AxisFormat {
    Up,
    Down,
}

/// Programs whose tables are known.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(in crate::experiment) enum PresetFormat {
    #[default]
    Plain,
    Dice,
    Mudic,
}

/// Column names that differ from those of the preset.
#[derive(Debug, Default, Deserialize)]
#[serde(
    default,
    deny_unknown_fields,
    expecting = "a table, such as { key = value }"
)]
pub(in crate::experiment) struct ColumnsFormat {
    pub(in crate::experiment) x: Option<String>,
    pub(in crate::experiment) y: Option<String>,
    pub(in crate::experiment) u: Option<String>,
    pub(in crate::experiment) v: Option<String>,
    pub(in crate::experiment) flag: Option<String>,
    pub(in crate::experiment) line: Option<String>,
    pub(in crate::experiment) order: Option<String>,
}

/// Displacements at scattered places.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct TableFormat {
    pub(in crate::experiment) file: String,
    #[serde(default)]
    pub(in crate::experiment) preset: PresetFormat,
    #[serde(default)]
    pub(in crate::experiment) columns: ColumnsFormat,
    pub(in crate::experiment) scale: Quantity<Length>,
    pub(in crate::experiment) displacement_scale: Option<Quantity<Length>>,
    pub(in crate::experiment) y_axis: AxisFormat,
    pub(in crate::experiment) origin: Option<[f64; 2]>,
    #[serde(default)]
    pub(in crate::experiment) reversed: [bool; 2],
    pub(in crate::experiment) deviation: Option<Quantity<Length>>,
}

/// Names of one picture, or of four with shifted phase.
#[derive(Debug)]
pub(in crate::experiment) enum FilesFormat {
    One(String),
    Four([String; 4]),
}

impl<'de> Deserialize<'de> for FilesFormat {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(FilesVisitor)
    }
}

/// Tells of a list that is none of four, where serde's untagged choice would only say that nothing fits.
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
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct RisingFormat {
    pub(in crate::experiment) u: [f64; 2],
    pub(in crate::experiment) v: [f64; 2],
}

/// Fringe pictures.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct PicturesFormat {
    pub(in crate::experiment) u: Option<FilesFormat>,
    pub(in crate::experiment) v: Option<FilesFormat>,
    pub(in crate::experiment) pixel: Quantity<Length>,
    pub(in crate::experiment) top_left: PlaceFormat,
    pub(in crate::experiment) y_axis: AxisFormat,
    pub(in crate::experiment) carrier: Option<CarriersFormat>,
    pub(in crate::experiment) rising: Option<RisingFormat>,
    pub(in crate::experiment) dark: Option<f64>,
}

/// What curve the fringe centres of a line lie on.
#[derive(Debug, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(in crate::experiment) enum TrackFormat {
    #[default]
    Straight,
    Drawn,
    Circle(CircleFormat),
}

/// `track.circle`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct CircleFormat {
    pub(in crate::experiment) centre: PlaceFormat,
    #[serde(default)]
    pub(in crate::experiment) closed: bool,
}

/// Tracks of single lines by name, in the table of either field.
#[derive(Debug, Default, Deserialize)]
#[serde(
    default,
    deny_unknown_fields,
    expecting = "a table, such as { u = { ring = \"drawn\" } }"
)]
pub(in crate::experiment) struct TracksFormat {
    pub(in crate::experiment) u: BTreeMap<String, TrackFormat>,
    pub(in crate::experiment) v: BTreeMap<String, TrackFormat>,
}

/// Fringe centres along lines.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::experiment) struct LinesFormat {
    pub(in crate::experiment) u: String,
    pub(in crate::experiment) v: String,
    #[serde(default)]
    pub(in crate::experiment) columns: ColumnsFormat,
    pub(in crate::experiment) scale: Quantity<Length>,
    pub(in crate::experiment) y_axis: AxisFormat,
    #[serde(default)]
    pub(in crate::experiment) reversed: [bool; 2],
    pub(in crate::experiment) tolerance: Option<Quantity<Length>>,
    #[serde(default)]
    pub(in crate::experiment) track: TrackFormat,
    #[serde(default)]
    pub(in crate::experiment) tracks: TracksFormat,
    pub(in crate::experiment) deviation: Option<f64>,
}
