//! Text of others, made safe for a terminal, a page, a picture and a spreadsheet.
//!
//! Names, titles and messages may come from files of anybody. A control character among them could move the cursor, hide what
//! was written or end an XML document; a table's cell that begins with `=`, `+`, `-` or `@` is a formula to a spreadsheet.

use std::borrow::Cow;

/// Checks whether a character steers a terminal or the direction of text rather than being shown; line breaks and tabs do not.
pub fn is_control(letter: char) -> bool {
    let turns = matches!(letter, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let breaks = matches!(letter, '\u{2028}' | '\u{2029}');
    let no_character = matches!(letter, '\u{fffe}' | '\u{ffff}');
    (letter.is_control() && !matches!(letter, '\n' | '\t')) || turns || breaks || no_character
}

/// Writes every control character of `text` out, as in `\u{1b}`.
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.contains(is_control) {
        return Cow::Borrowed(text);
    }
    let mut plain = String::with_capacity(text.len() + 8);
    for letter in text.chars() {
        if is_control(letter) {
            plain.extend(letter.escape_unicode());
        } else {
            plain.push(letter);
        }
    }
    Cow::Owned(plain)
}

/// Writes control characters out as [`printable`], except sequences that set colours (`ESC [ … m`).
pub fn printable_with_colours(text: &str) -> String {
    let mut pieces = text.split('\u{1b}');
    let mut plain = printable(pieces.next().unwrap_or_default()).into_owned();
    for piece in pieces {
        let parameters = piece.strip_prefix('[').and_then(|rest| {
            let end = rest.find(|letter: char| !letter.is_ascii_digit() && letter != ';')?;
            rest[end..].starts_with('m').then_some(end)
        });
        plain += if parameters.is_some() {
            "\u{1b}"
        } else {
            "\\u{1b}"
        };
        plain += &printable(piece);
    }
    plain
}

/// Makes a cell of a table for other programs: one that a spreadsheet would take for a formula begins with an apostrophe, and control
/// characters are written out. Numbers stay as they are.
pub fn csv_cell(text: &str) -> Cow<'_, str> {
    if is_formula(text) {
        Cow::Owned(format!("'{}", printable(text)))
    } else {
        printable(text)
    }
}

/// The text that [`csv_cell`] made the cell of, for a text without control characters.
pub fn csv_text(cell: &str) -> &str {
    match cell.strip_prefix('\'') {
        Some(text) if is_formula(text) => text,
        _ => cell,
    }
}

fn is_formula(text: &str) -> bool {
    // Apostrophes before a formula are doubled, so that a cell says what it was made of.
    let inner = text.trim_start_matches('\'');
    inner.starts_with([
        '=', '+', '-', '@', '\t', '\r', '\u{ff1d}', '\u{ff0b}', '\u{ff0d}', '\u{ff20}',
    ]) && text.parse::<f64>().is_err()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_written_out() {
        assert_eq!(printable("plate µ\n\tε"), "plate µ\n\tε");
        assert_eq!(printable("a\u{1b}[2Jb\r"), "a\\u{1b}[2Jb\\u{d}");
        assert_eq!(
            printable("\u{9b}1m\u{202e}\u{0}"),
            "\\u{9b}1m\\u{202e}\\u{0}"
        );
    }

    #[test]
    fn colours_may_stay_and_nothing_else() {
        let text = "\u{1b}[31;1mred\u{1b}[0m \u{1b}[2J\u{1b}]0;title\u{7}";
        assert_eq!(
            printable_with_colours(text),
            "\u{1b}[31;1mred\u{1b}[0m \\u{1b}[2J\\u{1b}]0;title\\u{7}"
        );
    }

    #[test]
    fn formulas_become_text_and_numbers_stay() {
        for text in ["=1+1", "+cmd", "-pin", "@sum", "'=1", "\t=1"] {
            let cell = csv_cell(text);
            assert!(cell.starts_with('\''), "{cell}");
            assert_eq!(csv_text(&cell), printable(text));
        }
        for text in ["-1.5e-3", "+2", "plate", "", "[45/-45]", "'quoted'", "-inf"] {
            assert_eq!(csv_cell(text), text);
            assert_eq!(csv_text(text), text);
        }
    }
}
