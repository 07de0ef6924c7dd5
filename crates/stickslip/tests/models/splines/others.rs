//! Splines in cut-outs and in meshes from files, and what is refused.

use std::f64::consts::{PI, TAU};
use std::fs;
use std::path::Path;

use stickslip::model::Model;
use stickslip::results::Results;
use stickslip::scene::shape::FileNote;
use stickslip_fem_core::mesh::Mesh;
use tempfile::TempDir;

use super::{close, edge, nose, place, points, pressed, spline};
use crate::{refusal, results, scene, scene_in, solved};

/// The strip of 40 mm with a circle of radius 10 mm cut out of it as splines of these names, each through three points between its ends, under 100 MPa of tension.
fn pulled(names: &[&str], reported: &[&str]) -> Results {
    let count = names.len();
    let at = |turn: f64| {
        let (sin, cos) = (TAU * turn / count as f64).sin_cos();
        place([10.0 * cos, 10.0 * sin])
    };
    let edges = names.iter().enumerate().map(|(k, name)| {
        let from = k as f64;
        let to = if k + 1 < count { format!("to = {}, ", at(from + 1.0)) } else { String::new() };
        let inner: Vec<String> = (1..8).map(|part| at(from + f64::from(part) / 8.0)).collect();
        let [leaves, arrives] = [from, from + 1.0].map(|own| 90.0 + 360.0 * own / count as f64);
        format!(
            r#"{{ name = "{name}", {to}spline = [{}], leaves = "{leaves} deg", arrives = "{arrives} deg", refine = 16 }}"#,
            inner.join(", ")
        )
    });
    let edges: Vec<String> = edges.collect();
    let reported: Vec<String> = (reported.iter())
        .map(|on| format!("[[edges]]\non = \"plate.{on}\"\n"))
        .collect();
    let reported = reported.concat();
    solved(
        &format!(
            r#"
version = 1
materials.metal.isotropic = {{ young = "70 GPa", poisson = 0.33 }}
[bodies.plate]
material = "metal"
thickness = "1 mm"
mesh.spacing = "4 mm"
[bodies.plate.shape.outline]
start = ["-120 mm", "-20 mm"]
edges = [{{ name = "bottom", to = ["120 mm", "-20 mm"] }}, {{ name = "right", to = ["120 mm", "20 mm"] }}, {{ name = "top", to = ["-120 mm", "20 mm"] }}, {{ name = "left" }}]
cutouts.round = {{ start = {}, edges = [{}] }}
[[supports]]
on = "plate.left"
fix = ["x", "y"]
[[loads]]
on = "plate.right"
pressure.steps = ["-100 MPa"]
{reported}[output]
fields = "none"
figures = false
"#,
            at(0.0),
            edges.join(", ")
        ),
        &[],
    )
}

/// Howland's problem of an infinitely long strip, solved to 6 digits, with results over the length of splines of 60°, of which the second and the fifth lie across the tension.
#[test]
fn a_circle_of_splines_concentrates_stresses_as_a_hole_does() {
    let results = pulled(&["a", "b", "c", "d", "e", "f"], &["b", "e"]);
    for edge in &results.steps[0].edges {
        let (peak, at) = edge.peak_hoop.unwrap();
        close(peak / 100.0, 4.347_60, 1e-3);
        assert!(at.abs() < 0.3, "{at}");
    }
    for edge in &results.edges {
        let half = 10.0 * PI / 6.0;
        close(edge.parameter[0], -half, 1e-6);
        close(edge.parameter[edge.parameter.len() - 1], half, 1e-6);
    }
}

#[test]
fn what_makes_no_spline_is_refused_with_its_line() {
    let text = nose(["spline", "spline"], |at| at, false, "");
    let refusal = |text: &str, change: &str| {
        let changes = [format!("bodies.nose.shape.outline.edges.1.{change}")];
        refusal(Path::new(""), text, &changes.each_ref().map(String::as_str))
    };
    for (change, messages) in [
        (
            "spline=[]",
            ["has no point between its ends", "remove `spline`"],
        ),
        (
            r#"spline=[["1 mm", "0 mm"], ["1 mm", "0 mm"]]"#,
            [
                "passes (1.000000, 0.000000) twice in a row",
                "remove one of the two points",
            ],
        ),
        (
            r#"spline=[["1 mm", "0 mm"], ["1.01 mm", "0 mm"], ["0.99 mm", "0.01 mm"], ["3 mm", "0 mm"]]"#,
            ["turns with a radius of", "give more points there"],
        ),
        (
            r#"spline=[["4 mm", "-1 mm"], ["0 mm", "-2 mm"], ["0 mm", "0 mm"], ["3 mm", "-2 mm"]]"#,
            ["meets itself near", "change its points"],
        ),
        (
            r#"spline=[["0 mm", "8 mm"]]"#,
            ["meet near", "change the edges"],
        ),
        (
            r#"spline=["0 mm", "0 mm"]"#,
            ["expected a list of 2 values", "give a list"],
        ),
    ] {
        let message = refusal(&text, change);
        for expected in messages {
            assert!(message.contains(expected), "{change}: {message}");
        }
    }
    let arcs = nose(["arc", "arc"], |at| at, false, "");
    let both = text.replacen("spline = [", r#"through = ["0 mm", "9 mm"], spline = ["#, 1);
    let message = refusal(&both, "refine=6");
    assert!(
        message.contains("through") && message.contains("both"),
        "{message}"
    );
    let message = refusal(&arcs, r#"leaves="10 deg""#);
    assert!(message.contains("`leaves` is for splines"), "{message}");
}

#[test]
fn gaps_on_the_deformed_geometry_are_refused_as_of_arcs() {
    let message = |way: [&str; 2]| {
        let text = nose(way, |at| at, false, "");
        Model::build(&scene(&text, &["analysis.kinematics=deformed-gaps"]))
            .unwrap_err()
            .to_string()
    };
    assert!(message(["spline", "spline"]).contains("deformed-gaps"));
    assert_eq!(message(["spline", "spline"]), message(["arc", "arc"]));
}

/// The mesh with the mid nodes of the edge `name` on its chords, and coordinates as a file of seven decimals has them.
fn rounded(mesh: &Mesh, name: &str) -> Mesh {
    let path = mesh.edge_path(name).unwrap();
    let mut parts = mesh.clone().into_parts();
    if path.order == 2 {
        for cell in path.nodes.windows(3).step_by(2) {
            let [a, b] = [cell[0], cell[2]].map(|node| parts.nodes[node]);
            parts.nodes[cell[1]] = [0, 1].map(|axis| f64::midpoint(a[axis], b[axis]));
        }
    }
    for node in &mut parts.nodes {
        *node = node.map(|x| (x * 1e7).round() / 1e7);
    }
    Mesh::new(parts).unwrap()
}

/// A punch of a parabola as a file: its face is a spline through its nodes where the scene says so.
#[test]
fn an_edge_of_a_file_is_a_spline_where_it_is_said() {
    let parabola = |part: f64| [10.0 * part, 2.5 * part * part];
    let way = spline(&points(9, parabola));
    let text = pressed(&way, [parabola(-1.0), parabola(1.0)], 1500.0, (40.0, 2.0));
    let start = text.rfind("shape.outline").unwrap();
    let end = start + text[start..].find("\n[mesh]").unwrap();
    let given = |splines: &str| {
        let file = format!("shape.mesh = {{ file = \"roller.msh\", unit = \"mm\"{splines} }}");
        format!("{}{file}{}", &text[..start], &text[end..])
    };
    let folder = TempDir::new().unwrap();
    for element in ["T6", "T3"] {
        let changes = [format!("mesh.element={element}")];
        let changes = changes.each_ref().map(String::as_str);
        let own = solved(&text, &changes);
        let body = own
            .bodies
            .iter()
            .find(|body| body.name == "roller")
            .unwrap();
        let mesh = body.mesh.as_deref().unwrap();
        for (mesh, near) in [(mesh.clone(), 1e-4), (rounded(mesh, "face"), 2e-3)] {
            let written = stickslip_mesh_files::write_msh(&mesh).unwrap();
            fs::write(folder.path().join("roller.msh"), written).unwrap();
            let text = given(", splines = [\"face\"]");
            let found = results(&scene_in(folder.path(), &text, &changes));
            let [a, b] = [&found, &own].map(edge);
            close(a.peak_pressure.unwrap().0, b.peak_pressure.unwrap().0, near);
            close(
                a.contact_half_extent.unwrap(),
                b.contact_half_extent.unwrap(),
                near,
            );
        }
    }
    let known = scene_in(
        folder.path(),
        &given(", splines = [\"top\", \"face\"]"),
        &[],
    );
    let notes = known.bodies["roller"].shape.notes();
    let edge = String::from("top");
    assert_eq!(notes[0], FileNote::NoSpline { edge });
    let message = refusal(folder.path(), &given(", splines = [\"crown\"]"), &[]);
    assert!(message.contains("it has no edge 'crown'"), "{message}");
}
