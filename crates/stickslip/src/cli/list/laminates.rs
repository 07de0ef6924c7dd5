//! How lay-ups are written, and the failure criteria with the strengths that they ask for.

use serde_json::{Value, json};
use stickslip_laminate::failure::{CriterionInfo, criteria};

use super::table;

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

fn strengths(info: &CriterionInfo) -> Vec<&'static str> {
    let criterion = (info.make)();
    let required = criterion.required().iter();
    required.map(|strength| strength.name()).collect()
}

pub(super) fn criteria_text() -> String {
    let rows = criteria().map(|info| {
        let needs = strengths(info).join(", ");
        let text = format!("{}; needs {needs}", info.summary);
        (info.name.to_owned(), text)
    });
    table("Failure criteria of plies, for failure.criteria", rows)
}

pub(super) fn criteria_value() -> Value {
    criteria()
        .map(|info| {
            json!({
                "name": info.name,
                "summary": info.summary,
                "strengths": strengths(info),
            })
        })
        .collect()
}
