//! What makes the bands of a region's stresses doubtful.

use stickslip_hybrid::region::fit::Amount;

use stickslip_measure::analysed::Analysed;
use stickslip_scene::experiment::{Experiment, Source};
use stickslip_text::short;

/// Part of the data that the parameters of a fit may be before it is reported.
const MANY: f64 = 0.5;
/// Noise factors beyond which the stated deviation is reported as wrong.
const FACTORS: [f64; 2] = [0.1, 10.0];
/// Part of the noise factor that single residuals show of errors which do not go together.
const CORRELATED: f64 = 0.5;

/// What makes the bands of a state doubtful.
pub(super) fn doubts(experiment: &Experiment, found: &Analysed) -> Vec<String> {
    let mut doubts = Vec::new();
    if let Some(why) = &found.scale_assumed {
        doubts.push(format!(
            "the noise factor is assumed to be {}, for the fit whose residuals tell it fails: {why}. Bands hold errors of the deviation \
             alone, and are too narrow where errors are larger or go together.",
            short(found.scale)
        ));
    }
    let Some(fit) = &found.fit else {
        return doubts;
    };
    if fit.parameters > MANY * fit.data as f64 {
        doubts.push(format!(
            "{} data determine {:.0} parameters of the fit: the region has too many nodes for them, and neither its stresses nor their \
             bands can be trusted. Take fewer cells or smaller areas of region.interior, or state a smoothing amount.",
            fit.data, fit.parameters
        ));
    }
    let single = fit.residual / (fit.data as f64 - fit.parameters).max(1.0);
    let least = fit.of_residuals.min(single);
    let source = &experiment.states[found.state].source;
    let pictured = matches!(source, Source::Step(_) | Source::Pictures(_));
    if !pictured && least < FACTORS[0] {
        doubts.push(smooth(experiment, found.state, least));
    } else if fit.of_residuals > FACTORS[1] && single < CORRELATED * fit.of_residuals {
        doubts.push(format!(
            "means of neighbouring residuals vary {} times as much as independent errors would make them, single residuals {}: errors of \
             neighbours go together, as those of overlapping subsets or filtered data do. Bands follow, but {}.",
            short(fit.of_residuals),
            short(single),
            of_smoothing(experiment)
        ));
    } else if !(FACTORS[0]..=FACTORS[1]).contains(&fit.of_residuals) {
        doubts.push(format!(
            "the variance of the residuals is {} times that of the deviation; bands follow the residuals. Check the deviation.",
            short(fit.of_residuals)
        ));
    }
    doubts
}

/// What errors of neighbours that go together mean for the amount of smoothing.
fn of_smoothing(experiment: &Experiment) -> &'static str {
    let amount = experiment.region.as_ref().map(|plan| plan.smoothing.amount);
    if matches!(amount, Some(Amount::Given(_))) {
        "so do residuals where the stated amount smooths the displacements themselves away: compare a smaller region.smoothing amount"
    } else {
        "cross-validation takes errors for independent and smooths too little: state a smoothing amount, or take one of so many places \
         that their errors are independent"
    }
}

/// What it means that residuals are far below the deviation of the data.
fn smooth(experiment: &Experiment, state: usize, of_residuals: f64) -> String {
    let found = format!(
        "the residuals have {} of the variance of the deviation",
        short(of_residuals)
    );
    let is_stated = |source: &Source| match source {
        Source::Table(table) => table.deviation.is_some(),
        Source::Lines(_) => true,
        Source::Step(_) | Source::Pictures(_) => false,
    };
    let plan = &experiment.states[state];
    let mut sources = plan.null.iter().chain([&plan.source]);
    if sources.all(is_stated) {
        format!(
            "{found} that was stated, which bands follow: smoothed data have small residuals whatever their errors are. If the data are not \
             smoothed, state a smaller deviation; if they are, state the smoothing amount, which is found from residuals."
        )
    } else {
        format!(
            "{found} that was estimated: the data are calculated or smoothed, and bands hold what rounds their digits and the bias of \
             smoothing, not the error of a measurement or of the mesh. State the deviation that the measurement has."
        )
    }
}
