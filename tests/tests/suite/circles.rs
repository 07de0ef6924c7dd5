//! Circles of imports inside crates: none between subjects or top-level modules, and no more within families than today.

use std::fs;
use std::path::PathBuf;

use stickslip_tests::imports::{Counted, Imports};

/// Circles within families, of a module and its children that use each other, by their modules; other crates have none.
const FAMILIES: &[(&str, &str)] = &[
    ("contact", "problem.rs problem/link.rs"),
    (
        "engine",
        "model.rs model/fasteners.rs model/request.rs model/room.rs model/series.rs",
    ),
    ("engine", "model/meshes.rs model/meshes/angles.rs"),
    ("experiment-pages", "gallery.rs gallery/restart.rs"),
    ("fem-core", "body/condensed.rs body/condensed/section.rs"),
    ("fem-core", "mesh.rs mesh/check.rs"),
    ("friction", "contract.rs contract/symmetry.rs"),
    (
        "joint",
        "mode_call.rs mode_call/evidence.rs mode_call/zones.rs",
    ),
    ("laboratory", "discrete.rs discrete/conditions.rs"),
    ("laboratory", "problems.rs problems/expected.rs"),
    ("laminate", "layup.rs layup/parse.rs"),
    ("mesh-files", "abaqus.rs abaqus/assembly.rs abaqus/data.rs"),
    ("series", "kernel.rs kernel/pairs.rs"),
    (
        "stickslip",
        "folder.rs folder/error.rs folder/hidden.rs folder/swap.rs",
    ),
    ("stickslip", "sweep/plan.rs sweep/plan/read.rs"),
    (
        "xtask",
        "chart.rs chart/summary.rs chart/text.rs chart/text/programs.rs chart/unmeshed.rs",
    ),
    (
        "xtask",
        "chart/peers.rs chart/peers/calculix.rs chart/peers/getfem.rs chart/peers/job.rs",
    ),
    ("xtask", "load_shares.rs load_shares/holes.rs"),
    (
        "xtask",
        "main.rs same_answers.rs same_answers/baseline.rs torture.rs torture/writers.rs torture/writers/command.rs torture/writers/fault.rs torture/writers/prepared.rs",
    ),
    (
        "xtask",
        "torture/scenes/random.rs torture/scenes/random/materials.rs",
    ),
    (
        "xtask",
        "validate.rs validate/mutants.rs validate/render.rs",
    ),
    ("xtask", "validate/laws.rs validate/laws/transition.rs"),
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

/// Refuses circles between subjects in what `view` makes of the imports of each crate.
fn assert_no_circle(view: impl Fn(Imports) -> Imports) {
    let mut found = Vec::new();
    for (name, imports) in crates() {
        let imports = view(imports);
        for circle in imports.circles(Counted::BetweenSubjects) {
            let ties = imports.ties(&circle, Counted::BetweenSubjects);
            found.push(format!("{name}: {}\n{ties}\n", circle.join(" ")));
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn no_circle_runs_between_subjects() {
    assert_no_circle(|imports| imports);
}

#[test]
fn no_circle_runs_between_top_level_modules() {
    assert_no_circle(|imports| imports.between_modules());
}

#[test]
fn circles_within_families_are_those_of_the_table() {
    let mut found = Vec::new();
    let mut ties = String::new();
    for (name, imports) in crates() {
        let between = imports.circles(Counted::BetweenSubjects);
        let families = imports.circles(Counted::WithFamilies);
        for circle in families.iter().filter(|circle| !between.contains(circle)) {
            let own = (name.clone(), circle.join(" "));
            if !FAMILIES.contains(&(&own.0, &own.1)) {
                ties += &imports.ties(circle, Counted::WithFamilies);
                ties += "\n\n";
            }
            found.push(own);
        }
    }
    found.sort();
    let found: Vec<_> = found.iter().map(|own| (&*own.0, &*own.1)).collect();
    assert_eq!(found, FAMILIES, "{ties}");
}
