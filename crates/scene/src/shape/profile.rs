//! `outline`: a body between lines, arcs and splines, with cut-outs of the same and circular holes anywhere in it.
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
mod keys;

use std::borrow::Cow;
use std::collections::BTreeMap;

use stickslip_fem_core::generate::unit_vector;
use stickslip_fem_core::mesh::{ElementKind, Point};
use stickslip_mesher::{Contour, ContourMesh, Hole, Piece};

use super::Shape;
use super::curve::Curve;
use super::outline::{Divided, DivisionError, Edge, Meshing, Outline, Role};

#[cfg(test)]
pub(super) use self::keys::EXAMPLE;
pub(super) use self::keys::{Keys, MEANING, ROWS, TABLES};
pub(super) use super::hole::MESH_KEYS;

const NAME: &str = "outline";
/// Lines, arcs and splines around a body, with cut-outs and circular holes.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// Its edges, cut-outs and holes; the angles of holes are those of a mesh.
    pub contour: Contour,
    /// By how many times cells along each piece of the outline, and then of the cut-outs, are smaller than the largest `[1]`.
    pub refine: Vec<f64>,
    /// Named places where edges end `[mm]`.
    pub points: BTreeMap<String, Point>,
    /// By what it is turned from how it is drawn `[rad]`.
    pub(super) turn: f64,
}

impl Profile {
    /// The same body with its points where `place` puts them, and its directions turned by `turn` `[rad]`.
    fn mapped(&self, place: impl Fn(Point) -> Point, turn: f64) -> Self {
        let points = self.points.iter();
        Self {
            contour: placed(&self.contour, &place, turn),
            refine: self.refine.clone(),
            points: points
                .map(|(name, &at)| (name.clone(), place(at)))
                .collect(),
            turn: self.turn + turn,
        }
    }
}

/// The same body with its points where `place` puts them, and its directions turned by `turn` `[rad]`.
fn placed(contour: &Contour, place: impl Fn(Point) -> Point, turn: f64) -> Contour {
    let mut own = contour.clone();
    let walk = |start: &mut Point, pieces: &mut [Piece]| {
        *start = place(*start);
        for piece in pieces {
            piece.to = place(piece.to);
            piece.course = piece.course.mapped(&place, |angle| angle + turn);
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

    fn reentrant_corners(&self) -> Vec<(Point, f64)> {
        self.contour.reentrant_corners()
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
        let mut contour = placed(
            &self.contour,
            |at| [at[0] - start[0], at[1] - start[1]],
            0.0,
        );
        for hole in &mut contour.holes {
            hole.angles = divided.angles.to_vec();
            hole.layers = divided.layers;
        }
        let division = stickslip_mesher::Division {
            kind,
            spacing: divided.spacing,
            fineness: divided.fineness,
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
        let moved = self.mapped(|at| [at[0] + by[0], at[1] + by[1]], 0.0);
        Some(Shape::Profile(moved))
    }

    fn turn(&self) -> f64 {
        self.turn
    }

    fn turned(&self, angle: f64) -> Option<Shape> {
        let [cos, sin] = unit_vector(angle);
        let turn = |[x, y]: Point| [cos * x - sin * y, sin * x + cos * y];
        Some(Shape::Profile(self.mapped(turn, angle)))
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
