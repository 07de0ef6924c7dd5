//! The same scene seen another way: half or whole, mirrored, turned, in other units, larger.

use stickslip::results::{EdgeResults, EdgeRow, Results};
use stickslip_tests::compare::{all_stresses, last_tractions, relative_difference, tractions};
use stickslip_tests::{Draft, draft::quantities};

/// The same numbers up to rounding, amplified by the condition of coarse bodies (about 1e4) and of contact near its ends.
const ROUNDING: f64 = 1e-8;

/// A ply whose 1-axis stands at `angle` degrees.
fn ply(angle: f64) -> String {
    format!(
        r#"{{ e1 = "140 GPa", e2 = "10 GPa", g12 = "5 GPa", nu12 = 0.3, angle = "{angle} deg" }}"#
    )
}

/// Rows of a whole edge by ascending −θ: what a mirror in the load axis shows. Node 0 of a whole edge is at −180°.
fn mirrored(edge: &EdgeResults) -> Vec<EdgeRow> {
    let rows = &edge.rows;
    (0..rows.len())
        .map(|k| {
            let row = rows[(rows.len() - k) % rows.len()];
            EdgeRow {
                shear: -row.shear,
                slip: -row.slip,
                tau: -row.tau,
                ..row
            }
        })
        .collect()
}

/// Pressures, shears, gaps and slips, the lengths as stresses of the scene's size (`stiffness` in MPa/mm).
fn numbers(rows: &[EdgeRow], stiffness: f64) -> Vec<f64> {
    rows.iter()
        .flat_map(|row| {
            [
                row.pressure,
                row.shear,
                stiffness * row.gap,
                stiffness * row.slip,
                row.sigma_tangential,
            ]
        })
        .collect()
}

/// Modulus over hole radius of the drafts `[MPa/mm]`.
const STIFFNESS: f64 = 70e3 / 5.0;

#[test]
fn half_and_whole_agree() {
    let law = "static_dynamic = { static = 0.3, dynamic = 0.2 }";
    let strip = r#"{ half_width = "15 mm", left = "50 mm", right = "40 mm" }"#;
    let drafts = [
        Draft::pin(),
        Draft::pin().set("mesh.element", "Q4").friction(law),
        Draft::pin()
            .set("mesh.element", "Q9")
            .set("bodies.plate.shape.plate_with_hole.outline.strip", strip),
        Draft::pin().set("materials.plate.orthotropic", ply(90.0)),
        Draft::pin()
            .set("mesh.fine_to", "100 deg")
            .set("mesh.coarse_spacing", "20 deg"),
        Draft::pin()
            .set("bodies.pin.shape.disk.radius", "5.002 mm")
            .set("contacts.0.interference", true),
    ];
    for draft in drafts {
        let draft = draft.forces(0, &[400.0, 1500.0, 3000.0, 900.0]);
        let half = draft.clone().set("analysis.model", "half").run();
        let whole = draft.clone().set("analysis.model", "whole").run();
        for (half_step, whole_step) in half.steps.iter().zip(&whole.steps) {
            let (half_edge, whole_edge) = (&half_step.edges[0], &whole_step.edges[0]);
            let count = half_edge.rows.len();
            // From 0 to 180°; the whole edge starts at −180° and does not repeat that node at its end.
            let upper: Vec<EdgeRow> = (0..count)
                .map(|k| whole_edge.rows[(count - 1 + k) % whole_edge.rows.len()])
                .collect();
            // Where the half model's points cannot slide, shear and slip are zero and not rounding.
            let difference = relative_difference(
                numbers(&half_edge.rows, STIFFNESS),
                numbers(&upper, STIFFNESS),
            );
            assert!(difference < ROUNDING, "{difference:e}:\n{draft:?}");
            let lower = relative_difference(
                numbers(&mirrored(whole_edge), STIFFNESS),
                numbers(&whole_edge.rows, STIFFNESS),
            );
            assert!(lower < ROUNDING, "{lower:e}:\n{draft:?}");
            let sums = |step: &stickslip::results::StepResults| {
                let edge = &step.edges[0];
                [
                    edge.resultant[0],
                    edge.normal_force,
                    edge.friction_force,
                    STIFFNESS * step.dissipation / 3000.0,
                ]
            };
            let difference = relative_difference(sums(half_step), sums(whole_step));
            assert!(difference < ROUNDING, "{difference:e}:\n{draft:?}");
        }
    }
}

#[test]
fn half_and_whole_line_contacts_agree() {
    let press = quantities(&[200.0, 600.0, 300.0], "N");
    let draft = Draft::cylinder()
        .set("materials.upper.isotropic.young", "200 GPa")
        .set(
            "loads",
            format!(
                "[{{ on = \"upper.top\", force = {{ direction = [0, -1], steps = {press} }} }}]"
            ),
        );
    let half = draft.clone().set("analysis.model", "half").run();
    let whole = draft.clone().set("analysis.model", "whole").run();
    for (half_step, whole_step) in half.steps.iter().zip(&whole.steps) {
        let (half_rows, whole_rows) = (&half_step.edges[0].rows, &whole_step.edges[0].rows);
        let right = &whole_rows[whole_rows.len() - half_rows.len()..];
        let difference =
            relative_difference(numbers(half_rows, STIFFNESS), numbers(right, STIFFNESS));
        assert!(difference < ROUNDING, "{difference:e}");
    }
}

#[test]
fn a_ply_turned_the_other_way_mirrors_everything() {
    for angle in [15.0, 45.0, 70.0] {
        let run = |angle: f64| {
            Draft::pin()
                .set("materials.plate.orthotropic", ply(angle))
                .forces(0, &[500.0, 2000.0, 700.0])
                .run()
        };
        let (plus, minus, half_turn) = (run(angle), run(-angle), run(angle + 180.0));
        for k in 0..plus.steps.len() {
            let [plus, minus] = [&plus, &minus].map(|results| &results.steps[k].edges[0]);
            let difference = relative_difference(
                numbers(&plus.rows, STIFFNESS),
                numbers(&mirrored(minus), STIFFNESS),
            );
            assert!(difference < ROUNDING, "{angle}: {difference:e}");
            // The test would see nothing in a symmetric answer.
            let skew = relative_difference(tractions(plus), tractions(minus));
            assert!(skew > 0.01, "{angle}: {skew:e}");
        }
        let difference = relative_difference(all_stresses(&plus), all_stresses(&half_turn));
        assert!(difference < ROUNDING, "{angle}: {difference:e}");
    }
}

/// A ring pulled along another axis: everything turns with the pull. A neat fit with friction, since with clearance the plate
/// would slide around the pin before it bears; with clearance without friction.
#[test]
fn a_turned_pull_turns_the_answer() {
    let ring = Draft::pin()
        .set(
            "bodies.plate.shape.plate_with_hole.outline",
            r#"{ ring = { radius = "25 mm" } }"#,
        )
        .set("loads.0.on", "plate.outer")
        .set("contacts.0.gap", "linearised")
        .set("analysis.model", "whole")
        .forces(0, &[1000.0, 2500.0, 600.0]);
    let drafts = [
        ring.clone()
            .set("bodies.pin.shape.disk.radius", "5 mm")
            .friction("coulomb = { mu = 0.3 }"),
        ring.friction("coulomb = { mu = 0 }"),
    ];
    for draft in drafts {
        let reference = draft.run();
        for quarter_turns in 1..4_u8 {
            let (s, c) = (f64::from(quarter_turns) * std::f64::consts::FRAC_PI_2).sin_cos();
            let direction = format!("[{}, {}]", -c.round(), -s.round());
            let turned = draft
                .clone()
                .set("loads.0.force.direction", direction)
                .run();
            for (step, turned_step) in reference.steps.iter().zip(&turned.steps) {
                let mut rows = turned_step.edges[0].rows.clone();
                let quarter = rows.len() / 4;
                rows.rotate_left(usize::from(quarter_turns) * quarter);
                let traction = |rows: &[EdgeRow]| -> Vec<f64> {
                    rows.iter()
                        .flat_map(|row| [row.pressure, row.shear, row.sigma_tangential])
                        .collect()
                };
                let difference =
                    relative_difference(traction(&step.edges[0].rows), traction(&rows));
                assert!(
                    difference < ROUNDING,
                    "{quarter_turns}: {difference:e}\n{draft:?}"
                );
            }
        }
    }
}

#[test]
fn units_of_the_scene_do_not_change_the_answer() {
    // 1 in = 25.4 mm and 1 lbf = 4.4482216152605 N exactly (NIST SP 811, 2008).
    let inches = |mm: f64| format!("{} in", mm / 25.4);
    let pounds: Vec<f64> = [500.0, 1500.0, 250.0]
        .iter()
        .map(|newtons| newtons / 4.448_221_615_260_5)
        .collect();
    let psi = |mpa: f64| format!("{} psi", mpa * 25.4 * 25.4 / 4.448_221_615_260_5);
    let metric = Draft::pin().forces(0, &[500.0, 1500.0, 250.0]);
    let imperial = metric
        .clone()
        .set(
            "units",
            r#"{ length = "in", force = "lbf", stress = "psi" }"#,
        )
        .set("materials.plate.isotropic.young", psi(70e3))
        .set("materials.pin.isotropic.young", psi(70e3))
        .set("bodies.plate.thickness", inches(2.0))
        .set("bodies.pin.thickness", inches(2.0))
        .set(
            "bodies.plate.shape.plate_with_hole.hole_radius",
            inches(5.0),
        )
        .set(
            "bodies.plate.shape.plate_with_hole.outline.strip",
            format!(
                "{{ half_width = \"{}\", left = \"{}\", right = \"{}\" }}",
                inches(20.0),
                inches(60.0),
                inches(20.0)
            ),
        )
        .set("bodies.pin.shape.disk.radius", inches(4.99))
        .set("mesh.spacing", format!("{} rad", 9.0_f64.to_radians()))
        .set("loads.0.force.steps", quantities(&pounds, "lbf"));
    let (metric, imperial) = (metric.run(), imperial.run());
    let difference = relative_difference(all_stresses(&metric), all_stresses(&imperial));
    assert!(difference < ROUNDING, "{difference:e}");
    let shown = |results: &Results| results.steps[1].loads[0].clone();
    assert_eq!(
        (shown(&metric).unit.as_str(), shown(&imperial).unit.as_str()),
        ("N", "lbf")
    );
    assert!((shown(&imperial).value / pounds[1] - 1.0).abs() < 1e-14);
}

/// Lengths × k and forces × k²: equal stresses. Moduli and forces × k: stresses × k.
#[test]
fn size_and_stiffness_scale() {
    let reference = last_tractions(&Draft::pin().forces(0, &[1000.0, 2000.0]).run());
    let mm = |value: f64| format!("{value} mm");
    let large = Draft::pin()
        .set("bodies.plate.thickness", mm(200.0))
        .set("bodies.pin.thickness", mm(200.0))
        .set("bodies.plate.shape.plate_with_hole.hole_radius", mm(500.0))
        .set(
            "bodies.plate.shape.plate_with_hole.outline.strip",
            r#"{ half_width = "2 m", left = "6 m", right = "2 m" }"#,
        )
        .set("bodies.pin.shape.disk.radius", mm(499.0))
        .forces(0, &[1e7, 2e7]);
    let difference = relative_difference(reference.iter().copied(), last_tractions(&large.run()));
    assert!(difference < ROUNDING, "{difference:e}");
    let stiff = Draft::pin()
        .set("materials.plate.isotropic.young", "7 GPa")
        .set("materials.pin.isotropic.young", "7 GPa")
        .forces(0, &[100.0, 200.0]);
    let softer = last_tractions(&stiff.run())
        .into_iter()
        .map(|stress| 10.0 * stress);
    let difference = relative_difference(reference, softer);
    assert!(difference < ROUNDING, "{difference:e}");
}
