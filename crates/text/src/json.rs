//! Where the entries of a JSON text stand.
//!
//! `serde_json` gives positions of errors only. Once it has accepted a text, this scan walks the same text again and notes the
//! span of every key and value. It relies on the text being valid JSON and never fails on one.

use std::ops::Range;

use crate::dotted::child;

/// A key and its value, as byte spans.
#[derive(Debug, PartialEq, Eq)]
pub struct Entry {
    /// The dotted key.
    pub path: String,
    /// Where the key stands; `None` of an entry of a list.
    pub key: Option<Range<usize>>,
    /// Where the value stands.
    pub value: Range<usize>,
}

/// All entries of objects and lists in valid JSON, outer ones first.
pub fn entries(text: &str) -> Vec<Entry> {
    let mut scan = Scan {
        text,
        at: 0,
        entries: Vec::new(),
    };
    scan.value("");
    scan.entries
}

struct Scan<'a> {
    text: &'a str,
    at: usize,
    entries: Vec<Entry>,
}

impl Scan<'_> {
    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// Moves over bytes for which `inside` holds.
    fn skip(&mut self, inside: impl Fn(u8) -> bool) {
        while self.peek().is_some_and(&inside) {
            self.at += 1;
        }
    }

    fn space(&mut self) {
        self.skip(|byte| byte.is_ascii_whitespace());
    }

    /// Moves over one value at `path`; its span.
    fn value(&mut self, path: &str) -> Range<usize> {
        self.space();
        let start = self.at;
        match self.peek() {
            Some(b'{') => self.members(b'}', path),
            Some(b'[') => self.members(b']', path),
            Some(b'"') => self.string(),
            _ => self.skip(|byte| !byte.is_ascii_whitespace() && !b",]}".contains(&byte)),
        }
        start..self.at
    }

    /// Moves over an object or list from its opening bracket to behind its closing one.
    fn members(&mut self, close: u8, path: &str) {
        self.at += 1;
        for index in 0.. {
            self.space();
            match self.peek() {
                Some(b',') => self.at += 1,
                Some(byte) if byte != close => {}
                _ => break,
            }
            self.space();
            let is_object = close == b'}';
            let start = self.at;
            let mut name = index.to_string();
            let mut key = None;
            if is_object {
                self.string();
                key = Some(start..self.at);
                name = serde_json::from_str(&self.text[start..self.at]).unwrap_or(name);
                self.space();
                self.at += 1;
            }
            let path = child(path, name);
            let place = self.entries.len();
            self.entries.push(Entry {
                path: path.clone(),
                key,
                value: 0..0,
            });
            self.entries[place].value = self.value(&path);
        }
        self.at = (self.at + 1).min(self.text.len());
    }

    fn string(&mut self) {
        self.at += 1;
        while let Some(byte) = self.peek() {
            self.at += if byte == b'\\' { 2 } else { 1 };
            if byte == b'"' {
                break;
            }
        }
        self.at = self.at.min(self.text.len());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_survive_escapes_nesting_and_odd_spacing() {
        let text = "{ \"a\\\"b\" :\n[ 1,\"]\" , {\"ü\":null} ],\"c\":{} , \"d\":[]}";
        let found: Vec<_> = entries(text)
            .into_iter()
            .map(|entry| (entry.path, text[entry.value].to_owned()))
            .collect();
        let expected = [
            ("a\"b", "[ 1,\"]\" , {\"ü\":null} ]"),
            ("a\"b.0", "1"),
            ("a\"b.1", "\"]\""),
            ("a\"b.2", "{\"ü\":null}"),
            ("a\"b.2.ü", "null"),
            ("c", "{}"),
            ("d", "[]"),
        ];
        let expected: Vec<_> = expected
            .map(|(path, value)| (path.to_owned(), value.to_owned()))
            .to_vec();
        assert_eq!(found, expected);
    }
}
