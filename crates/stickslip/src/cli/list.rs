//! `stickslip list`: what can be written in a scene or an experiment.

mod laminates;
mod presets;

use std::fmt::Write as _;

use clap::{Args, ValueEnum};
use serde_json::{Map, Value, json};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_friction::{ParameterInfo, laws};

use super::console::Console;
use super::failure::Failure;
use super::init::TEMPLATES;
use crate::output::{SIGNS, signs_table};
use crate::units::Dimension;

#[derive(Debug, Args)]
pub(super) struct ListArguments {
    /// What to list; everything by default
    topic: Option<Topic>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Topic {
    Laws,
    Loads,
    Layups,
    Criteria,
    Templates,
    Presets,
    Elements,
    Solvers,
    Units,
    Signs,
}

const LOADS: [(&str, &str); 5] = [
    ("force", "a total force, spread evenly over an edge"),
    (
        "bearing",
        "a force on a hole without a pin, as pressure by an assumed law: cosine, uniform",
    ),
    ("pressure", "a pressure on an edge"),
    ("polar_traction", "stresses on a circle, from a file"),
    ("temperature", "a temperature change of a body"),
];

const SOLVERS: [(&str, &str); 4] = [
    (
        "auto",
        "climbs from the fastest to the safest until one succeeds (default)",
    ),
    ("status", "iteration of open, stick and slip per node"),
    ("newton", "semismooth Newton on the contact conditions"),
    (
        "pivoting",
        "Lemke's pivoting on the linear complementarity problem",
    ),
];

/// Columns of the tables of edges, what they are measured in, and what they are.
const COLUMNS: [(&str, &str, &str); 9] = [
    (
        "theta, x",
        "deg, length",
        "place along a circle, along a line",
    ),
    ("CPRESS", "stress", "contact pressure"),
    ("CSHEAR1", "stress", "friction traction"),
    ("COPEN", "length", "gap"),
    ("CSLIP1", "length", "accumulated slip"),
    ("CSTATUS", "–", "open, stick, slip+, slip-"),
    ("sigma_r, sigma_yy", "stress", "stress normal to the edge"),
    ("sigma_theta, sigma_xx", "stress", "stress along the edge"),
    ("tau_rtheta, tau_xy", "stress", "shear stress"),
];

pub(super) fn list(arguments: &ListArguments, console: Console) -> Result<(), Failure> {
    let topics: Vec<Topic> = match arguments.topic {
        Some(topic) => vec![topic],
        None => Topic::value_variants().to_vec(),
    };
    let text = || {
        topics
            .iter()
            .map(|topic| text(*topic))
            .collect::<Vec<_>>()
            .join("\n")
    };
    let value: Map<_, _> = topics
        .iter()
        .map(|topic| (name(*topic).to_owned(), value(*topic)))
        .collect();
    console.result(text, &value)
}

fn name(topic: Topic) -> &'static str {
    match topic {
        Topic::Laws => "laws",
        Topic::Loads => "loads",
        Topic::Layups => "layups",
        Topic::Criteria => "criteria",
        Topic::Templates => "templates",
        Topic::Presets => "presets",
        Topic::Elements => "elements",
        Topic::Solvers => "solvers",
        Topic::Units => "units",
        Topic::Signs => "signs",
    }
}

fn element_summary(kind: ElementKind) -> &'static str {
    match kind {
        ElementKind::T3 => "linear triangle",
        ElementKind::T6 => "quadratic triangle",
        ElementKind::Q4 => "bilinear quadrilateral",
        ElementKind::Q8 => "serendipity quadrilateral (default)",
        ElementKind::Q9 => "biquadratic quadrilateral",
    }
}

fn text(topic: Topic) -> String {
    match topic {
        Topic::Laws => laws_text(),
        Topic::Loads => {
            let row = |(name, summary): (&str, &str)| (name.to_owned(), summary.to_owned());
            table("Loads, for loads.N.NAME", LOADS.into_iter().map(row))
        }
        Topic::Layups => laminates::layups_text(),
        Topic::Criteria => laminates::criteria_text(),
        Topic::Templates => {
            let rows = TEMPLATES
                .iter()
                .map(|template| (template.name.to_owned(), template.summary.to_owned()));
            table("Templates, for `stickslip init NAME`", rows)
        }
        Topic::Presets => presets::text(),
        Topic::Elements => {
            let row = |kind: ElementKind| (format!("{kind:?}"), element_summary(kind).to_owned());
            table(
                "Elements, for mesh.element",
                ElementKind::ALL.into_iter().map(row),
            )
        }
        Topic::Solvers => {
            let row = |(name, summary): (&str, &str)| (name.to_owned(), summary.to_owned());
            table("Solvers, for analysis.solver", SOLVERS.into_iter().map(row))
        }
        Topic::Units => {
            let row = |dimension: Dimension| {
                let names: Vec<_> = dimension.unit_names().collect();
                (dimension.to_string(), names.join(", "))
            };
            table(
                "Units; every quantity is written with one, in quotes",
                Dimension::ALL.into_iter().map(row),
            )
        }
        Topic::Signs => {
            let row = |(name, unit, meaning): (&str, &str, &str)| {
                (name.to_owned(), format!("{unit:11}  {meaning}"))
            };
            let columns = table(
                "Columns of edge tables; lengths and stresses in the [units] of the scene, which headings name",
                COLUMNS.into_iter().map(row),
            );
            format!("{columns}\n{}", signs_table())
        }
    }
}

/// A title and two aligned columns.
fn table(title: &str, rows: impl Iterator<Item = (String, String)>) -> String {
    let rows: Vec<_> = rows.collect();
    let width = rows
        .iter()
        .map(|(name, _)| name.chars().count())
        .max()
        .unwrap_or_default();
    let line = |(name, text): &(String, String)| format!("  {name:width$}  {text}");
    let lines: Vec<_> = rows.iter().map(line).collect();
    format!("{title}\n{}\n", lines.join("\n"))
}

fn laws_text() -> String {
    let mut text = "Friction laws, for contacts.N.friction.NAME\n".to_owned();
    for law in laws() {
        // Writing into a string does not fail.
        let _ = writeln!(text, "\n  {} – {}", law.name, law.summary);
        let width = law
            .parameters
            .iter()
            .map(|parameter| parameter.path.len())
            .max()
            .unwrap_or_default();
        for parameter in law.parameters {
            let _ = writeln!(
                text,
                "    {:width$}  {:13}  {:20}  {}",
                parameter.path,
                parameter.dimension,
                default_of(parameter),
                parameter.meaning
            );
        }
    }
    text
}

fn default_of(parameter: &ParameterInfo) -> String {
    parameter
        .default
        .map_or_else(|| "required".to_owned(), |value| format!("default {value}"))
}

fn value(topic: Topic) -> Value {
    match topic {
        Topic::Loads => LOADS
            .iter()
            .map(|(name, summary)| json!({ "name": name, "summary": summary }))
            .collect(),
        Topic::Layups => laminates::layups_value(),
        Topic::Criteria => laminates::criteria_value(),
        Topic::Laws => laws()
            .map(|law| {
                let parameters: Vec<_> = law
                    .parameters
                    .iter()
                    .map(|parameter| {
                        json!({
                            "path": parameter.path,
                            "dimension": parameter.dimension.to_string(),
                            "default": parameter.default,
                            "meaning": parameter.meaning,
                        })
                    })
                    .collect();
                json!({ "name": law.name, "summary": law.summary, "parameters": parameters })
            })
            .collect(),
        Topic::Templates => TEMPLATES
            .iter()
            .map(|template| json!({ "name": template.name, "summary": template.summary }))
            .collect(),
        Topic::Presets => presets::value(),
        Topic::Elements => ElementKind::ALL
            .into_iter()
            .map(|kind| json!({ "name": kind, "summary": element_summary(kind), "nodes": kind.nodes() }))
            .collect(),
        Topic::Solvers => SOLVERS
            .iter()
            .map(|(name, summary)| json!({ "name": name, "summary": summary }))
            .collect(),
        Topic::Units => {
            let names = |dimension: Dimension| json!(dimension.unit_names().collect::<Vec<_>>());
            Dimension::ALL.into_iter().map(|dimension| (dimension.to_string(), names(dimension))).collect()
        }
        Topic::Signs => {
            let column = |(name, unit, meaning): &(&str, &str, &str)| {
                json!({ "name": name, "unit": unit, "meaning": meaning })
            };
            let columns: Vec<_> = COLUMNS.iter().map(column).collect();
            let sign = |[quantity, meaning, elsewhere]: &[&str; 3]| {
                json!({ "quantity": quantity, "meaning": meaning, "elsewhere": elsewhere })
            };
            let signs: Vec<_> = SIGNS.iter().map(sign).collect();
            json!({ "columns": columns, "signs": signs })
        }
    }
}
