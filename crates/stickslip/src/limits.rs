//! How much memory reading and modelling may take.
//!
//! Readers and the model builder count what they would need before they allocate it, and refuse what is more than [`Limits`] allow.
//! Only the caller knows what there is: the command asks the system ([`cli`](crate::cli)).

use std::fs::File;
use std::io::{self, ErrorKind, Read as _};
use std::path::Path;

/// What reading a file and modelling its content may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Memory `[byte]`.
    pub memory: u64,
}

/// How many bytes of memory one byte of a file takes at most while it is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Content {
    /// A scene, sweep or experiment: values, their keys and where they stand.
    Document,
    /// A table of numbers, or a mesh: fields as text, then numbers.
    Table,
    /// A picture, which is counted by its pixels when its size is known.
    Picture,
}

impl Content {
    fn bytes_per_byte(self) -> u64 {
        match self {
            Self::Document => 200,
            Self::Table => 40,
            Self::Picture => 2,
        }
    }
}

impl Limits {
    /// No limit, for callers who know what they read.
    pub const NONE: Self = Self { memory: u64::MAX };

    /// Equal parts for `count` things that are done at the same time.
    #[must_use]
    pub fn shared_by(self, count: usize) -> Self {
        if self == Self::NONE {
            return self;
        }
        Self {
            memory: self.memory / (count.max(1) as u64),
        }
    }

    /// Refuses what would take `bytes`.
    ///
    /// # Errors
    /// The two amounts in words.
    pub(crate) fn check(self, bytes: f64) -> Result<(), String> {
        if bytes <= self.memory as f64 {
            return Ok(());
        }
        Err(format!(
            "it would take about {} of memory, and {} are free",
            amount(bytes),
            amount(self.memory as f64)
        ))
    }

    /// Refuses pictures of more pixels than there is memory for.
    ///
    /// # Errors
    /// The two amounts in words.
    pub(crate) fn check_pixels(self, pixels: f64) -> Result<(), String> {
        /// What a pixel takes at most on the way from its file to its phase and its part of a figure \[byte\]; 125 were measured.
        const BYTES_PER_PIXEL: f64 = 200.0;
        self.check(pixels * BYTES_PER_PIXEL)
    }

    /// The bytes of a regular file.
    ///
    /// # Errors
    /// Those of the system; a folder, device or pipe; a file that would take more memory than there is.
    pub(crate) fn read(self, path: &Path, content: Content) -> io::Result<Vec<u8>> {
        // Before it is opened: opening a pipe waits for a writer.
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
        let factor = content.bytes_per_byte();
        let refused = |bytes: u64| {
            let outcome = self.check(factor as f64 * bytes as f64);
            outcome.map_err(|words| {
                io::Error::new(
                    ErrorKind::FileTooLarge,
                    format!("it has {}: {words}", amount(bytes as f64)),
                )
            })
        };
        refused(found.len())?;
        let most = self.memory / factor;
        let mut bytes = Vec::new();
        // It may have grown meanwhile, and some systems do not know how long their files are.
        File::open(path)?
            .take(most.saturating_add(1))
            .read_to_end(&mut bytes)?;
        refused(bytes.len() as u64)?;
        Ok(bytes)
    }

    /// The text of a regular file.
    ///
    /// # Errors
    /// As [`read`](Self::read); bytes that are no UTF-8 text, with their line.
    pub(crate) fn read_text(self, path: &Path, content: Content) -> io::Result<String> {
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

/// Bytes in words.
fn amount(bytes: f64) -> String {
    let (value, unit) = match bytes {
        bytes if bytes < 1e6 => (bytes / 1e3, "kB"),
        bytes if bytes < 1e9 => (bytes / 1e6, "MB"),
        bytes => (bytes / 1e9, "GB"),
    };
    format!("{value:.1} {unit}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_beyond_the_memory_is_not_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("long.csv");
        // A file of a terabyte that takes no room.
        File::create(&path).unwrap().set_len(1 << 40).unwrap();
        let limits = Limits { memory: 1 << 30 };
        let error = limits.read(&path, Content::Table).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::FileTooLarge);
        assert_eq!(
            error.to_string(),
            "it has 1099.5 GB: it would take about 43980.5 GB of memory, and 1.1 GB are free"
        );
        std::fs::write(&path, "a\n\u{e9}".as_bytes()).unwrap();
        assert_eq!(limits.read(&path, Content::Table).unwrap().len(), 4);
        std::fs::write(&path, b"a\nb\xff").unwrap();
        let error = limits.read_text(&path, Content::Table).unwrap_err();
        assert_eq!(error.to_string(), "line 2 is not UTF-8 text");
    }

    #[cfg(unix)]
    #[test]
    fn devices_and_folders_are_no_files() {
        for path in ["/dev/full", "/dev/zero", "/"] {
            assert!(Limits::NONE.read(Path::new(path), Content::Table).is_err());
        }
    }
}
