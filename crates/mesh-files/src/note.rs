//! What a reader passed over or changed.

use std::fmt;

use stickslip_fem_core::mesh::{ElementBlock, Point};
use stickslip_text::counted;

use crate::names::listed;
use crate::place::Place;
use crate::quality::{self, Flaw};

/// Something that was passed over or changed on the way from the file to the mesh.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Note {
    /// A keyword of Abaqus, a section of Gmsh or an array of VTK that says nothing about the mesh.
    Skipped {
        /// The keyword, section or array.
        keyword: String,
        /// Where it stands first.
        at: Place,
        /// How often it stands in the file.
        count: usize,
    },
    /// Nodes that belong to no cell were dropped.
    UnusedNodes {
        /// How many.
        count: usize,
        /// The file's number of the first.
        first: u64,
    },
    /// A set lost members that no cell uses, or that a range names without their being there.
    DroppedMembers {
        /// "node" or "element".
        family: &'static str,
        /// The set.
        set: String,
        /// How many.
        count: usize,
    },
    /// A set that no cell uses, or a named group without elements, was dropped.
    DroppedSet {
        /// "node", "edge" or "element".
        family: &'static str,
        /// The set.
        set: String,
    },
    /// Cells numbered clockwise were turned.
    Turned {
        /// How many.
        count: usize,
        /// The file's number of the first.
        first: u64,
    },
    /// Elements or nodes that stand in the file twice, with the same content, were taken once.
    Repeated {
        /// "node" or "element".
        family: &'static str,
        /// How many.
        count: usize,
        /// The file's number of the first.
        first: u64,
    },
    /// Points and lines that belong to no set.
    Unnamed {
        /// "point" or "line".
        what: &'static str,
        /// How many.
        count: usize,
    },
    /// Edges of a set lie inside the mesh: the cell on the left of the line has them.
    InnerEdges {
        /// The set.
        set: String,
        /// How many.
        count: usize,
    },
    /// The nodes of each of these sets form whole boundary edges, which became an edge set.
    EdgesFromNodes {
        /// The sets.
        sets: Vec<String>,
    },
    /// The nodes of each of these sets lie on the boundary without being one chain of whole edges, so that it stays a set of points.
    NoEdges {
        /// The sets.
        sets: Vec<String>,
    },
    /// A node set and an edge set have one name and different nodes: the edge set is the edge.
    OtherNodes {
        /// Their name.
        set: String,
    },
    /// Nodes, elements or members of sets that belong to an assembly, not to its part, were passed over.
    OfAssembly {
        /// Where the first stands.
        at: Place,
        /// How many lines.
        count: usize,
    },
    /// A set was renamed because another one has its name.
    Renamed {
        /// Its name in the file.
        name: String,
        /// Its name here.
        to: String,
    },
    /// Cells of a bad shape.
    Flawed {
        /// How many with a flaw of this kind.
        count: usize,
        /// The file's number of the worst.
        worst: u64,
        /// What is bad with that one.
        flaw: Flaw,
    },
}

impl Note {
    /// On the cells of `blocks` of a bad shape; `numbers` are the file's of its cells.
    pub(crate) fn on_shapes(
        nodes: &[Point],
        blocks: &[ElementBlock],
        numbers: &[u64],
    ) -> impl Iterator<Item = Self> {
        let found = quality::worst(nodes, blocks, numbers);
        found.map(|(count, worst, flaw)| Self::Flawed { count, worst, flaw })
    }
}

impl fmt::Display for Note {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Skipped { keyword, at, count } => {
                write!(out, "{keyword} passed over: {at}")?;
                match count {
                    0 | 1 => Ok(()),
                    more => write!(out, " and {} more", more - 1),
                }
            }
            Self::UnusedNodes { count, first } => {
                write!(
                    out,
                    "{} of no cell dropped, the first is {first}",
                    counted(*count, "node")
                )
            }
            Self::DroppedMembers { family, set, count } => {
                write!(
                    out,
                    "{family} set '{set}': {} of no cell dropped",
                    counted(*count, "member")
                )
            }
            Self::DroppedSet { family, set } => {
                write!(
                    out,
                    "{family} set '{set}' has no members in the mesh, dropped"
                )
            }
            Self::Turned { count, first } => {
                write!(
                    out,
                    "{} turned, the first is {first}",
                    counted(*count, "clockwise element")
                )
            }
            Self::Repeated {
                family,
                count,
                first,
            } => {
                write!(
                    out,
                    "{} repeated, the first is {first}; each is taken once",
                    counted(*count, family)
                )
            }
            Self::Unnamed { what, count } => {
                write!(
                    out,
                    "{} in no set passed over",
                    counted(*count, &format!("{what} element"))
                )
            }
            Self::InnerEdges { set, count } => {
                write!(
                    out,
                    "edge set '{set}': {} inside the mesh",
                    counted(*count, "edge")
                )
            }
            Self::EdgesFromNodes { sets } => {
                let names: Vec<&str> = sets.iter().map(String::as_str).collect();
                write!(
                    out,
                    "node sets that form whole boundary edges are edges too: {}",
                    listed(&names)
                )
            }
            Self::NoEdges { sets } => {
                let names: Vec<&str> = sets.iter().map(String::as_str).collect();
                write!(
                    out,
                    "node sets on the boundary that are points and no edges, because they lack a node, such as the middle one of a quadratic edge, or are several chains: {}",
                    listed(&names)
                )
            }
            Self::OtherNodes { set } => write!(
                out,
                "the node set '{set}' has other nodes than the edge set '{set}'; the edge set is used"
            ),
            Self::OfAssembly { at, count } => {
                write!(
                    out,
                    "{} on nodes and elements of the assembly passed over, the first is {at}",
                    counted(*count, "line")
                )
            }
            Self::Renamed { name, to } => write!(out, "set '{name}' is called '{to}'"),
            Self::Flawed { count, worst, flaw } => flaw.write_note(out, *count, *worst),
        }
    }
}
