//! Numbering of nodes with coincident ones merged.
//!
//! Only nodes on the rim of a block can coincide. Two are the same if they are closer than a millionth of the smallest rim
//! spacing, which is far above rounding and far below any cell. The first one numbered stays, so the result depends on the
//! order of the blocks alone.

use std::collections::HashMap;

use super::lattice::{Lattice, NodeKind};
use crate::mesh::Point;

/// Share of the smallest spacing within which nodes are the same.
const RELATIVE_TOLERANCE: f64 = 1e-6;

pub(super) struct Merger {
    /// Nodes numbered so far.
    pub(super) nodes: Vec<Point>,
    tolerance: f64,
    /// Rim nodes by square of side `tolerance`.
    squares: HashMap<[i64; 2], Vec<usize>>,
}

impl Merger {
    pub(super) fn new(lattices: &[Lattice]) -> Self {
        let spacing = lattices
            .iter()
            .map(Lattice::rim_spacing)
            .fold(f64::INFINITY, f64::min);
        let tolerance = if spacing.is_finite() {
            RELATIVE_TOLERANCE * spacing
        } else {
            0.0
        };
        Self {
            nodes: Vec::new(),
            tolerance,
            squares: HashMap::new(),
        }
    }

    /// Node number of every lattice index; positions without a node get one past the largest number.
    pub(super) fn number(&mut self, lattice: &Lattice) -> Vec<usize> {
        let number = |(k, &at)| match lattice.node_kind(k) {
            NodeKind::None => usize::MAX,
            NodeKind::Rim => self.merged(at),
            NodeKind::Interior => self.push(at),
        };
        lattice.points().iter().enumerate().map(number).collect()
    }

    fn push(&mut self, at: Point) -> usize {
        self.nodes.push(at);
        self.nodes.len() - 1
    }

    fn merged(&mut self, at: Point) -> usize {
        // The cast saturates; points that share a square wrongly are still distinguished by their distance.
        let square = at.map(|c| (c / self.tolerance).floor() as i64);
        let near = |node: usize| {
            let other = self.nodes[node];
            (other[0] - at[0]).hypot(other[1] - at[1]) <= self.tolerance
        };
        let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| [dx, dy]));
        let candidates = around.filter_map(|[dx, dy]| {
            let key = [square[0].saturating_add(dx), square[1].saturating_add(dy)];
            self.squares.get(&key)
        });
        if let Some(node) = candidates
            .flatten()
            .copied()
            .filter(|&node| near(node))
            .min()
        {
            return node;
        }
        let node = self.push(at);
        self.squares.entry(square).or_default().push(node);
        node
    }
}
