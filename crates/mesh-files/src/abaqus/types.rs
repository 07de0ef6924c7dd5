//! Element types of Abaqus and CalculiX by name. Cells have the node order of this workspace.

use stickslip_fem_core::mesh::ElementKind;

use crate::error::Unsupported;
use crate::raw::Shape;

/// Letters behind the number of nodes that change the formulation, not the geometry: reduced integration, incompatible modes,
/// hybrid, modified, with temperature.
const VARIANTS: [&str; 14] = [
    "", "R", "I", "M", "H", "RH", "IH", "MH", "T", "RT", "HT", "RHT", "MT", "MHT",
];

/// What elements of a type are here.
pub(super) fn shape(name: &str) -> Result<Shape, Unsupported> {
    let name = name.to_ascii_uppercase();
    if let Some(rest) = name.strip_prefix("CPS").or(name.strip_prefix("CPE")) {
        return plane(rest);
    }
    match name.as_str() {
        "T2D2" | "T3D2" => Ok(Shape::Line(1)),
        "T2D3" | "T3D3" => Ok(Shape::Line(2)),
        // No plane type has 9 nodes; Gmsh writes its plane quadrilaterals of 9 nodes as these membranes.
        "M3D9" => Ok(Shape::Cell(ElementKind::Q9)),
        _ => Err(refused(&name)),
    }
}

fn plane(rest: &str) -> Result<Shape, Unsupported> {
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    // Digits are one byte each.
    let (number, variant) = rest.split_at(digits);
    let kind = match number {
        "3" => ElementKind::T3,
        "4" => ElementKind::Q4,
        "6" => ElementKind::T6,
        "8" => ElementKind::Q8,
        _ => return Err(Unsupported::Unknown),
    };
    if VARIANTS.contains(&variant) {
        Ok(Shape::Cell(kind))
    } else {
        Err(Unsupported::Unknown)
    }
}

fn refused(name: &str) -> Unsupported {
    const BY_BEGINNING: [(&str, Unsupported); 6] = [
        ("C3D", Unsupported::Solid),
        ("SC", Unsupported::Solid),
        ("CAX", Unsupported::Axisymmetric),
        ("CGAX", Unsupported::Axisymmetric),
        ("M3D", Unsupported::Shell),
        ("STRI", Unsupported::Shell),
    ];
    let mut known = BY_BEGINNING.iter();
    if let Some((_, why)) = known.find(|(start, _)| name.starts_with(start)) {
        return *why;
    }
    let shell = name.strip_prefix('S').and_then(|rest| rest.chars().next());
    if shell.is_some_and(|c| c.is_ascii_digit()) {
        Unsupported::Shell
    } else {
        Unsupported::Unknown
    }
}
