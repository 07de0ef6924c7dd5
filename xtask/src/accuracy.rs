//! `cargo xtask accuracy`: how often stated errors hold the truth.
//!
//! Random pins in holes are solved to an accuracy, and once more on the finest nodes with eight times as many increments, where the program chose the geometry
//! on the deformed one; general outlines on a mesh several times finer with four times as many increments. A number counts where the finer answer is itself good
//! to a third of the error that is tested.

mod along;
mod clock;
mod draw;
mod failure;
mod numbers;
mod outlines;
mod tally;

use numbers::{At, Compared, Number};
use std::error::Error;
use std::fs;
use std::path::PathBuf;

use clap::Args;
use rand::SeedableRng;
use rand::rngs::StdRng;
use rayon::prelude::*;
use stickslip::results::{
    EdgeGeometry, EdgeResults, LadderEnd, Results, SetNumbers, SetStated, Stated,
};
use stickslip::run::run;
use stickslip::scene::{Format, Scene};

use draw::Draw;
use tally::Tally;

/// Cases of a quick count.
pub(crate) const FEW: usize = 50;
/// Accuracies that are asked for.
pub(crate) const ASKED: [f64; 3] = [0.05, 0.01, 0.001];
/// Most increments of a step of the truth, or twice as many as the answer has.
const FINEST: usize = 128;
/// How many times as many increments the truth has; on a finer mesh they are compared with four times as many again.
const FINER: usize = 8;
const FINER_OF_MESH: usize = 2;
/// Numbers that follow from equilibrium to rounding.
const BALANCED: [Stated; 3] = [Stated::Bearing, Stated::ResultantX, Stated::ResultantY];
/// Least share of numbers within their stated error.
pub(crate) const COVERAGE: f64 = 0.95;

/// What is drawn at random.
pub(crate) struct Drawn {
    name: &'static str,
    /// Families that follow each other, each of which meets all accuracies.
    families: usize,
    draw: fn(usize, &mut StdRng) -> Draw,
}

/// Pins in strips.
pub(crate) const PINS: Drawn = Drawn {
    name: "pins",
    families: 1,
    draw: Draw::pin,
};
/// General outlines.
const OUTLINES: Drawn = Drawn {
    name: "outlines",
    families: 4,
    draw: outlines::draw,
};

#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Few cases.
    #[arg(long)]
    quick: bool,
    /// General outlines instead of pins in strips: holes anywhere, lugs, open edges, several fasteners.
    #[arg(long)]
    outlines: bool,
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
    let drawn = if options.outlines { &OUTLINES } else { &PINS };
    let random = (count, options.seed);
    let tally = counted(random, drawn, asked, |case, draw, asked, misses| {
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
    let text = tally.text(count, drawn.name, options.seed);
    println!("{text}");
    if let Some(path) = &options.output {
        fs::write(path, &text).map_err(|error| format!("{}: {error}", path.display()))?;
    }
    Ok(tally.is_good(COVERAGE))
}

/// Solves `count` random cases of `drawn` to the accuracies `asked` in turn; hands those with misses to `missed`, with what they miss.
pub(crate) fn counted(
    (count, seed): (usize, u64),
    drawn: &Drawn,
    asked: &[f64],
    mut missed: impl FnMut(usize, &Draw, f64, &str),
) -> Tally {
    let mut rng = StdRng::seed_from_u64(seed);
    let draws: Vec<Draw> = (0..count)
        .map(|case| (drawn.draw)(case, &mut rng))
        .collect();
    let asked = |case: usize| asked[(case / drawn.families) % asked.len()];
    let compared = draws.par_iter().enumerate();
    let compared = compared.map(|(k, draw)| {
        let compared = compare(draw, asked(k));
        let progress = progress(&compared, draw.family, asked(k));
        eprintln!("case {k}, {}: {}", draw.family, progress.trim_end());
        compared
    });
    let compared: Vec<_> = compared.collect();
    let mut tally = Tally::default();
    for (case, (compared, draw)) in compared.into_iter().zip(&draws).enumerate() {
        let misses = match compared {
            Ok(compared) => tally.add(&compared, draw.family, asked(case)),
            Err(why) => tally.failed(case, draw.family, &why),
        };
        if !misses.is_empty() {
            missed(case, draw, asked(case), &misses);
        }
    }
    tally
}

/// What is known of a case as soon as it is compared.
fn progress(compared: &Result<Compared, String>, family: &'static str, asked: f64) -> String {
    let compared = match compared {
        Ok(compared) => compared,
        Err(why) => return why.clone(),
    };
    let mut own = Tally::default();
    let misses = own.add(compared, family, asked);
    let (held, decided) = own.total();
    let reached = if compared.is_reached {
        "reached"
    } else {
        "not reached"
    };
    format!("{reached}, {held} of {decided} decided numbers within\n{misses}")
}

/// Solves `draw` to the accuracy `asked` and finer.
fn compare(draw: &Draw, asked: f64) -> Result<Compared, String> {
    let accuracy = format!("analysis.accuracy={asked}");
    let found = solved(&draw.text, &[&accuracy])?;
    let Some(ladder) = &found.ladder else {
        return Err("no ladder".into());
    };
    let Some(last) = ladder.rungs.iter().rfind(|rung| !rung.stopped) else {
        return Err("no rung".into());
    };
    let truth = truth(draw, last.most_increments())?;
    let mut compared = Compared {
        numbers: Vec::new(),
        is_reached: ladder.end == LadderEnd::Reached,
        is_met: true,
        nodes: found.edges[0].parameter.len(),
        increments: last.most_increments(),
    };
    for (step, (own, exact)) in found.steps.iter().zip(&truth.steps).enumerate() {
        let edges = own.edges.iter().zip(&exact.edges).enumerate();
        for (edge, (own_edge, exact_edge)) in edges {
            let at = At {
                step: step + 1,
                unloading: own.unloading,
            };
            let geometries = [&found.edges[edge], &truth.edges[edge]];
            compared.add(geometries, [own_edge, exact_edge], (at, draw, asked));
        }
    }
    for (step, set) in
        (0..found.steps.len()).flat_map(|step| (0..found.sets.len()).map(move |set| (step, set)))
    {
        compared.add_set([&found, &truth], step, set);
    }
    for (own, truth) in found.failure.iter().zip(&truth.failure) {
        let unloading = |step: usize| found.steps[step].unloading;
        compared
            .numbers
            .extend(failure::numbers(own, truth, unloading));
    }
    Ok(compared)
}

/// The answer to `draw` on its finest division, which took `increments` to the accuracy that was asked.
fn truth(draw: &Draw, increments: usize) -> Result<Results, String> {
    let times = if draw.finest.is_empty() {
        FINER
    } else {
        FINER_OF_MESH
    };
    let most = (2 * increments).max(FINEST / FINER * times);
    let increments = (times * increments).min(most);
    let increments = format!("analysis.substeps={increments}");
    let mut finer = vec![
        &*increments,
        "analysis.ramp=contact",
        "analysis.accuracy=1e-8",
    ];
    if draw.chooses_kinematics {
        finer.push("analysis.kinematics=deformed-gaps");
    }
    finer.extend(draw.finest.iter().map(String::as_str));
    solved(&draw.text, &finer)
}

impl Compared {
    /// Adds the numbers of the set with this index in a step beside those of the truth, but what is given.
    fn add_set(&mut self, [found, truth]: [&Results; 2], step: usize, set: usize) {
        for stated in SetStated::ALL {
            let get = |own: SetNumbers| own.get(stated);
            let [value, exact] = [found, truth].map(|own| get(own.set_numbers(set, step)));
            let [error, doubt] = [found, truth].map(|own| get(own.set_errors(set, step)));
            if let (Some(value), Some(exact), Some(error), Some(doubt)) =
                (value, exact, error, doubt)
            {
                self.numbers.push(Number {
                    name: stated.describe(),
                    step: step + 1,
                    unloading: found.steps[step].unloading,
                    values: [value, exact],
                    errors: Some([error, doubt]),
                });
            }
        }
    }

    /// Adds the numbers of an edge in a step beside those of the truth.
    fn add(
        &mut self,
        [geometry, exact_geometry]: [&EdgeGeometry; 2],
        [edge, truth]: [&EdgeResults; 2],
        (at, draw, asked): (At, &Draw, f64),
    ) {
        let along = along::numbers((geometry, edge), (exact_geometry, truth), at);
        self.numbers.extend(along);
        let stated = Stated::ALL.into_iter();
        for stated in stated.filter(|own| !(draw.is_balanced && BALANCED.contains(own))) {
            let (Some(value), Some(exact)) = (stated.value(edge), stated.value(truth)) else {
                continue;
            };
            let errors = [edge, truth].map(|edge| edge.errors.get(stated));
            let errors = match errors {
                [Some(own), Some(doubt)] => Some([own, doubt]),
                _ => None,
            };
            let is_asked = matches!(stated, Stated::PeakPressure | Stated::PeakHoop);
            self.is_met &= !is_asked
                || errors
                    .is_none_or(|[_, doubt]| (value - exact).abs() <= asked * exact.abs() + doubt);
            self.numbers.push(Number {
                name: stated.describe(),
                step: at.step,
                unloading: at.unloading,
                values: [value, exact],
                errors,
            });
        }
    }
}

fn solved(text: &str, changes: &[&str]) -> Result<Results, String> {
    let base = std::path::Path::new("");
    let scene = Scene::from_text_on(text, Format::Toml, "case.toml", base, changes, clock::HOST)
        .map_err(|error| error.to_string())?;
    run(&scene, &mut |_| {}).map_err(|error| error.to_string())
}
