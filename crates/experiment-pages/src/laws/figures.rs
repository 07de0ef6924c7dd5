//! Pictures of fitted laws: profiles of χ², residuals near the edge, measured against predicted.

use stickslip_friction::Dimension;
use stickslip_hybrid::calibrate::Estimate;
use stickslip_hybrid::identify::chi_squared_of_one;
use stickslip_report::FigureError;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{LineChart, Panels, ReferenceLine, Series, SeriesStyle};
use stickslip_report::color::Color;
use stickslip_report::svg::Svg;

use crate::gallery::caption;
use stickslip_experiment::Experiment;
use stickslip_measure::laws::{Fit, LawStage, Ring};

/// Profiles are drawn up to this many times their limit.
const HEIGHT: f64 = 3.0;
const AXES: [&str; 2] = ["U", "V"];

/// A parameter in the units of a reader: factor from base units, and name of the unit.
pub(super) fn unit(experiment: &Experiment, dimension: Dimension) -> (f64, &'static str) {
    let display = &experiment.display;
    match dimension {
        Dimension::Length => (display.length.from_base(1.0), display.length.name),
        Dimension::Stress => (display.stress.from_base(1.0), display.stress.name),
        Dimension::Angle => (1_f64.to_degrees(), "deg"),
        _ => (1.0, ""),
    }
}

/// The name of a parameter with its unit.
fn label(name: &str, unit: &str) -> String {
    if unit.is_empty() {
        name.to_owned()
    } else {
        format!("{name} [{unit}]")
    }
}

/// One chart per free parameter of every law.
pub(super) fn profiles(experiment: &Experiment, stage: &LawStage) -> Result<Svg, FigureError> {
    let limit = chi_squared_of_one(experiment.identify.confidence);
    let mut charts = Vec::new();
    for fit in &stage.comparison.fits {
        for index in 0..fit.calibration.estimates.len() {
            charts.push(profile(experiment, fit, index, limit));
        }
    }
    let columns = charts.len().clamp(1, 3);
    Panels::new("Profiles of χ²: what the data rule out", columns, charts).render()
}

fn profile(experiment: &Experiment, fit: &Fit, index: usize, limit: f64) -> LineChart {
    let own: &Estimate = &fit.calibration.estimates[index];
    let parameter = &fit.law.parameters[index];
    let (factor, unit) = unit(experiment, fit.law.dimensions[index]);
    let top = HEIGHT * limit;
    let inside: Vec<f64> = (own.profile.iter())
        .filter(|(_, increase)| *increase <= top)
        .map(|(value, _)| *value)
        .collect();
    let least = inside.iter().copied().fold(own.value, f64::min);
    let most = inside.iter().copied().fold(own.value, f64::max);
    // A little beyond what is not ruled out, within the range that was looked at.
    let room = 0.2 * (most - least);
    let [mut low, mut high] = [least - room, most + room];
    if parameter.logarithmic {
        let ratio = (most / least).powf(0.2);
        [low, high] = [least / ratio, most * ratio];
    }
    let [low, high] = [low.max(parameter.range[0]), high.min(parameter.range[1])];
    let points = own
        .profile
        .iter()
        .map(|&(value, increase)| [factor * value, increase]);
    let (low, high) = (factor * low, factor * high);
    let name = label(&own.name, unit);
    let x = if parameter.logarithmic {
        Axis::log(name)
    } else {
        Axis::linear(name)
    };
    let x = if low < high { x.between(low, high) } else { x };
    LineChart::new(
        &fit.law.name,
        x,
        Axis::linear("χ² above its least").between(0.0, top),
    )
    .with(Series::new("", points.collect()).style(SeriesStyle::Both))
    .reference(ReferenceLine::horizontal(
        format!("{:.4} %", 100.0 * experiment.identify.confidence).replace(".0000", ""),
        limit,
    ))
    .reference(ReferenceLine::vertical("", factor * own.value))
    .size(360.0, 0.7)
}

/// What each law leaves of the measured displacements near the edge, by angle.
pub(super) fn residuals(experiment: &Experiment, stage: &LawStage) -> Result<Svg, FigureError> {
    let (scale, unit) = scale(experiment);
    let charts = each(experiment, stage, |title, axis, ring| {
        let mut chart = chart(title, format!("{} left over [{unit}]", AXES[axis]));
        for (law, fit) in stage.comparison.fits.iter().enumerate() {
            let left = ring.measured.iter().zip(&ring.predicted[law]);
            let points = ring.angle.iter().zip(left);
            chart = chart.with(
                Series::new(
                    &fit.law.name,
                    points
                        .map(|(angle, (m, h))| [*angle, scale * (m - h)])
                        .collect(),
                )
                .color(Color::category(law)),
            );
        }
        chart.reference(ReferenceLine::horizontal("", 0.0))
    });
    Panels::new("Measured less predicted near the edge", 2, charts)
        .common_legend()
        .render()
}

/// Measured displacements near the edge, and those of the best law.
pub(super) fn predictions(experiment: &Experiment, stage: &LawStage) -> Result<Svg, FigureError> {
    let (scale, unit) = scale(experiment);
    let best = stage.comparison.best;
    let name = &stage.comparison.best().law.name;
    let charts = each(experiment, stage, |title, axis, ring| {
        let along = |values: &[f64]| -> Vec<[f64; 2]> {
            let both = ring.angle.iter().zip(values);
            both.map(|(angle, value)| [*angle, scale * value]).collect()
        };
        chart(title, format!("{} [{unit}]", AXES[axis]))
            .with(Series::new(
                format!("predicted: {name}"),
                along(&ring.predicted[best]),
            ))
            .with(Series::new("measured", along(&ring.measured)).style(SeriesStyle::Markers))
    });
    Panels::new("Displacements near the edge", 2, charts)
        .common_legend()
        .render()
}

/// Fringes where there is a grating, and otherwise the unit of length.
pub(super) fn scale(experiment: &Experiment) -> (f64, &'static str) {
    let unit = experiment.display.length;
    experiment.grating.map_or_else(
        || (unit.from_base(1.0), unit.name),
        |grating| (grating.frequency(), "fringes"),
    )
}

fn chart(title: String, y: String) -> LineChart {
    let x = Axis::linear("angle [deg]")
        .between(-180.0, 180.0)
        .every(60.0);
    LineChart::new(title, x, Axis::linear(y)).size(480.0, 0.5)
}

/// One chart per component of every state that has data near the edge.
fn each(
    experiment: &Experiment,
    stage: &LawStage,
    draw: impl Fn(String, usize, &Ring) -> LineChart,
) -> Vec<LineChart> {
    let mut charts = Vec::new();
    for (observation, &state) in stage.states.iter().enumerate() {
        for axis in 0..2 {
            let ring = Ring::of(stage, experiment.specimen.hole, observation, axis);
            if !ring.angle.is_empty() {
                charts.push(draw(caption(experiment, state), axis, &ring));
            }
        }
    }
    charts
}
