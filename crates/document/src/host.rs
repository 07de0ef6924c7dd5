//! What a library needs from the machine: files, the time, memory.
//!
//! In this workspace only the command opens files and reads the clock. A program without files, such as one in a browser, hands
//! over a [`System`] of its own, or none.

use std::collections::BTreeMap;
use std::fmt;
use std::io::{self, ErrorKind};
use std::path::{Component, Path, PathBuf};

use crate::limits::{Content, Limits, amount};

/// Files and a clock.
pub trait System: fmt::Debug + Send + Sync {
    /// The bytes of the regular file at `path`, of a longer one the first `most`.
    ///
    /// # Errors
    /// Those of the system; a folder, device or pipe.
    fn read(&self, path: &Path, most: u64) -> io::Result<Vec<u8>>;

    /// The length of the regular file at `path` `[byte]`, as far as it is known before it is read.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    fn length(&self, path: &Path) -> io::Result<u64>;

    /// Where the file at `path` stands once links are followed; a system without links has it at `path`.
    ///
    /// # Errors
    /// Those of the system.
    fn real_path(&self, path: &Path) -> io::Result<PathBuf> {
        Ok(path.to_owned())
    }

    /// `path` from the root, with its links; a system without a current folder has it as it is.
    ///
    /// # Errors
    /// Those of the system.
    fn whole_path(&self, path: &Path) -> io::Result<PathBuf> {
        Ok(path.to_owned())
    }

    /// Time since any moment that stays `[s]`.
    fn seconds(&self) -> f64;
}

/// No files, and a clock that stands still.
#[derive(Clone, Copy, Debug)]
struct Nothing;

impl System for Nothing {
    fn read(&self, _: &Path, _: u64) -> io::Result<Vec<u8>> {
        Err(io::Error::new(
            ErrorKind::Unsupported,
            "there are no files here",
        ))
    }

    fn length(&self, path: &Path) -> io::Result<u64> {
        self.read(path, 0).map(|_| 0)
    }

    fn seconds(&self) -> f64 {
        0.0
    }
}

/// Files held in memory by their paths, and a clock that stands still.
#[derive(Clone, Debug, Default)]
pub struct MemoryFiles(BTreeMap<PathBuf, Vec<u8>>);

impl<P: Into<PathBuf>, B: Into<Vec<u8>>> FromIterator<(P, B)> for MemoryFiles {
    fn from_iter<I: IntoIterator<Item = (P, B)>>(files: I) -> Self {
        let files = files.into_iter();
        Self(
            files
                .map(|(path, bytes)| (path.into(), bytes.into()))
                .collect(),
        )
    }
}

impl MemoryFiles {
    fn bytes(&self, path: &Path) -> io::Result<&[u8]> {
        let bytes = self.0.get(path).map(Vec::as_slice);
        bytes.ok_or_else(|| ErrorKind::NotFound.into())
    }
}

impl System for MemoryFiles {
    fn read(&self, path: &Path, most: u64) -> io::Result<Vec<u8>> {
        let bytes = self.bytes(path)?;
        let most = usize::try_from(most).unwrap_or(usize::MAX);
        Ok(bytes[..bytes.len().min(most)].to_vec())
    }

    fn length(&self, path: &Path) -> io::Result<u64> {
        self.bytes(path).map(|bytes| bytes.len() as u64)
    }

    fn seconds(&self) -> f64 {
        0.0
    }
}

/// The machine as a scene or an experiment sees it.
#[derive(Clone, Copy, Debug)]
pub struct Host {
    /// How much memory reading and modelling may take.
    pub limits: Limits,
    /// Files and a clock.
    pub system: &'static dyn System,
}

impl Host {
    /// No limit, no files, and a clock that stands still.
    pub const NONE: Self = Self {
        limits: Limits::NONE,
        system: &Nothing,
    };

    /// No limit, and the files and the clock of `system`, which stays until the program ends.
    pub fn of(system: impl System + 'static) -> Self {
        Self {
            system: Box::leak(Box::new(system)),
            ..Self::NONE
        }
    }

    /// Equal parts of the memory for `count` things that are done at the same time.
    #[must_use]
    pub fn shared_by(self, count: usize) -> Self {
        Self {
            limits: self.limits.shared_by(count),
            ..self
        }
    }

    /// Time since any moment that stays `[s]`.
    pub fn seconds(&self) -> f64 {
        self.system.seconds()
    }

    /// The bytes of a regular file; `content` says how much memory one of them will take.
    ///
    /// # Errors
    /// Those of the system; a folder, device or pipe; a file that would take more memory than there is.
    pub fn read(self, path: &Path, content: Content) -> io::Result<Vec<u8>> {
        let factor = content.bytes_per_byte();
        let refused = |bytes: u64| {
            let outcome = self.limits.check(factor as f64 * bytes as f64);
            outcome.map_err(|cause| {
                io::Error::new(
                    ErrorKind::FileTooLarge,
                    format!("it has {}: {cause}", amount(bytes as f64)),
                )
            })
        };
        refused(self.system.length(path)?)?;
        let most = self.limits.memory / factor;
        // It may have grown meanwhile, and some systems do not know how long their files are.
        let bytes = self.system.read(path, most.saturating_add(1))?;
        refused(bytes.len() as u64)?;
        Ok(bytes)
    }

    /// The text of the file that the one at `path` includes as `name`, which leaves the folder of `path` neither by its name nor by a link.
    ///
    /// # Errors
    /// As [`read_text`](Self::read_text); a name that leaves the folder, and a link, with the place that it leads to.
    pub fn read_included(self, path: &Path, name: &str, content: Content) -> io::Result<String> {
        let leaves = |cause: String| io::Error::new(ErrorKind::PermissionDenied, cause);
        let mut parts = Path::new(name).components();
        if !parts.all(|part| matches!(part, Component::Normal(_))) {
            return Err(leaves("it leaves the folder of the mesh".to_owned()));
        }
        let folder = path.parent().unwrap_or(Path::new(""));
        let real = self.system.real_path(&folder.join(name))?;
        if !real.starts_with(self.system.real_path(folder)?) {
            let place = real.display();
            return Err(leaves(format!(
                "a link leads to '{place}', outside of the folder of the mesh"
            )));
        }
        self.read_text(&real, content)
    }

    /// The text of a regular file.
    ///
    /// # Errors
    /// As [`read`](Self::read); bytes that are no UTF-8 text, with their line.
    pub fn read_text(self, path: &Path, content: Content) -> io::Result<String> {
        String::from_utf8(self.read(path, content)?).map_err(|cause| {
            let valid = cause.utf8_error().valid_up_to();
            let line = cause.as_bytes()[..valid]
                .split(|&byte| byte == b'\n')
                .count();
            io::Error::new(
                ErrorKind::InvalidData,
                format!("line {line} is not UTF-8 text"),
            )
        })
    }
}
