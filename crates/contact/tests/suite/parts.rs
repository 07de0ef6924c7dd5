//! Contacts that share no body that gives or moves: each as it is alone, at costs that add up.

use nalgebra::{DMatrix, DVector};
use stickslip_contact::interface::{Group, groups};
use stickslip_contact::{
    Chain, ContactError, ContactPair, ContactPoint, Interface, InterfaceProblem, Kinematics,
    LoadHistory, Ramp, StepRecord,
};
use stickslip_fem_core::{GivenBody, InterfaceOperator, RigidBody};

use crate::coulomb;

/// Held elastic bodies of two points, and rigid blocks pushed against them along x and pulled along y by the load cases times
/// `loads[k]`: first all elastic bodies, then all blocks, then one held wall that stands behind every elastic body's second point.
struct Blocks {
    elastic: Vec<GivenBody>,
    pushed: Vec<RigidBody>,
    wall: RigidBody,
}

impl Blocks {
    fn new(loads: &[f64]) -> Self {
        let compliance = DMatrix::from_row_slice(
            4,
            4,
            &[
                2.0, 0.1, 0.3, 0.0, 0.1, 0.5, 0.0, 0.1, 0.3, 0.0, 1.0, 0.2, 0.0, 0.1, 0.2, 0.5,
            ],
        );
        let elastic = GivenBody::held(compliance, vec![DVector::zeros(4); 2]).unwrap();
        let places = elastic.points().to_vec();
        let block = |load: &f64| {
            RigidBody::sliding(places.clone(), [true, true], &[[*load, 0.0], [0.0, *load]])
        };
        Self {
            elastic: vec![elastic.clone(); loads.len()],
            pushed: loads.iter().map(block).collect(),
            wall: RigidBody::held(places.clone(), 2),
        }
    }

    fn bodies(&self) -> Vec<&dyn InterfaceOperator> {
        let elastic = self
            .elastic
            .iter()
            .map(|body| body as &dyn InterfaceOperator);
        let blocks = self
            .pushed
            .iter()
            .map(|body| body as &dyn InterfaceOperator);
        let wall = &self.wall as &dyn InterfaceOperator;
        elastic.chain(blocks).chain([wall]).collect()
    }

    /// First the pairs with the wall, then those with the blocks, the last one first.
    fn pairs(&self) -> Vec<ContactPair> {
        let count = self.elastic.len();
        let point = |index: usize, normal: [f64; 2], gap: f64| ContactPoint {
            first: index.into(),
            second: index.into(),
            normal,
            gap,
            area: 1.0,
            material_angle: 0.0,
        };
        let walls = (0..count).map(|k| ContactPair {
            name: format!("wall {k}"),
            origin: [0.0; 2],
            first: k,
            second: 2 * count,
            points: vec![point(1, [-1.0, 0.0], 0.02)],
            law: coulomb(0.1),
        });
        let blocks = (0..count).rev().map(|k| ContactPair {
            name: format!("block {k}"),
            origin: [0.0; 2],
            first: k,
            second: count + k,
            points: vec![point(0, [1.0, 0.0], 0.1), point(1, [1.0, 0.0], 0.2)],
            law: coulomb(0.3),
        });
        walls.chain(blocks).collect()
    }

    fn interface(&self) -> Interface {
        Interface::new(&self.bodies(), self.pairs()).unwrap()
    }
}

fn history(steps: &[[f64; 2]]) -> LoadHistory {
    let steps = steps.iter().map(|step| step.to_vec()).collect();
    LoadHistory::new(steps, 2, Ramp::Linear).unwrap()
}

/// The records of the blocks under `load` alone.
fn alone(load: f64, steps: &[[f64; 2]]) -> Result<Vec<StepRecord>, ContactError> {
    let blocks = Blocks::new(&[load]);
    let problem = InterfaceProblem::new(&blocks.bodies(), blocks.pairs()).unwrap();
    history(steps).follow(&problem, &Chain::default(), |_| {})
}

#[test]
fn bodies_that_give_or_move_link_their_contacts() {
    let group = |bodies: &[usize], pairs: &[usize]| Group {
        bodies: bodies.to_vec(),
        pairs: pairs.to_vec(),
    };
    // The ground, 2, passes nothing on from 0 to 1; body 5 links 3 with 4; 6 touches nothing.
    let links = [true, true, false, true, true, true, true];
    let pairs = [[0, 2], [2, 1], [3, 5], [5, 4]];
    assert_eq!(
        groups(&links, &pairs, &[]),
        [
            group(&[0, 2], &[0]),
            group(&[1, 2], &[1]),
            group(&[3, 4, 5], &[2, 3]),
            group(&[6], &[]),
        ]
    );
    assert_eq!(groups(&[false; 2], &[[0, 1]], &[]), [group(&[0, 1], &[0])]);
}

#[test]
fn entries_grow_with_the_number_of_parts() {
    let entries = |count: usize| Blocks::new(&vec![1.0; count]).interface().entries();
    // Three points and two rigid motions each.
    assert_eq!(entries(1), 36 + 12);
    assert_eq!(entries(100), 100 * entries(1));
    let one = Blocks::new(&[1.0]);
    let problem = InterfaceProblem::new(&one.bodies(), one.pairs()).unwrap();
    assert_eq!(Interface::from(problem).entries(), entries(1));
}

/// Loads that differ by four orders of size: every number of every part is that of the part alone, to the last bit.
#[test]
fn parts_walk_as_each_does_alone() {
    let loads = [1.0, 0.37, 1e-4, 2.5];
    let steps = [[0.3, 0.0], [0.3, 0.05], [0.2, -0.04]];
    let blocks = Blocks::new(&loads);
    let interface = blocks.interface();
    assert_eq!(interface.parts().len(), loads.len());
    let mut seen = 0;
    let together = history(&steps)
        .follow_parts(&interface, &Kinematics::Small, &Chain::default(), || {
            seen += 1;
        })
        .unwrap();
    assert_eq!((seen, together.len()), (3, 3));
    for (k, &load) in loads.iter().enumerate() {
        for (whole, alone) in together.iter().zip(alone(load, &steps).unwrap()) {
            // Its wall and its block, which the other way round come first.
            let contacts = interface.contacts();
            let (wall, block) = (k, 2 * loads.len() - 1 - k);
            let points = contacts
                .pair_points(wall)
                .chain(contacts.pair_points(block));
            for (own, point) in points.enumerate() {
                for component in 0..2 {
                    let (at, here) = (2 * point + component, 2 * own + component);
                    assert_eq!(whole.state.forces[at], alone.state.forces[here]);
                    assert_eq!(whole.state.motion[at], alone.state.motion[here]);
                }
                assert_eq!(whole.state.status[point], alone.state.status[own]);
                assert_eq!(whole.state.history[point], alone.state.history[own]);
                assert_eq!(whole.slip[point], alone.slip[own]);
            }
            let modes = interface.body_modes(loads.len() + k);
            assert_eq!(whole.state.rigid.rows_range(modes), alone.state.rigid);
            assert_eq!(whole.audit.pairs[block], alone.audit.pairs[1]);
            let balance = &whole.audit.bodies[k];
            assert_eq!(balance.body, loads.len() + k);
            assert_eq!(balance.relative, alone.audit.bodies[0].relative);
            assert_eq!(whole.parts[k].work, alone.work);
            assert_eq!(whole.parts[k].uniqueness, alone.uniqueness);
        }
    }
    let forces = interface.forces_on_body(2 * loads.len(), 2, &together[0].state.forces);
    let first: f64 = (0..loads.len())
        .map(|k| together[0].state.forces[2 * k])
        .sum();
    assert!((forces[2] - first).abs() <= 1e-15 * first, "{forces:?}");
}

/// The second part's friction ends at half of the pull that the others can bear.
#[test]
fn a_history_ends_with_the_part_that_ends_first() {
    let steps = [[0.3, 0.0], [0.3, 0.12]];
    let loads = |pulls: [f64; 3]| {
        let mut blocks = Blocks::new(&[1.0; 3]);
        for (block, pull) in blocks.pushed.iter_mut().zip(pulls) {
            let places = block.points().to_vec();
            *block = RigidBody::sliding(places, [true, true], &[[1.0, 0.0], [0.0, pull]]);
        }
        blocks.interface()
    };
    let failure = |interface: &Interface| {
        let mut seen = 0;
        let error = history(&steps)
            .follow_parts(interface, &Kinematics::Small, &Chain::default(), || {
                seen += 1;
            })
            .unwrap_err();
        let ContactError::StepFailed {
            step,
            reached,
            bodies,
            cause,
        } = error
        else {
            panic!("{error}");
        };
        assert_eq!((seen, step), (1, 1));
        assert!(cause.is_proved_impossible(), "{cause}");
        (bodies, reached)
    };
    let held = history(&steps).follow_parts(
        &loads([0.5; 3]),
        &Kinematics::Small,
        &Chain::default(),
        || {},
    );
    assert!(held.is_ok());
    let (bodies, reached) = failure(&loads([0.5, 1.5, 0.5]));
    assert_eq!(bodies, [1, 4, 6]);
    assert!((reached - 0.5).abs() < 1e-2, "{reached}");
    let (bodies, earlier) = failure(&loads([1.5, 0.5, 3.0]));
    assert_eq!(bodies, [2, 5, 6]);
    assert!((earlier - 0.25).abs() < 1e-2, "{earlier}");
}
