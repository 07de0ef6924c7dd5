//! The machine that the command runs on.

use std::fs::File;
use std::io::{self, ErrorKind, Read as _};
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::time::Instant;

use stickslip_scene::host::{Host, System};
use stickslip_scene::limits::Limits;

/// Files of the system and its steady clock, without a limit of memory.
pub const HOST: Host = Host {
    limits: Limits::NONE,
    system: &Machine,
};

static START: LazyLock<Instant> = LazyLock::new(Instant::now);

#[derive(Debug)]
struct Machine;

impl System for Machine {
    fn read(&self, path: &Path, most: u64) -> io::Result<Vec<u8>> {
        // Before it is opened: opening a pipe waits for a writer.
        self.length(path)?;
        let mut bytes = Vec::new();
        File::open(path)?.take(most).read_to_end(&mut bytes)?;
        Ok(bytes)
    }

    fn length(&self, path: &Path) -> io::Result<u64> {
        let found = path.metadata()?;
        if found.is_dir() {
            return Err(io::Error::new(
                ErrorKind::IsADirectory,
                "it is a folder, not a file",
            ));
        }
        if !found.is_file() {
            return Err(io::Error::new(
                ErrorKind::InvalidInput,
                "it is a device or a pipe; copy its content into a file",
            ));
        }
        Ok(found.len())
    }

    fn real_path(&self, path: &Path) -> io::Result<PathBuf> {
        // A path without folder starts where the command does.
        Path::new(".").join(path).canonicalize()
    }

    fn whole_path(&self, path: &Path) -> io::Result<PathBuf> {
        std::path::absolute(path)
    }

    fn seconds(&self) -> f64 {
        START.elapsed().as_secs_f64()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickslip_scene::limits::Content;

    #[test]
    fn a_file_beyond_the_memory_is_not_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("long.csv");
        // A file of a terabyte that takes no room.
        File::create(&path).unwrap().set_len(1 << 40).unwrap();
        let host = Host {
            limits: Limits { memory: 1 << 30 },
            ..HOST
        };
        let error = host.read(&path, Content::Table).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::FileTooLarge);
        let said = error.to_string();
        for amount in ["1099.5 GB", "43980.5 GB of memory", "1.1 GB are free"] {
            assert!(said.contains(amount), "{amount}: {said}");
        }
        std::fs::write(&path, "a\n\u{e9}".as_bytes()).unwrap();
        assert_eq!(host.read(&path, Content::Table).unwrap().len(), 4);
        std::fs::write(&path, b"a\nb\xff").unwrap();
        let error = host.read_text(&path, Content::Table).unwrap_err();
        assert_eq!(error.to_string(), "line 2 is not UTF-8 text");
    }

    #[cfg(unix)]
    #[test]
    fn devices_and_folders_are_no_files() {
        for path in ["/dev/full", "/dev/zero", "/"] {
            assert!(HOST.read(Path::new(path), Content::Table).is_err());
        }
    }
}
