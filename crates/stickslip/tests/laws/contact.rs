//! One evaluation is the scene's own solution.

use std::sync::Arc;

use stickslip::experiment::laws::ContactModel;
use stickslip::model::Model;
use stickslip::run::{solve, solver};

use crate::common::scene;

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
        let forces = solved.problem.forces_on_body(body, count, &state.forces);
        let motions = state.rigid.rows_range(solved.problem.body_modes(body));
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
    assert_eq!(
        outside.to_string(),
        "the place (1, 1) mm is not in the specimen"
    );
    let elsewhere = ContactModel::new(&stickslip::experiment::plan::SpecimenScene {
        edge: "left".to_owned(),
        ..own
    });
    assert_eq!(
        elsewhere.unwrap_err().to_string(),
        "no contact of the scene is at 'plate.left', so no friction law acts there"
    );
}
