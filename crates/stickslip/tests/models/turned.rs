//! Bodies that the scene turns: their meshes, and those of the round bodies that touch them, turn with them; what has a direction of its own does not.

use std::fs;

use stickslip::model::Model;
use stickslip::results::{ContactFinding, Finding};
use stickslip_fem_core::material::PlaneState;
use tempfile::TempDir;

use super::{model, scene_in, solved};

/// A tapered lug on a pin with clearance and friction, drawn along x.
const LUG: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.lug]
material = "metal"
thickness = "2 mm"
[bodies.lug.shape.outline]
start = ["-40 mm", "-16 mm"]
edges = [
  { name = "lower", to = ["0 mm", "-12 mm"] },
  { name = "end", through = ["12 mm", "0 mm"], to = ["0 mm", "12 mm"] },
  { name = "upper", to = ["-40 mm", "16 mm"] },
  { name = "root" },
]
holes.bolt = { centre = ["0 mm", "1 mm"], radius = "5 mm" }
[bodies.pin]
material = "metal"
thickness = "2 mm"
shape.disk.radius = "4.95 mm"
[mesh]
spacing = "5 deg"
[[contacts]]
first = "lug.bolt"
second = "pin.rim"
friction.coulomb = { mu = 0.3 }
[[supports]]
on = "lug.root"
fix = ["x", "y"]
[[loads]]
on = "pin.section"
force = { direction = [1, 0.2], steps = ["2 kN", "4 kN", "1 kN"] }
[output]
fields = "none"
figures = false
"#;

/// Its triangles and the nodes of hole and pin turn with it.
#[test]
fn a_turned_lug_has_the_same_numbers() {
    let numbers = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let [x, y] = [cos - 0.2 * sin, sin + 0.2 * cos];
        let turned = [
            format!("bodies.lug.angle={degrees} deg"),
            format!("loads.0.force.direction=[{x:.17}, {y:.17}]"),
        ];
        let results = solved(LUG, &turned.each_ref().map(String::as_str));
        let steps = results.steps.iter().flat_map(|step| {
            let edge = &step.edges[0];
            let ends = [edge.contact_half_extent, edge.stick_half_extent];
            let peaks = [
                edge.peak_pressure.map(|peak| peak.0),
                edge.peak_hoop.map(|peak| peak.0),
            ];
            ends.into_iter().chain(peaks).flatten().collect::<Vec<_>>()
        });
        steps.collect::<Vec<f64>>()
    };
    let still = numbers(0.0);
    assert_eq!(still.len(), 12);
    // −85° brings a node of 5° to a full turn, but for rounding.
    for degrees in [30.0, 90.0, -61.0, -85.0] {
        for (own, other) in numbers(degrees).iter().zip(&still) {
            let apart = (own / other - 1.0).abs();
            assert!(apart < 1e-9, "{degrees}°: {own} {other}: {apart:.1e}");
        }
    }
}

/// The fine part of a mesh turns too, and so does the remark that contact ends beyond it.
#[test]
fn the_fine_part_of_a_mesh_turns() {
    for (degrees, direction) in [(0.0, "[1, 0]"), (90.0, "[0, 1]")] {
        let beyond = |fine: &str| {
            let changes = [
                format!("bodies.lug.angle={degrees} deg"),
                format!("loads.0.force.direction={direction}"),
                format!("mesh.fine_to={fine}"),
            ];
            let results = solved(LUG, &changes.each_ref().map(String::as_str));
            results.findings.iter().any(|finding| {
                matches!(
                    finding,
                    Finding::Contact {
                        finding: ContactFinding::BeyondFineMesh { .. },
                        ..
                    }
                )
            })
        };
        assert!(!beyond("100 deg") && beyond("40 deg"), "{degrees}");
    }
}

/// A bushing from a file may be turned in a hole; the strip around it is not, nor are its nodes.
#[test]
fn a_strip_around_a_turned_bushing_stays() {
    let text = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.plate]
material = "metal"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "5 mm", outline.strip = { half_width = "12 mm", left = "20 mm", right = "12 mm" } }
[bodies.bushing]
material = "metal"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "3 mm", outline.ring.radius = "5 mm" }
[bodies.pin]
material = "metal"
thickness = "2 mm"
shape.disk.radius = "3 mm"
[mesh]
spacing = "7.5 deg"
element = "Q4"
[[contacts]]
name = "outside"
first = "plate.hole"
second = "bushing.outer"
friction.coulomb = { mu = 0.3 }
[[contacts]]
name = "inside"
first = "bushing.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.3 }
[[supports]]
on = "pin.section"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["1 kN"] }
[output]
fields = "none"
"#;
    let whole = "analysis.model=whole";
    let mesh_of = |model: &Model, body: &str| {
        let own = model.bodies.iter().find(|own| own.name == body).unwrap();
        own.elastic().unwrap().mesh().clone()
    };
    let drawn = model(text, &[whole]);
    let folder = TempDir::new().unwrap();
    let file = stickslip_mesh_files::write_inp(&mesh_of(&drawn, "bushing"), PlaneState::Stress);
    fs::write(folder.path().join("bushing.inp"), file.unwrap()).unwrap();
    let shape =
        "shape.plate_with_hole = { hole_radius = \"3 mm\", outline.ring.radius = \"5 mm\" }";
    assert!(text.contains(shape));
    let own = |angle: &str, body: &str| {
        let read = format!(
            "shape.mesh = {{ file = \"bushing.inp\", unit = \"mm\" }}\nangle = \"{angle}\""
        );
        let scene = scene_in(folder.path(), &text.replace(shape, &read), &[whole]);
        mesh_of(&Model::build(&scene).unwrap(), body)
    };
    let [still, turned] = ["0 deg", "30 deg"];
    assert_ne!(
        own(still, "bushing").nodes(),
        own(turned, "bushing").nodes()
    );
    assert_eq!(own(still, "plate").nodes(), own(turned, "plate").nodes());
}
