//! Pictures of the whole plate: tractions around the hole, and their ratio.

use stickslip_report::FigureError;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, LineChart, Panels, ReferenceLine, Series};
use stickslip_report::color::Color;
use stickslip_report::svg::Svg;

use crate::gallery::caption;
use stickslip_experiment::Experiment;
use stickslip_measure::whole::WholeState;

fn angles() -> Axis {
    Axis::linear("θ [deg]").between(-180.0, 180.0).every(60.0)
}

/// Pressure and shear of every state.
pub(super) fn tractions(
    experiment: &Experiment,
    states: &[WholeState],
) -> Result<Svg, FigureError> {
    let unit = experiment.display.stress;
    let charts = states.iter().map(|own| {
        let solution = &own.solution;
        let curve = |name: &str, values: &[f64], which: usize, color: Color| {
            let points = |shift: f64| -> Vec<[f64; 2]> {
                (0..values.len())
                    .map(|k| {
                        let value = values[k] + shift * solution.deviation(which, k);
                        [solution.angle[k].to_degrees(), unit.from_base(value)]
                    })
                    .collect()
            };
            let bound = |label: &str, shift: f64| {
                Series::new(label, points(shift))
                    .color(color)
                    .dash(Dash::Dotted)
                    .width(1.0)
            };
            [
                Series::new(name, points(0.0)).color(color),
                bound("± 2 standard deviations", 2.0),
                bound("", -2.0),
            ]
        };
        let own_tractions = &solution.tractions;
        let pressure = curve("pressure", &own_tractions.pressure, 0, Color::category(0));
        let shear = curve("shear", &own_tractions.shear, 1, Color::category(1));
        let mut chart = LineChart::new(
            caption(experiment, own.state),
            angles(),
            Axis::linear(format!("traction [{}]", unit.name)),
        )
        .size(480.0, 0.55);
        for series in pressure.into_iter().chain(shear) {
            chart = chart.with(series);
        }
        chart.reference(ReferenceLine::horizontal("", 0.0))
    });
    Panels::new(
        "Tractions on the hole of the whole plate",
        2,
        charts.collect(),
    )
    .common_legend()
    .render()
}

/// Shear over pressure against the angle, all states in one chart.
pub(super) fn ratio(experiment: &Experiment, states: &[WholeState]) -> Result<Svg, FigureError> {
    let mut chart = LineChart::new(
        "Shear over pressure on the hole",
        angles(),
        Axis::linear("shear over pressure").between(-0.8, 0.8),
    );
    for own in states {
        let points = own.solution.ratios();
        let points = points
            .iter()
            .map(|(angle, ratio, _)| [angle.to_degrees(), *ratio]);
        chart = chart.with(Series::new(
            caption(experiment, own.state),
            points.collect(),
        ));
    }
    chart.reference(ReferenceLine::horizontal("", 0.0)).render()
}
