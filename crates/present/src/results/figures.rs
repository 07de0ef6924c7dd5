//! Figures of a run, each with a caption that says what one sees in numbers.

mod deformed;
pub(super) mod edge;
mod families;
pub(super) mod fields;
mod history;
mod map;
pub(super) mod sides;
pub(super) mod sketch;

use stickslip_contact::Status;
use stickslip_fem_core::parallel;
use stickslip_report::FigureError;
use stickslip_report::chart::Band;
use stickslip_report::color::Color;
use stickslip_report::raster::{DEFAULT_SCALE, to_png};
use stickslip_report::svg::Svg;

use super::OutputError;
use super::attempt::Attempt;
use super::display::EdgeView;
use super::failure::{self, FailureView};
use super::names::FileNames;
use super::progressive::{self, ProgressiveView};
use super::zones::shown_ranges;
use stickslip_engine::results::Results;
use stickslip_scene::schema::EnvelopePlane;

/// A finished figure.
#[derive(Debug)]
pub(super) struct Drawing {
    /// File name without ending, and anchor on the page.
    pub(super) name: String,
    pub(super) picture: Svg,
    pub(super) png: Vec<u8>,
    pub(super) caption: String,
    pub(super) group: Group,
}

/// Which part of the page a figure belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Group {
    /// The scene itself.
    Problem,
    /// A joint followed to its end.
    Joint,
    Edge,
    History,
    Failure,
    Field,
}

/// A figure that can be drawn beside others.
struct Plan<'a> {
    group: Group,
    /// File name before it is made safe and different from others.
    stem: String,
    draw: Box<dyn Fn() -> Attempt + Sync + 'a>,
}

impl<'a> Plan<'a> {
    fn new(group: Group, stem: String, draw: impl Fn() -> Attempt + Sync + 'a) -> Self {
        Self {
            group,
            stem,
            draw: Box::new(draw),
        }
    }
}

/// All figures that apply, and a line for each that could not be drawn: a picture is not worth losing a result.
///
/// # Errors
/// [`OutputError::Picture`] for a figure that cannot be written as PNG.
pub(super) fn draw(results: &Results) -> Result<(Vec<Drawing>, Vec<String>), OutputError> {
    let edges = EdgeView::all(results);
    let failing = FailureView::all(results);
    let mut plans: Vec<Plan<'_>> = sketch::all(results);
    plans.extend(edges.iter().flat_map(of_edge));
    plans.extend(failing.iter().flat_map(of_failure));
    plans.extend(deformed::all(results));
    plans.extend(fields::all(results));
    let drawn = parallel::map(&plans, |plan| {
        let made = (plan.draw)()?;
        Ok::<_, FigureError>(made.map(|(picture, caption)| {
            let png = to_png(&picture, DEFAULT_SCALE);
            (picture, caption, png)
        }))
    });

    let mut names = FileNames::default();
    let (mut drawings, mut failures) = (Vec::new(), Vec::new());
    for (Plan { group, stem, .. }, drawn) in plans.into_iter().zip(drawn) {
        match drawn {
            Ok(Some((picture, caption, png))) => {
                let name = names.unique(&stem);
                let failed = |cause| OutputError::Picture {
                    name: name.clone(),
                    cause,
                };
                drawings.push(Drawing {
                    png: png.map_err(failed)?,
                    name,
                    picture,
                    caption,
                    group,
                });
            }
            Ok(None) => {}
            Err(cause) => {
                failures.push(format!("The figure '{stem}' could not be drawn: {cause}."));
            }
        }
    }
    Ok((drawings, failures))
}

/// Figures of an edge.
fn of_edge<'a>(view: &'a EdgeView<'_>) -> Vec<Plan<'a>> {
    let plan = |group, what: &str, draw: fn(&EdgeView<'_>) -> Attempt| {
        let stem = format!("{what}-{}", view.geometry.name);
        Plan::new(group, stem, move || draw(view))
    };
    let mut plans = vec![plan(Group::Edge, "stresses", edge::chart)];
    if view.geometry.contact {
        plans.push(plan(Group::Edge, "pressure", families::pressure));
        plans.push(plan(Group::Edge, "shear", families::shear));
    }
    plans.push(plan(Group::Edge, "hoop", families::hoop));
    if view.geometry.second.is_some() {
        plans.push(plan(Group::Edge, "sides", sides::chart));
    }
    if view.geometry.contact {
        plans.push(plan(Group::History, "map", map::chart));
        plans.push(plan(Group::History, "extent", history::extent_and_peak));
        plans.push(plan(Group::History, "friction", history::friction));
    }
    plans
}

/// Figures of a laminated body.
fn of_failure<'a>(view: &'a FailureView<'a>) -> Vec<Plan<'a>> {
    use failure::figures::{characteristic, envelopes, index_along, stresses_along};
    let mut plans = Vec::new();
    for edge in &view.failure.edges {
        let stem = |what: &str| format!("{what}-{}", view.results.edges[edge.edge].name);
        plans.extend([
            Plan::new(Group::Failure, stem("ply-index"), || {
                index_along(view, edge)
            }),
            Plan::new(Group::Failure, stem("ply-stresses"), || {
                stresses_along(view, edge)
            }),
        ]);
    }
    let stem = |what: &str| format!("{what}-{}", view.body());
    let envelope = |plane| move || envelopes(view, plane);
    plans.extend([
        Plan::new(Group::Failure, stem("characteristic"), || {
            characteristic(view)
        }),
        Plan::new(
            Group::Failure,
            stem("envelope-normal"),
            envelope(EnvelopePlane::Normal),
        ),
        Plan::new(
            Group::Failure,
            stem("envelope-shear"),
            envelope(EnvelopePlane::Shear),
        ),
    ]);
    if let Some(joint) = ProgressiveView::of(*view) {
        let plan = |what: &str, draw: fn(&ProgressiveView<'_>) -> Attempt| {
            Plan::new(Group::Joint, stem(what), move || draw(&joint))
        };
        plans.extend([
            plan("load-displacement", progressive::figures::curve),
            plan("edge-strains", progressive::figures::edge_strains),
            plan("damage", progressive::damage_map),
        ]);
    }
    let maps = view.failure.maps.iter().map(|map| {
        let stem = format!("ply-map-{}-step-{:02}", view.body(), map.step + 1);
        Plan::new(Group::Failure, stem, || failure::index_map(view, map))
    });
    plans.extend(maps);
    plans
}

/// The largest of `values` by `size`; of those that are equal but for rounding the last.
fn last_largest<T: Copy>(values: impl Iterator<Item = T>, size: impl Fn(T) -> f64) -> Option<T> {
    const ROUNDING: f64 = 1e-7;
    let values: Vec<T> = values.collect();
    let most = values.iter().map(|&value| size(value)).reduce(f64::max)?;
    let high = |value: &&T| size(**value) >= most * (1.0 - ROUNDING);
    values.iter().rev().find(high).copied()
}

/// Colour of a zone in every figure.
fn zone_color(status: Status) -> Color {
    match status {
        Status::Open => Color::rgb(0x9a, 0x9a, 0x9a),
        Status::Stick => Color::rgb(0x1f, 0x6f, 0xb4),
        Status::SlipPositive => Color::rgb(0xe0, 0x7b, 0x1a),
        Status::SlipNegative => Color::rgb(0x2a, 0x93, 0x5c),
    }
}

/// Name of a zone for a reader.
fn zone_name(view: &EdgeView<'_>, status: Status) -> &'static str {
    let [positive, negative] = view.slip_names();
    match status {
        Status::Open => "open",
        Status::Stick => "stick",
        Status::SlipPositive => positive,
        Status::SlipNegative => negative,
    }
}

/// Zones of a step as bands over the place axis.
fn zone_bands(view: &EdgeView<'_>, step: usize) -> Vec<Band> {
    let ranges = shown_ranges(view, step).into_iter();
    ranges
        .map(|(status, [start, end])| {
            Band::new(zone_name(view, status), start, end, zone_color(status))
        })
        .collect()
}

/// What bands around curves are, for captions.
fn margin_remark(view: &EdgeView<'_>) -> Option<String> {
    let mut steps = view.results().steps.iter();
    let known = steps.any(|step| step.edges.iter().any(|edge| !edge.row_errors.is_empty()));
    known.then(|| "Bands around curves are estimated errors.".to_owned())
}

/// What a half model shows, for captions.
fn half_remark(view: &EdgeView<'_>) -> Option<String> {
    let remark = "One half is modelled; the other is its mirror image.";
    view.geometry.half.then(|| remark.to_owned())
}
