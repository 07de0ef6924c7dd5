//! What can go wrong in a comparison.

use stickslip::diagnostic::SceneError;
use stickslip::run::RunError;
use stickslip_contact::ContactError;
use stickslip_fem_core::GivenBodyError;
use thiserror::Error;

use crate::conventional::ConventionalError;

/// Why something was not computed or not measured.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LaboratoryError {
    /// A scene does not read.
    #[error("{scene}: {}", cause.findings().iter().map(|finding| finding.problem.to_string()).collect::<Vec<_>>().join("; "))]
    Scene {
        /// Its name.
        scene: String,
        /// What is wrong with it.
        #[source]
        cause: Box<SceneError>,
    },
    /// A run stopped.
    #[error(transparent)]
    Run(#[from] RunError),
    /// The conventional solver cannot be made.
    #[error(transparent)]
    Conventional(#[from] ConventionalError),
    /// A discrete problem cannot be made.
    #[error(transparent)]
    Discrete(#[from] ContactError),
    /// The numbers of a discrete problem do not fit together.
    #[error(transparent)]
    Given(#[from] GivenBodyError),
    /// Results or reference data lack something that an error measure needs.
    #[error("{0}")]
    Missing(String),
}
