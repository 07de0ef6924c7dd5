//! Several joints in one scene, each with a load of its own: every number, name and picture is that of the joint alone.

use std::fs;
use std::path::Path;

use super::files::{read, summary, written};
use super::{PIN, scene};

/// Name of a joint, loaded edge of its plate, direction and steps of its load.
type Own = (&'static str, &'static str, &'static str, &'static str);

const JOINTS: [Own; 3] = [
    ("a", "left", "[-1, 0]", r#"["1 kN", "2 kN", "0.5 kN"]"#),
    ("b", "top", "[0, 1]", r#"["3 kN", "1 kN", "0.2 kN"]"#),
    ("c", "bottom", "[0, -1]", r#"["0 kN", "0.4 kN", "0.8 kN"]"#),
];

/// The materials of [`PIN`] and joints of its shape.
fn joints(own: &[Own]) -> String {
    let materials = PIN.split("[bodies.plate]").next().unwrap();
    let joint = |(name, edge, direction, steps): &Own| {
        format!(
            r#"
[bodies.plate_{name}]
material = "laminate"
[bodies.plate_{name}.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = {{ half_width = "15 mm", left = "20 mm", right = "20 mm" }}
[bodies.pin_{name}]
material = "steel"
thickness = "1.5 mm"
shape.disk = {{ radius = "4.98 mm" }}
[[contacts]]
name = "joint_{name}"
first = "plate_{name}.hole"
second = "pin_{name}.rim"
friction.coulomb = {{ mu = 0.2 }}
[[supports]]
on = "pin_{name}.centre"
fix = ["x", "y"]
[[loads]]
name = "P_{name}"
on = "plate_{name}.{edge}"
force = {{ direction = {direction}, steps = {steps} }}
"#
        )
    };
    let all: String = own.iter().map(joint).collect();
    let settings = r#"
[analysis]
model = "whole"
[mesh]
element = "Q4"
spacing = "15 deg"
[failure]
criteria = ["hashin"]
characteristic = { tension = "1 mm", compression = "2 mm" }
"#;
    format!("{materials}{all}{settings}")
}

/// Figures other than fields, of which only the first contact has some: file names and drawings.
fn figures(folder: &Path) -> Vec<(String, String)> {
    let entries = fs::read_dir(folder.join("figures")).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let drawn = paths.filter(|path| path.extension().is_some_and(|ending| ending == "svg"));
    let names = drawn.map(|path| path.file_name().unwrap().to_str().unwrap().to_owned());
    names
        .filter(|name| !name.starts_with("field-"))
        .map(|name| (name.clone(), read(folder, &format!("figures/{name}"))))
        .collect()
}

/// What stands between two texts, each time that it does.
fn between<'t>(text: &'t str, start: &str, end: &str) -> Vec<&'t str> {
    let parts = text.split(start).skip(1);
    parts.filter_map(|part| part.split(end).next()).collect()
}

#[test]
fn each_of_three_joints_is_as_it_is_alone() {
    let (_folder, all) = written(&scene(&joints(&JOINTS), &[]));
    let (whole, page) = (summary(&all), read(&all, "report.html"));
    for (index, joint) in JOINTS.iter().enumerate() {
        let name = joint.0;
        let (_folder, alone) = written(&scene(&joints(&[*joint]), &[]));
        let own = summary(&alone);
        assert_eq!(own["failure"][0], whole["failure"][index], "joint {name}");
        assert_eq!(own["failure"][0]["load_name"], format!("P_{name}"));
        assert_eq!(own["edges"][0], whole["edges"][index], "joint {name}");
        let contact = format!("joint_{name}");
        for step in 0..3 {
            let (one, other) = (&own["steps"][step], &whole["steps"][step]);
            assert_eq!(
                one["edges"][&contact], other["edges"][&contact],
                "joint {name}, step {step}"
            );
            assert_eq!(one["edges"][&contact]["load"], one["load"]);
            assert_eq!(one["edges"][&contact]["unloading"], one["unloading"]);
        }
        for table in ["failure", "first-ply", "characteristic"] {
            let file = format!("{table}-plate_{name}.csv");
            assert_eq!(read(&alone, &file), read(&all, &file), "{file}");
        }
        let drawn = figures(&alone);
        assert!(drawn.len() > 8, "{}", drawn.len());
        let together = figures(&all);
        // The sketch shows all bodies.
        for picture in drawn.iter().filter(|own| !own.0.starts_with("sketch")) {
            assert!(together.contains(picture), "{}", picture.0);
        }
        let own_page = read(&alone, "report.html");
        let captions = between(&own_page, "<figcaption>", "</figcaption>");
        assert!(captions.len() >= drawn.len(), "{}", captions.len());
        for caption in captions {
            let about_fields = caption.contains("Shape before deformation");
            assert!(page.contains(caption) || about_fields, "{caption}");
        }
        let headline = format!("'{contact}': Largest pressure");
        assert!(page.replace("&#x27;", "'").contains(&headline), "{contact}");
    }
    // Fields of the largest load on each joint.
    for step in 1..=3 {
        let file = format!("fields/plate_a-step-{step:02}.vtu");
        assert!(all.join(&file).exists(), "{file}");
    }
}
