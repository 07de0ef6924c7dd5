//! Why a run stopped.

use stickslip_contact::ContactError;
use stickslip_fem_core::body::BodyError;
use stickslip_fem_core::stress::StressError;
use stickslip_joint::{CrackBandError, Halt, JointError};
use stickslip_laminate::FailureError;
use stickslip_laminate::progressive::ProgressiveError;
use thiserror::Error;

use super::whole_motion::MovingBody;
use crate::model::ModelError;

/// Why a run stopped.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum RunError {
    /// The scene cannot be modelled.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A body cannot be condensed.
    #[error("body '{body}': {cause}")]
    Body {
        /// The body.
        body: String,
        /// Its reason.
        #[source]
        cause: BodyError,
    },
    /// A load step was not solved.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// A load step was not solved: its load moves bodies as a whole, and no contact force balances it, which is proved.
    #[error("{cause}; {}", .moving.iter().map(MovingBody::describe).collect::<Vec<_>>().join(", "))]
    Unbalanced {
        /// Where the history ended.
        #[source]
        cause: ContactError,
        /// The part of the load that is not balanced `[1]`.
        part: f64,
        /// What the load moves, and how.
        moving: Vec<MovingBody>,
    },
    /// Stresses could not be recovered.
    #[error("stresses: {0}")]
    Stress(#[from] StressError),
    /// Cannot evaluate the failure criterion of the plies.
    #[error("failure of body '{body}': {cause}")]
    Failure {
        /// The body.
        body: String,
        /// Its reason.
        #[source]
        cause: FailureError,
    },
    /// Plies could not be followed beyond their failure.
    #[error("progressive failure of body '{body}': {cause}")]
    Progressive {
        /// The body.
        body: String,
        /// Its reason.
        #[source]
        cause: Box<ProgressiveRunError>,
    },
}

impl RunError {
    /// Where the history ended, if it did.
    pub fn contact(&self) -> Option<&ContactError> {
        match self {
            Self::Contact(cause) | Self::Unbalanced { cause, .. } => Some(cause),
            _ => None,
        }
    }
}

/// Why a joint could not be followed beyond the failure of its plies.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ProgressiveRunError {
    /// Strengths could not be scaled by fracture energies.
    #[error(transparent)]
    CrackBand(#[from] CrackBandError),
    /// The plies' model refused the laminate.
    #[error(transparent)]
    Model(#[from] ProgressiveError),
    /// The joint cannot be built or followed at all.
    #[error(transparent)]
    Joint(#[from] JointError),
    /// The pin never presses on the bearing point.
    #[error(
        "the pin never presses on the bearing point of '{body}', at {angle_deg:.0}° of its hole, where the load of a joint is read: turn the load or the drive round, or drive it farther"
    )]
    WrongWay {
        /// The body.
        body: String,
        /// Place of the bearing point, from +x `[degree]`.
        angle_deg: f64,
    },
    /// The history ended before the pin pressed.
    #[error(
        "the pin did not press before the history ended, at {percent:.3} % of load step {}: {cause}", .step + 1
    )]
    NothingBorne {
        /// Index of the load step, from 0.
        step: usize,
        /// Part of it that was reached `[%]`.
        percent: f64,
        /// Why no equilibrium was found beyond.
        cause: Halt,
    },
    /// Nothing says where the pin bears.
    #[error(
        "no load presses the pin against the hole of '{body}', so its bearing point is unknown: give the scene the load that the joint is to bear, or drive it by failure.progressive.control.displacement"
    )]
    NoBearing {
        /// The body.
        body: String,
    },
    /// Nothing of the model touches the hole.
    #[error("no contact touches the hole of '{body}'")]
    NoPin {
        /// The body.
        body: String,
    },
}
