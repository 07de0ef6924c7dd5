//! Pictures of measured fields: data with mask, orders, phase with its inconsistent loops.

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::Field;
use stickslip_report::FigureError;
use stickslip_report::axis::extent;
use stickslip_report::chart::tile;
use stickslip_report::color::{Color, Colormap};
use stickslip_report::plane::{Marks, PlanePlot};
use stickslip_report::svg::Svg;

use crate::gallery::{caption, edge_of_hole, edges, picture_plot};
use stickslip_experiment::Experiment;
use stickslip_measure::measured::{Measured, PictureField};

/// Width of one map \[px\].
const WIDTH: f64 = 430.0;
/// Most marks of one kind; more would hide the map.
const MOST_MARKS: usize = 400;

/// Orders of both fields over the plane, from the state's pictures.
pub(super) fn orders(
    experiment: &Experiment,
    measured: &Measured,
) -> Option<Result<Svg, FigureError>> {
    if measured
        .pictures
        .iter()
        .flatten()
        .any(|field| field.of_null)
    {
        return None;
    }
    both(experiment, measured, |field, found| {
        let unit = experiment.display.length;
        let title = format!("{} field", field.name());
        let label = format!("N{} [fringes]", ["x", "y"][field.component()]);
        let mut plot =
            picture_plot(&title, &found.orders, unit).colors(Colormap::Viridis, Some(label));
        plot.subtitle = Some("masked: grey".to_owned());
        plot.marks = vec![hole(experiment)];
        plot.window = edges(&found.orders, unit);
        plot.width = WIDTH;
        plot.render()
    })
}

/// Phase of both fields with the places that unwrapping cannot be trusted at.
pub(super) fn phase(
    experiment: &Experiment,
    measured: &Measured,
) -> Option<Result<Svg, FigureError>> {
    both(experiment, measured, |field, found| {
        let unit = experiment.display.length;
        let title = format!("{} field", field.name());
        let mut plot = picture_plot(&title, &found.wrapped, unit)
            .colors(Colormap::Cyclic, Some("phase [fringes]".to_owned()));
        plot.range = Some([-0.5, 0.5]);
        plot.width = WIDTH;
        let shown = |places: &[Point]| -> Vec<[f64; 2]> {
            let stride = places.len().div_ceil(MOST_MARKS).max(1);
            let some = places.iter().step_by(stride);
            some.map(|place| place.map(|x| unit.from_base(x))).collect()
        };
        for (label, color, places) in [
            (
                "loops that do not close",
                Color::rgb(0, 0, 0),
                &found.residues,
            ),
            (
                "jumps of half a fringe or more",
                Color::rgb(255, 255, 255),
                &found.cuts,
            ),
        ] {
            if !places.is_empty() {
                plot.marks.push(Marks {
                    points: shown(places),
                    ..Marks::new(format!("{label}: {}", places.len()), color)
                });
            }
        }
        plot.render()
    })
}

fn both(
    experiment: &Experiment,
    measured: &Measured,
    draw: impl Fn(Field, &PictureField) -> Result<Svg, FigureError>,
) -> Option<Result<Svg, FigureError>> {
    let fields = Field::BOTH.into_iter().zip(&measured.pictures);
    let drawn: Vec<_> = fields
        .filter_map(|(field, found)| found.as_ref().map(|found| draw(field, found)))
        .collect();
    if drawn.is_empty() {
        return None;
    }
    let all: Result<Vec<Svg>, FigureError> = drawn.into_iter().collect();
    Some(all.and_then(|all| tile(&caption(experiment, measured.state), 2, &all)))
}

/// Displacements at scattered places, masked ones grey.
pub(super) fn data(experiment: &Experiment, measured: &Measured) -> Result<Svg, FigureError> {
    let own = Field::BOTH
        .into_iter()
        .filter(|field| measured.measurement.count(*field) > 0);
    let drawn: Result<Vec<Svg>, FigureError> = own
        .map(|field| scattered(experiment, measured, field))
        .collect();
    tile(&caption(experiment, measured.state), 2, &drawn?)
}

fn scattered(
    experiment: &Experiment,
    measured: &Measured,
    field: Field,
) -> Result<Svg, FigureError> {
    let measurement = &measured.measurement;
    let unit = experiment.display.length;
    let c = field.component();
    let dots: Vec<([f64; 2], f64)> = (0..measurement.places.len())
        .map(|k| {
            let value = if measurement.valid[c][k] {
                unit.from_base(measurement.displacements[c][k])
            } else {
                f64::NAN
            };
            (measurement.places[k].map(|x| unit.from_base(x)), value)
        })
        .collect();
    let letter = ["u", "v"][c];
    let title = format!(
        "{}: {} of {} places valid",
        field.name(),
        measurement.count(field),
        dots.len()
    );
    let mut plot = PlanePlot::new(title, unit.name, window(&dots))
        .colors(Colormap::Viridis, Some(format!("{letter} [{}]", unit.name)));
    plot.dots = &dots;
    plot.subtitle = Some("masked: grey".to_owned());
    plot.marks = vec![hole(experiment)];
    let bad = &measured.outliers;
    if !bad.is_empty() {
        let label = format!("outliers, masked: {}", bad.len());
        plot.marks.push(Marks {
            points: bad.iter().map(|&k| dots[k].0).collect(),
            ..Marks::new(label, Color::rgb(0xd6, 0x27, 0x28))
        });
    }
    plot.width = WIDTH;
    plot.render()
}

/// The window around places, with a little room.
fn window(dots: &[([f64; 2], f64)]) -> [f64; 4] {
    let [left, right, bottom, top] = extent(dots.iter().map(|(place, _)| *place));
    let room = 0.03 * (right - left).max(top - bottom).max(f64::MIN_POSITIVE);
    [left - room, right + room, bottom - room, top + room]
}

/// The edge of the hole.
fn hole(experiment: &Experiment) -> Marks {
    const PIECES: usize = 180;
    let angle = |k: usize| std::f64::consts::TAU * k as f64 / PIECES as f64;
    edge_of_hole(experiment, (0..=PIECES).map(angle))
}
