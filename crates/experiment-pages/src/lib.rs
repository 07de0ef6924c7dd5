//! What was found in measured displacements, as one page with its files: tables, figures and answers.
//!
//! [`report`](fn@report) goes through the chain of an experiment and fills an [`ExperimentReport`], which hands each file as name and bytes to its
//! caller; nothing here touches a file.
//!
//! [`check`](check::check) says what an experiment would be analysed from, before anything is solved:
//!
//! ```
//! use std::path::Path;
//! use stickslip_experiment_pages::{check::check, stickslip_experiment::Experiment};
//! use stickslip_scene::{Format, host::{Host, MemoryFiles}};
//!
//! let scene = r#"
//! version = 1
//! materials.epoxy.isotropic = { young = "3 GPa", poisson = 0.36 }
//! mesh.spacing = "6 deg"
//! loads = [{ on = "plate.left", force = { direction = [-1, 0], steps = ["300 N"] } }]
//! supports = [{ on = "plate.right", fix = ["x", "y"] }]
//! [bodies.plate]
//! material = "epoxy"
//! thickness = "4 mm"
//! shape.plate_with_hole = { hole_radius = "6 mm", outline.strip = { half_width = "24 mm", left = "48 mm", right = "48 mm" } }
//! "#;
//! let experiment = r#"
//! version = 1
//! specimen = { scene = "plate.toml", body = "plate", edge = "hole" }
//! grating.frequency = "1200 1/mm"
//! fringes = { window = [["-9 mm", "-9 mm"], ["9 mm", "9 mm"]], pixel = "0.05 mm" }
//! states = [{ name = "pulled", step = 1 }]
//! region.sector = { angles = ["20 deg", "160 deg"], outer = "8.5 mm", cells = [24, 6] }
//! "#;
//! let host = Host::of(MemoryFiles::from_iter([("plate.toml", scene)]));
//! let experiment =
//!     Experiment::from_text(experiment, Format::Toml, "pull.toml", Path::new(""), &[""; 0], host)?;
//! let lines = check(&experiment)?.lines;
//! assert_eq!(lines[2], ("state", "pulled: synthetic pictures of the scene, not made here".to_owned()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod analysed;
pub mod check;
pub mod findings;
mod gallery;
mod identified;
pub mod laws;
mod measured;
pub mod report;
pub mod whole;

use std::path::Path;

use stickslip_engine::run::Progress;
use stickslip_experiment::Experiment;
use stickslip_measure::ExperimentError;
use stickslip_measure::chain::{self, Album, Depth};
use stickslip_measure::finding::ignored_keys;
use stickslip_measure::synthesis::{Camera, Shots};

/// The crates of experiments, findings, figures, runs and values that pages show.
pub use {serde_json, stickslip_engine, stickslip_experiment, stickslip_measure, stickslip_report};

use gallery::Gallery;
use identified::FrictionResults;
use report::ExperimentReport;

/// Goes through the chain of `experiment` down to `depth`, and reports it. Files of the report that name others do so from `folder`, where it
/// will be written.
///
/// # Errors
/// [`ExperimentError`] of the stage that fails.
pub fn report(
    experiment: &Experiment,
    depth: Depth,
    folder: &Path,
    progress: &mut dyn FnMut(Progress),
) -> Result<ExperimentReport, ExperimentError> {
    let mut album = Pages {
        gallery: Gallery::new(experiment),
        report: ExperimentReport::new(experiment),
        folder,
    };
    let found = chain::run(experiment, depth, &mut album, progress)?;
    let mut report = album.report;
    let truth = found.truth.as_ref();
    if depth >= Depth::Reduce {
        report.findings(experiment, ignored_keys(experiment));
        measured::report(experiment, &found.fields, &mut report);
    }
    let Some(edges) = &found.edges else {
        return Ok(report);
    };
    analysed::report(experiment, &edges.analysed, truth, &mut report);
    whole::report(experiment, edges, &mut report);
    if let Some(friction) = &found.friction {
        let results = FrictionResults {
            experiment,
            analysed: &edges.analysed,
            friction,
            truth,
        };
        identified::report(&results, &mut report);
        if let Some(stage) = &friction.laws {
            laws::report(experiment, stage, &mut report);
        }
    }
    Ok(report)
}

/// Synthetic pictures on their way to the page.
struct Pages<'a> {
    gallery: Gallery<'a>,
    report: ExperimentReport,
    folder: &'a Path,
}

impl Album for Pages<'_> {
    fn add(
        &mut self,
        camera: &Camera<'_>,
        state: usize,
        shots: &Shots,
    ) -> Result<(), ExperimentError> {
        self.gallery.add(camera, state, shots, &mut self.report)
    }

    fn complete(&mut self, camera: &Camera<'_>) {
        self.gallery.report(camera, self.folder, &mut self.report);
    }
}
