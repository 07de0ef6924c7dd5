//! Stress on an edge with known tractions.

use std::f64::consts::{PI, TAU};

use stickslip_fem_core::material::{Material, Orthotropic, OrthotropicConstants, apply};
use stickslip_fem_core::mesh::Point;
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

/// The report of one circular edge: nodes at `angles`, displacement and stress from closed forms.
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

    fn largest_error(
        &self,
        (order, ends): (usize, PathEnds),
        material: &dyn Material,
        initial: [f64; 3],
    ) -> f64 {
        let parameter: Vec<f64> = self.angles.iter().map(|a| kirsch::RADIUS * a).collect();
        let normal: Vec<Point> = self.angles.iter().map(|a| [a.cos(), a.sin()]).collect();
        let normal_stress: Vec<f64> = self.stress.iter().map(|s| s[0]).collect();
        let shear_stress: Vec<f64> = self.stress.iter().map(|s| s[2]).collect();
        let edge = EdgeData {
            order,
            ends,
            parameter: &parameter,
            displacement: &self.displacement,
            normal: &normal,
            normal_stress: &normal_stress,
            shear_stress: &shear_stress,
        };
        let recovered = edge_stresses(&edge, material, initial).unwrap();
        let error = |(found, exact): (&EdgeStress, &[f64; 3])| {
            assert_eq!((found.normal, found.shear), (exact[0], exact[2]));
            (found.tangential - exact[1]).abs()
        };
        recovered
            .iter()
            .zip(&self.stress)
            .map(error)
            .fold(0.0, f64::max)
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

fn kirsch_errors(order: usize, ends: PathEnds) -> Vec<f64> {
    let error = |edges: usize| {
        let circle = Circle::new(half_circle(edges), kirsch::displacement, kirsch::stress);
        circle.largest_error((order, ends), &kirsch::material(), [0.0; 3]) / kirsch::TENSION
    };
    [20, 40, 80, 160].map(error).to_vec()
}

#[test]
fn hoop_stress_around_a_hole_converges() {
    for (order, ends) in [(1, FREE), (1, MIRRORED), (2, FREE), (2, MIRRORED)] {
        let errors = kirsch_errors(order, ends);
        println!("{order} {ends:?} {errors:?} {:?}", rates(&errors));
    }
}
