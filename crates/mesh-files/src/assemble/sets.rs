//! Sets of the file as sets of the mesh.

use std::collections::{BTreeMap, BTreeSet};

use stickslip_fem_core::mesh::{EdgeRef, EdgeSet, Mesh, MeshParts};

use super::cells::Cells;
use super::edges::EdgeTable;
use super::{RawEdge, Sets};
use crate::chain;
use crate::error::ReadError;
use crate::note::Note;
use crate::place::Spot;
use crate::raw::{Numbered, Shape};

/// What the members of sets are looked up in.
pub(super) struct Resolver<'a> {
    pub(super) file: &'a Numbered,
    pub(super) cells: &'a Cells,
    pub(super) mesh: &'a Mesh,
    pub(super) edges: &'a EdgeTable,
    /// Groups whose cells were turned.
    pub(super) turned: &'a BTreeSet<u64>,
    pub(super) notes: Vec<Note>,
}

impl Resolver<'_> {
    /// The sets of the mesh, sorted, each member once.
    ///
    /// # Errors
    /// [`ReadError::Face`], [`ReadError::LineOffCells`].
    pub(super) fn all(&mut self, sets: &Sets) -> Result<MeshParts, ReadError> {
        let mut named = MeshParts::default();
        let cells = self.cells;
        for (name, members) in &sets.nodes {
            let found = self.kept("node", name, members, |k| cells.node(k));
            named.node_sets.extend(found);
        }
        for (name, members) in &sets.elements {
            let found = self.kept("element", name, members, |k| cells.cell(k));
            named.element_sets.extend(found);
        }
        for (name, members) in &sets.edges {
            let edges = self.edge_set(name, members)?;
            if edges.is_empty() {
                let (family, set) = ("edge", name.clone());
                self.notes.push(Note::DroppedSet { family, set });
            } else {
                let set = EdgeSet { edges, curve: None };
                named.edge_sets.insert(name.clone(), set);
            }
        }
        Ok(named)
    }

    /// The members that are in the mesh, with notes on those that are not.
    fn kept(
        &mut self,
        family: &'static str,
        name: &str,
        members: &[usize],
        find: impl Fn(usize) -> Option<usize>,
    ) -> Option<(String, Vec<usize>)> {
        let mut found: Vec<usize> = members.iter().filter_map(|&k| find(k)).collect();
        let (set, lost) = (name.to_owned(), members.len() - found.len());
        if found.is_empty() {
            self.notes.push(Note::DroppedSet { family, set });
            return None;
        }
        if lost > 0 {
            let count = lost;
            self.notes.push(Note::DroppedMembers { family, set, count });
        }
        found.sort_unstable();
        found.dedup();
        Some((name.to_owned(), found))
    }

    fn edge_set(&mut self, name: &str, members: &[RawEdge]) -> Result<Vec<EdgeRef>, ReadError> {
        let mut edges = Vec::with_capacity(members.len());
        for &edge in members {
            match edge {
                RawEdge::Face {
                    element,
                    local,
                    spot,
                } => edges.push(self.face(element, local, spot)?),
                RawEdge::Line { element } => edges.push(self.line(name, element)?),
                RawEdge::Free { element } => self.free(element, &mut edges),
            }
        }
        edges.sort_unstable();
        edges.dedup();
        let inner = |edge: &&EdgeRef| !self.edges.is_boundary(self.mesh.edge_nodes(**edge).ends);
        let count = edges.iter().filter(inner).count();
        if count > 0 {
            let set = name.to_owned();
            self.notes.push(Note::InnerEdges { set, count });
        }
        Ok(edges)
    }

    fn face(&self, element: usize, local: usize, spot: Spot) -> Result<EdgeRef, ReadError> {
        // Positions of elements come from the file's index.
        let raw = &self.file.elements[element];
        let missing = || ReadError::Face {
            at: self.file.files.place(spot),
            element: raw.number,
            face: format!("S{}", local + 1),
        };
        let (Shape::Cell(kind), Some(cell)) = (raw.shape, self.cells.cell(element)) else {
            return Err(missing());
        };
        if local >= kind.edges() {
            return Err(missing());
        }
        let turned = self.turned.contains(&raw.turn);
        let edge = if turned {
            kind.edges() - 1 - local
        } else {
            local
        };
        Ok(EdgeRef {
            element: cell,
            edge,
        })
    }

    fn line(&self, name: &str, element: usize) -> Result<EdgeRef, ReadError> {
        let off = || ReadError::LineOffCells {
            at: self.file.place(element),
            element: self.file.elements[element].number,
            set: name.to_owned(),
        };
        let nodes = self.file.nodes_of(element).iter();
        let nodes: Option<Vec<usize>> = nodes.map(|&k| self.cells.node(k)).collect();
        // The mid node is the last (Gmsh) or the second (CalculiX, and Abaqus files of Gmsh).
        let orders = match nodes.as_deref() {
            Some(&[a, b]) => [Some(([a, b], None)), None],
            Some(&[a, b, c]) => [Some(([a, b], Some(c))), Some(([a, c], Some(b)))],
            _ => [None, None],
        };
        let mut found = orders.into_iter().flatten();
        let found = found.find_map(|(ends, middle)| {
            let edge = self.edges.find(ends)?;
            // A line of order 1 on a quadratic cell names the edge by its ends.
            let inner = self.mesh.edge_nodes(edge).inner.first().copied();
            (middle.is_none() || middle == inner).then_some(edge)
        });
        found.ok_or_else(off)
    }

    fn free(&self, element: usize, edges: &mut Vec<EdgeRef>) {
        let Some(cell) = self.cells.cell(element) else {
            return;
        };
        let kind = self.mesh.element(cell).0;
        edges.extend(
            (0..kind.edges())
                .map(|edge| EdgeRef {
                    element: cell,
                    edge,
                })
                .filter(|&edge| self.edges.is_boundary(self.mesh.edge_nodes(edge).ends)),
        );
    }

    /// Adds an edge set for every node set that is a chain of whole boundary edges and has no edge set of its name.
    pub(super) fn edges_from_nodes(&mut self, named: &mut MeshParts) {
        // Boundary edges by their first node.
        let mut leaving: Vec<(usize, EdgeRef)> = self
            .edges
            .boundary()
            .map(|edge| (self.mesh.edge_nodes(edge).ends[0], edge))
            .collect();
        leaving.sort_unstable();
        let mut member = vec![false; self.mesh.nodes().len()];
        let mut boundary = member.clone();
        for &(_, edge) in &leaving {
            for node in self.mesh.edge_nodes(edge).all() {
                boundary[node] = true;
            }
        }
        let (mut found, mut points) = (BTreeMap::new(), Vec::new());
        for (name, nodes) in &named.node_sets {
            if let Some(own) = named.edge_sets.get(name) {
                let own = own.edges.iter();
                let own = own.flat_map(|&edge| self.mesh.edge_nodes(edge).all());
                if own.collect::<BTreeSet<_>>() != nodes.iter().copied().collect() {
                    let set = name.clone();
                    self.notes.push(Note::OtherNodes { set });
                }
                continue;
            }
            // Resolved nodes are less than the number of nodes.
            for &node in nodes {
                member[node] = true;
            }
            let edges = self.chain_of(nodes, &member, &leaving);
            for &node in nodes {
                member[node] = false;
            }
            if let Some(edges) = edges {
                found.insert(name.clone(), EdgeSet { edges, curve: None });
            } else if nodes.len() > 2 && nodes.iter().all(|&node| boundary[node]) {
                points.push(name.clone());
            }
        }
        if !points.is_empty() {
            self.notes.push(Note::NoEdges { sets: points });
        }
        if !found.is_empty() {
            let sets = found.keys().cloned().collect();
            self.notes.push(Note::EdgesFromNodes { sets });
        }
        named.edge_sets.extend(found);
    }

    /// The boundary edges whose nodes are all in a set, if they form one chain with all of its nodes.
    fn chain_of(
        &self,
        nodes: &[usize],
        member: &[bool],
        leaving: &[(usize, EdgeRef)],
    ) -> Option<Vec<EdgeRef>> {
        let mut edges = Vec::new();
        for &node in nodes {
            let start = leaving.partition_point(|&(first, _)| first < node);
            let own = leaving.iter().skip(start);
            let own = own.take_while(|&&(first, _)| first == node);
            edges.extend(own.map(|&(_, edge)| edge).filter(|&edge| {
                let mut all = self.mesh.edge_nodes(edge).all();
                all.all(|node| member[node])
            }));
        }
        let ends: Vec<[usize; 2]> = edges
            .iter()
            .map(|&edge| self.mesh.edge_nodes(edge).ends)
            .collect();
        let chain = chain::join(&ends)?;
        let order = self.mesh.edge_nodes(*edges.first()?).order();
        let covered = order * edges.len() + usize::from(!chain.closed);
        edges.sort_unstable();
        (covered == nodes.len()).then_some(edges)
    }
}
