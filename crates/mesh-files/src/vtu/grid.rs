//! The one piece of an unstructured grid: its points and cells.

use roxmltree::{Document, Node};

use super::arrays::{self, Array, Layout};
use super::types;
use crate::error::ReadError;
use crate::place::{Files, Place, Spot};
use crate::raw::{Raw, RawBlock};

/// Most nodes of a cell that is read.
const MOST_NODES: usize = 9;

/// Line `line` of the text.
pub(super) fn place(line: u32) -> Place {
    Files::default().place(Spot { file: 0, line })
}

/// The one piece of a grid, with what its arrays have in common.
pub(super) struct Grid<'a> {
    document: &'a Document<'a>,
    piece: Node<'a, 'a>,
    layout: Layout,
    pub(super) points: usize,
    pub(super) cells: usize,
    /// Most numbers of a packed array, and most members of all sets: far more than a text of this length can hold points and cells.
    pub(super) most: usize,
}

impl<'a> Grid<'a> {
    pub(super) fn new(document: &'a Document<'a>) -> Result<Self, ReadError> {
        let file = document.root_element();
        let kind = file.attribute("type").unwrap_or_default();
        if !file.has_tag_name("VTKFile") || kind != "UnstructuredGrid" {
            return Err(ReadError::Format {
                at: place(1),
                format: "VTK with an unstructured grid",
                found: format!("<{} type=\"{kind}\">", file.tag_name().name()),
            });
        }
        let layout = Layout::of(file).map_err(|what| what.at(place(1)))?;
        let mut pieces = file
            .children()
            .filter(|node| node.has_tag_name("UnstructuredGrid"))
            .flat_map(|grid| grid.children())
            .filter(|node| node.has_tag_name("Piece"));
        let first = pieces.next();
        let Some(piece) = first else {
            let (at, what) = (line_of(document, file), "a piece with points and cells");
            return Err(ReadError::Truncated { at, what });
        };
        if let Some(second) = pieces.next() {
            let at = line_of(document, second);
            return Err(ReadError::Partitioned { at });
        }
        let count = |name: &str, what: &'static str| {
            let found = piece.attribute(name).unwrap_or_default();
            found.trim().parse().map_err(|_| ReadError::Value {
                at: line_of(document, piece),
                what,
                found: found.to_owned(),
            })
        };
        Ok(Self {
            document,
            piece,
            layout,
            most: 16 * document.input_text().len() + (1 << 16),
            points: count("NumberOfPoints", "the number of points")?,
            cells: count("NumberOfCells", "the number of cells")?,
        })
    }

    pub(super) fn place(&self, node: Node<'_, '_>) -> Place {
        line_of(self.document, node)
    }

    fn spot(&self, node: Node<'_, '_>) -> Spot {
        Spot {
            file: 0,
            line: self.place(node).line as u32,
        }
    }

    /// Arrays in the part `name` of the piece.
    pub(super) fn arrays(&self, name: &'static str) -> impl Iterator<Item = Node<'a, 'a>> {
        let parts = self.piece.children();
        let parts = parts.filter(move |node| node.has_tag_name(name));
        parts
            .flat_map(|part| part.children())
            .filter(|node| node.has_tag_name("DataArray"))
    }

    /// The numbers of an array, `count` at most.
    pub(super) fn array(&self, node: Node<'_, '_>, count: usize) -> Result<Array, ReadError> {
        let most = count.min(self.most);
        arrays::read(node, self.layout, most).map_err(|what| what.at(self.place(node)))
    }

    /// The integers of the array `name` among those of the cells, `count` at most.
    fn integers(
        &self,
        name: &'static str,
        what: &'static str,
        count: usize,
    ) -> Result<(Node<'a, 'a>, Vec<i64>), ReadError> {
        let mut all = self.arrays("Cells");
        let found = all.find(|node| node.attribute("Name") == Some(name));
        let missing = |node| ReadError::MissingValue {
            at: self.place(node),
            what,
        };
        let node = found.ok_or_else(|| missing(self.piece))?;
        match self.array(node, count)? {
            Array::Integers(values) => Ok((node, values)),
            Array::Reals(_) => Err(missing(node)),
        }
    }

    pub(super) fn nodes(&self, raw: &mut Raw) -> Result<(), ReadError> {
        const WHAT: &str = "three coordinates of every point";
        let missing = |node| ReadError::MissingValue {
            at: self.place(node),
            what: WHAT,
        };
        let node = self.arrays("Points").next();
        let node = node.ok_or_else(|| missing(self.piece))?;
        let count = self.points.saturating_mul(3);
        let values = self.array(node, count)?.reals();
        if values.len() != count {
            return Err(missing(node));
        }
        let spot = self.spot(node);
        let (all, _) = values.as_chunks();
        for (number, &at) in all.iter().enumerate() {
            raw.add_node(number as u64, at, spot)?;
        }
        Ok(())
    }

    pub(super) fn cells(&self, raw: &mut Raw) -> Result<(), ReadError> {
        let cells = self.cells;
        let (_, types) = self.integers("types", "the type of every cell", cells)?;
        let (_, ends) = self.integers("offsets", "the end of every cell's nodes", cells)?;
        let most = cells.saturating_mul(MOST_NODES);
        let (node, connectivity) = self.integers("connectivity", "the nodes of cells", most)?;
        let (at, spot) = (self.place(node), self.spot(node));
        if types.len() != self.cells || ends.len() != self.cells {
            let what = "a type and an end of the nodes of every cell";
            return Err(ReadError::MissingValue { at, what });
        }
        let mut start = 0;
        for (number, (&kind, &end)) in types.iter().zip(&ends).enumerate() {
            let shape = types::shape(kind).map_err(|why| ReadError::ElementType {
                at: at.clone(),
                element: number as u64,
                name: types::name(kind),
                why,
            })?;
            let own = usize::try_from(end)
                .ok()
                .and_then(|end| connectivity.get(start..end))
                .filter(|own| own.len() == shape.nodes());
            let own: Option<Vec<u64>> = own.and_then(|own| {
                let numbers = own.iter().map(|&node| u64::try_from(node).ok());
                numbers.collect()
            });
            let nodes = own.ok_or_else(|| ReadError::Value {
                at: at.clone(),
                what: "for each cell the end of the nodes that its type has",
                found: format!("{end} for cell {number}"),
            })?;
            // VTK has no rule for which way cells go: each is turned on its own, and folds show as overlaps.
            let number = number as u64;
            raw.add_element(number, shape, &nodes, [0, number], spot);
            start += nodes.len();
        }
        if start != connectivity.len() {
            return Err(ReadError::Value {
                at,
                what: "an end of the last cell's nodes",
                found: format!(
                    "{} nodes, the last cell ends after {start}",
                    connectivity.len()
                ),
            });
        }
        raw.blocks.push(RawBlock {
            name: "cells".to_owned(),
            rank: 0,
        });
        Ok(())
    }
}

fn line_of(document: &Document<'_>, node: Node<'_, '_>) -> Place {
    place(document.text_pos_at(node.range().start).row)
}
