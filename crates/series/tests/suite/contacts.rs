//! A pin in a hole, from two operators to tractions.

use std::sync::Arc;

use stickslip_contact::{
    Chain, ContactPair, ContactPoint, ContactState, InterfaceProblem, LoadHistory, Ramp,
};
use stickslip_fem_core::InterfaceOperator;
use stickslip_friction::Coulomb;
use stickslip_series::Nodes;

/// The problem of a plate around a pin, both on `nodes`, with the radial clearance `clearance` and first contact at θ = 0.
pub(crate) fn problem(
    plate: &dyn InterfaceOperator,
    pin: &dyn InterfaceOperator,
    nodes: &Nodes,
    radius_times_thickness: f64,
    clearance: f64,
    friction: f64,
) -> InterfaceProblem {
    let weights = nodes.weights();
    let points = nodes
        .mean_angles()
        .into_iter()
        .enumerate()
        .map(|(k, angle)| ContactPoint {
            first: k.into(),
            second: k.into(),
            normal: [angle.cos(), angle.sin()],
            gap: clearance * (1.0 - angle.cos()),
            area: radius_times_thickness * weights[k],
            material_angle: 0.0,
        });
    let pair = ContactPair {
        name: "pin".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points: points.collect(),
        law: Arc::new(Coulomb::new(friction).unwrap()),
    };
    InterfaceProblem::new(&[plate, pin], vec![pair]).unwrap()
}

/// The states at the end of `steps`, multipliers of all load cases, each in `increments`.
pub(crate) fn follow(
    problem: &InterfaceProblem,
    steps: Vec<Vec<f64>>,
    increments: usize,
) -> Vec<ContactState> {
    let history = LoadHistory::new(steps, increments, Ramp::Linear).unwrap();
    let records = history.follow(problem, &Chain::default(), |_| {}).unwrap();
    records.into_iter().map(|record| record.state).collect()
}

/// Pressures `[stress]` at the points.
pub(crate) fn pressures(problem: &InterfaceProblem, state: &ContactState) -> Vec<f64> {
    let points = problem.points().iter().enumerate();
    points
        .map(|(k, point)| state.normal_force(k) / point.area)
        .collect()
}
