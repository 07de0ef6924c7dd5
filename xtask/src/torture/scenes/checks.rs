//! The checks of solved scenes.

use super::sample::{Sample, Verdict};
use super::trial::{Demand, demands};
use super::{balance, conditions, display, relations, sweeps};

/// Says whether an answer meets a check.
type Judge = fn(&Sample) -> Verdict;

/// What makes each check, in the order of `checks.toml`; the answers of the last ones are the same bits.
const JUDGES: [(&str, Judge); 22] = [
    ("numbers", conditions::numbers),
    ("unilateral", conditions::unilateral),
    ("cone", conditions::cone),
    ("direction", conditions::direction),
    ("dissipation", conditions::dissipation),
    ("resultant", conditions::resultant),
    ("bodies", balance::bodies),
    ("balance note", balance::residual),
    ("written", display::written),
    ("mirrored", relations::mirrored),
    ("turned", relations::turned),
    ("half and whole", relations::half_and_whole),
    ("rescaled", relations::rescaled),
    ("stiffer", relations::stiffer),
    ("other units", relations::other_units),
    ("path", relations::path),
    ("another solver", relations::another_solver),
    ("another mesh", relations::another_mesh),
    ("renamed", relations::renamed),
    ("key order", relations::key_order),
    ("threads", relations::threads),
    ("resumed", sweeps::resumed),
];

/// A check of a solved scene.
pub(super) struct Check {
    pub(super) name: &'static str,
    /// In what part of the scenes it is made, because it takes further runs.
    pub(super) share: f64,
    pub(super) verdict: Judge,
}

/// All checks, in the order of the page.
pub(super) fn checks() -> impl Iterator<Item = Check> {
    let check = |(demand, (name, verdict)): (&'static Demand, _)| Check {
        name,
        share: demand.share,
        verdict,
    };
    demands("scenes").iter().zip(JUDGES).map(check)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_check_is_made() {
        let demanded: Vec<&str> = (demands("scenes").iter())
            .map(|own| own.name.as_str())
            .collect();
        assert_eq!(demanded, JUDGES.map(|(name, _)| name));
    }
}
