//! Findings of measured data.

use serde::Serialize;

/// What the experiment file itself shows.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum FileFinding {
    /// A key of the experiment that has no effect with what else it states.
    IgnoredKey {
        /// The file, or the argument, that states it.
        file: String,
        /// Line of the file, counted from 1.
        line: Option<usize>,
        /// The key.
        key: &'static str,
        /// What would make it matter.
        why: &'static str,
    },
}

/// The outlier that is farthest off.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Worst {
    /// Its line in the file, counted from 1.
    pub line: u64,
    /// U or V.
    pub field: &'static str,
    /// What was measured `[mm]`.
    pub value: f64,
    /// What its neighbours say `[mm]`.
    pub expected: f64,
}

/// What tables of displacements show.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum TableFinding {
    /// A row of units that are no lengths.
    UnitNotCompared {
        /// The table.
        file: String,
        /// Line of the row, counted from 1.
        line: u64,
        /// Name of the column.
        column: String,
        /// The unit as it is written.
        unit: String,
        /// The key that it would be compared with.
        key: &'static str,
    },
    /// Valid places that lie well inside of the hole.
    InsideHole {
        /// The table.
        file: String,
        /// How many.
        count: usize,
        /// Of how many valid ones.
        places: usize,
        /// The deepest of them `[mm]`.
        deepest: [f64; 2],
        /// Its distance from the edge `[mm]`.
        depth: f64,
    },
    /// Places that were masked as outliers.
    Outliers {
        /// The table.
        file: String,
        /// How many.
        count: usize,
        /// Of how many.
        places: usize,
        /// The worst of them.
        worst: Worst,
    },
}

impl TableFinding {
    pub(super) const fn warns(&self) -> bool {
        !matches!(self, Self::UnitNotCompared { .. })
    }
}

/// What displacements show, whatever their source.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum FieldFinding {
    /// A component that scatters as little as calculated data do.
    AsCalculated {
        /// U or V.
        field: &'static str,
        /// Standard deviation `[mm]`.
        deviation: f64,
        /// The same over the range of the component `[1]`.
        of_range: f64,
    },
    /// A standard deviation that was estimated.
    Deviation {
        /// U or V.
        field: &'static str,
        /// Standard deviation `[mm]`.
        deviation: f64,
        /// Whether it is that of the rounding of digits, which neighbours do not exceed.
        by_digits: bool,
    },
    /// A finite rotation of the specimen that was taken off.
    RotationTakenOff {
        /// Angle `[degree]`, counter-clockwise, against the reference picture.
        degrees: f64,
        /// Its standard deviation `[degree]`.
        deviation_degrees: f64,
        /// Displacements that are masked for it.
        masked: usize,
    },
    /// Displacements that are beyond small strains.
    LargeDisplacements {
        /// Their range over the extent of the places `[1]`.
        of_extent: f64,
    },
    /// States with the same data.
    SameData {
        /// Their names.
        states: Vec<String>,
    },
}

impl FieldFinding {
    pub(super) const fn warns(&self) -> bool {
        !matches!(self, Self::Deviation { .. } | Self::RotationTakenOff { .. })
    }
}

/// Places at which a field does not unwrap.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Apart {
    /// U or V.
    pub field: &'static str,
    /// Loops of four pixels that do not close.
    pub loops: usize,
    /// Neighbours half a fringe or more apart.
    pub jumps: usize,
}

/// What fringe pictures show.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum PictureFinding {
    /// A carrier that was found and not stated.
    CarrierFound {
        /// U or V.
        field: &'static str,
        /// The carrier `[1/mm]`.
        carrier_per_mm: [f64; 2],
    },
    /// Pixels that hang together with no pixel of the largest region.
    PixelsApart {
        /// U or V.
        field: &'static str,
        /// How many.
        pixels: usize,
    },
    /// Orders that depend on the path along which they are counted.
    Unwrapping {
        /// The fields with such places.
        fields: Vec<Apart>,
    },
    /// Maps that show a state before its null field is taken off.
    MapsBeforeNullField,
    /// Every how many pixels a displacement is taken.
    Stride {
        /// Number of pixels along either axis.
        pixels: usize,
    },
    /// Synthetic fringes that are finer than two pixels.
    FineFringes {
        /// U or V.
        field: &'static str,
        /// Part of the pixels where they are `[1]`.
        part: f64,
    },
}

impl PictureFinding {
    pub(super) const fn warns(&self) -> bool {
        match self {
            Self::PixelsApart { .. } | Self::MapsBeforeNullField | Self::Stride { .. } => false,
            Self::CarrierFound { .. } | Self::Unwrapping { .. } | Self::FineFringes { .. } => true,
        }
    }
}

/// What tables of fringe centres show.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum LineFinding {
    /// Centres so far off the track of their line that it may be another one.
    OffTrack {
        /// The table.
        file: String,
        /// Line of the farthest centre in the table, counted from 1.
        line: u64,
        /// Its x and y in the table's own unit.
        centre: [f64; 2],
        /// Its distance from the track `[mm]`.
        distance: f64,
        /// Name of the fringe line.
        fringe_line: String,
        /// Centres that are so far off.
        count: usize,
        /// Of how many.
        centres: usize,
        /// Median spacing of the centres along the track `[mm]`.
        spacing: f64,
    },
    /// Centres beyond the lines of the null field.
    BeyondNullField {
        /// How many.
        count: usize,
        /// Fringe line of the first.
        fringe_line: String,
        /// Its place `[mm]`.
        place: [f64; 2],
    },
    /// A rotation of the specimen that is not taken off.
    RotationKept {
        /// Angle `[degree]`, counter-clockwise, against the lines of no load.
        degrees: f64,
        /// Strain in both directions by it `[1]`.
        strain: f64,
    },
}

impl LineFinding {
    pub(super) const fn warns(&self) -> bool {
        !matches!(self, Self::BeyondNullField { .. })
    }
}

/// What comparing front and back shows.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum BackFinding {
    /// A component that the front lacks.
    FrontLacks {
        /// U or V.
        field: &'static str,
    },
    /// Fringe lines that are on the front alone.
    LinesOfFrontAlone {
        /// U or V.
        field: &'static str,
        /// Their names.
        lines: Vec<String>,
    },
    /// The carriers of either side were found, and with them mean strains are taken off.
    MeanStrainsNotSeen,
}

impl BackFinding {
    pub(super) const fn warns(&self) -> bool {
        matches!(self, Self::MeanStrainsNotSeen)
    }
}
