//! Every defect has its line, the file's own number and a remedy.

use stickslip_fem_core::mesh::Mesh;
use stickslip_mesh_files::{Coincident, Format, read_with};

use super::{no_files, refused};

/// Four nodes of a square in lines 1 to 5.
const NODES: &str = "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n";
const SQUARE: &str = "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n*ELEMENT,TYPE=CPS4\n7,1,2,3,4\n";

fn abaqus(text: &str, parts: &[&str]) {
    shown(&refused(text, Format::Abaqus).to_string(), parts);
}

fn gmsh(text: &str, parts: &[&str]) {
    shown(&refused(text, Format::Gmsh).to_string(), parts);
}

fn shown(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "'{part}' in '{message}'");
    }
}

#[test]
fn defects_of_lines() {
    abaqus("1, 0, 0\n", &["line 1:", "does not begin", "extension"]);
    abaqus("", &["line 1:", "without a plane element"]);
    abaqus("*NODE\n1, 0, x\n", &["line 2:", "'x'", "coordinate"]);
    abaqus(
        "*NODE\n1.5, 0, 0\n",
        &["line 2:", "'1.5'", "number of a node"],
    );
    abaqus("*NODE\n1, 0, 1e999\n", &["line 2:", "node 1", "inf"]);
    abaqus("*NODE\n1, 0, nan\n", &["line 2:", "node 1", "NaN"]);
    abaqus("*NODE, SYSTEM=C\n1,1,0\n", &["line 1:", "flat file"]);
    abaqus("*NGEN\n1,5,1\n", &["line 1:", "*NGEN", "flat file"]);
    abaqus(&format!("{NODES}*ELEMENT\n"), &["line 6:", "TYPE"]);
    abaqus(
        &format!("{NODES}*ELEMENT,TYPE=CPS4\n7,1,2,3\n"),
        &["line 7:", "missing"],
    );
    abaqus(
        &format!("{NODES}*ELEMENT,TYPE=CPS4\n7,1,2,\n*NSET,NSET=a\n"),
        &["line 8:", "before this line"],
    );
    abaqus(
        &format!("{NODES}*ELEMENT,TYPE=CPS3\n7,1,2,3,4\n"),
        &["line 7:", "end of the element"],
    );
    abaqus(
        &format!("{SQUARE}*INCLUDE,INPUT=x.inp\n"),
        &["line 8:", "'x.inp'", "no file"],
    );
    abaqus(&format!("{SQUARE}*SURFACE\n7,S1\n"), &["line 8:", "NAME"]);
    abaqus(
        &format!("{SQUARE}*SURFACE,NAME=s\n7,S9\n"),
        &["line 9:", "'S9'", "S1 to S4"],
    );
    abaqus(
        &format!("{SQUARE}*NSET,NSET=a,GENERATE\n5,1\n"),
        &["line 9:", "ascending"],
    );
}

#[test]
fn defects_of_elements() {
    for (name, part) in [
        ("C3D8", "three-dimensional"),
        ("CAX4", "axisymmetric"),
        ("M3D4", "membrane"),
        ("S4R", "shell"),
        ("CPS9", "unknown"),
        ("CPS4X", "unknown"),
    ] {
        let text = format!("{NODES}*ELEMENT,TYPE={name}\n7,1,2,3,4\n");
        abaqus(&text, &["line 7: element 7", name, part]);
    }
    abaqus(
        &format!("{NODES}*ELEMENT,TYPE=CPS3\n7,1,2,9\n"),
        &["line 7: element 7", "node 9"],
    );
    abaqus(
        &format!("{SQUARE}7,1,2,3,1\n"),
        &["line 8: element 7", "at line 7"],
    );
    abaqus(
        &format!("{SQUARE}8,1,2,3,4\n"),
        &["line 8: element 8 overlaps element 7 (line 7)"],
    );
    abaqus(
        &SQUARE.replace("4,0,1", "4,0,1\n4,0,2"),
        &["line 6: node 4", "at line 5"],
    );
    abaqus(
        &SQUARE.replace("1,2,3,4", "1,2,4,3"),
        &["line 7: element 7 is", "mesh again"],
    );
    abaqus(
        &SQUARE.replace("3,1,1", "3,1,1,5"),
        &["line 4: node 3 has z = 5", "node 1"],
    );
    let crooked = "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n*ELEMENT,TYPE=CPS3\n1,1,2,3\n5,1,4,3\n";
    abaqus(
        crooked,
        &["line 8: element 5 is numbered clockwise", "reverse"],
    );
    let flat = "*NODE\n1,0,0\n2,1,0\n3,2,0\n*ELEMENT,TYPE=CPS3\n4,1,2,3\n";
    abaqus(flat, &["line 6: element 4 is degenerate"]);
    let mixed = "*NODE\n1,0,0\n2,2,0\n3,0,2\n4,1,0\n5,1,1\n6,0,1\n7,-1,0\n\
                 *ELEMENT,TYPE=CPS6\n8,1,2,3,4,5,6\n*ELEMENT,TYPE=CPS3\n9,1,3,7\n";
    abaqus(
        mixed,
        &[
            "line 12: element 9 (T3)",
            "element 8 (T6, line 10)",
            "one order",
        ],
    );
}

#[test]
fn defects_of_sets() {
    abaqus(
        &format!("{SQUARE}*NSET,NSET=a\n1,\n9\n"),
        &["line 10: node set 'a'", "node 9"],
    );
    abaqus(
        &format!("{SQUARE}*ELSET,ELSET=a\n7,8\n"),
        &["line 9: element set 'a'", "element 8"],
    );
    abaqus(
        &format!("{SQUARE}*NSET,NSET=a\nb\n"),
        &["line 9: node set 'a'", "set 'b'"],
    );
    abaqus(
        &format!("{SQUARE}*NSET,NSET=a\n*STEP\n"),
        &["line 8: node set 'a' is empty"],
    );
    abaqus(
        &format!("{SQUARE}*NSET,NSET=a,GENERATE\n8,9\n"),
        &["line 9:", "nodes 8 to 9"],
    );
    abaqus(
        &format!("{SQUARE}*SURFACE,NAME=a\n8,S1\n"),
        &["line 9: edge set 'a'", "element 8"],
    );
    abaqus(
        &format!("{SQUARE}*SURFACE,NAME=a\nc,S1\n"),
        &["line 9: edge set 'a'", "set 'c'"],
    );
    let triangle = SQUARE
        .replace("CPS4", "CPS3")
        .replace("7,1,2,3,4", "7,1,2,3");
    abaqus(
        &format!("{triangle}*SURFACE,NAME=a\n7,S4\n"),
        &["line 9: element 7", "S4"],
    );
    let truss = format!("{SQUARE}*ELEMENT,TYPE=T2D2,ELSET=bar\n8,1,3\n");
    abaqus(&truss, &["line 9: line element 8 of 'bar'", "take it out"]);
}

#[test]
fn torn_meshes_are_refused_unless_bodies_touch() {
    let torn = "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,1,0\n6,2,0\n7,2,1\n8,1,1\n\
                *ELEMENT,TYPE=CPS4\n1,1,2,3,4\n2,5,6,7,8\n";
    abaqus(
        torn,
        &[
            "line 6: node 5 and node 2 (line 3)",
            "(1, 0)",
            "merge coincident nodes",
        ],
    );
    let file = read_with(torn, Format::Abaqus, &no_files, Coincident::Allow);
    assert!(Mesh::new(file.expect("two bodies").parts).is_ok());
}

#[test]
fn set_sizes_are_bounded() {
    // Sets that name the set before them twice would double without end.
    let doubled = (1..60).map(|k| format!("*NSET,NSET=s{k}\ns{0},s{0}\n", k - 1));
    let doubled: String = doubled.collect();
    let text = format!("{SQUARE}*NSET,NSET=s0\n1,2,3,4\n{doubled}");
    abaqus(&text, &["members in all"]);
    let endless = format!("{SQUARE}*NSET,NSET=a,GENERATE\n1,18446744073709551615,1\n");
    assert_eq!(
        super::imported(&endless, Format::Abaqus).parts.node_sets["a"],
        [0, 1, 2, 3]
    );
}

#[test]
fn defects_of_gmsh_files() {
    const MIXED: &str = include_str!("../data/mixed-4.1.msh");
    gmsh("", &["line 0:", "does not begin"]);
    gmsh("*NODE\n", &["line 1:", "'*NODE'"]);
    gmsh("$NOD\n", &["line 1: format 1", "MshFileVersion"]);
    gmsh(
        &MIXED.replace("4.1 0", "4 0"),
        &["line 2: format 4 ", "4.1 or 2.2"],
    );
    gmsh(
        &MIXED.replace("4.1 0", "4.1 1"),
        &["line 2:", "binary", "Mesh.Binary = 0"],
    );
    gmsh(
        &MIXED.replace("$Periodic", "$PartitionedEntities"),
        &["line 54:", "partitioned"],
    );
    gmsh(
        &MIXED.replace("2 7 1 99", "3 7 1 99"),
        &["line 39: '$EndNodes'", "dimension"],
    );
    gmsh(
        &MIXED.replace("4 1 3 4\n", "4 1 3 44\n"),
        &["line 50: element 4", "node 44"],
    );
    gmsh(
        &MIXED.replace("2 1 2 2\n", "2 1 4 2\n"),
        &["line 49: element 5", "tetrahedron", "three-dimensional"],
    );
    gmsh(
        &MIXED.replace("2 1 2 2\n", "2 1 21 2\n"),
        &["line 49: element 5", "order 1 or 2"],
    );
    gmsh(
        &MIXED.replace("2 4 1\n", "2 4 2\n"),
        &["line 45: line element 2 of 'left edge'"],
    );
    gmsh(&MIXED[..400], &["the file ends", "export it again"]);
}
