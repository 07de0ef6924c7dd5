//! The command line.
//!
//! ```text
//! stickslip run SCENE [--output DIR] [--force]   solve a scene and write a folder of results
//! stickslip joint SWEEP [--output DIR] [--resume] sweep over joints: a table, maps of failure modes and a page
//! stickslip fringes EXPERIMENT [--output DIR]    synthetic fringe pictures of a scene
//! stickslip reduce EXPERIMENT [--output DIR]     measured fields from tables, fringe lines and pictures
//! stickslip hybrid EXPERIMENT [--output DIR]     edge stresses from measured fields, with bands and checks
//! stickslip identify EXPERIMENT [--output DIR]   friction from edge stresses, with intervals
//! stickslip check FILE [--sketch PICTURE]        check a scene and print it with all defaults, or check an experiment
//! stickslip init TEMPLATE [FILE]                 write a commented scene to start from
//! stickslip list [TOPIC]                         laws and their parameters, templates, elements, solvers, units, signs
//! ```
//!
//! `run` and `check` take any number of `--set KEY=VALUE`.
//!
//! Results go to standard output, errors and progress to standard error. The exit code is 0 only if everything succeeded: 1 for a
//! scene, run or file that failed, 2 for arguments that make no sense, 130 for a run that was interrupted (Ctrl-C), which leaves no
//! files. With `--json` both streams are JSON, one document each.
//!
//! A program that adds friction laws of its own is the same command: its `main` is one line,
//!
//! ```no_run
//! fn main() -> std::process::ExitCode {
//!     stickslip::cli::main()
//! }
//! ```
//!
//! because laws register themselves.

mod arguments;
mod check;
mod console;
mod experiment;
mod failure;
mod folder;
mod init;
mod interrupt;
mod joint;
mod list;
mod located;
mod memory;
mod run;

use arguments::SceneArguments;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use console::Console;
use failure::CommandError;
use stickslip_measure::chain::Depth;

/// Plane frictional contact of elastic bodies.
#[derive(Debug, Parser)]
#[command(name = "stickslip", version, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// Print nothing but errors
    #[arg(long, global = true)]
    quiet: bool,
    /// Print machine-readable JSON: results on standard output, errors on standard error
    #[arg(long, global = true)]
    json: bool,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Solve a scene and write tables, figures, fields and a page
    Run(run::RunArguments),
    /// Sweep over joints: a table, maps of failure modes and a page
    Joint(joint::JointArguments),
    /// Make synthetic fringe pictures of a scene: files, a gallery, and an experiment that reads them back
    Fringes(experiment::ExperimentArguments),
    /// Make measured fields of tables, fringe lines and fringe pictures, with their masks and deviations
    Reduce(experiment::ExperimentArguments),
    /// Find the stresses on an edge from measured displacements around it, with bands and checks
    Hybrid(experiment::ExperimentArguments),
    /// Find where an edge slips and its friction coefficients from measured displacements, with intervals
    Identify(experiment::ExperimentArguments),
    /// Check a scene, and print it with overrides applied and defaults filled in; or check an experiment with its data
    Check(check::CheckArguments),
    /// Write a commented scene to start from; never overwrites
    Init(init::InitArguments),
    /// List friction laws, loads, lay-ups, failure criteria, point models, templates, presets, elements, solvers, units, signs of results and keys
    List(list::ListArguments),
}

/// Prints what the parser of arguments has to say. Help and version are such "refusals" too, with exit code 0.
fn refused(refusal: &clap::Error) -> ExitCode {
    // The arguments could not be parsed, so that one is looked for by its name.
    let json = std::env::args_os().any(|argument| argument == "--json");
    if refusal.use_stderr() {
        if json {
            Console::new(false, true).fail(&CommandError::usage(refusal).into());
        } else {
            // The exit code reports the failure even if nobody can read the message.
            let _ = refusal.print();
        }
        return ExitCode::from(2);
    }
    // Nothing can be done if printing the help fails.
    let _ = refusal.print();
    ExitCode::SUCCESS
}

/// Runs the command on the arguments of the process.
pub fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(refusal) => return refused(&refusal),
    };
    let console = Console::new(arguments.quiet, arguments.json);
    let outcome = match arguments.command {
        Command::Run(scene) => run::run(&scene, console),
        Command::Joint(sweep) => joint::joint(&sweep, console),
        Command::Fringes(file) => experiment::experiment(&file, Depth::Fringes, console),
        Command::Reduce(file) => experiment::experiment(&file, Depth::Reduce, console),
        Command::Hybrid(file) => experiment::experiment(&file, Depth::Hybrid, console),
        Command::Identify(file) => experiment::experiment(&file, Depth::Identify, console),
        Command::Check(scene) => check::check(&scene, console),
        Command::Init(template) => init::init(&template, console),
        Command::List(topic) => list::list(&topic, console),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            console.fail(&failure);
            ExitCode::FAILURE
        }
    }
}
