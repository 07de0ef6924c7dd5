//! How extents, peaks and friction follow the load.

use stickslip_report::axis::{Axis, ends};
use stickslip_report::chart::{Dash, Legend, LineChart, Panels, Series, SeriesStyle};
use stickslip_report::color::Color;

use super::edge::all_contact;
use super::last_largest;
use crate::results::attempt::Attempt;
use crate::results::display::EdgeView;
use crate::results::tables::lies_evenly;
use crate::results::zones::{contact_ranges, contact_reach, stick_ranges};
use stickslip_text::{decimals, short};

/// Relative difference below which values count as equal.
const EQUAL: f64 = 1e-3;
const LOADING: Color = Color::rgb(0x08, 0x51, 0x9c);
const UNLOADING: Color = Color::rgb(0xd9, 0x48, 0x01);

/// Contact and stick half-extents, and the peak pressure, over the load.
pub(super) fn extent_and_peak(view: &EdgeView<'_>) -> Attempt {
    let results = view.results();
    if !load_varies(view) || all_contact(view).is_none() {
        return Ok(None);
    }
    let extents = extents(view);
    let over_bearing = view.bears();
    let label = if over_bearing {
        "Largest pressure / bearing stress σ_b [–]".to_owned()
    } else {
        format!("Largest pressure [{}]", view.units().stress.name)
    };
    let peak = |step: usize| {
        let (pressure, _) = view.step(step).peak_pressure?;
        if over_bearing {
            Some(pressure / view.bearing(step)?)
        } else {
            Some(view.stress(pressure))
        }
    };
    let mut peaks = chart("(b) largest pressure", view, label);
    peaks.y = steady((0..results.steps.len()).filter_map(peak), peaks.y);
    for series in branches(view, "", peak) {
        peaks = peaks.with(series.style(SeriesStyle::Both));
    }
    let title = format!(
        "Contact on '{}' through the load history",
        view.geometry.name
    );
    let charts = vec![extents, peaks]
        .into_iter()
        .map(|chart| chart.legend(Legend::Below).size(490.0, 0.8));
    let picture = Panels::new(title, 2, charts.collect()).render()?;
    Ok(Some((picture, caption(view))))
}

/// Contact and stick over the load: half-extents where they lie evenly about the bearing point, otherwise both ends.
fn extents(view: &EdgeView<'_>) -> LineChart {
    type Extent<'a> = Box<dyn Fn(usize) -> Option<f64> + 'a>;
    let unit = view.place_unit();
    let half = |value: Option<f64>| value.map(|value| view.length(value));
    let (label, contact, stick): (String, Vec<Extent<'_>>, Vec<Extent<'_>>) = if lies_evenly(view) {
        let name = if view.is_circle() {
            "Half-angle"
        } else {
            "Half-width"
        };
        (
            format!("{name} [{unit}]"),
            vec![Box::new(move |step| {
                half(view.step(step).contact_half_extent)
            })],
            vec![Box::new(move |step| {
                half(view.step(step).stick_half_extent)
            })],
        )
    } else {
        let end = |of: fn(&EdgeView<'_>, usize) -> Option<[f64; 2]>, k: usize| -> Extent<'_> {
            Box::new(move |step| of(view, step).map(|ends| ends[k]))
        };
        (
            format!("{} [{unit}]", view.place_name()),
            (0..2).map(|k| end(contact_reach, k)).collect(),
            (0..2).map(|k| end(stick_reach, k)).collect(),
        )
    };
    let mut chart = chart("(a) contact and stick", view, label);
    for (k, extent) in contact.iter().enumerate() {
        for series in named(branches(view, "contact", extent), k == 0) {
            chart = chart.with(series.style(SeriesStyle::Both));
        }
    }
    for (k, extent) in stick.iter().enumerate() {
        for mut series in named(branches(view, "stick", extent), k == 0) {
            series.color = series.color.map(|color| color.tint(0.6));
            chart = chart.with(series.dash(Dash::Dotted).style(SeriesStyle::Both));
        }
    }
    chart
}

/// First and last place that sticks, in display units.
fn stick_reach(view: &EdgeView<'_>, step: usize) -> Option<[f64; 2]> {
    let ranges = stick_ranges(view, step);
    Some([ranges.first()?[0], ranges.last()?[1]])
}

/// The series, without their names in the legend where others of the same name are there.
fn named(mut series: Vec<Series>, first: bool) -> Vec<Series> {
    if !first {
        for series in &mut series {
            series.label.clear();
        }
    }
    series
}

fn caption(view: &EdgeView<'_>) -> String {
    let load = view.load();
    let Some(step) = load.peak_step() else {
        return String::new();
    };
    let edge = view.step(step);
    let what = if lies_evenly(view) {
        "Half-extents of contact and of the stick zone around the bearing point"
    } else {
        "First and last place in contact and, dotted, of those that stick"
    };
    let mut sentences = vec![format!("{what}, and the largest pressure, over the load.")];
    if let Some(contact) = view.ranges(&contact_ranges(view, step)) {
        let mut parts = vec![format!("contact {contact}")];
        let stick = view.ranges(&stick_ranges(view, step));
        parts.extend(stick.map(|stick| format!("stick {stick}")));
        if let (Some((pressure, _)), Some(bearing)) = (edge.peak_pressure, view.bearing(step)) {
            parts.push(format!(
                "largest pressure {} σ_b",
                decimals(Some(pressure / bearing), 2)
            ));
        }
        sentences.push(format!("At {}: {}.", load.text(step), parts.join(", ")));
    }
    if load.unloading().contains(&true) {
        let memory =
            "Where the branches of rising and falling load differ, friction remembers the history.";
        sentences.push(memory.to_owned());
    }
    sentences.join(" ")
}

/// Friction over pressure, over the load.
pub(super) fn friction(view: &EdgeView<'_>) -> Attempt {
    let results = view.results();
    let ratios =
        (0..results.steps.len()).filter_map(|step| Some((step, view.friction_ratio(step)?)));
    let largest = last_largest(ratios, |(_, ratio)| ratio.abs());
    let Some((step, largest)) = largest.filter(|(_, ratio)| *ratio != 0.0 && load_varies(view))
    else {
        return Ok(None);
    };
    let name = if view.is_circle() {
        "Friction over pressure"
    } else {
        "Tangential over normal force"
    };
    let label = format!("{name} {} [–]", view.friction_symbol());
    let mut chart = chart("", view, label).size(620.0, 0.6);
    chart.title = format!("Mobilised friction on '{}'", view.geometry.name);
    chart.subtitle = Some(format!(
        "Friction law: {}",
        view.geometry.law.replace('_', " ")
    ));
    for series in branches(view, "", |step| view.friction_ratio(step)) {
        chart = chart.with(series.style(SeriesStyle::Both));
    }
    let meaning = if view.is_circle() {
        "q is positive where friction pulls the first body along the edge towards the bearing point of the step, negative where it pulls \
         away from it. Where all slips one way under one coefficient μ the ratio is ±μ."
            .to_owned()
    } else {
        format!(
            "Q is the tangential force on the first body along +{}, N the normal force; |Q/N| = μ means that all slips.",
            view.place_symbol()
        )
    };
    let caption = format!(
        "{name} through the load history. {meaning} The largest magnitude, {}, is at {}.",
        short(largest),
        view.load().step_text(step)
    );
    Ok(Some((chart.render()?, caption)))
}

fn load_varies(view: &EdgeView<'_>) -> bool {
    let load = view.load();
    load.is_load() && load.changes()
}

fn chart(title: &str, view: &EdgeView<'_>, label: String) -> LineChart {
    LineChart::new(
        title,
        Axis::linear(view.load().label()),
        Axis::linear(label),
    )
}

/// The axis from zero for values that are all but equal, whose differences would only be rounding blown up.
fn steady(values: impl Iterator<Item = f64>, axis: Axis) -> Axis {
    let [low, high] = ends(values);
    if high > 0.0 && high - low < EQUAL * high {
        axis.between(0.0, 1.2 * high)
    } else {
        axis
    }
}

/// A quantity over the load, one series for rising and one for falling load. A branch starts where the one before it ended.
fn branches(view: &EdgeView<'_>, name: &str, value: impl Fn(usize) -> Option<f64>) -> Vec<Series> {
    let load = view.load();
    let (loads, falls) = (&load.values, load.unloading());
    let point = |step: usize| [loads[step], value(step).unwrap_or(f64::NAN)];
    let mut runs = [Vec::new(), Vec::new()];
    for step in 0..loads.len() {
        let run = &mut runs[usize::from(falls[step])];
        if step > 0 && falls[step] != falls[step - 1] {
            run.push([f64::NAN; 2]);
            run.push(point(step - 1));
        }
        run.push(point(step));
    }
    let [rising, falling] = runs;
    let both = !falling.is_empty();
    let label = |branch: &str| match (name, both) {
        ("", true) => branch.to_owned(),
        (name, true) => format!("{name}, {branch}"),
        (name, false) => name.to_owned(),
    };
    let mut series = vec![Series::new(label("rising load"), rising).color(LOADING)];
    if both {
        series.push(
            Series::new(label("falling load"), falling)
                .color(UNLOADING)
                .dash(Dash::Dashed),
        );
    }
    series
}
