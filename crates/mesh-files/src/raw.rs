//! What a file says, before it is a mesh: nodes and elements by the file's numbers.

use stickslip_fem_core::mesh::ElementKind;

use crate::error::ReadError;
use crate::note::Note;
use crate::numbers::Numbers;
use crate::place::{Files, Place, Spot};

/// What an element is to a plane mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// A point, which names a node.
    Point,
    /// A line of an order, which names an edge.
    Line(usize),
    /// A cell.
    Cell(ElementKind),
}

impl Shape {
    pub(crate) fn nodes(self) -> usize {
        match self {
            Self::Point => 1,
            Self::Line(order) => order + 1,
            Self::Cell(kind) => kind.nodes(),
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct RawNode {
    pub(crate) number: u64,
    pub(crate) at: [f64; 3],
    pub(crate) spot: Spot,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct RawElement {
    pub(crate) number: u64,
    pub(crate) shape: Shape,
    /// Position of its first node in the connectivity.
    first: usize,
    /// Index of its block.
    pub(crate) block: usize,
    /// Elements of one such group are numbered clockwise together or not at all.
    pub(crate) turn: u64,
    pub(crate) spot: Spot,
}

/// A group of cells that becomes a block for each of its kinds.
#[derive(Clone, Debug)]
pub(crate) struct RawBlock {
    pub(crate) name: String,
    /// Blocks are sorted by it.
    pub(crate) rank: u64,
}

/// Nodes and elements as they were read.
#[derive(Debug, Default)]
pub(crate) struct Raw {
    pub(crate) files: Files,
    pub(crate) nodes: Vec<RawNode>,
    pub(crate) elements: Vec<RawElement>,
    connectivity: Vec<u64>,
    pub(crate) blocks: Vec<RawBlock>,
    pub(crate) notes: Vec<Note>,
}

impl Raw {
    /// Adds a node.
    ///
    /// # Errors
    /// [`ReadError::NotFinite`].
    pub(crate) fn add_node(
        &mut self,
        number: u64,
        at: [f64; 3],
        spot: Spot,
    ) -> Result<(), ReadError> {
        if let Some(&value) = at.iter().find(|value| !value.is_finite()) {
            let at = self.files.place(spot);
            return Err(ReadError::NotFinite {
                at,
                node: number,
                value,
            });
        }
        self.nodes.push(RawNode { number, at, spot });
        Ok(())
    }

    /// Adds an element with as many `nodes` as its shape has.
    pub(crate) fn add_element(
        &mut self,
        number: u64,
        shape: Shape,
        nodes: &[u64],
        [block, turn]: [u64; 2],
        spot: Spot,
    ) {
        self.elements.push(RawElement {
            number,
            shape,
            first: self.connectivity.len(),
            block: block as usize,
            turn,
            spot,
        });
        self.connectivity.extend_from_slice(nodes);
    }

    /// Numbers of the nodes of the element that was added at position `element`, which exists.
    pub(crate) fn nodes_of(&self, element: usize) -> &[u64] {
        let RawElement { first, shape, .. } = self.elements[element];
        // `add_element` appended as many numbers as the shape has nodes.
        &self.connectivity[first..first + shape.nodes()]
    }

    /// Sorts nodes and elements by their numbers and resolves the nodes of elements.
    ///
    /// # Errors
    /// [`ReadError::DuplicateNode`], [`ReadError::DuplicateElement`], [`ReadError::MissingNode`].
    pub(crate) fn number(mut self, end: Spot) -> Result<Numbered, ReadError> {
        self.unique_nodes()?;
        self.unique_elements()?;
        let node_index = Numbers::new(self.nodes.iter().map(|node| node.number).collect());
        let element_index = Numbers::new(self.elements.iter().map(|e| e.number).collect());
        let mut connectivity = vec![0; self.connectivity.len()];
        for element in &self.elements {
            let nodes = element.first..element.first + element.shape.nodes();
            // `add_element` appended as many numbers as the shape has nodes.
            let numbers = &self.connectivity[nodes.clone()];
            for (place, &node) in connectivity[nodes].iter_mut().zip(numbers) {
                *place = node_index.get(node).ok_or_else(|| ReadError::MissingNode {
                    at: self.files.place(element.spot),
                    element: element.number,
                    node,
                })?;
            }
        }
        Ok(Numbered {
            files: self.files,
            nodes: self.nodes,
            elements: self.elements,
            connectivity,
            blocks: self.blocks,
            notes: self.notes,
            node_index,
            element_index,
            end,
        })
    }

    fn unique_nodes(&mut self) -> Result<(), ReadError> {
        self.nodes.sort_by_key(|node| node.number);
        let mut repeated = Repeated::new("node");
        for pair in self.nodes.windows(2) {
            // Windows of 2 have two items.
            let (first, second) = (pair[0], pair[1]);
            if first.number != second.number {
                continue;
            }
            if first.at != second.at {
                return Err(ReadError::DuplicateNode {
                    at: self.files.place(second.spot),
                    first: self.files.place(first.spot),
                    node: first.number,
                });
            }
            repeated.add(first.number);
        }
        self.notes.extend(repeated.note());
        self.nodes.dedup_by_key(|node| node.number);
        Ok(())
    }

    fn unique_elements(&mut self) -> Result<(), ReadError> {
        self.elements.sort_by_key(|element| element.number);
        let nodes = |element: &RawElement| {
            // `add_element` appended as many numbers as the shape has nodes.
            &self.connectivity[element.first..element.first + element.shape.nodes()]
        };
        let mut repeated = Repeated::new("element");
        for pair in self.elements.windows(2) {
            let (first, second) = (&pair[0], &pair[1]);
            if first.number != second.number {
                continue;
            }
            if first.shape != second.shape || nodes(first) != nodes(second) {
                return Err(ReadError::DuplicateElement {
                    at: self.files.place(second.spot),
                    first: self.files.place(first.spot),
                    element: first.number,
                });
            }
            repeated.add(first.number);
        }
        self.notes.extend(repeated.note());
        self.elements.dedup_by_key(|element| element.number);
        Ok(())
    }
}

/// Counts what stands in a file twice.
pub(crate) struct Repeated {
    family: &'static str,
    count: usize,
    first: u64,
}

impl Repeated {
    pub(crate) fn new(family: &'static str) -> Self {
        Self {
            family,
            count: 0,
            first: 0,
        }
    }

    pub(crate) fn add(&mut self, number: u64) {
        if self.count == 0 {
            self.first = number;
        }
        self.count += 1;
    }

    pub(crate) fn note(self) -> Option<Note> {
        let Self {
            family,
            count,
            first,
        } = self;
        (count > 0).then_some(Note::Repeated {
            family,
            count,
            first,
        })
    }
}

/// Nodes and elements, ascending by their numbers, each once; elements know the positions of their nodes.
#[derive(Debug)]
pub(crate) struct Numbered {
    pub(crate) files: Files,
    pub(crate) nodes: Vec<RawNode>,
    pub(crate) elements: Vec<RawElement>,
    connectivity: Vec<usize>,
    pub(crate) blocks: Vec<RawBlock>,
    pub(crate) notes: Vec<Note>,
    pub(crate) node_index: Numbers,
    pub(crate) element_index: Numbers,
    /// The last line.
    pub(crate) end: Spot,
}

impl Numbered {
    /// Positions of the nodes of the element at position `element`, which exists.
    pub(crate) fn nodes_of(&self, element: usize) -> &[usize] {
        let RawElement { first, shape, .. } = self.elements[element];
        &self.connectivity[first..first + shape.nodes()]
    }

    /// The same, to change their order.
    pub(crate) fn nodes_of_mut(&mut self, element: usize) -> &mut [usize] {
        let RawElement { first, shape, .. } = self.elements[element];
        &mut self.connectivity[first..first + shape.nodes()]
    }

    /// Where an element stands in the file.
    pub(crate) fn place(&self, element: usize) -> Place {
        self.files.place(self.elements[element].spot)
    }
}
