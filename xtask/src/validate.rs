//! `cargo xtask validate`: computed quantities beside known solutions, in one table.
//!
//! Every case runs scenes of this repository through the library, as a user would, and compares them with closed forms, with
//! independently derived tables, or with measured runs of other programs. A bound that is missed fails the task. With
//! `--mutate` the cases with friction run again with friction wrong in three ways, and each has to notice: a physical quantity
//! misses its bound, or the load is proved impossible. A run that stops without a proof counts as not noticed.

mod aluminium;
mod benchmark;
mod check;
mod closed_loop;
mod cosine_load;
mod criteria;
mod elements;
mod hybrid;
mod joint_modes;
mod laboratory;
mod laminates;
mod laws;
mod line_contact;
mod mutants;
mod mutation;
mod open_hole;
mod persson;
mod pins;
mod ply_states;
mod press_fit;
mod region_cost;
mod render;
mod rigid_pin;
mod sensitivity;
mod shear_sign;

use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use stickslip::folder::write_atomic;

use check::{Check, Checks, Verdict};
use laboratory::{Laboratory, Size, Trouble};
use mutation::Mutation;

/// Largest relative residual of any step.
const RESIDUAL: f64 = 1e-10;

/// What to validate.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Coarser meshes and fewer of them: at most a minute.
    #[arg(long)]
    quick: bool,
    /// Runs the cases with friction again (on the quick meshes) with friction wrong, and fails if one does not notice.
    #[arg(long)]
    mutate: bool,
    /// Only cases whose name contains this.
    #[arg(long, value_name = "NAME")]
    only: Option<String>,
    /// Writes the table to docs/validation.md.
    #[arg(long, conflicts_with_all = ["quick", "only"])]
    write: bool,
}

/// Something known, and the scenes that should reproduce it.
struct Case {
    name: &'static str,
    title: &'static str,
    /// Whether friction decides quantities with a bound, so that a mistake in it must show.
    friction: bool,
    checks: Checker,
}

type Checker = fn(&Laboratory) -> Result<Vec<Check>, Trouble>;

impl Case {
    const fn new(name: &'static str, title: &'static str, checks: Checker) -> Self {
        Self {
            name,
            title,
            friction: false,
            checks,
        }
    }

    const fn of_friction(self) -> Self {
        Self {
            friction: true,
            ..self
        }
    }
}

const CASES: [Case; 24] = [
    Case::new("elements", "Elements", elements::checks),
    Case::new("open-hole", "Open holes", open_hole::checks),
    Case::new(
        "cosine-load",
        "Holes with an assumed cosine pressure",
        cosine_load::checks,
    ),
    Case::new("laminates", "Laminates", laminates::checks),
    Case::new("criteria", "Failure criteria", criteria::checks),
    Case::new(
        "ply-states",
        "Residual stress, coupling and yield of plies",
        ply_states::checks,
    ),
    Case::new(
        "joint-modes",
        "Laminated joints to their end",
        joint_modes::checks,
    ),
    Case::new(
        "hybrid-sensitivity",
        "Measured displacements: what their errors do",
        sensitivity::checks,
    ),
    Case::new(
        "hybrid-errors",
        "Measured displacements: covariance, reductions, fringe phase",
        hybrid::errors,
    ),
    Case::new(
        "closed-loop",
        "Friction from fringe pictures",
        closed_loop::checks,
    ),
    Case::new(
        "hybrid-laws",
        "Friction laws fitted by contact solves",
        laws::checks,
    ),
    Case::new(
        "persson",
        "Frictionless pin of the plate's material",
        persson::checks,
    ),
    Case::new("hertz", "Hertz", line_contact::hertz),
    Case::new("cattaneo", "Cattaneo–Mindlin", line_contact::cattaneo).of_friction(),
    Case::new(
        "rigid-pin-frictionless",
        "Rigid pin, orthotropic plate, frictionless",
        rigid_pin::frictionless,
    ),
    Case::new(
        "rigid-pin-friction",
        "Rigid pin, orthotropic plate, friction",
        rigid_pin::frictional,
    )
    .of_friction(),
    Case::new(
        "pin-orthotropic",
        "Steel pin, orthotropic strip",
        pins::orthotropic,
    ),
    Case::new(
        "press-fit",
        "Press fits of a pin and two rings",
        press_fit::checks,
    ),
    Case::new("interference", "Pin with interference", pins::interference),
    Case::new(
        "aluminium-frictionless",
        "Aluminium plate, frictionless",
        aluminium::frictionless,
    ),
    Case::new(
        "aluminium-friction",
        "Aluminium plate, friction",
        aluminium::frictional,
    )
    .of_friction(),
    Case::new(
        "shear-sign",
        "Pin in a quasi-isotropic laminate: sign of the shear, matrix cracks",
        shear_sign::checks,
    )
    .of_friction(),
    Case::new(
        "benchmark-frictionless",
        "Pin benchmark, frictionless",
        benchmark::frictionless,
    ),
    Case::new(
        "benchmark-friction",
        "Pin benchmark, friction",
        benchmark::frictional,
    )
    .of_friction(),
];

/// A case and what came of it.
pub(crate) struct Outcome {
    pub(crate) title: &'static str,
    pub(crate) checks: Vec<Check>,
}

/// Runs the task: table on stdout, progress on stderr.
pub(crate) fn main(options: &Options) -> ExitCode {
    let start = Instant::now();
    let chosen: Vec<&Case> = CASES
        .iter()
        .filter(|case| {
            options
                .only
                .as_ref()
                .is_none_or(|name| case.name.contains(name.as_str()))
        })
        .collect();
    if chosen.is_empty() {
        let names: Vec<&str> = CASES.iter().map(|case| case.name).collect();
        eprintln!(
            "no case has that in its name; the cases are {}",
            names.join(", ")
        );
        return ExitCode::FAILURE;
    }
    let size = if options.quick {
        Size::Quick
    } else {
        Size::Full
    };
    let laboratory = Laboratory::new(size, Mutation::None);
    let mut outcomes: Vec<Outcome> = chosen.iter().map(|case| run(case, &laboratory)).collect();
    outcomes.push(residuals(&laboratory));
    if options.mutate {
        outcomes.push(mutants::outcome(&chosen));
    }
    print!("{}", render::text(&outcomes));
    eprintln!("{:.0} s", start.elapsed().as_secs_f64());
    if options.write {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/validation.md");
        if let Err(cause) = write_atomic(&path, render::markdown(&outcomes).as_bytes()) {
            eprintln!("{cause}");
            return ExitCode::FAILURE;
        }
    }
    let failed = |outcome: &Outcome| outcome.checks.iter().any(|c| c.verdict == Verdict::Fail);
    if outcomes.iter().any(failed) {
        ExitCode::FAILURE
    } else {
        ExitCode::SUCCESS
    }
}

/// The checks of a case; one that cannot be computed has failed.
fn run(case: &Case, laboratory: &Laboratory) -> Outcome {
    eprintln!("{}", case.title);
    let checks = (case.checks)(laboratory).unwrap_or_else(|trouble| {
        let mut checks = Checks::default();
        checks.completes("all scenes are solved", "", trouble.to_string(), false);
        checks.into_list()
    });
    Outcome {
        title: case.title,
        checks,
    }
}

/// Equilibrium and contact conditions over all runs.
fn residuals(laboratory: &Laboratory) -> Outcome {
    let worst = laboratory.residuals();
    let mut checks = Checks::against("statics; Signorini and Coulomb");
    if worst.runs > 0 {
        let runs = format!("{} runs, {} load steps", worst.runs, worst.steps);
        let kinds = [
            ("unbalanced force over the load", worst.balance),
            ("complementarity violation", worst.complementarity),
            ("friction cone violation", worst.cone),
        ];
        for (name, worst) in kinds {
            checks.rounding_below(
                format!("{name}, worst of {runs}"),
                worst.place,
                worst.value,
                RESIDUAL,
            );
        }
    }
    Outcome {
        title: "Residuals",
        checks: checks.into_list(),
    }
}
