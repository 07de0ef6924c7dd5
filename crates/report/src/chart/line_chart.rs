//! What a line chart shows.

use crate::axis::Axis;
use crate::color::Color;

/// How the points of a series are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SeriesStyle {
    /// Straight lines from point to point.
    Line,
    /// A marker at each point.
    Markers,
    /// Lines and markers.
    Both,
    /// A staircase: the y of a point holds until the x of the next one.
    Step,
}

/// Dashes of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dash {
    /// Unbroken.
    Solid,
    /// Long strokes.
    Dashed,
    /// Dots.
    Dotted,
    /// Strokes and dots in turn.
    DashDotted,
    /// Strokes twice as long as those of `Dashed`.
    LongDashed,
}

impl Dash {
    pub(crate) fn pattern(self) -> &'static [f64] {
        match self {
            Self::Solid => &[],
            Self::Dashed => &[7.0, 4.0],
            Self::Dotted => &[1.5, 3.0],
            Self::DashDotted => &[8.0, 3.0, 1.5, 3.0],
            Self::LongDashed => &[14.0, 7.0],
        }
    }
}

/// One curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name in the legend; empty for a curve that the legend leaves out.
    pub label: String,
    /// Points (x, y) in the units of the axes. A coordinate that has no place on its
    /// axis (NaN, infinite, not positive on a log axis) interrupts the line.
    pub points: Vec<[f64; 2]>,
    /// Spread of each point along x, low and high end in the unit of the axis, drawn as a bar through the point; points
    /// beyond the end of this list have none.
    pub spread: Vec<[f64; 2]>,
    /// Margin of each point along y, low and high end in the unit of the axis, drawn as a band in a tint of the colour below all curves; points beyond
    /// the end of this list have none.
    pub margin: Vec<[f64; 2]>,
    /// Lines, markers or both.
    pub style: SeriesStyle,
    /// Colour; the category of the series' position in the chart if not given.
    pub color: Option<Color>,
    /// Dashes of the line.
    pub dash: Dash,
    /// Width of the line \[px\].
    pub width: f64,
}

impl Series {
    /// Makes a solid line through `points`, (x, y) in the units of the axes.
    pub fn new(label: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self {
            label: label.into(),
            points,
            spread: Vec::new(),
            margin: Vec::new(),
            style: SeriesStyle::Line,
            color: None,
            dash: Dash::Solid,
            width: 1.8,
        }
    }

    /// Sets the spread of the points along x, low and high end of each in the unit of the axis.
    #[must_use]
    pub fn spread(mut self, spread: Vec<[f64; 2]>) -> Self {
        self.spread = spread;
        self
    }

    /// Sets the margins of the points along y, low and high end of each in the unit of the axis.
    #[must_use]
    pub fn margin(mut self, margin: Vec<[f64; 2]>) -> Self {
        self.margin = margin;
        self
    }

    /// Sets lines, markers or both.
    #[must_use]
    pub fn style(mut self, style: SeriesStyle) -> Self {
        self.style = style;
        self
    }

    /// Sets the colour.
    #[must_use]
    pub fn color(mut self, color: Color) -> Self {
        self.color = Some(color);
        self
    }

    /// Sets the dashes.
    #[must_use]
    pub fn dash(mut self, dash: Dash) -> Self {
        self.dash = dash;
        self
    }

    /// Sets the width of the line \[px\].
    #[must_use]
    pub fn width(mut self, width: f64) -> Self {
        self.width = width;
        self
    }
}

/// A shaded range of x over the whole height: a zone.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// Name above the band, or in the legend where the band is too narrow for it.
    /// Bands of equal name share one legend entry.
    pub label: String,
    /// Ends on the x axis, in its unit; a part outside the axis is left out.
    pub range: [f64; 2],
    /// Colour of the name; the shade is a tint of it.
    pub color: Color,
}

impl Band {
    /// Makes a band from `low` to `high` on the x axis, in its unit.
    pub fn new(label: impl Into<String>, low: f64, high: f64, color: Color) -> Self {
        Self {
            label: label.into(),
            range: [low, high],
            color,
        }
    }
}

/// Direction of a [`ReferenceLine`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// At one y, over the whole width.
    Horizontal,
    /// At one x, over the whole height.
    Vertical,
}

/// A named dashed line at one value: a limit, a nominal stress, the end of contact.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceLine {
    /// Name beside (horizontal) or above (vertical) the frame; may be empty.
    pub label: String,
    /// Horizontal or vertical.
    pub direction: Direction,
    /// Value on the y axis (horizontal) or the x axis (vertical), in its unit. A
    /// fitted axis is widened to show it.
    pub value: f64,
    /// Colour of line and name.
    pub color: Color,
}

impl ReferenceLine {
    /// Makes a grey line at `y`, in the unit of the y axis.
    pub fn horizontal(label: impl Into<String>, y: f64) -> Self {
        let color = Color::rgb(0x55, 0x55, 0x55);
        Self {
            label: label.into(),
            direction: Direction::Horizontal,
            value: y,
            color,
        }
    }

    /// Makes a grey line at `x`, in the unit of the x axis.
    pub fn vertical(label: impl Into<String>, x: f64) -> Self {
        Self {
            direction: Direction::Vertical,
            ..Self::horizontal(label, x)
        }
    }

    /// Sets the colour.
    #[must_use]
    pub fn color(mut self, color: Color) -> Self {
        self.color = color;
        self
    }
}

/// Where the legend stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Legend {
    /// Inside where no curve passes; otherwise below, or right if it is long.
    Automatic,
    /// Right of the frame.
    Right,
    /// Below the x axis, in columns.
    Below,
    /// Nowhere.
    Hidden,
}

/// A chart of curves.
#[derive(Debug, Clone, PartialEq)]
pub struct LineChart {
    /// What the chart shows; may be empty.
    pub title: String,
    /// A second, smaller line: case, load, parameters.
    pub subtitle: Option<String>,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Curves, drawn in order.
    pub series: Vec<Series>,
    /// Shaded ranges of x, behind the curves.
    pub bands: Vec<Band>,
    /// Lines at fixed values.
    pub references: Vec<ReferenceLine>,
    /// Place of the legend.
    pub legend: Legend,
    /// Width of the whole figure \[px\].
    pub width: f64,
    /// Height over width of the area inside the frame \[1\].
    pub aspect: f64,
}

impl LineChart {
    /// Makes an empty chart, 720 px wide.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Self {
            title: title.into(),
            subtitle: None,
            x,
            y,
            series: Vec::new(),
            bands: Vec::new(),
            references: Vec::new(),
            legend: Legend::Automatic,
            width: 720.0,
            aspect: 0.55,
        }
    }

    /// Sets the line below the title.
    #[must_use]
    pub fn subtitle(mut self, subtitle: impl Into<String>) -> Self {
        self.subtitle = Some(subtitle.into());
        self
    }

    /// Adds a curve.
    #[must_use]
    pub fn with(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    /// Adds a shaded range.
    #[must_use]
    pub fn band(mut self, band: Band) -> Self {
        self.bands.push(band);
        self
    }

    /// Adds a line at a fixed value.
    #[must_use]
    pub fn reference(mut self, line: ReferenceLine) -> Self {
        self.references.push(line);
        self
    }

    /// Sets the place of the legend.
    #[must_use]
    pub fn legend(mut self, legend: Legend) -> Self {
        self.legend = legend;
        self
    }

    /// Sets the width of the figure \[px\] and the aspect of the frame, height over width \[1\].
    #[must_use]
    pub fn size(mut self, width: f64, aspect: f64) -> Self {
        self.width = width;
        self.aspect = aspect;
        self
    }

    /// The colour of series `index`.
    pub(super) fn color_of(&self, index: usize) -> Color {
        let own = self.series.get(index).and_then(|series| series.color);
        own.unwrap_or_else(|| Color::category(index))
    }
}
