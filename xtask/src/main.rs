//! Tasks on the whole workspace: `cargo xtask validate` compares the library with known solutions, `cargo xtask chart` shows
//! what accuracy costs, `cargo xtask accuracy` how often stated errors hold the truth, `cargo xtask stability` where methods fail, `cargo xtask cosine` how wrong an assumed bearing load is,
//! `cargo xtask shear-sign` which way friction points along a loaded hole, `cargo xtask mesh-dependence` what ply discount makes of a
//! finer mesh, `cargo xtask load-shares` how rows of bolts share their load beside springs and bars, `cargo xtask hybrid-noise` what noise and bias are left in stresses from measured displacements, `cargo xtask
//! closed-loop` how often friction from fringe pictures lies in its interval, `cargo xtask torture` what random cases break,
//! `cargo xtask size` how long the code is, `cargo xtask docs` writes the tables of keys, `cargo xtask gallery` pictures of shipped scenes, `cargo xtask same-answers` whether results are those of an
//! earlier revision, `cargo xtask wasm` whether a WebAssembly runtime finds the same numbers.

mod accuracy;
mod chart;
mod closed_loop;
mod cosine;
mod docs;
mod gallery;
mod hybrid_noise;
mod joints;
mod load_shares;
mod mesh_dependence;
mod publish;
mod same_answers;
mod shear_sign;
mod size;
mod stability;
mod study;
mod torture;
mod validate;
mod wasm;

use std::process::ExitCode;
use std::time::Instant;

use clap::{Parser, Subcommand};

/// Validation, charts and studies, built on the library.
#[derive(Debug, Parser)]
#[command(bin_name = "cargo xtask", version)]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Debug, Subcommand)]
enum Task {
    /// Compares computed quantities with known solutions; fails if one misses its bound.
    Validate(validate::Options),
    /// Counts how often stated errors hold the truth; fails if too few do.
    Accuracy(accuracy::Options),
    /// Draws work–precision charts: what accuracy costs with each method.
    Chart(chart::Options),
    /// Draws the atlas of failures: what each method does where methods fail.
    Stability(stability::Options),
    /// Finds friction from synthetic fringe pictures again and again: how often its interval holds the truth.
    ClosedLoop(publish::Options),
    /// Compares the assumed cosine bearing load with computed contact.
    Cosine(publish::Options),
    /// Asks which friction laws reverse the shear on the edge of a pin-loaded hole, and where matrix cracks are to be expected.
    ShearSign(publish::Options),
    /// Compares how rows of bolts share their load with springs and bars, and with formulas for the springs.
    LoadShares(publish::Options),
    /// Charts noise and bias of edge stresses from measured displacements, by data density, mesh, smoothing and stand-off.
    HybridNoise(publish::Options),
    /// Shows how the strength by ply discount depends on the mesh, and what crack bands mend.
    MeshDependence(publish::Options),
    /// Compares the results of all shipped scenes with those of an earlier revision; fails if a number differs.
    SameAnswers(same_answers::Options),
    /// Writes the tables of keys in the documents.
    Docs(docs::Options),
    /// Runs shipped scenes and shows them in docs/gallery.
    Gallery(gallery::Options),
    /// Counts lines of code of every crate; fails if a bound is exceeded.
    Size,
    /// Tries random cases, and checks them by what holds whatever the answer is; fails if a check does.
    Torture(torture::Options),
    /// Runs one scene in a WebAssembly runtime; fails if its laws or numbers differ from the native ones.
    Wasm(wasm::Options),
    /// Reads a batch of mutants; what `torture` starts in a process of its own.
    #[command(hide = true)]
    TortureReaders(torture::readers::Batch),
}

/// The name under which this program is the command, for trials that start it.
pub(crate) const COMMAND: &str = "stickslip";

fn main() -> ExitCode {
    let name = std::env::args_os().next().unwrap_or_default();
    if std::path::Path::new(&name).ends_with(COMMAND) {
        return stickslip::cli::main();
    }
    let start = Instant::now();
    let outcome = match Arguments::parse().task {
        Task::Validate(options) => validate::main(&options),
        Task::Accuracy(options) => accuracy::main(&options),
        Task::Chart(options) => chart::main(&options),
        Task::Stability(options) => stability::main(&options),
        Task::ClosedLoop(options) => closed_loop::STUDY.main(&options),
        Task::Cosine(options) => cosine::STUDY.main(&options),
        Task::ShearSign(options) => shear_sign::STUDY.main(&options),
        Task::LoadShares(options) => load_shares::STUDY.main(&options),
        Task::HybridNoise(options) => hybrid_noise::STUDY.main(&options),
        Task::MeshDependence(options) => mesh_dependence::STUDY.main(&options),
        Task::SameAnswers(options) => same_answers::main(&options),
        Task::Docs(options) => docs::main(&options),
        Task::Gallery(options) => gallery::main(&options),
        Task::Size => size::main(),
        Task::Torture(options) => torture::main(&options),
        Task::Wasm(options) => wasm::main(&options),
        Task::TortureReaders(batch) => torture::readers::child(&batch),
    };
    let seconds = start.elapsed().as_secs_f64();
    if seconds > 1.0 {
        eprintln!("{seconds:.0} s");
    }
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
