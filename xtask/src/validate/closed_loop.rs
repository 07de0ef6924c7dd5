//! Friction from synthetic fringe pictures of a scene whose friction is known.

use super::check::{Check, Checks, Tolerance};
use super::laboratory::{Laboratory, Trouble};
use crate::closed_loop::{FIRST, NEAR, Series, WITH_FRICTION, WITHOUT_FRICTION, wanted};

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, Trouble> {
    let stopped = |cause: crate::publish::Trouble| Trouble::Missing(cause.to_string());
    let (seeds, others) = (laboratory.sized(2, 200), laboratory.sized(1, 20));
    let [many, some] = [seeds, others].map(|count| FIRST..=FIRST + count - 1);
    let rubbing = Series::of(WITH_FRICTION, many).map_err(stopped)?;
    let smooth = Series::of(WITHOUT_FRICTION, some).map_err(stopped)?;
    let mut checks = Checks::against("the friction that the scene was solved with");
    with_friction(&mut checks, &rubbing);
    let none = smooth.none_found(NEAR);
    checks.holds(
        "without friction",
        format!("none, or at most {NEAR}"),
        format!("{none} of {others} seeds"),
        none == others as usize,
    );
    Ok(checks.into_list())
}

fn with_friction(checks: &mut Checks, series: &Series) {
    let (seeds, truth) = (series.outcomes.len(), series.known.mu);
    checks.holds(
        format!("μd, the farthest of {seeds} seeds"),
        format!("at most {NEAR} from {truth}"),
        format!("{:.4}", series.farthest()),
        series.farthest() <= NEAR,
    );
    let [mean, _] = series.mean_and_spread();
    checks.near(
        format!("μd, mean of {seeds} seeds"),
        mean,
        truth,
        "",
        Tolerance::Absolute(NEAR),
    );
    let wanted = wanted(seeds);
    checks.holds(
        "intervals of 95 %, with two ends, that hold it",
        format!("{} to {} of {seeds}", wanted.start(), wanted.end()),
        format!("{} of {seeds}", series.covered()),
        wanted.contains(&series.covered()),
    );
}
