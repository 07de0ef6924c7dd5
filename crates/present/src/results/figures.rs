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
    let mut add = |group, what: &str, attempt| {
        gallery.add(group, &format!("{what}-{}", view.geometry.name), attempt);
    };
    add(Group::Edge, "stresses", edge::chart(view));
    if view.geometry.contact {
        add(Group::Edge, "pressure", families::pressure(view));
        add(Group::Edge, "shear", families::shear(view));
    }
    add(Group::Edge, "hoop", families::hoop(view));
    if view.geometry.contact {
        add(Group::History, "map", map::chart(view));
        add(Group::History, "extent", history::extent_and_peak(view));
        add(Group::History, "friction", history::friction(view));
    }
}

/// Figures of a laminated body.
fn add_failure(gallery: &mut Gallery, view: &FailureView<'_>) {
    use failure::figures;
    let mut add = |group, what: &str, name: &str, attempt| {
        gallery.add(group, &format!("{what}-{name}"), attempt);
    };
    for edge in &view.failure.edges {
        let name = &view.results.edges[edge.edge].name;
        add(
            Group::Failure,
            "ply-index",
            name,
            figures::index_along(view, edge),
        );
        add(
            Group::Failure,
            "ply-stresses",
            name,
            figures::stresses_along(view, edge),
        );
    }
    let body = view.body();
    add(
        Group::Failure,
        "characteristic",
        body,
        figures::characteristic(view),
    );
    for (plane, what) in [
        (EnvelopePlane::Normal, "envelope-normal"),
        (EnvelopePlane::Shear, "envelope-shear"),
    ] {
        add(Group::Failure, what, body, figures::envelopes(view, plane));
    }
    if let Some(joint) = ProgressiveView::of(*view) {
        use progressive::figures;
        add(
            Group::Joint,
            "load-displacement",
            body,
            figures::curve(&joint),
        );
        add(
            Group::Joint,
            "edge-strains",
            body,
            figures::edge_strains(&joint),
        );
        add(
            Group::Joint,
            "damage",
            body,
            progressive::damage_map(&joint),
        );
    }
    for map in &view.failure.maps {
        let name = format!("{body}-step-{:02}", map.step + 1);
        add(
            Group::Failure,
            "ply-map",
            &name,
            failure::index_map(view, map),
        );
    }
}

#[derive(Debug, Default)]
struct Gallery {
    names: FileNames,
    drawings: Vec<Drawing>,
    failures: Vec<String>,
}

impl Gallery {
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
