//! `cargo xtask accuracy`: how often stated errors hold the truth.
//!
//! Random pins in holes are solved to an accuracy, and once more on the finest nodes with eight times as many increments, where the program chose the geometry
//! on the deformed one. A number counts where the finer answer is itself good to a third of the error that is tested.

mod along;
mod draw;
mod failure;
mod tally;

use std::error::Error;
use std::fs;
use std::path::PathBuf;

use clap::Args;
use rand::SeedableRng;
use rand::rngs::StdRng;
use rayon::prelude::*;
use stickslip::results::{LadderEnd, Results, Stated};
use stickslip::run::run;
use stickslip::scene::{Format, Scene};

use draw::Draw;
use tally::Tally;

/// Cases of a quick count.
pub(crate) const FEW: usize = 50;
/// Accuracies that are asked for.
pub(crate) const ASKED: [f64; 3] = [0.05, 0.01, 0.001];
/// Most increments of a step of the truth.
const FINEST: usize = 128;
/// How many times as many increments the truth has.
const FINER: usize = 8;
/// Numbers that follow from equilibrium to rounding.
const BALANCED: [Stated; 3] = [Stated::Bearing, Stated::ResultantX, Stated::ResultantY];
/// Least share of numbers within their stated error.
pub(crate) const COVERAGE: f64 = 0.95;

#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Few cases.
    #[arg(long)]
    quick: bool,
    /// Number of cases.
    #[arg(long)]
    cases: Option<usize>,
    /// Seed of the random cases.
    #[arg(long, default_value_t = 18)]
    seed: u64,
    /// Prints every number outside of its error, and writes its scene, or one that was not solved, to this folder.
    #[arg(long)]
    misses: Option<PathBuf>,
    /// Where the table is written.
    #[arg(long)]
    output: Option<PathBuf>,
}

/// Solves the cases and prints the table; whether enough errors hold the truth.
pub(crate) fn main(options: &Options) -> Result<bool, Box<dyn Error + Send + Sync>> {
    let few = options.quick;
    let count = options.cases.unwrap_or(if few { FEW } else { 500 });
    let asked = if few { &ASKED[..2] } else { &ASKED[..] };
    let mut written = Ok(());
    let tally = counted(count, options.seed, asked, |case, draw, asked, misses| {
        if let Some(folder) = &options.misses {
            let path = folder.join(format!("case-{case}.toml"));
            println!("{}, {asked} asked:\n{misses}", path.display());
            let put = || {
                fs::create_dir_all(folder)?;
                fs::write(&path, &draw.text)
            };
            written = std::mem::replace(&mut written, Ok(()))
                .and_then(|()| put().map_err(|error| format!("{}: {error}", path.display())));
        }
    });
    written?;
    let text = tally.text(count, options.seed);
    println!("{text}");
    if let Some(path) = &options.output {
        fs::write(path, &text).map_err(|error| format!("{}: {error}", path.display()))?;
    }
    Ok(tally.is_good(COVERAGE))
}

/// Solves `count` random cases to the accuracies `asked` in turn; hands those with misses to `missed`, with what they miss.
pub(crate) fn counted(
    count: usize,
    seed: u64,
    asked: &[f64],
    mut missed: impl FnMut(usize, &Draw, f64, &str),
) -> Tally {
    let mut rng = StdRng::seed_from_u64(seed);
    let draws: Vec<Draw> = (0..count).map(|_| Draw::new(&mut rng)).collect();
    let asked = |case: usize| asked[case % asked.len()];
    let compared = draws.par_iter().enumerate();
    let compared: Vec<_> = compared.map(|(k, draw)| compare(draw, asked(k))).collect();
    let mut tally = Tally::default();
    for (case, (compared, draw)) in compared.into_iter().zip(&draws).enumerate() {
        let misses = match compared {
            Ok(compared) => tally.add(&compared, asked(case)),
            Err(why) => tally.failed(case, &why),
        };
        if !misses.is_empty() {
            missed(case, draw, asked(case), &misses);
        }
    }
    tally
}

/// What the answer to a draw says, beside a finer one.
struct Compared {
    numbers: Vec<Number>,
    is_reached: bool,
    /// Whether peak pressure and stress lie within what was asked.
    is_met: bool,
    nodes: usize,
    increments: usize,
}

/// A number that is stated with an error.
struct Number {
    name: &'static str,
    step: usize,
    unloading: bool,
    /// The number and what it should be.
    values: [f64; 2],
    /// The errors of both, where both are stated.
    errors: Option<[f64; 2]>,
}

/// Solves `draw` to the accuracy `asked` and finer.
fn compare(draw: &Draw, asked: f64) -> Result<Compared, String> {
    let accuracy = format!("analysis.accuracy={asked}");
    let found = solved(&draw.text, &[&accuracy])?;
    let Some(ladder) = &found.ladder else {
        return Err("no ladder".into());
    };
    let Some(last) = ladder.rungs.last() else {
        return Err("no rung".into());
    };
    let increments = (FINER * last.most_increments()).min(FINEST);
    let increments = format!("analysis.substeps={increments}");
    let mut finer = vec![
        &*increments,
        "analysis.ramp=quadratic",
        "analysis.accuracy=1e-8",
    ];
    if draw.chooses_kinematics {
        finer.push("analysis.kinematics=deformed-gaps");
    }
    let truth = solved(&draw.text, &finer)?;
    let mut compared = Compared {
        numbers: Vec::new(),
        is_reached: ladder.end == LadderEnd::Reached,
        is_met: true,
        nodes: found.edges[0].parameter.len(),
        increments: last.most_increments(),
    };
    let (geometry, exact_geometry) = (&found.edges[0], &truth.edges[0]);
    for (step, (found, truth)) in found.steps.iter().zip(&truth.steps).enumerate() {
        let unloading = found.unloading;
        let (edge, truth) = (&found.edges[0], &truth.edges[0]);
        let along = along::numbers(
            (geometry, edge),
            (exact_geometry, truth),
            (step + 1, unloading),
        );
        compared.numbers.extend(along);
        for stated in Stated::ALL
            .into_iter()
            .filter(|stated| !BALANCED.contains(stated))
        {
            let (Some(value), Some(exact)) = (stated.value(edge), stated.value(truth)) else {
                continue;
            };
            let errors = [edge, truth].map(|edge| edge.errors.get(stated));
            let errors = match errors {
                [Some(own), Some(doubt)] => Some([own, doubt]),
                _ => None,
            };
            let is_asked = matches!(stated, Stated::PeakPressure | Stated::PeakHoop);
            compared.is_met &= !is_asked
                || errors
                    .is_none_or(|[_, doubt]| (value - exact).abs() <= asked * exact.abs() + doubt);
            compared.numbers.push(Number {
                name: stated.describe(),
                step: step + 1,
                unloading,
                values: [value, exact],
                errors,
            });
        }
    }
    for (own, truth) in found.failure.iter().zip(&truth.failure) {
        let unloading = |step: usize| found.steps[step].unloading;
        compared
            .numbers
            .extend(failure::numbers(own, truth, unloading));
    }
    Ok(compared)
}

fn solved(text: &str, changes: &[&str]) -> Result<Results, String> {
    let base = std::path::Path::new("");
    let scene = Scene::from_text_on(
        text,
        Format::Toml,
        "case.toml",
        base,
        changes,
        stickslip::host::HOST,
    )
    .map_err(|error| error.to_string())?;
    run(&scene, &mut |_| {}).map_err(|error| error.to_string())
}
