//! `cargo xtask shear-sign`: which way friction points along a pin-loaded hole, and where matrix cracks are to be expected.
//!
//! Post and Reddy (1988, part I, 6.3) saw the shear on the edge of a (0/60/−60) plate change its sign at about 30° from the net section.
//! Their joint is solved with all friction laws over their parameters, with moduli of the plies and smeared ones, and over lay-up,
//! clearance and pin, loading and unloading; every load step is asked where the shear is reversed. The plies' transverse stresses along
//! the edge are compared with the matrix cracks of 6.4. The task writes tables, charts and a page.

pub(crate) mod case;
mod crack;
pub(crate) mod curve;
mod depth;
mod figures;
mod findings;
mod maps;
mod page;
mod plan;
mod plies;
mod study;
mod tables;

use std::process::ExitCode;

use crate::publish::{self, Options, Publication, Trouble};
use plan::Plan;
use study::Study;

/// Runs the task.
pub(crate) fn main(options: &Options) -> ExitCode {
    publish::main("shear-sign", options, compare)
}

fn compare(quick: bool) -> Result<Publication, Trouble> {
    let study = Study::of(if quick { Plan::quick() } else { Plan::full() })?;
    let pictures = figures::all(&study)?;
    let findings = [findings::all(&study), crack::findings(&study)].concat();
    Ok(Publication {
        tables: vec![
            ("shear-sign.csv", tables::cases(&study)?),
            ("beneath.csv", tables::beneath(&study)?),
            ("plies.csv", tables::plies(&study)?),
        ],
        page: page::page(&study, &pictures),
        pictures,
        findings: findings.join("\n\n") + "\n",
    })
}
