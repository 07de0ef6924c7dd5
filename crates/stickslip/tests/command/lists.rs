//! `list`, and arguments that make no sense.

use std::path::Path;

use serde_json::Value;

use super::{stickslip, succeeds};

#[test]
fn list_names_laws_with_their_parameters() {
    let printed = succeeds(Path::new("."), &["list"]);
    for part in [
        "coulomb",
        "mu",
        "slip_scale",
        "default \"committed\"",
        "pin-infinite-plate",
        "laminate-joint",
        "Q9",
        "pivoting",
        "ksi",
        "CSHEAR1",
        "bearing",
    ] {
        assert!(printed.contains(part), "'{part}' is missing in:\n{printed}");
    }
    let laws: Value =
        serde_json::from_str(&succeeds(Path::new("."), &["list", "laws", "--json"])).unwrap();
    let names: Vec<_> = laws["laws"]
        .as_array()
        .unwrap()
        .iter()
        .map(|law| law["name"].as_str().unwrap())
        .collect();
    assert_eq!(
        names,
        [
            "coulomb",
            "fibre_coverage",
            "pressure_power",
            "slip_power",
            "static_dynamic"
        ]
    );
}

#[test]
fn help_names_every_topic_of_list() {
    let help = succeeds(Path::new("."), &["list", "--help"]);
    let first = help.lines().next().unwrap();
    let topics: Value =
        serde_json::from_str(&succeeds(Path::new("."), &["list", "--json"])).unwrap();
    for topic in topics.as_object().unwrap().keys() {
        let topic = topic.replace("layups", "lay-ups");
        assert!(first.contains(&topic), "'{topic}' is missing in: {first}");
    }
}

#[test]
fn list_shows_layups_and_criteria_with_their_strengths() {
    let printed = succeeds(Path::new("."), &["list", "layups"]);
    assert!(printed.contains("[0/±45/90]s") && printed.contains("0, 45, -45, 90, 90, -45, 45, 0"));
    let criteria: Value =
        serde_json::from_str(&succeeds(Path::new("."), &["list", "criteria", "--json"])).unwrap();
    let criteria = criteria["criteria"].as_array().unwrap();
    let hashin = criteria
        .iter()
        .find(|entry| entry["name"] == "hashin")
        .unwrap();
    assert_eq!(
        hashin["strengths"],
        serde_json::json!(["xt", "xc", "yt", "yc", "s12", "s23"])
    );
    for entry in criteria {
        assert!(!entry["summary"].as_str().unwrap().is_empty(), "{entry}");
    }
    assert!(succeeds(Path::new("."), &["list", "criteria"]).contains("yamada_sun"));
}

#[test]
fn list_shows_point_models_with_their_parameters() {
    let printed = succeeds(Path::new("."), &["list", "models"]);
    assert!(
        printed.contains("plasticity") && printed.contains("hardening"),
        "{printed}"
    );
    let models: Value =
        serde_json::from_str(&succeeds(Path::new("."), &["list", "models", "--json"])).unwrap();
    let models = models["models"].as_array().unwrap();
    let names: Vec<_> = models.iter().map(|model| model["name"].as_str()).collect();
    assert_eq!(names, [Some("plasticity"), Some("ply_discount")]);
    assert_eq!(models[0]["parameters"][0]["dimension"], "stress");
}

#[test]
fn list_names_every_key_with_type_units_default_and_example() {
    let printed = succeeds(Path::new("."), &["list", "keys"]);
    for part in [
        "materials.NAME.isotropic",
        "young = \"70 GPa\"  (stress > 0 in MPa, GPa,",
        "substeps = 4  (integer from 1 to 100000; default 1; ",
        "Young's modulus E",
    ] {
        assert!(printed.contains(part), "'{part}' is missing in:\n{printed}");
    }
    let keys: Value =
        serde_json::from_str(&succeeds(Path::new("."), &["list", "keys", "--json"])).unwrap();
    let keys = keys["keys"].as_array().unwrap();
    assert!(keys.len() > 120, "{}", keys.len());
    let row = |table: &str, key: &str| {
        let found = keys
            .iter()
            .find(|row| row["table"] == table && row["key"] == key);
        found.unwrap_or_else(|| panic!("{table}.{key}"))
    };
    let spacing = row("mesh", "spacing");
    assert_eq!(spacing["type"], "angle or length > 0");
    assert_eq!(spacing["example"], "spacing = \"2 deg\"");
    assert!(spacing["units"].as_str().unwrap().contains("deg"));
    assert_eq!(row("output", "figures")["default"], "`true`");
}

#[test]
fn senseless_arguments_exit_with_two() {
    for arguments in [&["solve"][..], &["check"], &["list", "everything"], &[]] {
        let output = stickslip(Path::new("."), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(!output.stderr.is_empty());
    }
    assert!(stickslip(Path::new("."), &["--help"]).status.success());
}

#[test]
fn list_names_columns_with_units_and_signs() {
    // Cells wrap: a phrase may go on in the next line.
    let printed = succeeds(Path::new("."), &["list", "signs"]);
    let printed = printed.split_whitespace().collect::<Vec<_>>().join(" ");
    for part in [
        "CPRESS",
        "CSHEAR1",
        "COPEN",
        "CSLIP1",
        "CSTATUS",
        "stress",
        "compression positive",
        "gap, open positive",
    ] {
        assert!(printed.contains(part), "'{part}' is missing in:\n{printed}");
    }
    let signs: Value =
        serde_json::from_str(&succeeds(Path::new("."), &["list", "signs", "--json"])).unwrap();
    assert_eq!(signs["signs"]["columns"][3]["name"], "COPEN");
    assert_eq!(signs["signs"]["columns"][3]["unit"], "length");
    let rows = signs["signs"]["signs"].as_array().unwrap();
    let gap = rows.iter().find(|row| row["quantity"] == "COPEN").unwrap();
    assert_eq!(gap["meaning"], "gap, open positive, 0 in contact");
    assert!(gap["elsewhere"].as_str().unwrap().contains("Ansys"));
}

#[test]
fn invalid_arguments_are_reported_in_json_too() {
    for (arguments, part) in [
        (&["--json", "solve"][..], "unrecognized subcommand 'solve'"),
        (&["check", "--json"], "<SCENE>"),
        (
            &["run", "a.toml", "--json", "--quite"],
            "unexpected argument '--quite'",
        ),
    ] {
        let output = stickslip(Path::new("."), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let errors: Value = serde_json::from_slice(&output.stderr).unwrap();
        let error = &errors["errors"][0];
        assert_eq!(error["code"], "command::usage");
        assert!(error["message"].as_str().unwrap().contains(part), "{error}");
        assert!(
            error["help"].as_str().unwrap().contains("--help"),
            "{error}"
        );
    }
}
