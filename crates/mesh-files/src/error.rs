//! Why a file cannot be read or written.

use std::fmt;

use stickslip_fem_core::mesh::{ElementKind, MeshError};
use thiserror::Error;

use crate::place::Place;
use crate::quality::Flaw;
use crate::recognise::{LARGEST_TURN, NEARLY};

/// Why elements of a type are no cells of a plane mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unsupported {
    /// Tetrahedra, hexahedra and other solids.
    Solid,
    /// Solids of revolution.
    Axisymmetric,
    /// Shells and membranes in space.
    Shell,
    /// Lines, triangles and quadrilaterals of order 3 and more.
    Order,
    /// Any other.
    Unknown,
}

impl fmt::Display for Unsupported {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Solid => "is three-dimensional; mesh the surface only, and save no volumes",
            Self::Axisymmetric => {
                "is axisymmetric; use a plane type, CPS for plane stress or CPE for plane strain"
            }
            Self::Shell => {
                "is a shell or membrane; use a plane type, CPS for plane stress or CPE for plane strain"
            }
            Self::Order => "has an order above 2; mesh with order 1 or 2",
            Self::Unknown => {
                "is unknown; use triangles and quadrilaterals of 3, 4, 6, 8 or 9 nodes"
            }
        })
    }
}

/// Why a file makes no mesh. Numbers of nodes and elements are those of the file.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ReadError {
    /// The text does not begin like a file of its format.
    #[error("{at}: '{found}' does not begin a file of {format}; check the file's extension")]
    Format {
        /// Where.
        at: Place,
        /// Name of the program.
        format: &'static str,
        /// What stands there.
        found: String,
    },
    /// A version of the MSH format that is not read.
    #[error(
        "{at}: format {version} of Gmsh is not read; save as 4.1 or 2.2 (Mesh.MshFileVersion = 4.1)"
    )]
    Version {
        /// Where.
        at: Place,
        /// The version.
        version: String,
    },
    /// A binary file.
    #[error("{at}: the file is binary; save as text (Mesh.Binary = 0)")]
    Binary {
        /// Where.
        at: Place,
    },
    /// Text that is no XML.
    #[error("{at}: the file is not valid XML ({cause}); export it again")]
    Xml {
        /// Where.
        at: Place,
        /// Why.
        cause: String,
    },
    /// Arrays of VTK in a form that is not read.
    #[error(
        "{at}: {what}; save the grid with its arrays inside, as text or binary, plain or packed by zlib (in ParaView: data mode Ascii or Binary)"
    )]
    Encoding {
        /// Where.
        at: Place,
        /// What is not read.
        what: &'static str,
    },
    /// An array of VTK whose bytes are not what it says.
    #[error("{at}: the array is damaged: {what}; export the file again")]
    Damaged {
        /// Where.
        at: Place,
        /// What is wrong.
        what: &'static str,
    },
    /// Points or cells of VTK that are marked as copies of another part's, or as hidden.
    #[error(
        "{at}: array '{array}' marks points or cells as copies or hidden; save the grid without them (in ParaView: Remove Ghost Information)"
    )]
    Ghosts {
        /// Where.
        at: Place,
        /// The array.
        array: String,
    },
    /// Two arrays of VTK that make sets of one name.
    #[error("{at}: two arrays make a set '{set}'; rename one of them")]
    SameSet {
        /// Where the second stands.
        at: Place,
        /// The set.
        set: String,
    },
    /// A mesh that was divided for parallel computation.
    #[error("{at}: the mesh is partitioned; save it without partitions")]
    Partitioned {
        /// Where.
        at: Place,
    },
    /// The text ends too early.
    #[error("{at}: the file ends where {what} is expected; export it again, it is incomplete")]
    Truncated {
        /// The last line.
        at: Place,
        /// What is missing.
        what: &'static str,
    },
    /// Something else stands where a value is expected.
    #[error("{at}: '{found}' stands where {what} is expected; correct the line")]
    Value {
        /// Where.
        at: Place,
        /// What is expected.
        what: &'static str,
        /// What stands there.
        found: String,
    },
    /// A line has too few values.
    #[error("{at}: {what} is missing; complete the line")]
    MissingValue {
        /// Where.
        at: Place,
        /// What is missing.
        what: &'static str,
    },
    /// A keyword of Abaqus lacks a parameter.
    #[error("{at}: *{keyword} has no parameter {parameter}; add it")]
    MissingParameter {
        /// Where.
        at: Place,
        /// The keyword.
        keyword: String,
        /// The parameter.
        parameter: &'static str,
    },
    /// A keyword or parameter that changes the mesh in a way that is not read.
    #[error("{at}: *{keyword} is not read; write a flat file with all nodes and elements")]
    Generated {
        /// Where.
        at: Place,
        /// The keyword.
        keyword: String,
    },
    /// Parts and instances that are not one part at its place.
    #[error(
        "{at}: {what}; write a flat file (in Abaqus: mdb.models[…].setValues(noPartsInputFile=ON))"
    )]
    Assembly {
        /// Where.
        at: Place,
        /// What is wrong.
        what: String,
    },
    /// An included file that cannot be had.
    #[error("{at}: the file '{file}' cannot be included: {cause}; check its name and place")]
    Include {
        /// Where.
        at: Place,
        /// Its name.
        file: String,
        /// Why.
        cause: String,
    },
    /// A coordinate is not finite.
    #[error("{at}: a coordinate of node {node} is {value}; correct or remove the node")]
    NotFinite {
        /// Where.
        at: Place,
        /// The node.
        node: u64,
        /// The coordinate, in the unit of the file.
        value: f64,
    },
    /// Two nodes with one number.
    #[error(
        "{at}: node {node} was given other coordinates at {first}; give every node a number of its own"
    )]
    DuplicateNode {
        /// The second.
        at: Place,
        /// The first.
        first: Place,
        /// Their number.
        node: u64,
    },
    /// Two elements with one number.
    #[error(
        "{at}: element {element} was given another type or other nodes at {first}; give every element a number of its own"
    )]
    DuplicateElement {
        /// The second.
        at: Place,
        /// The first.
        first: Place,
        /// Their number.
        element: u64,
    },
    /// An element of a type that is not read.
    #[error("{at}: element {element} of type {name} {why}")]
    ElementType {
        /// Where.
        at: Place,
        /// The element.
        element: u64,
        /// Its type, as the file names it.
        name: String,
        /// Why it is not read.
        why: Unsupported,
    },
    /// A node that an element names does not exist.
    #[error("{at}: element {element} names node {node}, which does not exist; add or correct it")]
    MissingNode {
        /// Where.
        at: Place,
        /// The element.
        element: u64,
        /// The node.
        node: u64,
    },
    /// No triangle and no quadrilateral.
    #[error(
        "{at}: the file ends without a plane element; mesh the surface, and save its elements (in Gmsh: those of a physical surface, or Mesh.SaveAll = 1)"
    )]
    NoCells {
        /// The last line.
        at: Place,
    },
    /// Linear and quadratic cells in one mesh.
    #[error(
        "{at}: element {element} ({kind:?}) and element {other} ({other_kind:?}, {other_at}) have different orders; mesh all with one order"
    )]
    MixedOrders {
        /// Where.
        at: Place,
        /// An element.
        element: u64,
        /// Its kind.
        kind: ElementKind,
        /// Where the other one is.
        other_at: Place,
        /// An element of another order.
        other: u64,
        /// Its kind.
        other_kind: ElementKind,
    },
    /// Nodes at different z.
    #[error(
        "{at}: node {node} has z = {z}, node {first} has z = {first_z}; turn the mesh into a plane z = constant"
    )]
    NotPlane {
        /// Where.
        at: Place,
        /// The node.
        node: u64,
        /// Its z `[length]`.
        z: f64,
        /// The first node.
        first: u64,
        /// Its z `[length]`.
        first_z: f64,
    },
    /// A cell numbered clockwise among others that are not.
    #[error(
        "{at}: element {element} is numbered {}, the other elements of its group are not; reverse the order of its nodes",
        if *.clockwise { "clockwise" } else { "counter-clockwise" }
    )]
    Orientation {
        /// Where.
        at: Place,
        /// The element.
        element: u64,
        /// Whether it is the one that goes clockwise.
        clockwise: bool,
    },
    /// A cell that is folded, or has no area.
    #[error(
        "{at}: element {element} is {}: its Jacobian determinant is {determinant:.3e} at reference point ({}, {}); correct its nodes or mesh again",
        if *.determinant < 0.0 { "inverted" } else { "degenerate" }, reference[0], reference[1]
    )]
    Distorted {
        /// Where.
        at: Place,
        /// The element.
        element: u64,
        /// Determinant of the Jacobian `[length²]`.
        determinant: f64,
        /// Reference point where it was found `[1]`.
        reference: [f64; 2],
    },
    /// A cell with nearly closed or straight corners, or with sides of very different lengths.
    #[error("{at}: element {element} {flaw}; move its nodes or mesh again with even cells")]
    Flawed {
        /// Where.
        at: Place,
        /// The element.
        element: u64,
        /// What is bad.
        flaw: Flaw,
    },
    /// Two cells on one side of an edge.
    #[error("{at}: element {element} overlaps element {other} ({other_at}); remove one of them")]
    Overlap {
        /// Where.
        at: Place,
        /// An element.
        element: u64,
        /// Where the other one is.
        other_at: Place,
        /// The other one.
        other: u64,
    },
    /// Two nodes of the boundary at one place.
    #[error(
        "{at}: node {node} and node {other} ({other_at}) both stand at ({}, {}), and the mesh is open between them; merge coincident nodes (in Gmsh: Coherence Mesh), or allow them if bodies touch there",
        point[0], point[1]
    )]
    Coincident {
        /// Where.
        at: Place,
        /// A node.
        node: u64,
        /// Where the other one is.
        other_at: Place,
        /// The other one.
        other: u64,
        /// Their place `[length]`.
        point: [f64; 2],
    },
    /// A member of a set does not exist.
    #[error("{at}: {family} set '{set}' names {member}, which does not exist; add or remove it")]
    UnknownMember {
        /// Where.
        at: Place,
        /// "node", "element" or "edge".
        family: &'static str,
        /// The set.
        set: String,
        /// The member.
        member: String,
    },
    /// A set without members.
    #[error("{at}: {family} set '{set}' is empty; add members or remove it")]
    EmptySet {
        /// Where.
        at: Place,
        /// "node", "element" or "edge".
        family: &'static str,
        /// The set.
        set: String,
    },
    /// Sets that grow without bound by naming each other.
    #[error("{at}: the sets have more than {limit} members in all; name fewer sets in sets")]
    SetsTooLarge {
        /// Where.
        at: Place,
        /// The largest number.
        limit: usize,
    },
    /// A face that an element does not have.
    #[error("{at}: element {element} has no face {face}; faces are S1 to S3 or S4")]
    Face {
        /// Where.
        at: Place,
        /// The element.
        element: u64,
        /// The face.
        face: String,
    },
    /// A line element that is no edge of a cell.
    #[error(
        "{at}: line element {element} of '{set}' is no edge of a plane element; mesh the curve with its surface, or take it out of the group"
    )]
    LineOffCells {
        /// Where.
        at: Place,
        /// The line element.
        element: u64,
        /// Its group or set.
        set: String,
    },
    /// Any other defect, in positions of the mesh instead of numbers of the file.
    #[error("the mesh is not valid: {0}")]
    Mesh(#[from] MeshError),
}

/// Why a mesh cannot be written.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum WriteError {
    /// A kind of cell that the format does not have.
    #[error("{format} has no cells like {kind:?} of block '{block}'; use {instead}")]
    Kind {
        /// Name of the format.
        format: &'static str,
        /// The kind.
        kind: ElementKind,
        /// The block.
        block: String,
        /// Kinds that it has.
        instead: &'static str,
    },
    /// A name that the format cannot hold.
    #[error("the name '{name}' {why}; rename the set or block")]
    Name {
        /// The name.
        name: String,
        /// Why.
        why: &'static str,
    },
}

/// Why an edge set has no curve to snap to.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum CurveError {
    /// No set of this name.
    #[error("no edge set '{set}'")]
    MissingSet {
        /// The name.
        set: String,
    },
    /// Edges that do not form one chain, or that do not exist.
    #[error("the edges of set '{set}' do not form one chain with the material on one side")]
    NoChain {
        /// The set.
        set: String,
    },
    /// A chain that lies on no line and no circle.
    #[error("edge set '{set}' lies on no straight line and no circle")]
    NoCurve {
        /// The set.
        set: String,
    },
    /// A chain with ends that is declared to be a circle.
    #[error("edge set '{set}' is open, and a circle has no ends")]
    Open {
        /// The set.
        set: String,
    },
    /// A closed chain that is declared to be a circle.
    #[error("the corner nodes of edge set '{set}' do not go around one circle: {}", why_no_circle(*radius, *off, *step))]
    NoCircle {
        /// The set.
        set: String,
        /// Radius of the circle of least squares `[length]`; infinite if they lie on a line.
        radius: f64,
        /// The farthest way of a corner node from it `[length]`.
        off: f64,
        /// Largest angle between neighbours as seen from its centre `[rad]`.
        step: f64,
    },
    /// A radius that is given for a circle of another one.
    #[error(
        "the corner nodes of edge set '{set}' lie on a circle of {:.4} times the given radius, which may be at most 5 % off",
        found / given
    )]
    OtherRadius {
        /// The set.
        set: String,
        /// Radius of the circle of least squares `[length]`.
        found: f64,
        /// The one that is given `[length]`.
        given: f64,
    },
    /// A set that is declared twice.
    #[error("edge set '{set}' is declared twice")]
    Twice {
        /// The set.
        set: String,
    },
    /// Another number of radii than of circles.
    #[error("the numbers of circles ({circles}) and of their radii ({radii}) differ")]
    Radii {
        /// How many circles.
        circles: usize,
        /// How many radii.
        radii: usize,
    },
    /// Circles onto which their nodes cannot be put.
    #[error("cells lose their shape where the nodes of '{sets}' are put onto circles")]
    Squeezed {
        /// The sets.
        sets: String,
    },
}

fn why_no_circle(radius: f64, off: f64, step: f64) -> String {
    if !radius.is_finite() {
        return "no circle goes through them".to_owned();
    }
    let part = off / radius;
    if part > NEARLY {
        let percent = 100.0 * part;
        return format!(
            "they are up to {percent:.2} % of its radius away from the best one, and 5 % is the most"
        );
    }
    if step > LARGEST_TURN[0] {
        let degrees = step.to_degrees();
        return format!(
            "its centre sees two neighbours {degrees:.1}° apart, and 50.4° is the most; mesh it finer"
        );
    }
    "they go back and forth around its centre".to_owned()
}
