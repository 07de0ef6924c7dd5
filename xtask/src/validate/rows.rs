//! Load shares of rows of bolts in a double lap, with and without clearance, against two full models of other programs.
//!
//! How the numbers of `rows.toml` were found is said in `crates/laboratory/data/README.md`.

use serde::Deserialize;

use super::check::Tolerance::Absolute;
use super::check::{Check, Checks};
use super::laboratory::{Laboratory, Size, Worst};
use crate::joints::Row;
use crate::publish::{TaskError, listed};

const ROWS: &str = include_str!("rows.toml");
/// Allowed error of a share `[% of the load]`.
const BOUND: f64 = 1.0;
/// Bolts of the rows of quick runs.
const QUICK: usize = 3;
/// Pull `[N]`.
const LOAD: f64 = 12e3;

/// A row, and what other programs found.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    /// Radial clearance `[µm]` of each bolt in the lower, the middle and the upper plate.
    clearances: Vec<[f64; 3]>,
    found: Vec<Found>,
}

/// What one program found.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Found {
    by: String,
    /// Parts `[%]` of the load that the lower plate takes from each bolt, the middle one gives it, and the upper one takes.
    shares: Vec<[f64; 3]>,
}

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::default();
    for case in listed::<Case>(ROWS, "rows")? {
        let count = case.clearances.len();
        if laboratory.size == Size::Quick && count > QUICK {
            continue;
        }
        let is_tight = case.clearances.as_flattened().iter().all(|own| *own == 0.0);
        let kind = if is_tight { "tight" } else { "loose" };
        let name = format!("{count} {kind} bolts");
        let row = Row {
            clearances: &case.clearances,
            pitch: 24.0,
            ends: [40.0, 12.0],
            held: r#"["x", "y"]"#,
            springs: r#"beam = { head = "clamped", nut = "clamped" }"#,
            spacing: laboratory.sized(10.0, 5.0),
            load: LOAD,
        };
        let results = laboratory.run_text(&name, &row.scene())?;
        let shares: Vec<[f64; 3]> = (results.steps[0].fasteners.iter())
            .map(|bolt| {
                let part = |layer: usize| 100.0 * bolt.layers[layer].force[0] / LOAD;
                [part(0), -part(1), part(2)]
            })
            .collect();
        for (index, found) in case.found.iter().enumerate() {
            checks.now_against(&found.by);
            compare(&mut checks, &name, &shares, &found.shares, index == 0);
        }
    }
    Ok(checks.into_list())
}

/// Every bolt on a line of its own where the numbers are to be shown, and the worst of all layers.
fn compare(
    checks: &mut Checks,
    name: &str,
    shares: &[[f64; 3]],
    found: &[[f64; 3]],
    is_shown: bool,
) {
    let pairs = || shares.iter().zip(found).zip(1..);
    if is_shown {
        for ((own, other), bolt) in pairs() {
            checks.near(
                format!("{name}: share of bolt {bolt}"),
                [own[1], other[1]],
                Absolute(BOUND, " %"),
            );
        }
    }
    let mut worst = Worst::default();
    for ((own, other), bolt) in pairs() {
        for (layer, plate) in ["lower", "middle", "upper"].iter().enumerate() {
            worst.meet(0.01 * (own[layer] - other[layer]).abs(), || {
                format!("bolt {bolt}, {plate} plate")
            });
        }
    }
    if shares.len() != found.len() {
        worst.value = f64::NAN;
    }
    checks.error_below(
        format!("{name}: shares in all layers, of the load"),
        worst,
        0.01 * BOUND,
    );
}
