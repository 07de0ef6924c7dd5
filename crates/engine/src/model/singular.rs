//! Places of a body where stresses of the linear model have no bound.

use std::ops::RangeInclusive;

use stickslip_fem_core::mesh::{EdgePath, Mesh, MeshError, Point};
use stickslip_scene::schema::LoadKind;

use super::edge::ModelEdge;
use super::plan::Plan;
use crate::results::EdgeResults;

/// Tangent of the angle up to which two edges go on without a corner.
const SMOOTH: f64 = 0.3;
/// Part of a traction along an edge from which it is one.
const ALONG: f64 = 1e-6;

/// Part of the size of a half up to which a node stands on its axis.
const ROUNDING: f64 = 1e-9;

/// The line at which a body is cut in half.
#[derive(Clone, Copy)]
pub(super) struct Axis {
    /// Coordinate that the two halves differ in.
    pub(super) coordinate: usize,
    /// Where it is on that line `[mm]`.
    pub(super) at: f64,
}

/// A place where stresses have no bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Singular {
    /// The node of a held point, of one on a spring, or of one that a force acts on, whose reaction is a concentrated force.
    Point(usize),
    /// The node at the end of a supported edge or of a platen.
    End(usize),
}

impl Singular {
    /// The node.
    pub fn node(self) -> usize {
        match self {
            Self::Point(node) | Self::End(node) => node,
        }
    }
}

/// A re-entrant corner of a body, towards which stress has no limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReentrantCorner {
    /// The node.
    pub node: usize,
    /// Angle inside the body, between π and 2π `[rad]`.
    pub angle: f64,
}

impl ReentrantCorner {
    /// Exponent λ − 1 `[1]` of the stress r^(λ − 1) that grows fastest towards it in an isotropic body with free sides, opened symmetrically:
    ///
    /// ```text
    /// sin(λ ω) + λ sin ω = 0,   ½ ≤ λ < 1
    /// ```
    ///
    /// Source: Williams, J. Appl. Mech. 19 (1952) 526–528.
    pub fn exponent(self) -> f64 {
        let (mut low, mut high) = (0.5, 1.0);
        for _ in 0..f64::MANTISSA_DIGITS {
            let middle = f64::midpoint(low, high);
            if (middle * self.angle).sin() + middle * self.angle.sin() > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        low - 1.0
    }
}

impl ModelEdge {
    /// Positions of its nodes in the cells beside `place` `[rad or mm]`.
    fn beside(&self, place: f64) -> Option<RangeInclusive<usize>> {
        let near = (self.geometry.parameter)
            .partition_point(|&at| at < place - f64::EPSILON * place.abs());
        let last = self.nodes.len().checked_sub(1)?;
        Some(near.saturating_sub(self.order)..=(near + self.order).min(last))
    }

    /// Whether one of `nodes` is in the cells beside `place` `[rad or mm]`.
    pub fn has_beside(&self, nodes: &[usize], place: f64) -> bool {
        let mut beside = self.beside(place).into_iter().flatten();
        beside.any(|k| nodes.contains(&self.nodes[k]))
    }

    /// Whether its largest tangential stress is beside one of `places`, those of its body.
    pub fn peaks_at(&self, places: &[Singular], results: &EdgeResults) -> bool {
        let nodes: Vec<usize> = places.iter().map(|place| place.node()).collect();
        (results.peak_hoop).is_some_and(|(_, place)| self.has_beside(&nodes, place))
    }

    /// The larger tangential stress `[MPa]` of its ends that are among `places`, of those towards which it grows.
    pub fn largest_end(&self, places: &[Singular], results: &EdgeResults) -> Option<f64> {
        let stress = |k: usize| Some(results.rows.get(k)?.sigma_tangential);
        let last = results.rows.len().checked_sub(1)?;
        let at_end = |end: usize, next: usize| {
            let (own, next) = (stress(end)?, stress(next)?);
            let is_one = places.iter().any(|place| place.node() == self.nodes[end]);
            (is_one && own > next && next > 0.0).then_some(own)
        };
        let ends = [
            at_end(0, self.order),
            at_end(last, last.checked_sub(self.order)?),
        ];
        ends.into_iter().flatten().reduce(f64::max)
    }

    /// Which of `corners`, those of its body, its largest tangential stress is beside, and beside none of `supports`, where stress grows towards it: a node at a corner that is pressed
    /// has a stress of the other sign than its neighbours.
    pub fn corner_at_peak(
        &self,
        (supports, corners): (&[Singular], &[ReentrantCorner]),
        results: &EdgeResults,
    ) -> Option<ReentrantCorner> {
        if self.peaks_at(supports, results) {
            return None;
        }
        let rows = &results.rows;
        let pulls = |k: usize| {
            let neighbours = [k.checked_sub(self.order), Some(k + self.order)];
            let mut neighbours = neighbours.into_iter().flatten().filter_map(|k| rows.get(k));
            neighbours.any(|row| row.sigma_tangential > 0.0)
        };
        let at = |k: usize| {
            let corner = corners.iter().find(|own| own.node == self.nodes[k])?;
            pulls(k).then_some(*corner)
        };
        self.beside(results.peak_hoop?.1)?.find_map(at)
    }
}

/// Re-entrant corners of the body with the index `body`, at nodes on the boundary of its mesh.
pub(super) fn corners(plan: &Plan<'_>, body: usize, mesh: &Mesh) -> Vec<ReentrantCorner> {
    let own = &plan.bodies[body];
    let corners = own.shape.reentrant_corners();
    if corners.is_empty() {
        return Vec::new();
    }
    let boundary = mesh.boundary_edges().into_iter();
    let ends: Vec<usize> = boundary.map(|edge| mesh.edge_nodes(edge).ends[0]).collect();
    let [x, y] = own.centre;
    let nearest = |at: Point| {
        let apart = |node: usize| {
            let [u, v] = mesh.nodes()[node];
            (u - x - at[0]).hypot(v - y - at[1])
        };
        let ends = ends.iter().copied();
        ends.min_by(|&a, &b| apart(a).total_cmp(&apart(b)))
    };
    let corner = |(at, angle)| {
        let node = nearest(at)?;
        Some(ReentrantCorner { node, angle })
    };
    corners.into_iter().filter_map(corner).collect()
}

/// Those of the body with the index `body`, half of which is cut at `axis` if only that is modelled.
pub(super) fn places(
    plan: &Plan<'_>,
    body: usize,
    mesh: &Mesh,
    axis: Option<Axis>,
) -> Result<Vec<Singular>, MeshError> {
    let supports = plan.supports_of(body).map(|support| &support.on);
    let springs = plan.springs.iter().filter(|own| own.body == body);
    let at_points = springs
        .filter(|own| own.edge.is_none())
        .map(|own| &own.of.on);
    let loaded = plan
        .loads
        .iter()
        .filter(|load| load.body == body && load.edge.is_none());
    let loaded = loaded.filter_map(|load| match &load.of.kind {
        LoadKind::Force { on, .. } => Some(on),
        _ => None,
    });
    let platens = plan.platens_of(body).map(|platen| &platen.on);
    let mut places = Vec::new();
    let shape = plan.bodies[body].shape;
    for on in supports
        .chain(at_points)
        .chain(loaded)
        .chain(platens)
        .filter(|on| !shape.is_area(&on.set))
    {
        if mesh.edge_set(&on.set).is_err() {
            let nodes = mesh.node_set(&on.set)?.iter();
            places.extend(nodes.map(|&node| Singular::Point(node)));
            continue;
        }
        let path = mesh.edge_path(&on.set)?;
        let ends = ends(&path, mesh, axis);
        places.extend(ends.into_iter().map(|[node, _]| Singular::End(node)));
    }
    Ok(places)
}

/// The nodes of the body with the index `body` at which tractions along its edges end, and others where the boundary goes on without a corner: of forces and pressures, with their load cases, and of springs. At a corner stress then depends on the side from which one
/// comes, and along a smooth edge it has no limit.
pub(super) fn sheared(
    plan: &Plan<'_>,
    body: usize,
    mesh: &Mesh,
    axis: Option<Axis>,
) -> Result<Vec<(usize, Option<usize>)>, MeshError> {
    let loads = plan.loads.iter().enumerate();
    let loads = loads.filter(|(_, load)| load.body == body);
    let forces = loads.filter_map(|(case, load)| match &load.of.kind {
        LoadKind::Force { on, direction, .. } => Some((on, vec![*direction], Some(case))),
        LoadKind::Pressure { on, .. } => Some((on, Vec::new(), Some(case))),
        _ => None,
    });
    let springs = plan.springs.iter().filter(|own| own.body == body);
    let springs = springs.map(|own| (&own.of.on, own.of.hold.directions(), None));
    let mut nodes = Vec::new();
    for (on, directions, case) in forces.chain(springs) {
        if mesh.edge_set(&on.set).is_err() {
            continue;
        }
        let path = mesh.edge_path(&on.set)?;
        for [node, next] in ends(&path, mesh, axis) {
            let [from, to] = [node, next].map(|node| mesh.nodes()[node]);
            let edge = [to[0] - from[0], to[1] - from[1]];
            let along = |of: &[f64; 2]| (of[0] * edge[0] + of[1] * edge[1]).abs();
            let length = edge[0].hypot(edge[1]);
            let is_along = directions.iter().any(|own| along(own) > ALONG * length);
            if is_along || goes_on(mesh, &on.set, node, edge) {
                nodes.push((node, case));
            }
        }
    }
    Ok(nodes)
}

/// Whether the boundary goes on at `node` beyond the edge set `name`, without a corner; `along` is a vector along the edge. A traction that ends there makes stresses jump.
fn goes_on(mesh: &Mesh, name: &str, node: usize, along: [f64; 2]) -> bool {
    let others = mesh.edge_set_names().filter(|other| *other != name);
    let sets = others.filter_map(|other| mesh.edge_set(other).ok());
    let mut edges = sets.flat_map(|set| &set.edges);
    let at = |node: usize| mesh.nodes()[node];
    edges.any(|&edge| {
        let [one, other] = mesh.edge_nodes(edge).ends;
        let far = if node == one { other } else { one };
        if ![one, other].contains(&node) {
            return false;
        }
        let [from, to] = [at(node), at(far)];
        let own = [to[0] - from[0], to[1] - from[1]];
        let [sin, cos] = [
            own[0] * along[1] - own[1] * along[0],
            own[0] * along[0] + own[1] * along[1],
        ];
        // Chords of a curve turn a little.
        cos < 0.0 && sin.abs() < SMOOTH * cos.abs()
    })
}

/// The nodes at the ends of an open edge, each with the next one. On the `axis` of half a model no edge ends.
fn ends(path: &EdgePath, mesh: &Mesh, axis: Option<Axis>) -> Vec<[usize; 2]> {
    let mut ends = match path.nodes[..] {
        [first, second, .., before, last] if !path.closed => vec![[first, second], [last, before]],
        [first, last] if !path.closed => vec![[first, last], [last, first]],
        _ => Vec::new(),
    };
    let [low, high] = mesh.bounding_box();
    let on_axis = |at: Point| {
        axis.is_some_and(|axis| {
            let size = high[axis.coordinate] - low[axis.coordinate];
            (at[axis.coordinate] - axis.at).abs() <= ROUNDING * size
        })
    };
    ends.retain(|end| !on_axis(mesh.nodes()[end[0]]));
    ends
}
