//! Coefficients along the slip path, of laws in which they change.

use stickslip_experiment::Experiment;
use stickslip_friction::FrictionLaw;
use stickslip_measure::laws::{Fit, LawStage, coefficient, half_width, law_of, passes};
use stickslip_report::FigureError;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, LineChart, Series};
use stickslip_report::color::Color;
use stickslip_report::svg::Svg;

/// Places along the slip path.
const PLACES: usize = 60;

/// Coefficients along the slip path that was reached, with the band of the laws in which they change and the truth of synthetic data;
/// `None` where no fitted law has a transition.
pub(super) fn figure(
    experiment: &Experiment,
    stage: &LawStage,
) -> Option<Result<Svg, FigureError>> {
    let reach = stage.slipped;
    let laws: Vec<(&Fit, Box<dyn FrictionLaw>)> = (stage.comparison.fits.iter())
        .filter_map(|fit| Some((fit, fit.law.law(&fit.calibration.values()).ok()?)))
        .collect();
    if reach <= 0.0 || !laws.iter().any(|(_, law)| passes(law.as_ref(), reach)) {
        return None;
    }
    let unit = experiment.display.length;
    let slips: Vec<f64> = (0..=PLACES)
        .map(|k| reach * (k as f64 / PLACES as f64).powi(2))
        .collect();
    let along = |of: &dyn Fn(f64) -> Option<f64>| -> Vec<[f64; 2]> {
        let points = slips.iter().filter_map(|&slip| Some((slip, of(slip)?)));
        points
            .map(|(slip, value)| [unit.from_base(slip), value])
            .collect()
    };
    let mut chart = LineChart::new(
        "Coefficient along the slip path",
        Axis::linear(format!("slip path [{}]", unit.name)),
        Axis::linear("μ"),
    );
    let synthetic = experiment
        .states
        .iter()
        .any(|own| own.source.is_synthetic());
    let truth = (experiment.specimen.scene.as_ref())
        .filter(|_| synthetic)
        .and_then(law_of);
    if let Some(truth) = truth {
        let points = along(&|slip| coefficient(truth, slip));
        let line = Series::new("truth", points).color(Color::rgb(0, 0, 0));
        chart = chart.with(line.width(3.0));
    }
    for (index, (fit, law)) in laws.iter().enumerate() {
        let color = Color::category(index);
        let points = along(&|slip| coefficient(law.as_ref(), slip));
        if !points.is_empty() {
            chart = chart.with(Series::new(&fit.law.name, points).color(color));
        }
        if !passes(law.as_ref(), reach) {
            continue;
        }
        let confidence = experiment.identify.confidence;
        for sign in [-1.0, 1.0] {
            let end = along(&|slip| {
                Some(coefficient(law.as_ref(), slip)? + sign * half_width(fit, slip, confidence)?)
            });
            if !end.is_empty() {
                let line = Series::new("", end).color(color).dash(Dash::Dashed);
                chart = chart.with(line.width(1.2));
            }
        }
    }
    Some(chart.render())
}
