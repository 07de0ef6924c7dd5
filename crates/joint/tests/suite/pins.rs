//! Pins that move: an elastic one that is driven, a rigid one that is pushed.

use std::sync::Arc;

use stickslip_contact::Chain;
use stickslip_fem_core::generate::{Disk, Extent, Generate, Growth, uniform_angles};
use stickslip_fem_core::material::{Isotropic, Material, PlaneState};
use stickslip_fem_core::mesh::Mesh;
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, RigidBody, Support};
use stickslip_joint::{Ending, Gauge, Joint, JointBody, JointHistory, Mark, Options};

use crate::models::{discount, laminate};
use crate::plate::{End, Plate};

const LAYUP: &str = "[0/45/-45/90]s";

fn narrow() -> Plate {
    Plate {
        half_width: 6.0,
        cells: 12,
        layers: 5,
        ..Plate::default()
    }
}

/// The joint of a held plate and the pin that `pin` makes of the hole's points, marked at its node or point `mark`.
fn joint(pin: impl FnOnce(&Plate, RigidBody) -> JointBody, mark: usize) -> Joint {
    counted_from(pin, mark, 0.0)
}

/// The same with displacements that count from `free_travel`.
fn counted_from(
    pin: impl FnOnce(&Plate, RigidBody) -> JointBody,
    mark: usize,
    free_travel: f64,
) -> Joint {
    let plate = narrow();
    let mesh = plate.mesh();
    let models = vec![discount(LAYUP); mesh.element_count()];
    let (body, pair, rigid) = plate.parts(&mesh, models, End::Held, 0.0);
    let gauge = Gauge {
        first: Mark::Node {
            body: 1,
            node: mark,
        },
        second: Mark::Node {
            body: 0,
            node: mesh.node_set("left").unwrap()[0],
        },
        free_travel,
        ..Plate::gauge(&mesh)
    };
    let options = Options {
        increments: 25,
        ..Options::default()
    };
    Joint::new(vec![body, pin(&plate, rigid)], vec![pair], gauge)
        .unwrap()
        .with_options(options)
        .unwrap()
}

/// A rigid pin that a force of 1 N pushes, ½ N on the half model.
fn pushed(rigid: &RigidBody) -> JointBody {
    use stickslip_fem_core::InterfaceOperator;
    let points = rigid.points().to_vec();
    JointBody::Rigid(RigidBody::sliding(points, [true, false], &[[0.5, 0.0]]))
}

fn follow(joint: &Joint, size: f64) -> JointHistory {
    joint
        .follow(&[vec![size]], &Chain::newton_first(), |_, _| {})
        .unwrap()
}

fn disk(plate: &Plate) -> Arc<Mesh> {
    let disk = Disk {
        radius: plate.radius,
        centre: [0.0; 2],
        extent: Extent::Half,
        angles: uniform_angles(Extent::Half, plate.cells),
        core: Disk::CORE,
        layers: 3,
        growth: Growth::Geometric { aspect: 1.0 },
        kind: plate.kind,
    };
    Arc::new(disk.generate().unwrap())
}

/// A steel pin whose middle plane moves by 1 mm.
fn steel(plate: &Plate) -> JointBody {
    let mesh = disk(plate);
    let support = |direction, displacement| Support {
        nodes: mesh.node_set("symmetry").unwrap().to_vec(),
        direction,
        displacement,
    };
    let steel = Isotropic::new(210_000.0, 0.3, PlaneState::Stress).unwrap();
    let thickness = laminate(LAYUP, &crate::models::carbon()).thickness();
    let case = LoadCase {
        moves_supports: true,
        ..LoadCase::default()
    };
    let materials: Vec<Arc<dyn Material>> = (mesh.blocks().iter())
        .map(|_| -> Arc<dyn Material> { Arc::new(steel) })
        .collect();
    let body = ElasticBody::new(Arc::clone(&mesh), materials, thickness)
        .unwrap()
        .with_supports([
            support(HeldDirection::X, 1.0),
            support(HeldDirection::Y, 0.0),
        ])
        .with_load_cases(vec![case])
        .unwrap();
    let rim = mesh.counter_clockwise(&mesh.edge_path("rim").unwrap(), [0.0; 2]);
    JointBody::Elastic(Arc::new(Arc::new(body).condense(&rim.nodes).unwrap()))
}

/// Loads, reactions of the driven pin, energies of all bodies and friction close the balance; past the peak too.
#[test]
fn a_driven_elastic_pin_balances_energy() {
    let middle = disk(&narrow()).node_set("centre").unwrap()[0];
    let joint = joint(|plate, _| steel(plate), middle);
    let history = follow(&joint, 0.15);
    assert!(
        matches!(history.ending, Ending::LoadDropped { .. }),
        "{:?}",
        history.ending
    );
    let strength = history.strength().unwrap();
    for record in &history.records {
        assert!(
            record.energy.imbalance().abs() < 5e-3,
            "{:?}",
            record.energy
        );
    }
    // The driven pin's reaction is the joint's load.
    let last = &history.state.bodies[1];
    let load = history.records[history.records.len() - 1].load;
    assert!((2.0 * last.support_work / load - 1.0).abs() < 1e-9);
    println!(
        "elastic pin {strength:.1} N, first ply {:.1} N",
        history.first_failure().unwrap().load
    );
}

/// A rigid pin pushed by a force: the load by the gauge is the force, the history ends at the strength, and the strength of the same plate
/// around the driven pin of steel is near.
#[test]
fn a_pushed_rigid_pin_ends_at_the_strength() {
    let pushed = joint(|_, rigid| pushed(&rigid), 0);
    let history = follow(&pushed, 4000.0);
    for record in &history.records {
        assert!((record.load / record.multipliers[0] - 1.0).abs() < 1e-9);
        assert!(record.energy.imbalance().abs() < 5e-3);
    }
    let strength = history.strength().unwrap();
    println!("rigid pin {strength:.1} N: {:?}", history.ending);
    assert!(matches!(history.ending, Ending::NoEquilibrium { .. }));
    let middle = disk(&narrow()).node_set("centre").unwrap()[0];
    let driven = follow(&joint(|plate, _| steel(plate), middle), 0.15);
    assert!((strength / driven.strength().unwrap() - 1.0).abs() < 0.15);
}

/// What a joint bears does not depend on where its displacements count from: as where a pin meets the hole before its free travel is used
/// up, or later.
#[test]
fn the_free_travel_changes_no_strength() {
    let of = |free_travel| {
        let history = follow(
            &counted_from(|_, rigid| pushed(&rigid), 0, free_travel),
            4000.0,
        );
        let failed = history.first_failure().unwrap().displacement + free_travel;
        (history.strength().unwrap(), history.records.len(), failed)
    };
    let (strength, records, failed) = of(0.0);
    // The pin moves by `failed` until the first ply fails.
    for part in [-1.0, 0.3, 0.9999, 1.3, 4.0] {
        let (other, count, _) = of(part * failed);
        assert!(
            (other / strength - 1.0).abs() < 1e-9 && count == records,
            "{part}: {other} N, {count} records; {strength} N, {records} records"
        );
    }
}
