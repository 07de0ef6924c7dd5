//! The answer for the terminal and the page.

use stickslip_report::table::{Column, Table};

use super::{ProgressiveView, mode_name};
use crate::output::display::{decimals, significant};
use crate::results::{PlyLoss, ProgressiveEnd};

/// First failure, first broken fibres, peak and end of the curve.
pub(crate) fn milestones(view: &ProgressiveView<'_>) -> Table {
    let (force, length) = (view.force_unit(), view.length_unit());
    let columns = vec![
        Column::new("progressive failure", ""),
        Column::new("load", force),
        Column::new("displacement", length),
        Column::new("ply", ""),
        Column::new("mode", ""),
        Column::new("θ", "deg"),
        Column::new("r", length),
    ];
    let own = view.progressive;
    let caption = format!(
        "Progressive failure of '{}', lay-up {}: {}; {}",
        view.failure.body(),
        view.failure.failure.layup,
        own.model,
        own.control
    );
    let mut table = Table::new(caption, columns);
    let first = own.first();
    if let Some(first) = first {
        let name = if first.mode.is_some() {
            "first ply failure"
        } else {
            "first ply flows"
        };
        table.push(loss_row(view, name, first));
    }
    if let Some(fibre) = own.first_fibre().filter(|fibre| Some(*fibre) != first) {
        table.push(loss_row(view, "first fibre failure", fibre));
    }
    let mut point = |name: &str, index: usize| {
        if let Some(point) = own.curve.get(index) {
            table.push([
                name.to_owned(),
                significant(view.force(point.load), 4),
                significant(view.failure.length(point.displacement), 4),
            ]);
        }
    };
    let peak = if own.strength.is_some() {
        "peak load = strength"
    } else {
        "largest load followed"
    };
    point(peak, own.peak);
    point("end of the history", own.curve.len().saturating_sub(1));
    table
}

fn loss_row(view: &ProgressiveView<'_>, name: &str, loss: &PlyLoss) -> Vec<String> {
    let mut cells = vec![
        name.to_owned(),
        significant(view.force(loss.load), 4),
        significant(view.failure.length(loss.displacement), 4),
        view.failure.failure.ply_name(loss.ply),
        mode_name(loss),
    ];
    if let Some([angle, radius]) = view.polar(loss.position) {
        cells.extend([decimals(Some(angle), 1), significant(radius, 3)]);
    }
    cells
}

/// The strength, the mode with its reasons, and how the history ended: one sentence each.
pub(crate) fn verdict(view: &ProgressiveView<'_>) -> Vec<String> {
    let own = view.progressive;
    let body = view.failure.body();
    let peak = format!(
        "{} {}",
        significant(view.force(own.peak_load()), 4),
        view.force_unit()
    );
    let mut sentences = vec![match (&own.mode, own.strength) {
        (Some(call), Some(_)) => format!("'{body}' fails by {} at {peak}.", call.mode),
        (Some(call), None) => format!(
            "'{body}' bears {peak}, and may bear more; its damage so far is that of {}.",
            call.mode
        ),
        (None, Some(_)) => format!("'{body}' bears no more than {peak}; no ply has failed."),
        (None, None) => format!("'{body}' bears {peak}; no ply has failed."),
    }];
    if let Some(call) = &own.mode {
        let reasons = call.reasons.iter();
        sentences.extend(reasons.map(|reason| format!("– {reason}")));
    }
    sentences.push(match &own.end {
        ProgressiveEnd::Completed => {
            "The history was followed to the end that the scene gives.".to_owned()
        }
        ProgressiveEnd::Dropped => {
            "The history ends because the load has fallen as far as the scene asks.".to_owned()
        }
        ProgressiveEnd::NoEquilibrium(cause) => {
            format!("The history ends where no equilibrium near was found: {cause}.")
        }
    });
    if own.half {
        sentences.push(
            "One half was followed; in the other, plies of opposite angle fail alike.".to_owned(),
        );
    }
    sentences
}
