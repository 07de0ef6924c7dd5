//! What is written for programs says the same as the results, in the units that it names.

use std::collections::HashMap;

use serde_json::Value;
use stickslip::folder::{Overwrite, ResultFolder};
use stickslip::{keep, output};

use super::sample::{Sample, Verdict};

/// Half a unit of the twelfth digit, and the rounding of a conversion.
const DIGITS: f64 = 1e-11;

/// Base units in one of each, mm, N or MPa: 1 in = 25.4 mm and 1 lbf = 4.4482216152605 N exactly (NIST SP 811, 2008).
const UNITS: [(&str, f64); 14] = [
    ("mm", 1.0),
    ("cm", 10.0),
    ("m", 1000.0),
    ("in", 25.4),
    ("mil", 0.0254),
    ("N", 1.0),
    ("kN", 1000.0),
    ("lbf", 4.448_221_615_260_5),
    ("kip", 4_448.221_615_260_5),
    ("MPa", 1.0),
    ("GPa", 1000.0),
    ("psi", 4.448_221_615_260_5 / (25.4 * 25.4)),
    ("ksi", 4_448.221_615_260_5 / (25.4 * 25.4)),
    ("Pa", 1e-6),
];

fn in_base(unit: &str) -> Option<f64> {
    UNITS
        .iter()
        .find(|(name, _)| *name == unit)
        .map(|(_, factor)| *factor)
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
    if steps.len() != sample.scene.steps() {
        return Some(format!(
            "{} steps written, {} asked for",
            steps.len(),
            sample.scene.steps()
        ));
    }
    for (index, (step, written)) in sample.results.steps.iter().zip(steps).enumerate() {
        for (geometry, edge) in sample
            .results
            .edges
            .iter()
            .zip(&step.edges)
            .filter(|(geometry, _)| geometry.contact)
        {
            let peak = edge.rows.iter().map(|row| row.pressure).fold(0.0, f64::max);
            let own = &written["edges"][&geometry.name];
            let normal = (
                quantity(&own["normal_force"]),
                edge.normal_force,
                "normal_force",
            );
            let pressure = (quantity(&own["peak_pressure"]), peak, "peak_pressure");
            for (value, exact, key) in [normal, pressure] {
                if apart(value.unwrap_or(0.0), exact) {
                    let name = &geometry.name;
                    return Some(format!(
                        "step {}, '{name}': {key} is {value:?} written and {exact:e}",
                        index + 1
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
                return Some(format!(
                    "step {}: load '{}' is {value:e} written and {exact:e}",
                    index + 1,
                    asked.name
                ));
            }
        }
    }
    None
}

fn tables(sample: &Sample) -> Option<String> {
    let place = tempfile::tempdir().ok()?;
    let wrong = |error: &dyn std::fmt::Display| Some(format!("not written: {error}"));
    let folder = match ResultFolder::create(&place.path().join("out"), Overwrite::Refuse) {
        Ok(folder) => folder,
        Err(error) => return wrong(&error),
    };
    let path = match keep::results(&sample.results, folder, false) {
        Ok(path) => path,
        Err(error) => return wrong(&error),
    };
    for (index, geometry) in sample
        .results
        .edges
        .iter()
        .enumerate()
        .filter(|(_, geometry)| geometry.contact)
    {
        for (step, results) in sample.results.steps.iter().enumerate() {
            let width = sample.results.steps.len().to_string().len().max(2);
            let file = path.join(format!(
                "edge-{}-step-{:0width$}.csv",
                geometry.name,
                step + 1
            ));
            let Some(columns) = columns(&file) else {
                return Some(format!("{} cannot be read", file.display()));
            };
            for (heading, value) in [
                (
                    "CPRESS",
                    (|row| row.pressure) as fn(&stickslip::results::EdgeRow) -> f64,
                ),
                ("CSHEAR1", |row| row.shear),
                ("COPEN", |row| row.gap),
                ("CSLIP1", |row| row.slip),
            ] {
                let Some(column) = columns.get(heading) else {
                    return Some(format!("{}: no column {heading}", file.display()));
                };
                for (written, row) in column.iter().zip(&results.edges[index].rows) {
                    if apart(*written, value(row)) {
                        return Some(format!(
                            "{heading}: {written:e} written and {:e}",
                            value(row)
                        ));
                    }
                }
            }
        }
    }
    None
}

/// Columns of numbers by the first word of their heading, in base units.
fn columns(file: &std::path::Path) -> Option<HashMap<String, Vec<f64>>> {
    let mut reader = csv::Reader::from_path(file).ok()?;
    let headings: Vec<(String, f64)> = reader
        .headers()
        .ok()?
        .iter()
        .map(|heading| {
            let (name, unit) = heading.split_once(" [").unwrap_or((heading, ""));
            (
                name.to_owned(),
                in_base(unit.trim_end_matches(']')).unwrap_or(1.0),
            )
        })
        .collect();
    let mut columns: HashMap<String, Vec<f64>> = HashMap::new();
    for record in reader.records() {
        for ((name, factor), cell) in headings.iter().zip(record.ok()?.iter()) {
            let number = cell.parse::<f64>().unwrap_or(f64::NAN) * factor;
            columns.entry(name.clone()).or_default().push(number);
        }
    }
    Some(columns)
}
