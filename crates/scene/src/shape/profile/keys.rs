//! The keys of an outline.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use stickslip_fem_core::generate::{Extent, uniform_angles};
use stickslip_fem_core::mesh::Point;
use stickslip_mesher::{Contour, Course, Cutout, Hole, Piece, Spline};

use super::Profile;
use crate::declaration::{
    Key, NONE, POSITIVE, REQUIRED, Range, Table, angle, described, length, number, numbers, table,
    tables_of, text,
};
use crate::document::child;
use crate::shape::outline::Sizes;
use crate::shape::pattern::{self, PatternFormat};
use crate::units::{Angle, Length, Quantity};

/// Around a corner cells may be a millionth of those inside and still be few.
const REFINED: Range = numbers(" 1 to 1e6", "1 to 1e6", |value| {
    (1.0..=1e6).contains(&value)
});

pub(crate) const MEANING: &str = "lines, arcs and splines around a body, with cut-outs and circular holes anywhere in it; edges, holes and points as they are named; areas `section`";

const EDGE: [Key; 7] = [
    text(
        "name",
        REQUIRED,
        r#""end""#,
        "name of the edge; neighbours with one name are one edge",
    ),
    described(
        "to",
        "two lengths",
        "`start`, of the last edge",
        r#"["40 mm", "20 mm"]"#,
        "where it ends",
    ),
    described(
        "through",
        "two lengths",
        "a straight edge",
        r#"["60 mm", "0 mm"]"#,
        "a point between its ends, which makes it an arc",
    ),
    described(
        "spline",
        "list of pairs of lengths",
        "a straight edge",
        r#"[["52 mm", "-6 mm"], ["55 mm", "4 mm"], ["50 mm", "14 mm"]]"#,
        "points between its ends in walk order, through which it is a smooth curve",
    ),
    angle(
        "leaves",
        "as its points ask for",
        r#""0 deg""#,
        "direction from +x in which a spline leaves its beginning",
    ),
    angle(
        "arrives",
        "as its points ask for",
        r#""90 deg""#,
        "direction from +x in which a spline arrives at its end",
    ),
    number(
        "refine",
        "`1`",
        "8.0",
        "by how many times cells along it are smaller than the largest of the body",
    )
    .range(REFINED),
];

#[rustfmt::skip]
pub(crate) const ROWS: &[Key] = &[
    described("start", "two lengths", REQUIRED, r#"["-60 mm", "-20 mm"]"#, "where the first edge begins"),
    described("edges", "list of tables", REQUIRED, r#"[{ name = "bottom", to = ["40 mm", "-20 mm"] }, { name = "end", to = ["40 mm", "20 mm"], through = ["60 mm", "0 mm"] }, { name = "top", to = ["-60 mm", "20 mm"] }, { name = "left" }]"#,
        "the [edges](#bodiesnameshapeoutlineedges), counter-clockwise, each from the end of the one before"),
    tables_of("cutouts", NONE, "slots and windows by name"),
    tables_of("holes", NONE, "circular holes by name"),
    described("points", "table of two lengths", NONE, r#"{ corner = ["40 mm", "20 mm"] }"#, "names of places where edges end, which forces, supports and springs act on"),
];

const COURSES: &[&[&str]] = &[&["through"], &["spline", "leaves", "arrives"]];
const COURSE_CHOICES: &str = r#"through = ["60 mm", "0 mm"], spline = [["52 mm", "-6 mm"], …]"#;

/// The tables inside.
#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("bodies.NAME.shape.outline.edges", &EDGE).at_most_one_of(COURSES, COURSE_CHOICES),
    Table::new("bodies.NAME.shape.outline.cutouts.NAME", &[
        described("start", "two lengths", REQUIRED, r#"["-50 mm", "-4 mm"]"#, "where its first edge begins"),
        described("edges", "list of tables", REQUIRED, r#"[{ name = "slot-below", to = ["-30 mm", "-4 mm"] }, { name = "slot-right", to = ["-30 mm", "4 mm"], through = ["-26 mm", "0 mm"] }, { name = "slot-above", to = ["-50 mm", "4 mm"] }, { name = "slot-left", through = ["-54 mm", "0 mm"] }]"#,
            "the [edges](#bodiesnameshapeoutlinecutoutsnameedges), counter-clockwise as those around the body"),
        table("pattern", NONE, pattern::MEANING),
    ]),
    Table::new("bodies.NAME.shape.outline.cutouts.NAME.edges", &EDGE).at_most_one_of(COURSES, COURSE_CHOICES),
    Table::new("bodies.NAME.shape.outline.holes.NAME", &[
        described("centre", "two lengths", REQUIRED, r#"["40 mm", "0 mm"]"#, "its centre"),
        length("radius", REQUIRED, r#""5 mm""#, "its radius").range(POSITIVE),
        table("pattern", NONE, pattern::MEANING),
    ]),
];

/// A place as a scene writes it.
type Place = [Quantity<Length>; 2];

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Keys {
    start: Place,
    edges: Vec<EdgeKeys>,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    cutouts: BTreeMap<String, CutoutKeys>,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    holes: BTreeMap<String, HoleKeys>,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    points: BTreeMap<String, Place>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct CutoutKeys {
    start: Place,
    edges: Vec<EdgeKeys>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pattern: Option<PatternFormat>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct EdgeKeys {
    name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    to: Option<Place>,
    #[serde(skip_serializing_if = "Option::is_none")]
    through: Option<Place>,
    #[serde(skip_serializing_if = "Option::is_none")]
    spline: Option<Vec<Place>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    leaves: Option<Quantity<Angle>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    arrives: Option<Quantity<Angle>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    refine: Option<f64>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct HoleKeys {
    centre: Place,
    radius: Quantity<Length>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pattern: Option<PatternFormat>,
}

#[cfg(test)]
pub(crate) const EXAMPLE: &str = r#"outline = { start = ["-30 mm", "-10 mm"], edges = [{ name = "bottom", to = ["8 mm", "-10 mm"] }, { name = "end", to = ["8 mm", "10 mm"], through = ["18 mm", "0 mm"] }, { name = "top", to = ["-30 mm", "10 mm"] }, { name = "left" }], cutouts.slot = { start = ["-24 mm", "-3 mm"], edges = [{ name = "slot-below", to = ["-10 mm", "-3 mm"] }, { name = "slot-end", to = ["-10 mm", "3 mm"], through = ["-7 mm", "0 mm"] }, { name = "slot-above", to = ["-24 mm", "3 mm"] }, { name = "slot-start" }] }, holes.bolt = { centre = ["7 mm", "1 mm"], radius = "5 mm" } }"#;

impl Keys {
    pub(crate) fn read(&self, table: &str, sizes: &mut dyn Sizes) -> Profile {
        let Self {
            start,
            edges,
            cutouts,
            holes,
            points,
        } = self;
        let hole = |(name, hole): (&String, &HoleKeys)| Hole {
            name: name.clone(),
            centre: place(&hole.centre),
            radius: hole.radius.value(),
            angles: uniform_angles(Extent::Whole, 12),
            layers: None,
        };
        let cutout = |(name, own): (&String, &CutoutKeys)| Cutout {
            name: name.clone(),
            start: place(&own.start),
            pieces: pieces(&own.start, &own.edges),
        };
        let contour = Contour {
            start: place(start),
            pieces: pieces(start, edges),
            cutouts: cutouts.iter().map(cutout).collect(),
            holes: holes.iter().map(hole).collect(),
        };
        let cut = cutouts.values().flat_map(|own| &own.edges);
        let all = edges.iter().chain(cut);
        let own = Profile {
            contour,
            refine: all.map(|edge| edge.refine.unwrap_or(1.0)).collect(),
            points: (points.iter())
                .map(|(name, at)| (name.clone(), place(at)))
                .collect(),
            turn: 0.0,
        };
        let lists = cutouts.iter().map(|(name, own)| {
            let table = child(&child(table, "cutouts"), name);
            (table, &own.edges)
        });
        let lists = std::iter::once((table.to_owned(), edges)).chain(lists);
        let mut is_whole = true;
        for (table, edges) in lists {
            refuse_directions(&table, edges, sizes);
            is_whole &= have_ends(&table, edges, sizes);
        }
        // A missing end has been reported, and what follows from it needs no second message.
        if is_whole {
            own.refuse_defects(table, sizes);
        }
        own
    }
}

impl EdgeKeys {
    /// Its way; `through` beside `spline` is refused as the table says.
    fn course(&self) -> Course {
        match (&self.spline, &self.through) {
            (Some(points), _) => Course::Spline(Spline {
                points: points.iter().map(place).collect(),
                leaves: self.leaves.as_ref().map(Quantity::value),
                arrives: self.arrives.as_ref().map(Quantity::value),
            }),
            (None, Some(through)) => Course::Arc(place(through)),
            (None, None) => Course::Line,
        }
    }

    /// The direction that it gives without being a spline.
    fn needless(&self) -> Option<&'static str> {
        let given = [("leaves", &self.leaves), ("arrives", &self.arrives)];
        let mut given = given.iter().filter(|_| self.spline.is_none());
        given.find(|own| own.1.is_some()).map(|own| own.0)
    }
}

/// The pieces of a loop from `start` and back.
fn pieces(start: &Place, edges: &[EdgeKeys]) -> Vec<Piece> {
    let piece = |edge: &EdgeKeys| Piece {
        name: edge.name.clone(),
        to: place(edge.to.as_ref().unwrap_or(start)),
        course: edge.course(),
    };
    edges.iter().map(piece).collect()
}

/// Reports directions at the ends of edges of the loop in `table` that are no splines.
fn refuse_directions(table: &str, edges: &[EdgeKeys], sizes: &mut dyn Sizes) {
    for (index, edge) in edges.iter().enumerate() {
        if let Some(key) = edge.needless() {
            let message = format!("`{key}` is for splines, and edge '{}' is none", edge.name);
            let remedy = "remove it, or give the edge its points between the ends, such as spline = [[\"52 mm\", \"-6 mm\"], [\"55 mm\", \"4 mm\"]]";
            sizes.conflict(
                &child(table, format!("edges.{index}.{key}")),
                message,
                remedy,
            );
        }
    }
}

/// Whether all edges of the loop in `table` but the last have an end; reports those that have none.
fn have_ends(table: &str, edges: &[EdgeKeys], sizes: &mut dyn Sizes) -> bool {
    let inner = &edges[..edges.len().saturating_sub(1)];
    for (index, edge) in inner.iter().enumerate() {
        if edge.to.is_none() {
            let message = format!("edge '{}' has no end", edge.name);
            let remedy = "add to = [\"40 mm\", \"20 mm\"]; only the last edge may leave it out";
            sizes.conflict(&child(table, format!("edges.{index}")), message, remedy);
        }
    }
    inner.iter().all(|edge| edge.to.is_some())
}

fn place(at: &Place) -> Point {
    [at[0].value(), at[1].value()]
}
