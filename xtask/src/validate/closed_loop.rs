//! Friction from synthetic fringe pictures of a scene whose friction is known.

use super::check::{Check, Checks, Tolerance};
use super::laboratory::{Laboratory, Trouble};
use crate::closed_loop::{FIRST, Series, WITH_FRICTION, WITHOUT_FRICTION};

/// How far an identified coefficient may be from the truth.
const NEAR: f64 = 0.01;
/// Seeds of ten that an interval of 95 % may miss: more than two do so once in eighty times.
const MISSED: usize = 2;

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, Trouble> {
    let stopped = |cause: crate::publish::Trouble| Trouble::Missing(cause.to_string());
    let (seeds, others) = (laboratory.sized(2, 10), laboratory.sized(1, 2));
    let [many, some] = [seeds, others].map(|count| FIRST..=FIRST + count - 1);
    let rubbing = Series::of(WITH_FRICTION, many).map_err(stopped)?;
    let smooth = Series::of(WITHOUT_FRICTION, some).map_err(stopped)?;
    let mut checks = Checks::against("the friction that the scene was solved with");
    let near = Tolerance::Absolute(NEAR);
    checks.holds(
        format!("μd, the farthest of {seeds} seeds"),
        format!("at most {NEAR} from {}", WITH_FRICTION.mu),
        format!("{:.4}", rubbing.farthest()),
        rubbing.farthest() <= NEAR,
    );
    let [mean, _] = rubbing.mean_and_spread();
    checks.near(
        format!("μd, mean of {seeds} seeds"),
        mean,
        WITH_FRICTION.mu,
        "",
        near,
    );
    checks.holds(
        "intervals of 95 % that hold it",
        format!(
            "{} of {seeds} at least",
            seeds as usize - MISSED.min(seeds as usize / 4)
        ),
        format!("{} of {seeds}", rubbing.covered()),
        rubbing.covered() + MISSED.min(seeds as usize / 4) >= seeds as usize,
    );
    checks.holds(
        "without friction",
        "none, or at most a little",
        format!("{} of {others} seeds", smooth.none_found()),
        smooth.none_found() == others as usize,
    );
    Ok(checks.into_list())
}
