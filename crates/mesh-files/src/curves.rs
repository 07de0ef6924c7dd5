//! Curves of the edge sets of a mesh: which one a set approximates, and its mid nodes moved onto it.

use stickslip_fem_core::mesh::{Curve, EdgeRef, ElementKind, Mesh, MeshParts, Point};

use crate::chain;
use crate::error::CurveError;
use crate::pieces::recognise_pieces;
use crate::quality;
use crate::recognise::{NEARLY, Recognised, best_circle, nearly_circle, recognise};

/// Part of the radius by which a mid node is off the circle because of rounding only.
const ROUNDING: f64 = 1e-14;
/// Part of the radius by which a point that a file gives on a circle may miss it.
const DIGITS: f64 = 1e-6;

/// Finds the line or circle that edge set `set` of a mesh lies on, by [`recognise`].
///
/// # Errors
/// [`CurveError::MissingSet`]; [`CurveError::NoChain`] if its edges do not form one chain; [`CurveError::NoCurve`].
pub fn recognise_set(parts: &MeshParts, set: &str) -> Result<Recognised, CurveError> {
    let Walk {
        nodes,
        closed,
        order,
    } = Walk::of(parts, set)?;
    let found = recognise(&parts.nodes, &nodes, closed, order);
    let set = set.to_owned();
    found.ok_or(CurveError::NoCurve { set })
}

/// The nodes of an edge set in order.
struct Walk {
    nodes: Vec<usize>,
    closed: bool,
    order: usize,
}

impl Walk {
    fn of(parts: &MeshParts, set: &str) -> Result<Self, CurveError> {
        let edges = edges(parts, set)?;
        let ends: Option<Vec<[usize; 2]>> = edges.iter().map(Edge::ends).collect();
        let chain = ends.and_then(|ends| chain::join(&ends));
        let (Some(chain), Some(first)) = (chain, edges.first()) else {
            let set = set.to_owned();
            return Err(CurveError::NoChain { set });
        };
        let order = first.kind.order();
        if edges.iter().any(|edge| edge.kind.order() != order) {
            let set = set.to_owned();
            return Err(CurveError::NoChain { set });
        }
        let mut nodes = Vec::with_capacity(order * edges.len() + 1);
        let mut last = None;
        // The chain holds positions of edges.
        for edge in chain.order.iter().map(|&k| &edges[k]) {
            nodes.extend(edge.ends().map(|[start, _]| start));
            nodes.extend(edge.inner());
            last = edge.ends().map(|[_, end]| end);
        }
        if !chain.closed {
            nodes.extend(last);
        }
        Ok(Self {
            nodes,
            closed: chain.closed,
            order,
        })
    }
}

/// Moves the mid nodes of the arcs of edge set `set`, an open chain of lines and arcs, from the chords of its edges onto them, and returns how many were moved; none
/// of other sets.
///
/// # Errors
/// [`CurveError::MissingSet`]; [`CurveError::NoChain`] if its edges do not form one chain.
pub fn snap_pieces(parts: &mut MeshParts, set: &str) -> Result<usize, CurveError> {
    let walk = Walk::of(parts, set)?;
    let open = (!walk.closed).then_some(&walk.nodes);
    let pieces = open.and_then(|nodes| recognise_pieces(&parts.nodes, nodes, walk.order));
    let mut moved = 0;
    for piece in pieces.into_iter().flatten() {
        let Curve::Arc { centre, radius } = piece.curve else {
            continue;
        };
        for position in piece.nodes.filter(|position| position % walk.order != 0) {
            if let Some(point) = parts.nodes.get_mut(walk.nodes[position]) {
                moved += usize::from(project(point, centre, radius));
            }
        }
    }
    Ok(moved)
}

/// Moves the mid nodes of edge set `set` from the chords of its edges onto the circle that its corner nodes lie on, and stores the curve in
/// the set. Returns how many were moved.
///
/// The circle is the set's own curve, or found by [`recognise_set`]; the nodes of a line stay. A thin cell inside a concave arc may be
/// folded by the motion: [`Mesh::new`](stickslip_fem_core::mesh::Mesh::new) finds it.
///
/// # Errors
/// As [`recognise_set`], if the set has no curve yet.
pub fn snap(parts: &mut MeshParts, set: &str) -> Result<usize, CurveError> {
    let own = parts.edge_sets.get(set).and_then(|set| set.curve);
    let curve = match own {
        Some(curve) => curve,
        None => recognise_set(parts, set)?.curve,
    };
    let mut moved = 0;
    if let Curve::Arc { centre, radius } = curve {
        let edges = edges(parts, set)?;
        let middles: Vec<usize> = edges.iter().flat_map(Edge::inner).collect();
        for node in middles {
            if let Some(point) = parts.nodes.get_mut(node) {
                moved += usize::from(project(point, centre, radius));
            }
        }
    }
    if let Some(set) = parts.edge_sets.get_mut(set) {
        set.curve = Some(curve);
    }
    Ok(moved)
}

/// A declared circle whose nodes were put onto it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PutOnCircle {
    /// The circle, and the farthest way of a corner node onto it `[length]`.
    pub circle: Recognised,
    /// Radius of the circle of least squares through the corner nodes `[length]`.
    pub fitted: f64,
    /// The farthest way of a corner node from that one `[length]`.
    pub scatter: f64,
    /// How many of its nodes were moved.
    pub moved: usize,
}

/// Moves all nodes of each of the edge sets `names`, closed chains, onto the circle of least squares through its corner nodes
/// ([`nearly_circle`]), and stores the circles in the sets: for edges that are known to be circles, although their file does not give them to the
/// digits that [`recognise_set`] asks for. `radii` `[length]` are those of the circles, one for each of `names`, or empty: then they are those of
/// the fits. Returns one entry for each of `names`.
///
/// # Errors
/// [`CurveError::MissingSet`]; [`CurveError::NoChain`] if the edges of a set do not form one chain; [`CurveError::Open`]; [`CurveError::NoCircle`]; [`CurveError::Radii`]; [`CurveError::Twice`];
/// [`CurveError::OtherRadius`] if one is off the fit by more than corner nodes may be; [`CurveError::Squeezed`] if a cell folds, or gets a shape for which a file is refused.
pub fn put_on_circles(
    parts: &mut MeshParts,
    names: &[String],
    radii: &[f64],
) -> Result<Vec<PutOnCircle>, CurveError> {
    if !radii.is_empty() && radii.len() != names.len() {
        let (circles, radii) = (names.len(), radii.len());
        return Err(CurveError::Radii { circles, radii });
    }
    let is_before = |(k, set): &(usize, &String)| names[..*k].contains(set);
    let named = names.iter().enumerate();
    if let Some((_, set)) = named.clone().find(is_before) {
        let set = set.clone();
        return Err(CurveError::Twice { set });
    }
    let put = named.map(|(k, set)| put_on_circle(parts, set, radii.get(k).copied()));
    let put: Vec<_> = put.collect::<Result<_, _>>()?;
    if !names.is_empty() && are_squeezed(parts) {
        let sets = names.join("', '");
        return Err(CurveError::Squeezed { sets });
    }
    Ok(put)
}

/// Whether cells fold, or have a shape for which a file is refused.
fn are_squeezed(parts: &MeshParts) -> bool {
    let mut flaws = quality::of_cells(&parts.nodes, &parts.blocks).flatten();
    flaws.any(quality::Flaw::is_refused) || Mesh::new(parts.clone()).is_err()
}

fn put_on_circle(
    parts: &mut MeshParts,
    set: &str,
    given: Option<f64>,
) -> Result<PutOnCircle, CurveError> {
    let name = || set.to_owned();
    let walk = Walk::of(parts, set)?;
    if !walk.closed {
        return Err(CurveError::Open { set: name() });
    }
    let corners = walk.nodes.iter().step_by(walk.order);
    let corners: Vec<Point> = corners
        .filter_map(|&k| parts.nodes.get(k).copied())
        .collect();
    let mut circle = nearly_circle(&corners).ok_or_else(|| {
        let [radius, off, step] = best_circle(&corners);
        CurveError::NoCircle {
            set: name(),
            radius,
            off,
            step,
        }
    })?;
    let (mut moved, mut fitted, scatter) = (0, 0.0, circle.residual);
    if let Curve::Arc { centre, radius } = &mut circle.curve {
        fitted = *radius;
        let (centre, radius) = (*centre, with_given(set, radius, given)?);
        circle.residual = farthest(&corners, centre, radius);
        for node in walk.nodes {
            if let Some(point) = parts.nodes.get_mut(node) {
                moved += usize::from(project(point, centre, radius));
            }
        }
    }
    if let Some(own) = parts.edge_sets.get_mut(set) {
        own.curve = Some(circle.curve);
    }
    Ok(PutOnCircle {
        circle,
        fitted,
        scatter,
        moved,
    })
}

/// Makes a `radius` the `given` one, and returns it.
fn with_given(set: &str, radius: &mut f64, given: Option<f64>) -> Result<f64, CurveError> {
    if let Some(given) = given {
        let is_near = (given - *radius).abs() <= NEARLY * *radius;
        if !is_near {
            let (set, found) = (set.to_owned(), *radius);
            return Err(CurveError::OtherRadius { set, found, given });
        }
        *radius = given;
    }
    Ok(*radius)
}

/// The farthest way of a point from a circle.
fn farthest(points: &[Point], centre: Point, radius: f64) -> f64 {
    let off = |p: &Point| ((p[0] - centre[0]).hypot(p[1] - centre[1]) - radius).abs();
    points.iter().map(off).fold(0.0, f64::max)
}

/// Moves a point along its ray onto a circle, and returns whether it was not there but for the digits of its file.
fn project(point: &mut Point, centre: Point, radius: f64) -> bool {
    let ray = [point[0] - centre[0], point[1] - centre[1]];
    let distance = ray[0].hypot(ray[1]);
    if distance == 0.0 || (distance - radius).abs() <= ROUNDING * radius {
        return false;
    }
    let factor = radius / distance;
    *point = [centre[0] + factor * ray[0], centre[1] + factor * ray[1]];
    (distance - radius).abs() > DIGITS * radius
}

/// An edge and the nodes of its cell.
struct Edge<'a> {
    kind: ElementKind,
    nodes: &'a [usize],
    local: usize,
}

impl Edge<'_> {
    fn ends(&self) -> Option<[usize; 2]> {
        let [a, b] = self.kind.edge_nodes(self.local).ends;
        Some([*self.nodes.get(a)?, *self.nodes.get(b)?])
    }

    fn inner(&self) -> impl Iterator<Item = usize> + use<> {
        let inner = self.nodes.get(self.kind.edge_nodes(self.local).inner);
        inner.unwrap_or_default().to_vec().into_iter()
    }
}

fn edges<'a>(parts: &'a MeshParts, set: &str) -> Result<Vec<Edge<'a>>, CurveError> {
    let name = || set.to_owned();
    let found = parts.edge_sets.get(set);
    let found = found.ok_or_else(|| CurveError::MissingSet { set: name() })?;
    let mut firsts = vec![0];
    for block in &parts.blocks {
        let count = block.connectivity.len() / block.kind.nodes();
        firsts.push(firsts.last().copied().unwrap_or(0) + count);
    }
    let edge = |edge: &EdgeRef| {
        let block = firsts.partition_point(|&first| first <= edge.element) - 1;
        let cells = parts.blocks.get(block)?;
        let size = cells.kind.nodes();
        let start = (edge.element - firsts[block]) * size;
        let nodes = cells.connectivity.get(start..start + size)?;
        let is_edge = edge.edge < cells.kind.edges();
        is_edge.then_some(Edge {
            kind: cells.kind,
            nodes,
            local: edge.edge,
        })
    };
    let all: Option<Vec<Edge<'_>>> = found.edges.iter().map(edge).collect();
    all.ok_or_else(|| CurveError::NoChain { set: name() })
}
