//! The checks of solved scenes.

use super::sample::{Sample, Verdict};
use super::{balance, conditions, display, relations, sweeps};

/// A check of a solved scene.
pub(super) struct Check {
    pub(super) name: &'static str,
    /// What it demands, for the page.
    pub(super) demands: &'static str,
    /// In what part of the scenes it is made, because it takes further runs.
    pub(super) share: f64,
    pub(super) verdict: fn(&Sample) -> Verdict,
}

/// All checks, in the order of the page.
const CHECKS: [Check; 19] = [
    Check {
        name: "numbers",
        demands: "every written number is finite",
        share: 1.0,
        verdict: conditions::numbers,
    },
    Check {
        name: "unilateral",
        demands: "p ≥ 0, g ≥ 0, p g = 0, and statuses that say which; 1e-8",
        share: 1.0,
        verdict: conditions::unilateral,
    },
    Check {
        name: "cone",
        demands: "friction within the law's bound, at it where a point slips, the bound computed again from the scene's text; 1e-8",
        share: 1.0,
        verdict: conditions::cone,
    },
    Check {
        name: "direction",
        demands: "friction acts against slip, and slip has the sign of its status; 1e-8",
        share: 1.0,
        verdict: conditions::direction,
    },
    Check {
        name: "dissipation",
        demands: "no step dissipates less than nothing (1e-8), and one increment what tractions and slips do, up to h²/6 for the angle h between corner nodes",
        share: 1.0,
        verdict: conditions::dissipation,
    },
    Check {
        name: "resultant",
        demands: "the resultant is the sum of the written tractions; h²/6 for the angle h between corner nodes",
        share: 1.0,
        verdict: conditions::resultant,
    },
    Check {
        name: "bodies",
        demands: "loads, resultants and reactions of every body sum to zero; 1e-8 of its largest force",
        share: 1.0,
        verdict: balance::bodies,
    },
    Check {
        name: "balance note",
        demands: "a balance residual above 1e-8 is said in the notes",
        share: 1.0,
        verdict: balance::residual,
    },
    Check {
        name: "written",
        demands: "summary.json and the tables of the edges say what the results say, in the units that they name; 1e-11",
        share: 0.2,
        verdict: display::written,
    },
    Check {
        name: "mirrored",
        demands: "the mirror image of the scene has the mirror image of the answer; 1e-7",
        share: 0.4,
        verdict: relations::mirrored,
    },
    Check {
        name: "turned",
        demands: "a scene of circles turned by quarters has the turned answer; 1e-7",
        share: 1.0,
        verdict: relations::turned,
    },
    Check {
        name: "half and whole",
        demands: "half a model gives what the whole gives; 1e-7",
        share: 0.6,
        verdict: relations::half_and_whole,
    },
    Check {
        name: "rescaled",
        demands: "lengths × 7.3 and moduli × 3.1 scale the answer; 1e-7",
        share: 0.3,
        verdict: relations::rescaled,
    },
    Check {
        name: "stiffer",
        demands: "moduli and loads × 1000 scale the answer; 1e-7",
        share: 0.3,
        verdict: relations::stiffer,
    },
    Check {
        name: "other units",
        demands: "in, lbf, psi and rad give what mm, N, MPa and deg give; 1e-7",
        share: 0.15,
        verdict: relations::other_units,
    },
    Check {
        name: "path",
        demands: "without friction the last load step alone gives what the history ends with; 1e-7",
        share: 0.25,
        verdict: relations::path,
    },
    Check {
        name: "another solver",
        demands: "another solver, if it finds an answer, finds the same; 1e-7",
        share: 0.4,
        verdict: relations::another_solver,
    },
    Check {
        name: "another mesh",
        demands: "twice as fine a mesh changes normal forces by at most 30 %, where at least five nodes touch",
        share: 0.15,
        verdict: relations::another_mesh,
    },
    Check {
        name: "renamed",
        demands: "other names of bodies and another order of lists change nothing; 1e-7",
        share: 0.2,
        verdict: relations::renamed,
    },
];

/// Checks whose answers are the same bits.
const BITS: [Check; 3] = [
    Check {
        name: "key order",
        demands: "keys in another order, as JSON and as TOML, give the same hash and the same bits",
        share: 0.15,
        verdict: relations::key_order,
    },
    Check {
        name: "threads",
        demands: "three threads give the bits of one",
        share: 0.1,
        verdict: relations::threads,
    },
    Check {
        name: "resumed",
        demands: "a sweep over friction and clearance, its table cut and gone on with, ends with the same rows, and each case has the peak pressure of a single run; 1e-7",
        share: 0.08,
        verdict: sweeps::resumed,
    },
];

/// All of them.
pub(super) fn checks() -> impl Iterator<Item = &'static Check> {
    CHECKS.iter().chain(&BITS)
}
