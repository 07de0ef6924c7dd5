//! Widths of texts in the embedded font, so that labels can be placed before they
//! are drawn: width = size · Σ advance / units per em.

use std::sync::LazyLock;

use rustybuzz::Face;

/// The family named in every figure. Verdana has nearly the same widths, for a
/// viewer without the first.
pub(crate) const FONT_FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";

/// Width assumed for a character where a font cannot be read or lacks it \[em\].
const FALLBACK_ADVANCE: f64 = 0.65;

static REGULAR: LazyLock<Option<Face<'static>>> =
    LazyLock::new(|| Face::from_slice(dejavu::sans::regular(), 0));
static BOLD: LazyLock<Option<Face<'static>>> =
    LazyLock::new(|| Face::from_slice(dejavu::sans::bold(), 0));

/// Weight of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Weight {
    Regular,
    Bold,
}

/// The embedded font of a weight; `None` if it cannot be read.
pub(crate) fn face(weight: Weight) -> Option<&'static Face<'static>> {
    match weight {
        Weight::Regular => REGULAR.as_ref(),
        Weight::Bold => BOLD.as_ref(),
    }
}

/// Width of `text` on one line at `size` \[px\].
pub(crate) fn width(text: &str, size: f64, weight: Weight) -> f64 {
    let Some(face) = face(weight) else {
        return text.chars().count() as f64 * FALLBACK_ADVANCE * size;
    };
    let units = f64::from(face.units_per_em());
    let advance = |letter| {
        let glyph = face.glyph_index(letter)?;
        Some(f64::from(face.glyph_hor_advance(glyph)?) / units)
    };
    let advances = text
        .chars()
        .map(|letter| advance(letter).unwrap_or(FALLBACK_ADVANCE));
    size * advances.sum::<f64>()
}

/// The widest of `texts` at `size` \[px\]; 0 for none.
pub(crate) fn widest<'a>(texts: impl IntoIterator<Item = &'a str>, size: f64) -> f64 {
    texts
        .into_iter()
        .map(|text| width(text, size, Weight::Regular))
        .fold(0.0, f64::max)
}

/// Breaks `text` into lines of at most `limit` px: at spaces where there are any,
/// inside a word that is wider than a whole line.
pub(crate) fn wrap(text: &str, limit: f64, size: f64, weight: Weight) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut line = String::new();
    for word in text.split_whitespace() {
        let joined = if line.is_empty() {
            word.to_owned()
        } else {
            format!("{line} {word}")
        };
        if width(&joined, size, weight) <= limit {
            line = joined;
            continue;
        }
        if !line.is_empty() {
            lines.push(std::mem::take(&mut line));
        }
        for character in word.chars() {
            line.push(character);
            if width(&line, size, weight) > limit && line.chars().count() > 1 {
                line.pop();
                lines.push(std::mem::replace(&mut line, character.to_string()));
            }
        }
    }
    if !line.is_empty() {
        lines.push(line);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_have_one_width_and_bold_is_wider() {
        assert_eq!(
            width("111", 10.0, Weight::Regular),
            width("987", 10.0, Weight::Regular)
        );
        assert!(width("stick", 10.0, Weight::Bold) > width("stick", 10.0, Weight::Regular));
        // DejaVu Sans 2.37: digits are 1303 of 2048 units wide.
        approx_eq(width("0", 2048.0, Weight::Regular), 1303.0);
    }

    #[test]
    fn every_character_that_figures_use_is_in_the_font() {
        let font = REGULAR.as_ref().unwrap();
        for character in "−×·⁰¹²³⁴⁵⁶⁷⁸⁹⁻µ°θσετφμΔδ≤≥–—…→√½".chars()
        {
            assert!(font.glyph_index(character).is_some(), "{character}");
        }
    }

    #[test]
    fn wrapped_lines_keep_every_word_and_the_limit() {
        let text = "contact pressure along the hole edge and averyveryverylongwordwithoutanyspace";
        let lines = wrap(text, 90.0, 12.0, Weight::Regular);
        assert!(lines.len() > 4);
        assert!(
            lines
                .iter()
                .all(|line| width(line, 12.0, Weight::Regular) <= 90.0)
        );
        let squeeze = |text: &str| text.replace(' ', "");
        assert_eq!(squeeze(&lines.concat()), squeeze(text));
    }

    #[test]
    fn wrapping_ends_even_when_nothing_fits() {
        assert_eq!(wrap("abc", 0.0, 12.0, Weight::Regular), ["a", "b", "c"]);
        assert!(wrap("  ", 50.0, 12.0, Weight::Regular).is_empty());
    }

    fn approx_eq(value: f64, expected: f64) {
        assert!((value - expected).abs() < 0.5, "{value} {expected}");
    }
}
