//! The boundary of a mesh, and its corners.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use super::{EdgeRef, Mesh};

// Measured: circles, slots and splines of 8 to 24 chords have no corners, notches of 196° and more have one.
/// Largest turn `[rad]` of the boundary between chords of a curve: that of a circle of eight, π/4.
const CHORD: f64 = 0.8;
/// Least turn `[rad]` of a corner, 10°.
const LEAST: f64 = 0.17;
/// Least ratio of the turn of a corner to those of the two nodes on either side.
const SHARPER: f64 = 3.0;

impl Mesh {
    /// The edges of one cell only, in the order of the cells.
    pub fn boundary_edges(&self) -> Vec<EdgeRef> {
        let mut all = Vec::new();
        for element in 0..self.element_count() {
            for edge in 0..self.element(element).0.edges() {
                let edge = EdgeRef { element, edge };
                let [a, b] = self.edge_nodes(edge).ends;
                all.push(([a.min(b), a.max(b)], edge));
            }
        }
        all.sort_unstable();
        let same = all.chunk_by(|one, other| one.0 == other.0);
        let mut edges: Vec<EdgeRef> = same
            .filter_map(|own| match own {
                &[(_, edge)] => Some(edge),
                _ => None,
            })
            .collect();
        edges.sort_unstable();
        edges
    }

    /// Angle of the material around a corner node: the sum of those of its cells `[rad]`. A node inside has 2π, on a smooth boundary π; along curved edges the
    /// directions are those to the next nodes. 0 for a node that no cell has as a corner.
    pub fn angle_at(&self, node: usize) -> f64 {
        let corners = (0..self.element_count()).flat_map(|element| self.corners_of(element));
        let own = corners.filter(|&(corner, _)| corner == node);
        own.map(|(_, angle)| angle).sum()
    }

    /// Corners of the boundary at which the material reaches over more than π, in the order of their nodes, each with its angle `[rad]`. Ends of chords that approximate a
    /// curve are not corners: a corner turns by more than those of a circle of eight chords, or by three times what the boundary turns at the two nodes on either side.
    pub fn reentrant_corners(&self) -> Vec<(usize, f64)> {
        let mut angles = vec![0.0; self.nodes().len()];
        for (node, angle) in (0..self.element_count()).flat_map(|element| self.corners_of(element))
        {
            angles[node] += angle;
        }
        let mut neighbours = BTreeMap::<usize, Vec<usize>>::new();
        for edge in self.boundary_edges() {
            let [a, b] = self.edge_nodes(edge).ends;
            neighbours.entry(a).or_default().push(b);
            neighbours.entry(b).or_default().push(a);
        }
        let turn = |node: usize| angles[node] - PI;
        let is_corner = |&(&node, beside): &(&usize, &Vec<usize>)| {
            // Where two parts of the boundary touch, angles of both are in the sum.
            let &[one, other] = &beside[..] else {
                return false;
            };
            let next = [one, other].into_iter();
            let around = next.flat_map(|near| neighbours[&near].iter().copied().chain([near]));
            let chords = around
                .filter(|&near| near != node)
                .map(|near| turn(near).abs());
            let chords = chords.fold(0.0, f64::max);
            turn(node) > CHORD || turn(node) > LEAST.max(SHARPER * chords)
        };
        let corners = neighbours.iter().filter(is_corner);
        corners.map(|(&node, _)| (node, angles[node])).collect()
    }

    /// The corners of a cell with its angle there `[rad]`.
    fn corners_of(&self, element: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let (kind, nodes, _) = self.element(element);
        let count = kind.corners();
        (0..count).filter_map(move |corner| {
            let node = nodes[corner];
            let walk = |edge: usize| self.edge_nodes(EdgeRef { element, edge }).walk();
            let next = walk(corner).nth(1)?;
            let before = walk((corner + count - 1) % count).nth_back(1)?;
            let way =
                |to: usize| [0, 1].map(|axis| self.nodes()[to][axis] - self.nodes()[node][axis]);
            let ([a, b], [c, d]) = (way(next), way(before));
            Some((node, (a * d - b * c).atan2(a * c + b * d)))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::{ElementBlock, ElementKind, MeshParts};
    use super::*;

    /// Cells of a grid of 4 × 4 squares of size 1, without those of `holes`.
    fn grid(holes: &[usize]) -> Mesh {
        let nodes = (0..25).map(|k| [f64::from(k % 5), f64::from(k / 5)]);
        let cells = (0..16).filter(|cell| !holes.contains(cell));
        let corners = cells.flat_map(|cell| {
            let at = cell % 4 + 5 * (cell / 4);
            [at, at + 1, at + 6, at + 5]
        });
        Mesh::new(MeshParts {
            nodes: nodes.collect(),
            blocks: vec![ElementBlock {
                name: "cells".into(),
                kind: ElementKind::Q4,
                connectivity: corners.collect(),
            }],
            ..MeshParts::default()
        })
        .unwrap()
    }

    #[test]
    fn notches_have_corners_and_squares_have_none() {
        assert!(grid(&[]).reentrant_corners().is_empty());
        let around = grid(&[5]).reentrant_corners();
        let nodes: Vec<usize> = around.iter().map(|own| own.0).collect();
        assert_eq!(nodes, [6, 7, 11, 12]);
        assert!(around.iter().all(|own| (own.1 - 1.5 * PI).abs() < 1e-12));
        assert!((grid(&[5]).angle_at(6) - 1.5 * PI).abs() < 1e-12);
        // Two holes that touch at a node: it belongs to both.
        let touching = grid(&[5, 10]).reentrant_corners();
        assert!(touching.iter().all(|own| own.0 != 12) && touching.len() == 6);
    }
}
