//! What the tests of whole scenes and the checks of the sources share.
//!
//! | module | subject |
//! | --- | --- |
//! | [`draft`] | small scenes to start from, changed key by key |
//! | [`solution`] | a solved model with the displacements of its bodies |
//! | [`balance`] | internal forces by a quadrature loop of its own |
//! | [`arcs`] | stress resultants on circles around a hole |
//! | [`compare`] | largest differences between results |
//! | [`imports`] | imports between the files of a crate, and circles among them |
//! | [`source`] | Rust sources as tokens, without their tests |
//!
//! Unlike the libraries, these functions panic: a test that cannot be set up has failed.

pub mod arcs;
pub mod balance;
pub mod compare;
pub mod draft;
pub mod imports;
pub mod solution;
pub mod source;

pub use draft::Draft;
pub use solution::Solution;
