//! Meshes of other programs: given instead of a scene, and files that a scene names and that cannot be used.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use super::{fails, folder_with, succeeds};

const SCENE: &str = r#"version = 1
materials.metal.isotropic = { young = "70 GPa", poisson = 0.33 }
[bodies.part]
material = "metal"
thickness = "2 mm"
shape.mesh = { file = "part.inp", unit = "mm" }
[[supports]]
on = "part.left"
fix = ["x", "y"]
[[loads]]
on = "part.right"
force = { direction = [1, 0], steps = ["1 kN"] }
[output]
figures = false
fields = "none"
"#;

const MESH: &str = "** a square\n*NODE\n1,0,0\n2,10,0\n3,10,10\n4,0,10\n*ELEMENT,TYPE=CPS4,ELSET=all\n7,1,2,3,4\n\
                    *NSET,NSET=left\n1,4\n*NSET,NSET=right\n2,3\n*NSET,NSET=corner\n3\n";

/// The scene beside its mesh `mesh`.
fn folder(mesh: &str) -> TempDir {
    let folder = folder_with("scene.toml", SCENE);
    fs::write(folder.path().join("part.inp"), mesh).unwrap();
    folder
}

#[track_caller]
fn holds(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "'{part}' is missing in:\n{message}");
    }
}

/// What `stickslip check` says of the scene, with one finding only.
#[track_caller]
fn one_finding(folder: &Path, parts: &[&str]) {
    let message = fails(folder, &["check", "scene.toml"]);
    holds(&message, parts);
    assert_eq!(message.matches("help:").count(), 1, "{message}");
}

#[test]
fn a_mesh_is_no_scene_and_its_sets_are_named() {
    let folder = folder(MESH);
    for command in ["run", "check", "joint", "reduce"] {
        let message = fails(folder.path(), &[command, "part.inp"]);
        holds(
            &message,
            &[
                "'part.inp' is a mesh of Abaqus",
                "not a scene",
                "shape.mesh = { file = \"part.inp\", unit = \"mm\" }",
                "Edges of the file: 'left', 'right'. Its points: 'corner'.",
            ],
        );
        assert!(!message.contains("TOML:"), "{message}");
    }
    let message = fails(folder.path(), &["check", "part.inp", "--json"]);
    let errors: serde_json::Value = serde_json::from_str(&message).unwrap();
    let help = errors["errors"][0]["help"].as_str().unwrap();
    // What is printed is a scene that runs.
    let [_, scene, _] = help.splitn(3, "\n\n").collect::<Vec<_>>()[..] else {
        panic!("{help}");
    };
    fs::write(folder.path().join("printed.toml"), scene).unwrap();
    succeeds(
        folder.path(),
        &["run", "printed.toml", "--set", "output.figures=false"],
    );
}

#[test]
fn a_grid_of_vtk_is_a_mesh_too() {
    let grid = include_str!("../../../mesh-files/tests/data/strip-packed.vtu");
    let folder = folder_with("scene.toml", &SCENE.replace("part.inp", "part.vtu"));
    fs::write(folder.path().join("part.vtu"), grid).unwrap();
    let message = fails(folder.path(), &["check", "part.vtu"]);
    let sets =
        "Edges of the file: 'end', 'gmsh:physical-1', 'gmsh:physical-2'. Its points: 'corner'.";
    holds(
        &message,
        &["'part.vtu' is a mesh of VTK, not a scene", sets],
    );
    let set = ["supports.0.on=part.gmsh:physical-1", "loads.0.on=part.end"];
    let printed = succeeds(
        folder.path(),
        &["run", "scene.toml", "--set", set[0], "--set", set[1]],
    );
    holds(&printed, &["of a mesh from a file none are known"]);
    let written = fs::read_to_string(folder.path().join("scene-results/summary.json")).unwrap();
    holds(&written, &["('u') passed over: line 9"]);
    let raw = [grid.as_bytes(), b"<AppendedData encoding=\"raw\">_\xff\xfe"].concat();
    fs::write(folder.path().join("part.vtu"), raw).unwrap();
    one_finding(folder.path(), &["is not UTF-8 text", "ParaView: Ascii"]);
}

#[test]
fn parts_of_a_mesh_that_nothing_holds_are_refused_with_what_to_do() {
    let two = MESH.replace(
        "*ELEMENT",
        "11,20,0\n12,30,0\n13,30,10\n14,20,10\n*ELEMENT,TYPE=CPS4,ELSET=other\n8,11,12,13,14\n*ELEMENT",
    );
    let folder = folder(&two);
    let message = fails(folder.path(), &["run", "scene.toml"]);
    holds(
        &message,
        &[
            "one of 2, can move freely",
            "bodies.part.shape.mesh",
            "as `elements`",
        ],
    );
    let one = "bodies.part.shape.mesh.elements=all";
    succeeds(folder.path(), &["run", "scene.toml", "--set", one]);
}

#[test]
fn a_mesh_that_cannot_be_read_says_why_beside_the_scene() {
    let folder = folder(&MESH.replace("7,1,2,3,4", "7,1,2,3,9"));
    let message = fails(folder.path(), &["check", "part.inp"]);
    holds(&message, &["not a scene", "line 8: element 7 names node 9"]);
    let folder = self::folder(MESH.split("*NSET").next().unwrap());
    let message = fails(folder.path(), &["check", "part.inp"]);
    holds(&message, &["The file names no edge", "on = \"part.left\""]);
}

#[test]
fn files_of_other_programs_are_known_by_name_or_first_line() {
    let folder = TempDir::new().unwrap();
    for (name, text, what) in [
        ("a.msh", "$MeshFormat\n2.2 0 8\n", "a mesh of Gmsh"),
        ("a", "$MeshFormat\n2.2 0 8\n", "a mesh of Gmsh"),
        (
            "b.txt",
            "\n** comment\n*HEADING\n",
            "a mesh of Abaqus or CalculiX",
        ),
        ("c.vtu", "", "a mesh of VTK"),
        ("c.vtk", "# vtk DataFile Version 3.0\n", "a file of VTK"),
        (
            "c.toml",
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\">\n",
            "a mesh of VTK",
        ),
        ("d.STL", "", "a surface of triangles (STL)"),
        (
            "d",
            "solid part\n  facet normal 0 0 1\n",
            "a surface of triangles (STL)",
        ),
        ("e.step", "", "a geometry (STEP)"),
        ("e", "ISO-10303-21;\n", "a geometry (STEP)"),
    ] {
        fs::write(folder.path().join(name), text).unwrap();
        let message = fails(folder.path(), &["run", name]);
        holds(&message, &[&format!("'{name}' is {what}, not a scene")]);
        holds(&message, &["unit = \"mm\""]);
        let is_read = what.starts_with("a mesh of");
        assert_eq!(message.contains("save it as .msh"), !is_read, "{message}");
    }
    let message = fails(folder.path(), &["run", "b.txt"]);
    holds(&message, &["rename it to 'b.inp'", "file = \"b.inp\""]);
    for text in ["solid = 3\n", "# a comment\nsolid.facet = 1\n"] {
        fs::write(folder.path().join("plain.toml"), text).unwrap();
        let message = fails(folder.path(), &["run", "plain.toml"]);
        holds(&message, &["does not say which version"]);
    }
    let message = fails(folder.path(), &["run", "none.inp"]);
    holds(&message, &["the scene file 'none.inp' does not exist"]);
}

#[test]
fn a_file_that_is_refused_draws_no_second_error() {
    let folder = folder(&MESH.replace("7,1,2,3,4", "7,1,2,3,9"));
    one_finding(
        folder.path(),
        &["element 7 names node 9", "export it again"],
    );
    fs::remove_file(folder.path().join("part.inp")).unwrap();
    one_finding(
        folder.path(),
        &["part.inp", "relative to the folder of the scene"],
    );
    fs::create_dir(folder.path().join("part.inp")).unwrap();
    one_finding(folder.path(), &["it is a folder", "name the file"]);
    let folder = self::folder(MESH);
    fs::write(folder.path().join("part.inp"), b"*NODE\n\xff\n").unwrap();
    one_finding(
        folder.path(),
        &["line 2 is not UTF-8 text", "save the mesh as text"],
    );
}

#[test]
fn a_set_that_is_missing_draws_no_second_error() {
    let folder = folder(MESH);
    let wrong = SCENE.replace("part.left", "part.leftt");
    fs::write(folder.path().join("scene.toml"), wrong).unwrap();
    one_finding(folder.path(), &["'leftt'", "did you mean 'part.left'?"]);
    let unheld = SCENE.replace(
        "[[supports]]\non = \"part.left\"\nfix = [\"x\", \"y\"]\n",
        "",
    );
    fs::write(folder.path().join("scene.toml"), unheld).unwrap();
    one_finding(folder.path(), &["nothing holds 'part'"]);
}

#[test]
fn slender_cells_reach_the_reader_with_the_number_of_the_file() {
    let folder = folder(&MESH.replace(",10,10\n4,0,10", ",10,0.3\n4,0,0.3"));
    let printed = succeeds(folder.path(), &["check", "scene.toml"]);
    holds(
        &printed,
        &[
            "1 element has sides more than 20 times",
            "element 7 with 33.3 times",
        ],
    );
    let folder = self::folder(&MESH.replace(",10,10\n4,0,10", ",10,1e-5\n4,0,1e-5"));
    one_finding(
        folder.path(),
        &["line 8: element 7 has a side", "mesh again"],
    );
}

/// A file of 800 GB that takes no room.
#[cfg(target_os = "linux")]
#[test]
fn a_mesh_beyond_the_memory_has_a_remedy_of_its_own() {
    let folder = folder(MESH);
    let file = fs::File::create(folder.path().join("part.inp")).unwrap();
    file.set_len(800_000_000_000).unwrap();
    one_finding(folder.path(), &["it has 800.0 GB", "fewer elements"]);
    let message = fails(folder.path(), &["check", "part.inp"]);
    holds(&message, &["not a scene", "it has 800.0 GB"]);
}

/// Links within the folder are followed, and those that leave it refused.
#[cfg(unix)]
#[test]
fn an_include_leaves_the_folder_of_the_mesh_by_no_link() {
    use std::os::unix::fs::symlink;
    let [head, cells] = MESH.split_at(MESH.find("*ELEMENT").unwrap()).into();
    let folder = folder(&format!("{head}*INCLUDE, INPUT=cells.inc\n"));
    let elsewhere = folder_with("secret.inc", cells);
    let place = |name: &str| folder.path().join(name);
    fs::write(place("own.inc"), cells).unwrap();
    symlink("own.inc", place("cells.inc")).unwrap();
    succeeds(folder.path(), &["check", "scene.toml"]);
    fs::remove_file(place("cells.inc")).unwrap();
    symlink(elsewhere.path().join("secret.inc"), place("cells.inc")).unwrap();
    let parts = [
        "'cells.inc' cannot be included",
        "a link leads to '",
        "secret.inc'",
    ];
    one_finding(folder.path(), &parts);
    let message = fails(folder.path(), &["check", "part.inp"]);
    holds(&message, &parts);
    fs::remove_file(place("cells.inc")).unwrap();
    symlink(elsewhere.path(), place("away")).unwrap();
    fs::write(
        place("part.inp"),
        format!("{head}*INCLUDE, INPUT=away/secret.inc\n"),
    )
    .unwrap();
    one_finding(folder.path(), &["a link leads to '"]);
}
