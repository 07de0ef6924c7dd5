//! Result folders and files that appear whole or not at all.
//!
//! ```text
//! create    put right what dead processes left; check that the target may be replaced
//! write     everything into a hidden folder beside the target, synced to disk
//! finish    list the files, exchange the hidden folder with the old one, delete the old one's listed files
//! drop      without `finish`: delete the hidden folder; the target is as before
//! abandon   the same from another thread, for a handler of signals
//! ```
//!
//! An exchange is one step of the file system, so a reader, and who comes after a crash, finds the old files or the new ones, never
//! a part and never nothing. Where the system has no exchange, two renames stand for it, and the next [`ResultFolder::create`] puts
//! the old results back if a process was killed between them.
//!
//! A results folder is owned by the list of its files, [`LIST`]: it is replaced only if it holds nothing else.

mod error;
mod hidden;
mod owned;
mod shared;
mod swap;

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

pub use error::FolderError;
pub use owned::LIST;
use owned::{Contents, FileList, Kind};
pub use shared::SharedFolder;
use swap::SwapError;

/// The file that says that results are complete; [`ResultFolder::finish`] writes it last.
pub const MARKER: &str = "summary.json";

/// Recognises results by the content of [`MARKER`]; `None` if it is no summary of this program.
pub type Known = fn(summary: &[u8]) -> Option<Results>;

/// Whose results a folder holds.
#[derive(Debug, Clone, Copy)]
pub enum Results {
    /// Those of the same command. Versions that wrote no [`LIST`] wrote the files for which this is true, by their relative path.
    Same(fn(&str) -> bool),
    /// Those of another one, such as "`stickslip run`".
    Other(&'static str),
}

/// What to do with a result folder that is there already.
#[derive(Debug, Clone, Copy)]
pub enum Overwrite {
    /// Leave it and report an error, if anything is in it.
    Refuse,
    /// Replace it when the new results are complete, if this program wrote all that is in it, by the same command.
    Force(Known),
}

/// A result folder being filled. Nothing is at its path before [`Self::finish`].
#[derive(Debug)]
pub struct ResultFolder {
    target: PathBuf,
    staging: PathBuf,
    overwrite: Overwrite,
    stage: Arc<Mutex<Stage>>,
    put_back: bool,
    /// Says that the hidden folder is in use; `None` where the system has no locks.
    _held: Option<File>,
}

/// Who may touch the hidden folder; it is locked as long as files are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stage {
    /// Being filled, and to be deleted if nothing comes of it.
    Filling,
    /// Deleted before it was complete.
    Abandoned,
    /// Complete, and not to be deleted any more.
    Complete,
}

fn lock(stage: &Mutex<Stage>) -> MutexGuard<'_, Stage> {
    // A stage is one word, which a panic elsewhere cannot leave half written.
    stage.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A way to give up a [`ResultFolder`] that another thread fills.
#[derive(Debug, Clone)]
pub struct FolderHandle {
    staging: PathBuf,
    stage: Arc<Mutex<Stage>>,
}

/// What became of a result folder that was given up.
#[derive(Debug)]
pub enum Abandoned<'a> {
    /// It is deleted. As long as this value lives, the thread that fills the folder waits; after that its writes fail.
    Deleted(Filling<'a>),
    /// The results were complete, abandoned or dropped before.
    TooLate,
}

/// Keeps the thread that fills a folder waiting.
#[derive(Debug)]
pub struct Filling<'a> {
    _stage: MutexGuard<'a, Stage>,
}

impl FolderHandle {
    /// Deletes the hidden folder, and what was written of it; while results are being put in place this waits.
    pub fn abandon(&self) -> Abandoned<'_> {
        let mut stage = lock(&self.stage);
        if *stage != Stage::Filling {
            return Abandoned::TooLate;
        }
        *stage = Stage::Abandoned;
        // A handler of signals cannot report; the folder is hidden and named as partial.
        let _ = fs::remove_dir_all(&self.staging);
        Abandoned::Deleted(Filling { _stage: stage })
    }
}

impl ResultFolder {
    /// Prepares a result folder at `path`, and its parents; finds out before a long run
    /// whether it can be written.
    ///
    /// # Errors
    /// [`FolderError::Exists`], [`FolderError::Foreign`], [`FolderError::NotAFolder`] and
    /// [`FolderError::NoName`] for what is at `path`; [`FolderError::Unwritable`] where nothing can be written.
    pub fn create(path: &Path, overwrite: Overwrite) -> Result<Self, FolderError> {
        // As the path was given, so that the message has its words.
        no_file_in_the_way(path)?;
        let target = resolved(path)?;
        let put_back = hidden::clear(&target)?;
        check_target(&target, overwrite)?;
        if let Some(parent) = target.parent() {
            fs::create_dir_all(parent).map_err(|cause| unwritable(parent, cause))?;
        }
        let (staging, (), held) = hidden::locked(&target, |path| fs::create_dir(path))?;
        let folder = Self {
            target,
            staging,
            overwrite,
            stage: Arc::new(Mutex::new(Stage::Filling)),
            put_back,
            _held: held,
        };
        let probe = folder.staging.join(".probe");
        write_synced(&probe, b"probe").map_err(|cause| unwritable(&probe, cause))?;
        fs::remove_file(&probe).map_err(|cause| unwritable(&probe, cause))?;
        Ok(folder)
    }

    /// Where the results will be.
    pub fn path(&self) -> &Path {
        &self.target
    }

    /// Whether old results are back in their place, because an earlier replacement of them was killed.
    pub fn puts_back(&self) -> bool {
        self.put_back
    }

    /// A way to give the results up from another thread.
    pub fn handle(&self) -> FolderHandle {
        FolderHandle {
            staging: self.staging.clone(),
            stage: Arc::clone(&self.stage),
        }
    }

    /// Keeps the folder from being given up; fails if it was.
    fn locked(&self) -> Result<MutexGuard<'_, Stage>, FolderError> {
        let stage = lock(&self.stage);
        match *stage {
            Stage::Abandoned => Err(FolderError::Abandoned {
                path: self.target.clone(),
            }),
            Stage::Filling | Stage::Complete => Ok(stage),
        }
    }

    /// The hidden folder where files are collected, for writers that want a path.
    pub fn staging(&self) -> &Path {
        &self.staging
    }

    /// Writes file `name`, a relative path such as `figures/traction.svg`.
    ///
    /// # Errors
    /// [`FolderError::Name`] for a path that leads out of the folder, or is [`MARKER`] or [`LIST`];
    /// [`FolderError::Unwritable`]; [`FolderError::Abandoned`].
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<(), FolderError> {
        if !is_inside(name) || name == MARKER || name == LIST {
            return Err(FolderError::Name {
                name: name.to_owned(),
            });
        }
        let _writing = self.locked()?;
        let path = self.staging.join(name);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(|cause| unwritable(parent, cause))?;
        }
        write_synced(&path, bytes).map_err(|cause| unwritable(&path, cause))
    }

    /// Writes [`LIST`], and `summary` as [`MARKER`], and puts the folder in its place; returns its path.
    ///
    /// # Errors
    /// [`FolderError::Unwritable`]; [`FolderError::NotPlaced`] if the results had to stay beside the target, which is
    /// then as before ([`FolderError::NotRestored`]: moved aside);
    /// [`FolderError::OldKept`] if only the deletion of the old results failed; [`FolderError::Abandoned`].
    pub fn finish(self, summary: &str) -> Result<PathBuf, FolderError> {
        let mut stage = self.locked()?;
        self.complete(summary)?;
        *stage = Stage::Complete;
        let not_placed = |cause| FolderError::NotPlaced {
            path: self.target.clone(),
            kept: hidden::keep(&self.staging, &self.target),
            cause,
        };
        // Checked again, since the run may have been long.
        let old = check_target(&self.target, self.overwrite).map_err(io::Error::other);
        let Some(owned) = old.map_err(not_placed)? else {
            fs::rename(&self.staging, &self.target).map_err(not_placed)?;
            return Ok(self.target.clone());
        };
        let old = match swap::swap(&self.staging, &self.target) {
            Ok(old) => old,
            Err(SwapError::Unchanged(cause)) => return Err(not_placed(cause)),
            Err(SwapError::Aside { old, cause }) => {
                return Err(FolderError::NotRestored {
                    path: self.target.clone(),
                    kept: hidden::keep(&self.staging, &self.target),
                    old,
                    cause,
                });
            }
        };
        owned::remove(&old, &|name| owned.contains(name)).map_err(|cause| {
            FolderError::OldKept {
                path: self.target.clone(),
                old: hidden::keep(&old, &self.target),
                cause,
            }
        })?;
        Ok(self.target.clone())
    }

    /// Writes the list of the files and the summary.
    fn complete(&self, summary: &str) -> Result<(), FolderError> {
        let here = |cause| unwritable(&self.staging, cause);
        let written = Contents::of(&self.staging, &|_| true).map_err(here)?;
        let mut list = FileList {
            kind: Kind::Whole,
            names: written.names(&self.staging),
        };
        list.names.insert(MARKER.to_owned());
        for (name, text) in [(LIST, list.text().as_str()), (MARKER, summary)] {
            let path = self.staging.join(name);
            write_synced(&path, text.as_bytes()).map_err(|cause| unwritable(&path, cause))?;
        }
        Ok(())
    }
}

impl Drop for ResultFolder {
    fn drop(&mut self) {
        let mut stage = lock(&self.stage);
        if *stage == Stage::Filling {
            *stage = Stage::Abandoned;
            // A drop cannot report; the folder is hidden and named as partial.
            let _ = fs::remove_dir_all(&self.staging);
        }
    }
}

/// Writes a file that appears whole or not at all; an old one is replaced.
///
/// # Errors
/// [`FolderError::NoName`] and [`FolderError::Unwritable`].
pub fn write_atomic(path: &Path, bytes: &[u8]) -> Result<(), FolderError> {
    let target = resolved(path)?;
    staged(&target, bytes, |staging| fs::rename(staging, &target))
}

/// Writes a file that appears whole or not at all, where none is.
///
/// # Errors
/// [`FolderError::Exists`], [`FolderError::NoName`] and [`FolderError::Unwritable`].
pub fn write_new(path: &Path, bytes: &[u8]) -> Result<(), FolderError> {
    let exists_already = || FolderError::Exists {
        path: path.to_owned(),
    };
    if exists(path) {
        return Err(exists_already());
    }
    let target = resolved(path)?;
    let placed = staged(&target, bytes, |staging| {
        // Unlike a rename, a link does not replace a file that has appeared meanwhile.
        match fs::hard_link(staging, &target) {
            Ok(()) => {
                // The file is in place; a second, hidden name of it does no harm.
                let _ = fs::remove_file(staging);
                Ok(())
            }
            Err(cause) if cause.kind() == io::ErrorKind::AlreadyExists => Err(cause),
            // Not every file system has links.
            Err(_) => fs::rename(staging, &target),
        }
    });
    match placed {
        Err(FolderError::Unwritable { cause, .. })
            if cause.kind() == io::ErrorKind::AlreadyExists =>
        {
            Err(exists_already())
        }
        placed => placed,
    }
}

/// Writes a hidden file beside `target`, which `place` puts there.
fn staged(
    target: &Path,
    bytes: &[u8],
    place: impl FnOnce(&Path) -> io::Result<()>,
) -> Result<(), FolderError> {
    hidden::clear(target)?;
    let (staging, mut file, _held) = hidden::locked(target, |path| File::create(path))?;
    let written = file
        .write_all(bytes)
        .and_then(|()| file.sync_all())
        .and_then(|()| place(&staging));
    written.map_err(|cause| {
        // The first error is the one to report.
        let _ = fs::remove_file(&staging);
        unwritable(target, cause)
    })
}

/// What an existing path leads to, through symbolic links; a new path as it is.
fn resolved(path: &Path) -> Result<PathBuf, FolderError> {
    if exists(path) {
        return path.canonicalize().map_err(|cause| unwritable(path, cause));
    }
    if path.file_name().is_none() {
        return Err(FolderError::NoName {
            path: path.to_owned(),
        });
    }
    Ok(path.to_owned())
}

fn exists(path: &Path) -> bool {
    path.symlink_metadata().is_ok()
}

fn no_file_in_the_way(path: &Path) -> Result<(), FolderError> {
    match path.ancestors().find(|part| part.is_file()) {
        Some(file) => Err(FolderError::NotAFolder {
            path: path.to_owned(),
            file: file.to_owned(),
        }),
        None => Ok(()),
    }
}

/// Whether a name stands for a file inside of a folder, and for itself in a list of lines.
fn is_inside(name: &str) -> bool {
    let path = Path::new(name);
    let normal = path
        .components()
        .all(|part| matches!(part, Component::Normal(_)));
    normal && path.file_name().is_some() && !name.chars().any(char::is_control)
}

/// The files and folders in the folder at `target`, all of which may be replaced; `None` where nothing is.
fn check_target(
    target: &Path,
    overwrite: Overwrite,
) -> Result<Option<BTreeSet<String>>, FolderError> {
    no_file_in_the_way(target)?;
    if !exists(target) {
        return Ok(None);
    }
    let failed = |cause| unwritable(target, cause);
    let mut entries = fs::read_dir(target).map_err(failed)?;
    if entries.next().is_none() {
        return Ok(Some(BTreeSet::new()));
    }
    let Overwrite::Force(known) = overwrite else {
        return Err(FolderError::Exists {
            path: target.to_owned(),
        });
    };
    let found = small_file(&target.join(MARKER)).and_then(|summary| known(&summary));
    let list = FileList::read(target).map_err(failed)?;
    let other = match (found, &list) {
        (Some(Results::Other(command)), _) => Some(command),
        (_, Some(list)) if list.kind == Kind::Shared => {
            Some("a command that replaces them one by one")
        }
        _ => None,
    };
    if let Some(command) = other {
        return Err(FolderError::OtherResults {
            path: target.to_owned(),
            command,
        });
    }
    let contents = match (list, found) {
        (Some(list), _) => Contents::of(target, &|name| list.holds(name)),
        (None, Some(Results::Same(owned))) => Contents::of(target, &owned),
        (None, _) => Contents::of(target, &|_| false),
    };
    let contents = contents.map_err(failed)?;
    if contents.foreign.is_empty() {
        Ok(Some(contents.names_and_folders(target)))
    } else {
        Err(FolderError::Foreign {
            path: target.to_owned(),
            files: contents.foreign,
        })
    }
}

/// The content of a plain file that is not too long for a summary.
fn small_file(path: &Path) -> Option<Vec<u8>> {
    const LONGEST: u64 = 1_000_000_000;
    let found = path.symlink_metadata().ok()?;
    (found.is_file() && found.len() <= LONGEST)
        .then(|| fs::read(path).ok())
        .flatten()
}

fn write_synced(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = File::create(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}

fn unwritable(path: &Path, cause: io::Error) -> FolderError {
    FolderError::Unwritable {
        path: path.to_owned(),
        cause,
    }
}
