//! Open edges of known curves that may touch: where they face each other, and their gaps.
//!
//! Places are arc lengths s along the first edge from its middle. The first body is moved by t to where the edges touch, and gaps are linear in displacements from there,
//!
//! ```text
//! g(s) = w(s) − n(s)·t,     w(s) the way from x(s) + t to the second edge along −n(s)
//! ```
//!
//! so that how far apart the bodies stand changes no pressure. The normal n into the first body is that of the flatter edge: of the first at s, otherwise of the second at the place nearest to
//! x(s) + t. Along a normal of a curve that rolls off, a body that slides would be held by a stiffness of force over radius, which is the geometry's and not the contact's.
//! A place whose normal leads past the other edge faces nothing.

use std::ops::Range;

use stickslip_fem_core::mesh::{EdgePath, Mesh, Point};
use stickslip_fem_core::vector::dot;
use stickslip_scene::schema::SetRef;
use stickslip_scene::shape::Path;
use stickslip_scene::units::Unit;

use super::edge::EdgeNodes;
use super::ends;
use crate::model::plan::{ContactPlan, Placed, Plan};
use crate::model::{EdgeEnd, Meshes, ModelError};
use crate::results::EdgeKind;

/// Places of a cell at which its gap is tried, beside its ends.
const SAMPLES: usize = 8;
/// Overlaps up to this part of the edge's length are rounding.
const ROUNDING: f64 = 1e-9;
/// Overlap up to which displacements are small beside an edge, as a part of its extent.
const MOST_OVERLAP: f64 = 0.05;
/// Cosine of the angle between two normals up to which edges do not face each other.
const ASKEW: f64 = 1e-3;

/// Places along the first edge at which the nearest one is sought, before it is refined.
const PLACES: usize = 512;
/// Golden sections of the interval around the nearest place.
const SECTIONS: usize = 60;

/// Two open edges where they stand.
#[derive(Clone, Debug)]
pub(super) struct OpenPair {
    /// The first edge, moved to where it touches.
    first: Path,
    second: Path,
    /// By what it was moved.
    travel: Point,
    /// Whether normals are those of the second edge.
    by_second: bool,
}

impl OpenPair {
    /// The edges of a contact, if the curves of both are known.
    pub(super) fn of(plan: &Plan<'_>, contact: &ContactPlan<'_>) -> Option<Self> {
        let [first, second] = &contact.sides;
        let path = |side: &Placed<'_, SetRef>| {
            let path = side.edge.as_ref()?.curve.path()?;
            Some(path.moved(plan.bodies[side.body].centre))
        };
        let [first, second] = [path(first)?, path(second)?];
        let mut pair = Self {
            travel: [0.0; 2],
            by_second: second.turn() < first.turn() - ROUNDING,
            first,
            second,
        };
        if let Some((gap, normal)) = pair.nearest().filter(|(gap, _)| *gap > 0.0) {
            pair.travel = normal.map(|part| -gap * part);
            pair.first = pair.first.moved(pair.travel);
        }
        Some(pair)
    }

    /// The least gap and the normal there.
    fn nearest(&self) -> Option<(f64, Point)> {
        let half = 0.5 * self.extent();
        let step = 2.0 * half / PLACES as f64;
        let way = |at: f64| self.way(at).map_or(f64::INFINITY, |(way, _)| way);
        let places = (0..=PLACES).map(|k| -half + step * k as f64);
        let coarse = places.min_by(|a, b| way(*a).total_cmp(&way(*b)))?;
        let [mut low, mut high] = [(coarse - step).max(-half), (coarse + step).min(half)];
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        for _ in 0..SECTIONS {
            let [inner, outer] = [high - golden * (high - low), low + golden * (high - low)];
            if way(inner) <= way(outer) {
                high = outer;
            } else {
                low = inner;
            }
        }
        let fine = [coarse, 0.5 * (low + high)];
        let at = fine
            .into_iter()
            .min_by(|a, b| way(*a).total_cmp(&way(*b)))?;
        self.way(at)
    }

    /// A gap `[mm]` that nothing closes: the length of the first edge beyond where the bodies have travelled.
    pub(super) fn never(&self) -> f64 {
        self.extent() + dot(self.travel, self.travel).sqrt()
    }

    fn extent(&self) -> f64 {
        self.first.length()
    }

    /// Unit normal into the first body at the place `at`.
    pub(super) fn normal(&self, at: f64) -> Point {
        let own = self.first.left(self.along(at));
        self.way(at).map_or(own, |(_, normal)| normal)
    }

    /// The initial gap at the place `at` `[mm]`; `None` where it faces nothing.
    pub(super) fn gap(&self, at: f64) -> Option<f64> {
        let (way, normal) = self.way(at)?;
        Some(way - dot(normal, self.travel))
    }

    /// The way from the moved first edge to the second at the place `at` `[mm]`, and the normal along which it is measured.
    fn way(&self, at: f64) -> Option<(f64, Point)> {
        let s = self.along(at);
        let (from, own) = (self.first.at(s), self.first.left(s));
        if !self.by_second {
            let crossings = self.second.crossings(from, own.map(|part| -part));
            let facing = crossings.filter(|&(_, place)| dot(self.second.left(place), own) < -ASKEW);
            let ways = facing.map(|(way, _)| (way, own));
            return ways.min_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        }
        let place = self.second.nearest(from);
        let (foot, left) = (self.second.at(place), self.second.left(place));
        let apart = [from[0] - foot[0], from[1] - foot[1]];
        // Beside an end or a corner the nearest place is on no normal.
        let is_beside = dot(apart, self.second.tangent(place)).abs() > ROUNDING * self.extent();
        let faces = dot(left, own) < -ASKEW && !is_beside;
        faces.then(|| (-dot(apart, left), left.map(|part| -part)))
    }

    /// Arc length from the beginning of the first edge.
    fn along(&self, at: f64) -> f64 {
        at + 0.5 * self.first.length()
    }

    /// The place that a node `at` of the first edge has; what is rounding beside the length is the middle.
    fn place(&self, at: Point) -> f64 {
        let moved = [at[0] + self.travel[0], at[1] + self.travel[1]];
        self.centred(self.first.nearest(moved))
    }

    /// The place of the moved first edge that a point of the second faces; beyond the ends as far as the point is from what they face along the flatter edge.
    fn facing(&self, point: Point) -> f64 {
        if self.by_second {
            let normal = self.second.left(self.second.nearest(point));
            let crossings = self.first.crossings(point, normal);
            let facing = crossings.filter(|&(_, s)| dot(self.first.left(s), normal) < -ASKEW);
            if let Some((_, s)) = facing.min_by(|a, b| a.0.abs().total_cmp(&b.0.abs())) {
                return self.centred(s);
            }
            let own = self.second.nearest(point);
            let length = self.first.length();
            let ends = [0.0, length].map(|s| self.second.nearest(self.first.at(s)));
            let away = ends.map(|end| (own - end).abs());
            let lies_between = own > ends[0].min(ends[1]) && own < ends[0].max(ends[1]);
            if !lies_between {
                let is_before = away[0] < away[1];
                return self.centred(if is_before {
                    -away[0]
                } else {
                    length + away[1]
                });
            }
        }
        let s = self.first.nearest(point);
        let (foot, tangent) = (self.first.at(s), self.first.tangent(s));
        let beyond = dot([point[0] - foot[0], point[1] - foot[1]], tangent);
        let is_end = s <= 0.0 || s >= self.first.length();
        self.centred(s + if is_end { beyond } else { 0.0 })
    }

    fn centred(&self, s: f64) -> f64 {
        let length = self.first.length();
        let at = s - 0.5 * length;
        if at.abs() < ROUNDING * length {
            0.0
        } else {
            at
        }
    }

    /// Whether the second edge at a point of it and the first face each other.
    fn opposes(&self, point: Point) -> bool {
        let own = self.second.left(self.second.nearest(point));
        dot(own, self.first.left(self.first.nearest(point))) < -ASKEW
    }

    /// The least way in `range`, of [`SAMPLES`] places and its ends; `None` if one of them faces nothing.
    fn least_way(&self, [from, to]: [f64; 2]) -> Option<f64> {
        let at = |k: usize| from + (to - from) * k as f64 / SAMPLES as f64;
        let ways: Option<Vec<f64>> = (0..=SAMPLES)
            .map(|k| self.way(at(k)).map(|(way, _)| way))
            .collect();
        Some(ways?.into_iter().fold(f64::INFINITY, f64::min))
    }

    /// The nodes of the two edges where these face each other, the first ascending along it, the second by the places that they face; those of a rigid second body do not exist.
    ///
    /// # Errors
    /// [`ModelError::Pairing`] where they face each other nowhere, or overlap without being meant to.
    pub(super) fn nodes(
        &self,
        plan: &Plan<'_>,
        planned: &ContactPlan<'_>,
        meshes: &Meshes,
        is_rigid: bool,
        length: &Unit,
    ) -> Result<(EdgeNodes, Option<EdgeNodes>), ModelError> {
        let ContactPlan {
            of: contact, sides, ..
        } = planned;
        let [first, second] = [&contact.first, &contact.second];
        let refused = |what: String| ModelError::Pairing {
            contact: contact.name.clone(),
            what,
        };
        let facing_nothing = || {
            refused(format!(
                "{first} and {second} do not face each other: lines along the normals of the first meet the second nowhere with the bodies on opposite sides; move one of the \
                 bodies, or name the edges that touch"
            ))
        };
        let lower = if is_rigid {
            None
        } else {
            let walked = walk(&sides[1], meshes, |at| self.facing(at))?.reversed();
            let kept = self.facing_cells(&walked).ok_or_else(facing_nothing)?;
            let into_first =
                |point: Point| left_on(&self.second, self.second.nearest(point)).map(|part| -part);
            Some(walked.edge_nodes(kept, &into_first))
        };
        let everywhere = [f64::NEG_INFINITY, f64::INFINITY];
        let reach = lower.as_ref().map_or(everywhere, |lower| {
            let places = &lower.parameter;
            [places[0], places[places.len() - 1]]
        });
        let walked = walk(&sides[0], meshes, |at| self.place(at))?;
        let gaps = self.gaps(&walked, reach);
        let kept = run_around_least(&gaps).ok_or_else(facing_nothing)?;
        let least = gaps[kept.clone()]
            .iter()
            .flatten()
            .copied()
            .fold(f64::INFINITY, f64::min);
        if least < -ROUNDING * self.extent() && !contact.interference {
            let overlap = length.show(-least);
            return Err(refused(format!(
                "{first} and {second} overlap by {overlap}; move one of the bodies, or say interference = true"
            )));
        }
        if least < -MOST_OVERLAP * self.extent() {
            let [overlap, most] =
                [-least, MOST_OVERLAP * self.extent()].map(|own| length.show(own));
            return Err(refused(format!(
                "{first} and {second} overlap by {overlap}, and displacements are small beside an edge of this size up to {most}; move one of the bodies"
            )));
        }
        let own = |point: Point| left_on(&self.first, self.along(self.place(point)));
        let mut upper = walked.edge_nodes(kept, &own);
        let half = 0.5 * self.extent();
        let faced = [0.0, self.second.length()].map(|s| self.facing(self.second.at(s)));
        let ends = [
            ends::Side {
                placed: &sides[0],
                path: &self.first,
                reach: [-half, half],
                is_reversed: false,
            },
            ends::Side {
                placed: &sides[1],
                path: &self.second,
                reach: [faced[0].min(faced[1]), faced[0].max(faced[1])],
                is_reversed: faced[0] > faced[1],
            },
        ];
        upper.ends = ends::of(plan, meshes, ends, &upper, planned.rubs());
        Ok((upper, lower))
    }

    /// The least gap of every cell of the first edge within `reach`; `None` where it faces nothing.
    fn gaps(&self, walked: &Walked<'_>, [from, to]: [f64; 2]) -> Vec<Option<f64>> {
        let Walked { path, places, .. } = walked;
        let least = |cell: usize| {
            let ends = [cell, cell + 1].map(|corner| places[corner * path.order]);
            let shared = [ends[0].max(from), ends[1].min(to)];
            (shared[0] < shared[1])
                .then(|| self.least_way(shared))
                .flatten()
        };
        (0..path.edges.len()).map(least).collect()
    }

    /// The cells of the second edge that face the first, in part at least, one after another around the nearest.
    fn facing_cells(&self, walked: &Walked<'_>) -> Option<Range<usize>> {
        let Walked { mesh, path, places } = walked;
        let half = 0.5 * self.extent();
        let distance = |cell: usize| -> Option<f64> {
            let nodes = cell * path.order..=(cell + 1) * path.order;
            let (at, own) = (&places[nodes.clone()], &path.nodes[nodes]);
            let points = || own.iter().map(|&node| mesh.nodes()[node]);
            let ascends = at.windows(2).all(|pair| pair[0] < pair[1]);
            let faces = ascends
                && (path.order != 2 || is_even(at))
                && at[path.order] > -half
                && at[0] < half
                && points().any(|point| self.opposes(point));
            let away = points().map(|point| {
                let foot = self.first.at(self.first.nearest(point));
                (point[0] - foot[0]).hypot(point[1] - foot[1])
            });
            faces.then(|| away.fold(f64::INFINITY, f64::min))
        };
        let distances: Vec<Option<f64>> = (0..path.edges.len()).map(distance).collect();
        run_around_least(&distances)
    }
}

/// The unit normal on the left of a path, where two of its pieces meet the mean of both.
fn left_on(path: &Path, at: f64) -> Point {
    let near = ROUNDING * path.length();
    let [before, after] = [at - near, at + near].map(|s| path.left(s.clamp(0.0, path.length())));
    let sum = [before[0] + after[0], before[1] + after[1]];
    let size = sum[0].hypot(sum[1]);
    if size > ASKEW {
        sum.map(|part| part / size)
    } else {
        before
    }
}

/// An open edge of a mesh, and the places of the first edge that its nodes face.
struct Walked<'m> {
    mesh: &'m Mesh,
    path: EdgePath,
    places: Vec<f64>,
}

impl Walked<'_> {
    /// The cells `kept` of an edge, with the normal into the first body that `normal` gives at a node: that of the edge itself, beside which
    /// those of contact are those of the flatter edge.
    fn edge_nodes(&self, kept: Range<usize>, normal: &dyn Fn(Point) -> Point) -> EdgeNodes {
        let order = self.path.order;
        let nodes = kept.start * order..=kept.end * order;
        let path = EdgePath {
            nodes: self.path.nodes[nodes.clone()].to_vec(),
            closed: false,
            edges: self.path.edges[kept].to_vec(),
            order,
        };
        let parameter = self.places[nodes].to_vec();
        let places = path.nodes.iter().map(|&node| self.mesh.nodes()[node]);
        let along = parameter.iter().zip(places);
        let along = along.map(|(&at, place)| (-at, normal(place)));
        EdgeNodes {
            kind: EdgeKind::Path,
            path: along.collect(),
            weights: self.mesh.edge_weights(&path, None),
            corner: (0..path.nodes.len()).map(|k| k % order == 0).collect(),
            centre: None,
            ends: [EdgeEnd::Free; 2],
            nodes: path.nodes,
            order,
            parameter,
        }
    }

    /// The same edge walked the other way.
    fn reversed(mut self) -> Self {
        self.path = self.path.reversed();
        self.places.reverse();
        self
    }
}

/// Whether the middle of three places lies in the middle half between the others, where a quadratic edge does not fold.
fn is_even(at: &[f64]) -> bool {
    let part = (at[1] - at[0]) / (at[2] - at[0]);
    (0.25..=0.75).contains(&part)
}

/// The nodes of an edge with their places by `place`.
fn walk<'m>(
    side: &Placed<'_, SetRef>,
    meshes: &'m Meshes,
    place: impl Fn(Point) -> f64,
) -> Result<Walked<'m>, ModelError> {
    let mesh = &*meshes[&side.body];
    let path = mesh
        .edge_path(&side.of.set)
        .map_err(|cause| ModelError::Mesh {
            body: side.of.body.clone(),
            cause,
        })?;
    let places = path.nodes.iter().map(|&node| place(mesh.nodes()[node]));
    Ok(Walked {
        mesh,
        places: places.collect(),
        path,
    })
}

/// The longest run of known values around the least of them.
fn run_around_least(values: &[Option<f64>]) -> Option<Range<usize>> {
    let known = values
        .iter()
        .enumerate()
        .filter_map(|(k, value)| Some((k, (*value)?)));
    let (least, _) = known.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let before = values[..least]
        .iter()
        .rev()
        .take_while(|value| value.is_some())
        .count();
    let after = values[least..]
        .iter()
        .take_while(|value| value.is_some())
        .count();
    Some(least - before..least + after)
}
