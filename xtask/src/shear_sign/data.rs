//! What the studies of the sign of shear share.

use toml::Table;

use crate::study::record::list;

/// Load at the end of each step `[lbf]`.
pub(super) fn loads(case: &Table) -> Vec<f64> {
    let texts = list(case, "loads").iter().filter_map(|load| load.as_str());
    texts
        .filter_map(|text| text.split(' ').next()?.parse().ok())
        .collect()
}

/// The case as the beginning of a row, without what only the scene needs.
pub(super) fn begun(case: &Table) -> Table {
    let mut row = case.clone();
    for key in ["set", "loads"] {
        row.remove(key);
    }
    row
}

/// The report's angle of |θ|, and back `[degree]`.
pub(super) fn of_report(angle: f64) -> f64 {
    90.0 - angle
}

/// Places where the curve through `rows` of angle and shear passes zero.
pub(super) fn crossings(rows: &[[f64; 2]]) -> Vec<f64> {
    let pairs = rows
        .windows(2)
        .filter(|pair| pair[0][1].signum() != pair[1][1].signum());
    let place = |pair: &[[f64; 2]]| {
        let part = pair[0][1] / (pair[0][1] - pair[1][1]);
        pair[0][0] + part * (pair[1][0] - pair[0][0])
    };
    pairs.map(place).collect()
}
