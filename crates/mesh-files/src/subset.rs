//! One body of a file that holds several.

use std::collections::BTreeMap;

use stickslip_fem_core::mesh::{EdgeRef, EdgeSet, ElementBlock, MeshParts};

use crate::imported::Imported;
use crate::note::Note;

/// An index that is not kept.
const NONE: usize = usize::MAX;

impl Imported {
    /// Keeps the cells of the element set `set`, their nodes, and what the other sets have of both; `None` where there is no such set.
    pub fn only(&self, set: &str) -> Option<Self> {
        let kept = self.parts.element_sets.get(set)?;
        let mut cells = vec![NONE; self.cell_numbers.len()];
        let mut nodes = vec![NONE; self.node_numbers.len()];
        let mut own = Self {
            parts: MeshParts::default(),
            node_numbers: Vec::new(),
            cell_numbers: Vec::new(),
            notes: Vec::new(),
        };
        let mut first = 0;
        for block in &self.parts.blocks {
            let size = block.kind.nodes();
            let mut chosen = kept.iter().map(|cell| cell.wrapping_sub(first));
            let count = block.connectivity.len() / size;
            let mut connectivity = Vec::new();
            for cell in chosen.by_ref().filter(|&cell| cell < count) {
                cells[first + cell] = own.cell_numbers.len();
                own.cell_numbers.push(self.cell_numbers[first + cell]);
                connectivity.extend_from_slice(&block.connectivity[cell * size..][..size]);
            }
            for &node in &connectivity {
                nodes[node] = 0;
            }
            if !connectivity.is_empty() {
                own.parts.blocks.push(ElementBlock {
                    connectivity,
                    ..block.clone()
                });
            }
            first += count;
        }
        own.renumber_nodes(self, &mut nodes);
        own.parts.node_sets = kept_of(&self.parts.node_sets, &nodes);
        own.parts.element_sets = kept_of(&self.parts.element_sets, &cells);
        own.parts.edge_sets = edges_of(&self.parts.edge_sets, &cells);
        let of_file = |note: &&Note| !matches!(note, Note::Flawed { .. });
        own.notes = self.notes.iter().filter(of_file).cloned().collect();
        let parts = &own.parts;
        let shapes = Note::on_shapes(&parts.nodes, &parts.blocks, &own.cell_numbers);
        own.notes.extend(shapes);
        Some(own)
    }

    /// Numbers the nodes of `all` that `nodes` marks, in their order.
    fn renumber_nodes(&mut self, all: &Self, nodes: &mut [usize]) {
        for (node, index) in nodes.iter_mut().enumerate() {
            if *index != NONE {
                *index = self.node_numbers.len();
                self.node_numbers.push(all.node_numbers[node]);
                self.parts.nodes.push(all.parts.nodes[node]);
            }
        }
        for block in &mut self.parts.blocks {
            block
                .connectivity
                .iter_mut()
                .for_each(|node| *node = nodes[*node]);
        }
    }
}

/// What is left of each set, with the new indices; sets of which nothing is left are dropped.
fn kept_of(sets: &BTreeMap<String, Vec<usize>>, index: &[usize]) -> BTreeMap<String, Vec<usize>> {
    let rest = |(name, members): (&String, &Vec<usize>)| {
        let own = members.iter().map(|&member| index[member]);
        let own: Vec<usize> = own.filter(|&member| member != NONE).collect();
        (!own.is_empty()).then(|| (name.clone(), own))
    };
    sets.iter().filter_map(rest).collect()
}

fn edges_of(sets: &BTreeMap<String, EdgeSet>, cells: &[usize]) -> BTreeMap<String, EdgeSet> {
    let rest = |(name, set): (&String, &EdgeSet)| {
        let own = set.edges.iter().map(|edge| EdgeRef {
            element: cells[edge.element],
            edge: edge.edge,
        });
        let edges: Vec<EdgeRef> = own.filter(|edge| edge.element != NONE).collect();
        let curve = set.curve;
        (!edges.is_empty()).then(|| (name.clone(), EdgeSet { edges, curve }))
    };
    sets.iter().filter_map(rest).collect()
}
