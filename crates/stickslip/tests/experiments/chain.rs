//! Synthetic pictures, their files, and the way back from them.

use std::fs;

use stickslip::experiment::Experiment;
use stickslip::experiment::truth::Truth;
use stickslip::host::HOST;
use stickslip_hybrid::fringe::decode;

use super::{FRINGES, SCENE, fails, findings, folder_with, numbers, succeeds};

const STATES: &str = r#"
[[states]]
name = "up"
step = 2
[[states]]
name = "down"
step = 3
null = { step = 1 }
"#;

#[test]
fn every_load_step_is_a_state_where_none_is_named() {
    let folder = folder_with(&[("scene.toml", SCENE), ("e.toml", FRINGES)]);
    succeeds(folder.path(), &["fringes", "e.toml", "--output", "out"]);
    for name in ["step-1", "step-2", "step-3"] {
        for field in ["u", "v"] {
            let path = format!("out/fringes/{name}-{field}.png");
            let raster = decode(&fs::read(folder.path().join(path)).unwrap()).unwrap();
            assert_eq!([raster.columns, raster.rows], [250, 250]);
        }
    }
    let page = fs::read_to_string(folder.path().join("out/index.html")).unwrap();
    for part in [
        "step-3",
        "unloading",
        "500 N",
        "a grating of 2400",
        "U field",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert!(folder.path().join("out/gallery.png").is_file());
    assert!(!page.contains("finer than two pixels"));
    let coarse = [
        "fringes",
        "e.toml",
        "--output",
        "coarse",
        "--set",
        "fringes.pixel=0.1 mm",
    ];
    let summary = succeeds(folder.path(), &coarse);
    let fine = findings(&summary, "fine_fringes");
    assert_eq!(fine[0]["level"], "warning");
    for found in &fine {
        let part = found["part"].as_f64().unwrap();
        assert!(part > 0.0 && part < 1.0, "{found}");
    }
    let warning = summary["warnings"][0].as_str().unwrap();
    assert!(warning.contains("finer than two pixels"), "{warning}");
    assert!(
        folder
            .path()
            .join("out/figures/fringes-step-2.svg")
            .is_file()
    );
}

/// The same numbers come from the pictures in memory and from their files, and pictures do not depend on when they are taken.
#[test]
fn the_chain_restarts_from_its_pictures() {
    let text = format!(
        "{FRINGES}order_error = 0.1\nmissing = [{{ centre = [\"9 mm\", \"3 mm\"], radius = \"0.5 mm\" }}]\n{STATES}"
    );
    for set in [
        "fringes.bits=8",
        "fringes.bits=16",
        "fringes.pictures=four",
        "fringes.format=tiff",
    ] {
        // A smaller window: all of this is about equality alone.
        let text = text.replace(
            "[[\"2 mm\", \"-5 mm\"], [\"12 mm\", \"5 mm\"]]",
            "[[\"4 mm\", \"-2 mm\"], [\"10 mm\", \"4 mm\"]]",
        );
        let folder = folder_with(&[("scene.toml", SCENE), ("e.toml", &text)]);
        let path = folder.path();
        let own = succeeds(path, &["reduce", "e.toml", "--output", "own", "--set", set]);
        let read = succeeds(path, &["reduce", "own/measured.toml", "--output", "read"]);
        assert_eq!(own["measured"], read["measured"], "{set}");
        for table in ["measured-up.csv", "measured-down.csv"] {
            let both = ["own", "read"].map(|run| fs::read(path.join(run).join(table)).unwrap());
            assert!(both[0] == both[1], "{set} {table}");
        }
        succeeds(
            path,
            &["fringes", "e.toml", "--output", "again", "--set", set],
        );
        let name = if set.ends_with("tiff") {
            "up-u.tiff"
        } else {
            "up-u.png"
        };
        let name = if set.ends_with("four") {
            "up-u-3.png"
        } else {
            name
        };
        let both = ["own", "again"]
            .map(|run| fs::read(path.join(run).join("fringes").join(name)).unwrap());
        assert!(both[0] == both[1], "{set}");
    }
}

/// Displacements of clean pictures are those of the scene to 0.01 fringe (root mean square) away from edges, up to a constant.
#[test]
fn clean_pictures_give_the_displacements_of_the_scene() {
    let text = format!("{FRINGES}{STATES}");
    let folder = folder_with(&[("scene.toml", SCENE), ("e.toml", &text)]);
    let path = folder.path();
    succeeds(path, &["reduce", "e.toml", "--output", "out"]);
    let experiment = Experiment::from_file(&path.join("e.toml"), &[] as &[&str], HOST).unwrap();
    let truth = Truth::solve(experiment.specimen.scene.as_ref().unwrap(), &mut |_| ()).unwrap();
    for (name, steps) in [("up", [1, usize::MAX]), ("down", [2, 0])] {
        let rows = numbers(&path.join(format!("out/measured-{name}.csv")));
        let inside: Vec<&Vec<f64>> = rows
            .iter()
            .filter(|row| {
                let [x, y] = [row[0], row[1]];
                x.hypot(y) > 5.5 && x > 2.5 && x < 11.5 && y.abs() < 4.5
            })
            .collect();
        assert!(inside.len() > 1000, "{}", inside.len());
        let places: Vec<[f64; 2]> = inside.iter().map(|row| [row[0], row[1]]).collect();
        let sampling = truth.sampled(&places);
        for axis in 0..2 {
            let own = truth.component(&sampling, steps[0], axis);
            let null = truth.component(&sampling, steps[1], axis);
            let errors: Vec<f64> = (0..inside.len())
                .filter(|&k| inside[k][2 + axis].is_finite())
                .map(|k| {
                    let null = if steps[1] == usize::MAX {
                        0.0
                    } else {
                        null[k].unwrap()
                    };
                    2400.0 * (inside[k][2 + axis] - (own[k].unwrap() - null))
                })
                .collect();
            let mean = errors.iter().sum::<f64>() / errors.len() as f64;
            let square: f64 = errors.iter().map(|error| (error - mean).powi(2)).sum();
            let rms = (square / errors.len() as f64).sqrt();
            println!(
                "{name}, component {axis}: {rms:.5} fringes at {} places",
                errors.len()
            );
            assert!(rms < 0.01, "{name} {axis}: {rms}");
        }
    }
}

#[test]
fn a_mirrored_half_moves_as_its_other_half_and_the_body_ends_at_its_edge() {
    let folder = folder_with(&[("scene.toml", SCENE), ("e.toml", FRINGES)]);
    let experiment =
        Experiment::from_file(&folder.path().join("e.toml"), &[] as &[&str], HOST).unwrap();
    let truth = Truth::solve(experiment.specimen.scene.as_ref().unwrap(), &mut |_| ()).unwrap();
    assert!(truth.is_half());
    let sampling = truth.sampled(&[[7.0, 2.0], [7.0, -2.0], [1.0, 1.0], [30.0, 0.0]]);
    let u = truth.component(&sampling, 1, 0);
    let v = truth.component(&sampling, 1, 1);
    assert_eq!(u[0], u[1]);
    assert_eq!(v[0], v[1].map(|v| -v));
    assert!(v[0].is_some() && u[2].is_none() && u[3].is_none());
}

#[test]
fn front_and_back_are_compared_along_a_line() {
    let symmetry =
        "[reduce]\nsymmetry = { from = [\"6 mm\", \"0 mm\"], to = [\"11 mm\", \"3 mm\"] }\n";
    let states = "[[states]]\nname = \"up\"\nstep = 2\nback = { step = BACK }\n";
    let text = format!("{FRINGES}{symmetry}{states}");
    for (back, symmetric) in [("2", true), ("3", false)] {
        let text = text.replace("BACK", back);
        let folder = folder_with(&[("scene.toml", SCENE), ("e.toml", &text)]);
        let summary = succeeds(folder.path(), &["reduce", "e.toml"]);
        assert_eq!(
            summary["measured"][0]["u"]["symmetric"], symmetric,
            "{summary}"
        );
        let largest = summary["measured"][0]["u"]["symmetry_fringes"]
            .as_f64()
            .unwrap();
        assert_eq!(largest <= 0.25, symmetric, "{largest}");
        // The null field is the front's alone: without it in either, the comparison is the same.
        let nulled = text.replace("step = 2\n", "step = 2\nnull = { step = 3 }\n");
        fs::write(folder.path().join("e.toml"), nulled).unwrap();
        let nulled = succeeds(folder.path(), &["reduce", "e.toml", "--force"]);
        assert_eq!(
            nulled["measured"][0]["u"]["symmetry_fringes"],
            summary["measured"][0]["u"]["symmetry_fringes"],
            "{nulled}"
        );
    }
}

#[test]
fn an_experiment_without_synthetic_states_has_no_pictures_to_make() {
    let folder = folder_with(&[("e.toml", super::TABLE)]);
    let error = fails(folder.path(), &["fringes", "e.toml"]);
    assert!(
        error.contains("no state has synthetic pictures") && error.contains("stickslip reduce"),
        "{error}"
    );
    assert!(!folder.path().join("e-results").exists());
}

/// The scene, a mesh and the pictures are found again when all are moved together; a line of symmetry goes with its backs.
#[test]
fn the_experiment_written_beside_pictures_moves_with_its_folder() {
    let text = format!(
        "{FRINGES}{STATES}edge_force = {{ x = \"0.5 kN\" }}\nback.table = {{ file = \"back.csv\", scale = \"1 mm\", y_axis = \"up\", deviation = \"1e-4 mm\" }}\n\
         [reduce]\nsymmetry = {{ from = [\"7 mm\", \"0 mm\"], to = [\"9 mm\", \"1 mm\"], tolerance = 1e9 }}\n"
    );
    let back = super::grid("x,y,u,v", |x, y| [1e-3 * x, 1e-3 * y]);
    let folder = folder_with(&[("back.csv", &back)]);
    let inner = folder.path().join("first/scenes");
    fs::create_dir_all(&inner).unwrap();
    for (name, text) in [
        ("scene.toml", SCENE),
        ("e.toml", &text),
        ("back.csv", &back),
    ] {
        fs::write(inner.join(name), text).unwrap();
    }
    let from = folder.path().join("first");
    succeeds(
        &from,
        &["fringes", "scenes/e.toml", "--output", "out/pictures"],
    );
    let written = fs::read_to_string(from.join("out/pictures/measured.toml")).unwrap();
    assert!(
        written.contains("scene = \"../../scenes/scene.toml\""),
        "{written}"
    );
    assert!(
        written.contains("[states.edge_force]\nx = \"500 N\""),
        "{written}"
    );
    assert!(
        written.contains("symmetry") && written.contains("file = \"../../scenes/back.csv\""),
        "{written}"
    );
    let moved = folder.path().join("elsewhere");
    fs::rename(&from, &moved).unwrap();
    succeeds(
        &moved,
        &["reduce", "out/pictures/measured.toml", "--output", "read"],
    );
}

/// A measured null field of synthetic pictures, and a measured state that a slip zone names, are read from where they are.
#[test]
fn measured_data_beside_synthetic_pictures_are_kept() {
    let table = |file: &str| {
        format!(
            "table = {{ file = \"{file}\", scale = \"1 mm\", y_axis = \"up\", deviation = \"1e-4 mm\" }}\n"
        )
    };
    let text = format!(
        "{FRINGES}[[states]]\nname = \"up\"\nstep = 2\nnull.{}[[states]]\nname = \"other\"\nload = \"1 kN\"\n{}\
         [identify]\nzones = [{{ state = \"other\", from = \"10 deg\", to = \"20 deg\" }}]\n",
        table("null.csv"),
        table("other.csv")
    );
    let small = super::grid("x,y,u,v", |x, y| [1e-4 * x, 1e-4 * y]);
    let folder = folder_with(&[
        ("scene.toml", SCENE),
        ("e.toml", &text),
        ("null.csv", &small),
        ("other.csv", &small),
    ]);
    let path = folder.path();
    let own = succeeds(path, &["reduce", "e.toml", "--output", "deep/own"]);
    let read = succeeds(
        path,
        &["reduce", "deep/own/measured.toml", "--output", "read"],
    );
    assert_eq!(own["measured"].as_array().unwrap().len(), 2);
    assert_eq!(own["measured"], read["measured"]);
}
