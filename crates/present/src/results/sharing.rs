//! Tables of how the contacts of a body share its load.

use stickslip_report::table::{Columns, Table};
use stickslip_results::{LoadShare, Results};
use stickslip_text::significant;

use super::display::EdgeView;

/// Whether the contact `edge` shares the load of a body with others.
pub(super) fn is_shared(edge: &EdgeView<'_>) -> bool {
    edge.results().shared_body(edge.index()).is_some()
}

/// The share of the contact `edge` in the load of that body at the end of `step`, where it has one.
pub(super) fn share(edge: &EdgeView<'_>, step: usize) -> Option<LoadShare> {
    edge.results().load_share(edge.index(), step)
}

/// One table for each body whose load several contacts share.
pub(super) fn tables(results: &Results) -> Vec<Table> {
    let bodies = (0..results.bodies.len()).filter(|&body| results.shares_load(body));
    bodies.map(|body| table(results, body)).collect()
}

/// Force and share of each contact of the body with the index `body`, one row per load step.
fn table(results: &Results, body: usize) -> Table {
    let unit = results.units.force;
    let mut columns = Columns::new().with("step", "", |step: usize| (step + 1).to_string());
    for index in results.contacts_of(body) {
        let name = &results.edges[index].name;
        columns = columns
            .with(format!("force '{name}'"), unit.name, move |step| {
                let [x, y] = results.force_on(body, index, step);
                significant(unit.from_base(x.hypot(y)), 5)
            })
            .with(format!("share '{name}'"), "%", move |step| {
                let share = results.share_of(body, index, step);
                share.map_or("balanced".into(), cell)
            });
    }
    let caption = format!("Load sharing on '{}'", results.bodies[body].name);
    columns.table(caption, 0..results.steps.len())
}

fn cell(share: LoadShare) -> String {
    let part = format!("{:.2}", 100.0 * share.part);
    match share.error {
        Some(error) => format!("{part} ± {}", significant(100.0 * error, 2)),
        None => part,
    }
}
