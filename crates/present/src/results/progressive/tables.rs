//! The answer for the terminal and the page.

use stickslip_joint::{JointMode, ModeCall};
use stickslip_report::table::Table;

use super::reasons::reasons;
use super::{ProgressiveView, mode_name};
use stickslip_results::{PlyLoss, ProgressiveEnd, ProgressiveFailure};
use stickslip_text::{decimals, significant};

/// First failure, first broken fibres, peak and end of the curve.
pub(crate) fn milestones(view: &ProgressiveView<'_>) -> Table {
    let (force, length) = (view.force_unit(), view.length_unit());
    let headings = format!(
        "progressive failure | load [{force}] | displacement [{length}] | ply | mode | φ [deg] | r [{length}]"
    );
    let own = view.progressive;
    let caption = format!(
        "Progressive failure of '{}', lay-up {}: {}; {}",
        view.failure.body(),
        view.failure.failure.layup,
        own.model,
        own.control
    );
    let mut table = Table::headed(caption, &headings);
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

/// What the joint bears, in a few words.
pub(crate) fn headline(view: &ProgressiveView<'_>) -> (String, String) {
    let own = view.progressive;
    let load = view.load_text(own.peak_load());
    let mode = (own.mode.as_ref()).map_or(String::new(), |call| {
        format!(", {}{}", call.mode, near(call))
    });
    if own.strength.is_some() {
        ("Strength and mode".to_owned(), load + &mode)
    } else {
        ("Largest load followed".to_owned(), load)
    }
}

/// The modes to which a call is near.
fn near(call: &ModeCall) -> String {
    if call.others.is_empty() {
        return String::new();
    }
    let others: Vec<&str> = call.others.iter().map(|mode| mode.name()).collect();
    format!(", near to {}", others.join(" or "))
}

/// The strength, the mode with its reasons, and how the history ended: one sentence each.
pub(crate) fn verdict(view: &ProgressiveView<'_>) -> Vec<String> {
    let own = view.progressive;
    let mut sentences = vec![strength(view)];
    let reasons = own.mode.iter().flat_map(reasons);
    sentences.extend(reasons.map(|reason| format!("– {reason}")));
    if !own.edge.is_empty() {
        sentences.push(departures(own));
    }
    sentences.extend(free_travel(view));
    sentences.push(match &own.end {
        ProgressiveEnd::Completed => {
            "The history was followed to the end that the scene gives.".to_owned()
        }
        ProgressiveEnd::Dropped => {
            "The history ends because the load has fallen as far as the scene asks.".to_owned()
        }
        ProgressiveEnd::Severed => {
            "The history ends because the joint is severed: what it still bears is borne by what failed plies are left with.".to_owned()
        }
        ProgressiveEnd::NoEquilibrium(cause) => {
            format!("The history ends where no equilibrium near was found: {cause}.")
        }
    });
    sentences.extend(view.notes());
    let remarks = include_str!("remarks.txt").lines().map(str::to_owned);
    sentences.extend(remarks.take(if own.half { 2 } else { 1 }));
    sentences
}

/// What the joint bears, and how it fails.
pub(super) fn strength(view: &ProgressiveView<'_>) -> String {
    let own = view.progressive;
    let body = view.failure.body();
    let peak = view.load_text(own.peak_load());
    match (&own.mode, own.strength) {
        (Some(call), Some(_)) if call.mode == JointMode::Mixed => {
            format!("'{body}' fails in a mixed mode at {peak}{}.", near(call))
        }
        (Some(call), Some(_)) => {
            format!("'{body}' fails by {} at {peak}{}.", call.mode, near(call))
        }
        (Some(call), None) => format!(
            "'{body}' bears {peak}, and may bear more; its damage so far is that of {}{}.",
            match call.mode {
                JointMode::Mixed => "a mixed mode",
                pure => pure.name(),
            },
            near(call)
        ),
        (None, Some(_)) => format!("'{body}' bears no more than {peak}; no ply has failed."),
        (None, None) if own.losses.is_empty() => {
            format!("'{body}' bears {peak}; no ply has failed.")
        }
        (None, None) => format!("'{body}' bears {peak}; plies flow, and none fails."),
    }
}

/// From where displacements count, where the pin does not start there.
pub(super) fn free_travel(view: &ProgressiveView<'_>) -> Option<String> {
    let own = view.progressive;
    (own.free_travel > 0.0).then(|| {
        format!(
            "Displacements count from where the pin can bear at θ = {}°: the {} {} that it moves before, from where it starts, are left out.",
            decimals(Some(own.frame.bearing.unwrap_or_default().to_degrees()), 0),
            significant(view.failure.length(own.free_travel), 3),
            view.length_unit()
        )
    })
}

/// Part of the largest linear strain by which strains at the edge differ where they are said to.
pub(super) const DEPARTURE: f64 = 0.1;

/// Where the strains at the hole's edge are not those of the linear joint.
pub(super) fn departures(own: &ProgressiveFailure) -> String {
    let ranges = own.departures(DEPARTURE);
    let listed: Vec<String> = (ranges.iter())
        .map(|range| {
            let [from, to] = range.map(|angle| decimals(Some(angle.to_degrees()), 0));
            if from == to {
                format!("{from}°")
            } else if range[0] < 0.0 {
                format!("{from}° to {to}°")
            } else {
                format!("{from}–{to}°")
            }
        })
        .collect();
    if listed.is_empty() {
        return "Under the largest load no strain at the hole's edge differs from the linear one by a tenth of the largest.".to_owned();
    }
    format!(
        "Under the largest load the strains at the hole's edge leave the linear ones, by more than a tenth of the largest, {} from the bearing point.",
        listed.join(", ")
    )
}
