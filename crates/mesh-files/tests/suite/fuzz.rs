//! Damaged files give an error or a mesh, and never a panic.

use proptest::prelude::*;
use stickslip_fem_core::mesh::Mesh;
use stickslip_mesh_files::{Format, put_on_circles, read, recognise_set, snap};

const FILES: [(&str, Format); 6] = [
    (include_str!("../data/mixed-4.1.msh"), Format::Gmsh),
    (include_str!("../data/quad9-2.2.msh"), Format::Gmsh),
    (include_str!("../data/flat.inp"), Format::Abaqus),
    (include_str!("../data/part.inp"), Format::Abaqus),
    (include_str!("../data/strip.vtu"), Format::Vtk),
    (include_str!("../data/strip-packed.vtu"), Format::Vtk),
];

/// Reads a text in all formats; what is read is a valid mesh.
fn try_all(text: &str) {
    for format in [Format::Gmsh, Format::Abaqus, Format::Vtk] {
        let includes = |name: &str| Ok(name.to_owned());
        if let Ok(file) = read(text, format, &includes) {
            let mut parts = file.parts;
            for set in parts.edge_sets.clone().keys() {
                let _ = recognise_set(&parts, set);
                let _ = snap(&mut parts.clone(), set);
                let _ = put_on_circles(&mut parts.clone(), std::slice::from_ref(set), &[]);
            }
            parts
                .edge_sets
                .values_mut()
                .for_each(|set| set.curve = None);
            assert!(Mesh::new(parts).is_ok());
        }
    }
}

#[test]
fn every_truncation_is_read_or_refused() {
    for (text, _) in FILES {
        for end in 0..text.len() {
            try_all(&text[..end]);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn changed_bytes_are_read_or_refused(
        which in 0..FILES.len(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), b' '..b'~'), 1..6),
    ) {
        let mut bytes = FILES[which].0.as_bytes().to_vec();
        for (place, byte) in changes {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        try_all(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn changed_words_are_read_or_refused(
        which in 0..FILES.len(),
        place in any::<prop::sample::Index>(),
        word in prop::sample::select(vec![
            "0", "1", "-1", "2", "99", "18446744073709551615", "9223372036854775807", "1e308", "-1e308", "5e-324", "nan", "inf", "", "*NODE",
            "$EndNodes", "$Nodes", "é", "\"", ",", "=",
        ]),
    ) {
        let mut words: Vec<&str> = FILES[which].0.split_inclusive([' ', '\n', ',']).collect();
        let place = place.index(words.len());
        let changed = format!("{word}{}", words[place].chars().last().unwrap_or(' '));
        words[place] = &changed;
        try_all(&words.concat());
    }

    #[test]
    fn lines_in_any_order_are_read_or_refused(
        which in 0..FILES.len(),
        swaps in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>()), 1..8),
    ) {
        let mut lines: Vec<&str> = FILES[which].0.lines().collect();
        for (a, b) in swaps {
            let (a, b) = (a.index(lines.len()), b.index(lines.len()));
            lines.swap(a, b);
        }
        try_all(&lines.join("\n"));
    }
}
