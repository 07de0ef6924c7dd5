//! Springs to the ground, and rollers along a slope, against closed forms.

use stickslip::model::Model;
use stickslip::results::{Finding, Results, SetMotion};
use stickslip::run;
use stickslip::scene::schema::SolverChoice;

use super::{scene, solved};

/// A block of 40 by 20 mm, 2 mm thick, on its lower edge, under a pressure on its upper one.
const BLOCK: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.3
[bodies.block]
material = "metal"
thickness = "2 mm"
mesh.spacing = "4 mm"
shape.outline = { start = ["-20 mm", "0 mm"], edges = [{ name = "bottom", to = ["20 mm", "0 mm"] }, { name = "right", to = ["20 mm", "20 mm"] }, { name = "top", to = ["0 mm", "20 mm"] }, { name = "top-left", to = ["-20 mm", "20 mm"] }, { name = "left" }] }
[[supports]]
on = "block.bottom"
fix = ["y"]
bed = "5 MPa/mm"
[[supports]]
on = "block.left"
fix = ["x"]
[[loads]]
name = "right-half"
on = "block.top"
pressure.steps = ["10 MPa", "10 MPa"]
[[loads]]
name = "left-half"
on = "block.top-left"
pressure.steps = ["10 MPa", "0 MPa"]
[[edges]]
on = "block.bottom"
[output]
fields = "none"
figures = false
"#;

fn close(found: f64, expected: f64, part: f64) {
    assert!(
        (found - expected).abs() <= part * expected.abs(),
        "{found} {expected}: {:.2e}",
        found / expected - 1.0
    );
}

/// The set of this name at the end of a step.
fn set(results: &Results, step: usize, name: &str) -> SetMotion {
    let index = results.sets.iter().position(|set| set.name == name);
    results.steps[step].sets[index.unwrap()].unwrap()
}

/// Under pressure all over: w = p/k below, and p h/E more above.
#[test]
fn a_block_on_a_bed_sinks_by_its_pressure() {
    let results = solved(BLOCK, &[]);
    let bottom = set(&results, 0, "block.bottom");
    close(bottom.displacement, -10.0 / 5.0, 1e-9);
    close(bottom.force, 10.0 * 40.0 * 2.0, 1e-9);
    let top = set(&results, 0, "right-half");
    close(top.displacement, 10.0 / 5.0 + 10.0 * 20.0 / 70e3, 1e-9);
    for row in &results.steps[0].edges[0].rows {
        close(row.sigma_normal, -10.0, 1e-6);
        assert!(row.tau.abs() < 1e-6, "{row:?}");
    }
    assert!(
        results
            .steps
            .iter()
            .all(|step| step.balance_residual < 1e-9)
    );
}

/// The same stiffness as that of the whole edge.
#[test]
fn a_bed_is_the_stiffness_of_its_area() {
    let whole = BLOCK.replace("bed = \"5 MPa/mm\"", "stiffness = \"0.4 kN/mm\"");
    let [bed, whole] = [BLOCK, &whole].map(|text| set(&solved(text, &[]), 1, "block.bottom"));
    close(whole.displacement, bed.displacement, 1e-12);
    close(whole.force, bed.force, 1e-12);
}

/// A nearly rigid block, by 10⁻⁶ of what springs give, and no stiffer, for their digits: under a force F at the distance e from its middle: w = F/(k b t) + F e x/(k I), I = b³ t/12.
#[test]
fn a_stiff_block_on_a_bed_tilts() {
    let free = r#"supports.1={ on = "block.bottom", fix = ["x"], bed = "5 MPa/mm" }"#;
    let results = solved(
        BLOCK,
        &["materials.metal.isotropic.young=\"7e5 GPa\"", free],
    );
    let (force, arm, inertia) = (10.0 * 20.0 * 2.0, 10.0, 40.0_f64.powi(3) * 2.0 / 12.0);
    let sinks = |x: f64| force / (5.0 * 80.0) + force * arm * x / (5.0 * inertia);
    // The mean over the right half of the top.
    close(
        set(&results, 1, "right-half").displacement,
        sinks(10.0),
        1e-5,
    );
    close(
        set(&results, 1, "block.bottom").displacement,
        -sinks(0.0),
        1e-5,
    );
}

/// A block on a slope of 30°, held along the slope at its upper end: F cos 30° and F sin 30°, and a spring gives by the first over its stiffness.
#[test]
fn a_roller_on_a_slope_takes_the_force_across_it() {
    let slope = BLOCK
        .replace("fix = [\"y\"]\nbed = \"5 MPa/mm\"", "normal = \"120 deg\"")
        .replace("fix = [\"x\"]", "normal = \"30 deg\"")
        .replace("shape.outline", "angle = \"30 deg\"\nshape.outline")
        .replace(
            "pressure.steps = [\"10 MPa\", \"10 MPa\"]",
            "force = { direction = [0, -1], steps = [\"2 kN\", \"1 kN\"] }",
        )
        .replace(
            "pressure.steps = [\"10 MPa\", \"0 MPa\"]",
            "force = { direction = [0, -1], steps = [\"2 kN\", \"0 kN\"] }",
        );
    let (sin, cos) = 30.0_f64.to_radians().sin_cos();
    let rigid = solved(&slope, &[]);
    let sprung = solved(&slope, &["supports.0.stiffness=2 kN/mm"]);
    for results in [&rigid, &sprung] {
        for (step, force) in [4000.0, 1000.0].into_iter().enumerate() {
            close(set(results, step, "block.bottom").force, force * cos, 1e-9);
            close(set(results, step, "block.left").force, force * sin, 1e-9);
        }
    }
    close(
        set(&sprung, 0, "block.bottom").displacement,
        -2.0 * cos,
        1e-9,
    );
    assert_eq!(set(&rigid, 0, "block.bottom").displacement, 0.0);
}

/// A force at a corner tilts a stiff block as one beside it, and is reported; a spring at a point gives by F/K.
#[test]
fn forces_and_springs_act_at_points() {
    let points = "shape.outline = { points = { corner = [\"20 mm\", \"20 mm\"], middle = [\"0 mm\", \"20 mm\"] },";
    let text = BLOCK.replace("shape.outline = {", points);
    let stiff = "materials.metal.isotropic.young=\"7e5 GPa\"";
    let free = r#"supports.1={ on = "block.bottom", fix = ["x"], bed = "5 MPa/mm" }"#;
    let push = r#"loads.0={ name = "push", on = "block.corner", force = { direction = [0, -1], steps = ["100 N", "200 N"] } }"#;
    let none = r#"loads.1.pressure.steps=["0 MPa", "0 MPa"]"#;
    let results = solved(&text, &[stiff, free, push, none]);
    let inertia = 40.0_f64.powi(3) * 2.0 / 12.0;
    let sinks = 200.0 / (5.0 * 80.0) + 200.0 * 20.0 * 20.0 / (5.0 * inertia);
    close(set(&results, 1, "push").displacement, sinks, 1e-4);
    let found = results.findings.iter().any(
        |finding| matches!(finding, Finding::PointLoads { loads } if *loads == ["push".to_owned()]),
    );
    assert!(found);
    // All of the block's weight on a spring at the middle of its upper edge, guided along it.
    let hung = [
        r#"supports.0={ on = "block.middle", fix = ["y"], stiffness = "1 kN/mm" }"#,
        r#"loads.0={ name = "weight", on = "block.section", force = { direction = [0, -1], steps = ["100 N", "200 N"] } }"#,
        none,
    ];
    let results = solved(&text, &hung);
    let spring = set(&results, 1, "block.middle");
    close(spring.force, 200.0, 1e-9);
    close(spring.displacement, -0.2, 1e-9);
}

#[test]
fn springs_that_cannot_be_are_refused() {
    let refused = |from: &str, to: &str| {
        let text = BLOCK.replacen(from, to, 1);
        let read = stickslip::scene::Scene::from_text(
            &text,
            stickslip::scene::Format::Toml,
            "a.toml",
            std::path::Path::new(""),
            &[] as &[&str],
        );
        read.err()
            .map(|error| error.to_string())
            .unwrap_or_default()
    };
    let bed = "bed = \"5 MPa/mm\"";
    for (to, part) in [
        ("bed = \"5 MPa\"", "a bed stiffness is expected"),
        ("bed = \"-5 MPa/mm\"", "bed"),
        ("bed = \"5 MPa/mm\"\nstiffness = \"1 N/mm\"", "both given"),
        (
            "bed = \"5 MPa/mm\"\ndisplacement = \"1 mm\"",
            "the ground, which is at rest",
        ),
    ] {
        let message = refused(bed, to);
        assert!(message.contains(part), "{to}: {message}");
    }
    let rigid = refused(
        "material = \"metal\"\nthickness = \"2 mm\"\nmesh.spacing = \"4 mm\"",
        "rigid = true",
    );
    assert!(rigid.contains("rigid body"), "{rigid}");
    let held = refused(
        bed,
        "bed = \"5 MPa/mm\"\n[[supports]]\non = \"block.bottom\"\nfix = [\"y\"]",
    );
    assert!(held.contains("carry nothing"), "{held}");
    // A platen that is free along springs on it would not feel them.
    let platen = "bed = \"5 MPa/mm\"\n[[platens]]\non = \"block.bottom\"\nfree = [\"y\"]";
    let text = BLOCK.replacen(bed, platen, 1);
    let read = scene(
        &text,
        &["supports.1.on=\"block.right\"", "loads.0.on=\"block.top\""],
    );
    let solver = run::solver(SolverChoice::Auto);
    let refused = Model::build(&read)
        .map_err(|error| error.to_string())
        .and_then(|model| {
            let solved = run::solve(&model, solver.as_ref(), &mut |_| {});
            solved.map(|_| ()).map_err(|error| error.to_string())
        });
    assert!(refused.unwrap_err().contains("no spring on its body"));
    // Beside the motion on springs as soft as these no digits of the body are left.
    let soft = scene(BLOCK, &["supports.0.bed=\"1e-8 MPa/mm\""]);
    let refused = Model::build(&soft).map(|_| ()).unwrap_err().to_string();
    assert!(refused.contains("make them stiffer"), "{refused}");
}
