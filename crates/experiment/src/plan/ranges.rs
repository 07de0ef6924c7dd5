//! Ranges of values, each declared once. What is checked with other values stands where these are read.

use std::f64::consts::TAU;

use stickslip_scene::declaration::{POSITIVE, Range, counts, numbers, outside, tables_at};
use stickslip_scene::diagnostic::{SceneError, SceneProblem};
use stickslip_scene::document::{Document, Part};

/// Keys of a table with the ranges of their values.
type Ranges = &'static [(&'static str, Range)];

const NOT_NEGATIVE: Range = numbers(" ≥ 0", "at least 0", |value| value >= 0.0);
const FROM_ONE: Range = numbers(" ≥ 1", "at least 1", |value| value >= 1.0);
#[rustfmt::skip]
const INSIDE: Range = numbers(" in (0, 1)", "between 0 and 1", |value| value > 0.0 && value < 1.0);

const AREA: Ranges = &[("radius", POSITIVE)];

/// What a state, its null field and its back may be read from.
#[rustfmt::skip]
const SOURCES: &[(&str, Ranges)] = &[
    ("table", &[("scale", POSITIVE), ("displacement_scale", POSITIVE), ("deviation", POSITIVE)]),
    ("pictures", &[
        ("pixel", POSITIVE),
        ("dark", numbers(" in [0, 1)", "at least 0 and less than 1, a part of full scale", is_part)),
    ]),
    ("lines", &[
        ("scale", POSITIVE),
        ("tolerance", NOT_NEGATIVE),
        ("deviation", numbers(" > 0", "greater than 0, in fringes", |value| value > 0.0)),
    ]),
];

/// The other tables.
#[rustfmt::skip]
const TABLES: &[(&str, Ranges)] = &[
    ("specimen", &[("thickness", POSITIVE)]),
    ("specimen.hole", &[("radius", POSITIVE)]),
    ("fringes", &[
        ("pixel", POSITIVE),
        ("background", POSITIVE),
        ("modulation", numbers(" > 0", "greater than 0 and at most the background", |value| value > 0.0)),
        ("order_error", NOT_NEGATIVE),
        ("camera_noise", NOT_NEGATIVE),
        ("speckle", FROM_ONE),
        ("bits", numbers(", 8 or 16", "8 or 16", |value| value == 8.0 || value == 16.0)),
    ]),
    ("fringes.missing", AREA),
    ("reduce", &[
        ("stride", FROM_ONE),
        ("band", INSIDE),
        ("least_modulation", numbers(" in [0, 1)", "at least 0 and less than 1", is_part)),
        ("settled", INSIDE),
        ("margin", NOT_NEGATIVE),
        ("longest_side", POSITIVE),
        ("common_places", NOT_NEGATIVE),
        ("reach", POSITIVE),
        ("order", numbers(", 1, 2 or 3", "1, 2 or 3", |value| (1.0..=3.0).contains(&value))),
        ("outliers", numbers(" > 0", "greater than 0, or false where none are to be looked for", |value| value > 0.0)),
    ]),
    ("reduce.mask", AREA),
    ("reduce.symmetry", &[
        ("tolerance", numbers(" ≥ 0", "at least 0, in fringes", |value| value >= 0.0)),
        ("places", counts(2, 100_000)),
    ]),
    ("region.sector", &[("stand_off", NOT_NEGATIVE), ("growth", POSITIVE)]),
    ("region.mesh", &[("scale", POSITIVE)]),
    ("region.interior", AREA),
    ("region.smoothing", &[
        ("order", numbers(", 2 or 3", "2 or 3", |value| value == 2.0 || value == 3.0)),
        ("amount", NOT_NEGATIVE),
        ("share", POSITIVE),
    ]),
    ("identify", &[
        ("confidence", INSIDE),
        ("samples", counts(2, 1_000_000)),
        ("bearing", numbers(" within a turn", "from -360 to 360 deg", |value| value.abs() <= TAU + 1e-9)),
    ]),
];

fn is_part(value: f64) -> bool {
    (0.0..1.0).contains(&value)
}

/// Checks every value that is written against its range.
///
/// # Errors
/// [`SceneError`] with all values outside.
pub(super) fn check(document: &Document) -> Result<(), SceneError> {
    let of_state = |data: &'static str| {
        let own = move |&(name, ranges)| (format!("{data}.{name}"), ranges);
        SOURCES.iter().map(own)
    };
    let states = ["states", "states.null", "states.back"];
    let others = TABLES
        .iter()
        .map(|&(path, ranges)| (path.to_owned(), ranges));
    let mut findings = Vec::new();
    for (path, ranges) in others.chain(states.into_iter().flat_map(of_state)) {
        for (place, given) in tables_at(&path, &document.root) {
            for [key, value, allowed] in outside(&place, given, ranges.iter().copied()) {
                let problem = SceneProblem::out_of_range(&key, &value, allowed);
                findings.push(document.finding(&key, Part::Value, problem));
            }
        }
    }
    SceneError::of_all(findings)
}
