//! Sweeps over a drawn joint: interrupted and resumed, and against single runs of their cases.

use std::num::NonZeroUsize;
use std::sync::atomic::AtomicBool;

use serde_json::{Value, json};
use stickslip::host::HOST;
use stickslip::sweep::row::{Outcome, Row};
use stickslip::sweep::{Sweep, engine, table};

use super::quantity;
use super::sample::{Sample, Verdict, declared, run};
use crate::publish::TaskError;

/// Rounding and the solvers' residuals, as for relations: a sweep condenses a body of another size.
const EXACT: f64 = 1e-7;

/// A sweep of four cases over friction and clearance; its table, cut anywhere and gone on with, ends the same, and each case has the
/// peak pressure of a single run.
pub(super) fn resumed(sample: &Sample) -> Verdict {
    let Some(text) = sweep_text(sample) else {
        return Verdict::Beside;
    };
    match compared(sample, &text) {
        Ok(verdict) => verdict,
        Err(error) => Verdict::Fails(error.to_string()),
    }
}

/// A sweep over the pin in the plate; `None` where the scene has none with clearance.
fn sweep_text(sample: &Sample) -> Option<Value> {
    let contacts = sample.value.get("contacts")?.as_array()?;
    let only = contacts.first().filter(|_| contacts.len() == 1)?;
    let (plate, _) = only["first"].as_str()?.split_once('.')?;
    let (pin, set) = only["second"].as_str()?.split_once('.')?;
    let hole = quantity::number(
        &sample.value,
        &format!("/bodies/{plate}/shape/plate_with_hole/hole_radius"),
    )?;
    let rim = quantity::number(&sample.value, &format!("/bodies/{pin}/shape/disk/radius"))?;
    (set == "rim" && rim < hole).then(|| {
        json!({
            "version": 1,
            "scene": "scene.json",
            "axes": [
                { "key": "mu", "values": [0.05, 0.25] },
                { "key": "clearance", "values": [quantity::mm(hole - rim), quantity::mm(0.5 * (hole - rim))] },
            ],
        })
    })
}

/// The comparison with single runs, after the peak pressures of the sweep were multiplied by `factor`.
#[cfg(test)]
pub(super) fn tampered(sample: &Sample, factor: f64) -> Result<Verdict, TaskError> {
    let text = sweep_text(sample).ok_or("no sweep")?;
    let (sweep, _folder) = made(sample, &text)?;
    let mut rows = rows(&sweep, &(0..sweep.cases()).collect::<Vec<_>>())?;
    for row in &mut rows {
        if let Outcome::Solved(measures) = &mut row.outcome {
            measures.peak_pressure = measures.peak_pressure.map(|peak| factor * peak);
        }
    }
    single(&sweep, &rows)
}

/// The sweep, and the folder in which its scene lies.
fn made(sample: &Sample, text: &Value) -> Result<(Sweep, tempfile::TempDir), TaskError> {
    let folder = tempfile::tempdir()?;
    std::fs::write(folder.path().join("scene.json"), sample.value.to_string())?;
    let path = folder.path().join("sweep.json");
    std::fs::write(&path, text.to_string())?;
    Ok((Sweep::from_file(&path, &[] as &[&str], HOST)?, folder))
}

fn compared(sample: &Sample, text: &Value) -> Result<Verdict, TaskError> {
    let (sweep, _folder) = made(sample, text)?;
    let all: Vec<usize> = (0..sweep.cases()).collect();
    let whole = rows(&sweep, &all)?;
    let written = table::text(&sweep, &whole)?;
    // Cut where a killed process may have stopped writing: within the last row that it began.
    let cut = written.len() * (2 + sample.results.steps.len() % 5) / 7;
    let part = String::from_utf8_lossy(&written[..cut]);
    let mut resumed = table::read(&sweep, &part)?;
    let pending: Vec<usize> = all
        .into_iter()
        .filter(|case| resumed.iter().all(|row| row.case != *case))
        .collect();
    resumed.extend(rows(&sweep, &pending)?);
    resumed.sort_by_key(|row| row.case);
    for (own, other) in whole.iter().zip(&resumed) {
        if own.case != other.case || own.outcome != other.outcome {
            return Ok(Verdict::Fails(format!(
                "case {}: {:?}, resumed {:?}",
                own.case, own.outcome, other.outcome
            )));
        }
    }
    single(&sweep, &whole)
}

/// The rows of `cases`, by case.
fn rows(sweep: &Sweep, cases: &[usize]) -> Result<Vec<Row>, TaskError> {
    let mut rows = Vec::new();
    let stop = AtomicBool::new(false);
    let keep = &mut |row: Row| {
        rows.push(row);
        Ok(())
    };
    engine::run(sweep, cases, NonZeroUsize::MIN, &stop, keep)?;
    rows.sort_by_key(|row| row.case);
    Ok(rows)
}

/// The first case that a single run answers otherwise.
fn single(sweep: &Sweep, rows: &[Row]) -> Result<Verdict, TaskError> {
    for row in rows {
        let scene = sweep.scene_of(row.case)?;
        let name = sweep.name_of(row.case);
        let (found, results) = match (&row.outcome, run(&scene)) {
            (Outcome::Solved(measures), Ok(results)) => {
                (measures.peak_pressure.unwrap_or(0.0), results)
            }
            (Outcome::Unresolved(_), Err(_)) => continue,
            (Outcome::Solved(_), Err(none)) => {
                return Ok(Verdict::Fails(format!("{name}: alone {}", none.describe())));
            }
            (Outcome::Unresolved(why), Ok(_)) => {
                return Ok(Verdict::Fails(format!("{name}: solved alone; {why}")));
            }
        };
        let peaks = results
            .steps
            .iter()
            .map(|step| step.edges[sweep.contact].peak_pressure)
            // Without contact neither a step nor a row has a peak.
            .map(|peak| peak.map_or(0.0, |(peak, _)| peak));
        let most = peaks.clone().fold(0.0, f64::max);
        // The row is that of the largest load, whichever step that is.
        let near = peaks.map(|peak| (peak - found).abs()).fold(most, f64::min);
        if near > EXACT * most {
            let message =
                format!("{name}: a peak of {found:e} MPa, alone none nearer than {near:e}");
            return Ok(declared(&results).map_or(Verdict::Fails(message), Verdict::Declared));
        }
    }
    Ok(Verdict::Holds)
}
