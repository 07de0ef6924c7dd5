//! Which files of a folder this program wrote: a list in the folder, by which it knows what it may replace.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// The file with the list of the files that were written, one in a line below a heading.
pub const LIST: &str = ".stickslip-files";

/// Who wrote a folder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A [`ResultFolder`](super::ResultFolder), which is replaced as a whole.
    Whole,
    /// A [`SharedFolder`](super::SharedFolder), whose files are replaced one by one.
    Shared,
}

impl Kind {
    const ALL: [Self; 2] = [Self::Whole, Self::Shared];

    fn heading(self) -> &'static str {
        match self {
            Self::Whole => {
                "# stickslip results: `--force` replaces this folder if it holds no files but these"
            }
            Self::Shared => {
                "# stickslip files: a later run replaces these and no others of this folder"
            }
        }
    }
}

/// The files that this program wrote into a folder.
#[derive(Debug)]
pub(super) struct FileList {
    pub(super) kind: Kind,
    pub(super) names: BTreeSet<String>,
}

impl FileList {
    /// The list of a folder; `None` where there is none that this program wrote.
    pub(super) fn read(folder: &Path) -> io::Result<Option<Self>> {
        /// Bytes of the longest list, about a million names.
        const LONGEST: u64 = 100_000_000;
        let path = folder.join(LIST);
        match path.symlink_metadata() {
            Ok(found) if found.is_file() && found.len() <= LONGEST => {}
            Ok(_) => return Ok(None),
            Err(cause) if cause.kind() == ErrorKind::NotFound => return Ok(None),
            Err(cause) => return Err(cause),
        }
        let bytes = fs::read(path)?;
        let Ok(text) = String::from_utf8(bytes) else {
            return Ok(None);
        };
        let mut lines = text.lines();
        let heading = lines.next().unwrap_or_default();
        let kind = Kind::ALL.into_iter().find(|kind| kind.heading() == heading);
        Ok(kind.map(|kind| Self {
            kind,
            names: lines.map(str::to_owned).collect(),
        }))
    }

    pub(super) fn text(&self) -> String {
        let mut text = self.kind.heading().to_owned() + "\n";
        for name in &self.names {
            text += name;
            text.push('\n');
        }
        text
    }

    /// Whether this program wrote `name`, the list itself included; of a name that ends in `/`, whether it wrote files there.
    pub(super) fn holds(&self, name: &str) -> bool {
        let is_folder = name.ends_with('/');
        name == LIST
            || self.names.contains(name)
            || (is_folder && self.names.iter().any(|own| own.starts_with(name)))
    }
}

/// What is in a folder.
#[derive(Debug, Default)]
pub(super) struct Contents {
    /// Files that were asked for, and folders that hold such files and nothing else, outer ones first.
    files: Vec<PathBuf>,
    folders: Vec<PathBuf>,
    /// Everything else, relative to the folder; a folder ends in `/` and stands for all that is in it.
    pub(super) foreign: Vec<String>,
}

impl Contents {
    /// Parts the entries of `folder` by `owned`, which is asked the path of each file relative to the folder, with `/` between
    /// its parts, and of each empty folder, which ends in `/`. Links and devices are foreign.
    pub(super) fn of(folder: &Path, owned: &dyn Fn(&str) -> bool) -> io::Result<Self> {
        let mut contents = Self::default();
        contents.add(folder, "", owned)?;
        contents.foreign.sort();
        Ok(contents)
    }

    /// Adds the entries of a folder; whether there was an owned one.
    fn add(
        &mut self,
        folder: &Path,
        prefix: &str,
        owned: &dyn Fn(&str) -> bool,
    ) -> io::Result<bool> {
        let mut any = false;
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            let kind = entry.file_type()?;
            let name = entry.file_name();
            let relative = format!("{prefix}{}", name.to_string_lossy());
            if kind.is_dir() {
                let place = self.folders.len();
                self.folders.push(entry.path());
                let before = self.foreign.len();
                let inner = relative + "/";
                let has_owned = self.add(&entry.path(), &inner, owned)?;
                if has_owned || (self.foreign.len() == before && owned(&inner)) {
                    any = true;
                } else {
                    self.folders.truncate(place);
                    self.foreign.truncate(before);
                    self.foreign.push(inner);
                }
            } else if kind.is_file() && name.to_str().is_some() && owned(&relative) {
                any = true;
                self.files.push(entry.path());
            } else {
                self.foreign.push(relative);
            }
        }
        Ok(any)
    }

    /// Names of the files that are not foreign, relative to `folder`, which they were read from.
    pub(super) fn names(&self, folder: &Path) -> BTreeSet<String> {
        let files = self.files.iter();
        files.filter_map(|path| relative(path, folder)).collect()
    }

    /// The same with the folders that are not foreign, which end in `/`.
    pub(super) fn names_and_folders(&self, folder: &Path) -> BTreeSet<String> {
        let mut names = self.names(folder);
        let folders = self.folders.iter();
        names.extend(folders.filter_map(|path| Some(relative(path, folder)? + "/")));
        names
    }
}

/// The path of an entry in the folder that is listed, with `/` between its parts.
fn relative(path: &Path, folder: &Path) -> Option<String> {
    let inner = path.strip_prefix(folder).ok()?;
    let parts: Vec<&str> = inner.iter().filter_map(|part| part.to_str()).collect();
    Some(parts.join("/"))
}

/// Deletes the owned files of `folder`, the folders that held them, and `folder` itself.
///
/// # Errors
/// [`io::Error`] where something foreign is left in the folder or something cannot be deleted.
pub(super) fn remove(folder: &Path, owned: &dyn Fn(&str) -> bool) -> io::Result<()> {
    let mut contents = Contents::of(folder, owned)?;
    // Whoever is interrupted leaves the list, by which the rest is known.
    contents
        .files
        .sort_by_key(|file| *file == folder.join(LIST));
    for file in &contents.files {
        gone(fs::remove_file(file))?;
    }
    for inner in contents.folders.iter().rev() {
        gone(fs::remove_dir(inner))?;
    }
    gone(fs::remove_dir(folder))
}

/// What another process has deleted meanwhile is deleted.
fn gone(done: io::Result<()>) -> io::Result<()> {
    match done {
        Err(cause) if cause.kind() == ErrorKind::NotFound => Ok(()),
        done => done,
    }
}
