//! Maps of where the shear is reversed.

use stickslip_report::FigureError;
use stickslip_report::color::Color;
use stickslip_report::map::{Category, Group, OutcomeMap};
use stickslip_report::svg::Svg;

use super::case::{Phase, Plate, Row, Step};
use super::curve::Pattern;
use super::plan::{COULOMB, DROPPING, FITS, LAYUPS, POWER, SWEPT, TANGENT, fit_name, pin_name};
use super::study::{SEEN, Study, of_report};

fn category(label: &str, mark: &str, color: Color) -> Category {
    Category {
        label: label.to_owned(),
        mark: mark.to_owned(),
        color,
    }
}

/// What a step can be.
fn patterns() -> Vec<Category> {
    vec![
        category("no shear", "0", Color::rgb(0xf4, 0xf4, 0xf4)),
        category(
            "towards the bearing point everywhere",
            "",
            Color::rgb(0xd6, 0xe6, 0xf4),
        ),
        category(
            "reversed near the bearing point",
            "b",
            Color::rgb(0xfd, 0xd0, 0x8c),
        ),
        category(
            "reversed beyond about 30°, as the report saw it",
            "R",
            Color::rgb(0xd7, 0x30, 0x27),
        ),
        category(
            "reversed at the end of contact",
            "e",
            Color::rgb(0xb8, 0xa9, 0xd6),
        ),
        category("reversed everywhere", "x", Color::rgb(0x8c, 0x6b, 0xb1)),
    ]
}

fn pattern(step: &Step) -> usize {
    match step.reading.pattern {
        _ if step.is_as_seen() => 3,
        Pattern::None => 0,
        Pattern::Forward => 1,
        Pattern::ReversedInside => 2,
        Pattern::ReversedOutside => 4,
        Pattern::Reversed => 5,
    }
}

/// Families and the laws of them that the map shows: all, or those whose name contains one of these.
const SHOWN: [(&str, &[&str]); 6] = [
    (COULOMB, &[""]),
    (DROPPING, &["drop", "0.6 and 0.1"]),
    (POWER, &["1e-4 in, current", "1e-3 in, current", "pressure"]),
    (SWEPT, &["κ = 1, V = 0.6", "κ = 3, V = 0.8"]),
    (TANGENT, &["ψ = 5°, V = 0.6", "ψ = 15°, V = 0.6"]),
    (LAYUPS, &["Coulomb"]),
];

/// Laws and lay-ups over the load.
pub(crate) fn laws(study: &Study) -> Result<Svg, FigureError> {
    let steps = study.rows.first().map_or(&[][..], |row| &row.steps);
    let unloading = steps.iter().position(|step| step.phase == Phase::Unloading);
    let group = |&(family, names): &(&str, &[&str])| {
        let shown = |row: &&Row| {
            row.case.family == family
                && row.case.plate != Plate::Smeared
                && names.iter().any(|name| row.case.name.contains(name))
        };
        let rows = study.rows.iter().filter(shown);
        Group {
            label: family.to_owned(),
            rows: rows
                .map(|row| {
                    (
                        row.case.name.clone(),
                        row.steps.iter().map(|step| Some(pattern(step))).collect(),
                    )
                })
                .collect(),
            divider: unloading.map(|column| (column, "unloading".to_owned())),
        }
    };
    OutcomeMap {
        title: "Sign of the shear on the edge, loading to 1500 lb and unloading".into(),
        subtitle: "(0₂/60₂/−60₂)s but where a lay-up is named, aluminium pin, radial clearance 0.0005 in; μ = fibre | matrix".into(),
        x_label: "Load [lb]".into(),
        columns: steps.iter().map(|step| step.load.to_string()).collect(),
        groups: SHOWN.iter().map(group).filter(|group| !group.rows.is_empty()).collect(),
        categories: patterns(),
        width: 1240.0,
    }
    .render()
}

/// How far from the bearing point, 90° of the report, the shear can be reversed while the load grows.
fn reaches() -> Vec<Category> {
    vec![
        category("nowhere", "", Color::rgb(0xd6, 0xe6, 0xf4)),
        category("down to 75°", "75", Color::rgb(0xfe, 0xee, 0xd0)),
        category("down to 60°", "60", Color::rgb(0xfd, 0xd0, 0x8c)),
        category("down to 40°", "40", Color::rgb(0xf4, 0x9d, 0x50)),
        category(
            "down to less, as the report saw it",
            "R",
            Color::rgb(0xd7, 0x30, 0x27),
        ),
    ]
}

fn reach(row: &Row) -> usize {
    let reach = row.furthest().and_then(|step| step.reading.reach());
    match reach.map(of_report) {
        None => 0,
        Some(angle) if angle > 75.0 => 1,
        Some(angle) if angle > 60.0 => 2,
        Some(angle) if angle > SEEN[1] => 3,
        Some(_) => 4,
    }
}

/// Clearance, pin and friction.
pub(crate) fn fits(study: &Study) -> Result<Svg, FigureError> {
    let plan = &study.plan;
    let cell = |mu: f64, pin: f64, clearance: f64| {
        let name = fit_name(mu, pin, clearance);
        let mut rows = study.rows.iter();
        let own = rows.find(|row| row.case.family == FITS && row.case.name == name)?;
        Some(reach(own))
    };
    let group = |&mu: &f64| Group {
        label: format!("μ = {mu}"),
        rows: plan
            .pins
            .iter()
            .map(|&pin| {
                let cells = plan
                    .clearances
                    .iter()
                    .map(|&clearance| cell(mu, pin, clearance));
                (pin_name(pin), cells.collect())
            })
            .collect(),
        divider: None,
    };
    OutcomeMap {
        title: "How far the shear is reversed while the load grows, Coulomb friction".into(),
        subtitle: "from the bearing point, 90° of the report, with unreversed shear beyond, at any load to 1500 lb".into(),
        x_label: "Radial clearance [in] (hole radius 0.375 in)".into(),
        columns: plan.clearances.iter().map(ToString::to_string).collect(),
        groups: plan.frictions.iter().map(group).collect(),
        categories: reaches(),
        width: 720.0,
    }
    .render()
}
