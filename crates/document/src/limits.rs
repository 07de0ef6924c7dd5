//! How much memory reading and modelling may take.
//!
//! Readers and the model builder count what they would need before they allocate it, and refuse what is more than [`Limits`] allow.
//! The caller states how much memory is available.

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
    /// The two amounts as text.
    pub fn check(self, bytes: f64) -> Result<(), String> {
        if bytes <= self.memory as f64 {
            return Ok(());
        }
        Err(format!(
            "it would take about {} of memory, and {} are free",
            amount(bytes),
            amount(self.memory as f64)
        ))
    }

    /// Refuses pictures of more `pixels` `[px]` than there is memory for.
    ///
    /// # Errors
    /// The two amounts as text.
    pub fn check_pixels(self, pixels: f64) -> Result<(), String> {
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
