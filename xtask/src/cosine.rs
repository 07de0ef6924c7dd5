//! `cargo xtask cosine`: the assumed cosine load against computed contact.
//!
//! The same joint, a hole in a laminated strip, is solved with the pressure 4P/(π D t) cos θ that handbooks assume and with a steel bolt
//! in contact, over clearance, friction and lay-up. Compared are peak hoop stress, hoop stress at the net section, peak pressure, peak
//! shear and the load of first-ply failure; everything is over P/(D t). The task writes a table, charts and a page.

mod case;
mod figures;
mod page;
mod study;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use stickslip_report::folder::write_atomic;
use stickslip_report::raster::{DEFAULT_SCALE, to_png};

use study::{Plan, Study};

/// Why the study stopped.
type Trouble = Box<dyn std::error::Error + Send + Sync>;

/// What to compare.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Few values on coarser meshes: at most a minute. Nothing is written unless a folder is named.
    #[arg(long)]
    quick: bool,
    /// Folder for table, pictures and page; docs/cosine for a full run.
    #[arg(long, value_name = "FOLDER")]
    output: Option<PathBuf>,
}

/// Runs the task: progress on stderr, findings on stdout.
pub(crate) fn main(options: &Options) -> ExitCode {
    let start = Instant::now();
    let outcome = compare(options);
    eprintln!("{:.0} s", start.elapsed().as_secs_f64());
    match outcome {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(trouble) => {
            eprintln!("{trouble}");
            ExitCode::FAILURE
        }
    }
}

fn compare(options: &Options) -> Result<String, Trouble> {
    let plan = if options.quick {
        Plan::QUICK
    } else {
        Plan::FULL
    };
    let study = Study::of(plan)?;
    let pictures = figures::all(&study)?;
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = match &options.output {
        Some(folder) => Some(folder.clone()),
        None => (!options.quick).then(|| root.join("docs/cosine")),
    };
    if let Some(folder) = folder {
        std::fs::create_dir_all(&folder)?;
        write_atomic(&folder.join("cosine.csv"), &page::csv(&study)?)?;
        for picture in &pictures {
            let path = folder.join(picture.name);
            write_atomic(&path.with_extension("svg"), picture.svg.as_str().as_bytes())?;
            write_atomic(
                &path.with_extension("png"),
                &to_png(&picture.svg, DEFAULT_SCALE)?,
            )?;
        }
        let text = page::page(&study, &pictures);
        write_atomic(&folder.join("README.md"), text.as_bytes())?;
    }
    Ok(page::findings(&study).join("\n\n") + "\n")
}
