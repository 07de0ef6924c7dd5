//! `cargo xtask docs`: the tables of keys in `docs/scene-format.md`, written from the declarations.

use std::fs;

use clap::Args;
use stickslip::folder::write_atomic;
use stickslip::scene::keys::document;

use crate::publish::{TaskError, root};

/// Whether the document is written.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Writes nothing; fails if the tables differ from the declarations.
    #[arg(long)]
    check: bool,
}

pub(crate) fn main(options: &Options) -> Result<bool, TaskError> {
    let path = root().join("docs/scene-format.md");
    let text = fs::read_to_string(&path)?;
    let written = document(&text).map_err(|cause| format!("docs/scene-format.md: {cause}"))?;
    if written == text {
        println!("docs/scene-format.md has the keys that are declared");
        return Ok(true);
    }
    if options.check {
        return Err(
            "docs/scene-format.md differs from the declarations: run `cargo xtask docs`".into(),
        );
    }
    write_atomic(&path, written.as_bytes())?;
    println!("wrote docs/scene-format.md");
    Ok(true)
}
