//! Fringe centres as a table has them, so that errors name the row and show the table's own numbers.

use stickslip_fem_core::mesh::Point;

use super::DataError;

/// A fringe centre as it was written.
#[derive(Clone, Copy, Debug)]
pub(super) struct Written {
    /// Line of its row in the file, if there is one.
    pub(super) row: Option<u64>,
    /// x and y in the table's own numbers.
    pub(super) place: Point,
    /// Order in the table's own numbers.
    pub(super) order: f64,
}

/// A line as errors call it, and its centres as they were written.
#[derive(Clone, Copy, Debug)]
pub(super) struct Origin<'a> {
    pub(super) file: &'a str,
    pub(super) name: &'a str,
    pub(super) centres: &'a [Written],
    /// Length of one unit of their places `[length]`.
    pub(super) scale: f64,
    /// Largest distance from the track `[length]`.
    pub(super) tolerance: f64,
}

/// What keeps centres, by their index as given, from being a line.
impl Origin<'_> {
    /// The line is too short.
    pub(super) fn short(&self) -> DataError {
        DataError::ShortLine {
            file: self.file.to_owned(),
            row: self.centres.first().and_then(|centre| centre.row),
            name: self.name.to_owned(),
            centres: self.centres.len(),
        }
    }

    /// A centre lies `distance` `[length]` off the track.
    pub(super) fn off(&self, centre: usize, distance: f64) -> DataError {
        let Written { row, place, order } = self.centres[centre];
        DataError::OffLine {
            file: self.file.to_owned(),
            row,
            name: self.name.to_owned(),
            place,
            order,
            distance: distance / self.scale,
            tolerance: self.tolerance / self.scale,
        }
    }

    /// The line turns back at a centre, by `angle` in degrees.
    pub(super) fn back(&self, centre: usize, angle: f64) -> DataError {
        let Written { row, place, .. } = self.centres[centre];
        DataError::TurnsBack {
            file: self.file.to_owned(),
            row,
            name: self.name.to_owned(),
            place,
            angle,
        }
    }

    /// Two centres are at one place.
    pub(super) fn repeated(&self, centres: [usize; 2]) -> DataError {
        let [first, second] = centres.map(|centre| self.centres[centre]);
        let rows = first.row.zip(second.row);
        DataError::RepeatedCentre {
            file: self.file.to_owned(),
            rows: rows.map(|(first, second)| [first, second]),
            name: self.name.to_owned(),
            places: [first.place, second.place],
            orders: [first.order, second.order],
        }
    }
}
