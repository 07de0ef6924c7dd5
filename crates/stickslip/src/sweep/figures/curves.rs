//! Curves of the contact of joints without failure criteria: pressure, hoop concentration, extent of contact, stick and load share over every axis with numbers, one
//! curve for each combination of the others.

use stickslip_report::FigureError;
use stickslip_report::axis::Axis as FigureAxis;
use stickslip_report::chart::{LineChart, Series, SeriesStyle};
use stickslip_report::color::Color;
use stickslip_report::svg::Svg;

use super::not_shown::NotShown;
use crate::sweep::Sweep;
use crate::sweep::row::{Measures, Row};

/// Most curves of a chart.
const MOST_CURVES: usize = 8;

/// A number of a case with its error, 0 where none is stated.
type Value = fn(&Measures) -> Option<[f64; 2]>;

/// A name of files, with the picture and its caption.
type Named = (String, (Svg, String));

/// What is drawn.
struct Quantity {
    /// Start of the names of its files.
    stem: &'static str,
    title: &'static str,
    /// Label of its axis before the unit.
    label: &'static str,
    kind: Kind,
    value: Value,
}

/// What a number is measured in.
#[derive(Clone, Copy)]
enum Kind {
    Stress,
    Degrees,
    Ratio,
}

const QUANTITIES: [Quantity; 5] = [
    Quantity {
        stem: "pressure",
        title: "Largest pressure",
        label: "Largest pressure",
        kind: Kind::Stress,
        value: |own| Some([own.peak_pressure?, own.errors.peak_pressure.unwrap_or(0.0)]),
    },
    Quantity {
        stem: "hoop",
        title: "Concentration of the hoop stress",
        label: "Largest hoop stress over bearing stress",
        kind: Kind::Ratio,
        value: |own| {
            let errors = [own.errors.peak_hoop, own.errors.bearing_stress];
            ratio(own.peak_hoop?[0], own.bearing_stress?, errors)
        },
    },
    Quantity {
        stem: "extent",
        title: "Extent of contact",
        label: "Half of the contact angle",
        kind: Kind::Degrees,
        value: |own| {
            let error = own.errors.contact_half_angle.unwrap_or(0.0);
            Some([own.contact_half_angle?, error])
        },
    },
    Quantity {
        stem: "stick",
        title: "Stick",
        label: "Stick zone over contact",
        kind: Kind::Ratio,
        value: |own| {
            let errors = [own.errors.stick_half_angle, own.errors.contact_half_angle];
            ratio(own.stick_half_angle?, own.contact_half_angle?, errors)
        },
    },
    Quantity {
        stem: "share",
        title: "Share of the load",
        label: "Share of the contact in the load",
        kind: Kind::Ratio,
        value: |own| Some([own.load_share?, own.errors.load_share.unwrap_or(0.0)]),
    },
];

/// `part` over `whole` with its error; `None` without a whole.
fn ratio(part: f64, whole: f64, errors: [Option<f64>; 2]) -> Option<[f64; 2]> {
    let [part_error, whole_error] = errors.map(|error| error.unwrap_or(0.0));
    let ratio = part / whole;
    let error = (part_error + ratio.abs() * whole_error) / whole;
    (whole > 0.0).then_some([ratio, error])
}

/// All charts of a sweep without failure criteria, and what they do not show.
pub(super) fn draw(sweep: &Sweep, rows: &[Row]) -> (Vec<Named>, Vec<NotShown>) {
    let (mut drawings, mut remarks) = (Vec::new(), Vec::new());
    if sweep.scene.failure.is_some() {
        return (drawings, remarks);
    }
    for (index, axis) in sweep.axes.iter().enumerate() {
        let Some(numbers) = axis.numbers.as_ref().filter(|own| own.len() > 1) else {
            continue;
        };
        let lines = lines(sweep, index);
        if lines.len() > MOST_CURVES {
            remarks.push(NotShown::Curves {
                axis: axis.symbol().to_owned(),
                shown: MOST_CURVES,
                all: lines.len(),
            });
        }
        let view = View {
            sweep,
            rows,
            axis: index,
            numbers,
        };
        for quantity in &QUANTITIES {
            match view.chart(quantity, &lines) {
                Some(Ok(drawn)) => {
                    let name = format!("{}-over-axis-{}", quantity.stem, index + 1);
                    drawings.push((name, drawn));
                }
                Some(Err(cause)) => {
                    let picture = format!("{} over {}", quantity.title, axis.symbol());
                    remarks.push(NotShown::Failed { picture, cause });
                }
                None => {}
            }
        }
    }
    (drawings, remarks)
}

/// The values of all axes, that of `axis` being the first, for every combination of the others.
fn lines(sweep: &Sweep, axis: usize) -> Vec<Vec<usize>> {
    let all = (0..sweep.cases()).map(|case| sweep.values_of(case));
    all.filter(|values| values[axis] == 0).collect()
}

/// One axis of a sweep.
struct View<'a> {
    sweep: &'a Sweep,
    rows: &'a [Row],
    axis: usize,
    numbers: &'a [f64],
}

impl View<'_> {
    /// The chart of `quantity`; none where no case has it.
    fn chart(
        &self,
        quantity: &Quantity,
        lines: &[Vec<usize>],
    ) -> Option<Result<(Svg, String), FigureError>> {
        let axis = &self.sweep.axes[self.axis];
        let unit = match quantity.kind {
            Kind::Stress => self.sweep.scene.display.stress.name,
            Kind::Degrees => "deg",
            Kind::Ratio => "–",
        };
        let mut chart = LineChart::new(
            quantity.title,
            FigureAxis::linear(axis.title()),
            FigureAxis::linear(format!("{} [{unit}]", quantity.label)),
        )
        .subtitle(format!("{}; at the largest load", self.sweep.title));
        for (color, line) in lines.iter().take(MOST_CURVES).enumerate() {
            let mut points = self.points(quantity, line);
            if points.is_empty() {
                continue;
            }
            points.sort_by(|one, other| one.0[0].total_cmp(&other.0[0]));
            let (points, margin) = points.into_iter().unzip::<_, _, Vec<_>, Vec<_>>();
            let series = Series::new(self.name(line), points).style(SeriesStyle::Both);
            chart = chart.with(series.margin(margin).color(Color::category(color)));
        }
        if chart.series.is_empty() {
            return None;
        }
        let caption = format!(
            "{} at the largest load over {}{}.{}",
            quantity.label,
            axis.symbol(),
            self.others(),
            if self.sweep.states_errors() {
                " Bands around curves are estimated errors."
            } else {
                ""
            }
        );
        Some(chart.render().map(|picture| (picture, caption)))
    }

    /// ", one curve for each μ", or nothing.
    fn others(&self) -> String {
        let axes = self.sweep.axes.iter().enumerate();
        let others = axes.filter(|(index, own)| *index != self.axis && own.values.len() > 1);
        let names: Vec<&str> = others.map(|(_, own)| own.symbol()).collect();
        if names.is_empty() {
            return String::new();
        }
        format!(", one curve for each {}", names.join(", "))
    }

    /// Points and margins of the curve of the cases with the values `line` on the other axes.
    fn points(&self, quantity: &Quantity, line: &[usize]) -> Vec<([f64; 2], [f64; 2])> {
        let on_line = |row: &&Row| {
            let values = self.sweep.values_of(row.case);
            let mut both = values.iter().zip(line).enumerate();
            both.all(|(axis, (own, wanted))| axis == self.axis || own == wanted)
        };
        let point = |row: &Row| {
            let [value, error] = (quantity.value)(row.measures()?)?;
            let at = self.numbers[self.sweep.values_of(row.case)[self.axis]];
            Some(([at, value], [value - error, value + error]))
        };
        self.rows.iter().filter(on_line).filter_map(point).collect()
    }

    /// The values of the other axes.
    fn name(&self, line: &[usize]) -> String {
        let axes = self.sweep.axes.iter().zip(line).enumerate();
        let others = axes.filter(|(index, (axis, _))| *index != self.axis && axis.values.len() > 1);
        let names = others.map(|(_, (axis, value))| axis.assignment(*value));
        names.collect::<Vec<_>>().join(", ")
    }
}
