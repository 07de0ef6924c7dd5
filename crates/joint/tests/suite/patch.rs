//! One material point stretched over a whole body: strip of any cells under a uniform strain, to yield and to ply failure.

use std::sync::Arc;

use stickslip_contact::Chain;
use stickslip_fem_core::generate::{Generate, Rectangle};
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, Support};
use stickslip_joint::{
    Gauge, Joint, JointBody, JointHistory, Mark, Options, PlyEventKind, ProgressiveBody, Pull,
};
use stickslip_laminate::failure::FailureMode;
use stickslip_laminate::progressive::PointModel;

use crate::models::{carbon, discount, plastic, strengths};

const LENGTH: f64 = 4.0;
const HEIGHT: f64 = 2.0;

/// A rectangle on rollers, its right side driven by 1.
fn strip(model: &Arc<dyn PointModel>, kind: ElementKind) -> Joint {
    strip_driven(model, kind, 1.0)
}

/// A rectangle on rollers, its right side driven by `driven` at a multiplier of 1.
fn strip_driven(model: &Arc<dyn PointModel>, kind: ElementKind, driven: f64) -> Joint {
    let mesh: Arc<Mesh> = Arc::new(
        Rectangle::uniform([0.0, LENGTH], [0.0, HEIGHT], [4, 2], kind)
            .unwrap()
            .generate()
            .unwrap(),
    );
    let hold = |set: &str, direction, displacement| Support {
        nodes: mesh.node_set(set).unwrap().to_vec(),
        direction,
        displacement,
    };
    let supports = [
        hold("left", HeldDirection::X, 0.0),
        hold("bottom", HeldDirection::Y, 0.0),
        hold("right", HeldDirection::X, driven),
    ];
    let laminate = model.laminate();
    let material = Arc::new(laminate.membrane_material().unwrap());
    let case = LoadCase {
        moves_supports: true,
        ..LoadCase::default()
    };
    let body = ElasticBody::new(Arc::clone(&mesh), vec![material], laminate.thickness())
        .unwrap()
        .with_supports(supports)
        .with_load_cases(vec![case])
        .unwrap();
    let body = ProgressiveBody::new(Arc::new(body), &[], model).unwrap();
    let gauge = Gauge {
        pull: Pull::Supports { body: 0 },
        multiple: 1.0,
        direction: [1.0, 0.0],
        first: Mark::Node {
            body: 0,
            node: mesh.node_set("right").unwrap()[0],
        },
        second: Mark::Fixed,
        free_travel: 0.0,
    };
    Joint::new(vec![JointBody::Progressive(Arc::new(body))], vec![], gauge).unwrap()
}

fn pull(joint: Joint, elongations: &[f64], increments: usize) -> JointHistory {
    let options = Options {
        increments,
        burst: usize::MAX,
        residual_load: 0.0,
        ..Options::default()
    };
    let steps: Vec<Vec<f64>> = elongations.iter().map(|e| vec![*e]).collect();
    joint
        .with_options(options)
        .unwrap()
        .follow(&steps, &Chain::newton_first(), |_, _| {})
        .unwrap()
}

/// A ply of perfect plasticity pulled across its fibres carries Y_t exactly, and unloads along its elastic slope.
#[test]
fn uniform_yield_is_exact() {
    for kind in ElementKind::COMMON {
        let model = plastic("[90]", 0.0);
        let yield_strain = 40.0 / 10_300.0;
        let elongation = 2.5 * yield_strain * LENGTH;
        let joint = strip(&model, kind);
        let history = pull(joint, &[elongation, 0.8 * elongation], 1);
        let section = HEIGHT * 0.125;
        let load = history.records[0].load / section;
        assert!((load / 40.0 - 1.0).abs() < 1e-10, "{kind:?}: {load}");
        let unloaded = 40.0 - 10_300.0 * 0.2 * 2.5 * yield_strain;
        let load = history.records[1].load / section;
        assert!((load / unloaded - 1.0).abs() < 1e-9, "{kind:?}: {load}");
        let plastic_work = 40.0 * 1.5 * yield_strain * section * LENGTH;
        let energy = history.records[0].energy;
        assert!((energy.dissipated / plastic_work - 1.0).abs() < 1e-9);
        let yields = history.events().filter(|e| e.kind == PlyEventKind::Yield);
        let points = history.state.bodies[0].points.len();
        assert_eq!(yields.count(), points);
        println!("{kind:?}: residuals {:?}", history.records[0].residuals);
    }
}

/// The load is a force, whatever a multiplier of 1 moves the supports by.
#[test]
fn the_load_does_not_depend_on_the_unit_of_the_drive() {
    let model = plastic("[90]", 0.0);
    let load = |driven: f64| {
        let joint = strip_driven(&model, ElementKind::Q4, driven);
        pull(joint, &[0.01 / driven], 1).records[0].load
    };
    assert!((load(0.02) / load(1.0) - 1.0).abs() < 1e-12);
}

/// Plies at right angles: those across fail at Y_t of their own stress, everywhere at once, and the load falls to what the rest
/// bears; the plies along then break at X_t.
#[test]
fn uniform_failure_is_exact() {
    for kind in ElementKind::COMMON {
        let model = discount("[0/90]s");
        let laminate = model.laminate().clone();
        let elastic = laminate.membrane_moduli(stickslip_laminate::Curvature::Suppressed);
        let section = HEIGHT * laminate.thickness();
        // σ₂ of the 90° ply per axial strain, with the mean transverse stress zero.
        let q = carbon().stiffness().to_owned();
        let transverse = -elastic.nuxy;
        let sigma = q[1][1] + q[0][1] * transverse;
        let first = 40.0 / sigma;
        let joint = strip(&model, kind);
        let below = first * LENGTH * (1.0 - 1e-9);
        let above = first * LENGTH * (1.0 + 1e-9);
        let history = pull(joint, &[below, above], 1);
        assert!(history.records[0].events.is_empty());
        let load = history.records[0].load / section;
        assert!((load / (elastic.ex * first) - 1.0).abs() < 1e-8, "{load}");
        let events = &history.records[1].events;
        assert_eq!(events.len(), 2 * history.state.bodies[0].points.len());
        assert!(events.iter().all(|event| event.angle == 90.0
            && event.pass == 0
            && event.kind == PlyEventKind::Failure(FailureMode::MatrixTension)));
        let history_load = history.records[1].load / section;
        assert!(history_load < load);
        assert!(history.records[1].energy.imbalance().abs() < 1e-9);
        assert_eq!(strengths(1.0).yt, Some(40.0));
    }
}
