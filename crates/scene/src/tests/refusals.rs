//! Every way in which a scene can be wrong: the code of the finding, its place, and the names and numbers that it shows.

use super::*;

/// Checks cases of three lines: what replaces what in the scene, with ⏎ for a line end; code and line of the only finding then,
/// and the text that it points at; words of its message, and of its remedy after `help: `.
#[track_caller]
fn check(cases: &str) {
    for case in cases.trim().split("\n\n") {
        let [edit, at, words] = case.lines().collect::<Vec<_>>()[..] else {
            panic!("{case}");
        };
        let (from, to) = edit.split_once("=>").unwrap();
        let [from, to] = [from, to].map(|text| text.trim().replace('⏎', "\n"));
        let finding = refused(&from, &to);
        assert_eq!(place(&finding).trim_end(), at, "{edit}: {finding}");
        says(&finding, &words.split(" … ").collect::<Vec<_>>());
    }
}

/// Code, line, and the text that it points at.
fn place(finding: &Finding) -> String {
    let summary = finding.summary();
    let (code, line) = (summary.code.unwrap(), summary.line.unwrap());
    format!("{code} {line}: {}", shown(finding))
}

/// The only finding in `text` has this code and [`says`] these words.
#[track_caller]
fn finds(text: &str, code: &str, words: &[&str]) {
    let error = read(text).unwrap_err();
    let [finding] = error.findings() else {
        panic!("{error}");
    };
    assert_eq!(finding.summary().code.as_deref(), Some(code), "{error}");
    says(finding, words);
}

/// Each word is in its message, or in its remedy after `help: `.
#[track_caller]
fn says(finding: &Finding, words: &[&str]) {
    let (message, help) = (finding.to_string(), finding.summary().help);
    let help = help.unwrap_or_default();
    for word in words {
        let (text, word) = match word.strip_prefix("help: ") {
            Some(word) => (&help, word),
            None => (&message, *word),
        };
        assert!(text.contains(word), "{word} in {text}");
    }
}

/// The scene up to `part`, and `tail`.
fn ended(part: &str, tail: &str) -> String {
    format!("{}{tail}", &SCENE[..SCENE.find(part).unwrap()])
}

/// The words themselves, of one finding of each common kind.
#[test]
fn findings_in_words() {
    for (from, to, words) in [
        (
            "thickness = \"2 mm\"\n[bodies.plate.s",
            "thicknes = \"2 mm\"\n[bodies.plate.s",
            "unknown key 'thicknes'\n\
             did you mean 'thickness'? known keys here: material, rigid, thickness, shape, position, angle, model, mesh, pattern",
        ),
        (
            "young = \"210 GPa\"\n",
            "",
            "'young' is missing in 'materials.steel.isotropic'\nadd for example `young = \"70 GPa\"`",
        ),
        (
            "half_width = \"20 mm\"",
            "half_width = \"5 mm\"",
            "half_width = 5 mm is outside its range: greater than the hole's radius, 5 mm\n\
             half_width must be greater than the hole's radius, 5 mm",
        ),
        (
            "\"plate.hole\"",
            "\"plate.hol\"",
            "'plate' (plate_with_hole) has no edge 'hol'\n\
             did you mean 'plate.hole'? sets of 'plate' that fit here: plate.hole, plate.left, plate.right, plate.top, plate.bottom",
        ),
        (
            "4.99 mm",
            "5.01 mm",
            "the pin (radius 5.01 mm) is larger than the hole (radius 5 mm): they overlap by 0.01 mm\n\
             make the pin smaller than 5 mm, or say interference = true for a press fit",
        ),
    ] {
        assert_eq!(said(&refused(from, to)), words);
    }
}

#[test]
fn unknown_keys() {
    check(
        r#"
thickness = "2 mm"⏎[bodies.plate.s => thicknes = "2 mm"⏎[bodies.plate.s
scene::unknown_key 8: thicknes
help: mean 'thickness'? … help: rigid

[mesh] => [mesh]⏎quality = 3
scene::unknown_key 17: quality
'quality'

shape.disk => shape.circle
scene::unknown_name 15: circle
'circle' … help: plate_with_hole, disk, outline, mesh, rectangle, block, cylinder

spacing =  => element = "Q7"⏎spacing =
scene::unknown_name 17: "Q7"
'Q7' … help: mean 'Q4'?
"#,
    );
}

#[test]
fn missing_and_wrong_values() {
    check(
        r#"
young = "210 GPa"⏎ =>
scene::missing_key 3: isotropic
'young' … materials.steel.isotropic

poisson = 0.3 => poisson = "0.3"
scene::wrong_kind 5: "0.3"
a number, found the text "0.3" … help: give a number

[mesh]⏎spacing = "2 deg" => mesh = 3
scene::wrong_kind 16: 3
a table … found the number 3
"#,
    );
}

#[test]
fn units() {
    check(
        r#"
"2 mm"⏎[bodies.plate.s => 2⏎[bodies.plate.s
unit::missing 8: 2
2 has no unit … a length … help: for example "2 mm"

"210 GPa" => "210 mm"
unit::dimension 4: "210 mm"
of a length … a stress is expected

"210 GPa" => "210 gpa"
unit::unknown 4: "210 gpa"
'gpa' … a stress is expected … help: GPa

"1 kN",  => "inf kN",
unit::finite 27: "inf kN"
inf kN

poisson = 0.3 => poisson = nan
scene::not_finite 5: nan
nan

title = "Pin" => units.length = "inch"
unit::unknown 2: "inch"
'inch' … a length is expected … help: in, ft

spacing = "2 deg" => spacing = "2 deg"⏎fine_to = "1 mm"
unit::dimension 18: "1 mm"
of a length … an angle is expected
"#,
    );
}

#[test]
fn sizes_and_materials() {
    check(
        r#"
thickness = "2 mm"⏎[bodies.plate.s => thickness = "-2 mm"⏎[bodies.plate.s
scene::out_of_range 8: "-2 mm"
thickness = -2 mm … help: must be greater than 0

poisson = 0.3 => poisson = 0.6
scene::material 5: 0.6
'steel' … ratio 0.6 … at most 0.5 … help: 0.25 to 0.35

half_width = "20 mm" => half_width = "5 mm"
scene::out_of_range 11: "5 mm"
half_width = 5 mm … the hole's radius, 5 mm

material = "steel"⏎thickness = "2 mm"⏎[ => material = "stel"⏎thickness = "2 mm"⏎[
scene::undefined 7: "stel"
material 'stel' … help: mean 'steel'? … help: in this scene: steel

material = "steel"⏎thickness = "2 mm"⏎shape.d => material = "steel"⏎rigid = true⏎shape.d
scene::one_of 12: pin
material = "…", rigid = true … found both

version = 1⏎ => version = 1⏎analysis.plane = "strain"⏎materials.ply.orthotropic = { e1 = "9 GPa", e2 = "9 GPa", g12 = "3 GPa", nu12 = 0.3, nu13 = 0.3, nu23 = 0.3 }⏎
scene::missing_key 3: orthotropic
'e3' … 'materials.ply.orthotropic'
"#,
    );
}

#[test]
fn contacts() {
    check(
        r#"
friction.coulomb = { mu = 0.2 }⏎ =>
scene::missing_friction 18: [[contacts]]
contact 'pin' … help: frictionless … help: coulomb = { mu = 0 }

4.99 mm => 5.01 mm
scene::pin_too_large 15: "5.01 mm"
by 0.01 mm … help: interference = true

"plate.hole" => "plate.hol"
scene::missing_set 19: "plate.hol"
edge 'hol' … help: mean 'plate.hole'? … help: plate.left

first = "plate.hole"⏎second = "pin.rim" => first = "pin.rim"⏎second = "plate.hole"
scene::contact_pair 18: [[contacts]]
'pin.rim' and 'plate.hole' … help: swap … help: first = "plate.hole", second = "pin.rim"

mu = 0.2 => mu = -0.2
scene::friction 21: -0.2
'coulomb' … mu = -0.2 … [0, ∞)
"#,
    );
    let pressed = SCENE
        .replace("4.99 mm", "5.01 mm")
        .replace("friction.", "interference = true\nfriction.");
    assert!(read(&pressed).is_ok());
}

#[test]
fn supports_and_loads() {
    check(
        r#"
[[supports]]⏎on = "pin.centre"⏎fix = ["x", "y"]⏎ =>
scene::unsupported_body 12: pin
'pin' and 'plate' … help: [[supports]]

on = "plate.left" => on = "plate.far"
scene::missing_set 26: "plate.far"
'plate' (plate_with_hole) … edge, point or area 'far' … help: plate.left, plate.right

on = "plate.left" => on = "plat.left"
scene::undefined 26: "plat.left"
body 'plat' … help: mean 'plate'? … help: pin, plate

direction = [-2, 0] => direction = [0, 0]
scene::out_of_range 27: [0, 0]
direction = [0, 0]

force = { => temperature = { steps = [] }⏎force = {
scene::one_of 25: [[loads]]
force, bearing, pressure, polar_traction, temperature
"#,
    );
    let more = "[[loads]]\nname = \"more\"\non = \"plate.top\"\npressure.steps = [\"1 MPa\"]\n";
    let error = read(&format!("{SCENE}{more}")).unwrap_err();
    assert_eq!(error.findings()[0].position(), Some((31, 18)));
    assert!(matches!(
        &error.findings()[0].problem,
        SceneProblem::UnequalSteps { load, steps: 1, other, other_steps: 2 } if load == "more" && other == "load1"
    ));
    let heat = "on = \"plate\"\ntemperature = { steps = [\"10 K\", \"20 K\"] }\n";
    let heated = ended("on = \"plate.left\"", heat);
    finds(&heated, "scene::conflict", &["'steel'", "expansion"]);
    finds(
        &ended("[[loads]]", ""),
        "scene::conflict",
        &["nothing happens"],
    );
}

#[test]
fn loads_that_are_held() {
    let held = "on = \"plate.left\"\nfix = [\"x\"]";
    let support = format!("[[supports]]\n{held}\n[[loads]]");
    let platen = "[[platens]]\non = \"plate.left\"\nfree = [\"y\"]\n[[loads]]";
    for keys in [&support, platen] {
        let finding = refused("[[loads]]", keys);
        assert_eq!(place(&finding), "scene::conflict 29: \"plate.left\"");
        says(
            &finding,
            &["held against load 'load1'", "help: another edge"],
        );
    }
    let across = support.replace("[\"x\"]", "[\"y\"]");
    read(&SCENE.replace("[[loads]]", &across)).unwrap();
    let pressure = ended("force = {", "pressure.steps = [\"1 MPa\"]\n");
    read(&pressure.replace("[[loads]]", &support)).unwrap();
}

#[test]
fn loads_on_a_held_rigid_body() {
    let rigid = SCENE.replace(
        "[bodies.pin]\nmaterial = \"steel\"\nthickness = \"2 mm\"\n",
        "[bodies.pin]\nrigid = true\n",
    );
    let more = "[[loads]]\non = \"pin.rim\"\nforce = { direction = [1, 1], steps = [\"1 kN\", \"2 kN\"] }\n";
    finds(
        &format!("{rigid}{more}"),
        "scene::conflict",
        &["'pin.rim'", "held against load 'load2'"],
    );
    read(&format!("{SCENE}{more}")).unwrap();
}

#[test]
fn bearing_loads() {
    check(
        r#"
force = { direction = [-2, 0], => bearing = { direction = [1, 0], law = "cosine",
scene::conflict 26: "plate.left"
'plate.left' is no hole … help: plate.hole

plate.left"⏎force = { direction = [-2, 0], => plate.hole"⏎bearing = { direction = [1, 0], law = "cosinus",
scene::unknown_name 27: "cosinus"
'cosinus' … help: cosine, uniform

plate.left"⏎force = { direction = [-2, 0], => plate.hole"⏎bearing = { direction = [1, 0],
scene::missing_key 27: bearing
'law'

plate.left"⏎force = { direction = [-2, 0], => plate.hole"⏎bearing = { direction = [0, 0], law = "cosine",
scene::out_of_range 27: [0, 0]
direction = [0, 0]

plate.left"⏎force = { direction = [-2, 0], steps = ["1 kN", "2 kN"] => plate.hole"⏎bearing = { direction = [1, 0], law = "cosine", steps = ["1 kN", "-2 kN"]
scene::out_of_range 27: "-2 kN"
-2 kN … turn the direction
"#,
    );
}

#[test]
fn data_files() {
    let ring = SCENE.replace(
        "outline.strip = { half_width = \"20 mm\", left = \"90 mm\", right = \"20 mm\" }",
        "outline.ring = { radius = \"50 mm\" }",
    );
    let start = ring.find("on = \"plate.left\"").unwrap();
    let load = "on = \"plate.outer\"\npolar_traction = { file = \"none.csv\", stress = \"MPa\", steps = [1] }\n";
    let error = read(&format!("{}{load}", &ring[..start])).unwrap_err();
    let finding = &error.findings()[0];
    assert_eq!(finding.position(), Some((27, 27)));
    assert!(
        matches!(&finding.problem, SceneProblem::DataFile { path, cause, .. } if path == "none.csv" && cause.starts_with("cannot be read")),
        "{error}"
    );
}

#[test]
fn meshes() {
    check(
        r#"
spacing = "2 deg" => spacing = "2 mm"
scene::conflict 17: "2 mm"
'pin' (disk) … mesh.spacing = 2 mm is a length … help: spacing = "2 deg"

spacing = "2 deg" => spacing = "0 deg"
scene::out_of_range 17: "0 deg"
spacing = 0 deg … greater than 0

spacing = "2 deg" => angles = ["0 deg", "9 deg", "5 deg", "180 deg"]
scene::out_of_range 17: "5 deg"
angles[2] = 5 deg … greater than … 9 deg

spacing = "2 deg" => layers = 3
scene::one_of 16: mesh
mesh: exactly one of spacing
"#,
    );
}

#[test]
fn mesh_keys_that_no_shape_uses() {
    check(
        r#"
shape.disk = { radius = "4.99 mm" } => shape.disk = { radius = "4.99 mm" }⏎mesh = { layers = 4 }
scene::conflict 16: 4
pin.mesh.layers has no effect … a disk … help: remove layers
"#,
    );
    let press = |shapes: [&str; 2], setting: &str| {
        let [first, second] = shapes;
        let text = format!(
            "version = 1\nmaterials.steel.isotropic = {{ young = \"210 GPa\", poisson = 0.3 }}\n\
             [bodies.first]\nmaterial = \"steel\"\nthickness = \"2 mm\"\nshape.{first}\n\
             [bodies.second]\nmaterial = \"steel\"\nthickness = \"2 mm\"\nshape.{second}\n\
             [mesh]\nspacing = \"1 mm\"\n{setting}\n\
             [[platens]]\non = \"first.top\"\nfree = [\"y\"]\n[[platens]]\non = \"second.bottom\"\nfree = []\n\
             [[loads]]\non = \"first.top\"\npressure.steps = [\"1 MPa\"]\n"
        );
        read(&text).err().map(|error| error.findings()[0].clone())
    };
    let coupon = r#"rectangle = { width = "60 mm", height = "20 mm" }"#;
    let cap = r#"cylinder = { radius = "100 mm", half_length = "20 mm", depth = "18 mm" }"#;
    let block = r#"block = { half_length = "20 mm", depth = "18 mm" }"#;
    let fine = "fine_to = \"5 mm\"";
    assert!(press([coupon, coupon], "element = \"Q4\"").is_none());
    assert!(press([coupon, block], fine).is_none());
    let coarse = format!("{fine}\ncoarse_spacing = \"2 mm\"");
    for (shapes, setting, words) in [
        (
            [coupon, coupon],
            fine,
            ["mesh.fine_to has no effect", "of a rectangle"],
        ),
        (
            [cap, block],
            &coarse,
            ["mesh.coarse_spacing has no effect", "a block or a cylinder"],
        ),
    ] {
        says(&press(shapes, setting).unwrap(), &words);
    }
}

#[test]
fn versions() {
    check(
        r"
version = 1 => version = 2
scene::unsupported_version 1: 2
version 2 … help: version = 1

version = 1⏎ =>
scene::missing_version 1:
help: version = 1
",
    );
}

#[test]
fn everything_wrong_is_shown_at_once() {
    let text = SCENE
        .replace("poisson = 0.3", "poisson = 0.7")
        .replace("4.99 mm", "6 mm")
        .replace("pin.centre", "pin.center");
    let error = read(&text).unwrap_err();
    assert_eq!(error.findings().len(), 3, "{error}");
    let shown = error.render(100, false);
    for part in [
        "a.toml:5:11",
        "a.toml:15:",
        "a.toml:23:",
        "did you mean 'pin.centre'?",
    ] {
        assert!(shown.contains(part), "{part} in {shown}");
    }
}

#[test]
fn errors_that_show_later_have_a_place_too() {
    let scene = read(SCENE).unwrap();
    let problem = SceneProblem::Model {
        message: "too fine".into(),
        remedy: "coarsen".into(),
    };
    let error = scene.error_at("mesh.spacing", problem);
    assert_eq!(error.to_string(), "a.toml:17:11: too fine");
    assert!(error.render(80, false).contains("help: coarsen"));
}

#[test]
fn overrides_are_named_in_their_errors() {
    let with = |argument: &str| {
        Scene::from_text(SCENE, Format::Toml, "a.toml", Path::new(""), &[argument])
    };
    assert_eq!(
        with("mesh.spacing=4 deg").unwrap().hash,
        read(&SCENE.replace("2 deg", "4 deg")).unwrap().hash
    );
    for (argument, code, column, words) in [
        (
            "mesh.spacing=4",
            "unit::missing",
            14,
            &["4 has no unit", "an angle or a length"][..],
        ),
        ("mesh.spaces=4 deg", "scene::unknown_key", 1, &["'spaces'"]),
        (
            "contacts.0.friction.static_dynamic.static=0.3",
            "scene::missing_key",
            1,
            &["'dynamic'", "'contacts.0.friction.static_dynamic'"],
        ),
    ] {
        let error = with(argument).unwrap_err();
        let finding = &error.findings()[0];
        assert_eq!(finding.source.name, "--set", "{error}");
        assert_eq!(finding.summary().code.as_deref(), Some(code), "{error}");
        assert_eq!(finding.position(), Some((1, column)), "{error}");
        says(finding, words);
    }
}

#[test]
fn accuracies_and_models_that_no_run_can_have() {
    let refuse = |key: &str, keys: &str, value: &str| {
        let finding = refused("[mesh]", &format!("[analysis]\naccuracy = {keys}\n[mesh]"));
        assert_eq!(place(&finding), format!("scene::out_of_range 17: {value}"));
        says(&finding, &[key, "at least 1e-8 and at most 50 %"]);
    };
    for value in ["\"0 %\"", "\"-1 %\"", "0.6", "1e-9"] {
        refuse("accuracy = ", value, value);
    }
    for value in ["\"0 %\"", "-0.01", "\"51 %\"", "1e-9"] {
        let keys = format!("{{ peak_hoop = \"1 %\", peak_pressure = {value} }}");
        refuse("peak_pressure = ", &keys, value);
    }
    check(
        r#"
[mesh] => [analysis]⏎accuracy = { peak_presure = "1 %" }⏎[mesh]
scene::unknown_key 17: peak_presure
'peak_presure' … help: peak_pressure

[mesh] => [analysis]⏎accuracy = { peak_hoop = "fine" }⏎[mesh]
scene::refused 17: "fine"
'fine' … a relative error

[mesh] => [analysis]⏎accuracy = {}⏎[mesh]
scene::conflict 17: accuracy
names no number … help: peak_pressure

[mesh] => [analysis]⏎accuracy = "fine"⏎[mesh]
scene::refused 17: "fine"
'fine' … a relative error

[mesh] => [analysis]⏎budget = "10 s"⏎[mesh]
scene::conflict 17: "10 s"
none is asked for … help: analysis.accuracy

[mesh] => [analysis]⏎accuracy = "1 %"⏎budget = "0 s"⏎[mesh]
scene::out_of_range 18: "0 s"
budget =  … a time above 0 s

[mesh] => [analysis]⏎accuracy = "1 %"⏎budget = 10⏎[mesh]
scene::refused 18: 10
'10' is not a time

[mesh] => [analysis]⏎memory = "0 GB"⏎[mesh]
scene::out_of_range 17: "0 GB"
memory =  … memory above 0 GB

[mesh] => [analysis]⏎memory = 4⏎[mesh]
scene::refused 17: 4
'4' is not … an amount of memory

[mesh] => [analysis]⏎memory = "8 GB"⏎[mesh]
scene::conflict 18: mesh
mesh prescribes this one … help: one of the two

[mesh] => [analysis]⏎contact_nodes = 3⏎[mesh]
scene::out_of_range 17: 3
contact_nodes = 3 … from 9 to 2049
"#,
    );
}

#[test]
fn a_mesh_that_nothing_uses() {
    let series = |scene: &str| {
        let scene = scene.replace(
            "thickness = \"2 mm\"",
            "thickness = \"2 mm\"\nmodel = \"series\"",
        );
        read(&scene)
    };
    let error = series(SCENE).unwrap_err().to_string();
    assert!(error.contains("no body of the scene is divided"), "{error}");
    let scene = series(&SCENE.replace("[mesh]\nspacing = \"2 deg\"\n", "")).unwrap();
    assert!(!scene.is_divided && scene.seeks_accuracy());
    let disk = "shape.disk = { radius = \"4.99 mm\" }";
    let meshed = format!("model = \"series\"\n{disk}\nmesh.spacing = \"3 deg\"");
    says(
        &refused(disk, &meshed),
        &["bodies.pin.mesh", "help: one of the two"],
    );
    let rigid = "[bodies.pin]\nrigid = true\nmodel = \"elements\"";
    let elastic = "[bodies.pin]\nmaterial = \"steel\"\nthickness = \"2 mm\"";
    says(&refused(elastic, rigid), &["this one is rigid"]);
}
