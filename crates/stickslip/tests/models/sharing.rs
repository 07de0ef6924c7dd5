//! Load sharing among the contacts of a body.

use std::fmt::Write as _;

use crate::solved;

/// Forces on two round punches `[N]`.
const FORCES: [f64; 2] = [100.0, 50.0];

/// Two punches on one block, which is the second body of both contacts.
fn punches() -> String {
    let mut text = r#"
version = 1
[materials.aluminium.isotropic]
young = "72 GPa"
poisson = 0.33
[mesh]
spacing = "2 mm"
[output]
fields = "none"
figures = false
[bodies.block]
material = "aluminium"
thickness = "1 mm"
[bodies.block.shape.outline]
start = ["-20 mm", "-20 mm"]
edges = [
  { name = "bottom", to = ["20 mm", "-20 mm"] },
  { name = "right", to = ["20 mm", "0 mm"] },
  { name = "top-0", to = ["0 mm", "0 mm"] },
  { name = "top-1", to = ["-20 mm", "0 mm"] },
  { name = "left" },
]
[[supports]]
on = "block.bottom"
fix = ["x", "y"]
"#
    .to_owned();
    for (k, (x, force)) in [10.0, -10.0].into_iter().zip(FORCES).enumerate() {
        let (left, right) = (x - 5.0, x + 5.0);
        let _ = write!(
            text,
            r#"
[bodies.punch-{k}]
material = "aluminium"
thickness = "1 mm"
[bodies.punch-{k}.shape.outline]
start = ["{left} mm", "5 mm"]
edges = [
  {{ name = "face", to = ["{right} mm", "5 mm"], through = ["{x} mm", "0 mm"], refine = 4 }},
  {{ name = "right", to = ["{right} mm", "10 mm"] }},
  {{ name = "top", to = ["{left} mm", "10 mm"] }},
  {{ name = "left" }},
]
[[contacts]]
name = "contact-{k}"
first = "punch-{k}.face"
second = "block.top-{k}"
friction.coulomb = {{ mu = 0.2 }}
[[platens]]
on = "punch-{k}.top"
free = ["y"]
[[loads]]
name = "press-{k}"
on = "punch-{k}.top"
force = {{ direction = [0, -1], steps = ["{force} N"] }}
"#
        );
    }
    text
}

#[test]
fn a_body_shares_its_load_as_the_second_one_of_its_contacts_too() {
    let results = solved(&punches(), &[]);
    for (edge, part) in [(0, 2.0 / 3.0), (1, 1.0 / 3.0)] {
        // Sideways forces turn the sum a little.
        let share = results.load_share(edge, 0).unwrap().part;
        assert!((share - part).abs() < 1e-3, "{edge}: {share}");
    }
    let bodies = (0..results.bodies.len()).filter(|&body| results.shares_load(body));
    let names: Vec<&str> = bodies
        .map(|body| results.bodies[body].name.as_str())
        .collect();
    assert_eq!(names, ["block"]);
    let block = results.bodies.iter().position(|body| body.name == "block");
    let down = results.force_on(block.unwrap(), 0, 0)[1];
    assert!((down + FORCES[0]).abs() < 1e-6 * FORCES[0], "{down}");
}
