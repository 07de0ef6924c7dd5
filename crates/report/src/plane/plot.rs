//! What a picture of a plane shows.

use crate::color::{Color, Colormap};

/// Where there is no value: grey, but pale blue among greys.
pub(super) fn no_value(colormap: Colormap) -> Color {
    if colormap == Colormap::Gray {
        Color::rgb(0xc6, 0xd8, 0xec)
    } else {
        Color::rgb(0xe4, 0xe4, 0xe4)
    }
}

/// Values at the pixels of an upright picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Pixels<'a> {
    /// Number of columns.
    pub columns: usize,
    /// Values row by row from the top left, in the unit of the plot's label; NaN where there is none.
    pub values: &'a [f64],
    /// Edges of the picture, `[x_low, x_high, y_low, y_high]` \[length\].
    pub edges: [f64; 4],
}

/// Marks of one kind over a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Marks {
    /// What they mean, in the legend.
    pub label: String,
    /// Their colour.
    pub color: Color,
    /// Places marked by a small cross \[length\].
    pub points: Vec<[f64; 2]>,
    /// Lines from place to place \[length\].
    pub paths: Vec<Vec<[f64; 2]>>,
    /// Text about places \[length\].
    pub texts: Vec<([f64; 2], String)>,
    /// Width of lines \[px\].
    pub width: f64,
}

impl Marks {
    /// Nothing marked yet.
    pub fn new(label: impl Into<String>, color: Color) -> Self {
        Self {
            label: label.into(),
            color,
            points: Vec::new(),
            paths: Vec::new(),
            texts: Vec::new(),
            width: 1.6,
        }
    }

    /// Whether nothing is marked.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty() && self.paths.is_empty() && self.texts.is_empty()
    }
}

/// Pixels, dots and marks over one plane.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanePlot<'a> {
    /// What the picture shows.
    pub title: String,
    /// A second, smaller line.
    pub subtitle: Option<String>,
    /// Values at pixels.
    pub pixels: Option<Pixels<'a>>,
    /// Scattered places \[length\] and values there, in the unit of `label`; grey where NaN.
    pub dots: &'a [([f64; 2], f64)],
    /// Marks, drawn over the rest.
    pub marks: Vec<Marks>,
    /// Name, symbol and unit of the values; without it there is no colour bar.
    pub label: Option<String>,
    /// Names and units of the x and y axes.
    pub axes: [String; 2],
    /// Colours of the values.
    pub colormap: Colormap,
    /// Values at the ends of the colours, in the unit of `label`; the least and greatest value if not given.
    pub range: Option<[f64; 2]>,
    /// The part to show, `[x_low, x_high, y_low, y_high]` \[length\].
    pub window: [f64; 4],
    /// Width of the whole figure \[px\].
    pub width: f64,
    /// Image pixels per figure pixel \[1\], at most: 1 for figures that are shown or written at their own size, more for those that are
    /// magnified.
    pub sharpness: f64,
}
