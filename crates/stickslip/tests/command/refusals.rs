//! Scenes that are refused: file, line, value and remedy.

use std::fs;

use serde_json::Value;

use super::{SCENE, fails, folder_with, succeeds};

/// Checks the scene with `from` replaced by `to`; the message must hold every part.
#[track_caller]
pub(super) fn refused(from: &str, to: &str, parts: &[&str]) {
    assert!(SCENE.contains(from), "{from}");
    let folder = folder_with("bad.toml", &SCENE.replacen(from, to, 1));
    let message = fails(folder.path(), &["check", "bad.toml"]);
    for part in parts {
        assert!(message.contains(part), "'{part}' is missing in:\n{message}");
    }
}

#[test]
fn keys() {
    refused(
        "poisson =",
        "poison =",
        &[
            "bad.toml:5:1",
            "unknown key 'poison'",
            "did you mean 'poisson'?",
        ],
    );
    refused(
        "version = 1\n",
        "",
        &["bad.toml:1:1", "version", "add the line `version = 1`"],
    );
    refused(
        "version = 1",
        "version = 3",
        &[
            "bad.toml:1:11",
            "version 3",
            "this program reads `version = 1`",
        ],
    );
    refused(
        "young = \"210 GPa\"\n",
        "",
        &[
            "bad.toml:3:18",
            "'young' is missing",
            "add for example `young = \"70 GPa\"`",
        ],
    );
    refused(
        "title = \"Pin\"",
        "title = Pin",
        &["bad.toml:2:9", "this is not valid TOML", "double quotes"],
    );
    refused(
        "title = \"Pin\"",
        "title = \"a\"\ntitle = \"b\"",
        &[
            "bad.toml:3:1",
            "the key 'title' is given twice",
            "on lines 2 and 3",
        ],
    );
}

#[test]
fn quantities() {
    refused(
        "\"2 mm\"",
        "2",
        &[
            "bad.toml:8:13",
            "2 has no unit; a length is expected",
            "for example \"2 mm\"",
        ],
    );
    refused(
        "\"2 mm\"",
        "\"2 MPa\"",
        &[
            "bad.toml:8:13",
            "\"2 MPa\"",
            "a stress; a length is expected",
            "units that fit here: mm",
        ],
    );
    refused(
        "\"2 mm\"",
        "\"2 inch\"",
        &[
            "bad.toml:8:13",
            "'inch' in \"2 inch\" is not a known unit",
            "mm, cm, m, um, nm, in",
        ],
    );
    refused(
        "\"2 mm\"",
        "\"-2 mm\"",
        &[
            "bad.toml:8:13",
            "thickness = -2 mm is outside its range",
            "greater than 0",
        ],
    );
    refused(
        "\"2 mm\"",
        "\"nan mm\"",
        &["bad.toml:8:13", "\"nan mm\" is not a finite number"],
    );
    refused(
        "mu = 0.2",
        "mu = inf",
        &["bad.toml:22:27", "inf is not a finite number"],
    );
    refused(
        "\"1 kN\",",
        "\"1e999 kN\",",
        &["bad.toml:28:41", "\"1e999 kN\" is not a finite number"],
    );
}

#[test]
fn materials_and_bodies() {
    refused(
        "poisson = 0.3",
        "poisson = 0.51",
        &[
            "bad.toml:5:11",
            "Poisson's ratio 0.51",
            "at most 0.5 in plane stress",
            "0.25 to 0.35",
        ],
    );
    refused(
        "material = \"steel\"",
        "material = \"stele\"",
        &[
            "bad.toml:7:12",
            "there is no material 'stele'",
            "did you mean 'steel'?",
        ],
    );
    refused(
        "\"4.99 mm\"",
        "\"5.25 mm\"",
        &[
            "bad.toml:15:25",
            "radius 5.25 mm",
            "radius 5 mm",
            "overlap by 0.25 mm",
            "interference = true",
        ],
    );
    refused(
        "half_width = \"20 mm\"",
        "half_width = \"4 mm\"",
        &["bad.toml:11:", "greater than the hole's radius, 5 mm"],
    );
}

#[test]
fn contacts_supports_and_loads() {
    refused(
        "friction.coulomb = { mu = 0.2 }",
        "",
        &[
            "bad.toml:18:",
            "contact 'pin' has no friction law",
            "friction.coulomb = { mu = 0 }",
        ],
    );
    refused(
        "on = \"pin.centre\"",
        "on = \"pin.top\"",
        &[
            "bad.toml:24:6",
            "'pin' (disk) has no edge, point or area 'top'",
            "pin.rim, pin.centre",
        ],
    );
    refused(
        "[[supports]]\non = \"pin.centre\"\nfix = [\"x\", \"y\"]\n",
        "",
        &[
            "bad.toml:12:",
            "nothing holds 'pin' and 'plate'",
            "[[supports]] on = \"pin.",
        ],
    );
    refused(
        "on = \"plate.left\"",
        "on = \"plate.end\"",
        &[
            "bad.toml:27:6",
            "no edge, point or area 'end'",
            "plate.hole, plate.left",
        ],
    );
    refused(
        "on = \"plate.left\"",
        "on = \"block.left\"",
        &["bad.toml:27:6", "there is no body 'block'", "pin, plate"],
    );
    let more = "[[loads]]\non = \"plate.top\"\npressure.steps = [\"1 MPa\"]\n[[loads]]";
    refused(
        "[[loads]]",
        more,
        &[
            "bad.toml:31:",
            "load 'load2' has 2 steps, but load 'load1' has 1",
            "same number of steps",
        ],
    );
}

#[test]
fn meshes_that_do_not_fit_into_memory() {
    refused(
        "\"6 deg\"",
        "\"1e-5 deg\"",
        &["bad.toml:17:11", "nodes", "GB", "make mesh.spacing larger"],
    );
}

#[test]
fn asymmetric_halves_are_refused_at_their_key() {
    let half = "[analysis]\nmodel = \"half\"\n[[loads]]\non = \"plate.top\"\npressure.steps = [\"1 MPa\", \"1 MPa\"]\n[[loads]]";
    refused(
        "[[loads]]",
        half,
        &[
            "bad.toml:27:9",
            "model = \"half\" asks for symmetry",
            "auto",
        ],
    );
    let one_ply = "friction.fibre_coverage = { plies = [{ angle = \"45 deg\", fraction = 1 }], fibre_fraction = 0.6, \
                   kernel.swept.kappa = 0.5, fibre.coulomb.mu = 0.1, matrix.coulomb.mu = 0.4 }\n[analysis]\nmodel = \"half\"";
    refused(
        "friction.coulomb = { mu = 0.2 }",
        one_ply,
        &[
            "bad.toml:24:9",
            "'fibre_coverage' of contact 'pin'",
            "no symmetry about the x axis",
            "say model = \"auto\" or leave it out",
        ],
    );
}

#[test]
fn json_scenes_point_at_their_lines() {
    let table: Value = toml::from_str(SCENE).unwrap();
    let pretty = serde_json::to_string_pretty(&table).unwrap();
    let folder = folder_with("pin.json", &pretty);
    succeeds(folder.path(), &["check", "pin.json"]);
    let bad = pretty.replacen("\"6 deg\"", "6", 1);
    let line = bad
        .lines()
        .position(|line| line.contains("\"spacing\""))
        .unwrap()
        + 1;
    fs::write(folder.path().join("bad.json"), &bad).unwrap();
    let message = fails(folder.path(), &["check", "bad.json"]);
    assert!(
        message.contains(&format!("bad.json:{line}:")) && message.contains("6 has no unit"),
        "{message}"
    );
}

#[test]
fn errors_in_json_carry_the_same_parts() {
    let folder = folder_with("bad.toml", &SCENE.replacen("poisson =", "poison =", 1));
    let errors: Value =
        serde_json::from_str(&fails(folder.path(), &["--json", "check", "bad.toml"])).unwrap();
    let error = &errors["errors"][0];
    assert_eq!(error["code"], "scene::unknown_key");
    assert_eq!(error["message"], "unknown key 'poison'");
    assert_eq!(
        (&error["source"], &error["line"], &error["column"]),
        (&"bad.toml".into(), &5.into(), &1.into())
    );
    assert_eq!(error["key"], "materials.steel.isotropic.poison");
    assert!(
        error["help"]
            .as_str()
            .unwrap()
            .contains("did you mean 'poisson'?")
    );
}

#[test]
fn keys_given_twice_name_both_lines() {
    refused(
        "[mesh]",
        "[mesh]\nelement = \"Q4\"\n[mesh]",
        &[
            "bad.toml:18:",
            "the key 'mesh' is given twice",
            "on lines 16 and 18",
        ],
    );
    refused(
        "{ mu = 0.2 }",
        "{ mu = 0.2, mu = 0.3 }",
        &[
            "contacts.0.friction.coulomb.mu",
            "the key 'mu' is given twice",
            "both on line 22",
        ],
    );
}

#[test]
fn radii_that_cannot_touch() {
    refused(
        "\"4.99 mm\"",
        "\"2.4 mm\"",
        &[
            "bad.toml:15:25",
            "radius 2.4 mm) is too small",
            "hole (radius 5 mm)",
            "at least 2.5 mm",
        ],
    );
    refused(
        "shape.disk = { radius = \"4.99 mm\" }\n[mesh]\nspacing = \"6 deg\"\n[[contacts]]",
        "shape.disk = { radius = \"6 mm\" }\n[mesh]\nspacing = \"6 deg\"\n[[contacts]]\ninterference = true",
        &[
            "bad.toml:15:25",
            "hole (radius 5 mm) by 1 mm, 20.000 %",
            "at most 5.5 mm",
        ],
    );
}

#[test]
fn chains_that_cannot_be() {
    let more = "[[contacts]]\nname = \"more\"\nfirst = \"plate.hole\"\nsecond = \"pin.rim\"\nfriction.coulomb = { mu = 0 }\n[[supports]]";
    refused(
        "[[supports]]",
        more,
        &[
            "bad.toml:25:9",
            "plate.hole is in contact 'pin' already",
            "pin.rim is in contact 'pin' already",
        ],
    );
    let ring = |name: &str| {
        format!(
            "[bodies.{name}]\nmaterial = \"steel\"\nthickness = \"2 mm\"\nshape.plate_with_hole = {{ hole_radius = \"4 mm\", outline.ring.radius = \"4.2 mm\" }}\n"
        )
    };
    let pair = |first: &str, second: &str| {
        format!(
            "[[contacts]]\nfirst = \"{first}.hole\"\nsecond = \"{second}.outer\"\ninterference = true\nfriction.coulomb = {{ mu = 0 }}\n"
        )
    };
    let circle = format!(
        "{}{}{}{}[[supports]]",
        ring("one"),
        ring("two"),
        pair("one", "two"),
        pair("two", "one")
    );
    refused(
        "[[supports]]",
        &circle,
        &["contacts form a circle", "'one', 'two'", "contacts.2"],
    );
    let own = format!("{}{}[[supports]]", ring("one"), pair("one", "one"));
    refused(
        "[[supports]]",
        &own,
        &["contact 'one' is one of a body with itself"],
    );
    let hole = "second = \"plate.left\"\n";
    refused(
        "second = \"pin.rim\"\n",
        hole,
        &["is one of a body with itself"],
    );
}

#[test]
fn numbers_outside_their_range() {
    refused(
        "title = \"Pin\"",
        "analysis.substeps = 100001",
        &["bad.toml:2:", "substeps = 100001", "from 1 to 100000"],
    );
    refused(
        "direction = [-1, 0]",
        "direction = [-1, 0, 0]",
        &["bad.toml:28:", "two numbers, x and y, such as [-1, 0]"],
    );
}

#[test]
fn bodies_that_are_divided_by_themselves() {
    const PIN: &str =
        "shape.disk = { radius = \"4.99 mm\" }\n[mesh]\nspacing = \"6 deg\"\n[[contacts]]";
    let divided = |mesh: &str, contact: &str| {
        format!(
            "shape.disk = {{ radius = \"4.99 mm\" }}\nmesh = {{ {mesh} }}\n[mesh]\nspacing = \"6 deg\"\n[[contacts]]\n{contact}"
        )
    };
    refused(
        PIN,
        &divided("spacing = \"4 deg\"", "projection = \"nodes\""),
        &[
            "bad.toml:20:14",
            "contact 'pin': pairs of nodes",
            "61 nodes of plate.hole face 91 of pin.rim",
            "projection = \"auto\" or \"dual-mortar\"",
        ],
    );
    refused(
        PIN,
        &divided("element = \"Q4\"", "projection = \"nodes\""),
        &[
            "bad.toml:20:14",
            "plate.hole are quadratic",
            "pin.rim linear",
        ],
    );
    refused(
        PIN,
        &divided("spacing = \"0.4 mm\"", ""),
        &[
            "bad.toml:16:20",
            "'pin' (disk) is divided by angles",
            "bodies.pin.mesh.spacing = 0.4 mm is a length",
            "spacing = \"2 deg\"",
        ],
    );
    refused(
        PIN,
        &divided("angles = [\"0 deg\", \"100 deg\"]", ""),
        &[
            "bad.toml:16:19",
            "from 0 to 180 deg",
            "the last one is 100.000000 deg",
        ],
    );
    refused(
        PIN,
        &divided("spacing = \"1e-5 deg\"", ""),
        &["bad.toml:16:20", "GB"],
    );
    refused(
        PIN,
        &divided("coarse_spacing = \"20 deg\"", ""),
        &[
            "bad.toml:16:27",
            "bodies.pin.mesh.coarse_spacing needs bodies.pin.mesh.fine_to",
        ],
    );
    refused(
        PIN,
        &divided("layers = 0", ""),
        &["bad.toml:16:19", "layers = 0", "at least 1"],
    );
    refused(
        PIN,
        &divided("spacing = \"4 deg\"", "projection = \"dual\""),
        &["bad.toml:20:14", "\"dual\"", "dual-mortar"],
    );
    refused(
        "material = \"steel\"\nthickness = \"2 mm\"\nshape.disk = { radius = \"4.99 mm\" }",
        "rigid = true\nmesh.spacing = \"3 deg\"\nshape.disk = { radius = \"4.99 mm\" }",
        &[
            "bad.toml:14:1",
            "the rigid body 'pin' is not divided",
            "remove its mesh",
        ],
    );
}

/// Of two joints the second is pulled beside its pin, which turns its plate: its own load is named and shown, and no other.
#[test]
fn a_load_that_nothing_balances() {
    let second = r#"
[bodies.lug]
material = "steel"
thickness = "2 mm"
[bodies.lug.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "30 mm", right = "20 mm" }
[bodies.bolt]
material = "steel"
thickness = "2 mm"
shape.disk = { radius = "4.99 mm" }
[[contacts]]
name = "bolt"
first = "lug.hole"
second = "bolt.rim"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "bolt.centre"
fix = ["x", "y"]
[[loads]]
name = "askew"
on = "lug.left"
force = { direction = [-1, 1], steps = ["10 N", "20 N"] }
"#;
    let text = SCENE.replace("6 deg", "15 deg") + second;
    let folder = folder_with("joints.toml", &text);
    let message = fails(folder.path(), &["run", "joints.toml"]);
    let line = 1 + text[..text.find("[[loads]]\nname").unwrap()]
        .lines()
        .count();
    for part in [
        "not solved beyond askew 0 N",
        "'bolt' and 'lug'",
        "the load cannot be balanced: ",
        "'lug' turns",
        "loads.1",
        "line of action",
        &format!("joints.toml:{line}:1"),
    ] {
        assert!(message.contains(part), "'{part}' is missing in:\n{message}");
    }
    assert!(!message.contains("load1") && !message.contains("loads.0"));
    // As little may be left of a direction that was rounded.
    for (across, is_rounded) in [("1e-8", true), ("1e-5", false)] {
        let direction = format!("loads.1.force.direction=[-1, {across}]");
        let message = fails(folder.path(), &["run", "joints.toml", "--set", &direction]);
        for part in ["miss their balance by ", "e-8 of their size", "more digits"] {
            assert_eq!(message.contains(part), is_rounded, "'{part}':\n{message}");
        }
    }
}

/// Without contact the body, its motion and the support that is missing are named, and no contact force.
#[test]
fn a_load_along_a_motion_that_nothing_holds() {
    let text = r#"version = 1
materials.metal.isotropic = { young = "70 GPa", poisson = 0.33 }
[bodies.plate]
material = "metal"
thickness = "2 mm"
shape.rectangle = { width = "40 mm", height = "20 mm" }
[mesh]
spacing = "5 mm"
[[supports]]
on = "plate.left"
fix = ["x"]
[[loads]]
on = "plate.right"
force = { direction = [1, -1], steps = ["1 kN"] }
"#;
    let folder = folder_with("plate.toml", text);
    let message = fails(folder.path(), &["run", "plate.toml"]);
    for part in [
        "the load cannot be balanced: 'plate' slides along −y (proved)",
        "fix = [\"y\"]",
        "loads.0",
    ] {
        assert!(message.contains(part), "'{part}' is missing in:\n{message}");
    }
    assert!(!message.contains("contact"), "{message}");
}
