//! All that is wrong is reported at once, and nothing twice.

use super::*;

const JOINT: &str = r#"version = 1
[plies.carbon]
e1 = "140 GPa"
e2 = "9 GPa"
g12 = "5 GPa"
nu12 = 0.3
thickness = "0.125 mm"
strengths = { xt = "1500 MPa", xc = "1200 MPa", yt = "50 MPa", yc = "200 MPa", s12 = "70 MPa" }
[materials.layers.laminate]
layup = "[0/90]s"
ply = "carbon"
[materials.steel.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.plate]
material = "layers"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "80 mm", right = "20 mm" }
[bodies.pin]
material = "steel"
thickness = "1 mm"
shape.disk = { radius = "5 mm" }
[mesh]
spacing = "6 deg"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["1 kN"] }
[failure]
criteria = ["max_stress"]
"#;

const PROGRESSIVE: &str =
    "[failure.progressive]\nmodel.ply_discount = { fibre = 0.1, matrix = 0.1 }\n";

/// An error of its own, which hid others.
const ELSEWHERE: (&str, &str) = ("spacing = \"6 deg\"", "spacing = \"0 deg\"");

/// No error.
const TITLED: (&str, &str) = ("version = 1\n", "version = 1\ntitle = \"joint\"\n");

/// The keys and messages of the findings in [`JOINT`] with `tail`, after the `changes`.
fn findings(tail: &str, changes: &[(&str, &str)]) -> Vec<(String, String)> {
    let text = changes
        .iter()
        .fold(format!("{JOINT}{tail}"), |text, (from, to)| {
            assert!(text.contains(from), "{from}");
            text.replace(from, to)
        });
    let error = read(&text).unwrap_err();
    let findings = error.findings().iter();
    findings
        .map(|finding| (finding.key.clone(), finding.to_string()))
        .collect()
}

/// Two findings: that of [`ELSEWHERE`], and one at `key` whose message holds `part`.
#[track_caller]
fn both(tail: &str, change: (&str, &str), key: &str, part: &str) {
    let found = findings(tail, &[ELSEWHERE, change]);
    assert_eq!(found.len(), 2, "{found:?}");
    assert_eq!(
        (found[0].0.as_str(), found[1].0.as_str()),
        ("mesh.spacing", key)
    );
    assert!(found[1].1.contains(part), "{found:?}");
}

#[test]
fn the_joint_is_right() {
    assert!(read(&format!("{JOINT}{PROGRESSIVE}")).is_ok());
}

#[test]
fn strengths_are_asked_for_beside_other_errors() {
    let hashin = ("[\"max_stress\"]", "[\"hashin\"]");
    both("", hashin, "failure.criteria.0", "s23");
    let unknown = ("[\"max_stress\"]", "[\"max_stres\", \"hashin\"]");
    let found = findings("", &[unknown]);
    let keys: Vec<_> = found.iter().map(|(key, _)| key.as_str()).collect();
    assert_eq!(keys, ["failure.criteria.0", "failure.criteria.1"]);
    let strengths = JOINT.lines().find(|line| line.starts_with("strengths"));
    let none = findings("", &[(strengths.unwrap(), "strengths = {}")]);
    assert_eq!(none.len(), 1, "{none:?}");
}

#[test]
fn failure_without_laminates_is_refused_beside_other_errors() {
    let steel = (
        "material = \"layers\"\n",
        "material = \"steel\"\nthickness = \"1 mm\"\n",
    );
    both("", steel, "failure", "no body");
    let refused = findings("", &[("layup = \"[0/90]s\"", "layup = \"[0/90]\"")]);
    assert_eq!(refused.len(), 1, "{refused:?}");
    let undefined = findings("", &[("material = \"layers\"", "material = \"layer\"")]);
    assert!(
        undefined
            .iter()
            .all(|(key, _)| key.starts_with("bodies.plate")),
        "{undefined:?}"
    );
}

#[test]
fn bodies_without_plies_are_refused_beside_other_errors() {
    both(
        "bodies = [\"plate\", \"pin\"]\n",
        TITLED,
        "failure.bodies.1",
        "'pin' has no plies",
    );
    let refused = findings(
        "bodies = [\"plate\"]\n",
        &[("layup = \"[0/90]s\"", "layup = \"[0/90]\"")],
    );
    assert_eq!(refused.len(), 1, "{refused:?}");
}

#[test]
fn a_missing_pin_is_reported_beside_other_errors() {
    let contact = "[[contacts]]\nfirst = \"plate.hole\"\nsecond = \"pin.rim\"\nfriction.coulomb = { mu = 0.2 }\n[[supports]]\n";
    let held = "[[supports]]\non = \"plate.right\"\nfix = [\"x\", \"y\"]\n[[supports]]\n";
    both(
        PROGRESSIVE,
        (contact, held),
        "failure.progressive",
        "0 contacts touch it",
    );
    let unread = findings(PROGRESSIVE, &[("mu = 0.2", "mu = -0.2")]);
    assert_eq!(unread.len(), 1, "{unread:?}");
}

#[test]
fn a_point_model_is_checked_beside_other_errors() {
    let own = ("matrix = 0.1", "matrix = 0.1, criterion = \"hashin\"");
    both(PROGRESSIVE, own, "failure.progressive.model", "s23");
    let same = findings(PROGRESSIVE, &[("[\"max_stress\"]", "[\"hashin\"]")]);
    assert_eq!(same.len(), 1, "{same:?}");
}

#[test]
fn the_rest_of_progressive_failure_is_checked_without_its_body() {
    let tail = format!("{PROGRESSIVE}body = \"plat\"\ncontrol.loads = {{ increments = 0 }}\n");
    let found = findings(&tail, &[]);
    let keys: Vec<_> = found.iter().map(|(key, _)| key.as_str()).collect();
    assert_eq!(
        keys,
        [
            "failure.progressive.control.loads.increments",
            "failure.progressive.body"
        ]
    );
}

#[test]
fn loads_beside_a_drive_are_refused_beside_other_errors() {
    let drive =
        format!("{PROGRESSIVE}control.displacement = {{ on = \"plate.left\", end = \"-1 mm\" }}\n");
    let other = (
        "[[loads]]\n",
        "[[loads]]\non = \"plate.far\"\npressure.steps = [\"1 MPa\"]\n[[loads]]\non = \"plate.top\"\npressure.steps = [\"1 MPa\"]\n[[loads]]\n",
    );
    let found = findings(&drive, &[other]);
    let keys: Vec<_> = found.iter().map(|(key, _)| key.as_str()).collect();
    assert_eq!(
        keys,
        ["loads.0.on", "failure.progressive.control.displacement.on"]
    );
    assert!(found[1].1.contains("load 'load2'"), "{found:?}");
}

#[test]
fn a_drive_of_a_section_that_another_support_holds_is_refused() {
    let drive =
        format!("{PROGRESSIVE}control.displacement = {{ on = \"pin.section\", end = \"1 mm\" }}\n");
    let held = "[[supports]]\non = \"plate.left\"\nfix = [\"x\", \"y\"]\n";
    let load =
        "[[loads]]\non = \"plate.left\"\nforce = { direction = [-1, 0], steps = [\"1 kN\"] }\n";
    let found = findings(&drive, &[(load, held)]);
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].0, "failure.progressive.control.displacement.on");
    assert!(found[0].1.contains("pin.centre"), "{found:?}");
    // Across the drive it may be held.
    let across = format!("{JOINT}{drive}").replace(load, held).replace(
        "on = \"pin.centre\"\nfix = [\"x\", \"y\"]",
        "on = \"pin.centre\"\nfix = [\"y\"]",
    );
    assert!(read(&across).is_ok());
}
