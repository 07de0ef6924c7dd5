//! Puts one folder in the place of another.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use super::FolderError;
use super::hidden;

/// Why a folder was not put in its place.
#[derive(Debug)]
pub(super) enum SwapError {
    /// Everything is as before.
    Unchanged(io::Error),
    /// The old folder is aside and could not be put back.
    Aside {
        /// Where it is.
        old: PathBuf,
        /// The reason.
        cause: io::Error,
    },
}

/// Puts the folder `new` at `target`, where a folder is; returns where the old one is now.
pub(super) fn swap(new: &Path, target: &Path) -> Result<PathBuf, SwapError> {
    match exchange(new, target) {
        Some(done) => done.map(|()| new.to_owned()).map_err(SwapError::Unchanged),
        None => aside(new, target),
    }
}

/// Exchanges two folders in one step, so that a reader, or who comes after a crash, finds one or the other; `None` where the
/// system or the file system cannot.
#[cfg(any(target_os = "linux", target_os = "android", target_vendor = "apple"))]
fn exchange(new: &Path, target: &Path) -> Option<io::Result<()>> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    use rustix::io::Errno;

    match renameat_with(CWD, new, CWD, target, RenameFlags::EXCHANGE) {
        Ok(()) => Some(Ok(())),
        Err(Errno::INVAL | Errno::NOSYS | Errno::NOTSUP) => None,
        Err(cause) => Some(Err(cause.into())),
    }
}

#[cfg(not(any(target_os = "linux", target_os = "android", target_vendor = "apple")))]
fn exchange(_new: &Path, _target: &Path) -> Option<io::Result<()>> {
    None
}

/// Two renames. A process that is killed between them leaves the old folder aside, and [`hidden::clear`] puts it back.
fn aside(new: &Path, target: &Path) -> Result<PathBuf, SwapError> {
    let failed = |cause: FolderError| SwapError::Unchanged(io::Error::other(cause));
    let old = hidden::sibling(target, "old").map_err(failed)?;
    // As long as it is held, no other process puts the old folder back.
    let held = File::open(target).map_err(SwapError::Unchanged)?;
    let _ = held.try_lock();
    fs::rename(target, &old).map_err(SwapError::Unchanged)?;
    match fs::rename(new, target) {
        Ok(()) => Ok(old),
        Err(cause) => match fs::rename(&old, target) {
            Ok(()) => Err(SwapError::Unchanged(cause)),
            Err(cause) => Err(SwapError::Aside { old, cause }),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder_with(path: &Path, content: &str) {
        fs::create_dir(path).unwrap();
        fs::write(path.join("file"), content).unwrap();
    }

    #[test]
    fn both_ways_put_the_new_folder_in_place_and_return_the_old_one() {
        for way in [swap, aside] {
            let home = tempfile::tempdir().unwrap();
            let (new, target) = (home.path().join("new"), home.path().join("target"));
            folder_with(&new, "new");
            folder_with(&target, "old");
            let old = way(&new, &target).unwrap();
            assert_eq!(fs::read(target.join("file")).unwrap(), b"new");
            assert_eq!(fs::read(old.join("file")).unwrap(), b"old");
        }
    }

    #[test]
    fn a_new_folder_that_is_gone_leaves_the_old_one() {
        for way in [swap, aside] {
            let home = tempfile::tempdir().unwrap();
            let (new, target) = (home.path().join("new"), home.path().join("target"));
            folder_with(&target, "old");
            assert!(matches!(
                way(&new, &target),
                Err(SwapError::Unchanged(cause)) if cause.kind() == io::ErrorKind::NotFound
            ));
            assert_eq!(fs::read(target.join("file")).unwrap(), b"old");
        }
    }

    #[test]
    fn a_replacement_killed_half_way_is_put_back() {
        let home = tempfile::tempdir().unwrap();
        let target = home.path().join("target");
        folder_with(&target, "old");
        fs::rename(&target, hidden::sibling(&target, "old").unwrap()).unwrap();
        folder_with(&hidden::sibling(&target, "partial").unwrap(), "new");
        assert!(hidden::clear(&target).unwrap());
        assert_eq!(fs::read(target.join("file")).unwrap(), b"old");
        assert_eq!(fs::read_dir(home.path()).unwrap().count(), 1);
    }
}
