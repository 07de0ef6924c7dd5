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
mod unmeshed;
mod yardstick;

use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use stickslip_laboratory::problems::Problem;

use bench::{Bench, Cost, Quantity};
use contact_cost::ContactCost;
use factors::{PathFactor, path_factors};
use methods::{Group, Method};
use peers::PeerRun;
use unmeshed::Unmeshed;
use yardstick::Yardstick;

use crate::publish::{Published, TaskError, root};

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

/// Everything measured.
struct Charts {
    bench: Bench,
    factors: Vec<PathFactor>,
    contact: Vec<ContactCost>,
    unmeshed: Vec<Unmeshed>,
    yardstick: Yardstick,
    peers: Vec<PeerRun>,
    /// Seconds that everything but the other programs took, by the wall clock.
    elapsed: f64,
}

/// Runs the task: progress on stderr, a summary on stdout.
pub(crate) fn main(options: &Options) -> Result<bool, TaskError> {
    let root = root();
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
    let unmeshed = pool.install(|| unmeshed::measure(options.quick))?;
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
        unmeshed,
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
    print!("{}", text::short(&charts));
    Ok(true)
}

/// Runs every method on every problem, and the yardstick.
fn measure(quick: bool) -> Result<(Bench, Vec<ContactCost>, Yardstick), TaskError> {
    let mut bench = Bench::new(quick);
    let [gaps, quadratic, linear] = methods::discretisations();
    let solvers = [methods::direct_solvers(), methods::iterative_solvers()];
    let groups = [methods::elements(), gaps, quadratic, linear];
    for problem in Problem::ALL {
        eprintln!("{}", problem.title());
        for group in groups.iter().chain(&solvers) {
            bench.measure(problem, group);
        }
    }
    bench.share_matrices();
    Ok((bench, contact_cost::measure(quick)?, Yardstick::measure()?))
}

/// The default has to solve everything.
fn unsolved(bench: &Bench) -> Result<(), TaskError> {
    let failed = bench
        .samples()
        .iter()
        .find(|sample| sample.method == Method::DEFAULT && sample.outcome.is_err());
    failed.map_or(Ok(()), |sample| {
        let cause = sample.outcome.as_ref().err().cloned().unwrap_or_default();
        let (problem, unit) = (sample.problem.name(), sample.problem.unit());
        Err(format!(
            "the default method does not solve {problem} at {} {unit}: {cause}",
            sample.spacing
        )
        .into())
    })
}

fn draw(folder: &mut Published, charts: &Charts) -> Result<(), TaskError> {
    let bench = &charts.bench;
    let mut save = |name: &str, picture| folder.write_scaled(name, &picture, 1.5);
    for problem in Problem::ALL {
        let (name, elements) = (problem.name(), methods::elements());
        for (cost, ending) in [(Cost::Whole, ""), (Cost::Unknowns, "-unknowns")] {
            let picture = figures::problem_figure(bench, problem, &elements, cost)?;
            save(&format!("elements-{name}{ending}"), picture)?;
        }
    }
    let overview = |group: &Group, cost, quantity| figures::overview(bench, group, cost, quantity);
    for group in methods::discretisations() {
        let peak = overview(&group, Cost::Whole, Quantity::PeakPressure)?;
        save(&format!("{}-peak-pressure", group.key), peak)?;
        let extent = overview(&group, Cost::Whole, Quantity::Extent)?;
        save(&format!("{}-extent", group.key), extent)?;
    }
    // Solvers that end with the same answer differ in cost alone.
    let approaching = methods::iterative_solvers();
    save(
        approaching.key,
        overview(&approaching, Cost::Solve, Quantity::PeakPressure)?,
    )?;
    for group in [methods::direct_solvers(), approaching] {
        save(
            &format!("{}-contact", group.key),
            figures::contact_cost(bench, &group)?,
        )?;
    }
    save("paths", figures::path_factors(&charts.factors)?)?;
    save("summary", summary::seconds(charts)?)?;
    save("peers-factorisations", summary::factorisations(charts)?)
}
