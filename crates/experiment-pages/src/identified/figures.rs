//! τ/p along the edge with slip zones and the coefficient that they share.

use stickslip_hybrid::identify::Bounds;
use stickslip_report::FigureError;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{Band, Dash, LineChart, Panels, ReferenceLine, Series, SeriesStyle};
use stickslip_report::color::Color;
use stickslip_report::svg::Svg;

use crate::analysed::figures::{TRUTH, angle_axis, truth_within};
use crate::gallery::caption;
use stickslip_experiment::Experiment;
use stickslip_measure::analysed::{Analysed, TruePlace};
use stickslip_measure::identified::{Identified, ratio};

const WIDTH: f64 = 760.0;
/// Ratios whose standard deviation is larger say nothing and would hide the others.
const VAGUE: f64 = 0.15;
/// Least half height of the axis.
const LEAST: f64 = 0.1;

/// One chart for each state.
pub(super) fn friction(
    experiment: &Experiment,
    analysed: &[Analysed],
    identified: &Identified,
    truth: &[Vec<TruePlace>],
) -> Result<Svg, FigureError> {
    let half = half_height(analysed, identified);
    let charts = analysed.iter().zip(truth);
    let charts = charts.map(|(found, truth)| chart(experiment, found, identified, truth, half));
    Panels::new("Shear over pressure", 1, charts.collect())
        .common_legend()
        .render()
}

/// Places in contact whose ratio is known well enough.
fn shown(found: &Analysed) -> Vec<usize> {
    let contact = found.contact().unwrap_or(0..0);
    contact.filter(|&k| ratio(found, k).1 < VAGUE).collect()
}

fn half_height(analysed: &[Analysed], identified: &Identified) -> f64 {
    let ratios = analysed
        .iter()
        .flat_map(|found| shown(found).into_iter().map(|k| ratio(found, k).0.abs()));
    let largest = ratios.fold(LEAST, f64::max);
    1.25 * identified
        .dynamic
        .as_ref()
        .map_or(largest, |fit| largest.max(fit.mu))
}

fn chart(
    experiment: &Experiment,
    found: &Analysed,
    identified: &Identified,
    truth: &[TruePlace],
    half: f64,
) -> LineChart {
    let places = shown(found);
    let angle = |k: usize| found.angle[k].to_degrees();
    let along = |sign: f64| -> Vec<[f64; 2]> {
        let point = |&k: &usize| {
            let (ratio, deviation) = ratio(found, k);
            [angle(k), ratio + 2.0 * sign * deviation]
        };
        places.iter().map(point).collect()
    };
    let color = Color::category(0);
    let mut chart = LineChart::new(
        caption(experiment, found.state),
        angle_axis(found),
        Axis::linear("τ_rθ / p [–]").between(-half, half),
    )
    .size(WIDTH, 0.4);
    for (label, sign) in [("± 2 standard deviations", -1.0), ("", 1.0)] {
        let line = Series::new(label, along(sign))
            .color(color)
            .dash(Dash::Dashed);
        chart = chart.with(line.width(0.9));
    }
    let line = Series::new("hybrid analysis", along(0.0)).color(color);
    chart = chart.with(line.style(SeriesStyle::Both).width(1.4));
    let known = true_ratios(found, truth);
    if !known.is_empty() {
        chart = chart.with(Series::new("truth", known).color(TRUTH).width(0.9));
    }
    with_zones(chart, found, identified)
}

/// Shear over pressure of the truth where there is pressure.
fn true_ratios(found: &Analysed, truth: &[TruePlace]) -> Vec<[f64; 2]> {
    let pressures = truth.iter().map(|place| place.stresses[0]);
    let largest = pressures.fold(0.0, f64::max);
    truth_within(found, truth)
        .filter(|place| place.stresses[0] > 1e-3 * largest)
        .map(|place| {
            let [pressure, shear, _] = place.stresses;
            [place.angle.to_degrees(), shear / pressure]
        })
        .collect()
}

/// The zones that slip in a state, and the coefficient with the signs that it has there.
fn with_zones(mut chart: LineChart, found: &Analysed, identified: &Identified) -> LineChart {
    let angle = |k: usize| found.angle[k].to_degrees();
    let zones = identified.zones.iter();
    let mut signs: Vec<f64> = Vec::new();
    for zone in zones.filter(|zone| zone.state == found.state) {
        let (first, last) = (zone.places.start, zone.places.end.saturating_sub(1));
        let label = if zone.given { "slips (given)" } else { "slips" };
        let band = Band::new(label, angle(first), angle(last), Color::category(2));
        chart = chart.band(band);
        signs.push(if zone.positive { 1.0 } else { -1.0 });
    }
    signs.dedup();
    signs.into_iter().fold(chart, |chart, sign| {
        with_coefficient(chart, identified, sign)
    })
}

fn with_coefficient(mut chart: LineChart, identified: &Identified, sign: f64) -> LineChart {
    let Some(fit) = &identified.dynamic else {
        return chart;
    };
    let color = Color::category(1);
    let name = format!("μd {}", signed(sign * fit.mu));
    chart = chart.reference(ReferenceLine::horizontal(name, sign * fit.mu).color(color));
    let faint = color.tint(0.6);
    let ends = identified.dynamic_bounds().map(Bounds::ends);
    for end in ends.into_iter().flatten().flatten() {
        chart = chart.reference(ReferenceLine::horizontal("", sign * end).color(faint));
    }
    chart
}

fn signed(value: f64) -> String {
    format!("{value:+.4}").replace('-', "−")
}
