//! The frame of a figure: grid, ticks, axis labels, titles, and the map from values
//! to pixels.

use crate::axis::ticks::Ticks;
use crate::axis::{Axis, Padding, Span};
use crate::color::Color;
use crate::error::FigureError;
use crate::markup::{Px, push_point};
use crate::shape::{Anchor, Area, Stroke, TextStyle};
use crate::svg::Canvas;
use crate::text::{self, Weight};

pub(crate) const INK: Color = Color::rgb(0x22, 0x22, 0x22);
pub(crate) const MUTED: Color = Color::rgb(0x5f, 0x5f, 0x5f);
const GRID: Color = Color::rgb(0xe3, 0xe3, 0xe3);
const FAINT_GRID: Color = Color::rgb(0xf1, 0xf1, 0xf1);
const FRAME: Color = Color::rgb(0x77, 0x77, 0x77);

/// Free border around a figure \[px\].
pub(crate) const OUTER: f64 = 12.0;
pub(crate) const TITLE_SIZE: f64 = 15.0;
const SUBTITLE_SIZE: f64 = 12.0;
pub(crate) const LABEL_SIZE: f64 = 12.0;
pub(crate) const TICK_SIZE: f64 = 11.0;
/// Height of a line of text over its size.
pub(crate) const LINE_HEIGHT: f64 = 1.35;
const TICK_LENGTH: f64 = 4.0;
const TICK_GAP: f64 = 4.0;
const LABEL_GAP: f64 = 7.0;

/// Two axes laid over an area.
#[derive(Debug)]
pub(crate) struct Frame {
    pub(crate) area: Area,
    pub(crate) x: Span,
    pub(crate) y: Span,
    x_ticks: Ticks,
    y_ticks: Ticks,
    x_label: Vec<String>,
    y_label: Vec<String>,
}

impl Frame {
    /// Lays `axes` (x, y) with the ends `spans` over `area`.
    ///
    /// # Errors
    /// [`FigureError::TickSpacing`].
    pub(crate) fn new(axes: [&Axis; 2], spans: [Span; 2], area: Area) -> Result<Self, FigureError> {
        let [x_axis, y_axis] = axes;
        let [x, y] = spans;
        let y_wanted = (area.height / 30.0).clamp(2.0, 12.0) as usize;
        Ok(Self {
            area,
            x,
            y,
            x_ticks: fitting_x_ticks(x_axis, &x, area.width)?,
            y_ticks: y_ticks(y_axis, &y, y_wanted, area.height)?,
            x_label: text::wrap(&x_axis.label, area.width, LABEL_SIZE, Weight::Regular),
            y_label: text::wrap(&y_axis.label, area.height, LABEL_SIZE, Weight::Regular),
        })
    }

    /// Lays the axes of the part `[x_low, x_high, y_low, y_high]` of a plane over the width of `area`, with equal scales: its height follows.
    ///
    /// # Errors
    /// [`FigureError::Range`] and [`FigureError::Size`] for a part or a width that cannot be drawn, of the figure of this title and width.
    pub(crate) fn to_scale(
        labels: &[String; 2],
        [x_low, x_high, y_low, y_high]: [f64; 4],
        mut area: Area,
        (title, width): (&str, f64),
    ) -> Result<Self, FigureError> {
        let mut axes = labels.clone().map(Axis::linear);
        axes[0].range = Some([x_low, x_high]);
        axes[1].range = Some([y_low, y_high]);
        let aspect = (y_high - y_low) / (x_high - x_low);
        area.height = area.width * aspect;
        if !(area.width > 20.0 && area.height > 20.0 && area.height < 1e5) {
            return Err(FigureError::Size {
                title: title.to_owned(),
                width,
                aspect,
            });
        }
        let spans = [
            axes[0].span(std::iter::empty(), Padding::Tight)?,
            axes[1].span(std::iter::empty(), Padding::Tight)?,
        ];
        Self::new([&axes[0], &axes[1]], spans, area)
    }

    /// Room needed left of the area for the ticks and label of `axis` \[px\].
    pub(crate) fn left_margin(&self) -> f64 {
        self.y_ticks.widest(TICK_SIZE) + TICK_LENGTH + TICK_GAP + label_depth(&self.y_label)
    }

    /// Room needed below the area \[px\].
    pub(crate) fn bottom_margin(&self) -> f64 {
        TICK_LENGTH + TICK_SIZE * LINE_HEIGHT + label_depth(&self.x_label)
    }

    /// Room needed above the area for the factor of the y labels \[px\].
    pub(crate) fn top_margin(&self) -> f64 {
        if self.y_ticks.factor.is_some() {
            TICK_SIZE * LINE_HEIGHT
        } else {
            0.0
        }
    }

    /// Room needed right of the area for half of the last tick's label \[px\].
    pub(crate) fn right_margin(&self) -> f64 {
        let factor = self.x_ticks.factor.as_deref().unwrap_or_default();
        let half = self.last_x_label_width() / 2.0;
        if factor.is_empty() {
            half.max(8.0)
        } else {
            half + 8.0 + text::width(factor, TICK_SIZE, Weight::Regular)
        }
    }

    /// The pixel of a point, if it has a place on both axes.
    pub(crate) fn pixel(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        Some([self.pixel_x(x)?, self.pixel_y(y)?])
    }

    pub(crate) fn pixel_x(&self, x: f64) -> Option<f64> {
        self.x
            .fraction(x)
            .map(|s| self.area.left + s * self.area.width)
    }

    pub(crate) fn pixel_y(&self, y: f64) -> Option<f64> {
        self.y
            .fraction(y)
            .map(|s| self.area.bottom() - s * self.area.height)
    }

    /// Pixels of the x ticks.
    fn major_x(&self) -> impl Iterator<Item = f64> {
        let ticks = self.x_ticks.major.iter();
        ticks.filter_map(|tick| self.pixel_x(tick.value))
    }

    /// Pixels of the y ticks.
    fn major_y(&self) -> impl Iterator<Item = f64> {
        let ticks = self.y_ticks.major.iter();
        ticks.filter_map(|tick| self.pixel_y(tick.value))
    }

    fn last_x_label_width(&self) -> f64 {
        let last = self.x_ticks.major.last();
        text::width(
            last.map_or("", |tick| &tick.label),
            TICK_SIZE,
            Weight::Regular,
        )
    }

    /// Grid lines, fainter between the ticks; zero is drawn stronger.
    pub(crate) fn draw_grid(&self, canvas: &mut Canvas) {
        let area = self.area;
        let minor = Stroke::solid(FAINT_GRID, 1.0);
        let major = Stroke::solid(GRID, 1.0);
        let (top, bottom) = (area.top, area.bottom());
        let (left, right) = (area.left, area.right());
        for x in self.x_ticks.minor.iter().filter_map(|&x| self.pixel_x(x)) {
            canvas.line([x, top], [x, bottom], &minor);
        }
        for y in self.y_ticks.minor.iter().filter_map(|&y| self.pixel_y(y)) {
            canvas.line([left, y], [right, y], &minor);
        }
        for x in self.major_x() {
            canvas.line([x, top], [x, bottom], &major);
        }
        for tick in &self.y_ticks.major {
            let Some(y) = self.pixel_y(tick.value) else {
                continue;
            };
            let zero = Stroke::solid(Color::rgb(0xa8, 0xa8, 0xa8), 1.0);
            canvas.line(
                [left, y],
                [right, y],
                if tick.value == 0.0 { &zero } else { &major },
            );
        }
    }

    /// Border, tick marks, tick labels and axis labels.
    pub(crate) fn draw_axes(&self, canvas: &mut Canvas) {
        self.draw_border(canvas);
        self.draw_x_labels(canvas);
        self.draw_y_labels(canvas);
    }

    fn draw_border(&self, canvas: &mut Canvas) {
        let area = self.area;
        let stroke = Stroke::solid(FRAME, 1.0);
        let (down, left) = (format!("v{TICK_LENGTH}"), format!("h-{TICK_LENGTH}"));
        let mut data = format!(
            "M{} {}h{}v{}h{}z",
            Px(area.left),
            Px(area.top),
            Px(area.width),
            Px(area.height),
            Px(-area.width),
        );
        for x in self.major_x() {
            push_point(&mut data, 'M', [x, area.bottom()]);
            data += &down;
        }
        for y in self.major_y() {
            push_point(&mut data, 'M', [area.left, y]);
            data += &left;
        }
        canvas.stroked_path(&data, &stroke);
    }

    fn draw_x_labels(&self, canvas: &mut Canvas) {
        let style = TextStyle::new(TICK_SIZE, INK, Anchor::Middle);
        let baseline = self.area.bottom() + TICK_LENGTH + TICK_SIZE * 1.1;
        for tick in &self.x_ticks.major {
            if let Some(x) = self.pixel_x(tick.value).filter(|_| !tick.label.is_empty()) {
                canvas.text([x, baseline], &tick.label, &style);
            }
        }
        if let Some(factor) = &self.x_ticks.factor {
            let x = self.area.right() + self.last_x_label_width() / 2.0 + 6.0;
            canvas.text(
                [x, baseline],
                factor,
                &TextStyle::new(TICK_SIZE, INK, Anchor::Start),
            );
        }
        let label = TextStyle::new(LABEL_SIZE, INK, Anchor::Middle);
        let first = self.area.bottom() + TICK_LENGTH + TICK_SIZE * LINE_HEIGHT + LABEL_GAP;
        for (index, line) in self.x_label.iter().enumerate() {
            let y = first + LABEL_SIZE * (0.9 + LINE_HEIGHT * index as f64);
            canvas.text([self.area.middle()[0], y], line, &label);
        }
    }

    fn draw_y_labels(&self, canvas: &mut Canvas) {
        let style = TextStyle::new(TICK_SIZE, INK, Anchor::End);
        let x = self.area.left - TICK_LENGTH - TICK_GAP;
        for tick in &self.y_ticks.major {
            if let Some(y) = self.pixel_y(tick.value).filter(|_| !tick.label.is_empty()) {
                canvas.centred_text([x, y], &tick.label, &style);
            }
        }
        if let Some(factor) = &self.y_ticks.factor {
            let at = [
                self.area.left - TICK_LENGTH,
                self.area.top - 0.7 * TICK_SIZE,
            ];
            canvas.text(at, factor, &TextStyle::new(TICK_SIZE, INK, Anchor::Start));
        }
        let label = TextStyle::new(LABEL_SIZE, INK, Anchor::Middle).upwards();
        let last = x - self.y_ticks.widest(TICK_SIZE) - LABEL_GAP - 0.2 * LABEL_SIZE;
        for (index, line) in self.y_label.iter().rev().enumerate() {
            let x = last - LABEL_SIZE * LINE_HEIGHT * index as f64;
            canvas.text([x, self.area.middle()[1]], line, &label);
        }
    }
}

/// Room that an axis label needs across its lines \[px\].
fn label_depth(lines: &[String]) -> f64 {
    if lines.is_empty() {
        0.0
    } else {
        LABEL_GAP + LABEL_SIZE * LINE_HEIGHT * lines.len() as f64
    }
}

/// As many ticks as have room for their labels side by side.
fn fitting_x_ticks(axis: &Axis, span: &Span, width: f64) -> Result<Ticks, FigureError> {
    let mut wanted = (width / 55.0).clamp(2.0, 12.0) as usize;
    loop {
        let mut ticks = Ticks::new(axis, span, wanted)?;
        let room = (width / (ticks.widest(TICK_SIZE) + 10.0)) as usize;
        if ticks.major.len() <= room + 1 {
            return Ok(ticks);
        }
        if wanted <= 2 || axis.tick_spacing.is_some() {
            ticks.thin_labels(room);
            return Ok(ticks);
        }
        wanted -= 1;
    }
}

fn y_ticks(axis: &Axis, span: &Span, wanted: usize, height: f64) -> Result<Ticks, FigureError> {
    let mut ticks = Ticks::new(axis, span, wanted)?;
    let room = (height / (TICK_SIZE * LINE_HEIGHT)) as usize;
    if ticks.major.len() > room + 1 {
        ticks.thin_labels(room);
    }
    Ok(ticks)
}

/// Title and the muted lines below it, wrapped to a width.
#[derive(Debug)]
pub(crate) struct Heading {
    title_size: f64,
    title: Vec<String>,
    lines: Vec<String>,
}

impl Heading {
    pub(crate) fn new(title: &str, title_size: f64, below: &[&str], width: f64) -> Self {
        let lines = below
            .iter()
            .flat_map(|line| text::wrap(line, width, SUBTITLE_SIZE, Weight::Regular))
            .collect();
        Self {
            title_size,
            title: text::wrap(title, width, title_size, Weight::Bold),
            lines,
        }
    }

    pub(crate) fn height(&self) -> f64 {
        let title = self.title_size * LINE_HEIGHT * self.title.len() as f64;
        let lines = SUBTITLE_SIZE * LINE_HEIGHT * self.lines.len() as f64;
        if title + lines > 0.0 {
            title + lines + 8.0
        } else {
            0.0
        }
    }

    /// Draws from the upper left corner `at`.
    pub(crate) fn draw(&self, canvas: &mut Canvas, at: [f64; 2]) {
        let [left, mut top] = at;
        let title = TextStyle::new(self.title_size, INK, Anchor::Start).bold();
        for line in &self.title {
            canvas.text([left, top + self.title_size], line, &title);
            top += self.title_size * LINE_HEIGHT;
        }
        let muted = TextStyle::new(SUBTITLE_SIZE, MUTED, Anchor::Start);
        for line in &self.lines {
            canvas.text([left, top + SUBTITLE_SIZE], line, &muted);
            top += SUBTITLE_SIZE * LINE_HEIGHT;
        }
    }
}
