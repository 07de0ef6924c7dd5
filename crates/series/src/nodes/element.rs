//! Parts of the circle and their ends.

/// A node of the whole circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Knot {
    /// Angle `[rad]`.
    pub(crate) angle: f64,
    /// Node of the operator, or that whose image this is.
    pub(crate) node: usize,
    /// Its mirror image among the knots, itself on the axis; itself without symmetry.
    pub(crate) image: usize,
    /// w of its whole hat `[rad]`.
    pub(crate) weight: f64,
}

/// A part of the circle between two knots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Element {
    /// Its knots, in the order of angles.
    pub(crate) knots: [usize; 2],
    /// Angle of the first `[rad]`.
    pub(crate) start: f64,
    /// Length `[rad]`.
    pub(crate) length: f64,
}
