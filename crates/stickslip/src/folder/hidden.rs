//! Hidden names beside a target, the locks that say who uses them, and what dead processes left.
//!
//! | name | what it is |
//! | --- | --- |
//! | `.NAME.partial-PID-N` | being filled, or replaced results that are being deleted |
//! | `.NAME.old-PID-N` | old results, moved aside where the system cannot exchange two folders |
//! | `.NAME.kept-PID-N` | kept for the user after a failure; never deleted here |
//!
//! A process holds an advisory lock on what it uses, and the system releases it when the process ends, however it ends.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use super::owned;
use super::{FolderError, exists};

/// A hidden name beside `target` that nothing uses.
pub(super) fn sibling(target: &Path, purpose: &str) -> Result<PathBuf, FolderError> {
    static COUNTER: AtomicU64 = AtomicU64::new(0);
    let mut name = prefix(target, purpose)?;
    let count = COUNTER.fetch_add(1, Ordering::Relaxed);
    name.push(format!("{}-{count}", std::process::id()));
    let hidden = target.with_file_name(name);
    // A process of the same number may have left one.
    if exists(&hidden) {
        sibling(target, purpose)
    } else {
        Ok(hidden)
    }
}

fn prefix(target: &Path, purpose: &str) -> Result<OsString, FolderError> {
    let name = target.file_name().ok_or_else(|| FolderError::NoName {
        path: target.to_owned(),
    })?;
    let mut hidden = OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{purpose}-"));
    Ok(hidden)
}

/// Whether somebody uses a file or folder.
#[derive(Debug)]
enum Use {
    /// Nobody else does as long as the lock lives.
    Mine(File),
    /// Another process or thread does.
    Other,
    /// The system has no locks here.
    Unknown,
}

fn lock(path: &Path) -> io::Result<Use> {
    let file = match File::open(path) {
        Ok(file) => file,
        Err(cause) if cause.kind() == ErrorKind::NotFound => return Err(cause),
        Err(_) => return Ok(Use::Unknown),
    };
    Ok(match file.try_lock() {
        Ok(()) => Use::Mine(file),
        Err(fs::TryLockError::WouldBlock) => Use::Other,
        Err(fs::TryLockError::Error(_)) => Use::Unknown,
    })
}

/// Makes a hidden file or folder by `make` and locks it; `None` where the system has no locks.
pub(super) fn locked<T>(
    target: &Path,
    make: impl Fn(&Path) -> io::Result<T>,
) -> Result<(PathBuf, T, Option<File>), FolderError> {
    loop {
        let path = sibling(target, "partial")?;
        let made = make(&path).map_err(|cause| super::unwritable(&path, cause))?;
        // Before it was locked, another process may have taken it for a leftover.
        match lock(&path) {
            Ok(Use::Mine(file)) if exists(&path) => return Ok((path, made, Some(file))),
            Ok(Use::Unknown) => return Ok((path, made, None)),
            _ => {}
        }
    }
}

/// Keeps what is at `path` under a name that no process deletes; its old path where that fails.
pub(super) fn keep(path: &Path, target: &Path) -> PathBuf {
    sibling(target, "kept")
        .ok()
        .filter(|kept| fs::rename(path, kept).is_ok())
        .unwrap_or_else(|| path.to_owned())
}

/// Deletes what dead processes left for `target`, and puts old results back where a replacement was killed half-way.
/// Whether it did that; what cannot be deleted stays.
pub(super) fn clear(target: &Path) -> Result<bool, FolderError> {
    let mut put_back = false;
    for path in leftovers(target, "old")? {
        let Ok(Use::Mine(_held)) = lock(&path) else {
            continue;
        };
        if exists(target) {
            remove(&path);
        } else {
            put_back |= fs::rename(&path, target).is_ok();
        }
    }
    for path in leftovers(target, "partial")? {
        if let Ok(Use::Mine(_held)) = lock(&path) {
            remove(&path);
        }
    }
    Ok(put_back)
}

/// Hidden entries beside `target` that this program named, in the order of their names.
fn leftovers(target: &Path, purpose: &str) -> Result<Vec<PathBuf>, FolderError> {
    let prefix = prefix(target, purpose)?;
    let parent = match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let Ok(entries) = fs::read_dir(parent) else {
        return Ok(Vec::new());
    };
    let ours = |name: &OsString| {
        let rest = name
            .as_encoded_bytes()
            .strip_prefix(prefix.as_encoded_bytes());
        rest.is_some_and(|rest| {
            let mut parts = rest.split(|&byte| byte == b'-');
            let number = |part: &[u8]| !part.is_empty() && part.iter().all(u8::is_ascii_digit);
            parts.by_ref().take(2).filter(|part| number(part)).count() == 2
                && parts.next().is_none()
        })
    };
    let names = entries.filter_map(|entry| Some(entry.ok()?.file_name()));
    let mut paths: Vec<PathBuf> = names
        .filter(ours)
        .map(|name| target.with_file_name(name))
        .collect();
    paths.sort();
    Ok(paths)
}

/// Deletes a leftover; of complete results no more than what they list. A leftover that stays does no harm.
fn remove(path: &Path) {
    if !path.is_dir() {
        let _ = fs::remove_file(path);
    } else if let Ok(Some(list)) = owned::FileList::read(path) {
        let _ = owned::remove(path, &|name| list.holds(name));
    } else {
        let _ = fs::remove_dir_all(path);
    }
}
