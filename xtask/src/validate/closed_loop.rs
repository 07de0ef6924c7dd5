//! Friction from synthetic fringe pictures of a scene whose friction is known.

use super::check::Tolerance::Absolute;
use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use crate::closed_loop::{FIRST, NEAR, Series, WITH_FRICTION, WITHOUT_FRICTION, wanted};
use crate::publish::TaskError;

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let (seeds, others) = (laboratory.sized(2, 20), laboratory.sized(1, 4));
    let [many, some] = [seeds, others].map(|count| FIRST..=FIRST + count - 1);
    let rubbing = Series::of(WITH_FRICTION, many)?;
    let smooth = Series::of(WITHOUT_FRICTION, some)?;
    let mut checks = Checks::against("the friction that the scene was solved with");
    with_friction(&mut checks, &rubbing);
    recorded(&mut checks, [&rubbing, &smooth])?;
    let none = smooth.none_found();
    checks.holds(
        "without friction",
        format!("none, or at most {NEAR}"),
        format!("{none} of {others} seeds"),
        none == others as usize,
    );
    Ok(checks.into_list())
}

/// The 200 seeds of `cargo xtask closed-loop`, too long for every validation: what it recorded, and whether this run repeats it.
fn recorded(checks: &mut Checks, series: [&Series; 2]) -> Result<(), TaskError> {
    let [rubbing, smooth] = [
        Series::recorded(WITH_FRICTION)?,
        Series::recorded(WITHOUT_FRICTION)?,
    ];
    let wanted = wanted(rubbing.seeds);
    checks.completes(
        "docs/closed-loop: seeds whose interval of 95 %, with two ends, holds μd",
        format!("{} to {} of 200", wanted.start(), wanted.end()),
        format!("{} of {}", rubbing.covered(), rubbing.seeds),
        rubbing.seeds == 200 && wanted.contains(&rubbing.covered()),
    );
    checks.completes(
        "docs/closed-loop: μd, the farthest of all seeds; seeds without friction that say so",
        format!("at most {NEAR}; all"),
        format!(
            "{:.4}; {} of {}",
            rubbing.farthest(),
            smooth.none_found(),
            smooth.seeds
        ),
        rubbing.farthest() <= NEAR && smooth.none_found() == smooth.seeds,
    );
    let own: usize = series.iter().map(|own| own.seeds).sum();
    let same = rubbing.repeated_by(series[0]) + smooth.repeated_by(series[1]);
    checks.completes(
        "docs/closed-loop: coefficients that this run repeats to five digits",
        format!("all of its {own} seeds"),
        same.to_string(),
        same == own,
    );
    Ok(())
}

fn with_friction(checks: &mut Checks, series: &Series) {
    let (seeds, truth) = (series.seeds, series.truth);
    checks.holds(
        format!("μd, the farthest of {seeds} seeds"),
        format!("at most {NEAR} from {truth}"),
        format!("{:.4}", series.farthest()),
        series.farthest() <= NEAR,
    );
    checks.near(
        format!("μd, mean of {seeds} seeds"),
        [series.mean(), truth],
        Absolute(NEAR, ""),
    );
    let wanted = wanted(seeds);
    checks.holds(
        "intervals of 95 %, with two ends, that hold it",
        format!("{} to {} of {seeds}", wanted.start(), wanted.end()),
        format!("{} of {seeds}", series.covered()),
        wanted.contains(&series.covered()),
    );
}
