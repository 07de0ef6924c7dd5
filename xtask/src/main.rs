//! Tasks on the whole workspace: `cargo xtask validate` compares the library with known solutions, `cargo xtask
//! stability` shows where methods fail.

mod validate;

use std::process::ExitCode;

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
}

fn main() -> ExitCode {
    match Arguments::parse().task {
        Task::Validate(options) => validate::main(&options),
    }
}
