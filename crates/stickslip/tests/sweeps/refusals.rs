//! What is wrong with a sweep is said at its line, with what would do.

use stickslip::host::HOST;
use stickslip::sweep::Sweep;

use super::{COARSE, SWEEP, folder_with};

/// What a sweep with this text is refused with: "line: message | remedy".
fn refusal(text: &str) -> String {
    let folder = folder_with(text);
    let error = Sweep::from_file(&folder.path().join("sweep.toml"), &[COARSE], HOST).unwrap_err();
    let found = error.findings()[0].summary();
    format!(
        "{}: {} | {}",
        found.line.unwrap_or_default(),
        found.message,
        found.help.unwrap_or_default()
    )
}

fn says(text: &str, line: usize, words: &[&str]) {
    let found = refusal(text);
    assert!(found.starts_with(&format!("{line}: ")), "{found}");
    for word in words {
        assert!(found.contains(word), "{word}: {found}");
    }
}

#[test]
fn keys_are_known() {
    says(
        &SWEEP.replace("title", "titel"),
        2,
        &["titel", "did you mean 'title'"],
    );
    says(
        &SWEEP.replace("version = 1", "version = 2"),
        1,
        &["version 2", "version = 1"],
    );
    says(
        &SWEEP.replace("version = 1\n", ""),
        1,
        &["'version' is missing", "version = 1"],
    );
    says(
        &SWEEP.replace("\"mu\"", "\"mju\""),
        8,
        &["'mju' is not an axis", "did you mean 'mu'", "layup"],
    );
    let without = SWEEP.split("[[axes]]").next().unwrap();
    assert!(
        refusal(without).contains("'axes' is missing"),
        "{}",
        refusal(without)
    );
}

#[test]
fn values_are_in_their_ranges() {
    let with = |values: &str| SWEEP.replace("[2, 4, 5]", values);
    says(&with("[2, 0.5]"), 6, &["e_over_d = 0.5", "more than 0.5"]);
    says(&with("[2, \"3 mm\"]"), 6, &["\"3 mm\"", "more than 0.5"]);
    says(&with("[]"), 6, &["at least one value"]);
    let width = SWEEP.replace("e_over_d", "w_over_d");
    says(
        &width.replace("[2, 4, 5]", "[1]"),
        6,
        &["w_over_d = 1", "more than 1"],
    );
    let clearance = SWEEP.replace("e_over_d", "clearance");
    says(
        &clearance.replace("[2, 4, 5]", "[0.01]"),
        6,
        &["clearance", "\"0.01 mm\""],
    );
    let larger = clearance.replace("[2, 4, 5]", "[\"0.01 mm\", \"-0.01 mm\"]");
    says(
        &larger,
        6,
        &[
            "radial clearance = -0.01 mm",
            "larger than the hole",
            "interference",
        ],
    );
    let layup = SWEEP.replace("e_over_d", "layup");
    says(
        &layup.replace("[2, 4, 5]", "[\"[0/x]s\"]"),
        6,
        &["lay-up = [0/x]s"],
    );
}

#[test]
fn an_axis_has_values_or_ends() {
    let with = |text: &str| SWEEP.replace("values = [2, 4, 5]", text);
    says(
        &with("from = 2"),
        4,
        &["exactly one of 'values' or 'from'", "found from"],
    );
    says(
        &with("values = [2]\ncount = 3"),
        4,
        &["found values, count"],
    );
    says(
        &with("from = 2\nto = \"3 mm\"\ncount = 3"),
        6,
        &["no steps from 2 to", "one dimension"],
    );
    says(
        &with("from = 2\nto = 3\ncount = 0"),
        8,
        &["count = 0", "from 2 to"],
    );
    says(
        &with("from = 2\nto = 3\ncount = 1"),
        8,
        &["count = 1", "values = [2]"],
    );
    let twice = SWEEP
        .replace("\"mu\"", "\"e_over_d\"")
        .replace("[0, 0.3]", "[3]");
    says(&twice, 8, &["two axes 'e_over_d'"]);
}

#[test]
fn axes_set_different_keys() {
    let with = |one: &str, values: &str| {
        let own = SWEEP.replace("\"e_over_d\"", &format!("\"{one}\""));
        own.replace("[2, 4, 5]", values)
    };
    says(
        &with("contacts.0.friction.coulomb.mu", "[0.1]"),
        8,
        &["both set contacts.0.friction.coulomb.mu", "leave one"],
    );
    says(
        &with("contacts.0.friction", "[{ coulomb = { mu = 0.2 } }]"),
        8,
        &["'contacts.0.friction' and 'mu'"],
    );
    let radius = with("bodies.pin.shape.disk.radius", "[\"2.9 mm\"]");
    says(
        &radius
            .replace("\"mu\"", "\"clearance\"")
            .replace("[0, 0.3]", "[\"0.01 mm\"]"),
        8,
        &["'bodies.pin.shape.disk.radius' and 'clearance'"],
    );
}

#[test]
fn names_are_those_of_the_scene() {
    let with = |text: &str| {
        SWEEP.replace(
            "[[axes]]\nkey = \"mu\"",
            &format!("{text}\n[[axes]]\nkey = \"mu\""),
        )
    };
    says(
        &with("[joint]\ncontact = \"pim\""),
        8,
        &["'pim'", "did you mean 'pin'"],
    );
    says(
        &with("[joint]\ncriterion = \"hashin\""),
        8,
        &["'hashin'", "yamada_sun"],
    );
    says(
        &with("[map]\nx = \"e_over_w\""),
        8,
        &["'e_over_w'", "did you mean 'e_over_d'"],
    );
    says(
        &with("[map]\nx = \"mu\"\ny = \"mu\""),
        9,
        &["two different axes"],
    );
    says(
        &SWEEP.replace("joint.toml", "joints.toml"),
        3,
        &["joints.toml", "relative to the folder"],
    );
}

#[test]
fn what_an_axis_needs_is_named() {
    let text = format!(
        "{SWEEP}[[axes]]\nkey = \"bodies.plate.shape\"\nvalues = [{{ disk = {{ radius = \"3 mm\" }} }}]\n"
    );
    let found = refusal(&text);
    assert!(found.contains("bodies.plate.shape"), "{found}");
}

/// A sweep follows no joint: a scene, or a value of an axis, that asks for it is refused at its line.
#[test]
fn progressive_failure_is_refused() {
    let folder = folder_with(SWEEP);
    let joint = folder.path().join("joint.toml");
    let mut text = std::fs::read_to_string(&joint).unwrap();
    text.push_str("\n[failure.progressive]\nmodel.ply_discount = { fibre = 0.01, matrix = 0.1 }\n");
    std::fs::write(&joint, text).unwrap();
    let error = Sweep::from_file(&folder.path().join("sweep.toml"), &[COARSE], HOST).unwrap_err();
    let found = error.findings()[0].summary();
    assert_eq!(found.line, Some(3));
    assert!(
        found.message.contains("failure.progressive"),
        "{}",
        found.message
    );
    assert!(found.help.unwrap().contains("delete failure.progressive"));
    let axis = "\"failure.progressive.model\"";
    let models = "[{ ply_discount = { fibre = 0.01, matrix = 0.1 } }, { plasticity = { hardening = \"1 GPa\" } }]";
    says(
        &SWEEP.replace("\"mu\"", axis).replace("[0, 0.3]", models),
        9,
        &["failure.progressive", "delete"],
    );
}
