//! stickslip: plane frictional contact from a scene file to tractions, pictures and a report.
//!
//! ```text
//! scene file ──► scene ──► model ──► run ──► results ──► output
//!                checked   bodies,   steps   numbers in  files, figures,
//!                          pairs             base units  page, table
//! ```
//!
//! | module | subject |
//! | --- | --- |
//! | [`scene`], [`units`], [`diagnostic`] | scene files, quantities with units, errors that point at a line |
//! | [`model`] | meshes, bodies, contact pairs, load history; the choices made |
//! | [`run`](mod@run), [`results`] | the solution and what is reported of it |
//! | [`experiment`] | measured displacements: fringe pictures, their reduction, hybrid analysis, friction |
//! | [`sweep`] | many joints: the axes of a sweep, its engine, its table and pictures |
//! | [`limits`] | how much memory reading and modelling may take |
//! | [`output`] | results as files, figures, a page and a table |
//!
//! A program with friction laws of its own links them and calls [`cli::main`].

pub mod cli;
pub mod diagnostic;
pub mod experiment;
mod failure;
pub mod limits;
pub mod model;
pub mod output;
pub mod results;
pub mod run;
pub mod scene;
pub mod sweep;
pub mod units;
