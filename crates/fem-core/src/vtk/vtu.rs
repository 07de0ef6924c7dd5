//! One unstructured grid.

use std::collections::BTreeSet;
use std::io::Write;

use super::base64::Encoder;
use super::{VtkError, escaped};
use crate::mesh::Mesh;

/// Values on the nodes or cells of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field<'a> {
    /// Name shown by the viewer.
    pub name: &'a str,
    /// Numbers per node or cell, 1 to 9: 1 a scalar, 3 a vector, 9 a tensor by rows.
    pub components: usize,
    /// All numbers, node by node or cell by cell in the mesh's order.
    pub values: &'a [f64],
}

/// Writes `mesh` with its fields to `out`, which should be buffered.
///
/// ```
/// use stickslip_fem_core::generate::{Generate, Rectangle};
/// use stickslip_fem_core::mesh::ElementKind;
/// use stickslip_fem_core::vtk::{Field, write_vtu};
///
/// let mesh = Rectangle::uniform([0.0, 1.0], [0.0, 1.0], [2, 2], ElementKind::Q8)?.generate()?;
/// let height: Vec<f64> = mesh.nodes().iter().map(|p| p[1]).collect();
/// let mut file = Vec::new();
/// write_vtu(&mesh, &[Field { name: "height", components: 1, values: &height }], &[], &mut file)?;
/// assert!(file.starts_with(b"<?xml"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`VtkError::Components`], [`VtkError::Length`], [`VtkError::Duplicate`] or [`VtkError::Name`] for a field, before anything
/// is written; [`VtkError::Io`] from `out`.
pub fn write_vtu<W: Write>(
    mesh: &Mesh,
    point_data: &[Field],
    cell_data: &[Field],
    mut out: W,
) -> Result<(), VtkError> {
    let (points, cells) = (mesh.nodes().len(), mesh.element_count());
    check(point_data, "nodes", points)?;
    check(cell_data, "cells", cells)?;
    writeln!(out, "<?xml version=\"1.0\"?>")?;
    writeln!(
        out,
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">"
    )?;
    writeln!(out, "<UnstructuredGrid>")?;
    writeln!(
        out,
        "<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">"
    )?;
    write_fields("PointData", point_data, &mut out)?;
    write_fields("CellData", cell_data, &mut out)?;
    writeln!(out, "<Points>")?;
    let coordinates = mesh.nodes().iter().flat_map(|p| [p[0], p[1], 0.0]);
    write_array(
        "Points",
        "Float64",
        3,
        coordinates.map(f64::to_le_bytes),
        3 * points,
        &mut out,
    )?;
    writeln!(out, "</Points>")?;
    write_cells(mesh, &mut out)?;
    writeln!(out, "</Piece>")?;
    writeln!(out, "</UnstructuredGrid>")?;
    writeln!(out, "</VTKFile>")?;
    out.flush()?;
    Ok(())
}

fn check(fields: &[Field], what: &'static str, entities: usize) -> Result<(), VtkError> {
    let mut names = BTreeSet::new();
    for &Field {
        name,
        components,
        values,
    } in fields
    {
        escaped(name)?;
        let field = || name.to_owned();
        if !(1..=9).contains(&components) {
            return Err(VtkError::Components {
                field: field(),
                components,
            });
        }
        let (found, expected) = (values.len(), entities * components);
        if found != expected {
            let field = field();
            return Err(VtkError::Length {
                field,
                found,
                what,
                entities,
                components,
                expected,
            });
        }
        if !names.insert(name) {
            return Err(VtkError::Duplicate { field: field() });
        }
    }
    Ok(())
}

fn write_fields(tag: &str, fields: &[Field], out: &mut impl Write) -> Result<(), VtkError> {
    writeln!(out, "<{tag}>")?;
    for field in fields {
        let bytes = field.values.iter().map(|value| value.to_le_bytes());
        write_array(
            field.name,
            "Float64",
            field.components,
            bytes,
            field.values.len(),
            out,
        )?;
    }
    writeln!(out, "</{tag}>")?;
    Ok(())
}

fn write_cells(mesh: &Mesh, out: &mut impl Write) -> Result<(), VtkError> {
    let blocks = mesh.blocks();
    let int = |value: usize| (value as i64).to_le_bytes();
    writeln!(out, "<Cells>")?;
    let nodes = blocks.iter().flat_map(|block| block.connectivity.iter());
    let total = blocks.iter().map(|block| block.connectivity.len()).sum();
    write_array(
        "connectivity",
        "Int64",
        1,
        nodes.map(|&node| int(node)),
        total,
        out,
    )?;
    let sizes = (0..mesh.element_count()).map(|cell| mesh.element(cell).0.nodes());
    let offsets = sizes.scan(0, |end, size| {
        *end += size;
        Some(int(*end))
    });
    write_array("offsets", "Int64", 1, offsets, mesh.element_count(), out)?;
    let types = (0..mesh.element_count()).map(|cell| [mesh.element(cell).0.vtk_cell_type()]);
    write_array("types", "UInt8", 1, types, mesh.element_count(), out)?;
    writeln!(out, "</Cells>")?;
    Ok(())
}

/// One array of `count` numbers of `S` bytes.
fn write_array<const S: usize>(
    name: &str,
    number: &str,
    components: usize,
    values: impl Iterator<Item = [u8; S]>,
    count: usize,
    out: &mut impl Write,
) -> Result<(), VtkError> {
    let name = escaped(name)?;
    writeln!(
        out,
        "<DataArray type=\"{number}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"binary\">"
    )?;
    let mut encoder = Encoder::new(out);
    encoder.push(&((count * S) as u64).to_le_bytes())?;
    for value in values {
        encoder.push(&value)?;
    }
    encoder.finish()?;
    writeln!(out, "\n</DataArray>")?;
    Ok(())
}
