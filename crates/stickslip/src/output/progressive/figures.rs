//! The load–displacement curve.

use stickslip_report::axis::Axis;
use stickslip_report::chart::{Legend, LineChart, Series, SeriesStyle};

use super::{ProgressiveView, tables};
use crate::output::display::significant;
use crate::output::figures::Attempt;

/// The curve from rest, with first failures and peak marked.
pub(crate) fn curve(view: &ProgressiveView<'_>) -> Attempt {
    let own = view.progressive;
    let place =
        |displacement: f64, load: f64| [view.failure.length(displacement), view.force(load)];
    let mut points = vec![[0.0, 0.0]];
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
    let mut mark = |name: String, point: [f64; 2]| {
        let series = Series::new(name, vec![point]).style(SeriesStyle::Markers);
        chart.series.push(series);
    };
    let text = |load: f64| format!("{} {}", significant(view.force(load), 4), view.force_unit());
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
    let caption = tables::verdict(view).into_iter().next().unwrap_or_default();
    Ok(Some((chart.render()?, caption)))
}
