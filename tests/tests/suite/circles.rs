//! Circles of imports inside crates: none between subjects, and no more within families than today.

use std::fs;
use std::path::PathBuf;

use stickslip_tests::imports::{Counted, Imports};

/// Modules in circles within families, of a module and its children that use each other, in each crate; others have none.
const FAMILIES: &[(&str, usize)] = &[
    ("contact", 2),
    ("engine", 7),
    ("experiment-pages", 2),
    ("fem-core", 4),
    ("friction", 2),
    ("joint", 3),
    ("laboratory", 4),
    ("laminate", 2),
    ("mesh-files", 3),
    ("series", 2),
    ("stickslip", 6),
    ("xtask", 26),
];

/// The crates and the tasks with their imports.
fn crates() -> Vec<(String, Imports)> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..");
    let entries = fs::read_dir(root.join("crates")).expect("a readable folder");
    let folders = entries.map(|entry| entry.expect("a readable entry").path());
    let sources = folders
        .chain(["xtask", "tests"].map(|name| root.join(name)))
        .filter(|folder| folder.join("src").is_dir());
    let named = |folder: PathBuf| {
        let name = folder.file_name().expect("a name").to_string_lossy();
        (name.into_owned(), Imports::of(&folder.join("src")))
    };
    sources.map(named).collect()
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
        let modules: usize = families.iter().map(Vec::len).sum();
        if modules != bound {
            let ties = families.iter();
            let ties: Vec<String> = ties
                .map(|circle| imports.ties(circle, Counted::WithFamilies))
                .collect();
            grown.push(format!(
                "{name}: {modules} modules, {bound} in the table:\n{}",
                ties.join("\n\n")
            ));
        }
    }
    assert!(grown.is_empty(), "{}", grown.join("\n\n"));
}
