//! Stresses along an edge at the largest load, with the zones of contact.

use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, LineChart, Series};

use super::{Attempt, half_remark, zone_bands};
use crate::output::display::{EdgeView, decimals, short, significant};
use crate::output::loads::LoadScale;
use crate::output::zones::closing_angle;
use crate::results::EdgeRow;

/// Part of a contact line that is shown, in half-widths of the widest contact.
const CONTACT_WIDTHS: f64 = 2.5;
/// Intervals between ticks over the width of a page.
pub(in crate::output) const TICK_INTERVALS: f64 = 13.0;
/// Rounding of an angle, in tick spacings.
const ROUNDING: f64 = 1e-6;

/// σ_r, σ_θ and τ_rθ over θ (on a line: σ_yy, σ_xx and τ_xy over x) in the step of the largest load.
pub(super) fn chart(view: &EdgeView<'_>) -> Attempt {
    let Some(step) = LoadScale::of(view.results()).peak_step() else {
        return Ok(None);
    };
    let bearing = view.bearing(step).filter(|_| view.geometry.contact);
    let unit = view.units().stress.name;
    let label = match bearing {
        Some(_) => "Stress / bearing stress σ_b [–]".to_owned(),
        None => format!("Stress [{unit}]"),
    };
    let scale =
        |stress: f64| bearing.map_or_else(|| view.stress(stress), |bearing| stress / bearing);
    let title = format!(
        "Stresses of '{}' along '{}'",
        view.geometry.body, view.geometry.name
    );
    let mut chart = LineChart::new(
        title,
        place_axis(view, contact_window(view), TICK_INTERVALS),
        Axis::linear(label),
    )
    .subtitle(subtitle(view, step))
    .size(760.0, 0.55);
    let [normal, tangential, shear] = view.stress_symbols();
    let curve = |value: fn(&EdgeRow) -> f64| curve(view, step, |row| scale(value(row)));
    let hoop = Series::new(tangential, curve(|row| row.sigma_tangential));
    if view.is_circle() && !view.geometry.contact {
        chart = chart.with(hoop);
    } else {
        let [pressure, friction] = contact_names(view);
        chart = chart
            .with(Series::new(
                format!("{normal}{pressure}"),
                curve(|row| row.sigma_normal),
            ))
            .with(hoop.dash(Dash::DashDotted))
            .with(
                Series::new(format!("{shear}{friction}"), curve(|row| row.tau)).dash(Dash::Dashed),
            );
    }
    chart.bands = zone_bands(view, step);
    Ok(Some((chart.render()?, caption(view, step))))
}

/// The contact quantities that the normal and the shear stress are; nothing on an edge without contact.
fn contact_names(view: &EdgeView<'_>) -> [&'static str; 2] {
    match (view.geometry.contact, view.is_circle()) {
        (false, _) => ["", ""],
        (true, true) => [" = −CPRESS", " = −CSHEAR1"],
        // e_t is −e_x there, which turns the sign of the shear.
        (true, false) => [" = −CPRESS", " = CSHEAR1"],
    }
}

fn subtitle(view: &EdgeView<'_>, step: usize) -> String {
    let mut parts = vec![format!(
        "At {}",
        LoadScale::of(view.results()).step_text(step)
    )];
    if let Some(bearing) = view.bearing(step) {
        let value = significant(view.stress(bearing), 4);
        parts.push(format!(
            "bearing stress σ_b = {value} {}",
            view.units().stress.name
        ));
    }
    if view.geometry.contact {
        parts.push(format!(
            "friction law: {}",
            view.geometry.law.replace('_', " ")
        ));
    }
    parts.join(" · ")
}

fn caption(view: &EdgeView<'_>, step: usize) -> String {
    let edge = view.step(step);
    let unit = view.units().stress.name;
    let value = |stress: f64| {
        let absolute = format!("{} {unit}", significant(view.stress(stress), 4));
        match view.bearing(step) {
            Some(bearing) => format!("{absolute} ({} σ_b)", decimals(Some(stress / bearing), 2)),
            None => absolute,
        }
    };
    let mut sentences = vec![format!(
        "Stresses at {}.",
        LoadScale::of(view.results()).step_text(step)
    )];
    if let Some(extent) = edge.contact_half_extent {
        let stick = view
            .step(step)
            .stick_half_extent
            .filter(|stick| *stick > 0.0);
        let stick = stick.map_or("no zone around its middle sticks".to_owned(), |stick| {
            format!("it sticks within ±{}", view.extent(stick))
        });
        sentences.push(format!(
            "Contact reaches to ±{}; {stick}.",
            view.extent(extent)
        ));
    }
    if let Some((pressure, place)) = edge.peak_pressure.filter(|_| view.geometry.contact) {
        let place = view.at(place);
        sentences.push(format!(
            "The largest pressure is {} at {place}.",
            value(pressure)
        ));
    }
    if let Some((hoop, place)) = edge.peak_hoop {
        let symbol = view.stress_symbols()[1];
        sentences.push(format!(
            "The largest {symbol} is {} at {}.",
            value(hoop),
            view.at(place)
        ));
        if let Some(margin) = edge.peak_hoop_uncertainty {
            sentences.push(format!(
                "It sits in a cusp at the end of contact, where values converge like the root of the node spacing: uncertain by {}.",
                value(margin)
            ));
        }
    }
    if let Some(ratio) = view.friction_ratio(step) {
        let ratio = short(ratio);
        sentences.push(format!(
            "Friction over pressure, {}, is {ratio}.",
            view.friction_symbol()
        ));
    }
    sentences.extend(half_remark(view));
    sentences.join(" ")
}

/// The place axis with ticks where a reader of angles expects them, in at most `intervals`; `window` is the part to show
/// `[rad or mm]`.
pub(in crate::output) fn place_axis(
    view: &EdgeView<'_>,
    window: Option<[f64; 2]>,
    intervals: f64,
) -> Axis {
    let unit = view.place_unit();
    let name = if view.is_circle() {
        "Angle θ from the bearing point"
    } else {
        "Place x along the edge"
    };
    let axis = Axis::linear(format!("{name} [{unit}]"));
    let parameter = &view.geometry.parameter;
    let whole = parameter
        .first()
        .zip(parameter.last())
        .map(|(first, last)| [*first, *last]);
    let Some([low, high]) = window.or(whole).map(|ends| ends.map(|end| view.place(end))) else {
        return axis;
    };
    if low >= high {
        return axis;
    }
    if !view.is_circle() {
        return axis.between(low, high);
    }
    let spacing = [5.0, 10.0, 15.0, 30.0, 45.0]
        .into_iter()
        .find(|spacing| (high - low) / spacing <= intervals);
    let spacing = spacing.unwrap_or(60.0);
    // Ends that are no node, such as +180° of a closed edge, still close the axis.
    let (first, last) = (
        (low / spacing + ROUNDING).floor(),
        (high / spacing - ROUNDING).ceil(),
    );
    axis.between(first * spacing, last * spacing).every(spacing)
}

/// The neighbourhood of the contact on a line, where the edge is much longer.
fn contact_window(view: &EdgeView<'_>) -> Option<[f64; 2]> {
    let reach = CONTACT_WIDTHS * view.widest_contact().filter(|_| !view.is_circle())?;
    around_contact(view, reach)
}

/// The part of the edge within `reach` of the bearing point `[rad or mm]`.
pub(super) fn around_contact(view: &EdgeView<'_>, reach: f64) -> Option<[f64; 2]> {
    let (first, last) = view
        .geometry
        .parameter
        .first()
        .zip(view.geometry.parameter.last())?;
    (reach > 0.0).then(|| [first.max(-reach), last.min(reach)])
}

/// A quantity along the edge, closed at +180° where the edge is a closed circle.
pub(super) fn curve(
    view: &EdgeView<'_>,
    step: usize,
    value: impl Fn(&EdgeRow) -> f64,
) -> Vec<[f64; 2]> {
    let rows = &view.step(step).rows;
    let mut points: Vec<[f64; 2]> = (view.geometry.parameter.iter().zip(rows))
        .map(|(parameter, row)| [view.place(*parameter), value(row)])
        .collect();
    if let (Some(end), Some(&[_, start])) = (closing_angle(view), points.first()) {
        points.push([end, start]);
    }
    points
}
