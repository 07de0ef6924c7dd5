//! Places where stress has no limit, or no value, and what hangs on single points.

use stickslip::results::{Finding, LadderEnd, Results, SetStated, Stated};

use super::solved;

/// A block of 40 × 10 mm that holes, supports and loads are added to.
const BLOCK: &str = r#"
version = 1
[materials.steel.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.block]
material = "steel"
thickness = "3 mm"
[bodies.block.shape.outline]
start = ["0 mm", "0 mm"]
edges = [{ name = "bottom", to = ["40 mm", "0 mm"] }, { name = "right", to = ["40 mm", "10 mm"] }, { name = "top", to = ["0 mm", "10 mm"] }, { name = "left" }]
points.a = ["0 mm", "0 mm"]
points.b = ["40 mm", "0 mm"]
points.c = ["40 mm", "10 mm"]
[output]
fields = "none"
figures = false
"#;

fn found(more: &str, changes: &[&str]) -> Results {
    solved(&(BLOCK.to_owned() + more), changes)
}

/// The largest stress along the edge with this index, and its error.
fn peak(results: &Results, edge: usize) -> (f64, Option<f64>) {
    let own = &results.steps[0].edges[edge];
    let peak = Stated::PeakHoop.value(own).unwrap();
    (peak, own.errors.get(Stated::PeakHoop))
}

fn is_said(results: &Results, is_one: impl Fn(&Finding) -> bool) -> bool {
    results.findings.iter().any(is_one)
}

/// A block on springs is pushed along its top. Along its free sides stress tends to π τ/2 towards the corner, with τ = 10 MPa, and along the top to its negative; the node there has neither.
#[test]
fn where_a_load_along_an_edge_ends_stress_has_no_error() {
    let sheared = r#"
[[supports]]
on = "block.bottom"
fix = ["x", "y"]
bed = "500 MPa/mm"
[[loads]]
on = "block.top"
force = { direction = [1, 0], steps = ["1.2 kN"] }
[[edges]]
on = "block.left"
[[edges]]
on = "block.right"
[[edges]]
on = "block.top"
"#;
    let results = found(sheared, &["analysis.accuracy=1 %"]);
    let (left, error) = peak(&results, 0);
    assert!(
        (left - 0.5 * std::f64::consts::PI * 10.0).abs() < 0.4,
        "{left}"
    );
    assert_eq!(error, None);
    assert_eq!(peak(&results, 1).1, None);
    // In the middle of a side, and along the top far from its ends, nothing is singular.
    let sides = &results.steps[0].edges;
    assert!(sides[0].errors.get(Stated::HoopAtBearing).is_some());
    let (top, error) = peak(&results, 2);
    let edges = r#"{ name = "top", refine = 4"#;
    let fine = BLOCK.replace(r#"{ name = "top""#, edges) + sheared;
    let fine = solved(&fine, &["mesh.spacing=0.2 mm"]);
    assert!(
        (top - peak(&fine, 2).0).abs() <= error.unwrap(),
        "{top} {error:?}"
    );
    // x = 0 is the corner.
    assert_eq!(sides[2].errors.get(Stated::HoopAtBearing), None);
    for edge in ["block.left", "block.right", "block.top"] {
        let is_one = |own: &Finding| matches!(own, Finding::NoValueAtLoadEnd { edge: own, .. } if own == edge);
        assert!(is_said(&results, is_one), "{:?}", results.findings);
    }
    // With nothing else to be accurate about nothing is reached.
    let one = ["analysis.accuracy=5 %", r#"edges=[{ on = "block.left" }]"#];
    let alone = found(sheared, &one);
    assert_eq!(alone.ladder.as_ref().unwrap().end, LadderEnd::Unstated);
    let is_peak = |own: &Finding| matches!(own, Finding::AccuracyUnstated { numbers } if numbers[..] == ["peak tangential stress"]);
    assert!(is_said(&alone, is_peak), "{:?}", alone.findings);
    // In a step without the load nothing is singular.
    let unloaded = r#"loads.1={ on = "block.left", pressure.steps = ["2 MPa", "1 MPa"] }"#;
    let steps = [
        "analysis.accuracy=5 %",
        r#"loads.0.force.steps=["0 kN", "1.2 kN"]"#,
        unloaded,
    ];
    let bed = sheared.replace(r#"fix = ["x", "y"]"#, r#"fix = ["y"]"#)
        + "[[supports]]\non = \"block.a\"\nfix = [\"x\"]\n";
    let results = found(&bed, &steps);
    let edges = results.steps.iter().map(|step| &step.edges[1].errors);
    let has_error: Vec<bool> = edges
        .map(|own| own.get(Stated::PeakHoop).is_some())
        .collect();
    assert_eq!(has_error, [true, false]);
    // At the corner itself, where x = 0 is along the top.
    let at_corner = results.steps.iter().map(|step| &step.edges[2].errors);
    let has_error: Vec<bool> = at_corner
        .map(|own| own.get(Stated::HoopAtBearing).is_some())
        .collect();
    assert_eq!(has_error, [true, false]);
    // Across the edge the same load ends without harm.
    let pressed = [
        "analysis.accuracy=1 %",
        "loads.0.force.direction=[0, -1]",
        "supports.0.fix=[\"y\"]",
        "supports.1={ on = \"block.a\", fix = [\"x\"] }",
    ];
    let results = found(sheared, &pressed);
    let is_any = |own: &Finding| matches!(own, Finding::NoValueAtLoadEnd { .. });
    assert!(!is_said(&results, is_any), "{:?}", results.findings);
}

/// Stresses that are rounding beside others decide nothing: pure shear, and uniform tension against a roller.
#[test]
fn rounding_is_neither_missed_nor_singular() {
    let roller = r#"
[[supports]]
on = "block.left"
fix = ["x"]
[[supports]]
on = "block.a"
fix = ["y"]
[[loads]]
on = "block.right"
pressure.steps = ["-50 MPa"]
[[edges]]
on = "block.left"
[[edges]]
on = "block.right"
"#;
    let results = found(roller, &["analysis.accuracy=1 %"]);
    let ladder = results.ladder.as_ref().unwrap();
    assert!(
        [LadderEnd::Reached, LadderEnd::Unstated].contains(&ladder.end),
        "{ladder:?}"
    );
    assert!(results.findings.is_empty(), "{:?}", results.findings);
}

/// In pure shear stress along the sides is rounding beside that across them, also at corners, where loads end.
#[test]
fn pure_shear_has_no_peak_along_its_sides() {
    let mut sheared = String::from(
        r#"
[[supports]]
on = "block.a"
fix = ["x", "y"]
[[supports]]
on = "block.b"
fix = ["y"]
"#,
    );
    let along = [("top", [1, 0], 1.2), ("bottom", [-1, 0], 1.2)];
    let across = [("right", [0, 1], 0.3), ("left", [0, -1], 0.3)];
    for (side, [x, y], force) in along.into_iter().chain(across) {
        let own = format!(
            r#"
[[loads]]
on = "block.{side}"
force = {{ direction = [{x}, {y}], steps = ["{force} kN"] }}
[[edges]]
on = "block.{side}"
"#
        );
        sheared.push_str(&own);
    }
    let results = found(&sheared, &["analysis.accuracy=1 %"]);
    assert!(results.findings.is_empty(), "{:?}", results.findings);
    for edge in 0..4 {
        assert!(
            peak(&results, edge).0.abs() < 1e-9,
            "{:?}",
            peak(&results, edge)
        );
        assert!(peak(&results, edge).1.is_some(), "{edge}");
    }
    // γ = τ/G over the height, and nothing else moves.
    let moved = |set: usize| results.set_numbers(set, 0);
    let top = moved(0).get(SetStated::Displacement).unwrap();
    assert!(
        (top / (10.0 * 10.0 * 2.6 / 210e3) - 1.0).abs() < 1e-9,
        "{top}"
    );
    for set in 1..4 {
        assert_eq!(moved(set).get(SetStated::Displacement), Some(0.0));
        assert_eq!(moved(set).get(SetStated::Secant), None);
    }
}

/// A spring that is much stiffer than its body carries its load by a displacement that is rounding beside others.
#[test]
fn stiff_springs_carry_their_load() {
    let stiff = r#"
[[supports]]
on = "block.left"
normal = "0 deg"
stiffness = "1e18 N/mm"
[[supports]]
on = "block.a"
fix = ["y"]
[[loads]]
on = "block.right"
force = { direction = [1, 0], steps = ["100 N"] }
"#;
    let results = found(stiff, &["mesh.spacing=\"2.5 mm\""]);
    let sets = 0..results.steps[0].sets.len();
    let forces = sets.filter_map(|set| results.set_numbers(set, 0).get(SetStated::Force));
    let forces: Vec<f64> = forces.collect();
    let is_carried = |force: &&f64| (force.abs() - 100.0).abs() < 1.0;
    assert_eq!(forces.iter().filter(is_carried).count(), 2, "{forces:?}");
}

/// A pressure on a part of a side jumps there, and so does the stress along it.
#[test]
fn where_a_pressure_ends_within_an_edge_stress_has_no_error() {
    let split = BLOCK.replace(
        r#"{ name = "top", to = ["0 mm", "10 mm"] }"#,
        r#"{ name = "rest", to = ["15 mm", "10 mm"] }, { name = "top", to = ["0 mm", "10 mm"] }"#,
    );
    assert_ne!(split, BLOCK);
    let pressed = r#"
[[supports]]
on = "block.right"
fix = ["x", "y"]
[[loads]]
on = "block.top"
pressure.steps = ["1 MPa"]
[[edges]]
on = "block.top"
[[edges]]
on = "block.left"
"#;
    let results = solved(&(split + pressed), &["analysis.accuracy=1 %"]);
    let place = results.steps[0].edges[0].peak_hoop.unwrap().1;
    assert!((place - 15.0).abs() < 1.0, "{place}");
    assert_eq!(peak(&results, 0).1, None);
    let is_one = |own: &Finding| matches!(own, Finding::NoValueAtLoadEnd { edge, .. } if edge == "block.top");
    assert!(is_said(&results, is_one), "{:?}", results.findings);
    let is_other = |own: &Finding| matches!(own, Finding::NoValueAtLoadEnd { edge, .. } if edge == "block.left");
    assert!(!is_said(&results, is_other), "{:?}", results.findings);
}

/// Beside a hole near the edge stress is the largest of coarse cells; of fine ones it is at the end of the clamp.
#[test]
fn a_peak_that_the_end_of_a_support_will_exceed_has_no_error() {
    let pulled = r#"
[bodies.block.shape.outline.holes.eye]
centre = ["20 mm", "6.5 mm"]
radius = "2 mm"
[[supports]]
on = "block.left"
fix = ["x", "y"]
[[loads]]
on = "block.right"
pressure.steps = ["-10 MPa"]
[[edges]]
on = "block.top"
[[edges]]
on = "block.eye"
"#;
    let results = found(pulled, &["analysis.accuracy=1 %"]);
    let (top, error) = peak(&results, 0);
    assert_eq!(error, None);
    let is_one = |own: &Finding| matches!(own, Finding::NoLimitAtSupport { edge, .. } if edge == "block.top");
    assert!(is_said(&results, is_one), "{:?}", results.findings);
    assert!(peak(&results, 1).1.is_some_and(|error| error < 0.5));
    // Above the hole; cells of a few micrometres have it at the clamp.
    let place = results.steps[0].edges[0].peak_hoop.unwrap().1;
    assert!((10.0..30.0).contains(&place), "{place}");
    let split = r#"{ name = "far", to = ["1 mm", "10 mm"] }, { name = "top", refine = 100, to"#;
    let fine = BLOCK.replace(r#"{ name = "top", to"#, split);
    let fine = solved(&(fine + pulled), &["mesh.spacing=6 deg"]);
    assert!(peak(&fine, 0).0 > 1.05 * top, "{} {top}", peak(&fine, 0).0);
}

/// Three forces that equilibrium gives do not depend on how far a point gives way, a fourth does, and displacements under a load do in both.
#[test]
fn points_share_a_load_where_equilibrium_leaves_it_open() {
    let held = r#"
[[supports]]
on = "block.a"
fix = ["x", "y"]
[[supports]]
on = "block.b"
fix = ["y"]
[[loads]]
on = "block.top"
pressure.steps = ["3 MPa"]
"#;
    let accuracy = "analysis.accuracy=5 %";
    let shares = |own: &Finding| matches!(own, Finding::PointSupports { .. });
    let hangs = |own: &Finding| matches!(own, Finding::PointDisplacements { .. });
    let reaction = |results: &Results| results.set_errors(1, 0).get(SetStated::Force);
    let three = found(held, &[accuracy]);
    assert!(
        !is_said(&three, shares) && is_said(&three, hangs),
        "{:?}",
        three.findings
    );
    assert!(reaction(&three).is_some());
    let fourth = "supports.2={ on = \"block.c\", fix = [\"x\"] }";
    let four = found(held, &[accuracy, fourth]);
    assert!(
        is_said(&four, shares) && is_said(&four, hangs),
        "{:?}",
        four.findings
    );
    assert_eq!(reaction(&four), None);
    // Points that take no force hold nothing.
    let balanced = "loads=[{ on = \"block.right\", pressure.steps = [\"-10 MPa\"] }, { on = \"block.left\", pressure.steps = [\"-10 MPa\"] }]";
    let none = found(held, &[accuracy, balanced]);
    assert!(
        !is_said(&none, shares) && !is_said(&none, hangs),
        "{:?}",
        none.findings
    );
}
