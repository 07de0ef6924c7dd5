//! Figures of a run, each with a caption that says what one sees in numbers.

mod deformed;
pub(super) mod edge;
mod families;
pub(super) mod fields;
mod history;
mod map;
mod plan;
mod shown;
pub(super) mod sides;
pub(super) mod sketch;

use stickslip_fem_core::parallel;
use stickslip_report::FigureError;
use stickslip_report::raster::{DEFAULT_SCALE, to_png};

use plan::Plan;
pub(super) use plan::{Drawing, Group};
use shown::{half_remark, last_largest, margin_remark, zone_bands, zone_color, zone_name};

use super::OutputError;
use super::attempt::Attempt;
use super::display::EdgeView;
use super::failure::{self, FailureView};
use super::names::FileNames;
use super::progressive::{self, ProgressiveView};
use stickslip_results::Results;
use stickslip_scene::schema::EnvelopePlane;

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
