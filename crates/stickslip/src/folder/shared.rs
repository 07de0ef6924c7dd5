//! Folders whose files are written one by one, beside files of others.

use std::collections::BTreeSet;
use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};

use super::owned::{Contents, FileList, Kind, LIST};
use super::{FolderError, exists, is_inside, unwritable, write_atomic};

/// A folder in which this program replaces its own files and no others.
#[derive(Debug)]
pub struct SharedFolder {
    path: PathBuf,
    list: FileList,
    /// Keeps other processes out; `None` where the system has no locks.
    _held: Option<File>,
}

impl SharedFolder {
    /// Opens the folder at `path`, and makes it if need be. A folder of a version that kept no list of its files is taken to own
    /// those that `older` says, by their name.
    ///
    /// # Errors
    /// [`FolderError::Unwritable`]; [`FolderError::Busy`] while another process has the folder open.
    pub fn open(path: &Path, older: fn(&str) -> bool) -> Result<Self, FolderError> {
        fs::create_dir_all(path).map_err(|cause| unwritable(path, cause))?;
        let held = match File::open(path) {
            Ok(folder) => match folder.try_lock() {
                Ok(()) => Some(folder),
                Err(TryLockError::WouldBlock) => {
                    return Err(FolderError::Busy {
                        path: path.to_owned(),
                    });
                }
                Err(TryLockError::Error(_)) => None,
            },
            Err(_) => None,
        };
        let failed = |cause| unwritable(path, cause);
        let names = match FileList::read(path).map_err(failed)? {
            Some(list) if list.kind == Kind::Shared => list.names,
            Some(_) => BTreeSet::new(),
            None => Contents::of(path, &older).map_err(failed)?.names(path),
        };
        let folder = Self {
            path: path.to_owned(),
            list: FileList {
                kind: Kind::Shared,
                names,
            },
            _held: held,
        };
        folder.write_list()?;
        Ok(folder)
    }

    fn write_list(&self) -> Result<(), FolderError> {
        write_atomic(&self.path.join(LIST), self.list.text().as_bytes())
    }

    /// Where a file of the folder is.
    pub fn file(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Writes file `name`, a relative path, so that it appears whole or not at all; replaces one that this program wrote.
    ///
    /// # Errors
    /// [`FolderError::Foreign`] where somebody else's file has this name; [`FolderError::Name`] for a path that leads out of the
    /// folder; [`FolderError::Unwritable`].
    pub fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), FolderError> {
        if !is_inside(name) || name == LIST {
            return Err(FolderError::Name {
                name: name.to_owned(),
            });
        }
        let path = self.file(name);
        if !self.list.names.contains(name) {
            if exists(&path) {
                return Err(FolderError::Foreign {
                    path: self.path.clone(),
                    files: vec![name.to_owned()],
                });
            }
            self.list.names.insert(name.to_owned());
            self.write_list()?;
        }
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(|cause| unwritable(parent, cause))?;
        }
        write_atomic(&path, bytes)
    }
}
