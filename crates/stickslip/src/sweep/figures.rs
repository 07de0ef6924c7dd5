//! Pictures of a sweep: maps of failure modes over two axes and curves of failure loads; without failure criteria curves of the contact over every axis.
//!
//! A sweep of more than two axes has one picture for every combination of the others, up to a dozen.

mod curves;
mod not_shown;

use stickslip_report::FigureError;
use stickslip_report::axis::Axis as FigureAxis;
use stickslip_report::cells::{Cell, CellMap};
use stickslip_report::chart::{Dash, LineChart, Series, SeriesStyle};
use stickslip_report::color::Color;
use stickslip_report::map::Category;
use stickslip_report::svg::Svg;

use super::Sweep;
use super::axis::Axis;
use super::row::Row;
use super::verdict::ORDER;
use stickslip_engine::results::JointMode;
use stickslip_text::short;

pub use not_shown::NotShown;

/// Most combinations of further axes that are drawn.
const MOST_PICTURES: usize = 12;

/// A picture with what it shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Name of its files.
    pub name: String,
    /// The picture.
    pub picture: Svg,
    /// What it shows, in a sentence.
    pub caption: String,
}

/// All pictures of a sweep, and what they do not show.
pub fn draw(sweep: &Sweep, rows: &[Row]) -> (Vec<Drawing>, Vec<NotShown>) {
    let (mut drawings, mut remarks) = (Vec::new(), Vec::new());
    let slices = slices(sweep);
    if slices.len() > MOST_PICTURES {
        remarks.push(NotShown::Combinations {
            shown: MOST_PICTURES,
            all: slices.len(),
        });
    }
    for (index, slice) in slices.iter().take(MOST_PICTURES).enumerate() {
        let number = if slices.len() > 1 {
            format!("-{}", index + 1)
        } else {
            String::new()
        };
        let view = View { sweep, rows, slice };
        let pictures = [
            ("modes", "Failure modes", view.modes()),
            ("loads", "Failure loads", view.loads()),
        ];
        for (name, what, picture) in pictures {
            match picture {
                Some(Ok((picture, caption))) => drawings.push(Drawing {
                    name: format!("{name}{number}"),
                    picture,
                    caption,
                }),
                Some(Err(cause)) => {
                    let picture = format!("{what}{}", view.conditions());
                    remarks.push(NotShown::Failed { picture, cause });
                }
                None => {}
            }
        }
    }
    let (further, about) = curves::draw(sweep, rows);
    let drawing = |(name, (picture, caption))| Drawing {
        name,
        picture,
        caption,
    };
    drawings.extend(further.into_iter().map(drawing));
    remarks.extend(about);
    (drawings, remarks)
}

/// Values of the axes that a map does not show: (axis, value).
type Slice = Vec<(usize, usize)>;

/// All combinations of the axes that a map does not show.
fn slices(sweep: &Sweep) -> Vec<Slice> {
    let mut slices: Vec<Slice> = vec![Vec::new()];
    for (index, axis) in sweep.axes.iter().enumerate() {
        if sweep.map.contains(&Some(index)) {
            continue;
        }
        let extended = slices.iter().flat_map(|slice| {
            (0..axis.values.len()).map(|value| {
                let mut longer = slice.clone();
                longer.push((index, value));
                longer
            })
        });
        slices = extended.collect();
    }
    slices
}

/// Colour and mark of a mode; mixed modes stand between their two in hue.
fn category(mode: JointMode) -> Category {
    let (mark, color) = match mode {
        JointMode::Bearing => ("B", Color::rgb(0x00, 0x72, 0xb2)),
        JointMode::BearingAndShearOut => ("B+S", Color::rgb(0x56, 0xb4, 0xe9)),
        JointMode::ShearOut => ("S", Color::rgb(0x00, 0x9e, 0x73)),
        JointMode::ShearOutAndNetTension => ("S+T", Color::rgb(0xe6, 0x9f, 0x00)),
        JointMode::NetTension => ("T", Color::rgb(0xd5, 0x5e, 0x00)),
    };
    Category {
        label: mode.name().to_owned(),
        mark: mark.to_owned(),
        color,
    }
}

/// What one picture shows of a sweep.
struct View<'a> {
    sweep: &'a Sweep,
    rows: &'a [Row],
    slice: &'a Slice,
}

/// Name of the axis of the rows, short where they are few.
fn row_title(axis: &Axis) -> String {
    const LOW: usize = 5;
    match axis.unit {
        _ if axis.values.len() >= LOW => axis.title(),
        Some(unit) => format!("{} [{}]", axis.symbol(), unit.name),
        None => axis.symbol().to_owned(),
    }
}

/// The load of a case, with its error.
type LoadOf<'a> = &'a dyn Fn(&Row) -> Option<(f64, Option<f64>)>;

type Picture = Option<Result<(Svg, String), FigureError>>;

impl View<'_> {
    /// " at μ = 0.2", or nothing.
    fn conditions(&self) -> String {
        let fixed: Vec<String> = (self.slice.iter())
            .map(|&(axis, value)| self.sweep.axes[axis].assignment(value))
            .collect();
        if fixed.is_empty() {
            String::new()
        } else {
            format!(" at {}", fixed.join(", "))
        }
    }

    /// The row with these values on the axes of the map.
    fn row(&self, x: Option<usize>, y: Option<usize>) -> Option<&Row> {
        let [x_axis, y_axis] = self.sweep.map;
        self.rows.iter().find(|row| {
            let values = self.sweep.values_of(row.case);
            let at = |axis: Option<usize>| axis.map(|axis| values[axis]);
            at(x_axis) == x
                && at(y_axis) == y
                && self
                    .slice
                    .iter()
                    .all(|&(axis, value)| values[axis] == value)
        })
    }

    fn axis(&self, which: usize) -> Option<&Axis> {
        self.sweep.map[which].map(|axis| &self.sweep.axes[axis])
    }

    /// Values of an axis of the map; one nameless value where there is no such axis.
    fn values(&self, which: usize) -> Vec<Option<usize>> {
        match self.axis(which) {
            Some(axis) => (0..axis.values.len()).map(Some).collect(),
            None => vec![None],
        }
    }

    fn label(&self, which: usize, value: Option<usize>) -> String {
        let axis = self.axis(which).zip(value);
        axis.map_or_else(String::new, |(axis, value)| axis.cell(value))
    }

    /// The map of failure modes; none where no mode is called.
    fn modes(&self) -> Picture {
        let criterion = self.sweep.criterion.as_deref()?;
        let x_axis = self.axis(0)?;
        let mut categories: Vec<Category> = ORDER.map(category).into();
        categories.push(Category {
            label: "no answer".to_owned(),
            mark: "–".to_owned(),
            color: Color::rgb(0xdd, 0xdd, 0xdd),
        });
        let unit = &self.sweep.load_unit;
        let cell = |x, y| match self.row(x, y) {
            Some(row) => match row.joint() {
                Some(joint) => Cell {
                    category: ORDER.iter().position(|mode| *mode == joint.mode),
                    text: joint.load.map_or_else(String::new, short),
                },
                None => Cell {
                    category: Some(ORDER.len()),
                    text: String::new(),
                },
            },
            None => Cell::default(),
        };
        let columns = self.values(0);
        let rows = self.values(1).into_iter().map(|y| {
            let cells = columns.iter().map(|&x| cell(x, y)).collect();
            (self.label(1, y), cells)
        });
        let map = CellMap {
            title: format!("Failure mode and load [{unit}] of the joint"),
            subtitle: format!(
                "{}{}; characteristic curve, criterion {criterion}",
                self.sweep.title,
                self.conditions()
            ),
            x_label: x_axis.title(),
            y_label: self.axis(1).map_or_else(String::new, row_title),
            columns: columns.iter().map(|&x| self.label(0, x)).collect(),
            rows: rows.collect(),
            categories,
            width: 720.0,
        };
        let caption = format!(
            "Failure mode by the place on the characteristic curve where a ply fails first (|φ| ≤ 15° bearing, 30° to 60° \
             shear-out, 75° to 90° net tension, mixed between them), and the load in {unit} at which it does{}.",
            self.conditions()
        );
        Some(map.render().map(|picture| (picture, caption)))
    }

    /// Failure loads over the x axis, one curve for each value of the y axis; none where x has no numbers or fewer than two.
    fn loads(&self) -> Picture {
        let x_axis = self.axis(0)?;
        let numbers = x_axis
            .numbers
            .as_ref()
            .filter(|numbers| numbers.len() > 1)?;
        let unit = &self.sweep.load_unit;
        let mut chart = LineChart::new(
            "Failure loads",
            FigureAxis::linear(x_axis.title()),
            FigureAxis::linear(format!("Load [{unit}]")),
        )
        .subtitle(format!(
            "{}{}; solid: joint, dashed: first ply",
            self.sweep.title,
            self.conditions()
        ));
        let curve = |y, load: LoadOf<'_>| {
            let points = numbers.iter().enumerate().filter_map(|(x, &number)| {
                let (load, error) = load(self.row(Some(x), y)?)?;
                let error = error.unwrap_or(0.0);
                Some(([number, load], [load - error, load + error]))
            });
            points.unzip::<_, _, Vec<[f64; 2]>, Vec<[f64; 2]>>()
        };
        let mut first_plies = false;
        for (index, y) in self.values(1).into_iter().enumerate() {
            let (joint, joint_margin) = curve(y, &|row| {
                let joint = row.joint()?;
                Some((joint.load?, joint.load_error))
            });
            let (first, first_margin) = curve(y, &|row| {
                let first = row.measures()?.first_ply.as_ref()?;
                Some((first.load?, first.load_error))
            });
            let name = self
                .axis(1)
                .zip(y)
                .map(|(axis, value)| axis.assignment(value));
            let name = name.unwrap_or_else(|| "joint".to_owned());
            let color = Color::category(index);
            let only_first = joint.is_empty();
            if !only_first {
                let series = Series::new(name.clone(), joint).style(SeriesStyle::Both);
                chart = chart.with(series.margin(joint_margin).color(color));
            }
            if !first.is_empty() {
                first_plies = true;
                let label = if only_first { name } else { String::new() };
                let series = Series::new(label, first).dash(Dash::Dashed).width(1.2);
                let series = series.margin(first_margin);
                chart = chart.with(series.color(color));
            }
        }
        if chart.series.is_empty() {
            return None;
        }
        if !first_plies {
            chart.subtitle = Some(format!("{}{}", self.sweep.title, self.conditions()));
        }
        let bands = if self.sweep.states_errors() {
            " Bands around curves are estimated errors."
        } else {
            ""
        };
        let caption = format!(
            "Load at which the joint fails on its characteristic curve (solid) and at which its first ply fails anywhere (dashed), over \
             {}{}.{bands}",
            x_axis.symbol(),
            self.conditions()
        );
        Some(chart.render().map(|picture| (picture, caption)))
    }
}
