//! What a table of displacements means.

use super::DataError;

/// Which columns hold what, and in what unit.
///
/// Names are compared without regard to upper and lower case. Another program's table is read by changing the names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Format {
    /// Columns of the places x and y.
    pub places: [String; 2],
    /// Columns of the displacements x and y; `None` where a component was not measured.
    pub displacements: [Option<String>; 2],
    /// A column that is negative or NaN where a point failed.
    pub flag: Option<String>,
    /// Whether places are those before or after the deformation.
    pub moved: Places,
    /// Whether the numbers are in pixels, so that a scale must be stated.
    pub pixels: bool,
}

/// What state of the body the places of a table belong to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Places {
    /// Before the deformation.
    Reference,
    /// After the deformation; the displacement is subtracted.
    Deformed,
}

impl Format {
    /// A format of its own: columns of the places and of the displacements, in the reference state, with a unit.
    pub fn columns(places: [&str; 2], displacements: [&str; 2]) -> Self {
        Self {
            places: places.map(String::from),
            displacements: displacements.map(|name| Some(name.into())),
            flag: None,
            moved: Places::Reference,
            pixels: false,
        }
    }

    /// Columns `x`, `y`, `u`, `v` in a unit of length.
    pub fn plain() -> Self {
        Self::columns(["x", "y"], ["u", "v"])
    }

    /// The text output of DICe: pixels, and `SIGMA` −1 where the correlation failed.
    pub fn dice() -> Self {
        Self {
            flag: Some("SIGMA".into()),
            pixels: true,
            ..Self::columns(
                ["COORDINATE_X", "COORDINATE_Y"],
                ["DISPLACEMENT_X", "DISPLACEMENT_Y"],
            )
        }
    }

    /// A table of muDIC's fields: columns `x`, `y`, `ux`, `uy` in pixels. Its coordinates are those of the deformed state, and its
    /// displacements the difference to those of the first picture.
    pub fn mudic() -> Self {
        Self {
            moved: Places::Deformed,
            pixels: true,
            ..Self::columns(["x", "y"], ["ux", "uy"])
        }
    }
}

/// What the numbers of a table are in the body's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Length of one unit of the table's places (of one pixel, say) `[length]`; must be stated where the format is in pixels,
    /// 1 where it is not stated otherwise.
    pub scale: Option<f64>,
    /// Length of one unit of the table's displacements `[length]`; as `scale` where it is not stated.
    pub displacement_scale: Option<f64>,
    /// Where the table's y axis points.
    pub y_axis: YAxis,
    /// Whether each component's sign is opposite to that of its axis in the table.
    pub reversed: [bool; 2],
    /// Standard deviation of each component `[length]`.
    pub deviation: [f64; 2],
}

impl Default for Reading {
    /// No scale, y up, signs as they are, standard deviation 0.
    fn default() -> Self {
        Self {
            scale: None,
            displacement_scale: None,
            y_axis: YAxis::Up,
            reversed: [false; 2],
            deviation: [0.0; 2],
        }
    }
}

/// Where an axis y of a table points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum YAxis {
    /// Up, as the body's.
    #[default]
    Up,
    /// Down, as in pictures: y and v change their sign.
    Down,
}

impl YAxis {
    /// Factor of y and v.
    pub(super) fn sign(self) -> f64 {
        match self {
            Self::Up => 1.0,
            Self::Down => -1.0,
        }
    }
}

/// What a length that may be 0 is.
pub(super) const LENGTH: &str = "it is a length, 0 or above";

/// Refuses the setting `what` `value`, of which `range` says what it may be, if it is negative or no number.
pub(super) fn not_negative(
    what: &'static str,
    value: f64,
    range: &'static str,
) -> Result<(), DataError> {
    if value >= 0.0 {
        Ok(())
    } else {
        Err(DataError::Setting { what, value, range })
    }
}

/// Refuses the setting `what` `value` unless it is positive and finite.
pub(super) fn positive(what: &'static str, value: f64) -> Result<f64, DataError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(DataError::Setting {
            what,
            value,
            range: "it must be positive and finite",
        })
    }
}
