//! Circles of imports inside crates: none between subjects, and no more within families than today.

use std::fs;
use std::path::PathBuf;

use stickslip_tests::imports::{Counted, Imports};

/// Circles within families, of a module and its children that use each other, in each crate; others have none.
const FAMILIES: &[(&str, usize)] = &[
    ("contact", 2),
    ("engine", 2),
    ("fem-core", 2),
    ("friction", 1),
    ("joint", 1),
    ("laboratory", 2),
    ("laminate", 1),
    ("measure", 1),
    ("present", 4),
    ("report", 3),
    ("scene", 2),
    ("stickslip", 4),
];

/// The library crates with their imports.
fn crates() -> Vec<(String, Imports)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../crates");
    let entries = fs::read_dir(folder).expect("a readable folder");
    entries
        .map(|entry| entry.expect("a readable entry"))
        .filter(|entry| entry.path().join("src/lib.rs").is_file())
        .map(|entry| {
            let name = entry.file_name().to_string_lossy().into_owned();
            (name, Imports::of(&entry.path().join("src")))
        })
        .collect()
}

#[test]
fn no_circle_runs_between_subjects() {
    let mut found = Vec::new();
    for (name, imports) in crates() {
        for circle in imports.circles(Counted::BetweenSubjects) {
            let ties = imports.ties(&circle, Counted::BetweenSubjects);
            found.push(format!(
                "{name}: {}
{ties}
",
                circle.join(" ")
            ));
        }
    }
    assert!(
        found.is_empty(),
        "{}",
        found.join(
            "
"
        )
    );
}

#[test]
fn circles_within_families_grow_no_more() {
    let mut grown = Vec::new();
    for (name, imports) in crates() {
        let between = imports.circles(Counted::BetweenSubjects);
        let mut families = imports.circles(Counted::WithFamilies);
        families.retain(|circle| !between.contains(circle));
        let bound = FAMILIES.iter().find(|(other, _)| *other == name);
        let bound = bound.map_or(0, |(_, most)| *most);
        if families.len() != bound {
            let ties = families.iter();
            let ties: Vec<String> = ties
                .map(|circle| imports.ties(circle, Counted::WithFamilies))
                .collect();
            grown.push(format!(
                "{name}: {} circles, {bound} in the table:\n{}",
                families.len(),
                ties.join("\n\n")
            ));
        }
    }
    assert!(grown.is_empty(), "{}", grown.join("\n\n"));
}
