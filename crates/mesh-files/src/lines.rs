//! Lines with their numbers, and numbers in them.

/// The lines of a text, without blanks around them, numbered from 1.
#[derive(Clone, Debug)]
pub(crate) struct Lines<'a> {
    rest: Option<&'a str>,
    number: u32,
}

impl<'a> Lines<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        // A byte order mark is no part of the first keyword.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        Self {
            rest: Some(text),
            number: 0,
        }
    }

    /// Number of the line that was read last; 0 before the first.
    pub(crate) fn number(&self) -> u32 {
        self.number
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = &'a str;

    fn next(&mut self) -> Option<&'a str> {
        let rest = self.rest?;
        let (line, rest) = match rest.split_once('\n') {
            Some((line, rest)) => (line, Some(rest)),
            None => (rest, None),
        };
        self.rest = rest;
        if rest.is_none() && line.is_empty() {
            return None;
        }
        self.number = self.number.saturating_add(1);
        Some(line.trim())
    }
}

/// A number of a node, an element or a count.
pub(crate) fn integer(word: &str) -> Option<u64> {
    word.parse().ok()
}

/// A real number, in the notation of C or of Fortran ("1.5D-3", "1.5d-3").
pub(crate) fn real(word: &str) -> Option<f64> {
    let fortran = || word.replace(['d', 'D'], "e").parse().ok();
    word.parse().ok().or_else(fortran)
}
