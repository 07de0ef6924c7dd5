//! A part of an edge that slips.

use std::ops::Range;

use stickslip_hybrid::identify::SlipFit;

/// A zone that slips.
#[derive(Clone, Debug)]
pub struct SlipZone {
    /// Index of the state in the experiment.
    pub state: usize,
    /// Places of the edge.
    pub places: Range<usize>,
    /// Whether friction acts along +τ_rθ.
    pub positive: bool,
    /// Whether it was given by hand.
    pub given: bool,
    /// What remains towards the bearing point, where it may stick.
    pub inside: Range<usize>,
    /// The coefficient of this zone alone.
    pub fit: SlipFit,
}

impl SlipZone {
    /// Whether it was recognised up to the bearing point, so that nothing shows where it ends.
    pub fn has_no_end(&self) -> bool {
        !self.given && self.inside.is_empty()
    }
}
