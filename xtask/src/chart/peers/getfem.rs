//! GetFEM through the system's Python: writes the job, runs a script on it, reads the displacements.

use std::process::{Command, Stdio};

use serde::{Deserialize, Serialize};
use stickslip_fem_core::mesh::{ElementKind, Point};

use super::job::{COMPARED, Job, POISSON, Part, YOUNG, wait};
use super::{LOAD_STEPS, PeerRun};
use crate::chart::Trouble;

const SCRIPT: &str = include_str!("getfem.py");
/// Elements and spacings `[deg]` that it is run on.
const FAMILIES: [(ElementKind, &[f64]); 2] = [
    (ElementKind::Q4, &[9.0, 4.5, 2.25]),
    (ElementKind::Q8, &[9.0]),
];
/// Release distance of the ray tracing `[mm]`: larger than any gap of the job.
const RELEASE: f64 = 0.5;

/// What Python's `getfem` says, if it is installed.
pub(super) fn version() -> Option<String> {
    let program =
        "import getfem; print(getfem.__version__ if hasattr(getfem, '__version__') else '')";
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
    steps: Vec<Vec<[f64; 2]>>,
    iterations: usize,
    seconds: f64,
}

/// Runs both elements without and with friction.
pub(super) fn runs(version: &str) -> Result<Vec<PeerRun>, Trouble> {
    let mut runs = Vec::new();
    for mu in [0.0, 0.25] {
        for (element, spacings) in FAMILIES {
            for &spacing in spacings {
                runs.push(run(&Job::new(mu, element, spacing)?, version)?);
            }
        }
    }
    Ok(runs)
}

fn run(job: &Job, version: &str) -> Result<PeerRun, Trouble> {
    let fail = |cause: &dyn std::fmt::Display| Trouble::Peer(cause.to_string());
    let folder = tempfile::tempdir().map_err(|cause| fail(&cause))?;
    let [script, input, result] =
        ["run.py", "job.json", "result.json"].map(|name| folder.path().join(name));
    let text = serde_json::to_string(&job_of(job)?).map_err(|cause| fail(&cause))?;
    std::fs::write(&script, SCRIPT).map_err(|cause| fail(&cause))?;
    std::fs::write(&input, text).map_err(|cause| fail(&cause))?;
    let child = python()
        .args([&script, &input, &result])
        .current_dir(folder.path())
        .env("OMP_NUM_THREADS", "1")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .map_err(|cause| fail(&cause))?;
    let (_, waited) = wait(child)?;
    let output = std::fs::read_to_string(&result)
        .ok()
        .and_then(|text| serde_json::from_str::<Output>(&text).ok())
        .unwrap_or(Output {
            steps: Vec::new(),
            iterations: 0,
            seconds: waited,
        });
    let peak = output
        .steps
        .get(COMPARED)
        .map(|u| job.peak_pressure(u))
        .transpose()?;
    eprintln!(
        "  {version}, {:?}, μ = {}, {}°: {:.2} s, {} of {LOAD_STEPS} steps",
        job.element,
        job.mu,
        job.spacing,
        output.seconds,
        output.steps.len()
    );
    Ok(PeerRun {
        program: version.to_owned(),
        contact: "ray tracing, augmented Lagrangian".into(),
        element: format!("{:?}", job.element),
        mu: job.mu,
        spacing_deg: job.spacing,
        unknowns: job.unknowns(),
        steps_converged: output.steps.len(),
        peak_pressure_psi: peak,
        contact_half_angle_deg: None,
        hoop_at_90_deg_psi: None,
        shear_ratio: None,
        wall_s: output.seconds,
        cpu_s: None,
        factorisation_s: None,
        cpu_over_factorisation: None,
        yardstick_s: 0.0,
        iterations: Some(output.iterations),
        measured: String::new(),
    })
}

fn job_of(job: &Job) -> Result<Input, Trouble> {
    let [low, high] = job.body(Part::Plate).mesh().bounding_box();
    Ok(Input {
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
fn body_of(job: &Job, part: Part) -> Result<Body, Trouble> {
    let mesh = job.body(part).mesh();
    let [first, _] = job.offsets(part);
    let own = |set: &str| -> Result<Vec<usize>, Trouble> {
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
