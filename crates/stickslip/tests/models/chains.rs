//! A pin in a bushing in a plate.

use stickslip::model::{Model, ModelBodyKind};
use stickslip::output::summary_json;
use stickslip::results::Results;

use super::{BUSHING, difference, model, results, scene, solved, tractions, upper};

/// Centre of a body's box `[mm]`, which is that of a whole round body.
fn centre(model: &Model, name: &str) -> [f64; 2] {
    let body = model.bodies.iter().find(|body| body.name == name).unwrap();
    let ModelBodyKind::Elastic(elastic) = &body.kind else {
        panic!("{name} is rigid");
    };
    let [low, high] = elastic.mesh().bounding_box();
    [0, 1].map(|axis| f64::midpoint(low[axis], high[axis]))
}

#[test]
fn each_body_starts_where_it_touches_what_holds_it() {
    let whole = model(BUSHING, &["analysis.model=whole"]);
    // Clearances 0.01 and 0.02 mm; coordinates near 7 mm carry 1e-15.
    for (name, at) in [("bushing", 0.01), ("pin", 0.03)] {
        let [x, y] = centre(&whole, name);
        assert!(
            (x - at).abs() < 1e-13 && y.abs() < 1e-13,
            "{name}: {x}, {y}"
        );
    }
    for (pair, clearance) in [(0, 0.01), (1, 0.02)] {
        let points = &whole.pairs[pair].points;
        let gap = |angle: f64| {
            let near = |k: &usize| (whole.edges[pair].geometry.parameter[*k] - angle).abs() < 1e-9;
            points[(0..points.len()).find(near).unwrap()].gap
        };
        assert!(gap(0.0).abs() < 1e-15);
        assert!((gap(-std::f64::consts::PI) - 2.0 * clearance).abs() < 1e-13);
    }
    // One with interference is concentric with what holds it, which holds the pin where the pin touches it.
    let pressed = model(
        BUSHING,
        &[
            "analysis.model=whole",
            "bodies.bushing.shape.plate_with_hole.outline.ring.radius=7.01 mm",
            "contacts.0.interference=true",
        ],
    );
    assert!(centre(&pressed, "bushing")[0].abs() < 1e-13);
    assert!((centre(&pressed, "pin")[0] - 0.02).abs() < 1e-13);
    assert!(
        pressed.pairs[0]
            .points
            .iter()
            .all(|point| (point.gap + 0.01).abs() < 1e-13)
    );
}

/// The faceted gap is that between the nodes of both meshes, which lie on the circles about their own centres.
#[test]
fn meshes_of_a_chain_match() {
    let gaps = |kind: &str| -> Vec<Vec<f64>> {
        let kinds = [0, 1].map(|contact| format!("contacts.{contact}.gap={kind}"));
        let model = model(BUSHING, &[&kinds[0], &kinds[1]]);
        let pair = |pair: &stickslip_contact::ContactPair| {
            pair.points.iter().map(|point| point.gap).collect()
        };
        model.pairs.iter().map(pair).collect()
    };
    for (exact, faceted) in gaps("exact").iter().zip(&gaps("faceted")) {
        // Nodes at equal angles are c sin θ apart across the normal: a second-order difference c²/2R.
        for (exact, faceted) in exact.iter().zip(faceted) {
            assert!(
                (exact - faceted).abs() < 0.02 * 0.02 / 5.0,
                "{exact} {faceted}"
            );
        }
    }
}

#[test]
fn every_body_is_in_balance_and_both_contacts_carry_the_pull() {
    let pulls = [1000.0, 4000.0, 1000.0];
    for changes in [
        &[][..],
        &["analysis.model=whole"],
        &[
            "bodies.bushing.shape.plate_with_hole.outline.ring.radius=7.004 mm",
            "contacts.0.interference=true",
        ],
    ] {
        let results = solved(BUSHING, changes);
        assert_eq!(results.edges.len(), 2);
        for (step, pull) in results.steps.iter().zip(pulls) {
            // The solvers promise 1e-10 of the largest force; sums over some tens of points stay below ten times that.
            for body in step.balance.iter().flatten() {
                let worst = body.force.max(body.moment).max(body.nodal);
                assert!(worst < 1e-9, "{changes:?}: {worst:e}");
            }
            assert_eq!(step.balance.iter().flatten().count(), 3);
            for edge in &step.edges {
                let [x, y] = edge.resultant;
                assert!(
                    (x / pull - 1.0).abs() < 1e-9 && (y / pull).abs() < 1e-9,
                    "{x}, {y}"
                );
            }
        }
    }
}

/// A pin with interference presses a bushing of the plate's own material against the plate all around; with friction that
/// nothing overcomes the two are one. What is left is the difference of two meshes, of which the plate's has no circle at 7 mm.
#[test]
fn a_bushing_that_sticks_everywhere_is_a_part_of_the_plate() {
    let apart = |spacing: &str| {
        let spacing = format!("mesh.spacing={spacing}");
        let fit = [
            spacing.as_str(),
            "bodies.pin.shape.disk.radius=5.01 mm",
            "loads.0.force.steps=[\"200 N\", \"500 N\"]",
        ];
        let bushed = [
            &fit[..],
            &[
                "bodies.bushing.shape.plate_with_hole.outline.ring.radius=7 mm",
                "contacts.0.friction.coulomb.mu=1000",
                "contacts.1.interference=true",
            ],
        ];
        let plain = [
            &fit[..],
            &[
                "bodies.plate.shape.plate_with_hole.hole_radius=5 mm",
                "bodies.bushing.shape.plate_with_hole.outline.ring.radius=20 mm",
                "contacts=[{ first = \"plate.hole\", second = \"pin.rim\", interference = true, friction.coulomb.mu = 0.2 }]",
                "supports.1={ on = \"bushing.outer\", fix = [\"x\", \"y\"] }",
            ],
        ];
        let (bushed, plain) = (
            solved(BUSHING, &bushed.concat()),
            solved(BUSHING, &plain.concat()),
        );
        let steps = 0..bushed.steps.len();
        steps
            .map(|step| {
                let rows = upper(&bushed, step, 0);
                assert!(
                    rows.iter().all(|row| row.pressure > 0.0),
                    "the bushing presses all around"
                );
                difference(
                    tractions(&upper(&plain, step, 0)),
                    tractions(&upper(&bushed, step, 1)),
                )
            })
            .fold(0.0, f64::max)
    };
    let (coarse, fine) = (apart("6 deg"), apart("3 deg"));
    assert!(coarse < 0.01 && fine < 0.6 * coarse, "{coarse:e}, {fine:e}");
}

/// Without friction nothing keeps a whole bushing from turning. Its rotation says nothing, and pressures do not depend on it.
#[test]
fn a_frictionless_bushing_may_turn() {
    let smooth = [
        "contacts.0.friction.coulomb.mu=0",
        "contacts.1.friction.coulomb.mu=0",
    ];
    let half = solved(BUSHING, &[&smooth[..], &["analysis.model=half"]].concat());
    for solver in ["auto", "pivoting"] {
        let solver = format!("analysis.solver={solver}");
        let whole = solved(
            BUSHING,
            &[&smooth[..], &["analysis.model=whole", solver.as_str()]].concat(),
        );
        for step in 0..half.steps.len() {
            for edge in 0..2 {
                // The half has its node at 180° and the whole at −180°.
                let (half, whole) = (upper(&half, step, edge), upper(&whole, step, edge));
                let apart = difference(tractions(&half), tractions(&whole));
                assert!(
                    apart < 1e-8,
                    "{solver}, step {step}, edge {edge}: {apart:e}"
                );
                // Not more than the play that it has.
                assert!(whole.iter().all(|row| row.slip.abs() < 0.1));
            }
        }
    }
}

#[test]
fn half_and_whole_agree() {
    let [half, whole] = ["half", "whole"].map(|kind| {
        let model = format!("analysis.model={kind}");
        solved(BUSHING, &[model.as_str()])
    });
    for step in 0..half.steps.len() {
        for edge in 0..2 {
            let apart = difference(
                tractions(&upper(&half, step, edge)),
                tractions(&upper(&whole, step, edge)),
            );
            assert!(apart < 1e-8, "step {step}, edge {edge}: {apart:e}");
        }
    }
}

#[test]
fn a_rigid_pin_may_be_in_a_bushing_and_a_bushing_in_a_bushing() {
    let rigid = "bodies.pin={ rigid = true, shape.disk.radius = \"4.98 mm\" }";
    let support = "supports.0.on=pin.centre";
    let results = solved(BUSHING, &[rigid, support]);
    assert!((results.steps[1].edges[0].resultant[0] / 4000.0 - 1.0).abs() < 1e-9);
    let liner = "bodies.liner={ material = \"metal\", thickness = \"2 mm\", shape.plate_with_hole = { hole_radius = \"4 mm\", \
                 outline.ring.radius = \"4.99 mm\" } }";
    let nested = solved(
        BUSHING,
        &[
            liner,
            "contacts.1.second=liner.outer",
            "contacts.2={ first = \"liner.hole\", second = \"pin.rim\", friction.coulomb.mu = 0.1 }",
            "bodies.pin.shape.disk.radius=3.99 mm",
        ],
    );
    for edge in &nested.steps[1].edges {
        assert!((edge.resultant[0] / 4000.0 - 1.0).abs() < 1e-9);
    }
}

#[test]
fn the_summary_has_one_entry_for_each_contact() {
    let summary = summary_json(&results(&scene(BUSHING, &[]))).unwrap();
    let edges = summary["steps"][1]["edges"].as_object().unwrap();
    assert_eq!(edges.keys().collect::<Vec<_>>(), ["bushing", "pin"]);
    // Contacts are named by their second bodies, and a note on one does not apply to the other.
    let angle = |name: &str| edges[name]["contact_half_angle_deg"].as_f64().unwrap();
    assert!(angle("bushing") > 10.0 && (angle("bushing") - angle("pin")).abs() > 0.1);
}

/// The clearance of each contact is that of the radii in the scene, negative for an interference; open edges have none.
#[test]
fn results_state_radial_clearances() {
    let clearances = |results: &Results| -> Vec<Option<f64>> {
        let edges = results.edges.iter();
        edges.map(|edge| edge.clearance).collect()
    };
    let own = clearances(&solved(BUSHING, &[]));
    let [Some(outer), Some(inner)] = own[..2] else {
        panic!("{own:?}");
    };
    // Differences of numbers near 7 and 5.
    assert!(
        (outer - 0.01).abs() < 1e-14 && (inner - 0.02).abs() < 1e-14,
        "{own:?}"
    );
    let tight = [
        "bodies.pin.shape.disk.radius=5.001 mm",
        "contacts.1.interference=true",
    ];
    let tight = clearances(&solved(BUSHING, &tight));
    assert!((tight[1].unwrap() + 0.001).abs() < 1e-14, "{tight:?}");
    let equal = clearances(&solved(BUSHING, &["bodies.pin.shape.disk.radius=5 mm"]));
    assert_eq!(equal[1], Some(0.0));
}
