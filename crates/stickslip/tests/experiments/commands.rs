//! Commands that are given the wrong kind of file, and `check` of an experiment.

use super::{FRINGES, SCENE, TABLE, fails, folder_with, grid, stickslip, succeeds};

fn linear(x: f64, y: f64) -> [f64; 2] {
    [1e-3 * x + 2e-4 * y, 2e-4 * x - 3e-4 * y]
}

#[test]
fn run_and_the_chain_say_which_command_reads_a_file() {
    let folder = folder_with(&[
        ("scene.toml", SCENE),
        ("e.toml", TABLE),
        ("up.csv", &grid("x,y,u,v", linear)),
    ]);
    let path = folder.path();
    let error = fails(path, &["run", "e.toml"]);
    for part in [
        "'e.toml' is an experiment",
        "stickslip reduce e.toml",
        "stickslip identify",
    ] {
        assert!(error.contains(part), "{part}: {error}");
    }
    for command in ["reduce", "hybrid", "identify", "fringes"] {
        let error = fails(path, &[command, "scene.toml"]);
        for part in [
            "'scene.toml' is a scene",
            "stickslip run scene.toml",
            "init experiment",
        ] {
            assert!(error.contains(part), "{part}: {error}");
        }
    }
    let sweep =
        "version = 1\nscene = \"scene.toml\"\n[[axes]]\nname = \"friction\"\nvalues = [0.1]\n";
    std::fs::write(path.join("s.toml"), sweep).unwrap();
    for command in ["run", "check", "hybrid"] {
        let error = fails(path, &[command, "s.toml"]);
        for part in ["'s.toml' is a sweep", "stickslip joint s.toml"] {
            assert!(error.contains(part), "{command}: {error}");
        }
    }
    for (file, what) in [
        ("scene.toml", "is a scene, not a sweep"),
        ("e.toml", "is an experiment"),
    ] {
        let error = fails(path, &["joint", file]);
        assert!(error.contains(&format!("'{file}' {what}")), "{error}");
    }
    // Nothing was begun.
    assert!(!path.join("e-results").exists() && !path.join("scene-results").exists());
}

#[test]
fn check_reads_an_experiment_with_its_data() {
    let region = "[region]\nsector = { angles = [\"-90 deg\", \"90 deg\"], outer = \"9 mm\", cells = [12, 3] }\n";
    let mut table = grid("x,y,u,v", linear);
    table = table.replacen("\n6,6,", "\n6,6,9", 1);
    let folder = folder_with(&[("e.toml", &format!("{TABLE}{region}")), ("up.csv", &table)]);
    let path = folder.path();
    let output = stickslip(path, &["check", "e.toml"]);
    let text = String::from_utf8(output.stdout).unwrap();
    for part in [
        "e.toml",
        "up (loading): 'up.csv'",
        "U valid at",
        "sector of 12 x 3 cells",
        "stickslip hybrid e.toml",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    assert!(output.stderr.is_empty() && output.status.success());
    assert!(text.contains("outliers"), "{text}");
    let summary = succeeds(path, &["check", "e.toml"]);
    assert!(
        summary["checked"].as_array().unwrap().len() > 4,
        "{summary}"
    );
    let findings = summary["findings"].as_array().unwrap();
    assert!(
        findings.iter().any(|finding| finding["kind"] == "outliers"),
        "{summary}"
    );
    // What is wrong with the data shows as in the chain.
    let error = fails(
        path,
        &["check", "e.toml", "--set", "states.0.table.file=none.csv"],
    );
    assert!(error.contains("none.csv"), "{error}");
    let far = "region.sector.outer=40 mm";
    let error = fails(path, &["check", "e.toml", "--set", far]);
    assert!(error.contains("do not cover the region"), "{error}");
    assert!(!path.join("e-results").exists());
}

#[test]
fn check_does_not_solve_the_scene_of_synthetic_states() {
    let folder = folder_with(&[("scene.toml", SCENE), ("e.toml", FRINGES)]);
    let output = stickslip(folder.path(), &["check", "e.toml"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        text.contains("step-1: synthetic pictures of the scene"),
        "{text}"
    );
    assert!(text.contains("body 'plate' of 'scene.toml'"), "{text}");
}
