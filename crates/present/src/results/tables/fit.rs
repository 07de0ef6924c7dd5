//! Tables of load steps that fit a terminal: columns give way, numbers are never broken.

use stickslip_report::table::Table;

/// What can be left out, first things first; of two columns of one name the last goes first, and the parts of one thing together.
const DISPENSABLE: [&[&str]; 14] = [
    &["time"],
    &["at x, y"],
    &["at x, y"],
    &["at x, y"],
    &["σ_1", "σ_2", "τ_12"],
    &["solves"],
    &["±"],
    &["at φ", "at θ"],
    &["at x", "at s"],
    &["slip+", "slip−", "slip away", "slip towards"],
    &["at φ", "at θ"],
    &["at x", "at s"],
    &["stick"],
    &["bears at"],
];

/// The text of `table`, with as many columns as fit `width` characters, and a note of what was left out.
pub(super) fn fitted(mut table: Table, width: usize) -> String {
    let notes = std::mem::take(&mut table.notes);
    let mut left_out: Vec<&str> = Vec::new();
    for names in DISPENSABLE {
        if table.text_width() <= width {
            break;
        }
        for name in names {
            let columns = &table.columns;
            let Some(index) = columns.iter().rposition(|column| column.name == *name) else {
                continue;
            };
            table = table.without_column(index);
            if !left_out.contains(name) {
                left_out.push(name);
            }
        }
    }
    table.notes = notes;
    if !left_out.is_empty() {
        let note = format!("No width left for {}.", left_out.join(", "));
        table.notes.push(note);
    }
    table.to_text(None)
}
