//! Charts of the study.

use stickslip_report::FigureError;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, LineChart, Panels, ReferenceLine, Series};
use stickslip_report::color::{Color, loading_sequence};
use stickslip_report::svg::Svg;

use super::case::{Phase, Plate, Row};
use super::depth::DEPTHS;
use super::maps;
use super::plan::{COULOMB, DROPPING, POWER, RELOADED, SWEPT, TANGENT};
use super::plies::STRENGTH;
use super::study::{Study, of_report};
use crate::publish::Picture;

const WIDTH: f64 = 460.0;
const ASPECT: f64 = 0.68;

/// Curves of the first picture: legend, family, law.
const SHOWN: [(&str, &str, &str); 6] = [
    ("Coulomb, μ = 0.2", COULOMB, "μ = 0.2"),
    ("static 0.35, dynamic 0.25", DROPPING, "0.35 and 0.25, drop"),
    (
        "power of slip, 0.4 to 0.1",
        POWER,
        "of slip, 0.4 to 0.1 over 1e-4 in, current",
    ),
    (
        "swept, κ = 1, μ = 0.1 | 0.4",
        SWEPT,
        "κ = 1, V = 0.6, μ = 0.1 | 0.4",
    ),
    (
        "tangent, 15°, μ = 0.1 | 0.4",
        TANGENT,
        "ψ = 15°, V = 0.6, μ = 0.1 | 0.4",
    ),
    (
        "tangent, 5°, μ = 0 | 0.6",
        TANGENT,
        "ψ = 5°, V = 0.6, μ = 0 | 0.6",
    ),
];

/// All pictures, in the order of the page.
pub(crate) fn all(study: &Study) -> Result<Vec<Picture>, FigureError> {
    Ok(vec![
        Picture {
            name: "shear",
            svg: shear(study)?,
            alternative: "Shear along the edge for six friction laws: one sign while the load grows, reversed outside while it falls",
        },
        Picture {
            name: "map",
            svg: maps::laws(study)?,
            alternative: "Map of laws and lay-ups against loads: where the shear is reversed",
        },
        Picture {
            name: "reach",
            svg: maps::fits(study)?,
            alternative: "Map of clearance and stiffness of the pin: how far from the bearing point the shear is reversed while the load grows",
        },
        Picture {
            name: "again",
            svg: again(study)?,
            alternative: "Shear along the edge when the load grows again after unloading: reversed inside, as the report saw it",
        },
        Picture {
            name: "beneath",
            svg: beneath(study)?,
            alternative: "Shear on arcs beneath the edge: its sign changes with depth",
        },
        Picture {
            name: "plies",
            svg: plies(study)?,
            alternative: "Stress across the fibres of the 60°, 0° and −60° plies along the edge, without and with residual stress",
        },
    ])
}

/// Angle of the report, towards the bearing point.
fn angle() -> Axis {
    Axis::linear("θ of the report [deg] (bearing point: 90)")
        .between(0.0, 90.0)
        .every(15.0)
}

fn empty(title: String, y: &str) -> LineChart {
    LineChart::new(title, angle(), Axis::linear(y))
        .size(WIDTH, ASPECT)
        .reference(ReferenceLine::horizontal("", 0.0))
        .reference(ReferenceLine::vertical("", 30.0))
}

fn mirrored(profile: &[[f64; 2]]) -> Vec<[f64; 2]> {
    profile
        .iter()
        .map(|&[theta, shear]| [of_report(theta), shear])
        .collect()
}

fn shear(study: &Study) -> Result<Svg, FigureError> {
    let mut charts = Vec::new();
    let panels = [
        (Phase::Loading, 20.0),
        (Phase::Loading, 400.0),
        (Phase::Loading, 900.0),
        (Phase::Loading, 1500.0),
        (Phase::Unloading, 900.0),
        (Phase::Unloading, 400.0),
    ];
    for (phase, load) in panels {
        let how = if phase == Phase::Loading {
            "loading"
        } else {
            "unloading from 1500 lb"
        };
        let mut chart = empty(format!("{load} lb, {how}"), "τ D t/P [1]");
        for (index, (label, family, name)) in SHOWN.iter().enumerate() {
            let own = |row: &&Row| {
                row.case.family == *family
                    && row.case.name == *name
                    && row.case.plate == Plate::Plies
            };
            let step = study
                .rows
                .iter()
                .find(own)
                .and_then(|row| row.at(phase, load));
            if let Some(step) = step {
                let series =
                    Series::new(*label, mirrored(&step.profile)).color(Color::category(index));
                chart = chart.with(series.dash([Dash::Solid, Dash::Dashed][index % 2]));
            }
        }
        charts.push(chart);
    }
    let title = "Shear on the edge; positive: towards the bearing point";
    Panels::new(title, 2, charts).common_legend().render()
}

fn again(study: &Study) -> Result<Svg, FigureError> {
    let mut charts = Vec::new();
    for row in study.rows.iter().filter(|row| row.case.family == RELOADED) {
        let mut chart = empty(row.case.name.clone(), "τ D t/P [1]");
        let shown = [
            (Phase::Loading, 500.0, "500 lb, loading", Color::category(0)),
            (
                Phase::Unloading,
                300.0,
                "300 lb, unloading from 1500 lb",
                Color::category(1),
            ),
            (
                Phase::Reloading,
                400.0,
                "400 lb, loading again",
                Color::category(2),
            ),
            (
                Phase::Reloading,
                500.0,
                "500 lb, loading again",
                Color::category(3),
            ),
            (
                Phase::Reloading,
                900.0,
                "900 lb, loading again",
                Color::category(4),
            ),
        ];
        for (phase, load, label, color) in shown {
            if let Some(step) = row.at(phase, load) {
                chart = chart.with(Series::new(label, mirrored(&step.profile)).color(color));
            }
        }
        charts.push(chart);
    }
    let title = "Shear on the edge after unloading to 300 lb and loading again";
    Panels::new(title, 2, charts).common_legend().render()
}

fn beneath(study: &Study) -> Result<Svg, FigureError> {
    let colors = loading_sequence(DEPTHS.len());
    let mut charts: Vec<LineChart> = Vec::new();
    for group in study.arcs.chunk_by(|a, b| {
        (a.joint.friction, a.joint.clearance) == (b.joint.friction, b.joint.clearance)
    }) {
        let Some(joint) = group.first().map(|arc| arc.joint) else {
            continue;
        };
        let title = format!(
            "μ = {}, radial clearance {} in",
            joint.friction, joint.clearance
        );
        let mut chart = empty(title, "τ D t/P [1]");
        for (arc, color) in group.iter().filter(|arc| arc.load == 400.0).zip(&colors) {
            let label = if arc.depth == 0.0 {
                "on the edge".to_owned()
            } else {
                format!("{} t beneath", arc.depth)
            };
            chart = chart.with(Series::new(label, mirrored(&arc.profile)).color(*color));
        }
        charts.push(chart);
    }
    let title =
        "Shear on arcs beneath the edge at 400 lb, loading (t: thickness; hole radius 6.25 t)";
    Panels::new(title, 2, charts).common_legend().render()
}

fn plies(study: &Study) -> Result<Svg, FigureError> {
    let mut charts = Vec::new();
    for load in [900.0, 1500.0] {
        for cure in [0.0, -150.0] {
            let how = if cure == 0.0 {
                "no residual stress".to_owned()
            } else {
                format!("residual stress of {cure} K").replace('-', "−")
            };
            let x = Axis::linear("θ of the report [deg]")
                .between(0.0, 180.0)
                .every(30.0);
            let mut chart =
                LineChart::new(format!("{load} lb, {how}"), x, Axis::linear("σ₂ [ksi]"))
                    .size(WIDTH, ASPECT)
                    .reference(ReferenceLine::horizontal("", 0.0))
                    .reference(ReferenceLine::horizontal("Y_t", STRENGTH))
                    .reference(ReferenceLine::vertical("", 30.0))
                    .reference(ReferenceLine::vertical("", 150.0));
            for curve in study
                .curves
                .iter()
                .filter(|curve| curve.load == load && curve.cure == cure)
            {
                let (dash, width) = match (curve.clearance, curve.name) {
                    (0.0005, "Coulomb") => (Dash::Solid, 2.0),
                    (0.0005, _) => (Dash::Dotted, 2.0),
                    (0.0015, _) => (Dash::Dashed, 1.4),
                    _ => continue,
                };
                let ply = format!("{}°", curve.ply).replace('-', "−");
                let color = match curve.ply {
                    ply if ply > 0.0 => Color::category(0),
                    ply if ply < 0.0 => Color::category(1),
                    _ => Color::category(2),
                };
                let label = format!("{ply}, {}, {} in", curve.name, curve.clearance);
                let series = Series::new(label, curve.profile.clone());
                chart = chart.with(series.color(color).dash(dash).width(width));
            }
            charts.push(chart);
        }
    }
    let title = "Stress across the fibres of each ply along the edge, by law and clearance";
    Panels::new(title, 2, charts).common_legend().render()
}
