//! The same problem in other units: lengths, forces and compliances scaled.

use nalgebra::{DMatrix, DVector};
use stickslip_contact::{
    Chain, ContactPair, ContactPoint, InterfaceProblem, InterfaceSolver, LoadHistory, Pivoting,
    Ramp, SemismoothNewton, StepRecord,
};
use stickslip_fem_core::{GivenBody, RigidBody};

use crate::coulomb;

pub(crate) const COUNT: usize = 16;

/// A disk that floats in a held hole, and the units that it is written in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Disk {
    /// Unit of length: lengths are so many times those of the disk of radius 1.
    pub(crate) length: f64,
    /// Unit of force, likewise; compliances are near length/force.
    pub(crate) force: f64,
    /// Arm by which turns are counted: they move the rim by the radius over the arm. A turn in radians has an arm of 1, whatever the
    /// unit of length.
    pub(crate) arm: f64,
    /// Clearance, in radii.
    pub(crate) gap: f64,
    /// Friction coefficient.
    pub(crate) mu: f64,
    /// Force along x and y and moment of two load cases, for unit length and force.
    pub(crate) loads: [[f64; 3]; 2],
}

impl Disk {
    /// The interface problem, first body the hole.
    pub(crate) fn problem(&self) -> InterfaceProblem {
        let (length, force) = (self.length, self.force);
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
        let turn = length / self.arm;
        let motions = DMatrix::from_fn(2 * COUNT, 3, |row, motion| {
            let [x, y] = normals[row / 2];
            [[1.0, 0.0, -y * turn], [0.0, 1.0, x * turn]][row % 2][motion]
        });
        let load = |[x, y, moment]: [f64; 3]| {
            DVector::from_vec(vec![force * x, force * y, force * moment * turn])
        };
        let disk = GivenBody::floating(
            compliance,
            motions,
            vec![DVector::zeros(2 * COUNT); 2],
            self.loads.map(load).to_vec(),
        )
        .unwrap();
        let hole = RigidBody::held(normals.clone(), 2);
        let points = normals.iter().enumerate().map(|(k, &normal)| ContactPoint {
            first: k.into(),
            second: k.into(),
            normal,
            gap: self.gap * length,
            area: length * length,
            material_angle: 0.0,
        });
        let pair = ContactPair {
            name: "hole".into(),
            origin: [0.0; 2],
            first: 0,
            second: 1,
            points: points.collect(),
            law: coulomb(self.mu),
        };
        InterfaceProblem::new(&[&hole, &disk], vec![pair]).unwrap()
    }
}

/// An elastic disk that floats in a held hole with clearance, pressed against it. Lengths are `length` times, forces `force` times
/// those of the disk with a compliance near one; its turn is counted along the rim.
pub(crate) fn disk(length: f64, force: f64) -> InterfaceProblem {
    let disk = Disk {
        length,
        force,
        arm: length,
        gap: 0.25,
        mu: 0.3,
        loads: [[1.0, 0.1, 0.0], [0.2, 1.0, 0.0]],
    };
    disk.problem()
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
