//! Chains of boundary edges and their consistent weights.
//!
//! ```text
//! wᵢ = ∫ Nᵢ ds,   Σᵢ wᵢ = length of the chain.
//! ```
//!
//! On an exact arc of radius R an edge from θ₁ to θ₂ has length R |θ₂ − θ₁|, split by Lobatto's weights among its nodes: (½, ½),
//! (⅙, ⁴⁄₆, ⅙), …; otherwise the integral runs over the isoparametric edge.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use super::{Curve, EdgeRef, EdgeSet, Mesh, MeshError, Point};
use crate::element::{EdgeValues, edge_nodes, edge_rule, edge_shape, edge_slope};

/// Angles this far below the full turn count as zero: coordinates of a node at θ = 0 carry rounding.
const ANGLE_ROUNDING: f64 = 1e-9;

/// The edges of a set joined to one chain.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgePath {
    /// Nodes in walk order, the inner ones of edges included; a closed chain does not repeat the first.
    pub nodes: Vec<usize>,
    /// Whether the last edge ends at the first node.
    pub closed: bool,
    /// Edges in walk order. As [`Mesh::edge_path`] returns it the cells are on the walker's left.
    pub edges: Vec<EdgeRef>,
    /// Polynomial order p of the edges. Edge `k` has the nodes `order·k ..= order·(k + 1)`.
    pub order: usize,
}

impl EdgePath {
    /// The same chain walked the other way. A closed chain keeps its first node.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let mut reversed = self.clone();
        reversed.edges.reverse();
        reversed.nodes.reverse();
        if self.closed {
            reversed.nodes.rotate_right(1);
        }
        reversed
    }

    /// Positions in `nodes` of edge `k`, in walk order.
    pub fn positions(&self, k: usize) -> impl Iterator<Item = usize> + Clone + use<> {
        let (start, count) = (self.order * k, self.nodes.len());
        (0..=self.order).map(move |step| (start + step) % count)
    }
}

impl Mesh {
    /// Joins the edges of set `name` to one chain with the cells on the walker's left: counter-clockwise around a body,
    /// clockwise around a hole. A closed chain starts with the set's first edge.
    ///
    /// # Errors
    /// [`MeshError::MissingSet`], [`MeshError::EmptySet`], [`MeshError::MixedOrder`]; [`MeshError::NonManifoldEdge`] if
    /// more than two edges meet at a node, [`MeshError::MixedOrientation`] if the cells change sides,
    /// [`MeshError::DisconnectedEdge`] if the edges form several chains.
    pub fn edge_path(&self, name: &str) -> Result<EdgePath, MeshError> {
        let set = self.edge_set(name)?;
        let order = self.common_order(name, set)?;
        let links = self.links(name, set)?;
        let open = links.iter().find(|(_, link)| link.incoming.is_none());
        let closed = open.is_none();
        let first = open.map_or_else(|| self.edge_nodes(set.edges[0]).ends[0], |(&node, _)| node);

        let mut path = EdgePath {
            nodes: Vec::new(),
            closed,
            edges: Vec::new(),
            order,
        };
        let mut at = first;
        while let Some(k) = links[&at].outgoing {
            let nodes = self.edge_nodes(set.edges[k]);
            path.edges.push(set.edges[k]);
            path.nodes.push(at);
            path.nodes.extend(nodes.inner);
            at = nodes.ends[1];
            if at == first {
                break;
            }
        }
        if !closed {
            path.nodes.push(at);
        }
        if path.edges.len() < set.edges.len() {
            let chains = chain_count(&links, |k| self.edge_nodes(set.edges[k]).ends[1]);
            return Err(MeshError::DisconnectedEdge {
                set: name.to_owned(),
                chains,
            });
        }
        // An inner edge named from both of its cells closes a chain of two edges over the same nodes.
        if let [first, second] = path.edges[..]
            && closed
            && (self.edge_nodes(first).inner.iter()).eq(self.edge_nodes(second).inner.iter().rev())
        {
            let (set, node) = (name.to_owned(), path.nodes[0]);
            return Err(MeshError::MixedOrientation { set, node });
        }
        Ok(path)
    }

    /// The chain walked counter-clockwise about `centre` `[length]`. A closed chain starts at the corner node of smallest
    /// angle in [0, 2π); on the half hole or half disk the walk goes from θ = 0 to θ = π.
    pub fn counter_clockwise(&self, path: &EdgePath, centre: Point) -> EdgePath {
        let swept: f64 = (0..path.edges.len())
            .map(|k| {
                let points = path.positions(k).map(|i| self.nodes()[path.nodes[i]]);
                turn_along(centre, points)
            })
            .sum();
        let mut walk = if swept < 0.0 {
            path.reversed()
        } else {
            path.clone()
        };
        if walk.closed {
            let corner = (0..walk.edges.len())
                .min_by(|&i, &j| {
                    let angle = |k| angle(centre, self.nodes()[walk.nodes[walk.order * k]]);
                    angle(i).total_cmp(&angle(j))
                })
                .unwrap_or(0);
            walk.nodes.rotate_left(walk.order * corner);
            walk.edges.rotate_left(corner);
        }
        walk
    }

    /// Angle `[rad]` of each node of the chain about `centre` `[length]`, continuous along the walk; the first is in [0, 2π).
    pub fn angles(&self, path: &EdgePath, centre: Point) -> Vec<f64> {
        let points = || path.nodes.iter().map(|&node| self.nodes()[node]);
        let mut angles = Vec::with_capacity(path.nodes.len());
        let mut previous: Option<(Point, f64)> = None;
        for point in points() {
            let value = previous.map_or_else(
                || angle(centre, point),
                |(before, value)| value + turn(centre, before, point),
            );
            angles.push(value);
            previous = Some((point, value));
        }
        angles
    }

    /// Consistent weights ∫ Nᵢ ds `[length]` of the chain's nodes, in its order. On [`Curve::Arc`] with the true length of
    /// each edge's arc, otherwise on the isoparametric edges.
    pub fn edge_weights(&self, path: &EdgePath, curve: Option<Curve>) -> Vec<f64> {
        let mut weights = vec![0.0; path.nodes.len()];
        for k in 0..path.edges.len() {
            let x: Vec<Point> = (path.positions(k))
                .map(|i| self.nodes()[path.nodes[i]])
                .collect();
            let edge = match curve {
                Some(Curve::Arc { centre, radius }) => {
                    let length = radius * turn_along(centre, x.iter().copied()).abs();
                    straight_edge_weights(path.order, length)
                }
                _ if path.order == 1 => {
                    straight_edge_weights(1, (x[1][0] - x[0][0]).hypot(x[1][1] - x[0][1]))
                }
                _ => curved_edge_weights(&x),
            };
            for (position, weight) in path.positions(k).zip(edge) {
                weights[position] += weight;
            }
        }
        weights
    }

    fn common_order(&self, name: &str, set: &EdgeSet) -> Result<usize, MeshError> {
        let order = |edge: &EdgeRef| self.element(edge.element).0.order();
        let mut orders = set.edges.iter().map(order);
        let first = orders.next().ok_or_else(|| MeshError::EmptySet {
            set: name.to_owned(),
        })?;
        if orders.any(|other| other != first) {
            return Err(MeshError::MixedOrder {
                set: name.to_owned(),
            });
        }
        Ok(first)
    }

    /// For every end node the edge that leaves it and the edge that arrives.
    fn links(&self, name: &str, set: &EdgeSet) -> Result<BTreeMap<usize, Link>, MeshError> {
        let mut degree = BTreeMap::<usize, usize>::new();
        let mut links = BTreeMap::<usize, Link>::new();
        let mut clash = None;
        for (k, &edge) in set.edges.iter().enumerate() {
            let [start, end] = self.edge_nodes(edge).ends;
            *degree.entry(start).or_default() += 1;
            *degree.entry(end).or_default() += 1;
            let taken = [
                (start, links.entry(start).or_default().outgoing.replace(k)),
                (end, links.entry(end).or_default().incoming.replace(k)),
            ];
            clash = clash.or(taken.into_iter().find_map(|(node, old)| old.map(|_| node)));
        }
        if let Some((&node, &edges)) = degree.iter().find(|(_, edges)| **edges > 2) {
            return Err(MeshError::NonManifoldEdge {
                set: name.to_owned(),
                node,
                edges,
            });
        }
        match clash {
            Some(node) => Err(MeshError::MixedOrientation {
                set: name.to_owned(),
                node,
            }),
            None => Ok(links),
        }
    }
}

#[derive(Clone, Copy, Default)]
struct Link {
    outgoing: Option<usize>,
    incoming: Option<usize>,
}

/// Number of chains: one per loose start, and the loops that remain.
fn chain_count(links: &BTreeMap<usize, Link>, end_of: impl Fn(usize) -> usize) -> usize {
    let mut rest = links.clone();
    let mut chains = 0;
    let loose = links
        .iter()
        .filter(|(_, link)| link.incoming.is_none())
        .map(|(&node, _)| node);
    for start in loose.chain(links.keys().copied()) {
        let mut next = rest.remove(&start).and_then(|link| link.outgoing);
        chains += usize::from(next.is_some());
        while let Some(edge) = next {
            next = rest.remove(&end_of(edge)).and_then(|link| link.outgoing);
        }
    }
    chains
}

/// ∫ Nᵢ ds on an edge of `order` whose points move evenly along its `length`.
fn straight_edge_weights(order: usize, length: f64) -> EdgeValues {
    let mut weights = EdgeValues::default();
    match order {
        1 => weights[..2].fill(length / 2.0),
        2 => weights[..3].copy_from_slice(&[length / 6.0, length * 4.0 / 6.0, length / 6.0]),
        _ => {
            let nodes = edge_nodes(order).unwrap_or_default();
            for (sum, (_, weight)) in weights.iter_mut().zip(nodes) {
                *sum = length * weight / 2.0;
            }
        }
    }
    weights
}

/// ∫ Nᵢ |dx/dξ| dξ on the edge through the points `x`.
fn curved_edge_weights(x: &[Point]) -> EdgeValues {
    let order = x.len() - 1;
    let mut weights = EdgeValues::default();
    for &(xi, weight) in edge_rule(order) {
        let (shape, slope) = (edge_shape(order, xi), edge_slope(order, xi));
        let along = |i: usize| {
            x.iter()
                .zip(slope)
                .map(|(p, slope)| slope * p[i])
                .sum::<f64>()
        };
        let speed = along(0).hypot(along(1));
        for (sum, value) in weights.iter_mut().zip(shape) {
            *sum += value * speed * weight;
        }
    }
    weights
}

/// Signed angle from `a` to `b` seen from `centre`, in (−π, π].
fn turn(centre: Point, a: Point, b: Point) -> f64 {
    let [a, b] = [a, b].map(|p| [p[0] - centre[0], p[1] - centre[1]]);
    (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1])
}

/// Sum of the signed angles from each of `points` to the next.
fn turn_along(centre: Point, points: impl Iterator<Item = Point> + Clone) -> f64 {
    (points.clone().zip(points.skip(1)))
        .map(|(a, b)| turn(centre, a, b))
        .sum()
}

/// Angle of `point` about `centre` in [0, 2π).
fn angle(centre: Point, point: Point) -> f64 {
    let angle = (point[1] - centre[1]).atan2(point[0] - centre[0]);
    if angle < -ANGLE_ROUNDING {
        angle + TAU
    } else {
        angle.max(0.0)
    }
}
