//! `stickslip list`: what can be written in a scene or an experiment.

mod keys;
mod laminates;
mod presets;
mod table;

use std::fmt::Write as _;
use table::table;

use clap::{Args, ValueEnum};
use serde_json::{Map, Value, json};
use stickslip_contact::solver::{SOLVERS, SolverInfo};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_friction::{ParameterInfo, laws};
use stickslip_laminate::progressive::point_models;

use super::console::Console;
use super::failure::Failure;
use super::init::templates;
use stickslip_present::results::{signs, signs_table};
use stickslip_scene::units::Dimension;

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
    Models,
    Templates,
    Presets,
    Elements,
    Solvers,
    Units,
    Signs,
    Keys,
}

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
        .map(|topic| {
            let name = topic.to_possible_value().unwrap_or_default();
            (name.get_name().to_owned(), value(*topic))
        })
        .collect();
    console.result(text, &value)
}

fn element_summary(kind: ElementKind) -> String {
    let default = if kind == ElementKind::Q8 {
        " (default)"
    } else {
        ""
    };
    format!("{}{default}", kind.summary())
}

fn text(topic: Topic) -> String {
    match topic {
        Topic::Laws => {
            let rows = laws().map(|law| (law.name, law.summary, law.parameters));
            parameters_text("Friction laws, for contacts.N.friction.NAME", rows)
        }
        Topic::Loads => {
            let row = |(name, summary): (&str, &str)| (name.to_owned(), summary.to_owned());
            table("Loads, for loads.N.NAME", keys::loads().map(row))
        }
        Topic::Layups => laminates::layups_text(),
        Topic::Criteria => laminates::criteria_text(),
        Topic::Models => {
            let rows = point_models().map(|model| (model.name, model.summary, model.parameters));
            parameters_text("Point models, for failure.progressive.model.NAME", rows)
        }
        Topic::Templates => {
            let rows =
                templates().map(|template| (template.name.to_owned(), template.summary.to_owned()));
            table("Templates, for `stickslip init NAME`", rows)
        }
        Topic::Presets => presets::text(),
        Topic::Keys => keys::text(),
        Topic::Elements => {
            let row = |kind: ElementKind| (kind.name().to_owned(), element_summary(kind));
            table(
                "Elements, for mesh.element",
                ElementKind::ALL.into_iter().map(row),
            )
        }
        Topic::Solvers => {
            let row = |solver: &SolverInfo| (solver.name.to_owned(), solver_summary(solver));
            table("Solvers, for analysis.solver", SOLVERS.iter().map(row))
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

/// A law or point model: name, summary and parameters.
type Registered = (&'static str, &'static str, &'static [ParameterInfo]);

fn parameters_text(title: &str, rows: impl Iterator<Item = Registered>) -> String {
    let mut text = format!("{title}\n");
    for (name, summary, parameters) in rows {
        // Writing into a string does not fail.
        let _ = writeln!(text, "\n  {name} – {summary}");
        let widths = parameters.iter().map(|parameter| parameter.path.len());
        let width = widths.max().unwrap_or_default();
        for parameter in parameters {
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

fn parameters_value((name, summary, parameters): Registered) -> Value {
    let parameters: Vec<_> = parameters
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
    json!({ "name": name, "summary": summary, "parameters": parameters })
}

fn default_of(parameter: &ParameterInfo) -> String {
    parameter
        .default
        .map_or_else(|| "required".to_owned(), |value| format!("default {value}"))
}

fn value(topic: Topic) -> Value {
    match topic {
        Topic::Loads => keys::loads()
            .map(|(name, summary)| json!({ "name": name, "summary": summary }))
            .collect(),
        Topic::Layups => laminates::layups_value(),
        Topic::Criteria => laminates::criteria_value(),
        Topic::Laws => laws()
            .map(|law| parameters_value((law.name, law.summary, law.parameters)))
            .collect(),
        Topic::Models => point_models()
            .map(|model| parameters_value((model.name, model.summary, model.parameters)))
            .collect(),
        Topic::Templates => templates()
            .map(|template| json!({ "name": template.name, "summary": template.summary }))
            .collect(),
        Topic::Presets => presets::value(),
        Topic::Keys => keys::value(),
        Topic::Elements => ElementKind::ALL
            .into_iter()
            .map(|kind| json!({ "name": kind, "summary": element_summary(kind), "nodes": kind.nodes() }))
            .collect(),
        Topic::Solvers => SOLVERS
            .iter()
            .map(|solver| json!({ "name": solver.name, "summary": solver_summary(solver) }))
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
            let sign = |[quantity, meaning, elsewhere]: [&str; 3]| {
                json!({ "quantity": quantity, "meaning": meaning, "elsewhere": elsewhere })
            };
            let signs: Vec<_> = signs().map(sign).collect();
            json!({ "columns": columns, "signs": signs })
        }
    }
}

fn solver_summary(solver: &SolverInfo) -> String {
    let condition = if solver.experimental {
        " (needs analysis.experimental = true)"
    } else {
        ""
    };
    format!("{}{condition}", solver.summary)
}
