//! `cargo xtask cosine`: the assumed cosine load against computed contact.
//!
//! The same joint, a hole in a laminated strip, is solved with the pressure 4P/(π D t) cos θ that handbooks assume and with a steel bolt
//! in contact, over clearance, friction and lay-up. Compared are peak hoop stress, hoop stress at the net section, peak pressure, peak
//! shear and the load of first-ply failure; everything is over P/(D t). The task writes a table, charts and a page.

mod case;
mod figures;
mod page;
mod study;

use std::process::ExitCode;

use crate::publish::{self, Options, Picture, Publication, Trouble};
use study::{Plan, Study};

/// Runs the task.
pub(crate) fn main(options: &Options) -> ExitCode {
    publish::main("cosine", options, compare)
}

fn compare(quick: bool) -> Result<Publication, Trouble> {
    let study = Study::of(if quick { Plan::QUICK } else { Plan::FULL })?;
    let pictures = figures::all(&study)?;
    Ok(Publication {
        tables: vec![("cosine.csv", page::csv(&study)?)],
        page: page::page(&study, &pictures),
        pictures,
        findings: page::findings(&study).join("\n\n") + "\n",
    })
}
