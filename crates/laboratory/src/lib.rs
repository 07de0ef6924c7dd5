//! Where contact methods are compared: problems with known answers, a conventional solver to compare with, and timing.
//!
//! A method is an element, a contact discretisation and an [`InterfaceSolver`](stickslip_contact::InterfaceSolver); its merit
//! is its error against its cost. Everything here takes and returns values.
//!
//! | module | subject |
//! | --- | --- |
//! | [`problems`] | reference problems as scenes, and the errors of their results |
//! | [`run`](run()) | a scene by the condensed or the conventional path, phase by phase |
//! | [`conventional`] | the whole finite-element system, refactorised in every contact iteration |
//! | [`references`] | closed forms and tables behind them |
//! | [`discrete`] | small problems given by their numbers, and all their solutions |
//! | [`measure`] | wall times of repeated runs: median and quartiles |

pub mod conventional;
pub mod discrete;
mod error;
pub mod measure;
pub mod problems;
pub mod references;
pub mod run;

pub use conventional::{ConventionalError, ConventionalNewton};
pub use discrete::Discrete;
pub use error::LaboratoryError;
pub use measure::{Repeat, Timing};
pub use problems::{Errors, Pairing, Problem};
pub use run::{Path, Run, Seconds, run};
