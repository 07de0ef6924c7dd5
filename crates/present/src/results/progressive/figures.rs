//! The load–displacement curve.

use stickslip_report::axis::{Axis, ends};
use stickslip_report::chart::{Dash, Legend, LineChart, Panels, Series, SeriesStyle};
use stickslip_report::color::Color;

use super::{ProgressiveView, tables};
use crate::results::attempt::Attempt;
use stickslip_results::{EdgeStrain, ProgressiveFailure};

/// Colour of what is there for comparison.
const MUTED: Color = Color::rgb(0x80, 0x80, 0x80);

/// The curve from rest, with first failures and peak marked.
pub(crate) fn curve(view: &ProgressiveView<'_>) -> Attempt {
    let own = view.progressive;
    let place =
        |displacement: f64, load: f64| [view.failure.length(displacement), view.force(load)];
    let mut points = vec![place(-own.free_travel, 0.0)];
    points.extend((own.curve.iter()).map(|point| place(point.displacement, point.load)));
    let x = Axis::linear(format!(
        "Displacement of the pin against the far end [{}]",
        view.length_unit()
    ));
    let y = Axis::linear(format!("Load [{}]", view.force_unit()));
    let title = format!("Load and displacement of '{}'", view.failure.body());
    let mut chart = LineChart::new(title, x, y)
        .subtitle(format!("{} · {}", view.failure.failure.layup, own.model))
        .legend(Legend::Right)
        .size(760.0, 0.6)
        .with(Series::new("joint", points));
    if let Some(linear) = &own.linear {
        let points = linear.curve.iter().map(|&[u, load]| place(u, load));
        let series = Series::new("no ply fails", points.collect());
        chart = chart.with(series.color(MUTED).dash(Dash::Dashed));
    }
    let mut mark = |name: String, point: [f64; 2]| {
        let series = Series::new(name, vec![point]).style(SeriesStyle::Markers);
        chart.series.push(series);
    };
    let text = |load: f64| view.load_text(load);
    if let Some(first) = own.first() {
        let name = format!("first ply, {}", text(first.load));
        mark(name, place(first.displacement, first.load));
    }
    if let Some(fibre) = own.first_fibre() {
        let name = format!("first fibres, {}", text(fibre.load));
        mark(name, place(fibre.displacement, fibre.load));
    }
    if let Some(peak) = own.curve.get(own.peak) {
        let name = format!("peak, {}", text(peak.load));
        mark(name, place(peak.displacement, peak.load));
    }
    let mut caption = vec![tables::strength(view)];
    caption.extend(tables::free_travel(view));
    Ok(Some((chart.render()?, caption.join(" "))))
}

/// Radial and circumferential strains at the hole's edge under the largest load, beside the linear ones.
pub(crate) fn edge_strains(view: &ProgressiveView<'_>) -> Attempt {
    let own = view.progressive;
    if own.edge.is_empty() {
        return Ok(None);
    }
    let chart = |component: usize, name: &str| {
        let line = |of: &dyn Fn(&EdgeStrain) -> f64| {
            let points = own.edge.iter();
            let mut points: Vec<[f64; 2]> = points
                .map(|edge| [own.frame.angle(edge.angle).to_degrees(), 100.0 * of(edge)])
                .collect();
            points.sort_by(|a, b| a[0].total_cmp(&b[0]));
            points
        };
        let linear = Series::new("no ply fails", line(&|edge| edge.linear[component]));
        let [low, high] = shown(own, component).map(|strain| 100.0 * strain);
        let x = Axis::linear("Angle φ from the bearing point [deg]").every(30.0);
        LineChart::new(
            name,
            x,
            Axis::linear(format!("{name} [%]")).between(low, high),
        )
        .size(480.0, 0.75)
        .with(Series::new("joint", line(&|edge| edge.followed[component])))
        .with(linear.color(MUTED).dash(Dash::Dashed))
    };
    let load = view.load_text(own.peak_load());
    let title = format!(
        "Strains at the hole of '{}' under {load}",
        view.failure.body()
    );
    let charts = vec![
        chart(0, "Radial strain"),
        chart(1, "Circumferential strain"),
    ];
    let picture = Panels::new(title, 2, charts).common_legend().render()?;
    let mut caption = tables::departures(own);
    if (0..2).any(|component| leaves(own, component)) {
        caption += " Strains beyond the frame are those of cells that a crack has opened.";
    }
    Ok(Some((picture, caption)))
}

/// The range to show: all strains, as far as they lie within twice the range of the linear ones. A cell that is cracked through has
/// strains that hide all others.
fn shown(own: &ProgressiveFailure, component: usize) -> [f64; 2] {
    let [low, high] = ends(own.edge.iter().map(|edge| edge.linear[component]));
    let room = 0.5 * (high - low);
    let [least, most] = ends(own.edge.iter().map(|edge| edge.followed[component]));
    let margin = 0.1 * room;
    [
        (least - margin).clamp(low - room, low - margin),
        (most + margin).clamp(high + margin, high + room),
    ]
}

fn leaves(own: &ProgressiveFailure, component: usize) -> bool {
    let [low, high] = shown(own, component);
    let strains = own.edge.iter().map(|edge| edge.followed[component]);
    strains
        .into_iter()
        .any(|strain| strain < low || strain > high)
}
