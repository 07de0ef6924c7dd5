//! Keys that are stated and have no effect with what else is stated. They are reported and not refused, so that one file serves several
//! methods: `--set reduce.method=polynomial`.

use crate::{Fringes, Method, Reduce, RegionPlan, Source, State};
use stickslip_scene::diagnostic::SceneProblem;
use stickslip_scene::document::{Document, Part};

/// A key, whether anything uses it, and a sentence on what would.
type Entry = (&'static str, bool, &'static str);

/// A key that is stated and has no effect.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IgnoredKey {
    /// The file, or the argument, that states it.
    pub file: String,
    /// Line of the file, counted from 1.
    pub line: Option<usize>,
    /// The key.
    pub key: &'static str,
    /// What would use the key, or why nothing does.
    pub why: &'static str,
}

/// The keys without effect.
pub(super) fn without_effect(
    document: &Document,
    reduce: &Reduce,
    region: Option<&RegionPlan>,
    fringes: Option<&Fringes>,
    states: &[State],
) -> Vec<IgnoredKey> {
    let mut entries = of_method(reduce, region, states);
    entries.extend(of_data(fringes, states));
    let ignored = entries
        .into_iter()
        .filter(|(key, used, _)| !used && document.get(key).is_some());
    ignored
        .map(|(key, _, why)| placed(document, key, why))
        .collect()
}

fn placed(document: &Document, key: &'static str, why: &'static str) -> IgnoredKey {
    let problem = SceneProblem::conflict(why, "");
    let finding = document.finding(key, Part::Key, problem);
    let line = finding.position().map(|(line, _)| line);
    IgnoredKey {
        file: finding.source.name.clone(),
        line: line.filter(|_| !document.is_overridden(key)),
        key,
        why,
    }
}

fn of_method(reduce: &Reduce, region: Option<&RegionPlan>, states: &[State]) -> Vec<Entry> {
    let polynomial = matches!(reduce.method, Method::Polynomial { .. });
    let lines = matches!(reduce.method, Method::Lines { .. });
    let whole = region.is_some_and(|plan| plan.whole_plate);
    let subtracted = states.iter().any(null_of_other_places);
    let interpolated = (subtracted && reduce.common_places.is_none())
        || states.iter().any(|state| state.back.is_some());
    let of_polynomial = "only reduce.method = \"polynomial\" uses it";
    vec![
        ("reduce.order", polynomial, of_polynomial),
        ("reduce.neighbours", polynomial, of_polynomial),
        (
            "reduce.reach",
            lines,
            "only reduce.method = \"lines\" uses it",
        ),
        (
            "reduce.longest_side",
            reduce.method == Method::Linear || interpolated,
            "only reduce.method = \"linear\" and the interpolation of null and back use it",
        ),
        (
            "reduce.free",
            region.is_some(),
            "it is determined on the free edge of a [region], and no region is stated",
        ),
        (
            "region.smoothing",
            !lines || whole,
            "reduce.method = \"lines\" fits nothing to the data, and region.whole_plate is not set",
        ),
    ]
}

fn of_data(fringes: Option<&Fringes>, states: &[State]) -> Vec<Entry> {
    let four = fringes.is_some_and(|plan| plan.four);
    let [mut pictured, mut single] = [false; 2];
    let sources = states
        .iter()
        .flat_map(|state| {
            [
                Some(&state.source),
                state.null.as_ref(),
                state.back.as_ref(),
            ]
        })
        .flatten();
    for source in sources {
        match source {
            Source::Step(_) => (pictured, single) = (true, single || !four),
            Source::Pictures(own) => {
                pictured = true;
                single |= own.files.iter().any(|files| files.len() == 1);
            }
            Source::Table(_) | Source::Lines(_) => {}
        }
    }
    let of_pictures = "no state has fringe pictures";
    let of_single = "no state has single fringe pictures, whose phase is that of a carrier";
    vec![
        ("reduce.stride", pictured, of_pictures),
        ("reduce.least_modulation", pictured, of_pictures),
        ("reduce.band", single, of_single),
        ("reduce.settled", single, of_single),
        (
            "reduce.outliers",
            states.iter().any(State::has_table),
            "no state has a table",
        ),
        (
            "reduce.common_places",
            states.iter().any(null_of_other_places),
            "no state has a null field that is a table, or that is taken off a table",
        ),
    ]
}

/// Whether a state's null field may have places of its own: pictures have the same pixels, fringe lines are compared along themselves.
fn null_of_other_places(state: &State) -> bool {
    let is_table = |source: &Source| matches!(source, Source::Table(_));
    let null = state.null.as_ref();
    null.is_some_and(|null| is_table(null) || is_table(&state.source))
}
