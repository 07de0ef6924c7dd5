//! What the tests of whole scenes share.
//!
//! | module | subject |
//! | --- | --- |
//! | [`draft`] | small scenes to start from, changed key by key |
//! | [`solution`] | a solved model with the displacements of its bodies |
//! | [`balance`] | internal forces by a quadrature loop of its own |
//! | [`arcs`] | stress resultants on circles around a hole |
//! | [`compare`] | largest differences between results |
//!
//! Unlike the libraries, these functions panic: a test that cannot be set up has failed.

pub mod arcs;
pub mod balance;
pub mod compare;
pub mod draft;
pub mod solution;

pub use draft::Draft;
pub use solution::Solution;
