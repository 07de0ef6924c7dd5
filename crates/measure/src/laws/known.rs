//! What earlier stages know of the measured fields.

use crate::analysed::Analysed;
use crate::truth::Truth;
use crate::whole::WholeState;

/// What earlier stages know of the measured fields.
#[derive(Clone, Copy, Debug, Default)]
pub struct Known<'a> {
    /// States that were analysed around the edge.
    pub analysed: &'a [Analysed],
    /// States that were analysed as whole plates.
    pub plates: &'a [WholeState],
    /// The solved scene of synthetic states.
    pub truth: Option<&'a Truth>,
}
