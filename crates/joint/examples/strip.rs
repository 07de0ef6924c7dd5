//! A strip of a cross-ply laminate pulled to its strength: which ply fails first, and what the strip bears after.
//!
//! Run with `cargo run --release -p stickslip-joint --example strip`. Lengths in mm, forces in N, stresses in MPa.

use std::error::Error;
use std::sync::Arc;

use stickslip_contact::Chain;
use stickslip_fem_core::generate::{Generate, Rectangle};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, Support};
use stickslip_joint::{Gauge, Joint, JointBody, Mark, ProgressiveBody, Pull};
use stickslip_laminate::degradation::Degradation;
use stickslip_laminate::failure::MaximumStress;
use stickslip_laminate::progressive::{PlyDiscount, PointModel};
use stickslip_laminate::{Laminate, Layup, Ply, PlyConstants, Strengths};

fn main() -> Result<(), Box<dyn Error>> {
    let joint = strip(&cross_ply()?)?;
    let history = joint.follow(&[vec![0.3]], &Chain::default(), |_, _| {})?;
    if let Some(first) = history.first_failure() {
        println!(
            "first failure: {}° ply at {:.1} N, {:?}",
            first.angle, first.load, first.kind
        );
    }
    let peak = &history.records[history.peak()];
    println!(
        "largest load {:.1} N at {:.4} mm",
        peak.load, peak.displacement
    );
    Ok(())
}

/// The laminate.
fn cross_ply() -> Result<Laminate, Box<dyn Error>> {
    // T300/5208 (Tsai & Hahn 1980).
    let constants = PlyConstants {
        e1: 181_000.0,
        e2: 10_300.0,
        g12: 7_170.0,
        nu12: 0.28,
        alpha1: 0.02e-6,
        alpha2: 22.5e-6,
        thickness: 0.125,
    };
    let strengths = Strengths {
        xt: Some(1500.0),
        xc: Some(1500.0),
        yt: Some(40.0),
        yc: Some(246.0),
        s12: Some(68.0),
        ..Strengths::default()
    };
    let layup: Layup = "[0/90]s".parse()?;
    let ply = Ply::new("T300/5208", constants, strengths)?;
    Ok(Laminate::new(&layup, &ply)?)
}

/// 20 mm × 10 mm on rollers, its right end driven by 1 mm for a multiplier of 1. Plies fail by maximum stress; broken fibres keep a
/// hundredth of their stiffness, broken matrix a tenth.
fn strip(laminate: &Laminate) -> Result<Joint, Box<dyn Error>> {
    let mesh = Rectangle::uniform([0.0, 20.0], [0.0, 10.0], [4, 2], ElementKind::Q8)?;
    let mesh = Arc::new(mesh.generate()?);
    let nodes = |set: &str| mesh.node_set(set).unwrap_or_default().to_vec();
    let hold = |set, direction, displacement| Support {
        nodes: nodes(set),
        direction,
        displacement,
    };
    let drive = LoadCase {
        moves_supports: true,
        ..LoadCase::default()
    };
    let material = Arc::new(laminate.membrane_material()?);
    let body = ElasticBody::new(Arc::clone(&mesh), vec![material], laminate.thickness())?
        .with_supports([
            hold("left", HeldDirection::X, 0.0),
            hold("bottom", HeldDirection::Y, 0.0),
            hold("right", HeldDirection::X, 1.0),
        ])
        .with_load_cases(vec![drive])?;
    let kept = Degradation::new(0.01, 0.1)?;
    let discount = PlyDiscount::new(laminate.clone(), Box::new(MaximumStress), kept)?;
    let model: Arc<dyn PointModel> = Arc::new(discount);
    let body = ProgressiveBody::new(Arc::new(body), &[], &model)?;
    let gauge = Gauge {
        pull: Pull::Supports { body: 0 },
        multiple: 1.0,
        direction: [1.0, 0.0],
        first: Mark::Node {
            body: 0,
            node: nodes("right")[0],
        },
        second: Mark::Fixed,
        free_travel: 0.0,
    };
    let bodies = vec![JointBody::Progressive(Arc::new(body))];
    Ok(Joint::new(bodies, Vec::new(), gauge)?)
}
