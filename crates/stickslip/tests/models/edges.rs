//! Stresses along edges on which contact, loads and supports act together.

use std::f64::consts::PI;

use stickslip::results::{EdgeRow, Results};

use super::{difference, model, solved, upper};
use crate::halves::ROLLER;

/// A ring that is held at its outer edge, under pressure in its hole.
const RING: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.3
[bodies.ring]
material = "metal"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "5 mm", outline.ring.radius = "20 mm" }
[mesh]
spacing = "3 deg"
[[supports]]
on = "ring.outer"
fix = ["x", "y"]
[[loads]]
on = "ring.hole"
pressure.steps = ["100 MPa", "0 MPa"]
[[edges]]
on = "ring.hole"
[[edges]]
on = "ring.outer"
[output]
fields = "none"
figures = false
"#;

/// A pin that is pressed towards +x in its hole.
const PIN: [&str; 2] = [
    r#"
[bodies.pin]
material = "metal"
thickness = "2 mm"
shape.disk = { radius = "4.95 mm" }
[[contacts]]
first = "ring.hole"
second = "pin.rim"
friction.coulomb.mu = 0.2
"#,
    r#"
[[loads]]
on = "pin.rim"
force = { direction = [1, 0], steps = ["2 kN", "2 kN"] }
"#,
];

fn ring_with_pin() -> String {
    let text = format!("{RING}{}{}", PIN[0], PIN[1]);
    text.replacen("[[edges]]\non = \"ring.hole\"\n", "", 1)
}

/// Sum of a traction over an edge `[N]`.
fn total(areas: &[f64], rows: &[EdgeRow], of: fn(&EdgeRow) -> f64) -> f64 {
    let shares = areas.iter().zip(rows).map(|(area, row)| area * of(row));
    shares.sum()
}

/// σ_xx + σ_yy of the fields at the nodes of edge `edge`, which no turn of the axes changes.
fn trace_of_field(results: &Results, step: usize, body: usize, nodes: &[usize]) -> Vec<f64> {
    let fields = &results.steps[step].fields;
    let own = fields.iter().find(|fields| fields.body == body).unwrap();
    let at = |&node: &usize| own.stress[node][0] + own.stress[node][1];
    nodes.iter().map(at).collect()
}

#[test]
fn a_held_edge_carries_the_reaction_of_lame() {
    let results = solved(RING, &[]);
    let (nu, inner, outer, pressure) = (0.3, 5.0_f64, 20.0_f64, 100.0);
    // u = A (r − b²/r) vanishes at b; σ_r = E/(1 − ν²) (u′ + ν u/r) in plane stress.
    let shape = |r: f64| [1.0 + (outer / r).powi(2), 1.0 - (outer / r).powi(2)];
    let stress = |[along, across]: [f64; 2]| along + nu * across;
    let factor = -pressure / stress(shape(inner));
    let expected = factor * stress(shape(outer));
    let rows = &results.steps[0].edges[1].rows;
    for row in rows {
        assert!((row.sigma_normal / expected - 1.0).abs() < 3e-4, "{row:?}");
        assert!((row.sigma_tangential / (nu * row.sigma_normal) - 1.0).abs() < 1e-9);
        assert!(row.tau.abs() < 1e-9 * pressure && row.pressure == -row.sigma_normal);
    }
    let hoop = factor * (shape(inner)[1] + nu * shape(inner)[0]);
    for row in &results.steps[0].edges[0].rows {
        assert_eq!(row.sigma_normal, -pressure);
        assert!((row.sigma_tangential / hoop - 1.0).abs() < 1e-3, "{row:?}");
    }
    let unloaded = results.steps[1].edges.iter().flat_map(|edge| &edge.rows);
    assert!(unloaded.into_iter().all(|row| row.sigma_normal == 0.0));
}

/// A plate that cannot expand between its supports, which share corners, and on a slope.
const CLAMPED: &str = r#"
version = 1
[materials.metal.isotropic]
young = "210 GPa"
poisson = 0.3
expansion = "12e-6 1/K"
[bodies.block]
material = "metal"
thickness = "2 mm"
shape.rectangle = { width = "10 mm", height = "10 mm" }
[mesh]
spacing = "2.5 mm"
[[supports]]
on = "block.left"
fix = ["x"]
[[supports]]
on = "block.right"
fix = ["x"]
[[supports]]
on = "block.bottom"
fix = ["x", "y"]
[[loads]]
on = "block"
temperature.steps = ["100 K"]
[[edges]]
on = "block.bottom"
[[edges]]
on = "block.left"
[output]
fields = "none"
"#;

/// Uniform stress is found on edges up to the corners that supports share, of which each counts its own part.
#[test]
fn corners_of_two_supports_carry_what_is_beside_them() {
    let expected = -210e3 * 12e-6 * 100.0;
    // The last two have two cells along each edge.
    for (element, spacing) in [("Q4", 2.5), ("Q8", 2.5), ("Q4", 5.0), ("Q8", 5.0)] {
        let changes = [
            format!("mesh.element={element}"),
            format!("mesh.spacing={spacing} mm"),
        ];
        let results = solved(CLAMPED, &changes.each_ref().map(String::as_str));
        for (edge, [normal, along]) in [(0, [0.0, expected]), (1, [expected, 0.0])] {
            for row in &results.steps[0].edges[edge].rows {
                for (found, expected) in [
                    (row.sigma_normal, normal),
                    (row.sigma_tangential, along),
                    (row.tau, 0.0),
                ] {
                    assert!((found - expected).abs() < 1e-8, "{element} {edge}: {row:?}");
                }
            }
        }
    }
}

/// Corners are shared where both supports hold in one direction: rollers across each other, as of a quarter, are not.
#[test]
fn rollers_across_each_other_share_nothing() {
    let ends = |text: &str| {
        model(text, &[""; 0])
            .edges
            .iter()
            .map(|edge| edge.shared_ends)
            .collect::<Vec<_>>()
    };
    assert_eq!(ends(CLAMPED)[0], [true; 2]);
    let rollers = CLAMPED.replace("fix = [\"x\", \"y\"]", "fix = [\"y\"]");
    assert_eq!(ends(&rollers), [[false; 2]; 2]);
}

/// Where every edge is held, a temperature loads held nodes alone, and balance is that of the reactions.
#[test]
fn a_body_held_all_around_balances() {
    let held = CLAMPED.replace("fix = [\"x\"]", "fix = [\"x\", \"y\"]")
        + "[[supports]]\non = \"block.top\"\nfix = [\"x\", \"y\"]\n";
    let results = solved(&held, &[]);
    assert_eq!(results.findings, []);
    assert!(results.steps[0].balance_residual < 1e-12);
}

/// A wedge between a floor and a slope of 30°, on rollers that share a corner: the reactions are those of statics.
#[test]
fn supports_that_share_a_corner_balance_the_loads() {
    let text = r#"
version = 1
[materials.metal.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.wedge]
material = "metal"
thickness = "2 mm"
[bodies.wedge.shape.outline]
start = ["0 mm", "0 mm"]
edges = [
  { name = "floor", to = ["40 mm", "0 mm"] },
  { name = "slope", to = ["23.0940107676 mm", "29.2820323028 mm"] },
  { name = "top", to = ["0 mm", "29.2820323028 mm"] },
  { name = "left" },
]
[mesh]
spacing = "5 mm"
[[supports]]
on = "wedge.floor"
fix = ["y"]
[[supports]]
on = "wedge.slope"
normal = "30 deg"
[[loads]]
on = "wedge.left"
force = { direction = [1, 0], steps = ["1 kN"] }
[output]
fields = "none"
"#;
    let results = solved(text, &[]);
    let reaction = |on: &str| {
        let held = results.sets.iter().position(|set| set.on == on).unwrap();
        results.steps[0].sets[held].unwrap().force
    };
    let (sin, cos) = (PI / 6.0).sin_cos();
    let slope = -1000.0 / cos;
    assert!((reaction("wedge.slope") / slope - 1.0).abs() < 1e-9);
    assert!((reaction("wedge.floor") + slope * sin).abs() < 1e-6);
}

#[test]
fn loads_on_an_edge_in_contact_count_in_its_stresses() {
    let changes = [
        "loads.0.pressure.steps=[\"0 MPa\", \"100 MPa\"]",
        "mesh.spacing=\"1.5 deg\"",
        "output.fields=\"last\"",
    ];
    let text = ring_with_pin();
    let (loaded, results) = (model(&text, &changes), solved(&text, &changes));
    let edge = &results.steps[1].edges[0];
    assert!(edge.rows.iter().any(|row| row.pressure == 0.0));
    for row in &edge.rows {
        assert!((row.sigma_normal + row.pressure + 100.0).abs() < 1e-9);
    }
    let nodes = &loaded.edges[0].nodes;
    let field = trace_of_field(&results, 1, loaded.edges[0].geometry.body, nodes);
    let traces = edge
        .rows
        .iter()
        .map(|row| row.sigma_normal + row.sigma_tangential);
    // Fields are smooth over patches, tractions have a kink where contact ends.
    let end = edge
        .rows
        .iter()
        .rposition(|row| row.pressure > 0.0)
        .unwrap();
    let compared = (0..nodes.len()).filter(|k| k.abs_diff(end) > 6);
    let pairs: Vec<(f64, f64)> = field.into_iter().zip(traces).collect();
    let (field, traces): (Vec<f64>, Vec<f64>) = compared.map(|k| pairs[k]).unzip();
    let apart = difference(field, traces);
    assert!(apart < 0.02, "{apart}");
}

#[test]
fn a_held_circle_balances_the_pin() {
    for kind in ["half", "whole"] {
        let kind_of = format!("analysis.model=\"{kind}\"");
        let (text, changes) = (ring_with_pin(), [kind_of.as_str()]);
        let (model, results) = (model(&text, &changes), solved(&text, &changes));
        for step in &results.steps {
            let (edge, normals) = (&model.edges[1], &model.edges[1].normals);
            let along = edge.areas.iter().zip(normals).zip(&step.edges[1].rows);
            let force: f64 = along
                .map(|((area, [x, y]), row)| area * (x * row.sigma_normal - y * row.tau))
                .sum();
            let whole = if model.half { 2.0 * force } else { force };
            assert!((whole + 2e3).abs() < 1e-6, "{kind}: {whole}");
        }
    }
}

#[test]
fn block_and_platen_balance_the_roller_by_half_and_whole() {
    let edges = "edges=[{ on = \"block.bottom\" }, { on = \"roller.top\" }]";
    let [half, whole] = ["half", "whole"].map(|kind| {
        let changes = [edges, &format!("analysis.model=\"{kind}\"")];
        (model(ROLLER, &changes), solved(ROLLER, &changes))
    });
    for (step, force) in [300.0, 600.0, 200.0].into_iter().enumerate() {
        for edge in [1, 2] {
            for ((model, results), share) in [&half, &whole].into_iter().zip([0.5, 1.0]) {
                let rows = &results.steps[step].edges[edge].rows;
                let sum = total(&model.edges[edge].areas, rows, |row| row.sigma_normal);
                assert!((sum + share * force).abs() < 1e-6, "{sum}");
            }
            let [one, other] = [&half, &whole].map(|of| upper(&of.1, step, edge));
            for of in [
                |row: &EdgeRow| row.sigma_normal,
                |row: &EdgeRow| row.sigma_tangential,
                |row: &EdgeRow| row.tau,
            ] {
                let apart = difference(one.iter().map(of), other.iter().map(of));
                assert!(apart < 1e-6, "{apart} on edge {edge}");
            }
        }
    }
}

#[test]
fn a_roller_support_takes_no_shear() {
    let changes = [
        "supports.0.fix=[\"y\"]",
        "edges=[{ on = \"block.bottom\" }]",
    ];
    let rows = &solved(ROLLER, &changes).steps[1].edges[1].rows;
    assert!(rows.iter().all(|row| row.tau == 0.0));
}

#[test]
fn stresses_along_an_arc_are_those_of_the_body() {
    let changes = [
        "output.fields=\"all\"",
        "bodies.roller.shape.cylinder.radius=\"20 mm\"",
    ];
    let (model, results) = (model(ROLLER, &changes), solved(ROLLER, &changes));
    let (edge, rows) = (&model.edges[0], &results.steps[1].edges[0].rows);
    let field = trace_of_field(&results, 1, edge.geometry.body, &edge.nodes);
    // Fields are smooth over patches, tractions have a kink where contact ends.
    let free = rows
        .iter()
        .zip(field)
        .filter(|(row, _)| (0.1..3.0).contains(&row.gap));
    let (traces, field): (Vec<f64>, Vec<f64>) = free
        .map(|(row, field)| (row.sigma_tangential, field))
        .unzip();
    let apart = difference(field, traces);
    assert!(apart < 0.02, "{apart}");
}

/// The two flanks of a blade's root in a slot: each is the mirror image of the other, and where nothing touches the stress along it is that of the fields,
/// also along the corners, which turn away from what they touch.
#[test]
fn stresses_along_a_flank_are_those_of_its_own_curve() {
    let text = include_str!("../../../../scenes/dovetail.toml");
    let changes = [
        "mesh.spacing=4 mm",
        "loads.0.force.steps=[\"100 N\"]",
        "output.fields=\"last\"",
    ];
    let (loaded, results) = (model(text, &changes), solved(text, &changes));
    let [right, left] = [0, 1].map(|edge| &results.steps[0].edges[edge].rows);
    let most = right.iter().map(|row| row.pressure).fold(0.0, f64::max);
    assert_eq!(right.len(), left.len());
    for (one, other) in right.iter().zip(left.iter().rev()) {
        let apart = (one.sigma_tangential - other.sigma_tangential).abs();
        assert!(apart < 1e-6 * most, "{one:?} {other:?}");
    }
    let edge = &loaded.edges[0];
    let field = trace_of_field(&results, 0, edge.geometry.body, &edge.nodes);
    let largest = right
        .iter()
        .filter(|row| row.pressure == 0.0)
        .map(|row| row.sigma_tangential.abs())
        .fold(0.0, f64::max);
    // Beside the end of contact fields are smooth where stresses are not.
    let last = right.iter().rposition(|row| row.pressure > 0.0).unwrap();
    for (row, field) in right.iter().zip(field).skip(last + 12) {
        let apart = (row.sigma_tangential - field).abs();
        assert!(apart < 0.05 * largest, "{row:?}: {field}");
    }
}
