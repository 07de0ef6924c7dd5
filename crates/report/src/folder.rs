//! Result folders and files that appear whole or not at all.
//!
//! ```text
//! write     everything into a hidden folder beside the target, synced to disk
//! finish    move an old result aside, move the new one in, delete the old one
//! drop      without `finish`: delete the hidden folder; the target is as before
//! abandon   the same from another thread, for a handler of signals
//! ```
//!
//! A rename within one folder is atomic on POSIX systems, so a reader sees the old
//! files or the new ones, never a part. A process that is killed leaves a hidden
//! folder `.NAME.partial-…`, which may be deleted; killed between the two renames of a
//! replacement, it leaves the old results whole as `.NAME.old-…`.

mod error;

use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::{Component, Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

pub use error::FolderError;

/// The file that makes a folder a result folder; [`ResultFolder::finish`] writes it.
pub const MARKER: &str = "summary.json";

/// What to do with a result folder that is there already.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Overwrite {
    /// Leave it and report an error.
    Refuse,
    /// Replace it when the new results are complete.
    Force,
}

/// A result folder being filled. Nothing is at its path before [`Self::finish`].
#[derive(Debug)]
pub struct ResultFolder {
    target: PathBuf,
    staging: PathBuf,
    overwrite: Overwrite,
    stage: Arc<Mutex<Stage>>,
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
    /// [`FolderError::Exists`], [`FolderError::NotResults`], [`FolderError::NotAFolder`] and
    /// [`FolderError::NoName`] for what is at `path`; [`FolderError::Unwritable`] where nothing can be written.
    pub fn create(path: &Path, overwrite: Overwrite) -> Result<Self, FolderError> {
        // As the path was given, so that the message has its words.
        no_file_in_the_way(path)?;
        let target = resolved(path)?;
        check_target(&target, overwrite)?;
        let staging = sibling(&target, "partial")?;
        if let Some(parent) = staging.parent() {
            fs::create_dir_all(parent).map_err(|cause| unwritable(parent, cause))?;
        }
        fs::create_dir(&staging).map_err(|cause| unwritable(&staging, cause))?;
        let folder = Self {
            target,
            staging,
            overwrite,
            stage: Arc::new(Mutex::new(Stage::Filling)),
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
    /// [`FolderError::Name`] for a path that leads out of the folder or is [`MARKER`];
    /// [`FolderError::Unwritable`]; [`FolderError::Abandoned`].
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<(), FolderError> {
        let relative = Path::new(name);
        let inside = relative
            .components()
            .all(|part| matches!(part, Component::Normal(_)));
        if !inside || relative.file_name().is_none() || relative == Path::new(MARKER) {
            return Err(FolderError::Name {
                name: name.to_owned(),
            });
        }
        let _writing = self.locked()?;
        let path = self.staging.join(relative);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(|cause| unwritable(parent, cause))?;
        }
        write_synced(&path, bytes).map_err(|cause| unwritable(&path, cause))
    }

    /// Writes `summary` as [`MARKER`] and puts the folder in its place; returns its path.
    ///
    /// # Errors
    /// [`FolderError::NotPlaced`] if the results had to stay beside the target, which is
    /// then as before ([`FolderError::NotRestored`]: moved aside);
    /// [`FolderError::OldKept`] if only the deletion of the old results failed; [`FolderError::Abandoned`].
    pub fn finish(self, summary: &str) -> Result<PathBuf, FolderError> {
        let mut stage = self.locked()?;
        *stage = Stage::Complete;
        let not_placed = |cause| FolderError::NotPlaced {
            path: self.target.clone(),
            kept: self.staging.clone(),
            cause,
        };
        let marker = self.staging.join(MARKER);
        write_synced(&marker, summary.as_bytes()).map_err(not_placed)?;
        let old = self.move_old_aside().map_err(not_placed)?;
        if let Err(cause) = fs::rename(&self.staging, &self.target) {
            if let Some(old) = old {
                fs::rename(&old, &self.target).map_err(|cause| FolderError::NotRestored {
                    path: self.target.clone(),
                    kept: self.staging.clone(),
                    old,
                    cause,
                })?;
            }
            return Err(not_placed(cause));
        }
        if let Some(old) = old {
            fs::remove_dir_all(&old).map_err(|cause| FolderError::OldKept {
                path: self.target.clone(),
                old,
                cause,
            })?;
        }
        Ok(self.target.clone())
    }

    /// Renames what is at the target, checked again since the run may have been long.
    fn move_old_aside(&self) -> io::Result<Option<PathBuf>> {
        if !exists(&self.target) {
            return Ok(None);
        }
        check_target(&self.target, self.overwrite).map_err(io::Error::other)?;
        let old = sibling(&self.target, "old").map_err(io::Error::other)?;
        fs::rename(&self.target, &old)?;
        Ok(Some(old))
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
    let staging = sibling(&target, "partial")?;
    let written = write_synced(&staging, bytes).and_then(|()| fs::rename(&staging, &target));
    written.map_err(|cause| {
        // The first error is the one to report.
        let _ = fs::remove_file(&staging);
        unwritable(&target, cause)
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

fn check_target(target: &Path, overwrite: Overwrite) -> Result<(), FolderError> {
    let path = || target.to_owned();
    no_file_in_the_way(target)?;
    if !exists(target) {
        return Ok(());
    }
    if overwrite == Overwrite::Refuse {
        return Err(FolderError::Exists { path: path() });
    }
    let mut entries = fs::read_dir(target).map_err(|cause| unwritable(target, cause))?;
    if entries.next().is_none() || target.join(MARKER).is_file() {
        Ok(())
    } else {
        Err(FolderError::NotResults { path: path() })
    }
}

/// A hidden name beside `target` that no other run uses.
fn sibling(target: &Path, purpose: &str) -> Result<PathBuf, FolderError> {
    static COUNTER: AtomicU64 = AtomicU64::new(0);
    let Some(name) = target.file_name() else {
        return Err(FolderError::NoName {
            path: target.to_owned(),
        });
    };
    let count = COUNTER.fetch_add(1, Ordering::Relaxed);
    let mut hidden = std::ffi::OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{purpose}-{}-{count}", std::process::id()));
    Ok(target.with_file_name(hidden))
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
