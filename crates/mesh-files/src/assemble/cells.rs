//! The cells in the order of the mesh, and the nodes that they use.

use std::collections::{BTreeMap, BTreeSet};

use stickslip_fem_core::mesh::{ElementBlock, ElementKind, MeshParts};

use crate::error::ReadError;
use crate::note::Note;
use crate::raw::{Numbered, Repeated, Shape};

/// Part of the mesh's extent by which z may vary: coordinates of single precision.
const FLAT: f64 = 1e-6;

/// No node or cell of the mesh.
const NONE: usize = usize::MAX;

/// Where nodes and elements of the file are in the mesh.
#[derive(Debug)]
pub(super) struct Cells {
    /// The element of each cell, in the order of the mesh.
    pub(super) order: Vec<usize>,
    /// The cell of each element, or [`NONE`].
    cell_of: Vec<usize>,
    /// The node of the mesh of each node of the file, or [`NONE`].
    node_of: Vec<usize>,
    /// The node of the file of each node of the mesh.
    pub(super) nodes: Vec<usize>,
}

impl Cells {
    /// Sorts the cells into blocks and drops unused nodes.
    ///
    /// # Errors
    /// [`ReadError::NoCells`], [`ReadError::MixedOrders`], [`ReadError::NotPlane`].
    pub(super) fn new(file: &mut Numbered, merge_twins: bool) -> Result<Self, ReadError> {
        let mut order: Vec<usize> = (0..file.elements.len())
            .filter(|&k| kind(file, k).is_some())
            .collect();
        check_orders(file, &order)?;
        let twins = if merge_twins {
            twins(file, &mut order)
        } else {
            Vec::new()
        };
        order.sort_by_key(|&k| {
            let element = &file.elements[k];
            (rank(file, element.block), kind(file, k))
        });
        let mut cells = Self {
            cell_of: vec![NONE; file.elements.len()],
            node_of: vec![NONE; file.nodes.len()],
            nodes: Vec::new(),
            order,
        };
        for (cell, &element) in cells.order.iter().enumerate() {
            // Elements and nodes are positions in the file's lists, here and below.
            cells.cell_of[element] = cell;
            for &node in file.nodes_of(element) {
                cells.node_of[node] = 0;
            }
        }
        for [twin, kept] in twins {
            cells.cell_of[twin] = cells.cell_of[kept];
        }
        for (node, new) in cells.node_of.iter_mut().enumerate() {
            if *new != NONE {
                *new = cells.nodes.len();
                cells.nodes.push(node);
            }
        }
        cells.note_unused(file);
        cells.check_plane(file)?;
        Ok(cells)
    }

    /// The cell that the element at a position is.
    pub(super) fn cell(&self, element: usize) -> Option<usize> {
        self.cell_of.get(element).copied().filter(|&k| k != NONE)
    }

    /// The node of the mesh that the node at a position is.
    pub(super) fn node(&self, node: usize) -> Option<usize> {
        self.node_of.get(node).copied().filter(|&k| k != NONE)
    }

    /// The file's numbers of nodes and cells.
    pub(super) fn numbers(&self, file: &Numbered) -> (Vec<u64>, Vec<u64>) {
        let nodes = self.nodes.iter().map(|&k| file.nodes[k].number);
        let cells = self.order.iter().map(|&k| file.elements[k].number);
        (nodes.collect(), cells.collect())
    }

    /// Nodes and blocks, without sets.
    pub(super) fn parts(&self, file: &Numbered) -> MeshParts {
        let place = |&k: &usize| {
            let [x, y, _] = file.nodes[k].at;
            [x, y]
        };
        let mut blocks = Vec::<ElementBlock>::new();
        let mut last = None;
        let names = block_names(file, &self.order);
        for &element in &self.order {
            let key = (
                rank(file, file.elements[element].block),
                kind(file, element),
            );
            let (Some(kind), true) = (key.1, blocks.is_empty() || last != Some(key)) else {
                if let Some(block) = blocks.last_mut() {
                    self.push(file, element, block);
                }
                continue;
            };
            last = Some(key);
            let mut block = ElementBlock {
                name: names.get(&key).cloned().unwrap_or_default(),
                kind,
                connectivity: Vec::new(),
            };
            self.push(file, element, &mut block);
            blocks.push(block);
        }
        MeshParts {
            nodes: self.nodes.iter().map(place).collect(),
            blocks,
            ..MeshParts::default()
        }
    }

    fn push(&self, file: &Numbered, element: usize, block: &mut ElementBlock) {
        let nodes = file
            .nodes_of(element)
            .iter()
            .map(|&node| self.node_of[node]);
        block.connectivity.extend(nodes);
    }

    fn note_unused(&self, file: &mut Numbered) {
        let count = file.nodes.len() - self.nodes.len();
        if let Some(first) = self.node_of.iter().position(|&new| new == NONE) {
            let first = file.nodes[first].number;
            file.notes.push(Note::UnusedNodes { count, first });
        }
    }

    fn check_plane(&self, file: &Numbered) -> Result<(), ReadError> {
        let mut nodes = self.nodes.iter().map(|&k| &file.nodes[k]);
        let Some(first) = nodes.clone().next() else {
            return Ok(());
        };
        let (mut low, mut high) = (first.at, first.at);
        for node in nodes.clone() {
            for i in 0..3 {
                low[i] = low[i].min(node.at[i]);
                high[i] = high[i].max(node.at[i]);
            }
        }
        let size = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
        match nodes.find(|node| (node.at[2] - first.at[2]).abs() > FLAT * size) {
            None => Ok(()),
            Some(node) => Err(ReadError::NotPlane {
                at: file.files.place(node.spot),
                node: node.number,
                z: node.at[2],
                first: first.number,
                first_z: first.at[2],
            }),
        }
    }
}

fn kind(file: &Numbered, element: usize) -> Option<ElementKind> {
    match file.elements[element].shape {
        Shape::Cell(kind) => Some(kind),
        Shape::Point | Shape::Line(_) => None,
    }
}

fn rank(file: &Numbered, block: usize) -> u64 {
    file.blocks.get(block).map_or(u64::MAX, |block| block.rank)
}

/// All cells have the order of the first.
fn check_orders(file: &Numbered, cells: &[usize]) -> Result<(), ReadError> {
    let mut all = cells.iter().filter_map(|&k| Some((k, kind(file, k)?)));
    let Some((first, first_kind)) = all.next() else {
        let at = file.files.place(file.end);
        return Err(ReadError::NoCells { at });
    };
    match all.find(|(_, kind)| kind.order() != first_kind.order()) {
        None => Ok(()),
        Some((k, kind)) => Err(ReadError::MixedOrders {
            at: file.place(k),
            element: file.elements[k].number,
            kind,
            other_at: file.place(first),
            other: file.elements[first].number,
            other_kind: first_kind,
        }),
    }
}

/// Takes cells with the same corners as an earlier one out of `cells`: pairs of such a cell and the one that stays.
fn twins(file: &mut Numbered, cells: &mut Vec<usize>) -> Vec<[usize; 2]> {
    let key = |&k: &usize| {
        let corners = kind(file, k).map_or(0, ElementKind::corners);
        let mut key = [NONE; 4];
        for (place, &node) in key.iter_mut().zip(&file.nodes_of(k)[..corners]) {
            *place = node;
        }
        key.sort_unstable();
        (kind(file, k), key, k)
    };
    let mut keys: Vec<_> = cells.iter().map(key).collect();
    keys.sort_unstable();
    let mut twins = Vec::new();
    let mut kept = 0;
    for k in 1..keys.len() {
        if (keys[k].0, keys[k].1) == (keys[kept].0, keys[kept].1) {
            twins.push([keys[k].2, keys[kept].2]);
        } else {
            kept = k;
        }
    }
    if !twins.is_empty() {
        let gone: BTreeSet<usize> = twins.iter().map(|&[twin, _]| twin).collect();
        cells.retain(|k| !gone.contains(k));
        let mut repeated = Repeated::new("element");
        for &twin in &gone {
            repeated.add(file.elements[twin].number);
        }
        file.notes.extend(repeated.note());
    }
    twins
}

type BlockKey = (u64, Option<ElementKind>);

/// A name for each block: that of its group, with the kind behind it if the group has several.
fn block_names(file: &Numbered, cells: &[usize]) -> BTreeMap<BlockKey, String> {
    let mut kinds = BTreeMap::<u64, (usize, BTreeSet<ElementKind>)>::new();
    for &k in cells {
        let block = file.elements[k].block;
        let entry = kinds.entry(rank(file, block)).or_default();
        entry.0 = block;
        entry.1.extend(kind(file, k));
    }
    let mut names = BTreeMap::new();
    for (rank, (block, kinds)) in kinds {
        let group = file.blocks.get(block).map_or("cells", |block| &block.name);
        for &kind in &kinds {
            let name = if kinds.len() == 1 {
                group.to_owned()
            } else {
                format!("{group}-{}", kind.name())
            };
            names.insert((rank, Some(kind)), name);
        }
    }
    names
}
