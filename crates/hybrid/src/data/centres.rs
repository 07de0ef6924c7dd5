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

/// What keeps fringe centres from being a line; centres by their index as given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Fault {
    Short,
    Off { centre: usize, distance: f64 },
    Back { centre: usize, angle: f64 },
    Repeated { centres: [usize; 2] },
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

impl Origin<'_> {
    /// The fault as an error of the table.
    pub(super) fn error(&self, fault: Fault) -> DataError {
        let (file, name) = (self.file.to_owned(), self.name.to_owned());
        match fault {
            Fault::Short => DataError::ShortLine {
                file,
                row: self.centres.first().and_then(|centre| centre.row),
                name,
                centres: self.centres.len(),
            },
            Fault::Off { centre, distance } => {
                let Written { row, place, order } = self.centres[centre];
                DataError::OffLine {
                    file,
                    row,
                    name,
                    place,
                    order,
                    distance: distance / self.scale,
                    tolerance: self.tolerance / self.scale,
                }
            }
            Fault::Back { centre, angle } => DataError::TurnsBack {
                file,
                row: self.centres[centre].row,
                name,
                place: self.centres[centre].place,
                angle,
            },
            Fault::Repeated { centres } => {
                let [first, second] = centres.map(|centre| self.centres[centre]);
                DataError::RepeatedCentre {
                    file,
                    rows: first
                        .row
                        .zip(second.row)
                        .map(|(first, second)| [first, second]),
                    name,
                    places: [first.place, second.place],
                    orders: [first.order, second.order],
                }
            }
        }
    }
}
