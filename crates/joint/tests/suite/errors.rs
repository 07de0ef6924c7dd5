//! What a joint refuses, with the numbers needed to correct it.

use std::sync::Arc;

use stickslip_contact::Chain;
use stickslip_fem_core::{ElasticBody, LoadCase, RigidBody};
use stickslip_joint::{Gauge, Joint, JointBody, JointError, Mark, Options, ProgressiveBody, Pull};

use crate::models::{discount, unbreakable};
use crate::plate::{End, Plate};

fn plate() -> (Plate, Joint) {
    let plate = Plate::default();
    let joint = plate.joint(&unbreakable("[0/90]s"), End::Driven);
    (plate, joint)
}

fn gauge(plate: &Plate) -> Gauge {
    Plate::gauge(&plate.mesh())
}

#[test]
fn a_gauge_names_what_is_there() {
    let (plate, joint) = plate();
    let good = gauge(&plate);
    let direction = good.direction;
    let refused = |gauge: Gauge| {
        Joint::new(joint.bodies().to_vec(), joint.pairs().to_vec(), gauge)
            .unwrap_err()
            .to_string()
    };
    let pull = |pull| Gauge { pull, ..good };
    assert!(refused(pull(Pull::Contact { pair: 3, direction })).contains("pair 3"));
    assert!(refused(pull(Pull::Supports { body: 9 })).contains("body 9"));
    let mark = |body, node| Gauge {
        first: Mark::Node { body, node },
        ..good
    };
    assert!(refused(mark(0, 999_999)).contains("node 999999"));
    assert!(refused(mark(7, 0)).contains("body 7"));
    let nowhere = Gauge {
        direction: [0.0; 2],
        ..good
    };
    assert!(refused(nowhere).contains("direction"));
    let nothing = Gauge {
        multiple: f64::NAN,
        ..good
    };
    assert!(refused(nothing).contains("multiple = NaN"));
}

#[test]
fn options_keep_their_ranges() {
    let (_, joint) = plate();
    let good = *joint.options();
    let bad = [
        Options {
            increments: 0,
            ..good
        },
        Options {
            iterations: 0,
            ..good
        },
        Options {
            smallest_part: 0.0,
            ..good
        },
        Options {
            tolerance: f64::NAN,
            ..good
        },
        Options {
            residual_load: 1.0,
            ..good
        },
        Options {
            residual_stiffness: -0.1,
            ..good
        },
    ];
    for options in bad {
        let refused = joint.clone().with_options(options);
        assert!(
            matches!(refused, Err(JointError::Option { .. })),
            "{options:?}"
        );
    }
}

#[test]
fn load_steps_fit_the_load_cases() {
    let (_, joint) = plate();
    let follow = |steps: &[Vec<f64>]| {
        joint
            .follow(steps, &Chain::newton_first(), |_, _| {})
            .unwrap_err()
            .to_string()
    };
    assert!(follow(&[]).contains("load step 1: missing"));
    assert!(follow(&[vec![0.0], vec![1.0, 2.0]]).contains("load step 2: 2 multipliers for 1"));
    assert!(follow(&[vec![f64::INFINITY]]).contains("inf"));
}

#[test]
fn bodies_share_load_cases_and_have_models() {
    let (plate, joint) = plate();
    let pin = JointBody::Rigid(RigidBody::held(vec![[0.0; 2]], 2));
    let bodies = vec![joint.bodies()[0].clone(), pin];
    let refused = Joint::new(bodies, joint.pairs().to_vec(), gauge(&plate));
    assert!(matches!(
        refused,
        Err(JointError::LoadCases {
            body: 1,
            expected: 1,
            found: 2
        })
    ));

    let JointBody::Progressive(body) = &joint.bodies()[0] else {
        panic!("the plate has a history");
    };
    let few = ProgressiveBody::with_models(Arc::clone(body.body()), &[], Vec::new());
    assert!(matches!(few, Err(JointError::ModelCount { models: 0, .. })));
    let warm = ElasticBody::clone(body.body())
        .with_load_cases(vec![LoadCase {
            initial_strain: vec![[1e-3; 3]; body.body().mesh().blocks().len()],
            ..LoadCase::default()
        }])
        .unwrap();
    let warm = ProgressiveBody::new(Arc::new(warm), &[], body.model(0)).unwrap();
    let bodies = vec![JointBody::Progressive(Arc::new(warm))];
    let refused = Joint::new(
        bodies,
        vec![],
        Gauge {
            pull: Pull::Supports { body: 0 },
            ..gauge(&plate)
        },
    );
    assert!(matches!(
        refused,
        Err(JointError::InitialStrain { body: 0, case: 1 })
    ));
    let infinite = ProgressiveBody::new(Arc::clone(body.body()), &[], body.model(0))
        .unwrap()
        .at_temperature(f64::NAN);
    assert!(matches!(
        infinite,
        Err(JointError::Material { cell: 0, .. })
    ));
}

/// The smallest part of the first increment breaks the plate: there is no load that it bears.
#[test]
fn a_joint_that_bears_nothing_says_so() {
    let joint = Plate::default().joint(&discount("[0/90]s"), End::Loaded);
    let options = Options {
        increments: 1,
        smallest_part: 1.0,
        ..*joint.options()
    };
    let joint = joint.with_options(options).unwrap();
    let refused = joint.follow(&[vec![1e6]], &Chain::newton_first(), |_, _| {});
    match refused {
        Err(JointError::NoStart(_)) => {}
        Err(other) => panic!("{other}"),
        Ok(history) => panic!("{:?}", history.ending),
    }
}
