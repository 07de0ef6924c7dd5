//! Files of Gmsh.

use stickslip_fem_core::mesh::ElementKind;
use stickslip_mesh_files::{Format, Note};

use super::{ends, imported};

const MIXED: &str = include_str!("../data/mixed-4.1.msh");
const QUAD9: &str = include_str!("../data/quad9-2.2.msh");

#[test]
fn a_file_of_version_4_has_its_groups_as_sets() {
    let file = imported(MIXED, Format::Gmsh);
    assert_eq!(file.node_numbers, [1, 2, 3, 4, 10, 11]);
    assert_eq!(file.cell_numbers, [4, 5, 6]);
    let blocks = &file.parts.blocks;
    let kinds: Vec<_> = blocks.iter().map(|b| (b.name.as_str(), b.kind)).collect();
    assert_eq!(
        kinds,
        [("plate-T3", ElementKind::T3), ("plate-Q4", ElementKind::Q4)]
    );
    assert_eq!(file.parts.element_sets["plate"], [0, 1, 2]);
    assert_eq!(file.parts.node_sets["corner"], [0]);
    assert_eq!(ends(&file, "left edge"), [[4, 1]]);
    // The line has a triangle on its left and a quadrilateral on its right.
    assert_eq!(ends(&file, "physical-3"), [[2, 3]]);
    assert_eq!(file.parts.edge_sets["physical-3"].edges[0].element, 1);
    assert!(file.notes.contains(&Note::UnusedNodes {
        count: 1,
        first: 99
    }));
    let inner = "physical-3".to_owned();
    assert!(file.notes.contains(&Note::InnerEdges {
        set: inner,
        count: 1
    }));
    let skipped =
        |note: &Note| matches!(note, Note::Skipped { keyword, .. } if keyword == "$Periodic");
    assert!(file.notes.iter().any(skipped));
}

#[test]
fn one_cell_in_two_groups_of_version_2_is_one_cell() {
    let file = imported(QUAD9, Format::Gmsh);
    assert_eq!(file.cell_numbers, [2]);
    assert_eq!(file.parts.blocks[0].kind, ElementKind::Q9);
    assert_eq!(file.parts.element_sets["physical-3"], [0]);
    assert_eq!(file.parts.element_sets["physical-4"], [0]);
    assert_eq!(file.parts.node_sets["physical-2"], [2]);
    assert_eq!(ends(&file, "bottom"), [[1, 2]]);
}

#[test]
fn clockwise_surfaces_are_turned_with_their_mid_nodes() {
    let turned = QUAD9.replace("1 2 3 4 5 6 7 8 9", "1 4 3 2 8 7 6 5 9");
    let file = imported(&turned, Format::Gmsh);
    assert_eq!(
        file.parts.blocks,
        imported(QUAD9, Format::Gmsh).parts.blocks
    );
    assert!(
        file.notes
            .iter()
            .any(|note| matches!(note, Note::Turned { count: 2, .. }))
    );
}

#[test]
fn line_ends_of_windows_and_a_byte_order_mark_are_read() {
    let windows = format!("\u{feff}{}", MIXED.replace('\n', "\r\n"));
    assert_eq!(
        imported(&windows, Format::Gmsh),
        imported(MIXED, Format::Gmsh)
    );
}

#[test]
fn extensions_name_formats() {
    assert_eq!(Format::of_name("a.b/part.INP"), Some(Format::Abaqus));
    assert_eq!(Format::of_name("plate.msh"), Some(Format::Gmsh));
    assert_eq!(Format::of_name("msh"), None);
}

#[test]
fn parametric_coordinates_and_further_tags_are_passed_over() {
    let mut text = MIXED
        .replace("2 2 1 3\n", "2 2 0 3\n")
        .replace("2 1 0 4\n", "2 1 1 4\n");
    for row in ["0 1 0", "1 1 0", "1 0 0", "0 0 0"] {
        text = text.replace(&format!("\n{row}\n"), &format!("\n{row} 0.5 0.25\n"));
    }
    for row in ["2 0 0 0 0\n", "2 1 0 0 0\n", "5 5 0 0 0\n"] {
        text = text.replace(row, &format!("{}\n", &row[..5]));
    }
    assert_eq!(
        imported(&text, Format::Gmsh).parts,
        imported(MIXED, Format::Gmsh).parts
    );
    let tags = QUAD9.replace("3 10 2 4 6 ", "3 10 4 4 6 1 9 ");
    assert_eq!(imported(&tags, Format::Gmsh), imported(QUAD9, Format::Gmsh));
}

#[test]
fn counts_of_headers_reserve_nothing() {
    for count in ["18446744073709551615", "1000000000000"] {
        let text = MIXED.replace("2 1 0 4\n", &format!("2 1 0 {count}\n"));
        let error = super::refused(&text, Format::Gmsh).to_string();
        assert!(error.contains("the number of a node"), "{error}");
    }
}
