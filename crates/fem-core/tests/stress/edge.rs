//! Stress on an edge with known tractions.

use std::f64::consts::{PI, TAU};

use approx::assert_relative_eq;
use stickslip_fem_core::material::{
    Isotropic, Material, Orthotropic, OrthotropicConstants, PlaneState, apply,
};
use stickslip_fem_core::mesh::{ElementKind, Point};
use stickslip_fem_core::stress::{
    EdgeData, EdgeStress, PathEnd, PathEnds, StressError, edge_stresses, polar,
};

use crate::{kirsch, rates};

const MIRRORED: PathEnds = PathEnds::Open([PathEnd::Mirror { axis: [1.0, 0.0] }; 2]);
const FREE: PathEnds = PathEnds::Open([PathEnd::Free; 2]);

fn off_axis() -> Orthotropic {
    let ply = OrthotropicConstants {
        e1: 18.1e4,
        e2: 1.03e4,
        g12: 7.17e3,
        nu12: 0.28,
    };
    Orthotropic::new(ply, 0.6)
        .unwrap()
        .with_expansion(-0.3e-6, 28e-6)
        .unwrap()
}

/// A circular edge with nodes at `angles`, its displacement and its stress.
struct Circle {
    angles: Vec<f64>,
    displacement: Vec<[f64; 2]>,
    /// (σ_rr, σ_θθ, τ_rθ)
    stress: Vec<[f64; 3]>,
}

impl Circle {
    fn new(
        angles: Vec<f64>,
        displacement: impl Fn(Point) -> [f64; 2],
        stress: impl Fn(Point) -> [f64; 3],
    ) -> Self {
        let place = |angle: &f64| [kirsch::RADIUS * angle.cos(), kirsch::RADIUS * angle.sin()];
        Self {
            displacement: angles
                .iter()
                .map(|angle| displacement(place(angle)))
                .collect(),
            stress: angles
                .iter()
                .map(|angle| polar(stress(place(angle)), *angle))
                .collect(),
            angles,
        }
    }

    /// Parameter and normal, the normal along `side` e_r.
    fn frame(&self, side: f64) -> (Vec<f64>, Vec<Point>) {
        let parameter = self
            .angles
            .iter()
            .map(|a| side * kirsch::RADIUS * a)
            .collect();
        (
            parameter,
            self.angles
                .iter()
                .map(|a| [side * a.cos(), side * a.sin()])
                .collect(),
        )
    }

    fn recovered(
        &self,
        (order, ends): (usize, PathEnds),
        material: &dyn Material,
        initial: [f64; 3],
    ) -> Vec<EdgeStress> {
        let (parameter, normal) = self.frame(1.0);
        let normal_stress: Vec<f64> = self.stress.iter().map(|s| s[0]).collect();
        let shear_stress: Vec<f64> = self.stress.iter().map(|s| s[2]).collect();
        let edge = EdgeData {
            order,
            ends,
            parameter: &parameter,
            place: &normal,
            displacement: &self.displacement,
            normal: &normal,
            normal_stress: &normal_stress,
            shear_stress: &shear_stress,
        };
        edge_stresses(&edge, material, initial).unwrap()
    }

    fn largest_error(
        &self,
        path: (usize, PathEnds),
        material: &dyn Material,
        initial: [f64; 3],
    ) -> f64 {
        let error = |(found, exact): (EdgeStress, &[f64; 3])| {
            assert_eq!((found.normal, found.shear), (exact[0], exact[2]));
            (found.tangential - exact[1]).abs()
        };
        let recovered = self.recovered(path, material, initial).into_iter();
        recovered.zip(&self.stress).map(error).fold(0.0, f64::max)
    }
}

/// Half circle from 0 to π, denser near 0.
fn half_circle(edges: usize) -> Vec<f64> {
    (0..=edges)
        .map(|k| {
            let t = k as f64 / edges as f64;
            PI * t * (0.7 + 0.3 * t)
        })
        .collect()
}

/// The polynomial of degree 2p differentiates with an error of h²ᵖ.
#[test]
fn hoop_stress_of_exact_displacements_converges_with_order_2p() {
    for (order, ends) in [(1, FREE), (1, MIRRORED), (2, FREE), (2, MIRRORED)] {
        let error = |edges: usize| {
            let circle = Circle::new(half_circle(edges), kirsch::displacement, kirsch::stress);
            circle.largest_error((order, ends), &kirsch::material(), [0.0; 3]) / kirsch::TENSION
        };
        let errors = [40, 80, 160].map(error);
        let expected = 2.0 * order as f64;
        for rate in rates(&errors) {
            assert!(
                (rate - expected).abs() < 0.15,
                "{order} {ends:?}: {errors:?}"
            );
        }
    }
}

/// A free end costs accuracy there; reflection gives it back. On equal spacing the errors are as the products of the
/// distances to the other nodes: 2h² against h² for order 1, 24h⁴ against 4h⁴ for order 2.
#[test]
fn reflection_is_better_than_a_free_end() {
    for (order, gain) in [(1, 2.0), (2, 6.0)] {
        let angles = (0..=160).map(|k| PI * f64::from(k) / 160.0).collect();
        let circle = Circle::new(angles, kirsch::displacement, kirsch::stress);
        let end_error = |ends| {
            let recovered = circle.recovered((order, ends), &kirsch::material(), [0.0; 3]);
            (recovered[0].tangential - circle.stress[0][1]).abs()
        };
        assert_relative_eq!(
            end_error(FREE) / end_error(MIRRORED),
            gain,
            max_relative = 0.05
        );
    }
}

#[test]
fn a_finite_element_solution_gives_its_hoop_stress() {
    // Bound on the largest error with 16 cells over a quarter, as a share of the remote tension (the peak is 3), and on the
    // rate from 16 to 32. With h = π/32 the bound is 5h², 2.5h², h²/8, h⁴ and h⁴/5.
    let cases = [
        (ElementKind::T3, 0.048, 1.4),
        (ElementKind::Q4, 0.024, 1.9),
        (ElementKind::T6, 0.0012, 1.9),
        (ElementKind::Q8, 0.000093, 3.8),
        (ElementKind::Q9, 0.000019, 3.8),
    ];
    for (kind, bound, rate) in cases {
        let errors = [16, 32].map(|cells| solved_hole_error(kind, cells));
        assert!(errors[0] < bound, "{kind:?}: {errors:?}");
        assert!(rates(&errors)[0] > rate, "{kind:?}: {errors:?}");
    }
}

fn solved_hole_error(kind: ElementKind, cells: usize) -> f64 {
    let (mesh, u) = kirsch::solved_quarter(kind, cells);
    let on_hole = |p: &Point| (p[0].hypot(p[1]) - kirsch::RADIUS).abs() < 1e-9 * kirsch::RADIUS;
    let mut nodes: Vec<usize> = (0..mesh.nodes().len())
        .filter(|&k| on_hole(&mesh.nodes()[k]))
        .collect();
    let angle = |k: usize| mesh.nodes()[k][1].atan2(mesh.nodes()[k][0]);
    nodes.sort_by(|&a, &b| angle(a).total_cmp(&angle(b)));
    let angles = nodes.iter().map(|&k| angle(k)).collect();
    let mut circle = Circle::new(angles, kirsch::displacement, kirsch::stress);
    circle.displacement = nodes.iter().map(|&k| [u[2 * k], u[2 * k + 1]]).collect();
    let ends = PathEnds::Open([[1.0, 0.0], [0.0, 1.0]].map(|axis| PathEnd::Mirror { axis }));
    circle.largest_error((kind.order(), ends), &kirsch::material(), [0.0; 3]) / kirsch::TENSION
}

/// Around a closed circle, in either direction and with the normal on either side, for a body with every coupling, an
/// initial strain and tractions that do not vanish.
#[test]
fn anisotropy_tractions_and_initial_strain_enter_on_a_closed_circle() {
    let material = off_axis();
    let initial = material.thermal_strain(-80.0);
    let strain = [1e-3, -2e-3, 1.5e-3];
    let elastic = [0, 1, 2].map(|i| strain[i] - initial[i]);
    let stress = apply(&material.stiffness(), elastic);
    let displacement = |[x, y]: Point| [strain[0] * x, strain[1] * y + strain[2] * x];
    let error = |nodes: usize, direction: f64, order: usize| {
        let angles = (0..nodes)
            .map(|k| 0.3 + direction * TAU * k as f64 / nodes as f64)
            .collect();
        let circle = Circle::new(angles, displacement, |_| stress);
        let ends = PathEnds::Closed {
            length: TAU * kirsch::RADIUS,
        };
        circle.largest_error((order, ends), &material, initial) / stress[1].abs()
    };
    for direction in [1.0, -1.0] {
        for order in [1, 2] {
            let errors = [20, 40, 80].map(|nodes| error(nodes, direction, order));
            let fast = |rate: &f64| *rate > 2.0 * order as f64 - 0.25;
            assert!(
                rates(&errors).iter().all(fast),
                "{direction} {order}: {errors:?}"
            );
            assert!(errors[2] < [0.01, 2e-5][order - 1], "{errors:?}");
        }
    }
}

/// A body that turns by 1 rad has no stress, between edges of unequal length too.
#[test]
fn a_turn_is_no_stress() {
    let isotropic = Isotropic::new(70e3, 0.3, PlaneState::Stress).unwrap();
    for count in [12_u32, 24] {
        let angles = (0..count).map(|k| {
            let part = f64::from(k) / f64::from(count);
            TAU * part + 0.15 * (TAU * part).sin() + 0.1 * (2.0 * TAU * part).cos()
        });
        let turn = |[x, y]: Point| [-y, x];
        let circle = Circle::new(angles.collect(), turn, |_| [0.0; 3]);
        for order in [1, 2] {
            let closed = PathEnds::Closed {
                length: TAU * kirsch::RADIUS,
            };
            let most = circle.largest_error((order, closed), &isotropic, [0.0; 3]);
            assert!(most < 1e-9 * 70e3, "{count} nodes, order {order}: {most:e}");
        }
    }
}

#[test]
fn the_side_of_the_normal_does_not_matter() {
    let circle = Circle::new(half_circle(10), kirsch::displacement, kirsch::stress);
    let outward = circle.recovered((1, FREE), &off_axis(), [1e-3, 0.0, 2e-3]);
    let (parameter, normal) = circle.frame(-1.0);
    let zero = vec![0.0; parameter.len()];
    let inward = EdgeData {
        order: 1,
        ends: FREE,
        parameter: &parameter,
        place: &normal,
        displacement: &circle.displacement,
        normal: &normal,
        normal_stress: &zero,
        shear_stress: &zero,
    };
    let inward = edge_stresses(&inward, &off_axis(), [1e-3, 0.0, 2e-3]).unwrap();
    for (a, b) in inward.iter().zip(outward) {
        assert_relative_eq!(a.tangential, b.tangential, max_relative = 1e-12);
    }
}

/// On a straight edge a parabola is differentiated exactly, whatever the spacing; quadratic edges take a quartic.
#[test]
fn polynomials_along_a_line_are_exact() {
    let (young, poisson) = (200.0, 0.3);
    let plate = Isotropic::new(young, poisson, PlaneState::Stress).unwrap();
    let parameter = [0.0, 0.1, 0.35, 0.4, 0.9];
    for (order, degree) in [(1, 2), (2, 4)] {
        // An edge along y with its normal along x, so t = e_y.
        let displacement = parameter.map(|s: f64| [0.7 * s, s.powi(degree) - 0.2 * s]);
        let edge = EdgeData {
            order,
            ends: FREE,
            parameter: &parameter,
            place: &[[1.0, 0.0]; 5],
            displacement: &displacement,
            normal: &[[1.0, 0.0]; 5],
            normal_stress: &[-4.0; 5],
            shear_stress: &[1.5; 5],
        };
        let recovered = edge_stresses(&edge, &plate, [0.0; 3]).unwrap();
        for (found, s) in recovered.iter().zip(parameter) {
            let strain = f64::from(degree) * s.powi(degree - 1) - 0.2;
            assert_relative_eq!(
                found.tangential,
                young * strain - poisson * 4.0,
                epsilon = 1e-12 * young
            );
        }
    }
}

#[test]
fn edges_that_do_not_fit_are_refused() {
    let sound = EdgeData {
        order: 1,
        ends: FREE,
        parameter: &[0.0, 1.0, 2.0],
        place: &[[0.0, 1.0]; 3],
        displacement: &[[0.0; 2]; 3],
        normal: &[[0.0, 1.0]; 3],
        normal_stress: &[0.0; 3],
        shear_stress: &[0.0; 3],
    };
    let refused =
        |edge: EdgeData<'_>| edge_stresses(&edge, &kirsch::material(), [0.0; 3]).unwrap_err();
    assert!(edge_stresses(&sound, &kirsch::material(), [0.0; 3]).is_ok());
    assert!(matches!(
        refused(EdgeData {
            shear_stress: &[0.0; 2],
            ..sound
        }),
        StressError::Length {
            name: "shear_stress",
            expected: 3,
            found: 2
        }
    ));
    for order in [0, 2, 3] {
        assert!(matches!(
            refused(EdgeData { order, ..sound }),
            StressError::PathNodes {
                nodes: 3,
                closed: false,
                ..
            }
        ));
    }
    for parameter in [
        [0.0, 1.0, 1.0],
        [0.0, 1.0, 0.5],
        [0.0, f64::NAN, 2.0],
        [0.0, 0.0, 1.0],
    ] {
        let error = refused(EdgeData {
            parameter: &parameter,
            ..sound
        });
        assert!(matches!(error, StressError::Parameter { .. }), "{error}");
    }
    let short_turn = PathEnds::Closed { length: 2.0 };
    assert!(matches!(
        refused(EdgeData {
            ends: short_turn,
            ..sound
        }),
        StressError::Parameter {
            node: 2,
            before: 2.0,
            after: 2.0
        }
    ));
    assert!(matches!(
        refused(EdgeData {
            normal: &[[0.0, 1.0], [0.0, 1.1], [0.0, 1.0]],
            ..sound
        }),
        StressError::Direction { node: 1, .. }
    ));
    let ends = PathEnds::Open([PathEnd::Free, PathEnd::Mirror { axis: [0.0, 0.0] }]);
    assert!(matches!(
        refused(EdgeData { ends, ..sound }),
        StressError::Direction { node: 2, .. }
    ));
}
