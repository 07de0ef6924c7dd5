//! Unstructured grids of VTK.

use stickslip_fem_core::mesh::{ElementBlock, ElementKind};
use stickslip_fem_core::vtk::write_vtu;
use stickslip_mesh_files::{Foreign, Format, Note, ReadError, Unsupported};

use super::round_trip::meshes;
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
    let reals = |note: &Note| matches!(note, Note::Skipped { keyword, at, .. } if keyword.starts_with("arrays that are no sets") && keyword.ends_with("('u')") && at.line == 9);
    assert!(file.notes.iter().any(reals), "{:?}", file.notes);
}

#[test]
fn a_grid_is_known_by_its_first_line() {
    let head = "<VTKFile version=\"1.0\" type=\"UnstructuredGrid\">";
    for text in [TEXT, head] {
        let found = Foreign::of_text(text).and_then(|known| known.format);
        assert_eq!(found, Some(Format::Vtk));
    }
    let other = Foreign::of_text("<VTKFile type=\"PolyData\">");
    assert_eq!(other.map(|known| known.format), Some(None));
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
    let kinds = [
        ElementKind::T3,
        ElementKind::T6,
        ElementKind::Q4,
        ElementKind::Q8,
        ElementKind::Q9,
    ];
    for mesh in kinds.into_iter().flat_map(meshes) {
        let mut written = Vec::new();
        write_vtu(&mesh, &[], &[], &mut written).unwrap();
        let again = imported(std::str::from_utf8(&written).unwrap(), Format::Vtk);
        assert_eq!(again.parts.nodes, mesh.nodes());
        let cells = |blocks: &[ElementBlock]| -> Vec<_> {
            let own = blocks.iter();
            own.map(|block| (block.kind, block.connectivity.clone()))
                .collect()
        };
        assert_eq!(cells(&again.parts.blocks), cells(mesh.blocks()));
    }
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
    for (from, to) in [
        ("LittleEndian", "MiddleEndian"),
        ("header_type=\"UInt32\"", "header_type=\"Int8\""),
    ] {
        assert!(
            matches!(change(from, to), ReadError::Encoding { .. }),
            "{from} → {to}"
        );
    }
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
        // A node behind the last end.
        ("3 0 2 5 0", "3 0 2 5 0 1"),
        ("0 1 4 3", "0 1 4 -3"),
        ("0 1 4 3", "0 1 four 3"),
        ("NumberOfPoints=\"6\"", "NumberOfPoints=\"six\""),
        // A node behind the last end.
        ("4 7 10 12 14 15", "4 7 10 12 14 14"),
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
            ReadError::Damaged { .. }
        ));
    }
}

#[test]
fn a_last_block_is_not_larger_than_the_others() {
    let text = PACKED.replacen(
        "BQAAAAAAAAAgAAAAAAAAABAAAAAAAAAA",
        "BQAAAAAAAAAgAAAAAAAAACEAAAAAAAAA",
        1,
    );
    assert!(
        matches!(refused(&text, Format::Vtk), ReadError::Damaged { what, .. } if what.contains("last block"))
    );
}

/// Zeros pack to a thousandth: what a short file may unpack to is bounded by its length, whatever number of cells it states.
#[test]
fn a_short_file_does_not_unpack_to_gigabytes() {
    let packed = miniz_oxide::deflate::compress_to_vec_zlib(&vec![0; 1 << 25], 9);
    let mut bytes = Vec::new();
    for count in [1, 1 << 25, 1 << 25, packed.len() as u64] {
        bytes.extend(count.to_le_bytes());
    }
    bytes.extend(packed);
    let array = base64::Engine::encode(&base64::engine::general_purpose::STANDARD, bytes);
    let text = format!(
        r#"<VTKFile type="UnstructuredGrid" header_type="UInt64" compressor="vtkZLibDataCompressor"><UnstructuredGrid>
        <Piece NumberOfPoints="3" NumberOfCells="33554432"><Points><DataArray type="Float64" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>
        <Cells><DataArray type="UInt8" Name="types" format="binary">{array}</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>"#
    );
    assert!(matches!(refused(&text, Format::Vtk), ReadError::Damaged { at, .. } if at.line == 3));
}

/// Nor to sets of more members than points and cells that it can hold.
#[test]
fn members_of_sets_are_bounded_by_the_length_of_the_file() {
    let count = 100_000;
    let array = |name: &str, kind: &str, bytes: &[u8]| {
        let packed = miniz_oxide::deflate::compress_to_vec_zlib(bytes, 9);
        let (size, own) = (bytes.len() as u32, packed.len() as u32);
        let mut all: Vec<u8> = [1, size, 0, own]
            .into_iter()
            .flat_map(u32::to_le_bytes)
            .collect();
        all.extend(packed);
        let text = base64::Engine::encode(&base64::engine::general_purpose::STANDARD, all);
        format!(r#"<DataArray type="{kind}" Name="{name}" format="binary">{text}</DataArray>"#)
    };
    let points = array("points", "Float32", &vec![0; 12 * count]);
    let sets: String = (0..4)
        .map(|k| array(&format!("s{k}"), "UInt8", &vec![1; count]))
        .collect();
    let text = format!(
        r#"<VTKFile type="UnstructuredGrid" compressor="vtkZLibDataCompressor"><UnstructuredGrid>
        <Piece NumberOfPoints="{count}" NumberOfCells="1"><Points>{points}</Points><Cells>
        <DataArray type="Int32" Name="connectivity">0 1 2</DataArray><DataArray type="Int32" Name="offsets">3</DataArray>
        <DataArray type="UInt8" Name="types">5</DataArray></Cells><PointData>{sets}</PointData></Piece></UnstructuredGrid></VTKFile>{}"#,
        " ".repeat(16_000)
    );
    assert!(matches!(
        refused(&text, Format::Vtk),
        ReadError::SetsTooLarge { .. }
    ));
}

#[test]
fn numbers_of_points_and_cells_are_no_sets() {
    let values: Vec<String> = (0..6).map(|k| (k + 1).to_string()).collect();
    for name in ["vtkOriginalPointIds", "GlobalNodeId"] {
        let text = TEXT.replacen("Name=\"end\"", &format!("Name=\"{name}\""), 1);
        let text = text.replacen("0 0 1 0 0 1", &values.join(" "), 1);
        let file = imported(&text, Format::Vtk);
        assert!(file.parts.node_sets.keys().eq(["corner"]), "{name}");
    }
    // With a value that comes twice an array of as many values as points but one is no numbering.
    let text = TEXT.replacen("0 0 1 0 0 1", "1 2 3 4 5 5", 1);
    let file = imported(&text, Format::Vtk);
    assert_eq!(file.parts.node_sets["end-5"], [4, 5]);
    let text = TEXT.replacen("<PointData", "<PointData GlobalIds=\"end\"", 1);
    let file = imported(&text, Format::Vtk);
    assert!(file.parts.node_sets.keys().eq(["corner"]));
}

#[test]
fn ghosts_are_no_material() {
    let ghosts = |values: &str| {
        let array = format!(
            "<CellData><DataArray type=\"UInt8\" Name=\"vtkGhostType\" format=\"ascii\">{values}</DataArray>"
        );
        assert!(TEXT.contains("<CellData>"));
        TEXT.replacen("<CellData>", &array, 1)
    };
    let plain = imported(TEXT, Format::Vtk);
    let marked = imported(&ghosts("0 0 0 0 0 0"), Format::Vtk);
    assert_eq!(marked.parts, plain.parts);
    let refused = refused(&ghosts("0 0 32 0 0 0"), Format::Vtk);
    assert!(
        matches!(&refused, ReadError::Ghosts { array, .. } if array == "vtkGhostType"),
        "{refused}"
    );
}

/// Nor may a point as a cell and a point make one, while an edge may have the name of a node set.
#[test]
fn two_arrays_may_not_make_one_set() {
    let points = TEXT.replacen("Name=\"end\"", "Name=\"corner\"", 1);
    assert!(
        matches!(refused(&points, Format::Vtk), ReadError::SameSet { set, .. } if set == "corner")
    );
    let other = "<DataArray type=\"Int8\" Name=\"gmsh:physical-1\" format=\"ascii\">1 0 0 0 0 0</DataArray></CellData>";
    let text = TEXT.replacen("</CellData>", other, 1);
    assert!(
        matches!(refused(&text, Format::Vtk), ReadError::SameSet { set, .. } if set == "gmsh:physical-1")
    );
}

/// Nodes of every kind of cell in the order of VTK: corners, then the middles of edges, then the centre; clockwise ones are turned.
#[test]
fn cells_of_every_type_are_read_whichever_way_they_go() {
    let nodes = "0 0 0 2 0 0 2 2 0 0 2 0 1 0 0 2 1 0 1 2 0 0 1 0 1 1 0";
    let turned = |order: &[usize]| {
        let corners = order.len().min(8) / 2;
        let mut cell = order.to_vec();
        cell[1..corners].reverse();
        cell[corners..2 * corners].reverse();
        cell
    };
    for (kind, number, order) in [
        (ElementKind::T6, 22, &[0, 1, 3, 4, 8, 7][..]),
        (ElementKind::Q8, 23, &[0, 1, 2, 3, 4, 5, 6, 7]),
        (ElementKind::Q9, 28, &[0, 1, 2, 3, 4, 5, 6, 7, 8]),
    ] {
        let clockwise = match kind {
            ElementKind::T6 => vec![0, 3, 1, 7, 8, 4],
            _ => turned(order),
        };
        let text = |order: &[usize]| {
            let cell: Vec<String> = order.iter().map(ToString::to_string).collect();
            let (all, edge) = (order.len(), "0 1 4");
            format!(
                r#"<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="9" NumberOfCells="2">
                <Points><DataArray type="Float32" NumberOfComponents="3">{nodes}</DataArray></Points>
                <Cells><DataArray type="Int32" Name="connectivity">{} {edge}</DataArray>
                <DataArray type="Int32" Name="offsets">{all} {}</DataArray>
                <DataArray type="UInt8" Name="types">{number} 21</DataArray></Cells>
                <CellData><DataArray type="Int32" Name="bottom">0 1</DataArray></CellData>
                </Piece></UnstructuredGrid></VTKFile>"#,
                cell.join(" "),
                all + 3
            )
        };
        let file = imported(&text(order), Format::Vtk);
        let block = &file.parts.blocks[0];
        let own = |node: &usize| file.node_numbers[*node] as usize;
        assert_eq!(block.kind, kind);
        assert!(block.connectivity.iter().map(own).eq(order.iter().copied()));
        assert_eq!(ends(&file, "bottom"), [[0, 1]]);
        let other = imported(&text(&clockwise), Format::Vtk);
        assert_eq!(other.parts, file.parts);
        assert!(other.notes.contains(&Note::Turned { count: 1, first: 0 }));
    }
}

/// Surfaces that touch may go opposite ways; a folded one covers its neighbour.
#[test]
fn cells_are_turned_one_by_one() {
    let text = TEXT.replacen("0 1 4 3", "3 4 1 0", 1);
    let file = imported(&text, Format::Vtk);
    let cell = file.cell_numbers.iter().position(|&cell| cell == 0);
    assert_eq!(cell, Some(2));
    assert!(file.notes.contains(&Note::Turned { count: 1, first: 0 }));
    assert_eq!(
        file.parts.element_sets,
        imported(TEXT, Format::Vtk).parts.element_sets
    );
    let folded = TEXT.replacen("1.0 1.0 0.0", "1.6 0.2 0.0", 1);
    assert_ne!(folded, TEXT);
    assert!(matches!(
        refused(&folded, Format::Vtk),
        ReadError::Overlap { .. }
    ));
}
