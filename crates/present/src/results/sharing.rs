//! Tables of how the contacts of a body share its load.

use stickslip_engine::results::{LoadShare, Results};
use stickslip_report::table::{Columns, Table};
use stickslip_text::significant;

use super::display::EdgeView;

/// The contacts on the body of `edge`, as the first of which it stands, in their order.
fn contacts_beside<'a>(edge: &EdgeView<'a>) -> Vec<EdgeView<'a>> {
    let all = EdgeView::all(edge.results());
    let beside = edge.results().contacts_beside(edge.index());
    beside.into_iter().map(|index| all[index]).collect()
}

/// Whether other contacts act on the body of the contact `edge` as well.
pub(super) fn is_shared(edge: &EdgeView<'_>) -> bool {
    edge.geometry.contact && contacts_beside(edge).len() > 1
}

/// The share of the contact `edge` in the load of its body at the end of `step`, where it has one.
pub(super) fn share(edge: &EdgeView<'_>, step: usize) -> Option<LoadShare> {
    edge.results().load_share(edge.index(), step)
}

/// One table for each body on which several contacts act.
pub(super) fn tables(results: &Results) -> Vec<Table> {
    let mut tables = Vec::new();
    for edge in EdgeView::all(results) {
        let contacts = contacts_beside(&edge);
        let is_first = contacts.first().is_some_and(|first| edge.is_same(first));
        if is_first && contacts.len() > 1 {
            tables.push(table(&contacts));
        }
    }
    tables
}

/// Force and share of each of `contacts`, one row per load step.
fn table(contacts: &[EdgeView<'_>]) -> Table {
    let [first, ..] = contacts else {
        return Columns::new().table("Load sharing", 0..0);
    };
    let unit = first.units().force;
    let mut columns = Columns::new().with("step", "", |step: usize| (step + 1).to_string());
    for edge in contacts.iter().copied() {
        let name = &edge.geometry.name;
        columns = columns
            .with(format!("force '{name}'"), unit.name, move |step| {
                let [x, y] = edge.step(step).resultant;
                significant(unit.from_base(x.hypot(y)), 5)
            })
            .with(format!("share '{name}'"), "%", move |step| {
                share(&edge, step).map_or("balanced".into(), cell)
            });
    }
    let caption = format!("Load sharing on '{}'", first.body());
    columns.table(caption, 0..first.results().steps.len())
}

fn cell(share: LoadShare) -> String {
    let part = format!("{:.2}", 100.0 * share.part);
    match share.error {
        Some(error) => format!("{part} ± {}", significant(100.0 * error, 2)),
        None => part,
    }
}
