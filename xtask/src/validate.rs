//! `cargo xtask validate`: computed quantities beside known solutions, in one table.
//!
//! Every case runs scenes of this repository through the library, as a user would, and compares them with closed forms, with
//! independently derived tables, or with measured runs of other programs. A bound that is missed fails the task. With
//! `--mutate` the cases with friction run again with friction wrong in three ways, and each has to notice: a physical quantity
//! misses its bound, or the load is proved impossible. A run that stops without a proof counts as not noticed.
//!
//! A case is an entry of `validate/cases.toml` and a line of [`CHECKERS`].

mod aluminium;
mod benchmark;
mod check;
mod closed_loop;
mod cosine_load;
mod criteria;
mod elements;
mod half_planes;
mod hybrid;
mod joint_modes;
mod laboratory;
mod laminates;
mod laws;
mod line_contact;
mod lugs;
mod mutants;
mod mutation;
mod open_hole;
mod persson;
mod pins;
mod ply_states;
mod press_fit;
mod punch;
mod region_cost;
mod render;
mod rigid_pin;
mod rows;
mod sensitivity;
mod shear_sign;
mod stated_errors;

use clap::Args;
use serde::Deserialize;
use stickslip::folder::write_atomic;

use check::{Check, Checks, Verdict};
use laboratory::{Laboratory, Size};
use mutation::Mutation;

use crate::publish::{TaskError, listed, root};

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

type Checker = fn(&Laboratory) -> Result<Vec<Check>, TaskError>;

/// What makes the checks of each case, in the order of `cases.toml`.
const CHECKERS: [(&str, Checker); 29] = [
    ("elements", elements::checks),
    ("open-hole", open_hole::checks),
    ("cosine-load", cosine_load::checks),
    ("laminates", laminates::checks),
    ("criteria", criteria::checks),
    ("ply-states", ply_states::checks),
    ("joint-modes", joint_modes::checks),
    ("hybrid-sensitivity", sensitivity::checks),
    ("hybrid-errors", hybrid::errors),
    ("closed-loop", closed_loop::checks),
    ("hybrid-laws", laws::checks),
    ("persson", persson::checks),
    ("hertz", line_contact::hertz),
    ("cattaneo", line_contact::cattaneo),
    ("half-planes", half_planes::checks),
    ("punch", punch::checks),
    ("rigid-pin-frictionless", rigid_pin::frictionless),
    ("rigid-pin-friction", rigid_pin::frictional),
    ("pin-orthotropic", pins::orthotropic),
    ("lugs", lugs::checks),
    ("rows", rows::checks),
    ("press-fit", press_fit::checks),
    ("interference", pins::interference),
    ("aluminium-frictionless", aluminium::frictionless),
    ("aluminium-friction", aluminium::frictional),
    ("shear-sign", shear_sign::checks),
    ("benchmark-frictionless", benchmark::frictionless),
    ("benchmark-friction", benchmark::frictional),
    ("stated-errors", stated_errors::checks),
];

/// Something known, and the scenes that should reproduce it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    name: String,
    title: String,
    #[serde(default)]
    friction: bool,
}

impl Case {
    fn checks(&self, laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
        let own = CHECKERS.iter().find(|(name, _)| *name == self.name);
        let (_, checker) = own.ok_or_else(|| format!("nothing checks {}", self.name))?;
        checker(laboratory)
    }
}

/// A case and what came of it.
pub(crate) struct Outcome {
    pub(crate) title: String,
    pub(crate) checks: Vec<Check>,
}

/// Runs the task: table on stdout, progress on stderr.
pub(crate) fn main(options: &Options) -> Result<bool, TaskError> {
    let only = options.only.as_deref().unwrap_or_default();
    let all: Vec<Case> = listed(include_str!("validate/cases.toml"), "cases")?;
    let chosen: Vec<&Case> = all.iter().filter(|case| case.name.contains(only)).collect();
    if chosen.is_empty() {
        let names: Vec<&str> = all.iter().map(|case| case.name.as_str()).collect();
        let names = names.join(", ");
        return Err(format!("no case has that in its name; the cases are {names}").into());
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
    if options.write {
        let path = root().join("docs/validation.md");
        write_atomic(&path, render::markdown(&outcomes).as_bytes())?;
    }
    let failed = |outcome: &Outcome| outcome.checks.iter().any(|c| c.verdict == Verdict::Fail);
    Ok(!outcomes.iter().any(failed))
}

/// The checks of a case; one that cannot be computed has failed.
fn run(case: &Case, laboratory: &Laboratory) -> Outcome {
    eprintln!("{}", case.title);
    let checks = case.checks(laboratory).unwrap_or_else(|error| {
        let mut checks = Checks::default();
        checks.completes("all scenes are solved", "", error.to_string(), false);
        checks.into_list()
    });
    Outcome {
        title: case.title.clone(),
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
            checks.rounding_below(format!("{name}, worst of {runs}"), worst, RESIDUAL);
        }
    }
    Outcome {
        title: "Residuals".to_owned(),
        checks: checks.into_list(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_has_its_checks() {
        let cases: Vec<Case> = listed(include_str!("validate/cases.toml"), "cases").unwrap();
        let names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
        assert_eq!(names, CHECKERS.map(|(name, _)| name));
    }
}
