//! What is written for programs says the same as the results, in the units that it names.

use std::collections::HashMap;

use serde_json::Value;
use stickslip::folder::{Overwrite, ResultFolder};
use stickslip::results::{EdgeGeometry, EdgeRow};
use stickslip::{keep, output};

use super::sample::{Sample, Verdict};

/// Half a unit of the twelfth digit, and the rounding of a conversion.
const DIGITS: f64 = 1e-11;

/// Base units in one of each, mm, N or MPa: 1 in = 25.4 mm and 1 lbf = 4.4482216152605 N exactly (NIST SP 811, 2008).
fn in_base(unit: &str) -> Option<f64> {
    const INCH: f64 = 25.4;
    const POUND: f64 = 4.448_221_615_260_5;
    Some(match unit {
        "mm" | "N" | "MPa" => 1.0,
        "cm" => 10.0,
        "m" | "kN" | "GPa" => 1000.0,
        "Pa" => 1e-6,
        "in" => INCH,
        "mil" => 1e-3 * INCH,
        "lbf" => POUND,
        "kip" => 1e3 * POUND,
        "psi" => POUND / (INCH * INCH),
        "ksi" => 1e3 * POUND / (INCH * INCH),
        _ => return None,
    })
}

/// `summary.json` and the tables of the edges against the results.
pub(super) fn written(sample: &Sample) -> Verdict {
    summary(sample)
        .or_else(|| tables(sample))
        .map_or(Verdict::Holds, Verdict::Fails)
}

fn apart(written: f64, exact: f64) -> bool {
    (written - exact).abs() > DIGITS * exact.abs().max(written.abs())
}

fn quantity(value: &Value) -> Option<f64> {
    Some(value["value"].as_f64()? * in_base(value["unit"].as_str()?)?)
}

fn summary(sample: &Sample) -> Option<String> {
    let summary = match output::summary_json(&sample.results) {
        Ok(summary) => summary,
        Err(error) => return Some(error.to_string()),
    };
    let steps = summary["steps"].as_array()?;
    let (count, asked) = (steps.len(), sample.scene.steps());
    if count != asked {
        return Some(format!("{count} steps written, {asked} asked for"));
    }
    for (index, (step, written)) in sample.results.steps.iter().zip(steps).enumerate() {
        let place = format!("step {}", index + 1);
        for (edge, EdgeGeometry { name, .. }) in sample.contacts() {
            let (edge, own) = (&step.edges[edge], &written["edges"][name]);
            let peak = edge.rows.iter().map(|row| row.pressure).fold(0.0, f64::max);
            for (key, exact) in [("normal_force", edge.normal_force), ("peak_pressure", peak)] {
                let value = quantity(&own[key]);
                if apart(value.unwrap_or(0.0), exact) {
                    return Some(format!(
                        "{place}, '{name}': {key} is {value:?} written and {exact:e}"
                    ));
                }
            }
        }
        for (load, asked) in written["loads"].as_array()?.iter().zip(&sample.scene.loads) {
            let factor = match load["unit"].as_str()? {
                "K" | "1" => 1.0,
                unit => in_base(unit)?,
            };
            let (value, exact) = (load["value"].as_f64()? * factor, asked.kind.steps()[index]);
            if apart(value, exact) {
                let name = &asked.name;
                return Some(format!(
                    "{place}: load '{name}' is {value:e} written and {exact:e}"
                ));
            }
        }
    }
    None
}

type Quantity = fn(&EdgeRow) -> f64;

/// What the tables of edges have, and what the results do.
const COLUMNS: [(&str, Quantity); 4] = [
    ("CPRESS", |row| row.pressure),
    ("CSHEAR1", |row| row.shear),
    ("COPEN", |row| row.gap),
    ("CSLIP1", |row| row.slip),
];

fn tables(sample: &Sample) -> Option<String> {
    let place = tempfile::tempdir().ok()?;
    let folder = ResultFolder::create(&place.path().join("out"), Overwrite::Refuse);
    let wrong = |error: &dyn std::fmt::Display| Some(format!("not written: {error}"));
    let path = match folder.map(|folder| keep::results(&sample.results, folder, false)) {
        Ok(Ok(path)) => path,
        Ok(Err(error)) => return wrong(&error),
        Err(error) => return wrong(&error),
    };
    let width = sample.results.steps.len().to_string().len().max(2);
    for (index, EdgeGeometry { name, .. }) in sample.contacts() {
        for (step, results) in sample.results.steps.iter().enumerate() {
            let file = path.join(format!("edge-{name}-step-{:0width$}.csv", step + 1));
            let Some(columns) = columns(&file) else {
                return Some(format!("{} cannot be read", file.display()));
            };
            for (heading, value) in COLUMNS {
                let Some(column) = columns.get(heading) else {
                    return Some(format!("{}: no column {heading}", file.display()));
                };
                let exact = results.edges[index].rows.iter().map(value);
                let mut pairs = column.iter().zip(exact);
                if let Some((written, exact)) =
                    pairs.find(|(written, exact)| apart(**written, *exact))
                {
                    return Some(format!("{heading}: {written:e} written and {exact:e}"));
                }
            }
        }
    }
    None
}

/// Columns of numbers by the first word of their heading, in base units.
fn columns(file: &std::path::Path) -> Option<HashMap<String, Vec<f64>>> {
    let mut reader = csv::Reader::from_path(file).ok()?;
    let heading = |heading: &str| {
        let (name, unit) = heading.split_once(" [").unwrap_or((heading, ""));
        let factor = in_base(unit.trim_end_matches(']'));
        (name.to_owned(), factor.unwrap_or(1.0))
    };
    let headings: Vec<(String, f64)> = reader.headers().ok()?.iter().map(heading).collect();
    let mut columns: HashMap<String, Vec<f64>> = HashMap::new();
    for record in reader.records() {
        for ((name, factor), cell) in headings.iter().zip(record.ok()?.iter()) {
            let number = cell.parse::<f64>().unwrap_or(f64::NAN) * factor;
            columns.entry(name.clone()).or_default().push(number);
        }
    }
    Some(columns)
}
