//! Base64 (RFC 4648) as a stream.

use std::io::{self, Write};

const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Encodes what is pushed; nothing may be pushed after [`Encoder::finish`], which the signature enforces.
pub(super) struct Encoder<'a, W> {
    out: &'a mut W,
    group: [u8; 3],
    filled: usize,
}

impl<'a, W: Write> Encoder<'a, W> {
    pub(super) fn new(out: &'a mut W) -> Self {
        Self {
            out,
            group: [0; 3],
            filled: 0,
        }
    }

    pub(super) fn push(&mut self, bytes: &[u8]) -> io::Result<()> {
        for &byte in bytes {
            self.group[self.filled] = byte;
            self.filled += 1;
            if self.filled == 3 {
                self.out.write_all(&encoded(self.group))?;
                self.filled = 0;
            }
        }
        Ok(())
    }

    /// Writes the last group with its padding.
    pub(super) fn finish(mut self) -> io::Result<()> {
        if self.filled == 0 {
            return Ok(());
        }
        self.group[self.filled..].fill(0);
        let mut text = encoded(self.group);
        text[self.filled + 1..].fill(b'=');
        self.out.write_all(&text)
    }
}

fn encoded(group: [u8; 3]) -> [u8; 4] {
    let [a, b, c] = group.map(u32::from);
    let bits = a << 16 | b << 8 | c;
    [18, 12, 6, 0].map(|shift| ALPHABET[(bits >> shift & 63) as usize])
}

#[cfg(test)]
mod tests {
    use super::Encoder;

    /// The test vectors of RFC 4648, section 10.
    #[test]
    fn rfc_4648_vectors() -> std::io::Result<()> {
        for (plain, expected) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            let mut out = Vec::new();
            let mut encoder = Encoder::new(&mut out);
            for byte in plain.bytes() {
                encoder.push(&[byte])?;
            }
            encoder.finish()?;
            assert_eq!(out, expected.as_bytes());
        }
        Ok(())
    }
}
