//! The contract of interface operators, over bodies drawn at random.

use std::f64::consts::PI;

use proptest::prelude::*;
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::interface::contract::{Known, check};
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_fem_core::nalgebra::{DMatrix, DVector};
use stickslip_series::{
    Accuracy, Anchor, Circle, Disk, DiskLoad, EdgeLoad, FarLoad, Ground, HalfPlane, Hole, Lies,
    LineNodes, Nodes, Outline, Plate, SeriesError,
};

/// Angles on 0 to `end` whose spacings differ by up to a factor of 100.
fn angles(end: f64) -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(0.0..1.0_f64, 16..32).prop_map(move |parts| {
        let lengths: Vec<f64> = parts.iter().map(|part| 0.01_f64.powf(*part)).collect();
        let total: f64 = lengths.iter().sum();
        let mut sum = 0.0;
        let mut found = vec![0.0];
        for length in lengths {
            sum += length * end / total;
            found.push(sum.min(end));
        }
        found
    })
}

fn nodes() -> impl Strategy<Value = Nodes> {
    let some = |found: Result<Nodes, SeriesError>| found.ok();
    prop_oneof![
        (8..40_usize).prop_map(Nodes::uniform_circle),
        (5..40_usize).prop_map(Nodes::uniform_half),
        angles(2.0).prop_map(Nodes::arc),
        angles(PI).prop_map(Nodes::mirrored),
        angles(2.5).prop_map(Nodes::mirrored),
    ]
    .prop_filter_map("spacings", some)
}

fn material() -> impl Strategy<Value = Isotropic> {
    let state = prop_oneof![Just(PlaneState::Stress), Just(PlaneState::Strain)];
    (0.1..10.0_f64, -0.9..0.49_f64, state)
        .prop_map(|(young, poisson, state)| Isotropic::new(young, poisson, state).unwrap())
}

fn circle() -> impl Strategy<Value = Circle> {
    (-3.0..3.0_f64, 0.01..100.0_f64, 0.1..10.0_f64).prop_map(|(x, radius, thickness)| Circle {
        centre: [x, 0.0],
        radius,
        thickness,
    })
}

fn anchor() -> impl Strategy<Value = Anchor> {
    prop_oneof![
        Just(Anchor::Area),
        (1e-6..0.25_f64).prop_map(|circle| Anchor::Centre { circle }),
    ]
}

/// Force along x and y and moment about the origin, of the half in a half model.
fn resultant(nodes: &Nodes, circle: Circle, force: [f64; 2], moment: f64) -> [f64; 3] {
    let part = if nodes.is_mirrored() { 0.5 } else { 1.0 };
    [force[0], force[1], moment + circle.centre[0] * force[1]].map(|value| part * value)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn bodies_keep_the_contract(
        nodes in nodes(),
        material in material(),
        circle in circle(),
        anchor in anchor(),
        values in prop::array::uniform6(-5.0..5.0_f64),
    ) {
        let [fx, fy, moment, xx, yy, xy] = values;
        let skew = if nodes.is_mirrored() { 0.0 } else { 1.0 };
        let (force, moment) = ([fx, skew * fy], skew * moment);
        let far = FarLoad { force, moment, stress: [xx, yy, skew * xy] };
        let resultants = [resultant(&nodes, circle, force, moment)];
        let known = Known { placed: true, resultants: &resultants };
        let plate = Hole::floating(nodes.clone(), &material, circle, &[far]).unwrap();
        prop_assert_eq!(check(&plate, known), Ok(()));
        let push = DiskLoad { force, moment, ..DiskLoad::default() };
        let pin = Disk::floating(nodes.clone(), &material, circle, anchor, &[push]).unwrap();
        prop_assert_eq!(check(&pin, known), Ok(()));

        let placed = Known { placed: true, resultants: &[] };
        let stress = FarLoad { stress: far.stress, ..FarLoad::default() };
        let plate = Hole::held(nodes.clone(), &material, circle, &[stress]).unwrap();
        prop_assert_eq!(check(&plate, placed), Ok(()));
        let pin = Disk::held(nodes, &material, circle, anchor, &[]).unwrap();
        prop_assert_eq!(check(&pin, placed), Ok(()));
    }

    /// A plate of four corners around the hole, or a strip around it.
    #[test]
    fn plates_keep_the_contract(
        nodes in nodes(),
        material in material(),
        circle in circle(),
        reach in prop::array::uniform4(2.0..4.0_f64),
        force in prop::array::uniform2(-5.0..5.0_f64),
    ) {
        let [a, b, c, d] = reach;
        let [x, y] = circle.centre;
        let place = |[px, py]: [f64; 2]| [x + circle.radius * px, y + circle.radius * py];
        let corners = if nodes.is_mirrored() {
            [[-a, -c], [b, -c], [b, c], [-a, c]]
        } else {
            [[-a, -b], [b, -c], [c, d], [-d, a]]
        };
        let outline = Outline::new(corners.map(place).to_vec());
        let skew = if nodes.is_mirrored() { 0.0 } else { 1.0 };
        let force = [force[0], skew * force[1]];
        let loads = [vec![EdgeLoad { edge: 1, force }]];
        let [start, end] = outline.edge(1);
        let middle = [0.5 * (start[0] + end[0]), 0.5 * (start[1] + end[1])];
        let moment = skew * (middle[0] * force[1] - middle[1] * force[0]);
        let part = if nodes.is_mirrored() { 0.5 } else { 1.0 };
        let resultants = [[part * force[0], part * force[1], moment]];
        let known = Known { placed: true, resultants: &resultants };
        let coarse = Accuracy { tolerance: 0.05, degree: 58 };
        let plate = Plate::new(nodes, &material, circle, &outline, &loads, coarse).unwrap();
        prop_assert_eq!(check(&plate, known), Ok(()));
    }

    /// The reference length is beyond that of the edge, as the compliance of a net force has to be positive.
    #[test]
    fn half_planes_keep_the_contract(
        offsets in angles(2.0),
        material in material(),
        lies in prop_oneof![Just(Lies::Below), Just(Lies::Above)],
        mirrored in any::<bool>(),
        force in prop::array::uniform2(-5.0..5.0_f64),
    ) {
        let nodes = if mirrored { LineNodes::mirrored(offsets) } else { LineNodes::whole(offsets) };
        let free = [!mirrored, true];
        let ground = Ground { lies, thickness: 1.7, reference: 4.0, free };
        let force = [if mirrored { 0.0 } else { force[0] }, force[1]];
        let body = HalfPlane::new(nodes.unwrap(), &material, ground, &[force]).unwrap();
        // It does not turn, so that moments are not balanced.
        prop_assert_eq!(check(&body, Known::default()), Ok(()));
    }

    /// A plane body of another size has the same compliance, one of another stiffness or thickness its inverse.
    #[test]
    fn compliance_scales(nodes in nodes(), material in material(), factor in 0.01..100.0_f64) {
        let unit = Circle { centre: [0.0, 0.0], radius: 1.0, thickness: 1.0 };
        let stiffer =
            Isotropic::new(factor * material.young(), material.poisson(), material.state()).unwrap();
        let scaled = Circle { centre: [1.0, 0.0], radius: factor, thickness: factor };
        let of = |material, circle| {
            let pin = Disk::held(nodes.clone(), material, circle, Anchor::default(), &[]).unwrap();
            pin.compliance().unwrap().clone()
        };
        let own = of(&material, unit);
        let other = of(&stiffer, scaled) * (factor * factor);
        prop_assert!((&own - other).amax() < 1e-13 * own.amax());
    }

    /// All nodes turned by an angle: forces and displacements turn with them.
    #[test]
    fn compliance_turns(offsets in angles(2.0), material in material(), turn in -3.0..3.0_f64) {
        let Ok(first) = Nodes::arc(offsets.clone()) else { return Ok(()) };
        let second = Nodes::arc(offsets.iter().map(|angle| angle + turn).collect()).unwrap();
        let unit = Circle { centre: [0.0, 0.0], radius: 1.0, thickness: 1.0 };
        let (sin, cos) = turn.sin_cos();
        let count = 2 * first.len();
        let turned = DMatrix::from_fn(count, count, |row, column| match (row / 2 == column / 2, row % 2, column % 2) {
            (true, 0, 0) | (true, 1, 1) => cos,
            (true, 0, 1) => -sin,
            (true, 1, 0) => sin,
            _ => 0.0,
        });
        let of = |nodes: Nodes| {
            let pin = Disk::held(nodes, &material, unit, Anchor::default(), &[]).unwrap();
            pin.compliance().unwrap().clone()
        };
        let (own, other) = (of(first), of(second));
        let back = turned.transpose() * other * &turned;
        // Angles are rounded by 1e-15, spacings of 1e-3 by 1e-12.
        prop_assert!((&own - back).amax() < 1e-11 * own.amax());
    }

    /// A half model is a whole one under loads with their images.
    #[test]
    fn a_half_model_is_half_of_a_whole(half in angles(PI), material in material(), seed in 0..1000_u32) {
        let Ok(nodes) = Nodes::mirrored(half.clone()) else { return Ok(()) };
        let count = half.len();
        let mut all: Vec<f64> = half.iter().rev().map(|angle| -angle).collect();
        all.pop();
        all.extend(&half);
        all.remove(0);
        let whole = Nodes::circle(all).unwrap();
        let unit = Circle { centre: [0.0, 0.0], radius: 1.0, thickness: 1.0 };
        let anchor = Anchor::Area;
        let random = |k: usize| f64::from((seed + 1) * 7919 * (k as u32 + 3) % 1013) / 1013.0 - 0.5;
        let mut forces = DVector::from_fn(2 * count, |row, _| random(row));
        forces[1] = 0.0;
        forces[2 * count - 1] = 0.0;
        let mut on_whole = DVector::zeros(2 * whole.len());
        for node in 0..count {
            // Node k of the half is node count − 2 + k of the whole, its image count − 2 − k.
            let places = [count - 2 + node, (count - 2 + whole.len() - node) % whole.len()];
            on_whole[2 * places[0]] += forces[2 * node];
            on_whole[2 * places[0] + 1] += forces[2 * node + 1];
            on_whole[2 * places[1]] += forces[2 * node];
            on_whole[2 * places[1] + 1] -= forces[2 * node + 1];
        }
        let bodies: [[Box<dyn InterfaceOperator>; 2]; 2] = [
            [
                Box::new(Hole::held(nodes.clone(), &material, unit, &[]).unwrap()),
                Box::new(Hole::held(whole.clone(), &material, unit, &[]).unwrap()),
            ],
            [
                Box::new(Disk::held(nodes, &material, unit, anchor, &[]).unwrap()),
                Box::new(Disk::held(whole, &material, unit, anchor, &[]).unwrap()),
            ],
        ];
        for [half, whole] in bodies {
            let u = half.compliance().unwrap() * &forces;
            let v = whole.compliance().unwrap() * &on_whole;
            for row in 0..2 * count {
                let error = (u[row] - v[2 * (count - 2) + row]).abs();
                prop_assert!(error < 1e-11 * v.amax(), "{} {}", row, error);
            }
        }
    }
}

#[test]
fn loads_that_do_not_fit_are_refused() {
    let material = Isotropic::new(1.0, 0.3, PlaneState::Stress).unwrap();
    let unit = Circle {
        centre: [0.0, 0.0],
        radius: 1.0,
        thickness: 1.0,
    };
    let nodes = Nodes::uniform_half(9).unwrap();
    let error = |load: DiskLoad, held: bool| {
        let make = if held { Disk::held } else { Disk::floating };
        let made = make(nodes.clone(), &material, unit, Anchor::Area, &[load]);
        made.unwrap_err()
    };
    let push = DiskLoad {
        force: [1.0, 2.0],
        ..DiskLoad::default()
    };
    let across = SeriesError::NotSymmetric {
        case: 0,
        what: "the force along y",
        value: 2.0,
    };
    let text = across.to_string();
    assert!(text.contains("case 0: the force along y is 2"), "{text}");
    assert_eq!(error(push, false), across);
    let on_support = |what| SeriesError::LoadOnSupport { case: 0, what };
    assert_eq!(error(push, true), on_support("the force"));
    let moved = DiskLoad {
        displacement: [f64::INFINITY, 0.0],
        ..DiskLoad::default()
    };
    let infinite = SeriesError::LoadNotFinite {
        case: 0,
        what: "the displacement along x",
        value: f64::INFINITY,
    };
    let text = infinite.to_string();
    assert!(text.contains("case 0: the displacement along x is inf"));
    assert_eq!(error(moved, true), infinite);
    let floats = SeriesError::NoSupport {
        case: 0,
        what: "the displacement",
    };
    assert_eq!(error(moved, false), floats);
    let anchor = Anchor::Centre { circle: 0.5 };
    let refused = Disk::held(nodes.clone(), &material, unit, anchor, &[]);
    let too_large = SeriesError::CentreCircle {
        ratio: 0.5,
        largest: 0.25,
    };
    let text = too_large.to_string();
    assert!(
        text.contains("has 0.5 of") && text.contains("at most 0.25 are"),
        "{text}"
    );
    assert_eq!(refused.unwrap_err(), too_large);
    let far = FarLoad {
        force: [1.0, 0.0],
        ..FarLoad::default()
    };
    let refused = Hole::held(nodes, &material, unit, &[far]).unwrap_err();
    assert_eq!(refused, on_support("the force or moment far away"));
}
