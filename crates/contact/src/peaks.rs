//! Peaks along a contact edge from the nodal values of one discretisation, each with an estimated error.
//!
//! The stress along the edge has a cusp where contact ends, and where stick ends after slip has turned, so its largest nodal value is that of a
//! node which happens to be near. Around such an end, with x the place counted from it into the side that is *free* (open, or slipping), of an isotropic body
//!
//! ```text
//! σ_t + p = A + a₁ x + a₂ x² + …  + 2 √x (b₀ + b₁ x + …)        free side, x > 0
//! σ_t + p = A + a₁ x + a₂ x² + …                                held side, x < 0
//! q − q_s =                         √−x (b₀ + b₁ x + …)        held side
//! ```
//!
//! where q is the shear traction on the body along the edge and q_s that of the slip on the free side, zero where contact is open: σ_t + p + 2i (q − q_s) is the boundary
//! value of an analytic function. All three lines are fitted at once, so the height A of the cusp is known from nodes on both sides, and the root, which a mesh cannot
//! resolve, from the shear traction that makes it. Without friction b = 0, and σ_t + p goes on smoothly. Of other bodies, or where no shear is known, only the first line is fitted.
//!
//! | function | peak |
//! | --- | --- |
//! | [`locate_end`] | where contact or stick ends, between two nodes |
//! | [`cusp_peak`] | at a located end |
//! | [`smooth_peak`] | of a smooth quantity, between nodes |
//! | [`edge_peak`] | the largest of a whole edge, from one or the other |
//!
//! Errors are estimated from how much the answer depends on the nodes and terms of the fit, and on the place of the end. They are calibrated on discrete solutions of pins in
//! strips with friction (`crates/series/tests/suite/peaks.rs`), where about 19 in 20 hold the truth of the hoop stress; fits by the free side alone are not calibrated on bodies that are not isotropic.
//!
//! Sources: the potentials of a half-plane, Muskhelishvili, *Some Basic Problems* (1953), § 93; σ_t beside a slipping end, Hills & Nowell, *Mechanics of Fretting Fatigue* (1994), ch. 4.

mod cusp;
mod edge;
mod fit;
mod locate;
mod smooth;

pub use cusp::{Cusp, HeldSide, Side, cusp_peak};
pub use edge::{EdgeValues, edge_peak};
pub use locate::{Located, locate_end};
pub use smooth::smooth_peak;

/// The largest value of a quantity along an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Its value, in the unit of the quantity.
    pub value: f64,
    /// Where it is `[length]`.
    pub place: f64,
    /// Estimated error of the value, in its unit.
    pub error: f64,
}
