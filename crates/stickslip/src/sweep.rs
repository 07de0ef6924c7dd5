//! Sweeps: many joints that differ along a few axes, from one scene.
//!
//! ```text
//! sweep file ──► Sweep ──► cases ──► engine ──► rows ──► table, maps, curves, page
//!                axes,     full      bodies     one
//!                scene     product   condensed  per case
//!                                    once
//! ```
//!
//! | module | subject |
//! | --- | --- |
//! | [`axis`] | axes, and the scene keys that e/D, W/D, clearance, μ and lay-up stand for |
//! | [`engine`] | workers that share condensed bodies |
//! | [`row`] | what is kept of a case |
//! | [`table`] | rows as CSV, written and read again |
//! | [`figures`], [`page`] | maps of failure modes, curves of failure loads, and the page around them |
//!
//! What makes a sweep cheap: a body is condensed once for all cases in which nothing of it changes, and a load, a friction
//! coefficient, a law or a strength changes nothing of any body. A pin of another radius is no other body either: under the same
//! forces the displacements of a plane body scaled by s,
//!
//! ```text
//! u'(s x) = u(x),     since  ε' = ε/s, σ' = σ/s,  and tractions σ'·n on lengths s dΓ are the forces σ·n on dΓ
//! ```
//!
//! are those of the body itself, so its compliance on the contact nodes does not know its size; only the gap does, and that is
//! computed from the true circles of every case.

pub mod axis;
mod bodies;
pub mod engine;
mod error;
pub mod figures;
mod format;
mod minima;
pub mod page;
mod plan;
mod queue;
pub mod row;
mod store;
pub mod table;
mod verdict;

pub use error::{RowError, SweepError};
pub use minima::{Minimum, minima};
pub use plan::Sweep;
pub use verdict::{findings, verdict, warning};
