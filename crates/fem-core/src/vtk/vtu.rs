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
    /// All numbers, node by node or cell by cell in the mesh's order, in any unit.
    pub values: &'a [f64],
}

/// Writes `mesh` with its fields to `out`, which should be buffered.
///
/// Cells that VTK does not have are written as several, with the same values: those of order above 2 as the p² quadrilaterals
/// between neighbouring nodes ([`ElementKind::vtk_cells`](crate::mesh::ElementKind::vtk_cells)). Points are the mesh's nodes.
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
    let points = mesh.nodes().len();
    check(point_data, "nodes", points)?;
    check(cell_data, "cells", mesh.element_count())?;
    let shown = Shown::new(mesh);
    let cells = shown.count();
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
    write_fields("PointData", point_data, points, |row| row, &mut out)?;
    write_fields(
        "CellData",
        cell_data,
        cells,
        |row| shown.owner[row],
        &mut out,
    )?;
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
    shown.write(&mut out)?;
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

/// Writes `count` rows of each field; `source` is the row of the field that each takes.
fn write_fields(
    tag: &str,
    fields: &[Field],
    count: usize,
    source: impl Fn(usize) -> usize,
    out: &mut impl Write,
) -> Result<(), VtkError> {
    writeln!(out, "<{tag}>")?;
    for field in fields {
        let width = field.components;
        let row = |k: usize| &field.values[source(k) * width..][..width];
        write_array(
            field.name,
            "Float64",
            width,
            (0..count).flat_map(row).map(|value| value.to_le_bytes()),
            count * width,
            out,
        )?;
    }
    writeln!(out, "</{tag}>")?;
    Ok(())
}

/// The cells of a file.
struct Shown<'a> {
    mesh: &'a Mesh,
    /// Cell of the mesh that each belongs to.
    owner: Vec<usize>,
    /// Local nodes of the cells that stand for one of each block's.
    of_block: Vec<Vec<Vec<usize>>>,
}

impl<'a> Shown<'a> {
    fn new(mesh: &'a Mesh) -> Self {
        let blocks = mesh.blocks().iter();
        let of_block: Vec<_> = blocks.map(|block| block.kind.vtk_cells()).collect();
        let owner = (0..mesh.element_count())
            .flat_map(|cell| std::iter::repeat_n(cell, of_block[mesh.element(cell).2].len()))
            .collect();
        Self {
            mesh,
            owner,
            of_block,
        }
    }

    fn count(&self) -> usize {
        self.owner.len()
    }

    /// Nodes of every cell.
    fn cells(&self) -> impl Iterator<Item = impl Iterator<Item = usize>> {
        (0..self.mesh.element_count()).flat_map(move |cell| {
            let (_, nodes, block) = self.mesh.element(cell);
            let parts = self.of_block[block].iter();
            parts.map(move |part| part.iter().map(move |&local| nodes[local]))
        })
    }

    fn write(&self, out: &mut impl Write) -> Result<(), VtkError> {
        let int = |value: usize| (value as i64).to_le_bytes();
        writeln!(out, "<Cells>")?;
        let total = self.cells().map(Iterator::count).sum();
        let nodes = self.cells().flatten().map(int);
        write_array("connectivity", "Int64", 1, nodes, total, out)?;
        let offsets = self.cells().scan(0, |end, cell| {
            *end += cell.count();
            Some(int(*end))
        });
        write_array("offsets", "Int64", 1, offsets, self.count(), out)?;
        let types = (self.owner.iter()).map(|&cell| [self.mesh.element(cell).0.vtk_cell_type()]);
        write_array("types", "UInt8", 1, types, self.count(), out)?;
        writeln!(out, "</Cells>")?;
        Ok(())
    }
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
