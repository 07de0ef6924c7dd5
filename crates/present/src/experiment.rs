//! What was found in measured displacements, as one page with its files.

mod analysed;
pub mod check;
pub mod findings;
mod gallery;
mod identified;
pub mod laws;
mod measured;
pub mod story;
pub mod whole;

use std::path::Path;

use stickslip_engine::run::Progress;
use stickslip_measure::ExperimentError;
use stickslip_measure::chain::{self, Album, Depth};
use stickslip_measure::finding::ignored_keys;
use stickslip_measure::synthesis::{Camera, Shots};
use stickslip_scene::experiment::Experiment;

use gallery::Gallery;
use identified::Told;
use story::Story;

/// Goes through the chain of `experiment` down to `depth`, and reports it. Files of the story that name others do so from `folder`, where it
/// will be written.
///
/// # Errors
/// [`ExperimentError`] of the stage that fails.
pub fn tell(
    experiment: &Experiment,
    depth: Depth,
    folder: &Path,
    progress: &mut dyn FnMut(Progress),
) -> Result<Story, ExperimentError> {
    let mut album = Pages {
        gallery: Gallery::new(experiment),
        story: Story::new(experiment),
        folder,
    };
    let found = chain::run(experiment, depth, &mut album, progress)?;
    let mut story = album.story;
    let truth = found.truth.as_ref();
    if depth >= Depth::Reduce {
        story.report(experiment, ignored_keys(experiment));
        measured::tell(experiment, &found.fields, &mut story);
    }
    let Some(edges) = &found.edges else {
        return Ok(story);
    };
    analysed::tell(experiment, &edges.analysed, truth, &mut story);
    whole::tell(experiment, edges, &mut story);
    if let Some(friction) = &found.friction {
        let told = Told {
            experiment,
            analysed: &edges.analysed,
            friction,
            truth,
        };
        identified::tell(&told, &mut story);
        if let Some(stage) = &friction.laws {
            laws::tell(experiment, stage, &mut story);
        }
    }
    Ok(story)
}

/// Synthetic pictures on their way to the page.
struct Pages<'a> {
    gallery: Gallery<'a>,
    story: Story,
    folder: &'a Path,
}

impl Album for Pages<'_> {
    fn add(
        &mut self,
        camera: &Camera<'_>,
        state: usize,
        shots: &Shots,
    ) -> Result<(), ExperimentError> {
        self.gallery.add(camera, state, shots, &mut self.story)
    }

    fn complete(&mut self, camera: &Camera<'_>) {
        self.gallery.tell(camera, self.folder, &mut self.story);
    }
}
