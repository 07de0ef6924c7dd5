//! Element types of Gmsh by number. Cells and lines have the node order of this workspace.

use stickslip_fem_core::mesh::ElementKind;

use crate::error::Unsupported;
use crate::raw::Shape;

/// What elements of type `number` are here.
pub(super) fn shape(number: u64) -> Result<Shape, Unsupported> {
    Ok(match number {
        1 => Shape::Line(1),
        2 => Shape::Cell(ElementKind::T3),
        3 => Shape::Cell(ElementKind::Q4),
        8 => Shape::Line(2),
        9 => Shape::Cell(ElementKind::T6),
        10 => Shape::Cell(ElementKind::Q9),
        15 => Shape::Point,
        16 => Shape::Cell(ElementKind::Q8),
        4..=7 | 11..=14 | 17..=19 | 29..=33 | 71..=83 | 90..=93 => return Err(Unsupported::Solid),
        20..=28 | 36..=63 => return Err(Unsupported::Order),
        _ => return Err(Unsupported::Unknown),
    })
}

/// The number of the type of cells of `kind`, if Gmsh has it.
pub(crate) fn number_of(kind: ElementKind) -> Option<u64> {
    use ElementKind::{P1, P2, Q4, Q8, Q9, T3, T6};
    Some(match kind {
        T3 => 2,
        Q4 | P1 => 3,
        T6 => 9,
        Q9 | P2 => 10,
        Q8 => 16,
        _ => return None,
    })
}

/// The name of type `number` in Gmsh's own words, for messages.
pub(super) fn name(number: u64) -> String {
    let known = match number {
        4 => "4-node tetrahedron",
        5 => "8-node hexahedron",
        6 => "6-node prism",
        7 => "5-node pyramid",
        11 => "10-node tetrahedron",
        12 => "27-node hexahedron",
        17 => "20-node hexahedron",
        21 => "10-node triangle",
        26 => "4-node edge",
        36 => "16-node quadrangle",
        _ => return number.to_string(),
    };
    format!("{number} ({known})")
}
