//! A finished picture, and the canvas that it is drawn on.

use std::fmt;
use std::sync::Arc;

use crate::color::Color;
use crate::image::Image;
use crate::markup;
use crate::shape::{Area, Picture, Shape, Stroke, TextStyle};

/// A self-contained SVG document. Only this crate makes one, so its markup is
/// well-formed and free of scripts, and [`page`](crate::page) may insert it as it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Svg {
    markup: String,
    picture: Arc<Picture>,
}

impl Svg {
    /// The document's text, UTF-8.
    pub fn as_str(&self) -> &str {
        &self.markup
    }

    /// The width \[px\].
    pub fn width(&self) -> f64 {
        self.picture.width
    }

    /// The height \[px\].
    pub fn height(&self) -> f64 {
        self.picture.height
    }

    /// What the document shows.
    pub(crate) fn picture(&self) -> &Picture {
        &self.picture
    }
}

impl fmt::Display for Svg {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.markup)
    }
}

/// Collects the shapes of a picture.
#[derive(Debug, Default)]
pub(crate) struct Canvas {
    shapes: Vec<Shape>,
}

impl Canvas {
    pub(crate) fn rectangle(&mut self, area: &Area, fill: Color, outline: Option<&Stroke>) {
        self.shapes.push(Shape::Rectangle {
            area: *area,
            fill,
            outline: outline.cloned(),
        });
    }

    pub(crate) fn line(&mut self, from: [f64; 2], to: [f64; 2], stroke: &Stroke) {
        self.shapes.push(Shape::Line {
            ends: [from, to],
            stroke: stroke.clone(),
        });
    }

    /// An unfilled path from path data.
    pub(crate) fn stroked_path(&mut self, data: &str, stroke: &Stroke) {
        self.path(data, None, stroke);
    }

    /// A filled path from path data, with an outline.
    pub(crate) fn filled_path(&mut self, data: &str, fill: Color, outline: &Stroke) {
        self.path(data, Some(fill), outline);
    }

    fn path(&mut self, data: &str, fill: Option<Color>, stroke: &Stroke) {
        if !data.is_empty() {
            self.shapes.push(Shape::Path {
                data: data.to_owned(),
                fill,
                stroke: stroke.clone(),
            });
        }
    }

    /// A text whose baseline starts, is centred or ends at `at`.
    pub(crate) fn text(&mut self, at: [f64; 2], text: &str, style: &TextStyle) {
        self.shapes.push(Shape::Text {
            at,
            text: text.to_owned(),
            style: *style,
        });
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

    /// An image stretched over `area`, and the same image as a PNG file.
    pub(crate) fn image(&mut self, area: &Area, image: Image, png: Vec<u8>) {
        self.shapes.push(Shape::Image {
            area: *area,
            image,
            png,
        });
    }

    /// Draws inside `area` only; coordinates stay those of the whole picture.
    pub(crate) fn clipped(&mut self, area: &Area, draw: impl FnOnce(&mut Self)) {
        let mut inner = Self::default();
        draw(&mut inner);
        self.shapes.push(Shape::Clipped {
            area: *area,
            shapes: inner.shapes,
        });
    }

    /// Places a finished picture with its upper left corner at `at`.
    pub(crate) fn place(&mut self, at: [f64; 2], picture: &Svg) {
        self.shapes.push(Shape::Placed {
            at,
            picture: Arc::clone(&picture.picture),
        });
    }

    /// The document, white behind everything; `title` is what a screen reader says.
    pub(crate) fn finish(self, width: f64, height: f64, title: &str) -> Svg {
        let picture = Picture {
            width,
            height,
            title: title.to_owned(),
            shapes: self.shapes,
        };
        Svg {
            markup: markup::document(&picture),
            picture: Arc::new(picture),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Anchor;

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
}
