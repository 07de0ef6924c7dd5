//! Cell types of VTK by number. Cells and lines have the node order of this workspace.

use stickslip_fem_core::mesh::ElementKind;

use crate::error::Unsupported;
use crate::raw::Shape;

/// What cells of type `number` are here.
pub(super) fn shape(number: i64) -> Result<Shape, Unsupported> {
    Ok(match number {
        1 => Shape::Point,
        3 => Shape::Line(1),
        5 => Shape::Cell(ElementKind::T3),
        9 => Shape::Cell(ElementKind::Q4),
        21 => Shape::Line(2),
        22 => Shape::Cell(ElementKind::T6),
        23 => Shape::Cell(ElementKind::Q8),
        28 => Shape::Cell(ElementKind::Q9),
        10..=16 | 24..=27 | 29 | 31..=33 | 42 | 71..=74 | 78..=81 => {
            return Err(Unsupported::Solid);
        }
        35 | 68..=70 | 75..=77 => return Err(Unsupported::Order),
        _ => return Err(Unsupported::Unknown),
    })
}

/// The name of type `number` in VTK's own words, for messages.
pub(super) fn name(number: i64) -> String {
    let known = match number {
        4 => "poly-line",
        7 => "polygon",
        8 => "pixel",
        10 => "tetrahedron",
        12 => "hexahedron",
        13 => "wedge",
        24 => "quadratic tetrahedron",
        25 => "quadratic hexahedron",
        34 => "biquadratic triangle",
        69 => "Lagrange triangle",
        70 => "Lagrange quadrilateral",
        _ => return number.to_string(),
    };
    format!("{number} ({known})")
}
