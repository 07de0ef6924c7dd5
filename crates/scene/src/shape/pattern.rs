//! `pattern`: rows and columns in which copies of a body, a hole or a cut-out stand.

use serde::{Deserialize, Serialize};

use crate::declaration::{Key, Range, Table, counts, described, integer};
use crate::units::{Length, Quantity};

/// Most rows, and most columns.
pub(crate) const MOST: usize = 1000;
/// Most copies.
pub(crate) const COPIES: usize = 10_000;

const COUNT: Range = counts(1, MOST as u32);

pub(crate) const MEANING: &str = "rows and columns in which copies of it stand";

const PATTERN: [Key; 3] = [
    integer(
        "rows",
        "`1`",
        "2",
        "number of rows, which follow each other along y",
    )
    .range(COUNT),
    integer(
        "columns",
        "`1`",
        "5",
        "number of columns, which follow each other along x",
    )
    .range(COUNT),
    described(
        "pitch",
        "two lengths",
        "required of holes and cut-outs",
        r#"["24 mm", "20 mm"]"#,
        "from one column to the next along x, and from one row to the next along y",
    ),
];

pub(super) const TABLES: &[Table] = &[
    Table::new("bodies.NAME.pattern", &PATTERN),
    Table::new("bodies.NAME.shape.outline.cutouts.NAME.pattern", &PATTERN),
    Table::new("bodies.NAME.shape.outline.holes.NAME.pattern", &PATTERN),
];

/// `pattern = { … }`; nothing has it once the scene is written out.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PatternFormat {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) rows: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) columns: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) pitch: Option<[Quantity<Length>; 2]>,
}
