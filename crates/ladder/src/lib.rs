//! The ladder: finer and finer models of a scene until the estimated errors meet what is asked.
//!
//! ```text
//! Scene ──► model of a rung ──► run ──► numbers ──► errors met? ──► Results with their errors
//!               ▲                                      │ no
//!               └────────── finer, graded ◄────────────┘
//! ```
//!
//! The error of a number v has three parts:
//!
//! ```text
//! error = |v(division) − limit| + |v(increments) − limit| + |v(small displacement) − v(deformed gaps)|
//! ```
//!
//! | part | by |
//! | --- | --- |
//! | of the division | what two or three models of finer and finer nodes or cells change |
//! | of the load path | what halving the increments changes, on a coarse model, and on the last one where the scene gives its increments |
//! | of the geometry, where it is left to the program | a multiple of the difference that deformed gaps make: on a coarse model, of elements on the last one |
//!
//! docs/accuracy.md shows how often the truth lies within.

mod along;
mod before;
mod budget;
mod climb;
mod division;
mod failure;
mod geometry;
mod grading;
mod level;
mod limits;
mod models;
mod motions;
mod numbers;
mod path;
mod peaks;
mod places;
mod rates;
mod stated;
mod stresses;
mod thinning;
mod unseen;
mod worst;

use stickslip_engine::results::{Choice, Results};
use stickslip_engine::run::{Progress, RunError, run_with, solver};
use stickslip_scene::Scene;

/// The crates of scenes, runs and their results.
pub use {stickslip_engine, stickslip_scene};

/// Runs `scene` and reports to `progress`. Where the scene asks for an accuracy or gives no mesh, finer and finer models are tried until their
/// estimated errors meet it; otherwise this is [`run_with`] with the scene's solver.
///
/// # Errors
/// [`RunError`].
pub fn run(scene: &Scene, progress: &mut dyn FnMut(Progress)) -> Result<Results, RunError> {
    let solver = solver(scene.analysis.solver);
    if scene.seeks_accuracy() {
        return climb::climb(scene, solver.as_ref(), progress);
    }
    let mut found = run_with(scene, solver.as_ref(), progress)?;
    found.choices.push(Choice {
        what: "errors".into(),
        value: "none stated".into(),
        reason: "the scene gives its mesh and asks for no analysis.accuracy, so no finer model was compared with it"
            .into(),
    });
    Ok(found)
}
