//! Pictures as SVG documents.
//!
//! The documents carry no `id`, so that any number of them can stand in one HTML page: clipping is done by nested `svg` elements,
//! and gradients are strips of rectangles.

use std::fmt::{self, Write as _};

use base64::Engine as _;

use crate::shape::{Anchor, Area, Picture, Shape, Stroke, TextStyle};
use crate::text::{FONT_FAMILY, Weight};
use stickslip_text::plain::is_control;

/// The document of a picture, white behind everything.
pub(crate) fn document(picture: &Picture) -> String {
    let mut text = String::new();
    write_document(&mut text, picture);
    text
}

// Writing to a String cannot fail, so the results of `write!` below are dropped.
fn write_document(text: &mut String, picture: &Picture) {
    let _ = write!(
        text,
        concat!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" "#,
            r#"width="{w}" height="{h}" viewBox="0 0 {w} {h}" font-family="{font}" role="img">"#,
            "\n<title>{title}</title>\n",
            r##"<rect x="0" y="0" width="{w}" height="{h}" fill="#ffffff"/>"##,
            "\n"
        ),
        w = Px(picture.width),
        h = Px(picture.height),
        font = FONT_FAMILY,
        title = Escaped(&picture.title),
    );
    write_shapes(text, &picture.shapes);
    text.push_str("</svg>\n");
}

fn write_shapes(text: &mut String, shapes: &[Shape]) {
    for shape in shapes {
        write_shape(text, shape);
    }
}

fn write_shape(text: &mut String, shape: &Shape) {
    match shape {
        Shape::Rectangle {
            area,
            fill,
            outline,
        } => {
            let _ = write!(text, r#"<rect {} fill="{fill}""#, Bounds(area));
            if let Some(stroke) = outline {
                write_stroke(text, stroke);
            }
            text.push_str("/>\n");
        }
        Shape::Line {
            ends: [from, to],
            stroke,
        } => {
            let [x1, y1, x2, y2] = [from[0], from[1], to[0], to[1]].map(Px);
            let _ = write!(text, r#"<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}""#);
            write_stroke(text, stroke);
            text.push_str("/>\n");
        }
        Shape::Path { data, fill, stroke } => {
            let fill = fill.map_or_else(|| "none".to_owned(), |fill| fill.to_string());
            let _ = write!(text, r#"<path d="{data}" fill="{fill}""#);
            write_stroke(text, stroke);
            text.push_str(" stroke-linejoin=\"round\"/>\n");
        }
        Shape::Text {
            at,
            text: words,
            style,
        } => write_text(text, *at, words, style),
        Shape::Image { area, png, .. } => write_image(text, area, png),
        Shape::Clipped { area, shapes } => write_clipped(text, area, shapes),
        Shape::Placed { at, picture } => {
            let [x, y] = at.map(Px);
            let _ = writeln!(text, r#"<g transform="translate({x} {y})">"#);
            write_document(text, picture);
            text.push_str("</g>\n");
        }
    }
}

fn write_image(text: &mut String, area: &Area, png: &[u8]) {
    let _ = write!(
        text,
        r#"<image {} preserveAspectRatio="none" xlink:href="data:image/png;base64,"#,
        Bounds(area),
    );
    base64::engine::general_purpose::STANDARD.encode_string(png, text);
    text.push_str("\"/>\n");
}

fn write_clipped(text: &mut String, area: &Area, shapes: &[Shape]) {
    let (left, top) = (Px(area.left), Px(area.top));
    let (width, height) = (Px(area.width), Px(area.height));
    let _ = writeln!(
        text,
        r#"<svg {} viewBox="{left} {top} {width} {height}" overflow="hidden">"#,
        Bounds(area),
    );
    write_shapes(text, shapes);
    text.push_str("</svg>\n");
}

fn write_text(text: &mut String, [x, y]: [f64; 2], words: &str, style: &TextStyle) {
    let (x, y) = (Px(x), Px(y));
    let (size, color) = (Px(style.size), style.color);
    let _ = write!(
        text,
        r#"<text x="{x}" y="{y}" font-size="{size}" fill="{color}""#
    );
    text.push_str(match style.anchor {
        Anchor::Start => "",
        Anchor::Middle => r#" text-anchor="middle""#,
        Anchor::End => r#" text-anchor="end""#,
    });
    if style.weight == Weight::Bold {
        text.push_str(r#" font-weight="bold""#);
    }
    if style.upwards {
        let _ = write!(text, r#" transform="rotate(-90 {x} {y})""#);
    }
    let _ = writeln!(text, ">{}</text>", Escaped(words));
}

fn write_stroke(text: &mut String, stroke: &Stroke) {
    let (color, width) = (stroke.color, Px(stroke.width));
    let _ = write!(text, r#" stroke="{color}" stroke-width="{width}""#);
    if !stroke.dashes.is_empty() {
        let lengths: Vec<String> = stroke.dashes.iter().map(|d| Px(*d).to_string()).collect();
        let _ = write!(text, r#" stroke-dasharray="{}""#, lengths.join(" "));
    }
}

/// Place and size of an area as attributes.
struct Bounds<'a>(&'a Area);

impl fmt::Display for Bounds<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (left, top) = (Px(self.0.left), Px(self.0.top));
        let (width, height) = (Px(self.0.width), Px(self.0.height));
        write!(
            f,
            r#"x="{left}" y="{top}" width="{width}" height="{height}""#
        )
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
    fn lengths_are_short_and_never_negative_zero() {
        assert_eq!(Px(1.0).to_string(), "1");
        assert_eq!(Px(-0.001).to_string(), "0");
        assert_eq!(Px(255.200_000_000_02).to_string(), "255.2");
    }
}
