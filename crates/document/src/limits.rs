//! How much memory reading and modelling may take.
//!
//! Readers and the model builder count what they would need before they allocate it, and refuse what is more than [`Limits`] allow.
//! The caller states how much memory is available.

use thiserror::Error;

/// What would take more memory than there is.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("it would take about {} of memory, and {} are free", amount(*needed), amount(*free as f64))]
pub struct TooLittleMemory {
    /// Memory that it would take `[byte]`.
    pub needed: f64,
    /// Memory that there is `[byte]`.
    pub free: u64,
}

/// What reading a file and modelling its content may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Memory `[byte]`.
    pub memory: u64,
}

/// How many bytes of memory one byte of a file takes at most while it is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// A scene, sweep or experiment: values, their keys and where they stand.
    Document,
    /// A table of numbers, or a mesh: fields as text, then numbers.
    Table,
    /// A picture, which is counted by its pixels when its size is known.
    Picture,
}

impl Content {
    pub(crate) fn bytes_per_byte(self) -> u64 {
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

    /// Refuses what would take `bytes` `[byte]`.
    ///
    /// # Errors
    /// [`TooLittleMemory`] with the two amounts.
    pub fn check(self, bytes: f64) -> Result<(), TooLittleMemory> {
        if bytes <= self.memory as f64 {
            Ok(())
        } else {
            Err(self.exceeded_by(bytes))
        }
    }

    /// That something would take `bytes` `[byte]`, which are known to be too many.
    pub fn exceeded_by(self, bytes: f64) -> TooLittleMemory {
        TooLittleMemory {
            needed: bytes,
            free: self.memory,
        }
    }

    /// Refuses pictures of more `pixels` `[px]` than there is memory for.
    ///
    /// # Errors
    /// [`TooLittleMemory`] with the two amounts.
    pub fn check_pixels(self, pixels: f64) -> Result<(), TooLittleMemory> {
        /// What a pixel takes at most on the way from its file to its phase and its part of a figure \[byte\]; 125 were measured.
        const BYTES_PER_PIXEL: f64 = 200.0;
        self.check(pixels * BYTES_PER_PIXEL)
    }
}

/// Bytes as text.
pub(crate) fn amount(bytes: f64) -> String {
    let (value, unit) = match bytes {
        bytes if bytes < 1e6 => (bytes / 1e3, "kB"),
        bytes if bytes < 1e9 => (bytes / 1e6, "MB"),
        bytes => (bytes / 1e9, "GB"),
    };
    format!("{value:.1} {unit}")
}
