//! Circles of imports inside crates: the known ones, with the reason why each stays, and no other.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use stickslip_tests::imports::{Counted, Imports};

/// Circles between subjects: the crate, why the circle stays ("open": it is to go), and its files below the crate's `src`.
const CIRCLES: &str = "
scene: open
    build/failure.rs build/progressive.rs
scene: open
    experiment/candidate.rs experiment/history.rs experiment/plan.rs experiment/plan/laws.rs experiment/plan/read.rs
    experiment/plan/settings.rs experiment/plan/specimen.rs experiment/plan/states.rs
";

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
    ("scene", 3),
    ("stickslip", 4),
];

/// The rows of [`CIRCLES`]: crates and their files.
fn known() -> BTreeSet<(String, Vec<String>)> {
    let mut rows: Vec<(String, Vec<String>)> = Vec::new();
    for line in CIRCLES.lines() {
        if !line.starts_with(' ') {
            let name = line.split(": ").next().unwrap_or_default();
            rows.push((name.to_owned(), Vec::new()));
        } else if let Some((_, files)) = rows.last_mut() {
            files.extend(line.split_whitespace().map(str::to_owned));
        }
    }
    rows.into_iter()
        .filter(|(_, files)| !files.is_empty())
        .collect()
}

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
fn circles_between_subjects_are_those_that_are_known() {
    let mut known = known();
    let mut unknown = Vec::new();
    for (name, imports) in crates() {
        for circle in imports.circles(Counted::BetweenSubjects) {
            let ties = imports.ties(&circle, Counted::BetweenSubjects);
            let files = circle.join(" ");
            if !known.remove(&(name.clone(), circle)) {
                unknown.push(format!("{name}: open\n    {files}\n\n{ties}\n"));
            }
        }
    }
    assert!(
        unknown.is_empty(),
        "circles that the table does not know:\n{}",
        unknown.join("\n")
    );
    assert!(
        known.is_empty(),
        "circles that are gone, to be taken out of the table: {known:#?}"
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
