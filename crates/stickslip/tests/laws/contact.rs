//! One evaluation is the scene's own solution, and cheap.

use std::sync::Arc;
use std::time::Instant;

use stickslip::model::Model;
use stickslip::run::{run, solve, solver};

use crate::common::{aluminium, scene, window};

#[test]
fn what_is_seen_is_what_the_scene_recovers() {
    let overrides = ["mesh.spacing=\"4.5 deg\"", "mesh.coarse_spacing=\"9 deg\""];
    let own = scene("pin-loaded-aluminium", &overrides);
    let model = Model::build(&own.scene).unwrap();
    let chain = solver(own.scene.analysis.solver);
    let solved = solve(&model, chain.as_ref(), &mut |_| {}).unwrap();
    let body = model
        .bodies
        .iter()
        .position(|body| body.name == "plate")
        .unwrap();
    let plate = solved.operators[body].elastic().unwrap();
    let nodes = plate.body().mesh().nodes().to_vec();

    let condensed = stickslip::experiment::laws::ContactModel::new(&own).unwrap();
    let view = condensed.view(&nodes).unwrap();
    let states = condensed
        .states(Arc::clone(condensed.own_law()), condensed.steps())
        .unwrap();
    for step in [0, 6, 13] {
        let state = &solved.records[step].state;
        assert_eq!(&states[step], state);
        let count = plate.interface_nodes().len();
        let forces = solved.problem.forces_on_body(body, count, &state.forces);
        let motions = state.rigid.rows_range(solved.problem.body_modes(body));
        let exact = plate.displacements(
            &forces,
            &state.multipliers,
            motions.clone_owned().as_slice(),
        );
        let seen = view.displacements(state);
        let largest = exact.iter().fold(0.0, |most: f64, u| most.max(u.abs()));
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
}

#[test]
fn timing() {
    for degrees in [1.125, 2.25, 4.5] {
        let start = Instant::now();
        let model = aluminium(degrees);
        let condensed = start.elapsed();
        let view = model.view(&window(20.0, 1.0, 0.2)).unwrap();
        let viewed = start.elapsed() - condensed;
        let start = Instant::now();
        let states = model
            .states(Arc::clone(model.own_law()), model.steps())
            .unwrap();
        let history = start.elapsed();
        let start = Instant::now();
        states
            .iter()
            .for_each(|state| drop(view.displacements(state)));
        println!(
            "{degrees}: {} nodes, condensed {condensed:?}, view {viewed:?}, history {history:?}, seen {:?}",
            model.edge().len(),
            start.elapsed()
        );
    }
    let own = scene("pin-loaded-aluminium", &[]);
    let start = Instant::now();
    run(&own.scene, &mut |_| {}).unwrap();
    println!("run {:?}", start.elapsed());
}
