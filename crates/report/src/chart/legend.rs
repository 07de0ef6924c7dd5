//! The legend: its entries, their size, and a place for them.

use super::curves::{clip, draw_name, draw_sample, runs};
use super::{LineChart, Series, SeriesStyle};
use crate::color::Color;
use crate::frame::{Frame, INK, LINE_HEIGHT};
use crate::shape::{Area, Stroke};
use crate::svg::Canvas;
use crate::text::{self, Weight};

const SIZE: f64 = 11.0;
const SAMPLE: f64 = 26.0;
const SAMPLE_GAP: f64 = 7.0;
const COLUMN_GAP: f64 = 18.0;
const INSET: f64 = 8.0;
const ROW_GAP: f64 = 4.0;
/// Names are wrapped at this width \[px\].
const WIDEST_NAME: f64 = 240.0;
/// Free room kept between the legend and a curve \[px\].
const CLEARANCE: f64 = 7.0;
/// A legend inside may cover this part of the frame.
const LARGEST_PART: f64 = 0.30;

#[derive(Debug)]
enum Sample {
    Curve { series: Box<Series>, index: usize },
    Shade,
}

#[derive(Debug)]
struct Entry {
    sample: Sample,
    color: Color,
    lines: Vec<String>,
}

impl Entry {
    fn width(&self) -> f64 {
        SAMPLE + SAMPLE_GAP + text::widest(self.lines.iter().map(String::as_str), SIZE)
    }

    fn height(&self) -> f64 {
        SIZE * LINE_HEIGHT * self.lines.len().max(1) as f64
    }
}

/// A legend laid out in columns, filled column by column.
#[derive(Debug)]
pub(crate) struct LegendBox {
    entries: Vec<Entry>,
    columns: usize,
    boxed: bool,
}

impl LegendBox {
    /// The legend of `chart` in one column, with `shades` for bands; nothing without entries.
    pub(crate) fn new(chart: &LineChart, shades: &[(String, Color)]) -> Option<Self> {
        let wrap = |label: &str| text::wrap(label, WIDEST_NAME, SIZE, Weight::Regular);
        let curves = chart
            .series
            .iter()
            .enumerate()
            .filter(|(_, s)| !s.label.trim().is_empty());
        let mut entries: Vec<Entry> = curves
            .map(|(index, series)| {
                // Only the look of the series is needed, not its points.
                let look = Series {
                    points: Vec::new(),
                    ..series.clone()
                };
                Entry {
                    sample: Sample::Curve {
                        series: Box::new(look),
                        index,
                    },
                    color: chart.color_of(index),
                    lines: wrap(&series.label),
                }
            })
            .collect();
        entries.extend(shades.iter().map(|(label, color)| Entry {
            sample: Sample::Shade,
            color: *color,
            lines: wrap(label),
        }));
        (!entries.is_empty()).then_some(Self {
            entries,
            columns: 1,
            boxed: false,
        })
    }

    pub(crate) fn len(&self) -> usize {
        self.entries.len()
    }

    /// Puts the entries side by side as far as `width` allows, in columns of equal length.
    pub(crate) fn spread(&mut self, width: f64) {
        let column = self.column_width() + COLUMN_GAP;
        let fitting = ((width + COLUMN_GAP) / column).max(1.0) as usize;
        let rows = self.entries.len().div_ceil(fitting);
        self.columns = self.entries.len().div_ceil(rows);
    }

    /// Draws a border and a white ground, for a legend inside the frame.
    pub(crate) fn enclose(&mut self) {
        self.boxed = true;
    }

    /// Width and height \[px\].
    pub(crate) fn size(&self) -> [f64; 2] {
        let inset = if self.boxed { 2.0 * INSET } else { 0.0 };
        let columns = self.columns as f64;
        let width = columns * self.column_width() + (columns - 1.0) * COLUMN_GAP;
        let height = self
            .entries
            .chunks(self.rows())
            .map(|column| {
                column
                    .iter()
                    .map(|entry| entry.height() + ROW_GAP)
                    .sum::<f64>()
            })
            .fold(0.0, f64::max);
        [width + inset, height - ROW_GAP + inset]
    }

    pub(crate) fn draw(&self, canvas: &mut Canvas, at: [f64; 2]) {
        let [width, height] = self.size();
        let mut corner = at;
        if self.boxed {
            let ground = Area::new([at[0], at[1]], [width, height]);
            let border = Stroke::solid(Color::rgb(0xcc, 0xcc, 0xcc), 1.0);
            canvas.rectangle(&ground, Color::rgb(255, 255, 255), Some(&border));
            corner = [at[0] + INSET, at[1] + INSET];
        }
        for (column, entries) in self.entries.chunks(self.rows()).enumerate() {
            let left = corner[0] + column as f64 * (self.column_width() + COLUMN_GAP);
            let mut top = corner[1];
            for entry in entries {
                draw_entry(canvas, [left, top], entry);
                top += entry.height() + ROW_GAP;
            }
        }
    }

    fn rows(&self) -> usize {
        self.entries.len().div_ceil(self.columns).max(1)
    }

    fn column_width(&self) -> f64 {
        self.entries.iter().map(Entry::width).fold(0.0, f64::max)
    }
}

fn draw_entry(canvas: &mut Canvas, [left, top]: [f64; 2], entry: &Entry) {
    let middle = top + SIZE * LINE_HEIGHT / 2.0;
    match &entry.sample {
        Sample::Curve { series, index } => {
            draw_sample(canvas, [left, middle], SAMPLE, series, entry.color, *index);
        }
        Sample::Shade => {
            let swatch = Area::new([left, middle - 5.0], [SAMPLE, 10.0]);
            let border = Stroke::solid(entry.color.tint(0.5), 1.0);
            canvas.rectangle(
                &swatch,
                entry.color.tint(super::annotations::SHADE),
                Some(&border),
            );
        }
    }
    for (index, line) in entry.lines.iter().enumerate() {
        let y = middle + SIZE * LINE_HEIGHT * index as f64;
        draw_name(canvas, [left + SAMPLE + SAMPLE_GAP, y], line, SIZE, INK);
    }
}

/// The upper left corner of a place inside the frame that no curve, marker or
/// reference line touches; corners are preferred.
pub(crate) fn empty_place(chart: &LineChart, frame: &Frame, size: [f64; 2]) -> Option<[f64; 2]> {
    let area = frame.area.grown(-CLEARANCE);
    let [width, height] = size;
    if width > area.width || height > area.height {
        return None;
    }
    if width * height > LARGEST_PART * frame.area.width * frame.area.height {
        return None;
    }
    let segments = drawn_segments(chart, frame);
    let columns = [1.0, 0.0, 0.5, 0.75, 0.25];
    let rows = [0.0, 1.0, 0.5, 0.25, 0.75];
    let mut places: Vec<(f64, f64)> = columns
        .iter()
        .flat_map(|&s| rows.iter().map(move |&t| (s, t)))
        .collect();
    // Corners, then the middles of the sides, then the rest; the sort is stable.
    let rank = |(s, t): &(f64, f64)| [s, t].iter().filter(|u| ***u != 0.0 && ***u != 1.0).count();
    places.sort_by_key(rank);
    places
        .into_iter()
        .map(|(s, t)| {
            [
                area.left + s * (area.width - width),
                area.top + t * (area.height - height),
            ]
        })
        .find(|&[left, top]| {
            let place = Area::new([left, top], [width, height]).grown(CLEARANCE);
            segments
                .iter()
                .all(|[from, to]| clip(*from, *to, &place).is_none())
        })
}

/// Everything drawn inside the frame, as segments; a marker is a segment of no length.
fn drawn_segments(chart: &LineChart, frame: &Frame) -> Vec<[[f64; 2]; 2]> {
    let mut segments = Vec::new();
    for series in &chart.series {
        for run in runs(frame, series) {
            let lone = run.len() == 1 || series.style == SeriesStyle::Markers;
            if lone {
                segments.extend(run.iter().map(|&point| [point, point]));
            } else {
                segments.extend(run.windows(2).map(|pair| [pair[0], pair[1]]));
            }
        }
    }
    for line in &chart.references {
        segments.extend(super::annotations::segment(line, frame));
    }
    segments
}
