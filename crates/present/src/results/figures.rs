//! Figures of a run, each with a caption that says what one sees in numbers.

pub(super) mod edge;
mod families;
pub(super) mod fields;
mod history;
mod map;

use stickslip_contact::Status;
use stickslip_report::chart::Band;
use stickslip_report::color::Color;
use stickslip_report::svg::Svg;

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
    pub(super) caption: String,
    pub(super) group: Group,
}

/// Which part of the page a figure belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Group {
    /// A joint followed to its end.
    Joint,
    Edge,
    History,
    Failure,
    Field,
}

/// All figures that apply, and a line for each that could not be drawn: a picture is not worth losing a result.
pub(super) fn draw(results: &Results) -> (Vec<Drawing>, Vec<String>) {
    let mut gallery = Gallery::default();
    for view in EdgeView::all(results) {
        add_edge(&mut gallery, &view);
    }
    for view in FailureView::all(results) {
        add_failure(&mut gallery, &view);
    }
    for (stem, attempt) in fields::all(results) {
        gallery.add(Group::Field, &stem, attempt);
    }
    (gallery.drawings, gallery.failures)
}

/// Figures of an edge.
fn add_edge(gallery: &mut Gallery, view: &EdgeView<'_>) {
    let (name, contact) = (view.geometry.name.as_str(), view.geometry.contact);
    gallery.add_of(name, Group::Edge, [("stresses", edge::chart(view))]);
    if contact {
        let tractions = [
            ("pressure", families::pressure(view)),
            ("shear", families::shear(view)),
        ];
        gallery.add_of(name, Group::Edge, tractions);
    }
    gallery.add_of(name, Group::Edge, [("hoop", families::hoop(view))]);
    if contact {
        let history = [
            ("map", map::chart(view)),
            ("extent", history::extent_and_peak(view)),
            ("friction", history::friction(view)),
        ];
        gallery.add_of(name, Group::History, history);
    }
}

/// Figures of a laminated body.
fn add_failure(gallery: &mut Gallery, view: &FailureView<'_>) {
    use failure::figures::{characteristic, envelopes, index_along, stresses_along};
    for edge in &view.failure.edges {
        let figures = [
            ("ply-index", index_along(view, edge)),
            ("ply-stresses", stresses_along(view, edge)),
        ];
        let name = &view.results.edges[edge.edge].name;
        gallery.add_of(name, Group::Failure, figures);
    }
    let figures = [
        ("characteristic", characteristic(view)),
        ("envelope-normal", envelopes(view, EnvelopePlane::Normal)),
        ("envelope-shear", envelopes(view, EnvelopePlane::Shear)),
    ];
    gallery.add_of(view.body(), Group::Failure, figures);
    if let Some(joint) = ProgressiveView::of(*view) {
        let figures = [
            ("load-displacement", progressive::figures::curve(&joint)),
            ("edge-strains", progressive::figures::edge_strains(&joint)),
            ("damage", progressive::damage_map(&joint)),
        ];
        gallery.add_of(view.body(), Group::Joint, figures);
    }
    for map in &view.failure.maps {
        let name = format!("{}-step-{:02}", view.body(), map.step + 1);
        let figure = ("ply-map", failure::index_map(view, map));
        gallery.add_of(&name, Group::Failure, [figure]);
    }
}

#[derive(Debug, Default)]
struct Gallery {
    names: FileNames,
    drawings: Vec<Drawing>,
    failures: Vec<String>,
}

impl Gallery {
    /// Adds figures of what is called `name`, each with what it shows.
    fn add_of(
        &mut self,
        name: &str,
        group: Group,
        figures: impl IntoIterator<Item = (&'static str, Attempt)>,
    ) {
        for (what, attempt) in figures {
            self.add(group, &format!("{what}-{name}"), attempt);
        }
    }

    fn add(&mut self, group: Group, stem: &str, attempt: Attempt) {
        match attempt {
            Ok(Some((picture, caption))) => {
                let name = self.names.unique(stem);
                self.drawings.push(Drawing {
                    name,
                    picture,
                    caption,
                    group,
                });
            }
            Ok(None) => {}
            Err(cause) => self
                .failures
                .push(format!("The figure '{stem}' could not be drawn: {cause}.")),
        }
    }
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

/// What a half model shows, for captions.
fn half_remark(view: &EdgeView<'_>) -> Option<String> {
    let remark = "One half is modelled; the other is its mirror image.";
    view.geometry.half.then(|| remark.to_owned())
}
