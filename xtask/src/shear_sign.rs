//! `cargo xtask shear-sign`: which way friction points along a pin-loaded hole, and where matrix cracks are to be expected.
//!
//! Post and Reddy (1988, part I, 6.3) saw the shear on the edge of a (0/60/−60) plate change its sign at about 30° from the net section.
//! Their joint is solved with all friction laws over their parameters, with moduli of the plies and smeared ones, and over lay-up,
//! clearance and pin, loading and unloading; every load step is asked where the shear is reversed. The plies' transverse stresses along
//! the edge are compared with the matrix cracks of 6.4. Angles in tables are the report's: 90° − |θ|.

mod beneath;
pub(crate) mod curve;
mod data;
mod plies;
pub(crate) mod signs;

use data::{begun, crossings, loads, of_report};
use toml::Table;

use crate::study::record::text;
use crate::study::{Study, TaskError, solved_side_by_side};

pub(crate) const STUDY: Study = Study {
    name: "shear-sign",
    solve: |cases| solved_side_by_side(cases, rows),
    complete: |_| {},
};

fn rows(case: &Table) -> Result<Vec<Table>, TaskError> {
    match text(case, "table")? {
        "beneath" => beneath::rows(case),
        "plies" => plies::rows(case),
        _ => signs::rows(case),
    }
}
