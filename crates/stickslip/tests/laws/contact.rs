//! One evaluation is the scene's own solution.

use std::sync::Arc;

use stickslip::experiment::laws::{ContactModel, LawsError};
use stickslip::model::Model;
use stickslip::run::{solve, solver};

use crate::common::{candidate, law, scene};

#[test]
fn what_is_seen_is_what_the_scene_recovers() {
    let overrides = ["mesh.spacing=\"4.5 deg\"", "mesh.coarse_spacing=\"9 deg\""];
    let own = scene("pin-loaded-aluminium", &overrides);
    let model = Model::build(&own.scene).unwrap();
    let chain = solver(own.scene.analysis.solver);
    let solved = solve(&model, chain.as_ref(), &mut |_| {}).unwrap();
    let named = |body: &stickslip::model::ModelBody| body.name == "plate";
    let body = model.bodies.iter().position(named).unwrap();
    let plate = solved.operators[body].elastic().unwrap();
    let nodes = plate.body().mesh().nodes().to_vec();

    let condensed = ContactModel::new(&own).unwrap();
    let view = condensed.view(&nodes).unwrap();
    let law = Arc::clone(condensed.own_law());
    let states = condensed.states(law, condensed.steps()).unwrap();
    for step in [0, 6, 13] {
        let state = &solved.records[step].state;
        assert_eq!(&states[step], state);
        let count = plate.interface_nodes().len();
        let forces = solved.interface.forces_on_body(body, count, &state.forces);
        let motions = state.rigid.rows_range(solved.interface.body_modes(body));
        let motions = motions.clone_owned();
        let exact = plate.displacements(&forces, &state.multipliers, motions.as_slice());
        let seen = view.displacements(state);
        let largest = exact.iter().fold(0.0, |most: f64, u| most.max(u.abs()));
        // Sums of columns against one solve: rounding.
        for (a, b) in seen.iter().zip(&exact) {
            assert!((a - b).abs() < 1e-10 * largest, "{a} {b}");
        }
    }
    // The other half moves as the mirror image.
    let pair = condensed.view(&[[12.0, 3.0], [12.0, -3.0]]).unwrap();
    let u = pair.displacements(&states[6]);
    assert_eq!((u[0], u[1]), (u[2], -u[3]));
    let outside = condensed.view(&[[1.0, 1.0]]).unwrap_err();
    assert!(outside.to_string().contains("(1, 1) mm is not in"));
    let elsewhere = ContactModel::new(&stickslip::experiment::SpecimenScene {
        edge: "left".to_owned(),
        ..own
    });
    let words = elsewhere.unwrap_err().to_string();
    assert!(words.starts_with("no contact of the scene is at 'plate.left'"));
}

/// A law of one ply, its angle in radians.
fn one_ply(angle: f64) -> String {
    format!(
        "{{ \"fibre_coverage\": {{ \"plies\": [{{ \"angle\": {angle}, \"fraction\": 1.0 }}], \"fibre_fraction\": 0.6, \
         \"kernel\": {{ \"tangent\": {{ \"width\": 0.7 }} }}, \"fibre\": {{ \"coulomb\": {{ \"mu\": 0.0 }} }}, \
         \"matrix\": {{ \"coulomb\": {{ \"mu\": 0.8 }} }} }} }}"
    )
}

#[test]
fn laws_that_do_not_mirror_are_fitted_to_the_whole() {
    let overrides = ["mesh.spacing=\"9 deg\"", "mesh.coarse_spacing=\"9 deg\""];
    let own = scene("pin-loaded-aluminium", &overrides);
    let coulomb = candidate(
        "coulomb",
        r#"{ "coulomb": { "mu": 0.3 } }"#,
        &[("mu", [0.0, 1.0])],
    );
    let matrix = [("matrix.coulomb.mu", [0.0, 1.0])];
    let along = candidate("along", &one_ply(0.0), &matrix);
    let skew = candidate("skew", &one_ply(0.8), &matrix);
    // At 0 the angle mirrors, and nowhere else in its range.
    let turning = candidate("turning", &one_ply(0.0), &[("plies.0.angle", [-0.5, 0.5])]);
    let half = ContactModel::for_laws(&own, &[coulomb.clone(), along]).unwrap();
    assert!(half.is_half());
    for other in [&skew, &turning] {
        let whole = ContactModel::for_laws(&own, &[coulomb.clone(), other.clone()]).unwrap();
        assert!(!whole.is_half());
    }
    let refused = half.states(Arc::from(law(&one_ply(0.8))), 1).unwrap_err();
    assert!(matches!(refused, LawsError::NotSymmetric { .. }));

    let asks_for_half = scene(
        "pin-loaded-aluminium",
        &[&overrides[..], &["analysis.model=half"]].concat(),
    );
    let refused = ContactModel::for_laws(&asks_for_half, &[skew]).unwrap_err();
    let words = refused.to_string();
    assert!(
        words.starts_with("law 'skew' claims no symmetry") && words.contains("analysis.model"),
        "{words}"
    );
}

#[test]
fn laws_are_not_fitted_on_the_deformed_geometry() {
    let own = scene(
        "pin-loaded-aluminium",
        &["analysis.kinematics=deformed-gaps"],
    );
    let refused = ContactModel::new(&own).unwrap_err().to_string();
    assert!(
        refused.contains("analysis.kinematics = \"small\""),
        "{refused}"
    );
}
