//! How lay-ups are written, and the failure criteria with the strengths that they ask for.

use serde_json::{Value, json};
use stickslip_laminate::FailureCriterion;

use super::table;
use crate::failure::criteria;

/// Lay-ups and the stacks that they mean, from the bottom up.
const LAYUPS: [(&str, &str); 8] = [
    ("[0/90]", "0, 90"),
    ("[0_2/90]", "0, 0, 90"),
    ("[0/±45/90]s", "0, 45, -45, 90, 90, -45, 45, 0"),
    ("[0/90]_2s", "0, 90, 0, 90, 90, 0, 90, 0"),
    (
        "[0/45/90~]s",
        "0, 45, 90, 45, 0: the mid-plane goes through the ply marked ~",
    ),
    ("[(±45)_2/0]", "45, -45, 45, -45, 0"),
    (
        "[0_2/60_2/-60_2]s",
        "0, 0, 60, 60, -60 four times, 60, 60, 0, 0",
    ),
    (
        "[0:carbon/90:glass]s",
        "0 of ply carbon, 90 of ply glass, and mirrored",
    ),
];

/// Where a criterion is defined.
fn source(name: &str) -> &'static str {
    match name {
        "max_stress" => "each stress against its strength; Jones (1999), 2.9.1",
        "max_strain" => "each strain against its limit; Jones (1999), 2.9.2",
        "tsai_hill" => "one quadratic form, strengths by sign; Azzi & Tsai (1965)",
        "tsai_hill_3d" => "the same in three dimensions; Post & Reddy (1988), part II, 4.4",
        "hoffman" => "with linear terms for unequal strengths; Hoffman (1967)",
        "tsai_wu" => "tensor polynomial, F12 by failure.tsai_wu_interaction; Tsai & Wu (1971)",
        "hashin" => "fibre and matrix apart, shear by failure.hashin_shear_weight; Hashin (1980)",
        "yamada_sun" => "fibres and shear alone, once all cracks have formed; Yamada & Sun (1978)",
        _ => "",
    }
}

pub(super) fn layups_text() -> String {
    let rows = LAYUPS
        .iter()
        .map(|(layup, stack)| ((*layup).to_owned(), (*stack).to_owned()));
    table(
        "Lay-ups, for materials.NAME.laminate.layup; degrees counter-clockwise from x, bottom ply first",
        rows,
    )
}

pub(super) fn layups_value() -> Value {
    LAYUPS
        .iter()
        .map(|(layup, stack)| json!({ "layup": layup, "stack": stack }))
        .collect()
}

fn strengths(criterion: &dyn FailureCriterion) -> Vec<&'static str> {
    let required = criterion.required().iter();
    required.map(|strength| strength.name()).collect()
}

pub(super) fn criteria_text() -> String {
    let rows = criteria().into_iter().map(|criterion| {
        let needs = strengths(criterion.as_ref()).join(", ");
        let name = criterion.name();
        (name.to_owned(), format!("{}; needs {needs}", source(name)))
    });
    table("Failure criteria of plies, for failure.criteria", rows)
}

pub(super) fn criteria_value() -> Value {
    criteria()
        .iter()
        .map(|criterion| {
            json!({
                "name": criterion.name(),
                "summary": source(criterion.name()),
                "strengths": strengths(criterion.as_ref()),
            })
        })
        .collect()
}
