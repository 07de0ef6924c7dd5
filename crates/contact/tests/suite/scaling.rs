//! The same problem in other units: lengths, forces and compliances scaled.

use nalgebra::{DMatrix, DVector};
use stickslip_contact::{
    Chain, ContactPair, ContactPoint, InterfaceProblem, InterfaceSolver, LoadHistory, Pivoting,
    Ramp, SemismoothNewton, StepRecord,
};
use stickslip_fem_core::{GivenBody, RigidBody};

use crate::coulomb;

const COUNT: usize = 16;

/// An elastic disk that floats in a held hole with clearance, pressed against it. Lengths are `length` times, forces `force` times
/// those of the disk with a compliance near one.
pub(crate) fn disk(length: f64, force: f64) -> InterfaceProblem {
    let give = length / force;
    let normals: Vec<[f64; 2]> = (0..COUNT)
        .map(|k| k as f64 * std::f64::consts::TAU / COUNT as f64)
        .map(|angle| [angle.cos(), angle.sin()])
        .collect();
    let compliance = DMatrix::from_fn(2 * COUNT, 2 * COUNT, |row, column| {
        let apart = (row / 2).abs_diff(column / 2);
        let near = 0.5_f64.powi(apart.min(COUNT - apart) as i32);
        let same = f64::from(u8::from(row % 2 == column % 2));
        give * near * (same + if apart == 0 { 0.0 } else { 0.05 })
    });
    let motions = DMatrix::from_fn(2 * COUNT, 3, |row, motion| {
        let [x, y] = normals[row / 2];
        [[1.0, 0.0, -y], [0.0, 1.0, x]][row % 2][motion]
    });
    let load = |x: f64, y: f64| DVector::from_vec(vec![force * x, force * y, 0.0]);
    let disk = GivenBody::floating(
        compliance,
        motions,
        vec![DVector::zeros(2 * COUNT); 2],
        vec![load(1.0, 0.1), load(0.2, 1.0)],
    )
    .unwrap();
    let hole = RigidBody::held(normals.clone(), 2);
    let points = normals.iter().enumerate().map(|(k, &normal)| ContactPoint {
        first: k.into(),
        second: k.into(),
        normal,
        gap: 0.25 * length,
        area: length * length,
        material_angle: 0.0,
    });
    let pair = ContactPair {
        name: "hole".into(),
        first: 0,
        second: 1,
        points: points.collect(),
        law: coulomb(0.3),
    };
    InterfaceProblem::new(&[&hole, &disk], vec![pair]).unwrap()
}

fn follow(problem: &InterfaceProblem, solver: &dyn InterfaceSolver) -> Vec<StepRecord> {
    let steps = vec![vec![-1.0, 0.0], vec![-2.0, -1.0], vec![-0.5, -0.5]];
    let history = LoadHistory::new(steps, 2, Ramp::Linear).unwrap();
    history.follow(problem, solver, |_| {}).unwrap()
}

fn solvers() -> [Box<dyn InterfaceSolver>; 3] {
    [
        Box::new(Chain::default()),
        Box::new(SemismoothNewton::default()),
        Box::new(Pivoting::default()),
    ]
}

fn close(one: &DVector<f64>, other: &DVector<f64>, scale: f64) -> bool {
    (one * scale - other).amax() <= 1e-11 * other.amax()
}

/// Units change nothing but the units, over twelve decades of each.
#[test]
fn units_change_no_answer() {
    for solver in solvers() {
        let reference = follow(&disk(1.0, 1.0), solver.as_ref());
        for (length, force) in [
            (1e-6, 1.0),
            (1e6, 1.0),
            (1.0, 1e-6),
            (1.0, 1e6),
            (3e-6, 7e6),
            (3e6, 7e-6),
        ] {
            let scaled = follow(&disk(length, force), solver.as_ref());
            for (one, other) in reference.iter().zip(&scaled) {
                let same = one.state.status == other.state.status
                    && close(&one.state.forces, &other.state.forces, force)
                    && close(&one.state.motion, &other.state.motion, length);
                assert!(same, "{} {length} {force}", solver.name());
                assert_eq!(
                    (one.cutbacks, &one.solvers),
                    (other.cutbacks, &other.solvers)
                );
            }
        }
    }
}

/// Powers of two change no digit.
#[test]
fn powers_of_two_change_no_bit() {
    for solver in solvers() {
        let reference = follow(&disk(1.0, 1.0), solver.as_ref());
        for (length, force) in [(20, 0), (-20, 0), (0, 20), (0, -20), (17, -13)] {
            let [length, force] = [length, force].map(|power| 2.0_f64.powi(power));
            let scaled = follow(&disk(length, force), solver.as_ref());
            for (one, other) in reference.iter().zip(&scaled) {
                assert_eq!(one.state.status, other.state.status);
                assert_eq!(&one.state.forces * force, other.state.forces);
                assert_eq!(&one.state.motion * length, other.state.motion);
                assert_eq!(one.work, other.work);
            }
        }
    }
}
