//! The contact map: for every load step, which part of the edge is open, sticks, or slips which way.

use stickslip_contact::Status;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{Legend, LineChart, ReferenceLine, Series};
use stickslip_report::color::Color;

use super::edge::{TICK_INTERVALS, all_contact, around_contact, place_axis};
use super::{zone_color, zone_name};
use crate::results::attempt::Attempt;
use crate::results::display::EdgeView;
use crate::results::zones::{shown_ranges, zone_ranges};
use stickslip_text::significant;

/// Width of the figure `[px]`.
const WIDTH: f64 = 760.0;
/// About the width inside the frame `[px]`.
const INSIDE: f64 = 640.0;
/// Part of a step's width that its bar takes.
const BAR: f64 = 0.86;
/// Part of the edge that is shown, in extents of all contact.
const REACH: f64 = 1.2;
/// Steps up to which every bar's load stands above it.
const NAMED_STEPS: usize = 16;

/// Zones (vertical) over the load steps (horizontal).
pub(super) fn chart(view: &EdgeView<'_>) -> Attempt {
    let count = view.results().steps.len();
    if count < 2 || all_contact(view).is_none() {
        return Ok(None);
    }
    let x = Axis::linear("Load step [–]").between(0.5, count as f64 + 0.5);
    let x = if count <= NAMED_STEPS {
        x.every(1.0)
    } else {
        x
    };
    let y = place_axis(view, around_contact(view, REACH), TICK_INTERVALS);
    let title = format!("Open, stick and slip on '{}'", view.geometry.name);
    let load = view.load();
    let subtitle = format!("{} above each bar", load.label());
    let mut chart = LineChart::new(title, x, y)
        .legend(Legend::Below)
        .size(WIDTH, 0.55);
    if count <= NAMED_STEPS {
        chart = chart.subtitle(subtitle);
        let quiet = Color::rgb(0x88, 0x88, 0x88);
        for (step, value) in load.values.into_iter().enumerate() {
            let load = significant(value, 4);
            chart = chart.reference(ReferenceLine::vertical(load, (step + 1) as f64).color(quiet));
        }
    }
    let bar = BAR * INSIDE / count as f64;
    for status in STATUSES {
        // A name without points, since a bar's own sample would fill the legend.
        let name = Series::new(legend_name(view, status), Vec::new())
            .color(fill(status))
            .width(9.0);
        chart = chart.with(name).with(bars(view, status, bar));
    }
    Ok(Some((chart.render()?, caption(view))))
}

const STATUSES: [Status; 4] = [
    Status::Open,
    Status::Stick,
    Status::SlipPositive,
    Status::SlipNegative,
];

fn legend_name(view: &EdgeView<'_>, status: Status) -> String {
    let name = zone_name(view, status);
    match (status, from_bearing(view)) {
        (Status::Open | Status::Stick, _) => name.into(),
        (Status::SlipPositive, true) => format!("{name} (q > 0)"),
        (Status::SlipNegative, true) => format!("{name} (q < 0)"),
        (Status::SlipPositive, false) => format!("{name} (CSHEAR1 < 0)"),
        (Status::SlipNegative, false) => format!("{name} (CSHEAR1 > 0)"),
    }
}

/// Whether the direction of slip is reported relative to a bearing point.
fn from_bearing(view: &EdgeView<'_>) -> bool {
    view.is_circle() && view.geometry.frame.bearing.is_some()
}

/// The fill of a zone: its colour, light where there is no contact.
fn fill(status: Status) -> Color {
    zone_color(status).tint(if status == Status::Open { 0.3 } else { 0.75 })
}

/// All zones of one status as thick vertical strokes.
fn bars(view: &EdgeView<'_>, status: Status, width: f64) -> Series {
    let mut points = Vec::new();
    for step in 0..view.results().steps.len() {
        let x = (step + 1) as f64;
        for (_, [start, end]) in shown_ranges(view, step)
            .into_iter()
            .filter(|zone| zone.0 == status)
        {
            points.extend([[x, start], [x, end], [x, f64::NAN]]);
        }
    }
    Series::new("", points).color(fill(status)).width(width)
}

fn caption(view: &EdgeView<'_>) -> String {
    let count = view.results().steps.len();
    let directions = if from_bearing(view) {
        "Slip away means that the first body's edge slips against the second away from the bearing point of the step, slip towards that \
         it slips towards it."
    } else {
        "Slip + means that the first body slips along +e_t against the second, slip − along −e_t."
    };
    let mut sentences = vec![format!(
        "Status of the contact points at the end of each load step, {} upwards. {directions}",
        view.place_symbol()
    )];
    let whole_sticks = |step: &usize| {
        let zones = &view.step(*step).zones;
        let slips = zones.iter().any(|zone| zone.status.slip_sign() != 0.0);
        zones.iter().any(|zone| zone.status.touches()) && !slips
    };
    if let Some(step) = (0..count).find(whole_sticks) {
        sentences.push(format!("In step {} the whole contact sticks.", step + 1));
    }
    let both_ways = |step: &usize| {
        let zones = zone_ranges(view, *step);
        // The two sides of a line mirror each other, so one side suffices.
        let has = |sign: f64| {
            let own = zones.iter().filter(|zone| zone.0.slip_sign() == sign);
            own.into_iter()
                .any(|(_, [_, end])| from_bearing(view) || *end > 0.0)
        };
        has(1.0) && has(-1.0)
    };
    let reversing = (0..count).filter(both_ways).count();
    if reversing > 0 {
        sentences.push(format!(
            "In {reversing} of {count} steps the contact slips both ways on one side of its middle."
        ));
    }
    sentences.join(" ")
}
