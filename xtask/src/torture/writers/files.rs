//! All files of a folder, in memory.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Every file below a folder with its bytes, by its path from there; a folder without files ends in an empty name.
pub(super) type Contents = BTreeMap<PathBuf, Vec<u8>>;

/// What is below `folder`.
pub(super) fn contents(folder: &Path) -> io::Result<Contents> {
    let mut found = Contents::new();
    add(folder, Path::new(""), &mut found)?;
    Ok(found)
}

fn add(folder: &Path, prefix: &Path, found: &mut Contents) -> io::Result<()> {
    let before = found.len();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = prefix.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            add(&entry.path(), &name, found)?;
        } else {
            found.insert(name, fs::read(entry.path())?);
        }
    }
    if found.len() == before {
        found.insert(prefix.join(""), Vec::new());
    }
    Ok(())
}

/// Writes what was below a folder below another one.
pub(super) fn write_all(folder: &Path, files: &Contents) -> io::Result<()> {
    for (name, bytes) in files {
        let path = folder.join(name);
        let is_folder = name.to_string_lossy().ends_with('/');
        fs::create_dir_all(if is_folder {
            &path
        } else {
            path.parent().unwrap_or(folder)
        })?;
        if !is_folder {
            fs::write(path, bytes)?;
        }
    }
    Ok(())
}
