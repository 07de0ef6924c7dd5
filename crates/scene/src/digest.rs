//! Checksums of what a scene is made of.

use std::fmt::Write as _;

use sha2::{Digest as _, Sha256};

/// Computes the SHA-256 of `bytes`, in hexadecimal digits.
pub fn sha256(bytes: impl AsRef<[u8]>) -> String {
    let digest = Sha256::digest(bytes);
    digest.iter().fold(String::new(), |mut text, byte| {
        // Writing into a string does not fail.
        let _ = write!(text, "{byte:02x}");
        text
    })
}
