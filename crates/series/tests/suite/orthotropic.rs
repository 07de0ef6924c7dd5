//! Rigid pin without clearance in an infinite orthotropic plate, with and without friction (table R3).

use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::interface::contract::{Known, check};
use stickslip_fem_core::material::{Isotropic, Orthotropic, OrthotropicConstants, PlaneState};
use stickslip_fem_core::nalgebra::{DMatrix, DVector};
use stickslip_fem_core::{InterfaceOperator, RigidBody};
use stickslip_series::{
    Accuracy, AnisotropicHole, Circle, EdgeLoad, FarLoad, Hole, Nodes, Outline, Plate, SeriesError,
};

use crate::contacts::{follow, problem};

const UNIT: Circle = Circle {
    centre: [0.0, 0.0],
    radius: 1.0,
    thickness: 1.0,
};

fn plate() -> Orthotropic {
    let constants = OrthotropicConstants {
        e1: 12_400.0,
        e2: 3730.0,
        g12: 3210.0,
        nu12: 0.66,
    };
    Orthotropic::new(constants, 0.0).unwrap()
}

/// θ `[deg]`, σ_r and σ_θ over P/2Rt without friction: a spectral solution, 4 to 5 digits away from the end of contact at 81.62°.
const FRICTIONLESS: [[f64; 3]; 8] = [
    [0.0, -1.48252, 0.26067],
    [20.0, -1.26712, 0.32524],
    [45.0, -0.76132, 0.44967],
    [60.0, -0.50136, 0.48185],
    [75.0, -0.24921, 0.62335],
    [90.0, 0.0, 0.96280],
    [105.0, 0.0, 0.70116],
    [135.0, 0.0, 0.15345],
];

/// The same at μ = 0.2, and the shear; node-wise solutions of two spacings.
const WITH_FRICTION: [[f64; 4]; 7] = [
    [15.0, -1.14125, 0.10105, 0.22825],
    [30.0, -1.01805, 0.26138, 0.20361],
    [45.0, -0.78076, 0.42396, 0.15615],
    [60.0, -0.53913, 0.54871, 0.10783],
    [75.0, -0.30473, 0.70784, 0.06095],
    [90.0, 0.0, 1.05016, 0.0],
    [135.0, 0.0, 0.14219, 0.0],
];

/// Numbers of nodes, and bounds of the errors over P/2Rt: second order, as near as 7° to the end of contact.
const BOUNDS: [(usize, f64); 2] = [(121, 6e-4), (241, 1.5e-4)];

/// Stresses over P/2Rt on the edge at `angles` `[deg]`: radial, hoop, shear.
fn stresses(count: usize, friction: f64, angles: impl Iterator<Item = f64>) -> Vec<[f64; 3]> {
    let nodes = Nodes::uniform_half(count).unwrap();
    let hole = AnisotropicHole::held(nodes.clone(), &plate(), UNIT, &[FarLoad::default()]).unwrap();
    // P = 2 on the whole is 1 on the half.
    let pin = RigidBody::sliding(hole.points().to_vec(), [true, false], &[[1.0, 0.0]]);
    let problem = problem(&hole, &pin, &nodes, 1.0, 0.0, friction);
    let states = follow(&problem, vec![vec![1.0]], 1);
    let forces = problem.forces_on_body(0, nodes.len(), &states[0].forces);
    let state = BodyLoad {
        forces: &forces,
        multipliers: &[1.0],
        motions: &[],
    };
    let edge = hole.edge(&state).unwrap();
    angles
        .map(|angle| {
            let s = edge.at(angle.to_radians());
            [s.radial, s.hoop, s.shear]
        })
        .collect()
}

#[test]
fn a_rigid_pin_without_friction() {
    for (count, bound) in BOUNDS {
        let found = stresses(count, 0.0, FRICTIONLESS.iter().map(|row| row[0]));
        for (row, found) in FRICTIONLESS.iter().zip(found) {
            let errors = [found[0] - row[1], found[1] - row[2], found[2]];
            assert!(
                errors.iter().all(|error| error.abs() < bound),
                "{}°: {errors:?}",
                row[0]
            );
        }
    }
}

#[test]
fn a_rigid_pin_with_friction() {
    for (count, bound) in BOUNDS {
        let found = stresses(count, 0.2, WITH_FRICTION.iter().map(|row| row[0]));
        for (row, found) in WITH_FRICTION.iter().zip(found) {
            let errors = [
                found[0] - row[1],
                found[1] - row[2],
                found[2].abs() - row[3],
            ];
            assert!(
                errors.iter().all(|error| error.abs() < bound),
                "{}°: {errors:?}",
                row[0]
            );
        }
    }
}

/// σ_θ over the far stress along 1 (table R5 of Lekhnitskii's closed form), seven digits.
#[test]
fn an_open_hole_has_the_stresses_of_the_closed_form() {
    let pull = FarLoad {
        stress: [1.0, 0.0, 0.0],
        ..FarLoad::default()
    };
    let nodes = Nodes::uniform_circle(9).unwrap();
    let hole = AnisotropicHole::held(nodes, &plate(), UNIT, &[pull]).unwrap();
    let state = BodyLoad {
        forces: &[0.0; 18],
        multipliers: &[1.0],
        motions: &[],
    };
    let edge = hole.edge(&state).unwrap();
    for (angle, expected) in [
        (0.0_f64, -0.5484582),
        (35.0, -0.0350682),
        (60.0, 1.7321202),
        (90.0, 3.4878734),
        (150.0, -0.2056643),
    ] {
        let found = edge.at(angle.to_radians()).hoop;
        assert!((found - expected).abs() < 1e-7, "{angle}: {found}");
    }
}

/// An isotropic plate is the same by either description, and operators keep the contract.
#[test]
fn both_descriptions_of_an_isotropic_plate_agree() {
    let material = Isotropic::new(3.0, 0.3, PlaneState::Strain).unwrap();
    for nodes in [
        Nodes::uniform_half(13).unwrap(),
        Nodes::arc(vec![0.1, 0.2, 0.5, 0.9, 1.0]).unwrap(),
    ] {
        let skew = if nodes.is_mirrored() { 0.0 } else { 1.0 };
        let far = FarLoad {
            stress: [1.0, -0.3, 0.4 * skew],
            ..FarLoad::default()
        };
        let own = Hole::floating(nodes.clone(), &material, UNIT, &[far]).unwrap();
        let other = AnisotropicHole::floating(nodes.clone(), &material, UNIT, &[far]).unwrap();
        let difference = own.compliance().unwrap() - other.compliance().unwrap();
        assert!(difference.amax() < 1e-14);
        let difference = own.load_response(0).unwrap() - other.load_response(0).unwrap();
        assert!(difference.amax() < 1e-14);
        let forces = DVector::from_fn(2 * nodes.len(), |row, _| (row % 5) as f64 - 1.0);
        let motions = vec![0.0; own.modes().ncols()];
        let state = BodyLoad {
            forces: forces.as_slice(),
            multipliers: &[0.5],
            motions: &motions,
        };
        let (field, edge) = (own.field(&state).unwrap(), other.edge(&state).unwrap());
        for theta in [0.15, 0.4, 0.7, 2.0, 5.0] {
            let (a, b) = (field.edge(theta), edge.at(theta));
            assert!(
                (a.hoop - b.hoop).abs() < 1e-12 * (1.0 + a.hoop.abs()),
                "{theta}"
            );
        }
    }
    let turned = Orthotropic::new(plate().constants(), 0.4).unwrap();
    let nodes = Nodes::uniform_circle(20).unwrap();
    let hole = AnisotropicHole::floating(nodes, &turned, UNIT, &[FarLoad::default()]).unwrap();
    let known = Known {
        placed: true,
        resultants: &[],
    };
    assert_eq!(check(&hole, known), Ok(()));
    let half = Nodes::uniform_half(9).unwrap();
    let refused = AnisotropicHole::held(half, &turned, UNIT, &[]).unwrap_err();
    assert!(matches!(
        refused,
        SeriesError::Material { what } if what.starts_with("does not mirror itself")
    ));
}

const FAR: Accuracy = Accuracy {
    tolerance: 1e-4,
    degree: 60,
};

/// Compliance of balanced forces: what a plate's own way of floating leaves out.
fn balanced(operator: &dyn InterfaceOperator, nodes: &Nodes) -> DMatrix<f64> {
    let modes = operator.modes();
    let mut weighted = modes.clone();
    for (node, weight) in nodes.weights().into_iter().enumerate() {
        weighted.rows_mut(2 * node, 2).scale_mut(weight);
    }
    let gram = weighted.tr_mul(modes).try_inverse().unwrap();
    let size = modes.nrows();
    let projector = DMatrix::identity(size, size) - modes * (gram * weighted.transpose());
    &projector * operator.compliance().unwrap() * projector.transpose()
}

/// Far edges do what no edges do, and pull a free hole as a far stress does.
#[test]
fn a_plate_with_far_edges_is_an_infinite_one() {
    for (angle, nodes) in [
        (0.0, Nodes::uniform_half(31).unwrap()),
        (0.5, Nodes::uniform_circle(60).unwrap()),
    ] {
        let layer = Orthotropic::new(plate().constants(), angle).unwrap();
        let half = 300.0;
        let outline = Outline::strip(half, half, half);
        let pull = [1, 3].map(|edge| EdgeLoad {
            edge,
            force: [if edge == 1 { 2.0 * half } else { -2.0 * half }, 0.0],
        });
        let far = FarLoad {
            stress: [1.0, 0.0, 0.0],
            ..FarLoad::default()
        };
        let own = Plate::anisotropic(nodes.clone(), &layer, UNIT, &outline, &[pull.to_vec()], FAR);
        let own = own.unwrap();
        let other = AnisotropicHole::floating(nodes.clone(), &layer, UNIT, &[far]).unwrap();
        let [found, expected] =
            [&own as &dyn InterfaceOperator, &other].map(|operator| balanced(operator, &nodes));
        // The edge reflects what the hole sends there, (R/d)².
        assert!((&found - &expected).amax() < 1e-4 * expected.amax());
        let state = BodyLoad {
            forces: &vec![0.0; 2 * nodes.len()],
            multipliers: &[1.0],
            motions: &vec![0.0; own.modes().ncols()],
        };
        let (field, edge) = (own.field(&state).unwrap(), other.edge(&state).unwrap());
        for theta in [0.1, 0.9, 1.6, 2.4, 3.0] {
            let (a, b) = (field.edge(theta).hoop, edge.at(theta).hoop);
            assert!((a - b).abs() < 3e-4, "{theta}: {a} {b}");
        }
    }
}

/// A plate whose two moduli differ by little is nearly the isotropic one, though its planes nearly are one.
#[test]
fn nearly_isotropic_plates_lose_few_digits() {
    let nodes = Nodes::uniform_half(25).unwrap();
    let outline = Outline::strip(3.0, 6.0, 2.5);
    let loads = [vec![EdgeLoad {
        edge: 1,
        force: [1.0, 0.0],
    }]];
    let isotropic = Isotropic::new(2.6, 0.3, PlaneState::Stress).unwrap();
    let expected = Plate::new(nodes.clone(), &isotropic, UNIT, &outline, &loads, FAR).unwrap();
    for part in [1e-2, 1e-4, 1e-6, 1e-8] {
        let constants = OrthotropicConstants {
            e1: 2.6 * (1.0 + part),
            e2: 2.6,
            g12: 1.0,
            nu12: 0.3,
        };
        let layer = Orthotropic::new(constants, 0.0).unwrap();
        let found = Plate::anisotropic(nodes.clone(), &layer, UNIT, &outline, &loads, FAR).unwrap();
        let size = expected.compliance().unwrap().amax();
        let difference = found.compliance().unwrap() - expected.compliance().unwrap();
        assert!(difference.amax() < (2.0 * part + 1e-6) * size, "{part}");
        let difference = found.load_response(0).unwrap() - expected.load_response(0).unwrap();
        assert!(difference.amax() < (2.0 * part + 1e-6) * size, "{part}");
    }
    let refused = Plate::anisotropic(nodes, &isotropic, UNIT, &outline, &loads, FAR).unwrap_err();
    assert!(matches!(
        refused,
        SeriesError::Material { what } if what.contains("or is isotropic")
    ));
}

/// A plate that is turned with its material, its outline and its load moves as it did.
#[test]
fn turned_plates_are_the_same() {
    let count = 48;
    let nodes = Nodes::uniform_circle(count).unwrap();
    let corners = [[-3.0, -2.5], [6.0, -2.5], [6.0, 2.5], [-3.0, 2.5]];
    let made = |steps: usize| {
        let angle = std::f64::consts::TAU * steps as f64 / count as f64;
        let (sin, cos) = angle.sin_cos();
        let turn = |[x, y]: [f64; 2]| [x * cos - y * sin, x * sin + y * cos];
        let layer = Orthotropic::new(plate().constants(), angle).unwrap();
        let outline = Outline::new(corners.map(turn).to_vec());
        let force = turn([1.0, 0.3]);
        let loads = [vec![EdgeLoad { edge: 1, force }]];
        let made = Plate::anisotropic(nodes.clone(), &layer, UNIT, &outline, &loads, FAR).unwrap();
        let response = made.load_response(0).unwrap().clone();
        let back = |node: usize| {
            let own = (node + steps) % count;
            let [x, y] = [response[2 * own], response[2 * own + 1]];
            [x * cos + y * sin, y * cos - x * sin]
        };
        (0..count).map(back).collect::<Vec<_>>()
    };
    let expected = made(0);
    let size = expected
        .iter()
        .flatten()
        .fold(0.0_f64, |a, b| a.max(b.abs()));
    for steps in [6, 12, 17] {
        for (a, b) in made(steps).iter().zip(&expected) {
            for axis in 0..2 {
                assert!(
                    (a[axis] - b[axis]).abs() < 1e-5 * size,
                    "{steps} {a:?} {b:?}"
                );
            }
        }
    }
}
