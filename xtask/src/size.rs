//! `cargo xtask size`: lines of code of every crate, and whether they keep their bounds.
//!
//! A line counts if code stands on it: neither blank nor comment, and no test (`#[cfg(test)]`, folders named `tests`, files named
//! `tests.rs`). Sources, examples and benches count alike. Templates and TOML files are reported beside the code.

mod code;

use std::fmt::Display;
use std::fs;
use std::path::{Path, PathBuf};

use stickslip_tests::source;

use crate::publish::{TaskError, root};
use code::{Code, measure};

/// Most lines of code of a crate below `crates`.
const CRATE_BOUND: usize = 12_000;

/// The code of a crate.
struct Crate {
    /// Its folder, from the root of the workspace.
    folder: PathBuf,
    lines: usize,
    /// The longest file, from the crate's folder, and its lines of code.
    longest_file: (PathBuf, usize),
    /// The longest function and its lines from signature to brace.
    longest_function: (String, usize),
}

/// Counts, prints a table, and fails if a bound is exceeded.
pub(crate) fn main() -> Result<bool, TaskError> {
    let (text, excesses) = report(&root())?;
    println!("{text}");
    for excess in &excesses {
        eprintln!("{excess}");
    }
    Ok(excesses.is_empty())
}

/// The table, and a sentence for every bound that is exceeded.
fn report(root: &Path) -> Result<(String, Vec<String>), TaskError> {
    let mut crates = Vec::new();
    for folder in crate_folders(root)? {
        crates.push(count(root, &folder)?);
    }
    let whole: usize = crates.iter().map(|one| one.lines).sum();
    let toml = lines_of(root, &|path| {
        has_extension(path, "toml") && !is_manifest(path)
    })?;
    let templates = lines_of(root, &is_template)?;

    let mut rows = vec![row(
        "crate",
        "code",
        ("longest file", "code"),
        ("longest function", "lines"),
    )];
    rows.extend(crates.iter().map(|one| {
        let (file, function) = (&one.longest_file, &one.longest_function);
        row(
            one.folder.display(),
            one.lines,
            (file.0.display(), file.1),
            (&function.0, function.1),
        )
    }));
    for (name, lines) in [
        ("all code", whole),
        ("templates", templates),
        ("TOML", toml),
    ] {
        rows.push(row(name, lines, ("", ""), ("", "")));
    }
    Ok((rows.join("\n"), excesses(&crates)))
}

fn row(
    name: impl Display,
    code: impl Display,
    (file, file_code): (impl Display, impl Display),
    (function, function_lines): (impl Display, impl Display),
) -> String {
    let row = format!(
        "{:<20} {code:>6}  {:<34} {file_code:>6}  {:<24} {function_lines:>6}",
        name.to_string(),
        file.to_string(),
        function.to_string(),
    );
    row.trim_end().to_owned()
}

fn excesses(crates: &[Crate]) -> Vec<String> {
    let large = crates
        .iter()
        .filter(|one| one.folder.starts_with("crates") && one.lines > CRATE_BOUND);
    let sentence = |one: &Crate| {
        let (folder, lines) = (one.folder.display(), one.lines);
        format!("{folder}: {lines} lines of code, at most {CRATE_BOUND} are allowed")
    };
    large.map(sentence).collect()
}

/// Folders of the workspace that hold a manifest, from its root; the tests of the workspace are no code.
fn crate_folders(root: &Path) -> Result<Vec<PathBuf>, TaskError> {
    let mut folders = vec![PathBuf::from("xtask")];
    for parent in ["crates", "examples", "xtask"] {
        for entry in fs::read_dir(root.join(parent))? {
            let entry = entry?;
            if entry.path().join("Cargo.toml").is_file() {
                folders.push(Path::new(parent).join(entry.file_name()));
            }
        }
    }
    folders.sort();
    Ok(folders)
}

/// Counts the code of the crate in `folder`, without that of crates in folders below it.
fn count(root: &Path, folder: &Path) -> Result<Crate, TaskError> {
    let base = root.join(folder);
    let mut counted = Crate {
        folder: folder.to_owned(),
        lines: 0,
        longest_file: (PathBuf::new(), 0),
        longest_function: (String::new(), 0),
    };
    let parts = ["src", "examples", "benches"].map(|part| base.join(part));
    for part in parts.iter().filter(|part| part.is_dir()) {
        for file in source::files(part)? {
            let name = file.strip_prefix(&base).unwrap_or(&file).to_owned();
            let code = measure(&fs::read_to_string(&file)?)
                .map_err(|cause| format!("{}: {cause}", file.display()))?;
            counted.add(name, code);
        }
    }
    Ok(counted)
}

impl Crate {
    fn add(&mut self, file: PathBuf, code: Code) {
        self.lines += code.lines;
        if code.lines > self.longest_file.1 {
            self.longest_file = (file, code.lines);
        }
        for (name, lines) in code.functions {
            if lines > self.longest_function.1 {
                self.longest_function = (name, lines);
            }
        }
    }
}

/// Lines, neither blank nor starting with `#`, of all files below `folder` that are `wanted`, without build products and hidden folders.
fn lines_of(folder: &Path, wanted: &dyn Fn(&Path) -> bool) -> Result<usize, TaskError> {
    let mut lines = 0;
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let (path, name) = (entry.path(), entry.file_name());
        let name = name.to_string_lossy();
        if path.is_dir() {
            if name != "target" && name != "tests" && !name.starts_with('.') {
                lines += lines_of(&path, wanted)?;
            }
        } else if wanted(&path) {
            let text = fs::read_to_string(&path)?;
            let code = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
            lines += text.lines().filter(code).count();
        }
    }
    Ok(lines)
}

fn has_extension(path: &Path, extension: &str) -> bool {
    path.extension().is_some_and(|other| other == extension)
}

fn is_manifest(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == "Cargo.toml")
}

/// Texts between the sources from which pages and messages are made; TOML is counted by itself, and tables, programs of others and what
/// tasks read or mutate in folders named `inputs` do not count.
fn is_template(path: &Path) -> bool {
    let other = ["rs", "toml", "csv", "py"];
    let is_in = |name: &str| path.iter().any(|folder| folder == name);
    is_in("src") && !is_in("inputs") && !other.iter().any(|end| has_extension(path, end))
}
