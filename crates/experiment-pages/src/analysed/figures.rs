//! Pictures of edge stresses and of what they leave unexplained.

use stickslip_report::FigureError;
use stickslip_report::axis::{Axis, extent};
use stickslip_report::chart::{Dash, LineChart, Panels, Series, tile};
use stickslip_report::color::{Color, Colormap};
use stickslip_report::plane::PlanePlot;
use stickslip_report::svg::Svg;

use crate::gallery::{caption, edge_of_hole};
use stickslip_experiment::Experiment;
use stickslip_measure::analysed::{Analysed, TruePlace};

/// Width of a chart of the edge \[px\].
const WIDTH: f64 = 760.0;
/// Width of one map \[px\].
const MAP: f64 = 430.0;
/// Ends of the colours of misfits, in standard deviations.
const MISFIT: f64 = 4.0;
/// Colour of the truth.
pub(crate) const TRUTH: Color = Color::rgb(0x11, 0x11, 0x11);
const DIRECT: Color = Color::rgb(0x99, 0x99, 0x99);

/// Pressure, shear and hoop stress along the edge with bands of two standard deviations, beside the truth where it is known and the
/// direct interpolation.
pub(super) fn edge(
    experiment: &Experiment,
    found: &Analysed,
    truth: &[TruePlace],
) -> Result<Svg, FigureError> {
    let names = ["pressure −σ_r", "shear τ_rθ", "hoop stress σ_θ"];
    let [pressure, shear] = found.deviations();
    let deviations = [&pressure, &shear, &found.hoop_deviation];
    let values = [
        &found.tractions.pressure,
        &found.tractions.shear,
        &found.hoop,
    ];
    let charts = (0..3).map(|part| {
        let curve = Curve {
            found,
            value: values[part],
            deviation: deviations[part],
            part,
        };
        curve.chart(experiment, names[part], truth)
    });
    Panels::new(caption(experiment, found.state), 1, charts.collect())
        .common_legend()
        .render()
}

struct Curve<'a> {
    found: &'a Analysed,
    value: &'a [f64],
    deviation: &'a [f64],
    part: usize,
}

impl Curve<'_> {
    fn chart(&self, experiment: &Experiment, name: &str, truth: &[TruePlace]) -> LineChart {
        let unit = experiment.display.stress;
        let inner = self.found.inner();
        let along = |value: &dyn Fn(usize) -> f64| -> Vec<[f64; 2]> {
            (inner.clone())
                .map(|k| [self.found.angle[k].to_degrees(), unit.from_base(value(k))])
                .collect()
        };
        let mut chart = LineChart::new(
            "",
            angle_axis(self.found),
            Axis::linear(format!("{name} [{}]", unit.name)),
        )
        .size(WIDTH, 0.36);
        if let Some(direct) = &self.found.direct {
            let [low, high] = self.range();
            let cut = |k: usize| direct[k][self.part].clamp(2.0 * low - high, 2.0 * high - low);
            let line = Series::new("direct interpolation", along(&cut));
            chart = chart.with(line.color(DIRECT).dash(Dash::Dotted).width(1.0));
        }
        let color = Color::category(0);
        for (label, sign) in [("± 2 standard deviations", -2.0), ("", 2.0)] {
            let line = along(&|k| self.value[k] + sign * self.deviation[k]);
            chart = chart.with(
                Series::new(label, line)
                    .color(color)
                    .dash(Dash::Dashed)
                    .width(0.9),
            );
        }
        chart = chart.with(Series::new("hybrid analysis", along(&|k| self.value[k])).color(color));
        let shown = truth_within(self.found, truth).map(|place| {
            let stress = place.stresses[self.part];
            [place.angle.to_degrees(), unit.from_base(stress)]
        });
        let shown: Vec<[f64; 2]> = shown.collect();
        if !shown.is_empty() {
            let line = Series::new("truth", shown).color(TRUTH);
            chart = chart.with(line.width(0.9));
        }
        let [low, high] = self.range().map(|value| unit.from_base(value));
        chart.y = chart.y.clone().between(low, high);
        chart
    }

    /// What the axis shows: all values, and their bands where they are not wider than the values' own range.
    fn range(&self) -> [f64; 2] {
        let inner = || self.found.inner();
        let low = inner().map(|k| self.value[k]).fold(0.0, f64::min);
        let high = inner().map(|k| self.value[k]).fold(0.0, f64::max);
        let span = (high - low).max(f64::MIN_POSITIVE);
        let band = |sign: f64| inner().map(move |k| self.value[k] + sign * 2.0 * self.deviation[k]);
        let bottom = band(-1.0).fold(low, f64::min).max(low - 0.3 * span);
        let top = band(1.0).fold(high, f64::max).min(high + 0.3 * span);
        [bottom - 0.03 * span, top + 0.03 * span]
    }
}

/// The axis of angles of the places that can be trusted.
pub(crate) fn angle_axis(found: &Analysed) -> Axis {
    let inner = found.inner();
    let at = |k: usize| found.angle.get(k).map_or(0.0, |angle| angle.to_degrees());
    let (low, high) = (at(inner.start), at(inner.end.saturating_sub(1)));
    let axis = Axis::linear("θ [deg]").every(10.0);
    if high > low {
        axis.between(low, high)
    } else {
        axis
    }
}

/// The truth at the angles that can be trusted.
pub(crate) fn truth_within<'a>(
    found: &Analysed,
    truth: &'a [TruePlace],
) -> impl Iterator<Item = &'a TruePlace> {
    let inner = found.inner();
    let at = |k: usize| found.angle.get(k).copied().unwrap_or(0.0);
    let (low, high) = (at(inner.start), at(inner.end.saturating_sub(1)));
    truth
        .iter()
        .filter(move |place| (low..=high).contains(&place.angle))
}

/// Misfit at unused places over its standard deviation, U and V.
pub(super) fn misfit(experiment: &Experiment, found: &Analysed) -> Result<Svg, FigureError> {
    let unit = experiment.display.length;
    let edge = edge_of_hole(experiment, found.angle.iter().copied());
    let places = found.checks.misfit.iter();
    let places = places.map(|one| one.place.map(|x| unit.from_base(x)));
    let window = window(places.chain(edge.paths.concat()));
    let drawn = [0, 1].map(|axis| {
        let dots: Vec<([f64; 2], f64)> = (found.checks.misfit.iter())
            .filter(|one| one.axis == axis)
            .map(|one| (one.place.map(|x| unit.from_base(x)), one.relative))
            .collect();
        let mut plot = PlanePlot::new(["U field", "V field"][axis], unit.name, window).colors(
            Colormap::BlueWhiteRed,
            Some("misfit / deviation".to_owned()),
        );
        plot.dots = &dots;
        plot.range = Some([-MISFIT, MISFIT]);
        plot.marks = vec![edge.clone()];
        plot.width = MAP;
        plot.render()
    });
    let drawn = drawn.into_iter().collect::<Result<Vec<_>, _>>()?;
    tile(&caption(experiment, found.state), 2, &drawn)
}

/// What holds all places, with some room.
fn window(places: impl Iterator<Item = [f64; 2]>) -> [f64; 4] {
    let [left, right, bottom, top] = extent(places);
    let room = |length: f64| 0.04 * length.max(f64::MIN_POSITIVE);
    let (along_x, along_y) = (room(right - left), room(top - bottom));
    [
        left - along_x,
        right + along_x,
        bottom - along_y,
        top + along_y,
    ]
}
