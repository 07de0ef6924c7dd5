//! `cargo xtask accuracy`: how often stated errors hold the truth.
//!
//! Random pins in holes are solved to an accuracy, and once more on the finest nodes with eight times as many increments, where the program chose the geometry
//! on the deformed one. A number counts where the finer answer is itself good to a third of the error that is tested.

mod draw;
mod tally;

use std::error::Error;
use std::fs;
use std::path::PathBuf;

use clap::Args;
use rand::SeedableRng;
use rand::rngs::StdRng;
use stickslip::results::{LadderEnd, Results, Stated};
use stickslip::run::run;
use stickslip::scene::{Format, Scene};

use draw::Draw;
use tally::Tally;

/// Accuracies that are asked for.
const ASKED: [f64; 3] = [0.05, 0.01, 0.001];
/// Most increments of a step of the truth.
const FINEST: usize = 128;
/// How many times as many increments the truth has.
const FINER: usize = 8;
/// Least share of numbers within their stated error.
const COVERAGE: f64 = 0.95;

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
    /// Prints every number outside of its error.
    #[arg(long)]
    misses: bool,
    /// Where the table is written.
    #[arg(long)]
    output: Option<PathBuf>,
}

/// Solves the cases and prints the table; whether enough errors hold the truth.
pub(crate) fn main(options: &Options) -> Result<bool, Box<dyn Error + Send + Sync>> {
    let count = options
        .cases
        .unwrap_or(if options.quick { 50 } else { 500 });
    let mut rng = StdRng::seed_from_u64(options.seed);
    let mut tally = Tally::new(options.misses);
    for case in 0..count {
        let asked = if options.quick {
            ASKED[case % 2]
        } else {
            ASKED[case % 3]
        };
        let draw = Draw::new(&mut rng);
        if let Err(why) = compare(&draw, asked, &mut tally) {
            tally.failed(case, &why);
        }
    }
    let text = tally.text(count, options.seed);
    println!("{text}");
    if let Some(path) = &options.output {
        fs::write(path, &text).map_err(|error| format!("{}: {error}", path.display()))?;
    }
    Ok(tally.is_good(COVERAGE))
}

/// Solves `draw` to the accuracy `asked` and finer, and counts which errors hold.
fn compare(draw: &Draw, asked: f64, tally: &mut Tally) -> Result<(), String> {
    let accuracy = format!("analysis.accuracy={asked}");
    let found = solved(&draw.text, &[&accuracy])?;
    let Some(ladder) = &found.ladder else {
        return Err("no ladder".into());
    };
    let Some(last) = ladder.rungs.last() else {
        return Err("no rung".into());
    };
    let nodes = found.edges[0].parameter.len();
    let increments = (FINER * last.increments).min(FINEST);
    let increments = format!("analysis.substeps={increments}");
    let mut finer = vec![
        &increments,
        "analysis.ramp=quadratic",
        "analysis.accuracy=1e-8",
    ];
    if draw.chooses_kinematics {
        finer.push("analysis.kinematics=deformed-gaps");
    }
    let truth = solved(&draw.text, &finer)?;
    let is_reached = ladder.end == LadderEnd::Reached;
    let mut is_met = true;
    for (found, truth) in found.steps.iter().zip(&truth.steps) {
        let unloading = found.unloading;
        let (edge, truth) = (&found.edges[0], &truth.edges[0]);
        for stated in Stated::ALL {
            let (Some(value), Some(exact)) = (stated.value(edge), stated.value(truth)) else {
                continue;
            };
            let errors = [edge, truth].map(|edge| edge.errors.get(stated));
            let [Some(own), Some(doubt)] = errors else {
                tally.without(stated, unloading);
                continue;
            };
            let apart = (value - exact).abs();
            if tally.shows_misses && apart > own && doubt < apart {
                println!(
                    "{stated:?}: {value:e} ± {own:.2e}, {exact:e} ± {doubt:.2e}, {nodes} nodes, {} increments\n{}",
                    last.increments, draw.text
                );
            }
            tally.count(stated, unloading, [own, apart, doubt]);
            let is_asked = matches!(stated, Stated::PeakPressure | Stated::PeakHoop);
            is_met &= !is_asked || apart <= asked * exact.abs() + doubt;
        }
    }
    tally.asked(asked, is_reached, is_met);
    Ok(())
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
