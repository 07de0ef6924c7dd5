//! Stresses along an edge at the largest load, with the zones of contact.

use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, LineChart, Series};

use super::{half_remark, margin_remark, zone_bands};
use crate::results::attempt::Attempt;
use crate::results::display::{EdgeView, even};
use crate::results::zones::{contact_ranges, contact_reach, is_closed, modelled, stick_ranges};
use stickslip_results::{EdgeRow, RowErrors};
use stickslip_text::{decimals, short, significant};

/// Part of a contact line that is shown, in widths of all contact.
const CONTACT_WIDTHS: f64 = 2.5;
/// Intervals between ticks over the width of a page.
pub(crate) const TICK_INTERVALS: f64 = 13.0;
/// Rounding of an angle, in tick spacings.
const ROUNDING: f64 = 1e-6;

/// σ_r, σ_θ and τ_rθ over θ (on a line: σ_yy, σ_xx and τ_xy over x) in the step of the largest load.
pub(super) fn chart(view: &EdgeView<'_>) -> Attempt {
    let Some(step) = view.load().peak_step() else {
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
        view.body(),
        view.geometry.name
    );
    let mut chart = LineChart::new(
        title,
        place_axis(view, contact_window(view), TICK_INTERVALS),
        Axis::linear(label),
    )
    .subtitle(subtitle(view, step))
    .size(760.0, 0.55);
    let [normal, tangential, shear] = view.stress_symbols();
    let curve = |name: String, value: fn(&EdgeRow) -> f64, error: fn(&RowErrors) -> f64| {
        let points = curve(view, step, |row| scale(value(row)));
        let margin = margin(view, step, &points, |errors| scale(error(errors)));
        Series::new(name, points).margin(margin)
    };
    let hoop = curve(
        tangential.to_owned(),
        |row| row.sigma_tangential,
        |errors| errors.sigma_tangential,
    );
    if view.is_circle() && !view.geometry.contact {
        chart = chart.with(hoop);
    } else {
        let [pressure, friction] = contact_names(view);
        chart = chart
            .with(curve(
                format!("{normal}{pressure}"),
                |row| row.sigma_normal,
                |errors| errors.pressure,
            ))
            .with(hoop.dash(Dash::DashDotted))
            .with(
                curve(
                    format!("{shear}{friction}"),
                    |row| row.tau,
                    |errors| errors.shear,
                )
                .dash(Dash::Dashed),
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
    let mut parts = vec![format!("At {}", view.load().step_text(step))];
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
    let mut sentences = vec![format!("Stresses at {}.", view.load().step_text(step))];
    sentences.extend(contact_sentences(view, step));
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
        let margin = edge.peak_hoop_uncertainty;
        if let Some(margin) = margin.filter(|_| view.results().ladder.is_none()) {
            sentences.push(format!(
                "It sits in a cusp at the end of contact, where values converge like the root of the node spacing; the next node has {} less, and the error may be larger.",
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
    sentences.extend(margin_remark(view));
    sentences.extend(half_remark(view));
    sentences.join(" ")
}

/// Where the contact bears, touches and sticks.
fn contact_sentences(view: &EdgeView<'_>, step: usize) -> Vec<String> {
    let mut sentences = Vec::new();
    let Some(reach) = contact_reach(view, step) else {
        return sentences;
    };
    if let Some(bearing) = view.geometry.frame.bearing.filter(|_| view.is_circle()) {
        sentences.push(format!(
            "The bearing point, φ = 0, lies at θ = {} from +x.",
            view.extent(bearing)
        ));
    }
    let stick = match view.ranges(&stick_ranges(view, step)) {
        Some(ranges) if ranges.starts_with('±') => format!("it sticks within {ranges}"),
        Some(ranges) if ranges.starts_with("all") => format!("it sticks {ranges}"),
        Some(ranges) => format!("it sticks at {ranges}"),
        None => "nothing sticks".to_owned(),
    };
    let parts = contact_ranges(view, step).len();
    let parts = if parts > 1 {
        format!(" in {parts} parts")
    } else {
        String::new()
    };
    sentences.push(if view.is_whole(reach) {
        format!("Contact is all around; {stick}.")
    } else if even(reach) {
        format!("Contact reaches to {}{parts}; {stick}.", view.range(reach))
    } else {
        format!(
            "Contact reaches over {}{parts}; {stick}.",
            view.range(reach)
        )
    });
    sentences
}

/// The place axis with ticks where a reader of angles expects them, in at most `intervals`; `window` is the part to show in display
/// units.
pub(crate) fn place_axis(view: &EdgeView<'_>, window: Option<[f64; 2]>, intervals: f64) -> Axis {
    let axis = Axis::linear(format!("{} [{}]", view.place_name(), view.place_unit()));
    let Some([low, high]) = window.or_else(|| modelled(view)) else {
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
    around_contact(view, CONTACT_WIDTHS).filter(|_| !view.is_circle())
}

/// What the contact reaches over in any step, in display units; of a half on its modelled side.
pub(super) fn all_contact(view: &EdgeView<'_>) -> Option<[f64; 2]> {
    let reaches = (0..view.results().steps.len()).filter_map(|step| contact_reach(view, step));
    let all = reaches.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])?;
    let whole = view.is_circle() && (all[0] < -180.0 || all[1] > 180.0);
    Some(if whole { [-180.0, 180.0] } else { all })
}

/// The part of the edge around all places that are in contact in any step, which take one part in `room` of it; in display units.
pub(super) fn around_contact(view: &EdgeView<'_>, room: f64) -> Option<[f64; 2]> {
    let [start, end] = all_contact(view)?;
    let [first, last] = modelled(view)?;
    let (middle, reach) = (0.5 * (start + end), 0.5 * room * (end - start));
    (reach > 0.0).then(|| [first.max(middle - reach), last.min(middle + reach)])
}

/// A quantity along the edge by ascending place, from −180° to 180° where the edge is a closed circle.
pub(super) fn curve(
    view: &EdgeView<'_>,
    step: usize,
    value: impl Fn(&EdgeRow) -> f64,
) -> Vec<[f64; 2]> {
    let rows = view.step(step).rows.iter().map(|row| {
        // Of a half that is read clockwise the other side is shown, whose shear and slip are opposite.
        if view.geometry.frame.clockwise {
            value(&EdgeRow {
                shear: -row.shear,
                slip: -row.slip,
                tau: -row.tau,
                ..*row
            })
        } else {
            value(row)
        }
    });
    let places = view.geometry.parameter.iter().map(|&at| view.place(at));
    along(places.zip(rows), is_closed(view))
}

/// The ends of the margins of `points`, those of [`curve`]; empty where no errors are known.
pub(super) fn margin(
    view: &EdgeView<'_>,
    step: usize,
    points: &[[f64; 2]],
    error: impl Fn(&RowErrors) -> f64,
) -> Vec<[f64; 2]> {
    let errors = view.step(step).row_errors.iter().map(error);
    let places = view.geometry.parameter.iter().map(|&at| view.place(at));
    let errors = along(places.zip(errors), is_closed(view));
    let ends = points.iter().zip(errors);
    ends.map(|([_, value], [_, error])| [value - error, value + error])
        .collect()
}

/// Points by ascending place `[degree]`, and where they are those of a closed circle continued to ±180°.
pub(crate) fn along(points: impl Iterator<Item = (f64, f64)>, closed: bool) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = points.map(|(place, value)| [place, value]).collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    if let (true, &[[low, first], .., [high, last]]) = (closed, &points[..]) {
        points.insert(0, [high - 360.0, last]);
        if low > -180.0 && high < 180.0 - ROUNDING {
            points.push([low + 360.0, first]);
        }
    }
    points
}
