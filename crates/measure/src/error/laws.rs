//! Why friction laws cannot be fitted.

use stickslip_engine::run::RunError;
use stickslip_experiment::RefusedLaw;
use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::calibrate::CalibrateError;
use thiserror::Error;

/// Why laws cannot be fitted.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LawsError {
    /// The scene cannot be modelled or solved.
    #[error(transparent)]
    Run(#[from] RunError),
    /// Nothing touches the edge.
    #[error("no contact of the scene is at '{edge}', so no friction law acts there")]
    NoContact {
        /// The edge.
        edge: String,
    },
    /// The specimen shows no displacements.
    #[error("body '{body}' is rigid and shows no displacements")]
    Rigid {
        /// The body.
        body: String,
    },
    /// A place without displacement.
    #[error("the place ({}, {}) mm is not in the specimen", place[0], place[1])]
    Outside {
        /// Where it is `[mm]`.
        place: Point,
    },
    /// A load step that the scene does not have.
    #[error("a state is measured at load step {step}, and the scene has {steps}")]
    Step {
        /// The step, from 1.
        step: usize,
        /// Number of steps.
        steps: usize,
    },
    /// A law that half of the scene does not do for.
    #[error(
        "law '{law}' claims no symmetry about the line that bounds the half model; in the scene, say analysis.model = \"whole\" or \
         leave it out"
    )]
    NotSymmetric {
        /// Name of the law.
        law: String,
    },
    /// No law has parameters to fit.
    #[error("there is no law to fit")]
    NoLaw,
    /// A law refuses its parameters.
    #[error(transparent)]
    Law(#[from] RefusedLaw),
    /// The data are invalid.
    #[error("the measured displacements: {0}")]
    Data(#[source] CalibrateError),
    /// A law cannot be fitted.
    #[error("law '{law}': {cause}")]
    Calibrate {
        /// Name of the law.
        law: String,
        /// What is wrong.
        #[source]
        cause: CalibrateError,
    },
}
