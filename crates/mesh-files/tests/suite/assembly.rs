//! Parts, instances and assemblies of Abaqus.

use stickslip_mesh_files::{Format, Note};

use super::{ends, imported, refused};

const PART: &str = include_str!("../data/part.inp");

#[test]
fn one_part_with_one_instance_is_read() {
    let file = imported(PART, Format::Abaqus);
    assert_eq!(file.node_numbers, [1, 2, 3, 4]);
    assert_eq!(ends(&file, "Surf-1"), [[2, 3]]);
    assert_eq!(ends(&file, "Fix"), [[4, 1]]);
    assert_eq!(file.parts.node_sets["again"], [0, 3]);
    assert!(!file.parts.element_sets.contains_key("_Surf-1_S2"));
    assert!(!file.parts.node_sets.contains_key("RP"));
    assert!(
        file.notes
            .iter()
            .any(|note| matches!(note, Note::OfAssembly { count: 2, .. }))
    );
}

#[test]
fn moved_and_further_instances_are_refused() {
    let moved = PART.replace("part=Plate\n", "part=Plate\n1., 0., 0.\n");
    let shown = refused(&moved, Format::Abaqus).to_string();
    assert!(
        shown.starts_with("line 14: instance 'Plate-1' is moved"),
        "{shown}"
    );
    let second = PART.replace(
        "*End Instance",
        "*End Instance\n*Instance, name=Plate-2, part=Plate\n*End Instance",
    );
    let shown = refused(&second, Format::Abaqus).to_string();
    assert!(
        shown.starts_with("line 15: 'Plate-2' is a second instance"),
        "{shown}"
    );
    assert!(shown.contains("write a flat file"), "{shown}");
}
