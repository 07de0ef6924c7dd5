//! Numbers beside those of a finer answer.

/// What the answer to a draw says, beside a finer one.
pub(super) struct Compared {
    pub(super) numbers: Vec<Number>,
    pub(super) is_reached: bool,
    /// Whether peak pressure and stress lie within what was asked.
    pub(super) is_met: bool,
    pub(super) nodes: usize,
    pub(super) increments: usize,
}

/// A number that is stated with an error.
pub(super) struct Number {
    pub(super) name: &'static str,
    pub(super) step: usize,
    pub(super) unloading: bool,
    /// The number and what it should be.
    pub(super) values: [f64; 2],
    /// The errors of both, where both are stated.
    pub(super) errors: Option<[f64; 2]>,
}

/// A load step.
#[derive(Clone, Copy)]
pub(super) struct At {
    pub(super) step: usize,
    pub(super) unloading: bool,
}
