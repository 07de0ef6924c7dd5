//! Half-planes against Johnson, *Contact Mechanics* (1985), chapters 2, 4 and 7.

use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_series::{Ground, HalfPlane, Lies, LineNodes};

const YOUNG: f64 = 73_100.0;
const POISSON: f64 = 0.33;
const THICKNESS: f64 = 1.5;

fn body(places: Vec<f64>, lies: Lies, mirrored: bool) -> HalfPlane {
    let material = Isotropic::new(YOUNG, POISSON, PlaneState::Strain).unwrap();
    let nodes = if mirrored {
        LineNodes::mirrored(places)
    } else {
        LineNodes::whole(places)
    };
    let ground = Ground {
        lies,
        thickness: THICKNESS,
        reference: 7.0,
        free: [false; 2],
    };
    HalfPlane::new(nodes.unwrap(), &material, ground, &[]).unwrap()
}

/// Places that are closer at ±1, from −1.5 to 1.5.
fn places(count: i32) -> Vec<f64> {
    let half = |k: i32| {
        let s = f64::from(k) / f64::from(count);
        (0.5 * std::f64::consts::PI * s).sin()
    };
    let mut all: Vec<f64> = (0..=count).map(half).collect();
    all.extend([1.001, 1.005, 1.02, 1.1, 1.5]);
    let left: Vec<f64> = all.iter().skip(1).rev().map(|x| -x).collect();
    left.into_iter().chain(all).collect()
}

fn ellipse(x: f64) -> f64 {
    (1.0 - x * x).max(0.0).sqrt()
}

/// Nodal forces of the tractions `at` on nodes.
fn forces(body: &HalfPlane, at: impl Fn(f64) -> [f64; 2]) -> Vec<f64> {
    let nodes = body.nodes();
    let both = nodes.places().iter().zip(nodes.weights());
    both.flat_map(|(&x, weight)| at(x).map(|q| q * weight * THICKNESS))
        .collect()
}

fn state(forces: &[f64]) -> BodyLoad<'_> {
    BodyLoad {
        forces,
        multipliers: &[],
        motions: &[],
    }
}

/// On nodes at equal parts of the angle arcsin x hats make the parabola of Johnson (4.28), u_y = −(1 − ν²) p0/(E a) (const − x²), without an error; on
/// others with one of second order.
#[test]
fn elliptical_pressure_bends_the_surface_to_a_parabola() {
    let error = |places: Vec<f64>| {
        let below = body(places, Lies::Below, false);
        let pressed = forces(&below, |x| [0.0, -ellipse(x)]);
        let u = below.compliance().unwrap() * nalgebra::DVector::from_vec(pressed);
        let k = (1.0 - POISSON * POISSON) / YOUNG;
        let own = below.nodes().mean(|x| k * x * x);
        let middle = below.nodes().len() / 2;
        let inside = below.nodes().places().iter().enumerate();
        let error = |(node, _): (usize, &f64)| {
            let found = u[2 * node + 1] - u[2 * middle + 1];
            ((found - (own[node] - own[middle])) / k).abs()
        };
        let inside = inside.filter(|(_, x)| x.abs() < 0.8);
        inside.map(error).fold(0.0, f64::max)
    };
    assert!(error(places(20)) < 1e-13);
    let graded = |count: i32| {
        let at = |k: i32| 1.4 * f64::from(k) / f64::from(count);
        error(
            (-count..=count)
                .map(|k| at(k) * (1.0 + 0.2 * at(k).cos()))
                .collect(),
        )
    };
    let (coarse, fine) = (graded(100), graded(200));
    assert!(coarse < 5e-3 && fine < 0.5 * coarse, "{coarse:e} {fine:e}");
}

#[test]
fn stresses_under_elliptical_tractions_are_those_of_mcewen() {
    let count = 200;
    for lies in [Lies::Below, Lies::Above] {
        let side = if lies == Lies::Below { -1.0 } else { 1.0 };
        let own = body(places(count), lies, false);
        // Tractions press into the body.
        let pressed = forces(&own, |x| [0.0, side * ellipse(x)]);
        let field = own.field(&state(&pressed)).unwrap();
        for depth in [0.01_f64, 0.3, 1.0, 4.0, 100.0] {
            // Johnson (4.46), on the axis.
            let root = (1.0 + depth * depth).sqrt();
            let along = -((1.0 + 2.0 * depth * depth) / root - 2.0 * depth);
            let down = -1.0 / root;
            let [xx, yy, xy] = field.stress([0.0, side * depth]).unwrap();
            assert!((xx - along).abs() < 2e-4, "{lies:?} {depth} {xx} {along}");
            assert!((yy - down).abs() < 2e-4, "{lies:?} {depth} {yy} {down}");
            assert!(xy.abs() < 1e-12);
        }
        // On the edge σ_xx is the pressure, and under friction 2 q0 x/a, Johnson (7.8) with q towards +x on the body.
        let rubbed = forces(&own, |x| [ellipse(x), 0.0]);
        let at = [-0.9, -0.2, 0.4, 0.8];
        let found = own
            .edge_stresses(&[state(&pressed), state(&rubbed)], &at)
            .unwrap();
        for (k, x) in at.into_iter().enumerate() {
            let [xx, yy, _] = found[0][k];
            assert!((xx + ellipse(x)).abs() < 2e-4 && (yy + ellipse(x)).abs() < 2e-4);
            assert!(
                (found[1][k][0] + 2.0 * x).abs() < 5e-3,
                "{x} {:?}",
                found[1][k]
            );
            assert!((found[1][k][2] + side * ellipse(x)).abs() < 2e-4);
        }
        assert!(field.stress([0.0, -side]).is_err());
    }
}

#[test]
fn the_field_meets_the_edge_and_the_operator() {
    for lies in [Lies::Below, Lies::Above] {
        let side = if lies == Lies::Below { -1.0 } else { 1.0 };
        let own = body(vec![-2.0, -1.1, -1.0, -0.3, 0.4, 0.5, 3.0], lies, false);
        let applied = forces(&own, |x| [0.3 * x.cos(), (2.0 - x) * side]);
        let applied_state = state(&applied);
        let field = own.field(&applied_state).unwrap();
        let stresses = |x: f64, depth: f64| {
            let at = [x, side * depth];
            (field.stress(at).unwrap(), field.displacement(at).unwrap())
        };
        for x in [-1.5, -0.7, 0.1, 1.7] {
            let (on, moved) = stresses(x, 0.0);
            let (near, beside) = stresses(x, 1e-6);
            for part in 0..3 {
                assert!((on[part] - near[part]).abs() < 1e-4, "{x} {on:?} {near:?}");
            }
            assert!((0..2).all(|axis| (moved[axis] - beside[axis]).abs() < 1e-9));
            let of_edge = own.edge_stresses(&[applied_state], &[x]).unwrap()[0][0];
            assert!((0..3).all(|part| (on[part] - of_edge[part]).abs() < 1e-12));
        }
        // Means of the displacement over hats are those of the operator.
        let u = own.compliance().unwrap() * nalgebra::DVector::from_vec(applied.clone());
        for axis in 0..2 {
            let means = own.nodes().mean(|x| stresses(x, 0.0).1[axis]);
            for (node, mean) in means.into_iter().enumerate() {
                let found = u[2 * node + axis];
                assert!(
                    (found - mean).abs() < 1e-4 * u.amax(),
                    "{axis} {node} {found} {mean}"
                );
            }
        }
        // Strains by differences are those of the stresses.
        let (step, at) = (1e-4, [0.2, side * 0.7]);
        let moved = |dx: f64, dy: f64| field.displacement([at[0] + dx, at[1] + dy]).unwrap();
        let slope = |dx: f64, dy: f64| {
            let ([ax, ay], [bx, by]) = (moved(dx, dy), moved(-dx, -dy));
            [(ax - bx) / (2.0 * step), (ay - by) / (2.0 * step)]
        };
        let ([exx, yx], [xy, eyy]) = (slope(step, 0.0), slope(0.0, step));
        let [sx, sy, txy] = field.stress(at).unwrap();
        let (shear, nu) = (0.5 * YOUNG / (1.0 + POISSON), POISSON);
        let strain = |own: f64, other: f64| ((1.0 - nu) * own - nu * other) / (2.0 * shear);
        for (found, expected) in [
            (exx, strain(sx, sy)),
            (eyy, strain(sy, sx)),
            (yx + xy, txy / shear),
        ] {
            assert!(
                (found - expected).abs() < 1e-6 * expected.abs().max(1e-6),
                "{found} {expected}"
            );
        }
    }
}

#[test]
fn half_of_a_symmetric_body_is_the_whole() {
    let own = vec![0.0, 0.1, 0.15, 0.6, 2.0];
    let all: Vec<f64> = (own.iter().skip(1).rev().map(|x| -x))
        .chain(own.iter().copied())
        .collect();
    let [half, whole] =
        [(own, true), (all, false)].map(|(places, mirrored)| body(places, Lies::Above, mirrored));
    let traction = |x: f64| [x, 1.0 - 0.2 * x * x];
    let [part, full] = [&half, &whole].map(|body| forces(body, traction));
    let [u, v] = [(&half, &part), (&whole, &full)].map(|(body, forces)| {
        body.compliance().unwrap() * nalgebra::DVector::from_vec(forces.clone())
    });
    for node in 0..5 {
        for axis in 0..2 {
            let (a, b) = (u[2 * node + axis], v[2 * (node + 4) + axis]);
            assert!((a - b).abs() < 1e-14, "{node} {axis} {a} {b}");
        }
    }
    let [a, b] = [(&half, &part), (&whole, &full)]
        .map(|(body, forces)| body.edge_stresses(&[state(forces)], &[0.05, 0.3]).unwrap());
    for (a, b) in a[0].iter().zip(&b[0]) {
        assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-12), "{a:?} {b:?}");
    }
}

#[test]
fn a_half_plane_that_makes_no_sense_is_refused() {
    let material = Isotropic::new(YOUNG, POISSON, PlaneState::Strain).unwrap();
    let make = |free, load, mirrored: bool| {
        let places = vec![0.0, 1.0, 2.0];
        let nodes = if mirrored {
            LineNodes::mirrored(places)
        } else {
            LineNodes::whole(places)
        };
        let ground = Ground {
            lies: Lies::Below,
            thickness: 1.0,
            reference: 1.0,
            free,
        };
        HalfPlane::new(nodes.unwrap(), &material, ground, &[load])
            .map(|_| ())
            .map_err(|cause| cause.to_string())
    };
    assert_eq!(
        make([true; 2], [0.0; 2], true),
        Err("a half model does not move along x".into())
    );
    let skew = make([false, true], [1.0, 0.0], true).unwrap_err();
    assert!(skew.contains("the force along x is 1"), "{skew}");
    assert!(make([true; 2], [f64::NAN, 0.0], false).is_err());
    assert!(make([true; 2], [1.0, 2.0], false).is_ok());
}
