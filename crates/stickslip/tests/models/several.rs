//! Several contacts that know nothing of each other, in one scene.

use super::{BUSHING, difference, solved, tractions};

const LINES: &str = r#"
version = 1
[analysis]
plane = "strain"
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.block]
material = "metal"
thickness = "1 mm"
shape.block = { half_length = "12 mm", depth = "12 mm" }
[bodies.roller]
material = "metal"
thickness = "1 mm"
shape.cylinder = { radius = "50 mm", half_length = "12 mm", depth = "12 mm" }
[bodies.slab]
material = "metal"
thickness = "1 mm"
shape.block = { half_length = "8 mm", depth = "10 mm" }
[bodies.wheel]
material = "metal"
thickness = "1 mm"
shape.cylinder = { radius = "30 mm", half_length = "8 mm", depth = "10 mm" }
[mesh]
spacing = "0.2 mm"
fine_to = "1.6 mm"
[[contacts]]
first = "roller.contact"
second = "block.contact"
friction.coulomb = { mu = 0.4 }
[[contacts]]
first = "wheel.contact"
second = "slab.contact"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "block.bottom"
fix = ["x", "y"]
[[supports]]
on = "slab.bottom"
fix = ["x", "y"]
[[platens]]
on = "roller.top"
free = ["x", "y"]
[[platens]]
on = "wheel.top"
free = ["x", "y"]
[[loads]]
on = "roller.top"
force = { direction = [0, -1], steps = ["300 N", "600 N"] }
[[loads]]
on = "roller.top"
force = { direction = [1, 0], steps = ["10 N", "100 N"] }
[[loads]]
on = "wheel.top"
force = { direction = [0, -1], steps = ["200 N", "300 N"] }
[output]
fields = "none"
figures = false
"#;

/// The scene without some of its tables, which start with these lines.
fn without(text: &str, tables: &[&str]) -> String {
    let mut kept = String::new();
    for table in text.split("\n[").skip(1) {
        let table = format!("[{table}\n");
        if !tables.iter().any(|start| table.contains(start)) {
            kept += &table;
        }
    }
    format!("version = 1\n{kept}")
}

#[test]
fn two_line_contacts_are_as_each_is_alone() {
    let both = solved(LINES, &[]);
    let roller = solved(&without(LINES, &["wheel", "slab"]), &[]);
    let wheel = solved(
        &without(LINES, &["roller", "block]", "block."]),
        &["analysis.model=whole"],
    );
    for step in 0..2 {
        for (edge, alone) in [(0, &roller), (1, &wheel)] {
            let apart = difference(
                tractions(&alone.steps[step].edges[0].rows),
                tractions(&both.steps[step].edges[edge].rows),
            );
            // The same bodies and the same points; only the sums of the solvers run over more of them.
            assert!(apart < 1e-9, "step {step}, contact {edge}: {apart:e}");
        }
    }
    // Different radii and loads: different contacts.
    let extent = |edge: usize| both.steps[1].edges[edge].contact_half_extent.unwrap();
    assert!((extent(0) / extent(1) - 1.0).abs() > 0.1);
}

#[test]
fn two_joints_are_as_each_is_alone() {
    let second = r#"
[bodies.lug]
material = "metal"
thickness = "3 mm"
shape.plate_with_hole = { hole_radius = "4 mm", outline.ring.radius = "15 mm" }
[bodies.bolt]
material = "metal"
thickness = "3 mm"
shape.disk.radius = "3.99 mm"
[[contacts]]
first = "lug.hole"
second = "bolt.rim"
friction.coulomb = { mu = 0.1 }
[[supports]]
on = "bolt.centre"
fix = ["x", "y"]
[[loads]]
on = "lug.outer"
force = { direction = [-1, 0], steps = ["500 N", "700 N", "900 N"] }
"#;
    let both = solved(&format!("{BUSHING}{second}"), &[]);
    let bushing = solved(BUSHING, &[]);
    let lug = without(
        &format!("{BUSHING}{second}"),
        &["plate]", "\"plate.", "bodies.plate.", "bushing", "pin"],
    );
    let lug = solved(&lug, &[]);
    assert_eq!(both.edges.len(), 3);
    for step in 0..3 {
        for (edge, alone, own) in [(0, &bushing, 0), (1, &bushing, 1), (2, &lug, 0)] {
            let apart = difference(
                tractions(&alone.steps[step].edges[own].rows),
                tractions(&both.steps[step].edges[edge].rows),
            );
            assert!(apart < 1e-9, "step {step}, contact {edge}: {apart:e}");
        }
    }
}
