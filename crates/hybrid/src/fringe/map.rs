//! Values at the pixels of a picture.

use std::fmt;

use stickslip_fem_core::mesh::Point;

use super::{FringeError, MOST_PIXELS};

/// Where the pixels of a picture lie in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    columns: usize,
    rows: usize,
    first: Point,
    step: [f64; 2],
}

impl Frame {
    /// Frame of `columns` × `rows` pixels; the pixel of column c and row r has its centre at `first` + (c `step[0]`, r `step[1]`)
    /// `[length]`. A step is negative where a coordinate falls: in a photograph, whose row 0 is on top, `step[1]` is negative if y
    /// points up.
    ///
    /// # Errors
    ///
    /// No pixels, more than 2²⁸, a place that is not finite, or a step that is zero or not finite.
    pub fn new(
        columns: usize,
        rows: usize,
        first: Point,
        step: [f64; 2],
    ) -> Result<Self, FringeError> {
        let pixels = columns.saturating_mul(rows);
        let counted = (1..=MOST_PIXELS).contains(&pixels);
        let placed = first.iter().chain(&step).all(|value| value.is_finite())
            && step.iter().all(|&value| value != 0.0);
        if counted && placed {
            Ok(Self {
                columns,
                rows,
                first,
                step,
            })
        } else {
            Err(FringeError::Frame {
                columns,
                rows,
                step,
            })
        }
    }

    /// Upright frame of the `window` from its lower left to its upper right corner `[length]`, with square pixels of edge `pixel`
    /// `[length]`, as many as lie inside to 1e-9; row 0 is on top.
    ///
    /// # Errors
    ///
    /// As [`Frame::new`]; also where no pixel lies inside.
    pub fn over(window: [Point; 2], pixel: f64) -> Result<Self, FringeError> {
        let [low, high] = window;
        let count = |axis: usize| {
            ((high[axis] - low[axis]) / pixel * (1.0 + 1e-9))
                .floor()
                .max(0.0) as usize
        };
        Self::new(
            count(0),
            count(1),
            [low[0] + 0.5 * pixel, high[1] - 0.5 * pixel],
            [pixel, -pixel],
        )
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of pixels, which are counted row by row.
    pub fn pixels(&self) -> usize {
        self.columns * self.rows
    }

    /// Signed steps from column to column and from row to row `[length]`.
    pub fn step(&self) -> [f64; 2] {
        self.step
    }

    /// Centre `[length]` of a pixel, whose index counts row by row.
    pub fn place(&self, pixel: usize) -> Point {
        let (column, row) = (pixel % self.columns, pixel / self.columns);
        [
            self.first[0] + column as f64 * self.step[0],
            self.first[1] + row as f64 * self.step[1],
        ]
    }

    /// The error that a list has not one entry for each pixel but `found`.
    pub(super) fn unlike(&self, found: usize) -> FringeError {
        FringeError::Size {
            columns: self.columns,
            rows: self.rows,
            found,
        }
    }

    /// The error that `value` of a pixel is not finite.
    pub(super) fn not_finite(&self, pixel: usize, value: f64) -> FringeError {
        FringeError::NotFinite {
            column: pixel % self.columns,
            row: pixel / self.columns,
            value,
        }
    }

    /// Columns and rows, as real numbers, from the first pixel's centre to a place.
    pub(super) fn position(&self, place: Point) -> [f64; 2] {
        [
            (place[0] - self.first[0]) / self.step[0],
            (place[1] - self.first[1]) / self.step[1],
        ]
    }
}

impl fmt::Display for Frame {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            columns,
            rows,
            first,
            step,
        } = self;
        write!(
            out,
            "{columns} x {rows} pixels from ({}, {}) by ({}, {})",
            first[0], first[1], step[0], step[1]
        )
    }
}

/// Values at the pixels of a frame, some of them missing: intensities, fringe orders, displacements. At least one is there, and
/// those that are there are finite; missing ones read NaN.
#[derive(Clone, Debug)]
pub struct PixelMap {
    frame: Frame,
    values: Vec<f64>,
    valid: Vec<bool>,
}

impl PixelMap {
    /// Map of one value, in any unit, and one mark per pixel, row by row; `valid` is false where a value is missing.
    ///
    /// # Errors
    ///
    /// Lists of the wrong length; no valid pixel; a valid value that is not finite.
    pub fn new(frame: Frame, mut values: Vec<f64>, valid: Vec<bool>) -> Result<Self, FringeError> {
        let pixels = frame.pixels();
        for found in [values.len(), valid.len()] {
            if found != pixels {
                return Err(frame.unlike(found));
            }
        }
        for (pixel, (value, &valid)) in values.iter_mut().zip(&valid).enumerate() {
            if !valid {
                *value = f64::NAN;
            } else if !value.is_finite() {
                return Err(frame.not_finite(pixel, *value));
            }
        }
        if valid.contains(&true) {
            Ok(Self {
                frame,
                values,
                valid,
            })
        } else {
            Err(FringeError::Masked { pixels })
        }
    }

    /// Map of one value per pixel, in any unit, row by row, in which NaN stands for a missing one.
    ///
    /// # Errors
    ///
    /// As [`PixelMap::new`]; an infinite value is no missing one.
    pub fn with_gaps(frame: Frame, values: Vec<f64>) -> Result<Self, FringeError> {
        let valid = values.iter().map(|value| !value.is_nan()).collect();
        Self::new(frame, values, valid)
    }

    /// Map of the values, in any unit, of a function of the place `[length]`, which has none where the picture has none.
    ///
    /// # Errors
    ///
    /// As [`PixelMap::new`].
    pub fn of(frame: Frame, value: impl Fn(Point) -> Option<f64>) -> Result<Self, FringeError> {
        let found: Vec<_> = (0..frame.pixels())
            .map(|pixel| value(frame.place(pixel)))
            .collect();
        Self::new(
            frame,
            found
                .iter()
                .map(|value| value.unwrap_or(f64::NAN))
                .collect(),
            found.iter().map(Option::is_some).collect(),
        )
    }

    /// The same map without the pixels whose places `[length]` `keep` refuses.
    ///
    /// # Errors
    ///
    /// No pixel is left.
    pub fn restricted(&self, keep: impl Fn(Point) -> bool) -> Result<Self, FringeError> {
        let valid = (0..self.values.len())
            .map(|pixel| self.valid[pixel] && keep(self.frame.place(pixel)))
            .collect();
        Self::new(self.frame, self.values.clone(), valid)
    }

    /// Where the pixels lie.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// Values row by row, in the unit of the map; NaN where missing.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Which values are there, row by row.
    pub fn valid(&self) -> &[bool] {
        &self.valid
    }

    /// Value of a pixel, in the unit of the map, if it is there.
    pub fn get(&self, pixel: usize) -> Option<f64> {
        self.valid
            .get(pixel)
            .copied()
            .unwrap_or(false)
            .then(|| self.values[pixel])
    }

    /// Pixels that are there, with their values, in the unit of the map.
    pub fn present(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        (0..self.values.len())
            .filter(|&pixel| self.valid[pixel])
            .map(|pixel| (pixel, self.values[pixel]))
    }

    /// The same pixels with other values, finite wherever `change` of a finite value is.
    pub(super) fn mapped(&self, change: impl Fn(usize, f64) -> f64) -> Result<Self, FringeError> {
        let values = self
            .values
            .iter()
            .enumerate()
            .map(|(pixel, &value)| change(pixel, value))
            .collect();
        Self::new(self.frame, values, self.valid.clone())
    }

    /// Refuses maps of unlike frames.
    pub(super) fn same_frame(&self, other: &Self) -> Result<(), FringeError> {
        let like = self.frame == other.frame;
        if like {
            Ok(())
        } else {
            Err(FringeError::Frames(Box::new((self.frame, other.frame))))
        }
    }
}
