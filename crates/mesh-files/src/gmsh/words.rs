//! Words of a file, across lines, with the line that each stands on.

use std::str::SplitAsciiWhitespace;

use crate::error::ReadError;
use crate::lines::{self, Lines};
use crate::place::{Files, Place, Spot};

/// Reads words, and lines where the format has them.
#[derive(Clone, Debug)]
pub(super) struct Words<'a> {
    lines: Lines<'a>,
    words: SplitAsciiWhitespace<'a>,
}

impl<'a> Words<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            lines: Lines::new(text),
            words: "".split_ascii_whitespace(),
        }
    }

    /// The line of the last word.
    pub(super) fn spot(&self) -> Spot {
        Spot {
            file: 0,
            line: self.lines.number(),
        }
    }

    fn next(&mut self) -> Option<&'a str> {
        loop {
            if let Some(word) = self.words.next() {
                return Some(word);
            }
            self.words = self.lines.next()?.split_ascii_whitespace();
        }
    }

    /// The next line that is not empty.
    pub(super) fn line(&mut self, what: &'static str) -> Result<&'a str, ReadError> {
        self.words = "".split_ascii_whitespace();
        let line = self.lines.find(|line| !line.is_empty());
        line.ok_or_else(|| self.truncated(what))
    }

    fn truncated(&self, what: &'static str) -> ReadError {
        let at = place(self.spot());
        ReadError::Truncated { at, what }
    }

    fn unexpected(&self, what: &'static str, found: &str) -> ReadError {
        ReadError::Value {
            at: place(self.spot()),
            what,
            found: shortened(found),
        }
    }

    /// The next word.
    pub(super) fn word(&mut self, what: &'static str) -> Result<&'a str, ReadError> {
        self.next().ok_or_else(|| self.truncated(what))
    }

    /// The next word as a number of a node or an element, or a count.
    pub(super) fn integer(&mut self, what: &'static str) -> Result<u64, ReadError> {
        let word = self.word(what)?;
        lines::integer(word).ok_or_else(|| self.unexpected(what, word))
    }

    /// The next word as a tag of an entity or a group. Its sign, an orientation, is dropped.
    pub(super) fn tag(&mut self, what: &'static str) -> Result<u64, ReadError> {
        let word = self.word(what)?;
        let tag = word.parse::<i64>().ok().map(i64::unsigned_abs);
        tag.ok_or_else(|| self.unexpected(what, word))
    }

    /// The next word as a coordinate.
    pub(super) fn real(&mut self, what: &'static str) -> Result<f64, ReadError> {
        let word = self.word(what)?;
        lines::real(word).ok_or_else(|| self.unexpected(what, word))
    }

    /// Goes to the next section, and returns its name without the sign; none at the end of the text.
    pub(super) fn section(&mut self) -> Result<Option<&'a str>, ReadError> {
        let Some(word) = self.next() else {
            return Ok(None);
        };
        let name = word.strip_prefix('$');
        let name = name.ok_or_else(|| self.unexpected("a section", word))?;
        Ok(Some(name))
    }

    /// Reads the end of section `name`.
    pub(super) fn end(&mut self, name: &str) -> Result<(), ReadError> {
        const WHAT: &str = "the end of the section";
        let word = self.word(WHAT)?;
        if word.strip_prefix("$End") == Some(name) {
            Ok(())
        } else {
            Err(self.unexpected(WHAT, word))
        }
    }

    /// Goes behind the end of section `name`.
    pub(super) fn skip(&mut self, name: &str) -> Result<(), ReadError> {
        while self.line("the end of the section")?.strip_prefix("$End") != Some(name) {}
        Ok(())
    }
}

/// The beginning of what a message quotes.
fn shortened(text: &str) -> String {
    text.chars().take(40).collect()
}

/// Where a word of a file that stands alone is.
pub(super) fn place(spot: Spot) -> Place {
    Files::default().place(spot)
}
