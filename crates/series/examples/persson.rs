//! A frictionless pin with clearance in an infinite plate: peak pressure beside the closed form of Persson (1964).
//!
//! Run with `cargo run --release -p stickslip-series --example persson`. Lengths in units of the radius, stresses in units of Q/Rt.

use std::error::Error;
use std::sync::Arc;

use stickslip_contact::{Chain, ContactPair, ContactPoint, InterfaceProblem, LoadHistory, Ramp};
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_friction::Coulomb;
use stickslip_series::{Anchor, Circle, Disk, DiskLoad, FarLoad, Hole, Nodes};

/// E ΔR t/Q for contact over ±65°, and the largest pressure.
const CLEARANCE: f64 = 0.74191808;
const PEAK: f64 = 0.67697427;

fn main() -> Result<(), Box<dyn Error>> {
    let circle = Circle {
        centre: [0.0, 0.0],
        radius: 1.0,
        thickness: 1.0,
    };
    let material = Isotropic::new(1.0, 0.3, PlaneState::Stress)?;
    let nodes = Nodes::uniform_half(61)?;
    let push = DiskLoad {
        force: [1.0, 0.0],
        ..DiskLoad::default()
    };
    let plate = Hole::held(nodes.clone(), &material, circle, &[FarLoad::default()])?;
    let pin = Disk::floating(nodes.clone(), &material, circle, Anchor::default(), &[push])?;

    let weights = nodes.weights();
    let point = |(k, angle): (usize, &f64)| ContactPoint {
        first: k.into(),
        second: k.into(),
        normal: [angle.cos(), angle.sin()],
        gap: CLEARANCE * (1.0 - angle.cos()),
        area: weights[k],
        material_angle: 0.0,
    };
    let pair = ContactPair {
        name: "pin".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points: nodes.angles().iter().enumerate().map(point).collect(),
        law: Arc::new(Coulomb::new(0.0)?),
    };
    let problem = InterfaceProblem::new(&[&plate, &pin], vec![pair])?;
    let history = LoadHistory::new(vec![vec![1.0]], 1, Ramp::Linear)?;
    let records = history.follow(&problem, &Chain::default(), |_| {})?;
    let state = &records[0].state;
    let peak = (0..nodes.len())
        .map(|k| state.normal_force(k) / weights[k])
        .fold(0.0, f64::max);
    println!("peak pressure {peak:.6} Q/Rt, closed form {PEAK:.6}");
    Ok(())
}
