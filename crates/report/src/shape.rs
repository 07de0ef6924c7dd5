//! What a picture is made of. Lengths are figure pixels, x to the right, y down.

use std::sync::Arc;

use crate::color::Color;
use crate::image::Image;
use crate::text::Weight;

/// An upright rectangle \[px\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Area {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl Area {
    /// An area with its upper left corner and its width and height.
    pub(crate) const fn new([left, top]: [f64; 2], [width, height]: [f64; 2]) -> Self {
        Self {
            left,
            top,
            width,
            height,
        }
    }

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
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stroke {
    pub(crate) color: Color,
    pub(crate) width: f64,
    /// Lengths of strokes and gaps \[px\]; empty for solid.
    pub(crate) dashes: &'static [f64],
}

impl Stroke {
    pub(crate) fn solid(color: Color, width: f64) -> Self {
        Self::dashed(color, width, &[])
    }

    pub(crate) fn dashed(color: Color, width: f64, dashes: &'static [f64]) -> Self {
        Self {
            color,
            width,
            dashes,
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
#[derive(Debug, Clone, Copy, PartialEq)]
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

/// One part of a picture.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Shape {
    /// A filled rectangle.
    Rectangle {
        area: Area,
        fill: Color,
        outline: Option<Stroke>,
    },
    /// A straight line.
    Line { ends: [[f64; 2]; 2], stroke: Stroke },
    /// A path with round corners, in the path data of SVG without arcs and shorthand curves.
    Path {
        data: String,
        fill: Option<Color>,
        stroke: Stroke,
    },
    /// A text on one line with its baseline at a place.
    Text {
        at: [f64; 2],
        text: String,
        style: TextStyle,
    },
    /// An image stretched over an area.
    Image {
        area: Area,
        image: Image,
        /// The same as a PNG file.
        png: Vec<u8>,
    },
    /// What is drawn inside an area only.
    Clipped { area: Area, shapes: Vec<Shape> },
    /// A finished picture with its upper left corner at a place.
    Placed { at: [f64; 2], picture: Arc<Picture> },
}

/// A picture on white.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Picture {
    pub(crate) width: f64,
    pub(crate) height: f64,
    /// What a screen reader says.
    pub(crate) title: String,
    pub(crate) shapes: Vec<Shape>,
}
