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
use stickslip_report::folder::write_atomic;

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
    checks: fn(&Laboratory) -> Result<Vec<Check>, Trouble>,
}

const CASES: [Case; 24] = [
    Case {
        name: "elements",
        title: "Elements",
        friction: false,
        checks: elements::checks,
    },
    Case {
        name: "open-hole",
        title: "Open holes",
        friction: false,
        checks: open_hole::checks,
    },
    Case {
        name: "cosine-load",
        title: "Holes with an assumed cosine pressure",
        friction: false,
        checks: cosine_load::checks,
    },
    Case {
        name: "laminates",
        title: "Laminates",
        friction: false,
        checks: laminates::checks,
    },
    Case {
        name: "criteria",
        title: "Failure criteria",
        friction: false,
        checks: criteria::checks,
    },
    Case {
        name: "ply-states",
        title: "Residual stress, coupling and yield of plies",
        friction: false,
        checks: ply_states::checks,
    },
    Case {
        name: "joint-modes",
        title: "Laminated joints to their end",
        friction: false,
        checks: joint_modes::checks,
    },
    Case {
        name: "hybrid-sensitivity",
        title: "Measured displacements: what their errors do",
        friction: false,
        checks: sensitivity::checks,
    },
    Case {
        name: "hybrid-errors",
        title: "Measured displacements: covariance, reductions, fringe phase",
        friction: false,
        checks: hybrid::errors,
    },
    Case {
        name: "closed-loop",
        title: "Friction from fringe pictures",
        friction: false,
        checks: closed_loop::checks,
    },
    Case {
        name: "hybrid-laws",
        title: "Friction laws fitted by contact solves",
        friction: false,
        checks: laws::checks,
    },
    Case {
        name: "persson",
        title: "Frictionless pin of the plate's material",
        friction: false,
        checks: persson::checks,
    },
    Case {
        name: "hertz",
        title: "Hertz",
        friction: false,
        checks: line_contact::hertz,
    },
    Case {
        name: "cattaneo",
        title: "Cattaneo–Mindlin",
        friction: true,
        checks: line_contact::cattaneo,
    },
    Case {
        name: "rigid-pin-frictionless",
        title: "Rigid pin, orthotropic plate, frictionless",
        friction: false,
        checks: rigid_pin::frictionless,
    },
    Case {
        name: "rigid-pin-friction",
        title: "Rigid pin, orthotropic plate, friction",
        friction: true,
        checks: rigid_pin::frictional,
    },
    Case {
        name: "pin-orthotropic",
        title: "Steel pin, orthotropic strip",
        friction: false,
        checks: pins::orthotropic,
    },
    Case {
        name: "press-fit",
        title: "Press fits of a pin and two rings",
        friction: false,
        checks: press_fit::checks,
    },
    Case {
        name: "interference",
        title: "Pin with interference",
        friction: false,
        checks: pins::interference,
    },
    Case {
        name: "aluminium-frictionless",
        title: "Aluminium plate, frictionless",
        friction: false,
        checks: aluminium::frictionless,
    },
    Case {
        name: "aluminium-friction",
        title: "Aluminium plate, friction",
        friction: true,
        checks: aluminium::frictional,
    },
    Case {
        name: "shear-sign",
        title: "Pin in a quasi-isotropic laminate: sign of the shear, matrix cracks",
        friction: true,
        checks: shear_sign::checks,
    },
    Case {
        name: "benchmark-frictionless",
        title: "Pin benchmark, frictionless",
        friction: false,
        checks: benchmark::frictionless,
    },
    Case {
        name: "benchmark-friction",
        title: "Pin benchmark, friction",
        friction: true,
        checks: benchmark::frictional,
    },
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
