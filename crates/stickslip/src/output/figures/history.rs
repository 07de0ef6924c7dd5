//! How extents, peaks and friction follow the load.

use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, Legend, LineChart, Panels, Series, SeriesStyle};
use stickslip_report::color::Color;

use super::{Attempt, half_remark};
use crate::output::display::{
    EdgeView, decimals, load_label, load_text, load_values, peak_step, short, shown_load, unloading,
};
use crate::results::Results;

const LOADING: Color = Color::rgb(0x08, 0x51, 0x9c);
const UNLOADING: Color = Color::rgb(0xd9, 0x48, 0x01);

/// Contact and stick half-extents, and the peak pressure, over the load.
pub(super) fn extent_and_peak(view: &EdgeView<'_>) -> Attempt {
    let results = view.results();
    if !load_varies(results) || view.widest_contact().is_none() {
        return Ok(None);
    }
    let unit = view.place_unit();
    let half = if view.is_circle() { "Half-angle" } else { "Half-width" };
    let mut extents = chart("(a) contact and stick", results, format!("{half} [{unit}]"));
    let extent = |value: Option<f64>| value.map(|value| view.place(value));
    for series in branches(results, "contact", |step| extent(view.step(step).contact_half_extent)) {
        extents = extents.with(series.style(SeriesStyle::Both));
    }
    for mut series in branches(results, "stick", |step| extent(view.step(step).stick_half_extent)) {
        series.color = series.color.map(|color| color.tint(0.6));
        extents = extents.with(series.dash(Dash::Dotted).style(SeriesStyle::Both));
    }
    let over_bearing = view.geometry.bearing_area.is_some();
    let label = match over_bearing {
        true => "Largest pressure / bearing stress σ_b [–]".to_owned(),
        false => format!("Largest pressure [{}]", view.units().stress.name),
    };
    let mut peaks = chart("(b) largest pressure", results, label);
    let peak = |step: usize| {
        let (pressure, _) = view.step(step).peak_pressure?;
        if over_bearing { Some(pressure / view.bearing(step)?) } else { Some(view.stress(pressure)) }
    };
    for series in branches(results, "", peak) {
        peaks = peaks.with(series.style(SeriesStyle::Both));
    }
    let title = format!("Contact on '{}' through the load history", view.geometry.name);
    let charts = vec![extents, peaks].into_iter().map(|chart| chart.legend(Legend::Below).size(490.0, 0.8));
    let picture = Panels::new(title, 2, charts.collect()).render()?;
    Ok(Some((picture, caption(view))))
}

fn caption(view: &EdgeView<'_>) -> String {
    let results = view.results();
    let Some(step) = peak_step(results) else { return String::new() };
    let edge = view.step(step);
    let mut text = "Half-extent of contact and of the stick zone around its middle, and the largest pressure, over the load."
        .to_owned();
    if let Some(contact) = edge.contact_half_extent {
        text += &format!(" At {}: contact ±{}", load_text(results, step), view.extent(contact));
        if let Some(stick) = edge.stick_half_extent {
            text += &format!(", stick ±{}", view.extent(stick));
        }
        if let (Some((pressure, _)), Some(bearing)) = (edge.peak_pressure, view.bearing(step)) {
            text += &format!(", largest pressure {} σ_b", decimals(Some(pressure / bearing), 2));
        }
        text += ".";
    }
    if unloading(results).contains(&true) {
        text += " Where the branches of rising and falling load differ, friction keeps a memory of the history.";
    }
    text + half_remark(view)
}

/// ∫|τ| dA / ∫p dA over the load.
pub(super) fn friction(view: &EdgeView<'_>) -> Attempt {
    let results = view.results();
    let ratio = |step: usize| {
        let edge = view.step(step);
        (edge.normal_force > 0.0).then(|| edge.friction_force / edge.normal_force)
    };
    let ratios: Vec<(usize, f64)> =
        (0..results.steps.len()).filter_map(|step| ratio(step).map(|ratio| (step, ratio))).collect();
    let largest = ratios.iter().copied().max_by(|(_, a), (_, b)| a.total_cmp(b));
    let Some((step, largest)) = largest.filter(|(_, ratio)| *ratio > 0.0 && load_varies(results)) else {
        return Ok(None);
    };
    let mut chart = chart("", results, "∫|τ| dA / ∫p dA [–]".into()).size(620.0, 0.6);
    chart.title = format!("Mobilised friction on '{}'", view.geometry.name);
    chart.subtitle = Some(format!("Friction law: {}", view.geometry.law.replace('_', " ")));
    for series in branches(results, "", ratio) {
        chart = chart.with(series.style(SeriesStyle::Both));
    }
    let caption = format!(
        "Sum of the friction tractions' magnitudes over the sum of the pressures: where all slips under one coefficient μ it \
         is μ. It is largest, {}, at {}.",
        short(largest),
        load_text(results, step)
    );
    Ok(Some((chart.render()?, caption)))
}

fn load_varies(results: &Results) -> bool {
    let values = load_values(results);
    shown_load(results).is_some() && values.iter().any(|value| *value != values[0])
}

fn chart(title: &str, results: &Results, label: String) -> LineChart {
    LineChart::new(title, Axis::linear(load_label(results)), Axis::linear(label))
}

/// A quantity over the load, one series for rising and one for falling load. A branch starts where the one before it ended.
fn branches(results: &Results, name: &str, value: impl Fn(usize) -> Option<f64>) -> Vec<Series> {
    let loads = load_values(results);
    let falls = unloading(results);
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
        series.push(Series::new(label("falling load"), falling).color(UNLOADING).dash(Dash::Dashed));
    }
    series
}
