//! A flat rigid punch pressed into an elastic block and pushed along it, with friction: from two operators to tractions.
//!
//! Run with `cargo run --release -p stickslip-contact --example punch`. Lengths in mm, forces in N, stresses in MPa.

use std::error::Error;
use std::sync::Arc;

use stickslip_contact::{
    Chain, ContactPair, ContactPoint, ContactState, InterfaceProblem, LoadHistory, Ramp, Status,
};
use stickslip_fem_core::generate::{Generate, Rectangle};
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_fem_core::mesh::{ElementKind, Point};
use stickslip_fem_core::{
    CondensedBody, ElasticBody, HeldDirection, InterfaceOperator, LoadCase, RigidBody, Support,
};
use stickslip_friction::Coulomb;

const THICKNESS: f64 = 1.0;
const HALF_WIDTH: f64 = 1.0;
const CELL: f64 = 0.125;
/// The punch's load cases: pressed down with 100 N, pushed along x with 10 N.
const LOADS: [[f64; 2]; 2] = [[0.0, -100.0], [10.0, 0.0]];

fn main() -> Result<(), Box<dyn Error>> {
    let block = block()?;
    // The second operator: a rigid punch, free to move along x and y.
    let punch = RigidBody::sliding(block.points().to_vec(), [true, true], &LOADS);
    let pair = ContactPair {
        name: "punch".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points: node_pairs(block.points()),
        law: Arc::new(Coulomb::new(0.2)?),
    };
    let problem = InterfaceProblem::new(&[&block, &punch], vec![pair])?;

    // Pressed first, then pushed.
    let history = LoadHistory::new(vec![vec![1.0, 0.0], vec![1.0, 1.0]], 4, Ramp::Linear)?;
    let records = history.follow(&problem, &Chain::default(), |_| {})?;
    print(&problem, &records[1].state);
    Ok(())
}

/// The first operator: an elastic block, clamped below, condensed to its nodes under the punch.
fn block() -> Result<CondensedBody, Box<dyn Error>> {
    let mesh = Rectangle::uniform([-4.0, 4.0], [-4.0, 0.0], [64, 32], ElementKind::Q4)?;
    let mesh = Arc::new(mesh.generate()?);
    let clamp = |direction| Support {
        nodes: mesh.node_set("bottom").unwrap_or_default().to_vec(),
        direction,
        displacement: 0.0,
    };
    let under_punch: Vec<usize> = (0..mesh.nodes().len())
        .filter(|&node| {
            let [x, y] = mesh.nodes()[node];
            y == 0.0 && x.abs() <= HALF_WIDTH
        })
        .collect();
    let steel = Arc::new(Isotropic::new(210_000.0, 0.3, PlaneState::Strain)?);
    let block = ElasticBody::new(Arc::clone(&mesh), vec![steel], THICKNESS)?
        .with_supports([clamp(HeldDirection::X), clamp(HeldDirection::Y)])
        .with_load_cases(vec![LoadCase::default(), LoadCase::default()])?;
    Ok(Arc::new(block).condense(&under_punch)?)
}

/// Nodes touch nodes; a node stands for a cell's width, at both ends for half of it.
fn node_pairs(places: &[Point]) -> Vec<ContactPoint> {
    let point = |(k, [x, _]): (usize, &Point)| {
        let at_end = x.abs() > HALF_WIDTH - 0.5 * CELL;
        let width = if at_end { 0.5 * CELL } else { CELL };
        ContactPoint {
            first: k.into(),
            second: k.into(),
            normal: [0.0, -1.0],
            gap: 0.0,
            area: width * THICKNESS,
            material_angle: 0.0,
        }
    };
    places.iter().enumerate().map(point).collect()
}

fn print(problem: &InterfaceProblem, end: &ContactState) {
    println!("{:>8} {:>10} {:>10}  status", "x", "CPRESS", "CSHEAR1");
    for (k, point) in problem.points().iter().enumerate() {
        let (pressure, shear) = (
            end.normal_force(k) / point.area,
            end.tangential_force(k) / point.area,
        );
        let status = match end.status[k] {
            Status::Open => "open",
            Status::Stick => "stick",
            Status::SlipPositive | Status::SlipNegative => "slip",
        };
        let x = point.place.position[0];
        println!("{x:8.3} {pressure:10.3} {shear:10.3}  {status}");
    }
    let count = problem.points().len();
    let pressed: f64 = (0..count).map(|k| end.normal_force(k)).sum();
    println!("normal force {pressed:.6} N");
}
