//! `cargo xtask docs`: the tables of keys in `docs/scene-format.md`, written from the declarations.

use std::fs;
use std::path::Path;
use std::process::ExitCode;

use clap::Args;
use stickslip::folder::write_atomic;
use stickslip::scene::keys::document;

use crate::publish::Trouble;

/// Whether the document is written.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Writes nothing; fails if the tables differ from the declarations.
    #[arg(long)]
    check: bool,
}

pub(crate) fn main(options: &Options) -> ExitCode {
    match update(options) {
        Ok(message) => {
            println!("{message}");
            ExitCode::SUCCESS
        }
        Err(trouble) => {
            eprintln!("{trouble}");
            ExitCode::FAILURE
        }
    }
}

fn update(options: &Options) -> Result<String, Trouble> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/scene-format.md");
    let text = fs::read_to_string(&path)?;
    let written = document(&text).map_err(|cause| format!("docs/scene-format.md: {cause}"))?;
    if written == text {
        return Ok("docs/scene-format.md has the keys that are declared".to_owned());
    }
    if options.check {
        return Err(
            "docs/scene-format.md differs from the declarations: run `cargo xtask docs`".into(),
        );
    }
    write_atomic(&path, written.as_bytes())?;
    Ok("wrote docs/scene-format.md".to_owned())
}
