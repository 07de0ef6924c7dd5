//! `outline`: a body between lines and arcs, with cut-outs of the same and circular holes anywhere in it.
//!
//! ```text
//!              top
//!      ┌──────────────────╮
//!      │                   ╲
//! left │     a       b      │ end      edges follow one another counter-clockwise, each from the
//!      │                   ╱           end of the one before; the last one closes the outline
//!      └──────────────────╯
//!    start    bottom
//! ```

mod curves;
mod defects;

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use stickslip_fem_core::generate::{Extent, uniform_angles, unit_vector};
use stickslip_fem_core::mesh::{ElementKind, Point};
use stickslip_mesher::{Contour, ContourMesh, Cutout, Hole, Piece};

use super::Shape;
use super::curve::Curve;
use super::hole::MESH_KEYS;
use super::outline::{Divided, DivisionError, Edge, Meshing, Outline, Role, Sizes};
use super::pattern::{self, PatternFormat};
use crate::declaration::{
    Key, NONE, POSITIVE, REQUIRED, Range, Table, length, number, numbers, table, tables_of, text,
    words,
};
use crate::document::child;
use crate::units::{Length, Quantity};

const NAME: &str = "outline";
/// Around a corner cells may be a millionth of those inside and still be few.
const REFINED: Range = numbers(" 1 to 1e6", "1 to 1e6", |value| {
    (1.0..=1e6).contains(&value)
});

pub(super) const MEANING: &str = "lines and arcs around a body, with cut-outs and circular holes anywhere in it; edges, holes and points as they are named; areas `section`";

const EDGE: [Key; 4] = [
    text(
        "name",
        REQUIRED,
        r#""end""#,
        "name of the edge; neighbours with one name are one edge",
    ),
    words(
        "to",
        "two lengths",
        "`start`, of the last edge",
        r#"["40 mm", "20 mm"]"#,
        "where it ends",
    ),
    words(
        "through",
        "two lengths",
        "a straight edge",
        r#"["60 mm", "0 mm"]"#,
        "a point between its ends, which makes it an arc",
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
pub(super) const ROWS: &[Key] = &[
    words("start", "two lengths", REQUIRED, r#"["-60 mm", "-20 mm"]"#, "where the first edge begins"),
    words("edges", "list of tables", REQUIRED, r#"[{ name = "bottom", to = ["40 mm", "-20 mm"] }, { name = "end", to = ["40 mm", "20 mm"], through = ["60 mm", "0 mm"] }, { name = "top", to = ["-60 mm", "20 mm"] }, { name = "left" }]"#,
        "the [edges](#bodiesnameshapeoutlineedges), counter-clockwise, each from the end of the one before"),
    tables_of("cutouts", NONE, "slots and windows by name"),
    tables_of("holes", NONE, "circular holes by name"),
    words("points", "table of two lengths", NONE, r#"{ corner = ["40 mm", "20 mm"] }"#, "names of places where edges end, which forces, supports and springs act on"),
];

/// The tables inside.
#[rustfmt::skip]
pub(super) const TABLES: &[Table] = &[
    Table::new("bodies.NAME.shape.outline.edges", &EDGE),
    Table::new("bodies.NAME.shape.outline.cutouts.NAME", &[
        words("start", "two lengths", REQUIRED, r#"["-50 mm", "-4 mm"]"#, "where its first edge begins"),
        words("edges", "list of tables", REQUIRED, r#"[{ name = "slot-below", to = ["-30 mm", "-4 mm"] }, { name = "slot-right", to = ["-30 mm", "4 mm"], through = ["-26 mm", "0 mm"] }, { name = "slot-above", to = ["-50 mm", "4 mm"] }, { name = "slot-left", through = ["-54 mm", "0 mm"] }]"#,
            "the [edges](#bodiesnameshapeoutlinecutoutsnameedges), counter-clockwise as those around the body"),
        table("pattern", NONE, pattern::MEANING),
    ]),
    Table::new("bodies.NAME.shape.outline.cutouts.NAME.edges", &EDGE),
    Table::new("bodies.NAME.shape.outline.holes.NAME", &[
        words("centre", "two lengths", REQUIRED, r#"["40 mm", "0 mm"]"#, "its centre"),
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
pub(super) const EXAMPLE: &str = r#"outline = { start = ["-30 mm", "-10 mm"], edges = [{ name = "bottom", to = ["8 mm", "-10 mm"] }, { name = "end", to = ["8 mm", "10 mm"], through = ["18 mm", "0 mm"] }, { name = "top", to = ["-30 mm", "10 mm"] }, { name = "left" }], cutouts.slot = { start = ["-24 mm", "-3 mm"], edges = [{ name = "slot-below", to = ["-10 mm", "-3 mm"] }, { name = "slot-end", to = ["-10 mm", "3 mm"], through = ["-7 mm", "0 mm"] }, { name = "slot-above", to = ["-24 mm", "3 mm"] }, { name = "slot-start" }] }, holes.bolt = { centre = ["7 mm", "1 mm"], radius = "5 mm" } }"#;

impl Keys {
    pub(super) fn read(&self, table: &str, sizes: &mut dyn Sizes) -> Profile {
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
        };
        let lists = cutouts.iter().map(|(name, own)| {
            let table = child(&child(table, "cutouts"), name);
            (table, &own.edges)
        });
        let lists = std::iter::once((table.to_owned(), edges)).chain(lists);
        let mut is_whole = true;
        for (table, edges) in lists {
            is_whole &= have_ends(&table, edges, sizes);
        }
        // A missing end has been reported, and what follows from it needs no second message.
        if is_whole {
            own.refuse_defects(table, sizes);
        }
        own
    }
}

/// The pieces of a loop from `start` and back.
fn pieces(start: &Place, edges: &[EdgeKeys]) -> Vec<Piece> {
    let piece = |edge: &EdgeKeys| Piece {
        name: edge.name.clone(),
        to: place(edge.to.as_ref().unwrap_or(start)),
        through: edge.through.as_ref().map(place),
    };
    edges.iter().map(piece).collect()
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

/// Lines and arcs around a body, with cut-outs and circular holes.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// Its edges, cut-outs and holes; the angles of holes are those of a mesh.
    pub contour: Contour,
    /// By how many times cells along each piece of the outline, and then of the cut-outs, are smaller than the largest.
    pub refine: Vec<f64>,
    /// Named places where edges end.
    pub points: BTreeMap<String, Point>,
}

impl Profile {
    /// The same body with its points where `place` puts them.
    fn mapped(&self, place: impl Fn(Point) -> Point) -> Self {
        let points = self.points.iter();
        Self {
            contour: placed(&self.contour, &place),
            refine: self.refine.clone(),
            points: points
                .map(|(name, &at)| (name.clone(), place(at)))
                .collect(),
        }
    }

    /// The same body turned by `angle` `[rad]` about the origin.
    pub(super) fn turned(&self, angle: f64) -> Self {
        let [cos, sin] = unit_vector(angle);
        let turn = |[x, y]: Point| [cos * x - sin * y, sin * x + cos * y];
        self.mapped(turn)
    }
}

/// The same body with its points where `place` puts them.
fn placed(contour: &Contour, place: impl Fn(Point) -> Point) -> Contour {
    let mut own = contour.clone();
    let walk = |start: &mut Point, pieces: &mut [Piece]| {
        *start = place(*start);
        for piece in pieces {
            piece.to = place(piece.to);
            piece.through = piece.through.map(&place);
        }
    };
    walk(&mut own.start, &mut own.pieces);
    for cutout in &mut own.cutouts {
        walk(&mut cutout.start, &mut cutout.pieces);
    }
    for hole in &mut own.holes {
        hole.centre = place(hole.centre);
    }
    own
}

impl Outline for Profile {
    fn name(&self) -> &'static str {
        NAME
    }

    fn edges(&self) -> Vec<Edge> {
        let hole = |hole: &Hole| Edge {
            name: Cow::Owned(hole.name.clone()),
            curve: Curve::Circle {
                centre: hole.centre,
                radius: hole.radius,
            },
            role: Role::Hole,
            size: Some(format!("{NAME}.holes.{}.radius", hole.name).into()),
        };
        let mut edges: Vec<Edge> = self.contour.holes.iter().map(hole).collect();
        edges.extend(curves::around(&self.contour));
        edges.extend(self.contour.cutouts.iter().flat_map(curves::cut_out));
        edges
    }

    fn points(&self) -> Vec<(Cow<'static, str>, Point)> {
        let points = self.points.iter();
        points
            .map(|(name, &at)| (Cow::Owned(name.clone()), at))
            .collect()
    }

    fn areas(&self) -> &'static [&'static str] {
        &["section"]
    }

    fn bounds(&self) -> [Point; 2] {
        self.contour.bounds()
    }

    fn mirror(&self) -> Option<usize> {
        None
    }

    fn mesh_keys(&self) -> &'static [&'static str] {
        if self.contour.holes.is_empty() {
            &["spacing"]
        } else {
            MESH_KEYS
        }
    }

    /// Triangles of the order that is asked for.
    fn cells(&self, asked: ElementKind) -> Option<ElementKind> {
        match asked.order() {
            1 => Some(ElementKind::T3),
            2 => Some(ElementKind::T6),
            _ => None,
        }
    }

    fn refinement(&self) -> f64 {
        self.refine.iter().copied().fold(1.0, f64::max)
    }

    fn meshing(&self, divided: &Divided<'_>) -> Result<Meshing, DivisionError> {
        let kind = self.cells(divided.kind).ok_or(DivisionError::NoCells {
            kind: divided.kind.name(),
        })?;
        // About its start, which keeps the digits of circles through three points far from the origin.
        let start = self.contour.start;
        let mut contour = placed(&self.contour, |at| [at[0] - start[0], at[1] - start[1]]);
        for hole in &mut contour.holes {
            hole.angles = divided.angles.to_vec();
            hole.layers = divided.layers;
        }
        let division = stickslip_mesher::Division {
            kind,
            spacing: divided.spacing,
            refined: self.refine.iter().copied().enumerate().collect(),
            points: (self.points.iter())
                .map(|(name, at)| (name.clone(), [at[0] - start[0], at[1] - start[1]]))
                .collect(),
            centre: [0, 1].map(|axis| divided.centre[axis] + start[axis]),
            ..stickslip_mesher::Division::default()
        };
        Ok(Meshing {
            generator: Box::new(ContourMesh { contour, division }),
            layers: None,
        })
    }

    fn is_placed(&self) -> bool {
        true
    }

    fn moved(&self, by: Point) -> Option<Shape> {
        let moved = self.mapped(|at| [at[0] + by[0], at[1] + by[1]]);
        Some(Shape::Profile(moved))
    }

    fn describe(&self, show: &dyn Fn(f64) -> String) -> String {
        let [low, high] = self.bounds();
        let holes: Vec<String> = (self.contour.holes.iter())
            .map(|hole| format!("'{}' of radius {}", hole.name, show(hole.radius)))
            .collect();
        let holes = if holes.is_empty() {
            String::new()
        } else {
            format!(", with the holes {}", holes.join(", "))
        };
        let cutouts: Vec<String> = (self.contour.cutouts.iter())
            .map(|own| format!("'{}' of {} edges", own.name, own.pieces.len()))
            .collect();
        let cutouts = if cutouts.is_empty() {
            String::new()
        } else {
            format!(", with the cut-outs {}", cutouts.join(", "))
        };
        format!(
            "outline of {} edges, {} by {}{cutouts}{holes}",
            self.contour.pieces.len(),
            show(high[0] - low[0]),
            show(high[1] - low[1]),
        )
    }
}
