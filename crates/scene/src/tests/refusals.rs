//! Every way in which a scene can be wrong, with the exact words that are shown.

use super::*;

#[test]
fn unknown_keys() {
    let (message, help, line, shown) = refused(
        "thickness = \"2 mm\"\n[bodies.plate.s",
        "thicknes = \"2 mm\"\n[bodies.plate.s",
    );
    assert_eq!(message, "unknown key 'thicknes'");
    assert_eq!(
        help,
        "did you mean 'thickness'? known keys here: material, rigid, thickness, shape, position, angle, model, mesh, pattern"
    );
    assert_eq!((line, shown.as_str()), (8, "thicknes"));
    let (message, _, line, _) = refused("[mesh]", "[mesh]\nquality = 3");
    assert_eq!((message.as_str(), line), ("unknown key 'quality'", 17));
    let (message, help, _, shown) = refused("shape.disk", "shape.circle");
    assert_eq!(message, "'circle' is not one of the choices");
    assert!(
        help.ends_with("choices: plate_with_hole, disk, outline, mesh, rectangle, block, cylinder"),
        "{help}"
    );
    assert_eq!(shown, "circle");
    let (message, help, _, shown) = refused("spacing = ", "element = \"Q7\"\nspacing = ");
    assert_eq!(
        (message.as_str(), shown.as_str()),
        ("'Q7' is not one of the choices", "\"Q7\"")
    );
    assert!(help.starts_with("did you mean 'Q4'?"), "{help}");
}

#[test]
fn missing_and_wrong_values() {
    let (message, help, line, shown) = refused("young = \"210 GPa\"\n", "");
    assert_eq!(message, "'young' is missing in 'materials.steel.isotropic'");
    assert_eq!(
        (help.as_str(), line, shown.as_str()),
        ("add for example `young = \"70 GPa\"`", 3, "isotropic")
    );
    let (message, help, line, _) = refused("poisson = 0.3", "poisson = \"0.3\"");
    assert_eq!(message, "expected a number, found the text \"0.3\"");
    assert_eq!((help.as_str(), line), ("give a number", 5));
    let (message, _, line, shown) = refused("[mesh]\nspacing = \"2 deg\"", "mesh = 3");
    assert_eq!(
        message,
        "expected a table, such as { key = value }, found the number 3"
    );
    assert_eq!((line, shown.as_str()), (16, "3"));
}

#[test]
fn units() {
    let (message, help, line, shown) = refused("\"2 mm\"\n[bodies.plate.s", "2\n[bodies.plate.s");
    assert_eq!(message, "2 has no unit; a length is expected");
    assert!(
        help.starts_with("write the number with its unit in quotes, for example \"2 mm\""),
        "{help}"
    );
    assert_eq!((line, shown.as_str()), (8, "2"));
    let (message, _, _, shown) = refused("\"210 GPa\"", "\"210 mm\"");
    assert_eq!(
        message,
        "\"210 mm\" has the unit of a length; a stress is expected"
    );
    assert_eq!(shown, "\"210 mm\"");
    let (message, help, ..) = refused("\"210 GPa\"", "\"210 gpa\"");
    assert_eq!(
        message,
        "'gpa' in \"210 gpa\" is not a known unit; a stress is expected"
    );
    assert!(help.contains("GPa"), "{help}");
    let (message, ..) = refused("\"1 kN\", ", "\"inf kN\", ");
    assert_eq!(message, "\"inf kN\" is not a finite number");
    let (message, _, _, shown) = refused("poisson = 0.3", "poisson = nan");
    assert_eq!(
        (message.as_str(), shown.as_str()),
        ("nan is not a finite number", "nan")
    );
    let (message, help, ..) = refused("title = \"Pin\"", "units.length = \"inch\"");
    assert_eq!(
        message,
        "'inch' in \"inch\" is not a known unit; a length is expected"
    );
    assert!(help.contains("in, ft"), "{help}");
}

#[test]
fn sizes_and_materials() {
    let (message, help, line, _) = refused(
        "thickness = \"2 mm\"\n[bodies.plate.s",
        "thickness = \"-2 mm\"\n[bodies.plate.s",
    );
    assert_eq!(
        message,
        "thickness = -2 mm is outside its range: greater than 0"
    );
    assert_eq!(
        (help.as_str(), line),
        ("thickness must be greater than 0", 8)
    );
    let (message, help, line, shown) = refused("poisson = 0.3", "poisson = 0.6");
    assert_eq!(
        message,
        "material 'steel': Poisson's ratio 0.6 must be greater than -1 and at most 0.5 in plane stress"
    );
    assert!(help.contains("0.25 to 0.35"), "{help}");
    assert_eq!((line, shown.as_str()), (5, "0.6"));
    let (message, ..) = refused("half_width = \"20 mm\"", "half_width = \"5 mm\"");
    assert_eq!(
        message,
        "half_width = 5 mm is outside its range: greater than the hole's radius, 5 mm"
    );
    let (message, help, line, shown) = refused(
        "material = \"steel\"\nthickness = \"2 mm\"\n[",
        "material = \"stel\"\nthickness = \"2 mm\"\n[",
    );
    assert_eq!(message, "there is no material 'stel'");
    assert_eq!(
        help,
        "did you mean 'steel'? material names in this scene: steel"
    );
    assert_eq!((line, shown.as_str()), (7, "\"stel\""));
    let (message, ..) = refused(
        "material = \"steel\"\nthickness = \"2 mm\"\nshape.d",
        "material = \"steel\"\nrigid = true\nshape.d",
    );
    assert!(
        message.ends_with("exactly one of material = \"…\", rigid = true is needed, found both"),
        "{message}"
    );
    let (message, ..) = refused(
        "version = 1\n",
        "version = 1\nanalysis.plane = \"strain\"\nmaterials.ply.orthotropic = { e1 = \"9 GPa\", e2 = \"9 GPa\", g12 = \"3 GPa\", nu12 = 0.3, nu13 = 0.3, nu23 = 0.3 }\n",
    );
    assert_eq!(message, "'e3' is missing in 'materials.ply.orthotropic'");
}

#[test]
fn contacts() {
    let (message, help, line, shown) = refused("friction.coulomb = { mu = 0.2 }\n", "");
    assert_eq!(message, "contact 'pin' has no friction law");
    assert!(
        help.contains("a frictionless contact says friction.coulomb = { mu = 0 }"),
        "{help}"
    );
    assert!(line >= 17 && shown.contains("contacts"), "{line} {shown}");
    let (message, help, line, shown) = refused("4.99 mm", "5.01 mm");
    assert_eq!(
        message,
        "the pin (radius 5.01 mm) is larger than the hole (radius 5 mm): they overlap by 0.01 mm"
    );
    assert!(help.contains("interference = true"), "{help}");
    assert_eq!((line, shown.as_str()), (15, "\"5.01 mm\""));
    assert!(
        read(
            &SCENE
                .replace("4.99 mm", "5.01 mm")
                .replace("friction.", "interference = true\nfriction.")
        )
        .is_ok()
    );
    let (message, help, line, _) = refused("\"plate.hole\"", "\"plate.hol\"");
    assert_eq!(message, "'plate' (plate_with_hole) has no edge 'hol'");
    assert_eq!(
        help,
        "did you mean 'plate.hole'? sets of 'plate' that fit here: plate.hole, plate.left, plate.right, plate.top, plate.bottom"
    );
    assert_eq!(line, 19);
    let (message, help, ..) = refused(
        "first = \"plate.hole\"\nsecond = \"pin.rim\"",
        "first = \"pin.rim\"\nsecond = \"plate.hole\"",
    );
    assert_eq!(message, "'pin.rim' and 'plate.hole' cannot be in contact");
    assert_eq!(
        help,
        "swap them: first = \"plate.hole\", second = \"pin.rim\""
    );
    let (message, ..) = refused("mu = 0.2", "mu = -0.2");
    assert_eq!(
        message,
        "friction law 'coulomb': mu = -0.2 is outside [0, ∞)"
    );
}

#[test]
fn supports_and_loads() {
    let (message, help, line, _) = refused(
        "[[supports]]\non = \"pin.centre\"\nfix = [\"x\", \"y\"]\n",
        "",
    );
    assert_eq!(
        message,
        "nothing holds 'pin' and 'plate': no support, no platen, and no contact with a body that has one"
    );
    assert!(help.contains("[[supports]]"), "{help}");
    assert_eq!(line, 12);
    let (message, help, line, _) = refused("on = \"plate.left\"", "on = \"plate.far\"");
    assert_eq!(
        message,
        "'plate' (plate_with_hole) has no edge, point or area 'far'"
    );
    assert!(help.contains("plate.left, plate.right"), "{help}");
    assert_eq!(line, 26);
    let (message, help, ..) = refused("on = \"plate.left\"", "on = \"plat.left\"");
    assert_eq!(message, "there is no body 'plat'");
    assert_eq!(
        help,
        "did you mean 'plate'? body names in this scene: pin, plate"
    );
    let second =
        "[[loads]]\nname = \"more\"\non = \"plate.top\"\npressure.steps = [\"1 MPa\"]\n[[loads]]";
    let error = read(&format!("{SCENE}{}", second.trim_end_matches("[[loads]]"))).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a.toml:31:18: load 'more' has 1 step, but load 'load1' has 2"
    );
    let (message, _, line, _) = refused("direction = [-2, 0]", "direction = [0, 0]");
    assert!(
        message.starts_with("direction = [0, 0] is outside its range"),
        "{message}"
    );
    assert_eq!(line, 27);
    let (message, ..) = refused("force = {", "temperature = { steps = [] }\nforce = {");
    assert!(
        message.contains("exactly one of force, bearing, pressure, polar_traction, temperature"),
        "{message}"
    );
    let heat = "on = \"plate\"\ntemperature = { steps = [\"10 K\", \"20 K\"] }\n";
    let start = SCENE.find("on = \"plate.left\"").unwrap();
    let error = read(&format!("{}{heat}", &SCENE[..start])).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("material 'steel' has no expansion"),
        "{error}"
    );
    let load = SCENE.find("[[loads]]").unwrap();
    let error = read(&SCENE[..load]).unwrap_err();
    assert!(
        error.to_string().contains("nothing happens in this scene"),
        "{error}"
    );
}

#[test]
fn loads_that_are_held() {
    let held = "on = \"plate.left\"\nfix = [\"x\"]";
    let (message, help, line, shown) =
        refused("[[loads]]", &format!("[[supports]]\n{held}\n[[loads]]"));
    assert_eq!(
        message,
        "'plate.left' is held against load 'load1', which therefore changes nothing"
    );
    assert!(help.starts_with("load another edge"), "{help}");
    assert_eq!((line, shown.as_str()), (29, "\"plate.left\""));
    let across = format!(
        "[[supports]]\n{}\n[[loads]]",
        held.replace("[\"x\"]", "[\"y\"]")
    );
    read(&SCENE.replace("[[loads]]", &across)).unwrap();
    let pressure = "pressure.steps = [\"1 MPa\"]\n";
    let force = SCENE.find("force = {").unwrap();
    read(&format!(
        "{}{pressure}",
        SCENE[..force].replace("[[loads]]", &format!("[[supports]]\n{held}\n[[loads]]"))
    ))
    .unwrap();
    let platen = "[[platens]]\non = \"plate.left\"\nfree = [\"y\"]\n[[loads]]";
    let (message, ..) = refused("[[loads]]", platen);
    assert!(message.contains("held against load"), "{message}");
}

#[test]
fn loads_on_a_held_rigid_body() {
    let rigid = SCENE.replace(
        "[bodies.pin]\nmaterial = \"steel\"\nthickness = \"2 mm\"\n",
        "[bodies.pin]\nrigid = true\n",
    );
    let more = "[[loads]]\non = \"pin.rim\"\nforce = { direction = [1, 1], steps = [\"1 kN\", \"2 kN\"] }\n";
    let error = read(&format!("{rigid}{more}")).unwrap_err().to_string();
    assert!(
        error.contains("'pin.rim' is held against load 'load2'"),
        "{error}"
    );
    read(&format!("{SCENE}{more}")).unwrap();
}

#[test]
fn bearing_loads() {
    use miette::Diagnostic as _;

    let start = SCENE.find("on = \"plate.left\"").unwrap();
    let refusal = |load: &str| {
        let error = read(&format!("{}{load}", &SCENE[..start])).unwrap_err();
        let help = error.findings()[0]
            .problem
            .help()
            .map(|help| help.to_string());
        (error.to_string(), help.unwrap_or_default())
    };
    let bearing = |on: &str, what: &str| {
        refusal(&format!(
            "on = \"{on}\"\nbearing = {{ {what}, steps = [\"1 kN\", \"2 kN\"] }}\n"
        ))
    };
    let (message, help) = bearing("plate.left", "direction = [1, 0], law = \"cosine\"");
    assert!(message.contains("'plate.left' is no hole"), "{message}");
    assert!(help.contains("plate.hole"), "{help}");
    let (message, help) = bearing("plate.hole", "direction = [1, 0], law = \"cosinus\"");
    assert!(
        message.contains("'cosinus' is not one of the choices"),
        "{message}"
    );
    assert!(help.contains("cosine, uniform"), "{help}");
    let (message, _) = bearing("plate.hole", "direction = [1, 0]");
    assert!(message.contains("'law' is missing"), "{message}");
    let (message, _) = bearing("plate.hole", "direction = [0, 0], law = \"cosine\"");
    assert!(
        message.contains("direction = [0, 0] is outside its range"),
        "{message}"
    );
    let (message, help) = refusal(
        "on = \"plate.hole\"\nbearing = { direction = [1, 0], law = \"cosine\", steps = [\"1 kN\", \"-2 kN\"] }\n",
    );
    assert!(message.contains("-2 kN is outside its range"), "{message}");
    assert!(help.contains("turn the direction"), "{help}");
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
    assert!(
        error
            .to_string()
            .starts_with("a.toml:27:27: data file 'none.csv': cannot be read"),
        "{error}"
    );
}

#[test]
fn meshes() {
    let (message, help, line, _) = refused("spacing = \"2 deg\"", "spacing = \"2 mm\"");
    assert_eq!(
        message,
        "body 'pin' (disk) is divided by angles, but mesh.spacing = 2 mm is a length"
    );
    assert!(help.contains("spacing = \"2 deg\""), "{help}");
    assert_eq!(line, 17);
    let (message, ..) = refused("spacing = \"2 deg\"", "spacing = \"0 deg\"");
    assert_eq!(
        message,
        "spacing = 0 deg is outside its range: greater than 0"
    );
    let (message, _, _, shown) = refused(
        "spacing = \"2 deg\"",
        "angles = [\"0 deg\", \"9 deg\", \"5 deg\", \"180 deg\"]",
    );
    assert_eq!(
        message,
        "angles[2] = 5 deg is outside its range: greater than the angle before it, 9 deg"
    );
    assert_eq!(shown, "\"5 deg\"");
    let (message, ..) = refused("spacing = \"2 deg\"", "layers = 3");
    assert!(
        message.starts_with("mesh: exactly one of spacing"),
        "{message}"
    );
    let (message, ..) = refused(
        "spacing = \"2 deg\"",
        "spacing = \"2 deg\"\nfine_to = \"1 mm\"",
    );
    assert_eq!(
        message,
        "\"1 mm\" has the unit of a length; an angle is expected"
    );
}

#[test]
fn mesh_keys_that_no_shape_uses() {
    let own = |setting: &str| {
        let disk = "shape.disk = { radius = \"4.99 mm\" }";
        refused(disk, &format!("{disk}\nmesh = {{ {setting} }}"))
    };
    let (message, help, line, shown) = own("layers = 4");
    assert_eq!(
        message,
        "bodies.pin.mesh.layers has no effect: nothing in the mesh of a disk depends on it"
    );
    assert_eq!(help, "remove layers");
    assert_eq!((line, shown.as_str()), (16, "4"));
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
        let error = read(&text).err();
        error.map(|error| error.findings()[0].summary().message)
    };
    let coupon = r#"rectangle = { width = "60 mm", height = "20 mm" }"#;
    let cap = r#"cylinder = { radius = "100 mm", half_length = "20 mm", depth = "18 mm" }"#;
    let block = r#"block = { half_length = "20 mm", depth = "18 mm" }"#;
    assert_eq!(press([coupon, coupon], "element = \"Q4\""), None);
    assert_eq!(
        press([coupon, coupon], "fine_to = \"5 mm\"").as_deref(),
        Some("mesh.fine_to has no effect: nothing in the mesh of a rectangle depends on it")
    );
    assert_eq!(press([coupon, block], "fine_to = \"5 mm\""), None);
    assert_eq!(
        press(
            [cap, block],
            "fine_to = \"5 mm\"\ncoarse_spacing = \"2 mm\""
        )
        .as_deref(),
        Some(
            "mesh.coarse_spacing has no effect: nothing in the mesh of a block or a cylinder depends on it"
        )
    );
}

#[test]
fn versions() {
    let (message, help, line, _) = refused("version = 1", "version = 2");
    assert_eq!(message, "version 2 of the scene format is not supported");
    assert_eq!(
        (help.as_str(), line),
        ("this program reads `version = 1`", 1)
    );
    let error = read(&SCENE.replace("version = 1\n", "")).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a.toml:1:1: the scene does not say which version of the format it is written in"
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
    let error = with("mesh.spacing=4").unwrap_err();
    assert_eq!(
        error.to_string(),
        "--set:1:14: 4 has no unit; an angle or a length is expected"
    );
    let error = with("mesh.spaces=4 deg").unwrap_err();
    assert_eq!(error.to_string(), "--set:1:1: unknown key 'spaces'");
    let error = with("contacts.0.friction.static_dynamic.static=0.3").unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("--set:1:1: 'dynamic' is missing in 'contacts.0.friction.static_dynamic'"),
        "{error}"
    );
}

#[test]
fn accuracies_and_models_that_no_run_can_have() {
    let analysis = |keys: &str| refused("[mesh]", &format!("[analysis]\n{keys}\n[mesh]"));
    for (value, shown) in [
        ("\"0 %\"", "\"0 %\""),
        ("\"-1 %\"", "\"-1 %\""),
        ("0.6", "0.6"),
        ("1e-9", "1e-9"),
    ] {
        let (message, help, line, found) = analysis(&format!("accuracy = {value}"));
        assert!(message.starts_with("accuracy = "), "{message}");
        assert!((message + &help).contains("at least 1e-8 and at most 50 %"));
        assert_eq!((line, found.as_str()), (17, shown));
    }
    for (value, shown) in [
        ("\"0 %\"", "\"0 %\""),
        ("-0.01", "-0.01"),
        ("\"51 %\"", "\"51 %\""),
        ("1e-9", "1e-9"),
    ] {
        let table = format!("accuracy = {{ peak_hoop = \"1 %\", peak_pressure = {value} }}");
        let (message, help, line, found) = analysis(&table);
        assert!(message.starts_with("peak_pressure = "), "{message}");
        assert!((message + &help).contains("at least 1e-8 and at most 50 %"));
        assert_eq!((line, found.as_str()), (17, shown));
    }
    let (message, help, line, found) = analysis("accuracy = { peak_presure = \"1 %\" }");
    assert_eq!(message, "unknown key 'peak_presure'");
    assert!(help.contains("peak_pressure"), "{help}");
    assert_eq!((line, found.as_str()), (17, "peak_presure"));
    let (message, ..) = analysis("accuracy = { peak_hoop = \"fine\" }");
    assert!(
        message.contains("'fine' is not a relative error"),
        "{message}"
    );
    let (message, help, ..) = analysis("accuracy = {}");
    assert!(message.contains("names no number"), "{message}");
    assert!(help.contains("peak_pressure"), "{help}");
    let (message, ..) = analysis("accuracy = \"fine\"");
    assert!(
        message.contains("'fine' is not a relative error"),
        "{message}"
    );
    for (keys, said, remedy) in [
        (
            "budget = \"10 s\"",
            "none is asked for",
            "analysis.accuracy",
        ),
        ("accuracy = \"1 %\"\nbudget = \"0 s\"", "budget = ", ""),
        ("accuracy = \"1 %\"\nbudget = 10", "'10' is not a time", ""),
        ("memory = \"0 GB\"", "memory = ", ""),
        ("memory = 4", "'4' is not an amount of memory", ""),
        (
            "memory = \"8 GB\"",
            "mesh prescribes this one",
            "one of the two",
        ),
    ] {
        let (message, help, ..) = analysis(keys);
        assert!(message.contains(said), "{message}");
        assert!(help.contains(remedy), "{help}");
        // What is out of range begins with its key.
        assert!(
            !said.ends_with(" = ") || message.starts_with(said),
            "{message}"
        );
    }
    let (message, ..) = analysis("contact_nodes = 3");
    assert!(message.contains("contact_nodes"), "{message}");
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
    let (message, help, ..) = refused(
        "shape.disk = { radius = \"4.99 mm\" }",
        "model = \"series\"\nshape.disk = { radius = \"4.99 mm\" }\nmesh.spacing = \"3 deg\"",
    );
    assert!(message.contains("bodies.pin.mesh"), "{message}");
    assert!(help.contains("one of the two"), "{help}");
    let (message, ..) = refused(
        "[bodies.pin]\nmaterial = \"steel\"\nthickness = \"2 mm\"",
        "[bodies.pin]\nrigid = true\nmodel = \"elements\"",
    );
    assert!(message.contains("this one is rigid"), "{message}");
}
