//! What a writer finds, what it makes of it if nothing fails, and whether files are the one or the other.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::command::{Old, Writer, run};
use super::fault::{self, Call};
use super::files::{Contents, contents, write_all};
use super::said;
use crate::publish::root;

/// The table of a sweep, which grows row by row.
const TABLE: &str = "out/cases.csv";

/// Files of `run` and `joint` that state how long something took: two runs make the same bytes by chance only.
const TIMED: [&str; 3] = [TABLE, "out/report.html", "out/summary.json"];

/// A writer's files, and its system calls.
#[derive(Debug)]
pub(super) struct Prepared {
    /// All files before the command.
    pub(super) before: Contents,
    /// Files of the results, if nothing fails.
    pub(super) new: Contents,
    /// Those that differ from run to run, such as by times.
    varying: BTreeSet<PathBuf>,
    pub(super) calls: Vec<Call>,
}

impl Prepared {
    /// Runs the command without a fault, twice from the same files, and once more to see its calls.
    pub(super) fn of(writer: &Writer) -> io::Result<Self> {
        let before = before(writer)?;
        let made = || {
            let home = tempfile::tempdir()?;
            write_all(home.path(), &before)?;
            let output = run(&writer.arguments(), home.path())?;
            if !output.status.success() {
                return Err(io::Error::other(said(&output)));
            }
            contents(home.path())
        };
        let (new, second) = (results(made()?), results(made()?));
        let is_timed = |name: &Path| {
            matches!(writer.name(), "run" | "joint")
                && TIMED.iter().any(|file| name == Path::new(file))
        };
        let varies = |name: &&PathBuf| is_timed(name) || new.get(*name) != second.get(*name);
        let home = tempfile::tempdir()?;
        write_all(home.path(), &before)?;
        let log = tempfile::NamedTempFile::new()?;
        let calls = fault::calls(writer, home.path(), log.path())?;
        if calls.is_empty() {
            return Err(io::Error::other("strace shows no calls"));
        }
        Ok(Self {
            varying: new.keys().filter(varies).cloned().collect(),
            before,
            new,
            calls,
        })
    }

    /// Whether all results are the new ones.
    pub(super) fn is_new(&self, then: &Contents) -> bool {
        let then = results(then.clone());
        then.keys().eq(self.new.keys()) && then.iter().all(|(name, bytes)| self.made(name, bytes))
    }

    /// Whether a file is the one that the command makes.
    fn made(&self, name: &Path, bytes: &[u8]) -> bool {
        /// Bytes at the end by which a file is known to be whole.
        const END: usize = 8;
        let Some(new) = self.new.get(name) else {
            return false;
        };
        if !self.varying.contains(name) {
            return new == bytes;
        }
        match name.extension().and_then(|end| end.to_str()) {
            Some("json") => serde_json::from_slice::<Value>(bytes).is_ok(),
            _ => bytes.ends_with(&new[new.len().saturating_sub(END)..]),
        }
    }

    /// Whether results are old or new.
    pub(super) fn old_or_new(
        &self,
        writer: &Writer,
        then: &Contents,
        is_killed: bool,
    ) -> Result<(), String> {
        let (old, now) = (results(self.before.clone()), results(then.clone()));
        if now == old || self.is_new(then) {
            return Ok(());
        }
        // Files that are written one by one are whole, each for itself.
        let one_by_one = writer.1 == Old::Rows || (writer.1 == Old::Nothing && is_killed);
        let is_whole = |(name, bytes): &(&PathBuf, &Vec<u8>)| {
            old.get(*name) == Some(*bytes)
                || self.made(name, bytes)
                || (*name == Path::new(TABLE) && self.has_rows(&old, bytes))
        };
        let kept = old.keys().all(|name| now.contains_key(name));
        match now.iter().find(|file| !is_whole(file)) {
            None if one_by_one && (kept || writer.1 == Old::Nothing) => Ok(()),
            None => Err(format!("some of the files: {:?}", now.keys())),
            Some((name, bytes)) => Err(format!("{} has {} bytes", name.display(), bytes.len())),
        }
    }

    /// Whether a table has all old rows, and else rows of the new one, the last of which may be cut.
    fn has_rows(&self, old: &Contents, bytes: &[u8]) -> bool {
        let table = Path::new(TABLE);
        let rows = |bytes: Option<&[u8]>| -> Vec<String> {
            let text = String::from_utf8_lossy(bytes.unwrap_or_default()).into_owned();
            let lines = text.split_inclusive('\n');
            let whole = lines.filter(|line| line.ends_with('\n'));
            whole.map(without_time).collect()
        };
        let (now, new) = (
            rows(Some(bytes)),
            rows(self.new.get(table).map(Vec::as_slice)),
        );
        let old = rows(old.get(table).map(Vec::as_slice));
        now.starts_with(&old) && now.iter().all(|row| new.contains(row))
    }

    /// Whether all files that are no results are as before.
    pub(super) fn others(&self, then: &Contents) -> Result<(), String> {
        let is_lost = |(name, bytes): &(&PathBuf, &Vec<u8>)| {
            !is_result(name) && then.get(*name) != Some(*bytes)
        };
        match self.before.iter().find(is_lost) {
            None => Ok(()),
            Some((name, _)) => Err(format!("{} is lost or changed", name.display())),
        }
    }

    /// Whether a message names a file that the command reads or writes, a path in `home`, or the standard output.
    pub(super) fn names_a_file(&self, text: &str, home: &Path) -> bool {
        let files = self.before.keys().chain(self.new.keys());
        let mut names = files
            .map(PathBuf::as_path)
            .chain([home])
            .filter_map(|path| path.file_name()?.to_str());
        text.contains("'out'")
            || text.contains("the output")
            || names.any(|name| text.contains(name))
    }
}

/// The row of a sweep without the column that says how long it took, the third from the end.
fn without_time(line: &str) -> String {
    let mut cells: Vec<&str> = line.trim_end().split(',').collect();
    if cells.len() > 2 {
        cells.remove(cells.len() - 3);
    }
    cells.join(",")
}

/// Whether a path is that of a result, and not somebody else's or hidden.
fn is_result(name: &Path) -> bool {
    let is_hidden = |part: &std::ffi::OsStr| part.to_string_lossy().contains(".partial-");
    name.starts_with("out") && !name.ends_with("notes.txt") && !name.iter().any(is_hidden)
}

fn results(mut all: Contents) -> Contents {
    all.retain(|name, _| is_result(name) && !name.to_string_lossy().ends_with('/'));
    all
}

/// The files that a writer finds.
fn before(writer: &Writer) -> io::Result<Contents> {
    let home = tempfile::tempdir()?;
    let path = home.path();
    let inputs = root().join("xtask/src/torture/writers/inputs");
    write_all(path, &contents(&inputs)?)?;
    let mut first = writer.arguments();
    if writer.1 == Old::Results {
        first.extend(["--set", "title=\"old\""]);
    }
    if writer.1 == Old::Nothing {
        fs::create_dir(path.join("out"))?;
    } else {
        let output = run(&first, path)?;
        if !output.status.success() {
            return Err(io::Error::other(said(&output)));
        }
    }
    if writer.1 == Old::Rows {
        let table = path.join(TABLE);
        let text = fs::read_to_string(&table)?;
        let rows: Vec<&str> = text.split_inclusive('\n').take(2).collect();
        fs::write(&table, rows.concat())?;
        fs::write(path.join("out/notes.txt"), "somebody's notes\n")?;
    }
    contents(path)
}
