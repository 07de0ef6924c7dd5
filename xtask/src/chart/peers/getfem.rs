//! GetFEM through the system's Python: writes the job, runs a script on it, reads the displacements.

use std::process::Command;

use serde::{Deserialize, Serialize};
use stickslip_fem_core::mesh::{ElementKind, Point};

use super::PeerRun;
use super::job::{Cost, Job, POISSON, Part, Steps, YOUNG, wait};
use crate::publish::TaskError;

const SCRIPT: &str = include_str!("getfem.py");
/// Contact, elements and spacings `[deg]` that it is run on.
const FAMILIES: [(&str, ElementKind, &[f64]); 4] = [
    ("ray tracing", ElementKind::Q4, &[9.0, 4.5, 2.25, 1.125]),
    ("ray tracing", ElementKind::Q8, &[9.0, 4.5]),
    ("projection", ElementKind::Q4, &[9.0, 4.5, 2.25, 1.125]),
    ("projection", ElementKind::Q8, &[9.0, 4.5, 2.25]),
];
/// Release distance of the ray tracing `[mm]`: larger than any gap of the job.
const RELEASE: f64 = 0.5;

/// What Python's `getfem` says, if it is installed.
pub(super) fn version() -> Option<String> {
    let program = "import getfem; print(getfem.getfem_env('version'))";
    let output = python().args(["-c", program]).output().ok()?;
    let number = String::from_utf8_lossy(&output.stdout);
    output
        .status
        .success()
        .then(|| format!("GetFEM {}", number.trim()).trim().to_owned())
}

/// The Python that a distribution's package belongs to.
fn python() -> Command {
    let system = "/usr/bin/python3";
    let exists = std::path::Path::new(system).exists();
    Command::new(if exists { system } else { "python3" })
}

#[derive(Serialize)]
struct Body {
    points: Vec<Point>,
    cells: Vec<Vec<usize>>,
    contact: Vec<usize>,
    symmetry: Vec<usize>,
    pulled: Vec<usize>,
    centre: Vec<usize>,
}

#[derive(Serialize)]
struct Input {
    contact: &'static str,
    order: usize,
    mu: f64,
    young: f64,
    poisson: f64,
    release: f64,
    length: f64,
    tractions: Vec<f64>,
    plate: Body,
    pin: Body,
}

#[derive(Deserialize)]
struct Output {
    steps: Steps,
    iterations: usize,
    wall: f64,
    cpu: f64,
}

/// Runs all families without and with friction.
pub(super) fn runs(version: &str) -> Result<Vec<PeerRun>, TaskError> {
    let mut runs = Vec::new();
    for mu in [0.0, 0.25] {
        for (contact, element, spacings) in FAMILIES {
            for &spacing in spacings {
                let job = Job::new(mu, element, spacing)?;
                let (output, waited) = follow(&job_of(&job, contact)?)?;
                let (cost, steps, iterations) = match output {
                    Some(output) => {
                        let (wall, cpu) = (output.wall, Some(output.cpu));
                        (Cost { wall, cpu }, output.steps, Some(output.iterations))
                    }
                    None => (waited, Vec::new(), None),
                };
                let contact = format!("{contact}, augmented Lagrangian");
                let element = format!("{element:?}");
                let run = job.peer_run(version, contact, element, cost, &steps)?;
                runs.push(PeerRun { iterations, ..run });
            }
        }
    }
    Ok(runs)
}

/// Runs the script: what it found, unless it ended early, and what it took with all imports.
fn follow(input: &Input) -> Result<(Option<Output>, Cost), TaskError> {
    let folder = tempfile::tempdir()?;
    let [script, job, result] =
        ["run.py", "job.json", "result.json"].map(|name| folder.path().join(name));
    let text = serde_json::to_string(input)?;
    std::fs::write(&script, SCRIPT)?;
    std::fs::write(&job, text)?;
    let cost = wait(
        python()
            .args([&script, &job, &result])
            .current_dir(folder.path())
            .env("OMP_NUM_THREADS", "1"),
    )?;
    let output = std::fs::read_to_string(&result)
        .ok()
        .and_then(|text| serde_json::from_str(&text).ok());
    Ok((output, cost))
}

fn job_of(job: &Job, contact: &'static str) -> Result<Input, TaskError> {
    let [low, high] = job.body(Part::Plate).mesh().bounding_box();
    Ok(Input {
        contact,
        order: job.element.order(),
        mu: job.mu,
        young: YOUNG,
        poisson: POISSON,
        release: RELEASE,
        length: high[1] - low[1],
        tractions: job.tractions(),
        plate: body_of(job, Part::Plate)?,
        pin: body_of(job, Part::Pin)?,
    })
}

/// A body in its own numbering.
fn body_of(job: &Job, part: Part) -> Result<Body, TaskError> {
    let mesh = job.body(part).mesh();
    let [first, _] = job.offsets(part);
    let own = |set: &str| -> Result<Vec<usize>, TaskError> {
        let nodes = job.nodes(part, set)?;
        Ok(nodes.iter().map(|node| node - first).collect())
    };
    let cells = (0..mesh.element_count()).map(|cell| mesh.element(cell).1.to_vec());
    let is_plate = part == Part::Plate;
    Ok(Body {
        points: mesh.nodes().to_vec(),
        cells: cells.collect(),
        contact: own(if is_plate { "hole" } else { "rim" })?,
        symmetry: own("symmetry")?,
        pulled: if is_plate { own("left")? } else { Vec::new() },
        centre: if is_plate { Vec::new() } else { own("centre")? },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_body_is_numbered_from_zero() {
        let job = Job::new(0.0, ElementKind::Q8, 9.0).unwrap();
        for part in [Part::Plate, Part::Pin] {
            let body = body_of(&job, part).unwrap();
            let count = body.points.len();
            assert!(body.cells.iter().flatten().all(|&node| node < count));
            assert_eq!(body.contact.len(), 41);
            for &node in &body.symmetry {
                assert!(body.points[node][1].abs() < 1e-9);
            }
        }
    }
}
