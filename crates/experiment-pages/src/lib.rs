//! What was found in measured displacements, as one page with its files: tables, figures and answers.
//!
//! [`report`](fn@report) goes through the chain of an experiment and fills an [`ExperimentReport`], which hands each file as name and bytes to its
//! caller; nothing here touches a file.

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
