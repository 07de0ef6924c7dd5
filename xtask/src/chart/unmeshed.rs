//! The pin benchmark without a mesh: bodies by series with given nodes, and the ladder, which chooses them.

use std::fs;
use std::time::Instant;

use stickslip::host::HOST;
use stickslip::results::{Results, Stated};
use stickslip::scene::{Format, Scene};
use stickslip_contact::SemismoothNewton;
use stickslip_laboratory::measure::{summary, thread_seconds};
use stickslip_laboratory::run::{Path, run};

use super::curve::Point;
use super::peers::undeformed_error;
use super::summary::JOBS;
use crate::publish::{TaskError, root};

/// Nodes on half of the circle.
const NODES: [usize; 6] = [16, 31, 61, 121, 241, 481];
/// Accuracies that are asked of the peak pressure.
const ASKED: [&str; 6] = ["5 %", "1 %", "0.5 %", "0.1 %", "0.05 %", "0.01 %"];
const RUNS: usize = 5;

/// Time of the whole history over the error of the peak pressure, as other programs are judged.
#[derive(Clone, Debug)]
pub(super) struct Unmeshed {
    pub(super) mu: f64,
    pub(super) label: &'static str,
    pub(super) points: Vec<Point>,
}

/// Measures both kinds with and without friction; with `quick` two points of each, run once.
pub(super) fn measure(quick: bool) -> Result<Vec<Unmeshed>, TaskError> {
    let text = without_mesh()?;
    let (count, runs) = if quick { (2, 1) } else { (NODES.len(), RUNS) };
    let mut measured = Vec::new();
    for (mu, _) in JOBS {
        let friction = format!("contacts.0.friction.coulomb.mu={mu}");
        let point = |setting: String, solve: &dyn Fn(&Scene) -> Result<Results, TaskError>| {
            let settings = [
                friction.clone(),
                "analysis.kinematics=small".into(),
                setting,
            ];
            let scene = scene(&text, &settings)?;
            timed(mu, runs, || solve(&scene))
        };
        let newton = SemismoothNewton::default();
        let series = |scene: &Scene| Ok(run(scene, Path::Condensed(&newton))?.results);
        let nodes = NODES[..count].iter();
        measured.push(Unmeshed {
            mu,
            label: "series",
            points: nodes
                .map(|nodes| point(format!("analysis.contact_nodes={nodes}"), &series))
                .collect::<Result<_, TaskError>>()?,
        });
        let ladder = |scene: &Scene| Ok(stickslip::run::run(scene, &mut |_| {})?);
        let asked = ASKED[..count].iter();
        measured.push(Unmeshed {
            mu,
            label: "ladder",
            points: asked
                .map(|asked| {
                    let asked = format!("analysis.accuracy={{ peak_pressure = \"{asked}\" }}");
                    point(asked, &ladder)
                })
                .collect::<Result<_, TaskError>>()?,
        });
    }
    Ok(measured)
}

/// The benchmark's scene, one increment for each load step as in the reference.
fn without_mesh() -> Result<String, TaskError> {
    let text = fs::read_to_string(root().join("scenes/pin-benchmark.toml"))?;
    let from = text.find("[mesh]").ok_or("the benchmark has no mesh")?;
    let to = text[from..].find("\n\n").map_or(text.len(), |to| from + to);
    let analysis = "\n[analysis]\nsubsteps = 1\n\n[output]\nfields = \"none\"\nfigures = false\n";
    Ok(text[..from].to_owned() + &text[to..] + analysis)
}

fn scene(text: &str, settings: &[String]) -> Result<Scene, TaskError> {
    let folder = root().join("scenes");
    let name = "pin-benchmark.toml";
    Ok(Scene::from_text_on(
        text,
        Format::Toml,
        name,
        &folder,
        settings,
        HOST,
    )?)
}

/// Median processor time of `runs` runs, and the error of the last.
fn timed(
    mu: f64,
    runs: usize,
    solve: impl Fn() -> Result<Results, TaskError>,
) -> Result<Point, TaskError> {
    let (mut samples, mut peak) = (Vec::new(), None);
    for _ in 0..runs {
        let (wall, before) = (Instant::now(), thread_seconds());
        let results = solve()?;
        let used = before.zip(thread_seconds()).map(|(start, end)| end - start);
        samples.push(used.unwrap_or_else(|| wall.elapsed().as_secs_f64()));
        peak = Stated::PeakPressure.value(&results.steps[3].edges[0]);
    }
    let peak = peak.ok_or("the benchmark has no pressure")?;
    Ok(Point {
        cost: summary(&samples).median,
        error: undeformed_error(mu, peak),
    })
}
