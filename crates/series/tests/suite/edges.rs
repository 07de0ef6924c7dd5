//! Stresses of many states on an edge against those of each state's field.

use std::f64::consts::PI;

use proptest::prelude::*;
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::material::{Isotropic, Orthotropic, OrthotropicConstants, PlaneState};
use stickslip_series::{
    Accuracy, Anchor, Circle, Disk, DiskLoad, EdgeLoad, FarLoad, Field, Hole, Nodes, Outline,
    Plate, PolarStress, SeriesError,
};

const CIRCLE: Circle = Circle {
    centre: [0.3, 0.0],
    radius: 2.0,
    thickness: 0.5,
};

fn material() -> Isotropic {
    Isotropic::new(3.0, 0.25, PlaneState::Strain).unwrap()
}

fn nodes() -> impl Strategy<Value = Nodes> {
    let graded = vec![0.0, 0.01, 0.03, 0.1, 0.4, 0.9, 1.5, 2.1, 2.5, 2.9, PI];
    prop_oneof![
        (5..40_usize).prop_map(|count| Nodes::uniform_half(count).unwrap()),
        (8..40_usize).prop_map(|count| Nodes::uniform_circle(count).unwrap()),
        Just(Nodes::mirrored(graded.clone()).unwrap()),
        Just(Nodes::mirrored(graded[1..9].to_vec()).unwrap()),
        Just(Nodes::arc(graded).unwrap()),
        (9..30_usize).prop_map(|count| {
            let even = (0..count).map(|k| 2.0 * PI * k as f64 / count as f64);
            Nodes::circle(
                even.map(|angle| angle + 0.05 * (2.0 * angle).sin())
                    .collect(),
            )
            .unwrap()
        }),
    ]
}

/// Forces, multipliers and motions of some states.
type States = Vec<(Vec<f64>, Vec<f64>, Vec<f64>)>;

fn states(body: &dyn InterfaceOperator, nodes: &Nodes, numbers: &[f64]) -> States {
    let weights = nodes.weights();
    let mut numbers = numbers.iter().copied().cycle();
    let mut some = |count: usize| numbers.by_ref().take(count).collect::<Vec<f64>>();
    (0..3)
        .map(|_| {
            let mut forces = some(2 * nodes.len());
            for (row, force) in forces.iter_mut().enumerate() {
                let angle = nodes.angles()[row / 2];
                let on_axis = nodes.is_mirrored() && [0.0, PI].contains(&angle) && row % 2 == 1;
                *force *= if on_axis { 0.0 } else { weights[row / 2] };
            }
            (forces, some(body.load_cases()), some(body.modes().ncols()))
        })
        .collect()
}

fn check(
    what: &str,
    body: &dyn InterfaceOperator,
    nodes: &Nodes,
    numbers: &[f64],
    field: impl Fn(&BodyLoad<'_>) -> Field,
    edges: impl Fn(&[BodyLoad<'_>], &[f64]) -> Result<Vec<Vec<PolarStress>>, SeriesError>,
) {
    let owned = states(body, nodes, numbers);
    let loads: Vec<BodyLoad<'_>> = owned
        .iter()
        .map(|(forces, multipliers, motions)| BodyLoad {
            forces,
            multipliers,
            motions,
        })
        .collect();
    // Ends of hats are left out: a traction that jumps there has no bound beside it.
    let inner = &nodes.angles()[1..nodes.len() - 1];
    let angles: Vec<f64> = inner
        .iter()
        .copied()
        .chain([0.05, 1.0, 2.3, 3.5, 5.9])
        .collect();
    let found = edges(&loads, &angles).unwrap();
    assert_eq!(found.len(), loads.len());
    for (found, load) in found.iter().zip(&loads) {
        let field = field(load);
        let expected: Vec<PolarStress> = angles.iter().map(|&angle| field.edge(angle)).collect();
        let parts = |stress: &PolarStress| [stress.radial, stress.hoop, stress.shear];
        let sizes = expected.iter().flat_map(parts);
        let size = sizes.fold(0.0, |size: f64, part| size.max(part.abs()));
        for (found, expected) in found.iter().zip(&expected) {
            for (a, b) in parts(found).into_iter().zip(parts(expected)) {
                assert!(
                    (a - b).abs() < 1e-12 * size,
                    "{what} {nodes:?}: {found:?} {expected:?}"
                );
            }
        }
    }
    let few = BodyLoad {
        forces: &[0.0],
        multipliers: &[],
        motions: &[],
    };
    assert!(edges(&[few], &angles).is_err());
}

fn outline(skew: bool) -> Outline {
    let low = if skew { -4.5 } else { -4.0 };
    Outline::new(vec![[-5.0, low], [7.0, -4.0], [7.0, 4.0], [-5.0, 4.0]])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn tables_are_fields(
        nodes in nodes(),
        skew in any::<bool>(),
        numbers in prop::collection::vec(-1.0..1.0_f64, 101),
    ) {
        let skews = if nodes.is_mirrored() { 0.0 } else { 1.0 };
        let far = FarLoad {
            force: [3.0, 2.0 * skews],
            moment: 1.5 * skews,
            stress: [1.0, -0.4, 0.3 * skews],
        };
        let hole = Hole::floating(nodes.clone(), &material(), CIRCLE, &[far]).unwrap();
        check("hole", &hole, &nodes, &numbers, |state| hole.field(state).unwrap(), |states, angles| {
            hole.edge_stresses(states, angles)
        });
        let anchor = if skew { Anchor::Area } else { Anchor::default() };
        let load = DiskLoad { force: [3.0, 0.0], ..DiskLoad::default() };
        let disk = Disk::floating(nodes.clone(), &material(), CIRCLE, anchor, &[load]).unwrap();
        check("disk", &disk, &nodes, &numbers, |state| disk.field(state).unwrap(), |states, angles| {
            disk.edge_stresses(states, angles)
        });
        let loads = [
            vec![EdgeLoad { edge: 1, force: [3.0, 2.0 * skews] }],
            vec![EdgeLoad { edge: 2, force: [skews, 1.0] }, EdgeLoad { edge: 0, force: [skews, -1.0] }],
        ];
        let outline = outline(skew && !nodes.is_mirrored());
        let accuracy = Accuracy { tolerance: 1e-2, degree: 60 };
        let plate = Plate::new(nodes.clone(), &material(), CIRCLE, &outline, &loads, accuracy).unwrap();
        check("plate", &plate, &nodes, &numbers, |state| plate.field(state).unwrap(), |states, angles| {
            plate.edge_stresses(states, angles)
        });
        let layer = OrthotropicConstants { e1: 14.0, e2: 3.0, g12: 0.9, nu12: 0.3 };
        let layer = Orthotropic::new(layer, 0.4 * skews).unwrap();
        let plate = Plate::anisotropic(nodes.clone(), &layer, CIRCLE, &outline, &loads, accuracy).unwrap();
        check("layer", &plate, &nodes, &numbers, |state| plate.field(state).unwrap(), |states, angles| {
            plate.edge_stresses(states, angles)
        });
    }
}
