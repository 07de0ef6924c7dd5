//! Why a whole plate cannot be analysed.

use stickslip_engine::model::ModelError;
use stickslip_fem_core::body::BodyError;
use stickslip_hybrid::region::RegionError;
use thiserror::Error;

/// Why a whole plate cannot be analysed.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WholeError {
    /// The scene cannot be modelled.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The plate makes no body.
    #[error(transparent)]
    Body(#[from] BodyError),
    /// The plate, the fit or its outputs.
    #[error(transparent)]
    Region(#[from] RegionError),
    /// The plate is not free.
    #[error(
        "body '{body}' is held by a support of the scene, whose force is not known: the whole plate is analysed under known forces alone"
    )]
    Held {
        /// The body.
        body: String,
    },
    /// The plate is rigid.
    #[error("body '{body}' is rigid")]
    Rigid {
        /// The body.
        body: String,
    },
    /// The plate is heated.
    #[error("body '{body}' is heated, which the analysis of the whole plate does not cover")]
    Heated {
        /// The body.
        body: String,
    },
}
