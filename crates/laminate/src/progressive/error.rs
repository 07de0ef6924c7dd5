//! Why a point model cannot be built, or cannot take a step.

use thiserror::Error;

use crate::degradation::DegradationError;
use crate::failure::FailureError;

/// A model that cannot be built, or a step that it cannot take.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ProgressiveError {
    /// A strain or temperature that is not finite.
    #[error("strain {strain:?} at the temperature rise {temperature} is not finite")]
    NotFinite {
        /// The requested strain (xx, yy, xy), dimensionless.
        strain: [f64; 3],
        /// The requested temperature rise `[temperature]`.
        temperature: f64,
    },
    /// A state of another laminate.
    #[error("the state has {given} layers, the laminate {layers}")]
    LayerCount {
        /// Layers of the laminate.
        layers: usize,
        /// Layers of the state.
        given: usize,
    },
    /// Strengths for which the Tsai–Hill quadratic is no ellipse.
    #[error(
        "ply '{ply}': y = {across} is too large beside xt = {xt} and xc = {xc}: the Tsai-Hill quadratic is then no closed surface; \
         the largest y is {limit}"
    )]
    OpenYieldSurface {
        /// Name of the ply.
        ply: String,
        /// The larger of Y_t and Y_c `[stress]`.
        across: f64,
        /// X_t `[stress]`.
        xt: f64,
        /// X_c `[stress]`.
        xc: f64,
        /// Y must be less `[stress]`.
        limit: f64,
    },
    /// A hardening that softens or is not finite.
    #[error("hardening = {value} must be finite and not negative")]
    Hardening {
        /// The value given: a plastic modulus `[stress]`, or H `[1/stress]` of a [`YieldSurface`](super::YieldSurface).
        value: f64,
    },
    /// The return mapping did not reach the yield surface to rounding.
    #[error(
        "layer {layer}: return mapping stopped {distance:.1e} off the yield surface after {iterations} iterations"
    )]
    ReturnMapping {
        /// Index of the layer, from the bottom, from 0.
        layer: usize,
        /// Distance, relative to the yield stress, dimensionless.
        distance: f64,
        /// Iterations taken.
        iterations: usize,
    },
    /// A degradation factor out of its range.
    #[error(transparent)]
    Degradation(#[from] DegradationError),
    /// The failure criterion refused.
    #[error(transparent)]
    Failure(#[from] FailureError),
}
