//! How the contacts of a body share its load, such as the fasteners of a plate.
//!
//! ```text
//! share_k = F_k · e / Σ_j F_j · e,   e = Σ_j F_j / |Σ_j F_j|
//! ```
//!
//! F_k is the force of contact k on its first body; contacts in which that body is the second have no share.

use stickslip_engine::results::Results;
use stickslip_report::table::{Columns, Table};
use stickslip_text::significant;

use super::display::EdgeView;

/// Sum of contact forces, as a part of the largest sum of their magnitudes in the history, below which they balance each other and share nothing.
const BALANCED: f64 = 1e-6;

/// A part of a load, with its estimated error where contact forces have one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Share {
    pub(super) part: f64,
    pub(super) error: Option<f64>,
}

/// The contacts on the body of `edge`, as the first of which it stands, in their order.
fn contacts_beside<'a>(edge: &EdgeView<'a>) -> Vec<EdgeView<'a>> {
    let body = edge.geometry.body;
    let mut all = EdgeView::all(edge.results());
    all.retain(|own| own.geometry.contact && own.geometry.body == body);
    all
}

/// Whether other contacts act on the body of the contact `edge` as well.
pub(super) fn is_shared(edge: &EdgeView<'_>) -> bool {
    edge.geometry.contact && contacts_beside(edge).len() > 1
}

/// The share of the contact `edge` in the load of its body at the end of `step`; `None` for the only contact of a body, and where the
/// forces balance each other, to rounding or within their errors.
pub(super) fn share(edge: &EdgeView<'_>, step: usize) -> Option<Share> {
    if !is_shared(edge) {
        return None;
    }
    let all = contacts_beside(edge);
    let force = |own: &EdgeView<'_>| own.step(step).resultant;
    let sum = [0, 1].map(|axis| all.iter().map(|own| force(own)[axis]).sum::<f64>());
    let size = |[x, y]: [f64; 2]| x.hypot(y);
    let total = size(sum);
    let steps = 0..edge.results().steps.len();
    let each = |step: usize| {
        all.iter()
            .map(|own| size(own.step(step).resultant))
            .sum::<f64>()
    };
    if total <= BALANCED * steps.map(each).fold(0.0, f64::max) {
        return None;
    }
    let [x, y] = force(edge);
    let part = (x * sum[0] + y * sum[1]) / (total * total);
    let errors = all.iter().map(|own| own.step(step).resultant_error());
    let together = errors.sum::<Option<f64>>();
    if together.is_some_and(|together| total <= together) {
        return None;
    }
    let own = edge.step(step).resultant_error();
    let error = own
        .zip(together)
        .map(|(own, together)| (own + part.abs() * together) / total);
    Some(Share { part, error })
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

fn cell(share: Share) -> String {
    let part = format!("{:.2}", 100.0 * share.part);
    match share.error {
        Some(error) => format!("{part} ± {}", significant(100.0 * error, 2)),
        None => part,
    }
}
