//! What a source says, before anything is taken off.

use stickslip_hybrid::data::FringeLines;

use super::field::Measured;
use super::phase::Unwound;
use crate::finding::Finding;

/// A source as it was read, before anything is taken off.
#[derive(Clone, Debug)]
pub(super) enum Reading {
    /// Displacements at places of a table.
    Scattered(Box<Measured>),
    /// Orders at the pixels of the U and the V field.
    Pictures(Box<[Option<Unwound>; 2]>),
    /// Fringe lines of the U and the V field.
    Lines(Digitised),
}

/// What tables of fringe centres say.
#[derive(Clone, Debug)]
pub(super) struct Digitised {
    /// Fringe lines of the U and the V field.
    pub(super) lines: [FringeLines; 2],
    /// Standard deviation of an order `[fringes]`.
    pub(super) deviation: f64,
    pub(super) findings: Vec<Finding>,
}
