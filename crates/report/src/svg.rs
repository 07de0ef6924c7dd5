//! A finished picture, and the small writer that makes one.
//!
//! Lengths are CSS pixels, x to the right, y down. The documents carry no `id`,
//! so that any number of them can stand in one HTML page: clipping is done by
//! nested `svg` elements, and gradients are strips of rectangles.

use std::fmt::{self, Write as _};

use crate::color::Color;
use crate::plain::is_control;
use crate::text::{FONT_FAMILY, Weight};

/// A self-contained SVG document. Only this crate makes one, so its markup is
/// well-formed and free of scripts, and [`page`](crate::page) may insert it as it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Svg {
    markup: String,
    width: f64,
    height: f64,
}

impl Svg {
    /// The document's text, UTF-8.
    pub fn as_str(&self) -> &str {
        &self.markup
    }

    /// Width \[px\].
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Height \[px\].
    pub fn height(&self) -> f64 {
        self.height
    }
}

impl fmt::Display for Svg {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.markup)
    }
}

/// An upright rectangle \[px\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Area {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl Area {
    pub(crate) fn right(&self) -> f64 {
        self.left + self.width
    }

    pub(crate) fn bottom(&self) -> f64 {
        self.top + self.height
    }

    pub(crate) fn middle(&self) -> [f64; 2] {
        [self.left + self.width / 2.0, self.top + self.height / 2.0]
    }

    pub(crate) fn grown(&self, by: f64) -> Self {
        Self {
            left: self.left - by,
            top: self.top - by,
            width: self.width + 2.0 * by,
            height: self.height + 2.0 * by,
        }
    }

    pub(crate) fn contains(&self, [x, y]: [f64; 2]) -> bool {
        x >= self.left && x <= self.right() && y >= self.top && y <= self.bottom()
    }
}

/// How a line is drawn.
#[derive(Debug, Clone)]
pub(crate) struct Stroke {
    pub(crate) color: Color,
    pub(crate) width: f64,
    /// Lengths of strokes and gaps \[px\], as SVG writes them; empty for solid.
    pub(crate) dashes: String,
}

impl Stroke {
    pub(crate) fn solid(color: Color, width: f64) -> Self {
        Self {
            color,
            width,
            dashes: String::new(),
        }
    }

    pub(crate) fn dashed(color: Color, width: f64, dashes: &str) -> Self {
        Self {
            color,
            width,
            dashes: dashes.to_owned(),
        }
    }
}

/// Which point of a text stands at the given place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text is drawn.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TextStyle {
    pub(crate) size: f64,
    pub(crate) weight: Weight,
    pub(crate) color: Color,
    pub(crate) anchor: Anchor,
    /// Whether the text reads upwards.
    pub(crate) upwards: bool,
}

impl TextStyle {
    pub(crate) fn new(size: f64, color: Color, anchor: Anchor) -> Self {
        Self {
            size,
            weight: Weight::Regular,
            color,
            anchor,
            upwards: false,
        }
    }

    pub(crate) fn bold(self) -> Self {
        Self {
            weight: Weight::Bold,
            ..self
        }
    }

    pub(crate) fn upwards(self) -> Self {
        Self {
            upwards: true,
            ..self
        }
    }
}

/// Collects the elements of a picture.
#[derive(Debug, Default)]
pub(crate) struct Canvas {
    body: String,
}

// Writing to a String cannot fail, so the results of `write!` below are dropped.
impl Canvas {
    pub(crate) fn rectangle(&mut self, area: &Area, fill: Color, outline: Option<&Stroke>) {
        let _ = write!(
            self.body,
            r#"<rect x="{}" y="{}" width="{}" height="{}" fill="{fill}""#,
            Px(area.left),
            Px(area.top),
            Px(area.width),
            Px(area.height),
        );
        if let Some(stroke) = outline {
            self.stroke_attributes(stroke);
        }
        self.body.push_str("/>\n");
    }

    pub(crate) fn line(&mut self, from: [f64; 2], to: [f64; 2], stroke: &Stroke) {
        let _ = write!(
            self.body,
            r#"<line x1="{}" y1="{}" x2="{}" y2="{}""#,
            Px(from[0]),
            Px(from[1]),
            Px(to[0]),
            Px(to[1])
        );
        self.stroke_attributes(stroke);
        self.body.push_str("/>\n");
    }

    /// An unfilled path from path data.
    pub(crate) fn stroked_path(&mut self, data: &str, stroke: &Stroke) {
        if data.is_empty() {
            return;
        }
        let _ = write!(self.body, r#"<path d="{data}" fill="none""#);
        self.stroke_attributes(stroke);
        self.body.push_str(" stroke-linejoin=\"round\"/>\n");
    }

    /// A filled path from path data, with an outline.
    pub(crate) fn filled_path(&mut self, data: &str, fill: Color, outline: &Stroke) {
        if data.is_empty() {
            return;
        }
        let _ = write!(self.body, r#"<path d="{data}" fill="{fill}""#);
        self.stroke_attributes(outline);
        self.body.push_str(" stroke-linejoin=\"round\"/>\n");
    }

    /// A text whose baseline starts, is centred or ends at `at`.
    pub(crate) fn text(&mut self, at: [f64; 2], text: &str, style: &TextStyle) {
        let [x, y] = at;
        let _ = write!(
            self.body,
            r#"<text x="{}" y="{}" font-size="{}" fill="{}""#,
            Px(x),
            Px(y),
            Px(style.size),
            style.color
        );
        match style.anchor {
            Anchor::Start => {}
            Anchor::Middle => self.body.push_str(r#" text-anchor="middle""#),
            Anchor::End => self.body.push_str(r#" text-anchor="end""#),
        }
        if style.weight == Weight::Bold {
            self.body.push_str(r#" font-weight="bold""#);
        }
        if style.upwards {
            let _ = write!(self.body, r#" transform="rotate(-90 {} {})""#, Px(x), Px(y));
        }
        let _ = writeln!(self.body, ">{}</text>", Escaped(text));
    }

    /// A text with its middle height at `at[1]` (or at `at[0]` when it reads upwards).
    pub(crate) fn centred_text(&mut self, at: [f64; 2], text: &str, style: &TextStyle) {
        // Digits and capitals of the font are 0.73 em high.
        let drop = 0.365 * style.size;
        let at = if style.upwards {
            [at[0] + drop, at[1]]
        } else {
            [at[0], at[1] + drop]
        };
        self.text(at, text, style);
    }

    /// A PNG stretched over `area`.
    pub(crate) fn image(&mut self, area: &Area, png: &[u8]) {
        use base64::Engine as _;
        let _ = write!(
            self.body,
            r#"<image x="{}" y="{}" width="{}" height="{}" preserveAspectRatio="none" xlink:href="data:image/png;base64,"#,
            Px(area.left),
            Px(area.top),
            Px(area.width),
            Px(area.height),
        );
        base64::engine::general_purpose::STANDARD.encode_string(png, &mut self.body);
        self.body.push_str("\"/>\n");
    }

    /// Draws inside `area` only; coordinates stay those of the whole picture.
    pub(crate) fn clipped(&mut self, area: &Area, draw: impl FnOnce(&mut Self)) {
        let (left, top) = (Px(area.left), Px(area.top));
        let (width, height) = (Px(area.width), Px(area.height));
        let _ = writeln!(
            self.body,
            r#"<svg x="{left}" y="{top}" width="{width}" height="{height}" viewBox="{left} {top} {width} {height}" overflow="hidden">"#
        );
        draw(self);
        self.body.push_str("</svg>\n");
    }

    /// Places a finished picture with its upper left corner at `at`.
    pub(crate) fn place(&mut self, at: [f64; 2], picture: &Svg) {
        let _ = writeln!(
            self.body,
            r#"<g transform="translate({} {})">{}</g>"#,
            Px(at[0]),
            Px(at[1]),
            picture.markup
        );
    }

    /// The document, white behind everything; `title` is what a screen reader says.
    pub(crate) fn finish(self, width: f64, height: f64, title: &str) -> Svg {
        let markup = format!(
            concat!(
                r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" "#,
                r#"width="{w}" height="{h}" viewBox="0 0 {w} {h}" font-family="{font}" role="img">"#,
                "\n<title>{title}</title>\n",
                r##"<rect x="0" y="0" width="{w}" height="{h}" fill="#ffffff"/>"##,
                "\n{body}</svg>\n"
            ),
            w = Px(width),
            h = Px(height),
            font = FONT_FAMILY,
            title = Escaped(title),
            body = self.body,
        );
        Svg {
            markup,
            width,
            height,
        }
    }

    fn stroke_attributes(&mut self, stroke: &Stroke) {
        let _ = write!(
            self.body,
            r#" stroke="{}" stroke-width="{}""#,
            stroke.color,
            Px(stroke.width)
        );
        if !stroke.dashes.is_empty() {
            let _ = write!(self.body, r#" stroke-dasharray="{}""#, stroke.dashes);
        }
    }
}

/// A length with at most two decimals.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Px(pub(crate) f64);

impl fmt::Display for Px {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Adding zero turns −0 into 0.
        write!(f, "{}", (self.0 * 100.0).round() / 100.0 + 0.0)
    }
}

/// Appends `command` and a point to path data.
pub(crate) fn push_point(data: &mut String, command: char, [x, y]: [f64; 2]) {
    // Writing to a String cannot fail.
    let _ = write!(data, "{command}{} {}", Px(x), Px(y));
}

/// A text as XML wants it; control characters, some of which XML 1.0 forbids, become U+FFFD.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Escaped<'a>(pub(crate) &'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for character in self.0.chars() {
            match character {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                '"' => f.write_str("&quot;")?,
                '\t' | '\n' | '\r' => f.write_str(" ")?,
                other if is_control(other) => f.write_str("\u{fffd}")?,
                other => write!(f, "{other}")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_text_gives_well_formed_xml() {
        let mut canvas = Canvas::default();
        let style = TextStyle::new(12.0, Color::category(0), Anchor::Middle)
            .bold()
            .upwards();
        canvas.text([1.0, 2.0], "a < b & \"c\"\u{0}\u{b}\n'd'", &style);
        let svg = canvas.finish(10.0, 20.0, "<title> & more");
        let document = roxmltree::Document::parse(svg.as_str()).unwrap();
        let text = document
            .descendants()
            .find(|node| node.has_tag_name("text"))
            .unwrap();
        assert_eq!(text.text(), Some("a < b & \"c\"\u{fffd}\u{fffd} 'd'"));
    }

    #[test]
    fn lengths_are_short_and_never_negative_zero() {
        assert_eq!(Px(1.0).to_string(), "1");
        assert_eq!(Px(-0.001).to_string(), "0");
        assert_eq!(Px(255.200_000_000_02).to_string(), "255.2");
    }
}
