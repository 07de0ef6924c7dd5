//! The strip on which other contact codes were measured (peers' job): an elastic pin in an elastic plate, 14 load steps of one increment each.

use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_series::{
    Accuracy, Anchor, Circle, Disk, DiskLoad, EdgeLoad, Nodes, Outline, Plate, SeriesError,
};

use crate::contacts::{follow, pressures, problem};

/// Inches, pounds, psi.
const CIRCLE: Circle = Circle {
    centre: [0.0, 0.0],
    radius: 0.375,
    thickness: 0.06,
};
const CLEARANCE: f64 = 0.0005;
const STEPS: [f64; 14] = [
    20.0, 23.0, 520.0, 1240.0, 1460.0, 1670.0, 1980.0, 1800.0, 1600.0, 1210.0, 1070.0, 535.0,
    210.0, 40.0,
];
/// Peak pressure at 1240 lb, loading, small sliding: condensed finite elements of two orders agree within 2 psi.
const PEAK: f64 = 31_501.0;
/// The same at μ = 0.25.
const PEAK_WITH_FRICTION: f64 = 25_229.0;
/// What these references are known to, relative.
const KNOWN: f64 = 2.0 / PEAK_WITH_FRICTION;

/// Largest pressure in the step of 1240 lb, loading.
fn peak(nodes: &Nodes, friction: f64, accuracy: Accuracy) -> f64 {
    let material = Isotropic::new(10.4e6, 0.33, PlaneState::Stress).unwrap();
    let strip = Outline::strip(5.5, 1.5, 1.5);
    let pull = vec![EdgeLoad {
        edge: 3,
        force: [-1.0, 0.0],
    }];
    let plate = Plate::new(nodes.clone(), &material, CIRCLE, &strip, &[pull], accuracy).unwrap();
    let loads = [DiskLoad::default()];
    let pin = Disk::held(nodes.clone(), &material, CIRCLE, Anchor::default(), &loads).unwrap();
    let area = CIRCLE.radius * CIRCLE.thickness;
    let problem = problem(&plate, &pin, nodes, area, CLEARANCE, friction);
    let states = follow(&problem, STEPS.iter().map(|p| vec![*p]).collect(), 1);
    let p = pressures(&problem, &states[3]);
    p.into_iter().fold(0.0, f64::max)
}

#[test]
fn peak_pressures_are_those_of_fine_meshes() {
    // A second-order error in the spacing, and what the references are known to.
    for (count, error) in [(61, 2.5e-4), (121, 6e-5), (241, 1.5e-5)] {
        let nodes = Nodes::uniform_half(count).unwrap();
        for (friction, expected) in [(0.0, PEAK), (0.25, PEAK_WITH_FRICTION)] {
            let found = peak(&nodes, friction, Accuracy::default());
            let off = (found / expected - 1.0).abs();
            assert!(off < error + KNOWN, "{count}, {friction}: {found}");
        }
    }
}

/// What the fit leaves on the outer edge does a thousandth on the hole.
#[test]
fn the_fit_of_the_outer_edge_is_accurate_enough() {
    let nodes = Nodes::uniform_half(61).unwrap();
    let finer = Accuracy {
        tolerance: 3e-4,
        ..Accuracy::default()
    };
    let found = peak(&nodes, 0.0, Accuracy::default()) / peak(&nodes, 0.0, finer) - 1.0;
    assert!(found.abs() < 2e-6, "{found:e}");
}

/// The same strip turned by 30° is no longer symmetric about x: all coefficients are fitted together.
#[test]
fn a_turned_strip_is_the_same_strip() {
    let turn = |angle: f64, [x, y]: [f64; 2]| {
        let (sin, cos) = angle.sin_cos();
        [cos * x - sin * y, sin * x + cos * y]
    };
    let material = Isotropic::new(10.4e6, 0.33, PlaneState::Stress).unwrap();
    let even = Nodes::uniform_circle(40).unwrap();
    let plate = |angle: f64| {
        let strip = Outline::strip(2.0, 1.5, 1.5);
        let corners = strip.vertices().iter().map(|&place| turn(angle, place));
        let outline = Outline::new(corners.collect());
        let forces = [turn(angle, [-3.0, 1.0]), turn(angle, [2.0, 0.0])];
        let loads = [
            EdgeLoad {
                edge: 3,
                force: forces[0],
            },
            EdgeLoad {
                edge: 2,
                force: forces[1],
            },
        ];
        let angles = even.angles().iter().map(|own| own + angle).collect();
        let nodes = Nodes::circle(angles).unwrap();
        Plate::new(
            nodes,
            &material,
            CIRCLE,
            &outline,
            &[loads.to_vec()],
            Accuracy::default(),
        )
        .unwrap()
    };
    let angle = 30.0_f64.to_radians();
    let [own, turned] = [plate(0.0), plate(angle)];
    let (u, v) = (
        own.load_response(0).unwrap(),
        turned.load_response(0).unwrap(),
    );
    for k in 0..even.len() {
        let back = turn(-angle, [v[2 * k], v[2 * k + 1]]);
        for axis in 0..2 {
            let error = (back[axis] - u[2 * k + axis]).abs() / u.amax();
            assert!(error < 1e-5, "{error:e}");
        }
    }
    let unit = [&own, &turned].map(|plate| plate.compliance().unwrap().norm());
    assert!((unit[0] / unit[1] - 1.0).abs() < 1e-6);
    assert!(own.fit().residual < 2e-3 && turned.fit().residual < 2e-3);
}

#[test]
fn outlines_that_hold_no_series_are_refused() {
    let material = Isotropic::new(1.0, 0.3, PlaneState::Stress).unwrap();
    let make = |outline: &Outline, nodes: Nodes, loads: &[Vec<EdgeLoad>]| {
        let made = Plate::new(
            nodes,
            &material,
            CIRCLE,
            outline,
            loads,
            Accuracy::default(),
        );
        made.unwrap_err()
    };
    let half = || Nodes::uniform_half(31).unwrap();
    let error = |outline: &Outline| make(outline, half(), &[]);
    let text = |outline: &Outline| error(outline).to_string();
    let outside = SeriesError::HoleOutside {
        distance: 0.3,
        radius: 0.375,
    };
    assert_eq!(error(&Outline::strip(1.0, 0.3, 1.0)), outside);
    let said = outside.to_string();
    assert!(said.contains("within 0.3 of the hole's centre") && said.ends_with("reaches 0.375"));
    let behind = error(&Outline::strip(1.0, -0.5, 1.0));
    assert!(matches!(
        behind,
        SeriesError::Outline { edge: 1, what } if what.contains("counter-clockwise and in its sight")
    ));
    let mut clockwise = Outline::strip(1.0, 1.0, 1.0).vertices().to_vec();
    clockwise.reverse();
    assert!(text(&Outline::new(clockwise)).contains("counter-clockwise"));
    assert!(text(&Outline::strip(1.0, 0.376, 1.0)).starts_with("a ligament of 0.0010 beside"));
    assert!(matches!(
        error(&Outline::new(vec![[0.0, 1.0], [1.0, 0.0]])),
        SeriesError::Outline { edge: 2, what } if what.contains("at least three")
    ));
    assert!(text(&Outline::new(vec![[0.0, f64::NAN]; 4])).contains("is not finite"));
    assert!(text(&Outline::new(vec![[1.0, 1.0]; 4])).contains("has no length"));
    let skew = Outline::new(vec![[-1.0, -1.0], [1.0, -1.0], [1.0, 1.2], [-1.0, 1.0]]);
    assert_eq!(error(&skew), SeriesError::NotMirrored);
    let strip = Outline::strip(1.0, 1.0, 1.0);
    let load = |edge, force| vec![vec![EdgeLoad { edge, force }]];
    let unknown = SeriesError::UnknownEdge {
        case: 0,
        edge: 7,
        edges: 4,
    };
    assert_eq!(make(&strip, half(), &load(7, [1.0, 0.0])), unknown);
    let said = unknown.to_string();
    assert!(said.contains("4 edges, none with the index 7"), "{said}");
    assert!(matches!(
        make(&strip, half(), &load(2, [0.0, 1.0])),
        SeriesError::NotSymmetric { case: 0, what, .. } if what.starts_with("the traction of an edge less")
    ));
    assert!(matches!(
        make(&strip, half(), &load(2, [f64::NAN, 1.0])),
        SeriesError::LoadNotFinite { case: 0, what: "a force along x", value } if value.is_nan()
    ));
    let long = Outline::strip(200.0, 200.0, 1.0);
    let misfit = make(&long, half(), &load(1, [1.0, 0.0]));
    let SeriesError::NotFitted { degree, residual } = misfit else {
        panic!("{misfit}");
    };
    let numbers = format!("degree {degree} leave {residual:.1e} of the mean traction");
    assert!(misfit.to_string().contains(&numbers), "{misfit}");
}
