//! `cargo xtask shear-sign`: which way friction points along a pin-loaded hole, and where matrix cracks are to be expected.
//!
//! Post and Reddy (1988, part I, 6.3) saw the shear on the edge of a (0/60/−60) plate change its sign at about 30° from the net section.
//! Their joint is solved with all friction laws over their parameters, with moduli of the plies and smeared ones, and over lay-up,
//! clearance and pin, loading and unloading; every load step is asked where the shear is reversed. The plies' transverse stresses along
//! the edge are compared with the matrix cracks of 6.4. Angles in tables are the report's: 90° − |θ|.

mod beneath;
pub(crate) mod curve;
mod plies;
pub(crate) mod signs;

use toml::Table;

use crate::study::record::{list, text};
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

/// Load at the end of each step `[lbf]`.
fn loads(case: &Table) -> Vec<f64> {
    let texts = list(case, "loads").iter().filter_map(|load| load.as_str());
    texts
        .filter_map(|text| text.split(' ').next()?.parse().ok())
        .collect()
}

/// The case as the beginning of a row, without what only the scene needs.
fn begun(case: &Table) -> Table {
    let mut row = case.clone();
    for key in ["set", "loads"] {
        row.remove(key);
    }
    row
}

/// The report's angle of |θ|, and back `[degree]`.
fn of_report(angle: f64) -> f64 {
    90.0 - angle
}

/// Places where the curve through `rows` of angle and shear passes zero.
fn crossings(rows: &[[f64; 2]]) -> Vec<f64> {
    let pairs = rows
        .windows(2)
        .filter(|pair| pair[0][1].signum() != pair[1][1].signum());
    let place = |pair: &[[f64; 2]]| {
        let part = pair[0][1] / (pair[0][1] - pair[1][1]);
        pair[0][0] + part * (pair[1][0] - pair[0][0])
    };
    pairs.map(place).collect()
}
