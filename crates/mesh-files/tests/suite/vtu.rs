//! Unstructured grids of VTK.

use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::vtk::write_vtu;
use stickslip_mesh_files::{Format, Note, ReadError, Unsupported};

use super::{ends, imported, refused};

const TEXT: &str = include_str!("../data/strip.vtu");
/// Big-endian bytes behind counts of 4 bytes that are padded on their own.
const PLAIN: &str = include_str!("../data/strip-plain.vtu");
/// Blocks of 32 bytes, packed by zlib, counts of 8 bytes.
const PACKED: &str = include_str!("../data/strip-packed.vtu");

#[test]
fn arrays_of_integers_are_sets_of_points_lines_and_cells() {
    let file = imported(TEXT, Format::Vtk);
    assert_eq!(file.node_numbers, [0, 1, 2, 3, 4, 5]);
    assert_eq!(file.parts.nodes[5], [2.0, 1.0]);
    let kinds: Vec<_> = file.parts.blocks.iter().map(|block| block.kind).collect();
    assert_eq!(kinds, [ElementKind::T3, ElementKind::Q4]);
    assert_eq!(file.cell_numbers, [1, 2, 0]);
    assert_eq!(file.parts.element_sets["gmsh:physical-1"], [2]);
    assert_eq!(file.parts.element_sets["gmsh:physical-2"], [0, 1]);
    assert_eq!(ends(&file, "gmsh:physical-1"), [[3, 0]]);
    assert_eq!(ends(&file, "gmsh:physical-2"), [[2, 5]]);
    // The nodes of an array of 0 and 1 form a whole edge.
    assert_eq!(file.parts.node_sets["end"], [2, 5]);
    assert_eq!(ends(&file, "end"), [[2, 5]]);
    assert_eq!(file.parts.node_sets["corner"], [0]);
    let reals = |note: &Note| matches!(note, Note::Skipped { keyword, at, .. } if keyword == "array 'u' of PointData" && at.line == 9);
    assert!(file.notes.iter().any(reals), "{:?}", file.notes);
}

#[test]
fn bytes_hold_what_text_holds() {
    let expected = imported(TEXT, Format::Vtk);
    for text in [PLAIN, PACKED] {
        assert_eq!(imported(text, Format::Vtk), expected);
    }
}

#[test]
fn what_this_workspace_writes_is_read_again() {
    let file = imported(TEXT, Format::Vtk);
    let mesh = Mesh::new(file.parts).unwrap();
    let mut written = Vec::new();
    write_vtu(&mesh, &[], &[], &mut written).unwrap();
    let again = imported(std::str::from_utf8(&written).unwrap(), Format::Vtk);
    assert_eq!(again.parts.nodes, mesh.nodes());
    assert_eq!(again.parts.blocks.len(), mesh.blocks().len());
}

#[test]
fn defects_are_named_with_their_lines() {
    let change = |from: &str, to: &str| {
        assert!(TEXT.contains(from), "{from}");
        refused(&TEXT.replacen(from, to, 1), Format::Vtk)
    };
    assert!(matches!(
        change("type=\"UnstructuredGrid\"", "type=\"PolyData\""),
        ReadError::Format { .. }
    ));
    assert!(matches!(change("</Points>", "</Point>"), ReadError::Xml { at, .. } if at.line == 25));
    assert!(matches!(
        change("format=\"ascii\"", "format=\"appended\" offset=\"0\""),
        ReadError::Encoding { at, .. } if at.line == 6
    ));
    assert!(matches!(
        change(
            "header_type",
            "compressor=\"vtkLZ4DataCompressor\" header_type"
        ),
        ReadError::Encoding { .. }
    ));
    assert!(matches!(
        change("9 5 5 3 3 1", "12 5 5 3 3 1"),
        ReadError::ElementType {
            element: 0,
            why: Unsupported::Solid,
            ..
        }
    ));
    for (from, to) in [
        ("4 7 10 12 14 15", "4 8 10 12 14 15"),
        ("4 7 10 12 14 15", "4 7 10 12 14 99"),
        ("4 7 10 12 14 15", "4 -1 10 12 14 15"),
        ("0 1 4 3", "0 1 4 -3"),
        ("0 1 4 3", "0 1 four 3"),
        ("NumberOfPoints=\"6\"", "NumberOfPoints=\"six\""),
    ] {
        assert!(
            matches!(change(from, to), ReadError::Value { .. }),
            "{from} → {to}"
        );
    }
    for (from, to) in [
        ("NumberOfPoints=\"6\"", "NumberOfPoints=\"7\""),
        ("NumberOfCells=\"6\"", "NumberOfCells=\"9999999999999\""),
        ("1 2 2 1 2 0", "1 2 2"),
        ("Name=\"offsets\"", "Name=\"ends\""),
    ] {
        assert!(
            matches!(change(from, to), ReadError::MissingValue { .. }),
            "{from} → {to}"
        );
    }
    assert!(matches!(
        change("1 5 4", "1 9 4"),
        ReadError::MissingNode {
            element: 2,
            node: 9,
            ..
        }
    ));
    assert!(matches!(
        change(
            "    <Piece ",
            "    <Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"/>\n    <Piece "
        ),
        ReadError::Partitioned { .. }
    ));
}

#[test]
fn packed_arrays_may_not_claim_more_than_they_hold() {
    // The header of the coordinates: 5 blocks of 32 bytes.
    let header = "BQAAAAAAAAAgAAAAAAAAABAAAAAAAAAA";
    assert!(PACKED.contains(header));
    for other in [
        "BQAAAAAAAAD/////////fxAAAAAAAAAA",
        "/////////38gAAAAAAAAABAAAAAAAAAA",
        "BQAAAAAAAAAgAAAAAAAAABEAAAAAAAAA",
    ] {
        let text = PACKED.replacen(header, other, 1);
        assert!(matches!(
            refused(&text, Format::Vtk),
            ReadError::Value { .. }
        ));
    }
}

#[test]
fn numbers_of_points_are_no_sets() {
    let values: Vec<String> = (0..6).map(|k| (k + 1).to_string()).collect();
    let text = TEXT.replacen("Name=\"end\"", "Name=\"vtkOriginalPointIds\"", 1);
    let text = text.replacen("0 0 1 0 0 1", &values.join(" "), 1);
    let file = imported(&text, Format::Vtk);
    assert!(file.parts.node_sets.keys().eq(["corner"]));
}
