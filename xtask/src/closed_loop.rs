//! `cargo xtask closed-loop`: friction from synthetic fringe pictures, again and again with other noise.
//!
//! The pin-loaded aluminium plate of `scenes/hybrid-aluminium` is solved with known friction and photographed once for every seed; its
//! friction is identified from the pictures by the same functions that `stickslip identify` calls. How often the interval holds the
//! truth says whether it is one of 95 %. The task writes a table, a chart and a page.

mod figures;
mod page;
mod record;
mod study;

use std::process::ExitCode;

use crate::publish::{self, Options, Picture, Publication, Trouble};

pub(crate) use record::Record;
pub(crate) use study::{NEAR, Series, WITH_FRICTION, WITHOUT_FRICTION, wanted};

/// Runs the task.
pub(crate) fn main(options: &Options) -> ExitCode {
    publish::main("closed-loop", options, repeat)
}

/// The scene's settings were chosen with seeds 1 to 20: none of these is asked again.
pub(crate) const FIRST: u64 = 1001;

fn repeat(quick: bool) -> Result<Publication, Trouble> {
    let [many, some] = if quick { [20, 5] } else { [200, 20] };
    let [many, some] = [many, some].map(|count| FIRST..=FIRST + count - 1);
    let rubbing = Series::of(WITH_FRICTION, many)?;
    let smooth = Series::of(WITHOUT_FRICTION, some)?;
    Ok(Publication {
        tables: vec![("closed-loop.csv", page::csv([&rubbing, &smooth])?)],
        pictures: vec![figures::intervals(&rubbing)?],
        page: page::page(&rubbing, &smooth),
        findings: page::findings(&rubbing, &smooth).join("\n") + "\n",
    })
}
