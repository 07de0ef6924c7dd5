//! Messages that say the particular thing: a name that an override mistypes, the setting that does not fit, the load that was reached.

use super::{SCENE, fails, folder_with, succeeds};

/// A message without the frame and the line breaks that a terminal gives it.
fn flat(message: &str) -> String {
    let words = message.split_whitespace().filter(|word| *word != "│");
    words.collect::<Vec<_>>().join(" ")
}

/// What `check` says of the scene with these changes.
fn refused(changes: &[&str]) -> String {
    let folder = folder_with("pin.toml", SCENE);
    let mut arguments = vec!["check", "pin.toml"];
    for change in changes {
        arguments.extend(["--set", change]);
    }
    flat(&fails(folder.path(), &arguments))
}

#[test]
fn a_mistyped_name_is_no_new_entry() {
    for (change, what, name, meant) in [
        ("bodies.plaet.material=steel", "body", "plaet", "plate"),
        ("bodies.pln.shape.disk.radius=5 mm", "body", "pln", "pin"),
        ("bodies.plate2.thickness=1 mm", "body", "plate2", "plate"),
        (
            "materials.stele.isotropic.young=200 GPa",
            "material",
            "stele",
            "steel",
        ),
    ] {
        let message = refused(&[change]);
        for part in [
            format!("there is no {what} '{name}'"),
            format!("did you mean '{meant}'?"),
            change.to_owned(),
        ] {
            assert!(
                message.contains(&part),
                "'{part}' is missing in:\n{message}"
            );
        }
    }
    // An entry that has all it needs is a new one.
    let folder = folder_with("pin.toml", SCENE);
    let brass = "materials.brass.isotropic={ young = \"100 GPa\", poisson = 0.3 }";
    let printed = succeeds(folder.path(), &["check", "pin.toml", "--set", brass]);
    assert!(printed.contains("[materials.brass.isotropic]"), "{printed}");
}

#[test]
fn of_two_settings_that_do_not_fit_the_more_particular_one_is_shown() {
    let graded = ["mesh.fine_to=90 deg", "mesh.coarse_spacing=8 deg"];
    let with = |more: &[&'static str]| {
        let all: Vec<&str> = graded.iter().chain(more).copied().collect();
        refused(&all)
    };
    // The body's own coarse spacing does not fit the scene's spacing, which stands in the scene's table.
    let message = with(&["bodies.plate.mesh.coarse_spacing=5 deg"]);
    for part in ["coarse_spacing = 5 deg", "at least mesh.spacing, 6 deg"] {
        assert!(message.contains(part), "'{part}' is missing in:\n{message}");
    }
    // The body's own spacing exceeds where the scene's fine zone ends.
    let folder = folder_with(
        "pin.toml",
        &SCENE.replace(
            "spacing = \"6 deg\"",
            "spacing = \"6 deg\"\nfine_to = \"90 deg\"\ncoarse_spacing = \"8 deg\"",
        ),
    );
    let override_only = ["check", "pin.toml", "--set", "mesh.spacing=10 deg"];
    let message = flat(&fails(folder.path(), &override_only));
    for part in [
        "spacing = 10 deg is outside its range",
        "at most mesh.coarse_spacing, 8 deg",
        "mesh.spacing=10 deg",
    ] {
        assert!(message.contains(part), "'{part}' is missing in:\n{message}");
    }
    // What the scene's own table says is reported once, and not for every body that inherits it.
    let twice = [
        "check",
        "pin.toml",
        "--set",
        "mesh.spacing=10 deg",
        "--set",
        "bodies.plate.mesh.fine_to=100 deg",
    ];
    let message = flat(&fails(folder.path(), &twice));
    assert_eq!(
        message.matches("is outside its range").count(),
        1,
        "{message}"
    );
}

/// A plate that is turned about a rigid pin: friction alone resists, by the moment μ P R k, k from 1 to 4/π for a bearing pressure between
/// that of a point and a cosine, so it turns at a force of 1 kN · 0.2 · 5 mm · k / 90 mm.
#[test]
fn the_load_that_was_reached_has_a_unit() {
    let folder = folder_with("pin.toml", SCENE);
    let loads = "loads=[{ name = \"pull\", on = \"plate.left\", force = { direction = [-1, 0], steps = [\"1 kN\", \"1 kN\"] } }, \
                 { name = \"turn\", on = \"plate.left\", force = { direction = [0, 1], steps = [\"0 N\", \"100 N\"] } }]";
    let run = ["run", "pin.toml", "--output", "out", "--set"];
    // An elastic pin that is held at its centre alone turns with the plate.
    let changes = ["bodies.pin.rigid=true", "--set", loads];
    let message = flat(&fails(folder.path(), &[&run[..], &changes].concat()));
    assert!(message.contains("beyond pull 1000 N, turn "), "{message}");
    let after = message.split("turn ").nth(1).unwrap();
    let value: f64 = after.split(' ').next().unwrap().parse().unwrap();
    assert!((11.1..14.2).contains(&value), "{message}");
}
