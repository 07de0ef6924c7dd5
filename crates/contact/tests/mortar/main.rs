//! Tests of the mortar projection, from outside the crate.

mod assembled;
mod blocks;
mod cylinder;
mod patch;
mod pin;
mod sides;
mod weights;

use std::sync::Arc;

use stickslip_contact::{
    Chain, ContactPair, ContactPoint, EdgeSide, InterfaceProblem, LoadHistory, Multipliers, Ramp,
    StepRecord,
};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_friction::Coulomb;

const BOTH: [Multipliers; 2] = [Multipliers::Standard, Multipliers::Dual];

/// The edge `set` of a mesh as the whole interface of its body, along x: mesh nodes and side.
fn along_x(mesh: &Mesh, set: &str) -> (Vec<usize>, EdgeSide) {
    let mut path = mesh.edge_path(set).unwrap();
    let x = |node: &usize| mesh.nodes()[*node][0];
    if x(&path.nodes[0]) > x(&path.nodes[1]) {
        path = path.reversed();
    }
    let parameter: Vec<f64> = path.nodes.iter().map(x).collect();
    let side = EdgeSide::open((0..parameter.len()).collect(), parameter, path.order).unwrap();
    (path.nodes, side)
}

/// The problem of one pair between two bodies, solved in one step per entry of `steps`.
fn solve(
    bodies: [&dyn InterfaceOperator; 2],
    points: Vec<ContactPoint>,
    mu: f64,
    steps: &[f64],
) -> (InterfaceProblem, StepRecord) {
    let pair = ContactPair {
        name: "joint".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points,
        law: Arc::new(Coulomb::new(mu).unwrap()),
    };
    let problem = InterfaceProblem::new(&bodies, vec![pair]).unwrap();
    let steps = steps.iter().map(|&factor| vec![factor]).collect();
    let history = LoadHistory::new(steps, 1, Ramp::Linear).unwrap();
    let mut records = history.follow(&problem, &Chain::default(), |_| {}).unwrap();
    (problem, records.pop().unwrap())
}

/// Pressure and shear traction of each point.
fn tractions(problem: &InterfaceProblem, record: &StepRecord) -> Vec<[f64; 2]> {
    let point = |(k, point): (usize, &stickslip_contact::problem::ProblemPoint)| {
        [
            record.state.normal_force(k) / point.area,
            record.state.tangential_force(k) / point.area,
        ]
    };
    problem.points().iter().enumerate().map(point).collect()
}

/// Resultant force and moment about the origin of forces on points.
fn resultant(points: &[Point], forces: &[f64]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (point, force) in points.iter().zip(forces.chunks_exact(2)) {
        sum[0] += force[0];
        sum[1] += force[1];
        sum[2] += point[0] * force[1] - point[1] * force[0];
    }
    sum
}
