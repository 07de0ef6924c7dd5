//! How often the errors that results state hold the truth, over random pins: what `cargo xtask accuracy` counts.

use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use crate::accuracy::{ASKED, COVERAGE, FEW, PINS, counted};
use crate::publish::TaskError;

/// Seed of the pins.
const SEED: u64 = 18;
/// Pins of the quick validation.
const FEWER: usize = 8;

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let count = laboratory.sized(FEWER, FEW);
    let tally = counted((count, SEED), &PINS, &ASKED[..2], |_, _, _, _| {});
    let mut checks = Checks::against("finest nodes, eight times as many increments");
    let (held, decided) = tally.total();
    if decided == 0 {
        return Err("no number of the random pins is decided".into());
    }
    let share = |held: usize, decided: usize| {
        let share = 100.0 * held as f64 / decided.max(1) as f64;
        format!("{share:.1} % of {decided}")
    };
    checks.holds(
        format!("numbers of {count} random pins within their stated error"),
        format!("at least {} %", 100.0 * COVERAGE),
        share(held, decided),
        held as f64 >= COVERAGE * decided as f64,
    );
    for (name, held, decided) in tally.shares().filter(|own| own.2 > 0) {
        checks.show(name, "", share(held, decided));
    }
    Ok(checks.into_list())
}
