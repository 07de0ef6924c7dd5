//! Input files of Abaqus and CalculiX.

use std::io;

use stickslip_fem_core::mesh::ElementKind;
use stickslip_mesh_files::{Format, Note, read};

use super::{ends, imported};

const FLAT: &str = include_str!("../data/flat.inp");

#[test]
fn a_flat_file_has_its_sets_and_surfaces() {
    let file = imported(FLAT, Format::Abaqus);
    assert_eq!(file.node_numbers, [1, 2, 3, 11, 12, 13, 21, 22]);
    assert_eq!(file.cell_numbers, [1, 2, 3, 4]);
    let parts = &file.parts;
    let kinds: Vec<_> = parts
        .blocks
        .iter()
        .map(|b| (b.name.as_str(), b.kind))
        .collect();
    assert_eq!(
        kinds,
        [("Quads", ElementKind::Q4), ("triangles", ElementKind::T3)]
    );
    assert_eq!(parts.nodes[1], [1.0, 0.0]);
    let nodes = |name: &str| parts.node_sets[name].iter().map(|&k| file.node_numbers[k]);
    assert_eq!(nodes("Left").collect::<Vec<_>>(), [1, 11, 21]);
    assert_eq!(nodes("two").collect::<Vec<_>>(), [1, 2, 3, 11, 12, 21]);
    assert_eq!(nodes("touching").collect::<Vec<_>>(), [1, 2, 3, 21]);
    assert_eq!(nodes("Nall").count(), 8);
    assert_eq!(parts.element_sets["some"], [0, 2]);
    assert_eq!(parts.element_sets["both"], [0, 1, 3]);
    assert_eq!(ends(&file, "right"), [[3, 13]]);
    assert_eq!(
        ends(&file, "outer"),
        [
            [1, 2],
            [11, 1],
            [2, 3],
            [3, 13],
            [13, 12],
            [22, 21],
            [21, 11]
        ]
    );
}

#[test]
fn node_sets_along_the_boundary_are_edge_sets() {
    let file = imported(FLAT, Format::Abaqus);
    assert_eq!(ends(&file, "Left"), [[11, 1], [21, 11]]);
    assert_eq!(ends(&file, "base"), [[1, 2], [2, 3]]);
    // Node 12 is off the chain of "two", and "touching" has gaps.
    for name in ["two", "touching"] {
        assert!(!file.parts.edge_sets.contains_key(name), "{name}");
    }
    let note = Note::EdgesFromNodes {
        sets: ["Left", "Nall", "base"].map(str::to_owned).into(),
    };
    assert!(file.notes.contains(&note), "{:?}", file.notes);
    let note = Note::NoEdges {
        sets: ["touching", "two"].map(str::to_owned).into(),
    };
    assert!(file.notes.contains(&note), "{:?}", file.notes);
    // A node set beside a surface of its name, without one of its nodes.
    let other = FLAT.replacen(
        "*NSET, NSET=two",
        "*NSET, NSET=right\n3\n*NSET, NSET=two",
        1,
    );
    let note = Note::OtherNodes {
        set: "right".to_owned(),
    };
    let file = imported(&other, Format::Abaqus);
    assert!(file.notes.contains(&note), "{:?}", file.notes);
}

#[test]
fn keywords_of_the_analysis_are_noted_with_their_lines() {
    let file = imported(FLAT, Format::Abaqus);
    let unused = Note::UnusedNodes {
        count: 1,
        first: 900,
    };
    assert!(file.notes.contains(&unused), "{:?}", file.notes);
    let shown: Vec<String> = file.notes.iter().map(Note::to_string).collect();
    for expected in [
        "*MATERIAL passed over: line 41",
        "*BOUNDARY passed over: line 46",
        "*NODE PRINT passed over: line 48",
        "node set 'Nall': 1 member of no cell dropped",
    ] {
        assert!(
            shown.iter().any(|note| note == expected),
            "{expected} in {shown:#?}"
        );
    }
}

#[test]
fn faces_follow_cells_that_are_turned() {
    let counter = "*NODE\n1,0,0\n2,2,0\n3,0,2\n4,1,0\n5,1,1\n6,0,1\n*ELEMENT,TYPE=CPS6\n1,1,2,3,4,5,6\n*SURFACE,NAME=s\n1,S1\n";
    let clockwise = counter.replace("1,1,2,3,4,5,6", "1,1,3,2,6,5,4");
    assert_eq!(ends(&imported(counter, Format::Abaqus), "s"), [[1, 2]]);
    assert_eq!(ends(&imported(&clockwise, Format::Abaqus), "s"), [[3, 1]]);
}

#[test]
fn lines_mark_edges_as_gmsh_writes_them() {
    let text = "*NODE\n1,0,0\n2,2,0\n3,2,2\n4,0,2\n5,1,0\n6,2,1\n7,1,2\n8,0,1\n\
                *ELEMENT, type=T3D3, ELSET=Line1\n1, 1, 5, 2\n\
                *ELEMENT, type=CPS8, ELSET=Surface1\n2, 1, 2, 3, 4, 5, 6, 7, 8\n\
                *ELSET, ELSET=all\n1, 2\n";
    let file = imported(text, Format::Abaqus);
    assert_eq!(ends(&file, "Line1"), [[1, 2]]);
    assert_eq!(ends(&file, "all"), [[1, 2]]);
    assert_eq!(file.parts.element_sets["all"], [0]);
}

#[test]
fn files_are_included_and_errors_name_them() {
    let text = "*NODE\n*INCLUDE, INPUT=nodes.inc\n*ELEMENT, TYPE=CPS3, INPUT=cells.inc\n";
    let includes = |cells: &'static str| {
        move |name: &str| match name {
            "nodes.inc" => Ok("1, 0, 0\n2, 1, 0\n".to_owned() + "*INCLUDE, INPUT=more.inc"),
            "more.inc" => Ok("3, 0, 1".to_owned()),
            "cells.inc" => Ok(cells.to_owned()),
            _ => Err(io::ErrorKind::NotFound.into()),
        }
    };
    let file = read(text, Format::Abaqus, &includes("1, 1, 2, 3")).expect("a triangle");
    assert_eq!(file.node_numbers, [1, 2, 3]);
    let error = read(text, Format::Abaqus, &includes("1, 1, 2, 3\n2, 1, 2, 4"));
    let shown = error.expect_err("no node 4").to_string();
    assert!(
        shown.starts_with("line 2 of 'cells.inc': element 2 names node 4"),
        "{shown}"
    );
    let endless = |_: &str| Ok("*INCLUDE, INPUT=again".to_owned());
    let shown = read(text, Format::Abaqus, &endless)
        .expect_err("a circle")
        .to_string();
    assert!(shown.contains("too often"), "{shown}");
}
