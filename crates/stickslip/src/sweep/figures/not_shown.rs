//! What pictures of a sweep leave out.

use stickslip_report::FigureError;

/// What the pictures of a sweep do not show.
#[derive(Debug, thiserror::Error)]
pub enum NotShown {
    /// Combinations of the axes that no picture has.
    #[error(
        "Pictures show the first {shown} of {all} combinations of the further axes; the table has all."
    )]
    Combinations {
        /// How many have pictures.
        shown: usize,
        /// How many there are.
        all: usize,
    },
    /// Combinations of the other axes that have no curve.
    #[error(
        "Charts over {axis} show the first {shown} of {all} combinations of the other axes; the table has all."
    )]
    Curves {
        /// Symbol of the axis of the charts.
        axis: String,
        /// How many have curves.
        shown: usize,
        /// How many there are.
        all: usize,
    },
    /// A picture that could not be drawn.
    #[error("{picture}: {cause}")]
    Failed {
        /// What it was to show.
        picture: String,
        /// Why.
        cause: FigureError,
    },
}
