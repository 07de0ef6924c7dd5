//! The frame in which a body is triangulated.
//!
//! Triangulations depend on the last bits of coordinates and on the order of their points. Bodies are therefore triangulated in a frame of
//! their own: the box around the outline along a direction of its own (`orientation.rs`), centred and of unit size, coordinates on a grid of
//! [`GRID`], and of the eight ways to turn and mirror that box, and of all orders of pieces and holes, the one whose list of coordinates
//! comes first. The same body in other units, elsewhere, turned, mirrored, or drawn from another corner has the same triangles, unless a
//! coordinate lies within rounding of the middle between two grid lines, or the outline is drawn by arcs of one circle alone, whose ends give the direction. Nodes on the boundary return to the exact curves. Of a body that is its own image, several ways come first: its triangles are their own images only where `symmetry.rs` finds the mirror.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

use stickslip_fem_core::mesh::Point;

use crate::Division;
use crate::contour::{Hole, TOLERANCE};
use crate::cubic::Cubic;
use crate::curve::Track;
use crate::outline::{Outline, bounds};
use crate::plan::Plan;
use crate::vector::{middle, turned};

/// Steps of the grid per size of the body: coarse beside rounding, fine beside cells.
const GRID: f64 = (1_u64 << 36) as f64;

/// A body in the frame of its triangulation.
pub(crate) struct Framed {
    /// What is triangulated.
    pub(crate) plan: Plan,
    /// The track that each track of `plan` was.
    pub(crate) tracks: Vec<usize>,
    /// The hole that each ring of `plan` was.
    pub(crate) holes: Vec<usize>,
    /// The ray that each ray of each ring was.
    pub(crate) rays: Vec<Vec<usize>>,
    /// Its coordinates one after another.
    pub(crate) key: Vec<f64>,
    place: Place,
}

/// Where the frame stands in the drawing.
struct Place {
    /// The direction of its x axis.
    direction: Point,
    centre: Point,
    unit: f64,
    turn: Turn,
}

/// (x, y) → (±x, ±y) or (±y, ±x).
#[derive(Clone, Copy)]
struct Turn {
    swaps: bool,
    signs: Point,
}

/// A piece of outline on the grid.
#[derive(Clone)]
struct Part {
    ends: [Point; 2],
    halfway: Point,
    /// By how many times its cells are smaller than the largest.
    refined: f64,
    /// Of a spline, the control points of its plain parts.
    cubics: Vec<[Point; 4]>,
    track: usize,
}

/// A hole on the grid.
#[derive(Clone)]
struct Eye {
    centre: Point,
    radius: f64,
    /// In right angles, ascending, each with the ray that it was.
    angles: Vec<(f64, usize)>,
    layers: Option<usize>,
    hole: usize,
}

/// A body on the grid.
#[derive(Clone)]
struct Drawing {
    loops: Vec<Vec<Part>>,
    eyes: Vec<Eye>,
}

impl Framed {
    /// The frame of a checked body whose x axis lies along the unit vector `direction`.
    pub(crate) fn along(
        direction: Point,
        plan: &Plan,
        holes: &[Hole],
        division: &Division,
    ) -> Self {
        let back = [direction[0], 0.0 - direction[1]];
        let outline = plan.outline.turned(back);
        let by = back[1].atan2(back[0]);
        let turned_hole = |hole: &Hole| Hole {
            centre: turned(hole.centre, back),
            angles: hole.angles.iter().map(|angle| angle + by).collect(),
            ..hole.clone()
        };
        let turned_holes: Vec<Hole> = holes.iter().map(turned_hole).collect();
        let [low, high] = outline.bounds;
        let centre = middle(low, high);
        let unit = (high[0] - low[0]).max(high[1] - low[1]);
        let drawing = Drawing::new(&outline, &turned_holes, &division.refined, (centre, unit));
        let ways = Turn::all().map(|turn| (turn, drawing.turned(turn)));
        let keys = ways.map(|(turn, drawing)| (turn, drawing.key(), drawing));
        let first = keys.into_iter().min_by(|a, b| ordered(&a.1, &b.1));
        // There are eight.
        let (turn, key, drawing) = first.unwrap_or((Turn::NONE, Vec::new(), drawing));
        let place = Place {
            direction,
            centre,
            unit,
            turn,
        };
        Self::of(plan, holes, division, (drawing, key, place))
    }

    fn of(
        plan: &Plan,
        holes: &[Hole],
        division: &Division,
        (drawing, key, place): (Drawing, Vec<f64>, Place),
    ) -> Self {
        let outline = drawing.outline(&plan.outline);
        let own_holes: Vec<Hole> = drawing.eyes.iter().map(|eye| eye.hole(holes)).collect();
        let division = Division {
            spacing: division
                .spacing
                .map(|spacing| on_grid(spacing / place.unit).max(1.0 / GRID)),
            ..division.clone()
        };
        let parts = drawing.loops.iter().flatten();
        Self {
            plan: Plan::of(outline, &own_holes, &division),
            tracks: parts.map(|part| part.track).collect(),
            holes: drawing.eyes.iter().map(|eye| eye.hole).collect(),
            rays: drawing.eyes.iter().map(Eye::rays).collect(),
            key,
            place,
        }
    }

    /// Whether left and right are exchanged.
    pub(crate) fn mirrors(&self) -> bool {
        self.place.turn.mirrors()
    }

    /// A point of the frame where it was.
    pub(crate) fn back(&self, point: Point) -> Point {
        let own = &self.place;
        let [x, y] = own.turn.undone(point);
        let in_box = [own.centre[0] + own.unit * x, own.centre[1] + own.unit * y];
        turned(in_box, own.direction)
    }
}

impl Turn {
    const NONE: Self = Self {
        swaps: false,
        signs: [1.0; 2],
    };

    fn all() -> [Self; 8] {
        std::array::from_fn(|k| Self {
            swaps: k & 1 != 0,
            signs: [2, 4].map(|bit| if k & bit == 0 { 1.0 } else { -1.0 }),
        })
    }

    fn mirrors(self) -> bool {
        (self.signs[0] * self.signs[1] < 0.0) != self.swaps
    }

    fn of(self, [x, y]: Point) -> Point {
        let [x, y] = if self.swaps { [y, x] } else { [x, y] };
        // Adding zero leaves no negative one.
        [self.signs[0] * x + 0.0, self.signs[1] * y + 0.0]
    }

    fn undone(self, point: Point) -> Point {
        let [x, y] = [self.signs[0] * point[0], self.signs[1] * point[1]];
        if self.swaps { [y, x] } else { [x, y] }
    }

    /// In right angles, which keeps grid points on the grid.
    fn angle(self, angle: f64) -> f64 {
        let angle = if self.swaps { 1.0 - angle } else { angle };
        let angle = if self.signs[0] < 0.0 {
            2.0 - angle
        } else {
            angle
        };
        let angle = if self.signs[1] < 0.0 { -angle } else { angle };
        // Adding zero leaves no negative one.
        angle.rem_euclid(4.0) + 0.0
    }
}

impl Drawing {
    fn new(
        outline: &Outline,
        holes: &[Hole],
        refined: &BTreeMap<usize, f64>,
        (centre, unit): (Point, f64),
    ) -> Self {
        let place = |point: Point| [0, 1].map(|c| on_grid((point[c] - centre[c]) / unit));
        let part = |track: usize| {
            let own = &outline.tracks[track];
            Part {
                ends: [own.from, own.to].map(place),
                halfway: place(own.at(own.length() / 2.0)),
                refined: refined.get(&outline.numbers[track]).copied().unwrap_or(1.0),
                cubics: own.cubics().map(|cubic| cubic.0.map(place)).collect(),
                track,
            }
        };
        let eye = |(hole, own): (usize, &Hole)| {
            let angles = own.angles.iter().enumerate();
            Eye {
                centre: place(own.centre),
                radius: on_grid(own.radius / unit).max(1.0 / GRID),
                angles: angles.map(|(ray, &a)| (right_angles(a), ray)).collect(),
                layers: own.layers,
                hole,
            }
        };
        Self {
            loops: outline
                .loops
                .iter()
                .map(|own| own.clone().map(part).collect())
                .collect(),
            eyes: holes.iter().enumerate().map(eye).collect(),
        }
    }

    /// Turned, and in the order that its coordinates give.
    fn turned(&self, turn: Turn) -> Self {
        let mut loops: Vec<Vec<Part>> = self
            .loops
            .iter()
            .map(|own| {
                let mut own: Vec<Part> = own.iter().map(|part| part.turned(turn)).collect();
                if turn.mirrors() {
                    own.reverse();
                }
                let first =
                    (0..own.len()).min_by(|&a, &b| ordered(&own[a].ends[0], &own[b].ends[0]));
                own.rotate_left(first.unwrap_or(0));
                own
            })
            .collect();
        // The outline stays before its cut-outs.
        loops[1..].sort_by(|a, b| ordered(&a[0].ends[0], &b[0].ends[0]));
        let mut eyes: Vec<Eye> = self.eyes.iter().map(|eye| eye.turned(turn)).collect();
        eyes.sort_by(|a, b| ordered(&a.centre, &b.centre));
        Self { loops, eyes }
    }

    /// Its numbers one after another.
    fn key(&self) -> Vec<f64> {
        let parts = self.loops.iter().flatten();
        let lines = parts.flat_map(|part| {
            let inside = part.cubics.as_flattened().as_flattened();
            let places = part.ends[0].into_iter().chain(part.halfway);
            places.chain([part.refined]).chain(inside.iter().copied())
        });
        let circles = self.eyes.iter().flat_map(|eye| {
            let angles = eye.angles.iter().map(|&(angle, _)| angle);
            let layers = eye.layers.map_or(-1.0, |layers| layers as f64);
            (eye.centre.into_iter().chain([eye.radius, layers])).chain(angles)
        });
        lines.chain(circles).collect()
    }

    fn outline(&self, was: &Outline) -> Outline {
        let parts = || self.loops.iter().flatten();
        let tracks: Vec<Track> = parts().map(|part| part.track(was)).collect();
        let mut begin = 0;
        let loops = self.loops.iter().map(|own| {
            begin += own.len();
            begin - own.len()..begin
        });
        Outline {
            names: parts().map(|part| was.names[part.track].clone()).collect(),
            numbers: parts().map(|part| was.numbers[part.track]).collect(),
            loops: loops.collect(),
            bounds: bounds(&tracks),
            tracks,
            tolerance: TOLERANCE,
        }
    }
}

impl Part {
    fn turned(&self, turn: Turn) -> Self {
        let mut ends = self.ends.map(|end| turn.of(end));
        if turn.mirrors() {
            ends.reverse();
        }
        let cubics = self.cubics.iter();
        let mut cubics: Vec<[Point; 4]> = cubics.map(|own| own.map(|at| turn.of(at))).collect();
        if turn.mirrors() {
            cubics.reverse();
            for own in &mut cubics {
                own.reverse();
            }
        }
        Self {
            ends,
            halfway: turn.of(self.halfway),
            cubics,
            ..*self
        }
    }

    /// Its curve; an arc that the grid has made straight is a line.
    fn track(&self, was: &Outline) -> Track {
        if !self.cubics.is_empty() {
            return Track::along(self.cubics.iter().copied().map(Cubic).collect());
        }
        let [from, to] = self.ends;
        let arc = was.tracks[self.track].radius().map(|_| self.halfway);
        arc.and_then(|halfway| Track::arc(from, halfway, to))
            .unwrap_or_else(|| Track::line(from, to))
    }
}

impl Eye {
    fn turned(&self, turn: Turn) -> Self {
        let angles = self.angles.iter();
        let mut angles: Vec<(f64, usize)> = angles
            .map(|&(angle, ray)| (turn.angle(angle), ray))
            .collect();
        angles.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self {
            centre: turn.of(self.centre),
            angles,
            ..*self
        }
    }

    fn hole(&self, holes: &[Hole]) -> Hole {
        Hole {
            centre: self.centre,
            radius: self.radius,
            angles: self
                .angles
                .iter()
                .map(|&(angle, _)| FRAC_PI_2 * angle)
                .collect(),
            ..holes[self.hole].clone()
        }
    }

    fn rays(&self) -> Vec<usize> {
        self.angles.iter().map(|&(_, ray)| ray).collect()
    }
}

fn on_grid(value: f64) -> f64 {
    (value * GRID).round() / GRID + 0.0
}

/// An angle `[rad]` in right angles in [0, 4), on the grid.
fn right_angles(angle: f64) -> f64 {
    on_grid(angle / FRAC_PI_2).rem_euclid(4.0)
}

/// The first difference decides.
pub(crate) fn ordered(a: &[f64], b: &[f64]) -> Ordering {
    let pairs = a.iter().zip(b).map(|(a, b)| a.total_cmp(b));
    pairs
        .into_iter()
        .find(|order| order.is_ne())
        .unwrap_or(Ordering::Equal)
}
