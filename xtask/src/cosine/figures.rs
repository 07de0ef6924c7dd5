//! Charts of the study.

use stickslip_report::FigureError;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, LineChart, Panels, ReferenceLine, Series, SeriesStyle};
use stickslip_report::color::Color;
use stickslip_report::svg::Svg;

use super::Picture;
use super::case::{MEAN, Row};
use super::study::{CLEARANCE, CRITERION, FRICTION, Study};

const WIDTH: f64 = 460.0;
const ASPECT: f64 = 0.72;
const ASSUMED: Color = Color::rgb(0x22, 0x22, 0x22);

/// A compared quantity, larger or smaller with contact than with the assumed load.
struct Quantity {
    title: &'static str,
    of: fn(&Row) -> Option<f64>,
}

const RATIOS: [Quantity; 4] = [
    Quantity {
        title: "peak hoop stress",
        of: |row| Some(row.peak_hoop[0]),
    },
    Quantity {
        title: "hoop stress at 90°",
        of: |row| Some(row.net_hoop),
    },
    Quantity {
        title: "peak pressure",
        of: |row| Some(row.peak_pressure[0]),
    },
    Quantity {
        title: "load of first-ply failure",
        of: |row| row.strength(CRITERION),
    },
];

/// What is varied along the x axis.
#[derive(Clone, Copy)]
enum Varied {
    Clearance,
    Friction,
}

impl Varied {
    fn axis(self) -> Axis {
        match self {
            Self::Clearance => Axis::linear("Clearance c/R [%]"),
            Self::Friction => Axis::linear("Coefficient of friction μ [1]"),
        }
    }

    /// Rows of a lay-up along the axis, the other parameter at its usual value.
    fn rows<'a>(self, study: &'a Study, layup: &str) -> Vec<(f64, &'a Row)> {
        let (clearances, frictions) = (study.plan.clearances, study.plan.frictions);
        match self {
            Self::Clearance => clearances
                .iter()
                .filter_map(|&c| Some((100.0 * c, study.contact(layup, c, FRICTION)?)))
                .collect(),
            Self::Friction => frictions
                .iter()
                .filter_map(|&mu| Some((mu, study.contact(layup, CLEARANCE, mu)?)))
                .collect(),
        }
    }
}

/// All pictures, in the order of the page.
pub(super) fn all(study: &Study) -> Result<Vec<Picture>, FigureError> {
    Ok(vec![
        Picture {
            name: "profiles",
            svg: profiles(study)?,
            alternative: "Pressure and hoop stress along the hole, assumed and computed",
        },
        Picture {
            name: "clearance",
            svg: ratios(study, Varied::Clearance)?,
            alternative: "Computed over assumed quantities against clearance",
        },
        Picture {
            name: "friction",
            svg: ratios(study, Varied::Friction)?,
            alternative: "Computed over assumed quantities against friction",
        },
        Picture {
            name: "shear",
            svg: shear(study)?,
            alternative: "Peak shear stress on the edge, which the assumed load leaves out",
        },
        Picture {
            name: "first-ply",
            svg: first_ply(study)?,
            alternative: "Bearing stress at first-ply failure, assumed and computed",
        },
    ])
}

/// Pressure and hoop stress over the angle: assumed, and with three clearances.
fn profiles(study: &Study) -> Result<Svg, FigureError> {
    let mut charts = Vec::new();
    for &layup in study.plan.layups {
        for (column, what) in [(1, "−σ_r"), (2, "σ_θ")] {
            let title = format!("{layup}: {what}");
            let label = format!("{what} D t/P [1]");
            let x = Axis::linear("θ [deg]").between(0.0, 180.0).every(30.0);
            let mut chart = LineChart::new(title, x, Axis::linear(label)).size(WIDTH, 0.6);
            let points = |row: &Row| row.profile.iter().map(|r| [r[0], r[column]]).collect();
            if let Some(row) = study.cosine(layup) {
                let series = Series::new("assumed cosine", points(row));
                chart = chart.with(series.color(ASSUMED).dash(Dash::Dashed).width(2.2));
            }
            for (index, clearance) in [0.0, CLEARANCE, 0.01].into_iter().enumerate() {
                if let Some(row) = study.contact(layup, clearance, FRICTION) {
                    let name = format!("contact, c/R = {} %", 100.0 * clearance);
                    chart =
                        chart.with(Series::new(name, points(row)).color(Color::category(index)));
                }
            }
            charts.push(chart);
        }
    }
    let title = format!("Along the hole's edge at P/(D t) = {MEAN} MPa, μ = {FRICTION}");
    Panels::new(title, 2, charts).common_legend().render()
}

/// Each quantity with contact over the one with the assumed load, a curve for each lay-up.
fn ratios(study: &Study, varied: Varied) -> Result<Svg, FigureError> {
    let mut charts = Vec::new();
    for quantity in &RATIOS {
        let mut chart = LineChart::new(
            quantity.title,
            varied.axis(),
            Axis::linear("computed / assumed [1]"),
        )
        .size(WIDTH, ASPECT)
        .reference(ReferenceLine::horizontal("", 1.0));
        for (index, &layup) in study.plan.layups.iter().enumerate() {
            let Some(assumed) = study.cosine(layup).and_then(quantity.of) else {
                continue;
            };
            let points = varied
                .rows(study, layup)
                .into_iter()
                .filter_map(|(x, row)| Some([x, (quantity.of)(row)? / assumed]))
                .collect();
            chart = chart.with(curve(layup, points, index));
        }
        charts.push(chart);
    }
    let held = match varied {
        Varied::Clearance => format!("over clearance, μ = {FRICTION}"),
        Varied::Friction => format!("over friction, c/R = {} %", 100.0 * CLEARANCE),
    };
    let title = format!("Computed contact / assumed cosine {held}; P/(D t) = {MEAN} MPa");
    Panels::new(title, 2, charts).common_legend().render()
}

/// Every other curve is dashed, so that equal ones are both seen: lay-ups with the same moduli have the same stresses.
fn curve(name: &str, points: Vec<[f64; 2]>, index: usize) -> Series {
    let dash = [Dash::Solid, Dash::Dashed][index % 2];
    Series::new(name, points)
        .style(SeriesStyle::Both)
        .color(Color::category(index))
        .dash(dash)
}

/// What friction adds and the assumed load does not have.
fn shear(study: &Study) -> Result<Svg, FigureError> {
    let mut charts = Vec::new();
    for varied in [Varied::Clearance, Varied::Friction] {
        let held = match varied {
            Varied::Clearance => format!("μ = {FRICTION}"),
            Varied::Friction => format!("c/R = {} %", 100.0 * CLEARANCE),
        };
        let mut chart = LineChart::new(held, varied.axis(), Axis::linear("max |τ_rθ| D t/P [1]"))
            .size(WIDTH, ASPECT);
        for (index, &layup) in study.plan.layups.iter().enumerate() {
            let points = varied
                .rows(study, layup)
                .into_iter()
                .map(|(x, row)| [x, row.peak_shear])
                .collect();
            chart = chart.with(curve(layup, points, index));
        }
        charts.push(chart);
    }
    let title =
        format!("Peak shear on the edge at P/(D t) = {MEAN} MPa; the assumed load has none");
    Panels::new(title, 2, charts).common_legend().render()
}

/// First-ply failure over clearance for every friction, a panel for each lay-up.
fn first_ply(study: &Study) -> Result<Svg, FigureError> {
    let mut charts = Vec::new();
    for &layup in study.plan.layups {
        let y = Axis::linear("P/(D t) at first-ply failure [MPa]");
        let mut chart = LineChart::new(layup, Varied::Clearance.axis(), y).size(WIDTH, ASPECT);
        let ends = [study.plan.clearances.first(), study.plan.clearances.last()];
        if let Some(assumed) = study.cosine(layup).and_then(|row| row.strength(CRITERION)) {
            let line = ends.into_iter().flatten().map(|c| [100.0 * c, assumed]);
            let series = Series::new("assumed cosine", line.collect());
            chart = chart.with(series.color(ASSUMED).dash(Dash::Dashed).width(2.2));
        }
        for (index, &friction) in study.plan.frictions.iter().enumerate() {
            let points = study
                .plan
                .clearances
                .iter()
                .filter_map(|&c| {
                    let row = study.contact(layup, c, friction)?;
                    Some([100.0 * c, row.strength(CRITERION)?])
                })
                .collect();
            let series = curve(&format!("contact, μ = {friction}"), points, index);
            chart = chart.with(series.dash(Dash::Solid));
        }
        charts.push(chart);
    }
    Panels::new("First-ply failure by maximum stress", 2, charts)
        .common_legend()
        .render()
}
