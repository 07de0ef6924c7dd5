//! Texts as outlines: order of scripts by UAX #9, shaping by rustybuzz, outlines of the embedded fonts.

use rustybuzz::ttf_parser::{GlyphId, OutlineBuilder};
use rustybuzz::{Direction, Face, UnicodeBuffer};
use tiny_skia::{Path, PathBuilder};
use unicode_bidi::{BidiInfo, Level};

use crate::text::{self, Weight};

/// A line of text at size 1 from the origin, y down.
#[derive(Debug)]
pub(super) struct Line {
    /// The outlines; `None` where nothing is to be seen.
    pub(super) path: Option<Path>,
    /// Where the next letter would stand.
    pub(super) width: f32,
}

/// Lays out `text` on one line.
pub(super) fn line(text: &str, weight: Weight) -> Line {
    let mut pen = Pen::default();
    // Line breaks and tabs are spaces, and control characters are shown as such, as in the SVG.
    let text = text.replace(['\t', '\n', '\r'], " ");
    let text = text.replace(stickslip_text::plain::is_control, "\u{fffd}");
    let bidi = BidiInfo::new(&text, Some(Level::ltr()));
    for paragraph in &bidi.paragraphs {
        let (levels, runs) = bidi.visual_runs(paragraph, paragraph.range.clone());
        for run in runs {
            let is_rtl = levels.get(run.start).is_some_and(Level::is_rtl);
            shape(&mut pen, &text[run], is_rtl, weight);
        }
    }
    Line {
        path: pen.path.finish(),
        width: pen.at[0],
    }
}

/// Draws a run of one direction, in the fonts that have its letters.
fn shape(pen: &mut Pen, run: &str, is_rtl: bool, weight: Weight) {
    let mut parts = parts(run, weight);
    if is_rtl {
        parts.reverse();
    }
    for (part, face) in parts {
        let mut buffer = UnicodeBuffer::new();
        buffer.push_str(part);
        buffer.set_direction(if is_rtl {
            Direction::RightToLeft
        } else {
            Direction::LeftToRight
        });
        buffer.guess_segment_properties();
        let glyphs = rustybuzz::shape(face, &[], buffer);
        pen.scale = 1.0 / face.units_per_em() as f32;
        for (glyph, position) in glyphs.glyph_infos().iter().zip(glyphs.glyph_positions()) {
            let offset = [position.x_offset, position.y_offset].map(|units| units as f32);
            pen.glyph_at = [
                pen.at[0] + pen.scale * offset[0],
                pen.at[1] - pen.scale * offset[1],
            ];
            // Fonts have at most 65 535 glyphs. One without outline, such as a space, draws nothing.
            face.outline_glyph(GlyphId(glyph.glyph_id as u16), pen);
            pen.at[0] += pen.scale * position.x_advance as f32;
            pen.at[1] -= pen.scale * position.y_advance as f32;
        }
    }
}

/// Cuts a run where letters are missing in the font of `weight` and present in the other one.
fn parts(run: &str, weight: Weight) -> Vec<(&str, &'static Face<'static>)> {
    let Some(own) = text::face(weight) else {
        return Vec::new();
    };
    let other = text::face(match weight {
        Weight::Regular => Weight::Bold,
        Weight::Bold => Weight::Regular,
    });
    let face_of = |letter: char| match other {
        Some(other) if own.glyph_index(letter).is_none() && other.glyph_index(letter).is_some() => {
            other
        }
        _ => own,
    };
    let mut parts: Vec<(&str, &'static Face<'static>)> = Vec::new();
    let mut start = 0;
    let mut letters = run.char_indices().map(|(at, letter)| (at, face_of(letter)));
    let Some((_, mut face)) = letters.next() else {
        return parts;
    };
    for (at, next) in letters {
        if !std::ptr::eq(face, next) {
            parts.push((&run[start..at], face));
            (start, face) = (at, next);
        }
    }
    parts.push((&run[start..], face));
    parts
}

/// Collects outlines in units of the text's size.
#[derive(Default)]
struct Pen {
    path: PathBuilder,
    /// Where the next glyph stands.
    at: [f32; 2],
    /// Origin of the glyph being drawn, and size of the font's unit.
    glyph_at: [f32; 2],
    scale: f32,
}

impl Pen {
    fn place(&self, x: f32, y: f32) -> [f32; 2] {
        [
            self.glyph_at[0] + self.scale * x,
            self.glyph_at[1] - self.scale * y,
        ]
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        let [x, y] = self.place(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let [x, y] = self.place(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ([x1, y1], [x, y]) = (self.place(x1, y1), self.place(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let [[x1, y1], [x2, y2], [x, y]] =
            [self.place(x1, y1), self.place(x2, y2), self.place(x, y)];
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_as_wide_as_its_letters() {
        let line = line("0123", Weight::Regular);
        // Digits of DejaVu Sans are 1303 of 2048 units wide.
        assert!((line.width - 4.0 * 1303.0 / 2048.0).abs() < 1e-5);
        let bounds = line.path.unwrap().bounds();
        assert!(bounds.left() > 0.0 && bounds.right() < line.width);
        assert!(bounds.top() < -0.7 && bounds.bottom() < 0.05, "{bounds:?}");
    }

    #[test]
    fn letters_are_joined_and_ordered_as_their_script_wants() {
        // Three joined Arabic letters are narrower than the same ones by themselves.
        let joined = line("\u{628}\u{628}\u{628}", Weight::Regular).width;
        let single = line("\u{628}", Weight::Regular).width;
        assert!(joined < 2.5 * single, "{joined} {single}");
        // Hebrew is read from the right: its first letter stands on the right.
        let alef = line("\u{5d0}", Weight::Regular);
        let word = line("\u{5d0}\u{5d5}", Weight::Regular);
        let right = |line: &Line| line.path.as_ref().unwrap().bounds().right();
        let rest = right(&word) - (word.width - alef.width);
        assert!((rest - right(&alef)).abs() < 1e-5);
    }

    #[test]
    fn letters_that_bold_lacks_are_those_of_the_regular_font() {
        let [bold, regular] =
            [Weight::Bold, Weight::Regular].map(|weight| text::face(weight).unwrap());
        let mut letters = ('\u{100}'..'\u{20000}').filter(|letter| {
            bold.glyph_index(*letter).is_none() && regular.glyph_index(*letter).is_some()
        });
        let text = letters.next().unwrap().to_string();
        let [bold, regular] = [Weight::Bold, Weight::Regular].map(|weight| line(&text, weight));
        assert_eq!(bold.width, regular.width);
        assert_eq!(bold.path.unwrap().bounds(), regular.path.unwrap().bounds());
    }

    #[test]
    fn nothing_and_spaces_have_no_outline() {
        assert!(line("", Weight::Bold).path.is_none());
        let space = line(" ", Weight::Bold);
        assert!(space.path.is_none() && space.width > 0.0);
    }
}
