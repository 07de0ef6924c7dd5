//! Tokens of a file, across lines, with the line that each stands on.

use std::str::SplitAsciiWhitespace;

use crate::error::ReadError;
use crate::lines::{self, Lines};
use crate::place::{Files, Place, Spot};

/// Reads tokens, and lines where the format has them.
#[derive(Clone, Debug)]
pub(super) struct Tokens<'a> {
    lines: Lines<'a>,
    tokens: SplitAsciiWhitespace<'a>,
}

impl<'a> Tokens<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            lines: Lines::new(text),
            tokens: "".split_ascii_whitespace(),
        }
    }

    /// The line of the last token.
    pub(super) fn spot(&self) -> Spot {
        Spot {
            file: 0,
            line: self.lines.number(),
        }
    }

    fn next(&mut self) -> Option<&'a str> {
        loop {
            if let Some(token) = self.tokens.next() {
                return Some(token);
            }
            self.tokens = self.lines.next()?.split_ascii_whitespace();
        }
    }

    /// The next line that is not empty.
    pub(super) fn line(&mut self, what: &'static str) -> Result<&'a str, ReadError> {
        self.tokens = "".split_ascii_whitespace();
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

    /// The next token.
    pub(super) fn token(&mut self, what: &'static str) -> Result<&'a str, ReadError> {
        self.next().ok_or_else(|| self.truncated(what))
    }

    /// The next token as a number of a node or an element, or a count.
    pub(super) fn integer(&mut self, what: &'static str) -> Result<u64, ReadError> {
        let token = self.token(what)?;
        lines::integer(token).ok_or_else(|| self.unexpected(what, token))
    }

    /// The next token as a tag of an entity or a group. Its sign, an orientation, is dropped.
    pub(super) fn tag(&mut self, what: &'static str) -> Result<u64, ReadError> {
        let token = self.token(what)?;
        let tag = token.parse::<i64>().ok().map(i64::unsigned_abs);
        tag.ok_or_else(|| self.unexpected(what, token))
    }

    /// The next token as a coordinate.
    pub(super) fn real(&mut self, what: &'static str) -> Result<f64, ReadError> {
        let token = self.token(what)?;
        lines::real(token).ok_or_else(|| self.unexpected(what, token))
    }

    /// Goes to the next section, and returns its name without the sign; none at the end of the text.
    pub(super) fn section(&mut self) -> Result<Option<&'a str>, ReadError> {
        let Some(token) = self.next() else {
            return Ok(None);
        };
        let name = token.strip_prefix('$');
        let name = name.ok_or_else(|| self.unexpected("a section", token))?;
        Ok(Some(name))
    }

    /// Reads the end of section `name`.
    pub(super) fn end(&mut self, name: &str) -> Result<(), ReadError> {
        const WHAT: &str = "the end of the section";
        let token = self.token(WHAT)?;
        if token.strip_prefix("$End") == Some(name) {
            Ok(())
        } else {
            Err(self.unexpected(WHAT, token))
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

/// Where a token of a file that stands alone is.
pub(super) fn place(spot: Spot) -> Place {
    Files::default().place(spot)
}
