//! `cargo xtask chart`: work–precision diagrams.
//!
//! Reference problems with known answers are solved by every method on ever finer meshes; errors are drawn over wall time and
//! over unknowns, log–log, one curve for each method, with the Pareto front. Everything goes to one folder: the data as CSV,
//! the pictures as SVG and PNG, and a page that says in numbers who wins where.

mod bench;
mod contact_cost;
mod curve;
mod data;
mod factors;
mod figures;
mod methods;
mod peers;
mod summary;
mod text;
mod yardstick;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use stickslip::folder::FolderError;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_laboratory::LaboratoryError;
use stickslip_laboratory::problems::Problem;
use stickslip_report::FigureError;
use thiserror::Error;

use bench::{Bench, Cost, Quantity};
use contact_cost::ContactCost;
use factors::{PathFactor, path_factors};
use figures::save;
use methods::Method;
use peers::PeerRun;
use yardstick::Yardstick;

use crate::publish::Published;

/// What to chart.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Two coarse meshes of each curve, each run once: under a minute.
    #[arg(long)]
    quick: bool,
    /// Runs the other programs that are installed (CalculiX as `ccx`, GetFEM in the system's Python) on the benchmark.
    #[arg(long)]
    peers: bool,
    /// Folder of data and pictures [default: docs/charts; with --quick target/charts].
    #[arg(long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Why charts could not be made.
#[derive(Debug, Error)]
pub(crate) enum Trouble {
    /// A problem could not be built.
    #[error(transparent)]
    Laboratory(#[from] LaboratoryError),
    /// A picture could not be drawn.
    #[error(transparent)]
    Figure(#[from] FigureError),
    /// A file could not be read or written.
    #[error("{}: {cause}", path.display())]
    File {
        path: PathBuf,
        cause: std::io::Error,
    },
    /// A picture could not be turned into pixels or written.
    #[error(transparent)]
    Picture(Box<dyn std::error::Error + Send + Sync>),
    /// The folder or a file in it could not be written.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// A table could not be read or written.
    #[error("{}: {cause}", path.display())]
    Csv { path: PathBuf, cause: csv::Error },
    /// The page could not be made.
    #[error(transparent)]
    Page(#[from] minijinja::Error),
    /// Another program could not be run.
    #[error("{0}")]
    Peer(String),
    /// A thread could not be started.
    #[error("{0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    /// The default method does not solve a reference problem.
    #[error("the default method does not solve {0}")]
    Unsolved(String),
}

/// Everything measured.
struct Charts {
    bench: Bench,
    factors: Vec<PathFactor>,
    contact: Vec<ContactCost>,
    yardstick: Yardstick,
    peers: Vec<PeerRun>,
    /// Seconds that everything but the other programs took, by the wall clock.
    elapsed: f64,
}

/// Runs the task: progress on stderr, a summary on stdout.
pub(crate) fn main(options: &Options) -> ExitCode {
    let start = Instant::now();
    match charts(options) {
        Ok(summary) => {
            print!("{summary}");
            eprintln!("{:.0} s", start.elapsed().as_secs_f64());
            ExitCode::SUCCESS
        }
        Err(trouble) => {
            eprintln!("{trouble}");
            ExitCode::FAILURE
        }
    }
}

fn charts(options: &Options) -> Result<String, Trouble> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let committed = root.join("docs/charts");
    let own = if options.quick {
        root.join("target/charts")
    } else {
        committed.clone()
    };
    let mut folder =
        Published::open(options.output.as_deref(), None)?.unwrap_or(Published::Own(own));
    // One thread, as the other programs were measured.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let start = Instant::now();
    let (bench, contact, yardstick) = pool.install(|| measure(options.quick))?;
    let elapsed = start.elapsed().as_secs_f64();
    let mut peers = peers::read(&committed.join("peers.csv"))?;
    if options.peers {
        let machine = data::machine();
        peers::renew(&mut peers, &data::today(), &machine, yardstick.seconds)?;
    }
    let charts = Charts {
        factors: path_factors(&bench),
        bench,
        contact,
        yardstick,
        peers,
        elapsed,
    };
    folder.write("work-precision.csv", &data::csv(charts.bench.samples())?)?;
    folder.write("peers.csv", &peers::csv(&charts.peers)?)?;
    draw(&mut folder, &charts)?;
    folder.write("README.md", text::page(&charts)?.as_bytes())?;
    unsolved(&charts.bench)?;
    eprintln!("charts, data and page are in {}", folder.path().display());
    Ok(text::short(&charts))
}

/// Runs every method on every problem, and the yardstick.
fn measure(quick: bool) -> Result<(Bench, Vec<ContactCost>, Yardstick), Trouble> {
    let mut bench = Bench::new(quick);
    let groups = [
        methods::elements(),
        methods::gaps(),
        methods::projections(ElementKind::Q8),
        methods::projections(ElementKind::Q4),
        methods::direct_solvers(),
        methods::iterative_solvers(),
    ];
    for problem in Problem::ALL {
        eprintln!("{}", problem.title());
        for group in &groups {
            bench.measure(problem, group);
        }
    }
    bench.share_matrices();
    Ok((bench, contact_cost::measure(quick)?, Yardstick::measure()?))
}

/// The default has to solve everything.
fn unsolved(bench: &Bench) -> Result<(), Trouble> {
    let failed = bench
        .samples()
        .iter()
        .find(|sample| sample.method == Method::DEFAULT && sample.outcome.is_err());
    failed.map_or(Ok(()), |sample| {
        let cause = sample.outcome.as_ref().err().cloned().unwrap_or_default();
        Err(Trouble::Unsolved(format!(
            "{} at {} {}: {cause}",
            sample.problem.name(),
            sample.spacing,
            sample.problem.unit()
        )))
    })
}

fn draw(folder: &mut Published, charts: &Charts) -> Result<(), Trouble> {
    let bench = &charts.bench;
    for problem in Problem::ALL {
        for (cost, ending) in [(Cost::Whole, ""), (Cost::Unknowns, "-unknowns")] {
            let picture = figures::problem_figure(bench, problem, &methods::elements(), cost)?;
            save(
                folder,
                &format!("elements-{}{ending}", problem.name()),
                &picture,
            )?;
        }
    }
    let discretisations = [
        methods::gaps(),
        methods::projections(ElementKind::Q8),
        methods::projections(ElementKind::Q4),
    ];
    for group in &discretisations {
        for (quantity, ending) in [
            (Quantity::PeakPressure, "peak-pressure"),
            (Quantity::Extent, "extent"),
        ] {
            let picture = figures::overview(bench, group, Cost::Whole, quantity)?;
            save(folder, &format!("{}-{ending}", group.key), &picture)?;
        }
    }
    // Solvers that end with the same answer differ in cost alone.
    let approaching = methods::iterative_solvers();
    let picture = figures::overview(bench, &approaching, Cost::Solve, Quantity::PeakPressure)?;
    save(folder, approaching.key, &picture)?;
    for group in [methods::direct_solvers(), approaching] {
        let picture = figures::contact_cost(bench, &group)?;
        save(folder, &format!("{}-contact", group.key), &picture)?;
    }
    save(folder, "paths", &figures::path_factors(&charts.factors)?)?;
    save(folder, "summary", &summary::seconds(charts)?)?;
    save(
        folder,
        "peers-factorisations",
        &summary::factorisations(charts)?,
    )
}
