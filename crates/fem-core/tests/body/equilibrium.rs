//! Properties of any body under any load: equilibrium, Betti's reciprocity, C symmetric and positive semidefinite.

use std::sync::Arc;

use nalgebra::{DVector, SymmetricEigen};
use proptest::prelude::*;
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::{
    CondensedBody, ElasticBody, HeldDirection, InterfaceOperator, LoadCase, Support,
};

use crate::fields::{THICKNESS, materials};
use crate::meshes::{Distortion, Noise, nearest, scattered, side_nodes};
use crate::reference::{largest, resultants};

const ROUNDING: f64 = 1e-12;

/// A body to draw: any cell, material and shape; how it is held; two load cases.
#[derive(Clone, Debug)]
struct Sample {
    kind: ElementKind,
    material: usize,
    seed: u64,
    holding: Holding,
    /// Scales of the forces of the two load cases and of the interface.
    loads: [f64; 3],
}

#[derive(Clone, Debug)]
enum Holding {
    Floating,
    /// Directions `[rad]` of the supports of three corners, not all through one point.
    Isostatic,
    /// The left side along one direction `[rad]`, one more corner along another.
    Skew(f64, f64),
}

fn samples() -> impl Strategy<Value = Sample> {
    let holding = prop_oneof![
        Just(Holding::Floating),
        Just(Holding::Isostatic),
        // Far enough from parallel that the supports hold well: condition numbers stay below 10⁵.
        (0.0..0.4_f64, 1.1..1.9_f64).prop_map(|(a, b)| Holding::Skew(a, b)),
    ];
    let kind = prop::sample::select(ElementKind::COMMON.to_vec());
    let loads = prop::array::uniform3(-3.0..3.0_f64);
    (kind, 0..4_usize, any::<u64>(), holding, loads).prop_map(
        |(kind, material, seed, holding, loads)| Sample {
            kind,
            material,
            seed,
            holding,
            loads,
        },
    )
}

struct Drawn {
    condensed: CondensedBody,
    lambda: Vec<f64>,
}

impl Sample {
    fn supports(&self, mesh: &Mesh) -> Vec<Support> {
        let hold = |nodes, angle| Support {
            nodes,
            direction: HeldDirection::Angle(angle),
            displacement: 0.0,
        };
        let corner = |place| vec![nearest(mesh, place)];
        match self.holding {
            Holding::Floating => vec![],
            Holding::Isostatic => vec![
                hold(corner([-0.2, 0.0]), 0.0),
                hold(corner([-0.2, 0.0]), 1.3),
                hold(corner([1.1, -0.2]), 1.5),
            ],
            Holding::Skew(a, b) => vec![
                hold(side_nodes(mesh, &["left"]), a),
                hold(corner([1.1, -0.2]), b),
            ],
        }
    }

    fn draw(&self) -> Drawn {
        let distortion = if self.seed.is_multiple_of(2) {
            Distortion::Straight
        } else {
            Distortion::Curved
        };
        let mesh = scattered(self.kind, distortion, self.seed);
        let supports = self.supports(&mesh);
        let mut noise = Noise::new(self.seed ^ 0x5851_f42d);
        let mut scaled = |length, scale: f64| -> Vec<f64> {
            noise.vector(length).iter().map(|v| scale * v).collect()
        };
        let mut cases = [0, 1].map(|k| LoadCase {
            forces: scaled(2 * mesh.nodes().len(), self.loads[k]),
            ..LoadCase::default()
        });
        cases[1].initial_strain = vec![[1e-3, 2e-3, -3e-3]];
        let interface = side_nodes(&mesh, &["top", "right"]);
        let lambda = scaled(2 * interface.len(), self.loads[2]);
        let material = Arc::clone(&materials()[self.material]);
        let body = ElasticBody::new(Arc::new(mesh), vec![material], THICKNESS).unwrap();
        let body = body
            .with_supports(supports)
            .with_load_cases(cases.to_vec())
            .unwrap();
        Drawn {
            condensed: Arc::new(body).condense(&interface).unwrap(),
            lambda,
        }
    }
}

impl Drawn {
    /// Interface forces that balance the load cases in all free motions: `lambda` plus a combination of the motions.
    fn balanced(&self, multipliers: [f64; 2]) -> Vec<f64> {
        let (modes, mut lambda) = (
            self.condensed.modes(),
            DVector::from_column_slice(&self.lambda),
        );
        if modes.ncols() > 0 {
            let mut excess = modes.transpose() * &lambda;
            for (case, factor) in multipliers.into_iter().enumerate() {
                excess += self.condensed.mode_load(case) * factor;
            }
            lambda -= modes * (modes.transpose() * modes).lu().solve(&excess).unwrap();
        }
        lambda.as_slice().to_vec()
    }

    /// All forces on the nodes but the reactions.
    fn applied(&self, lambda: &[f64], multipliers: [f64; 2]) -> Vec<f64> {
        let body = self.condensed.body();
        let mut forces = vec![0.0; 2 * body.mesh().nodes().len()];
        for (case, factor) in body.load_cases().iter().zip(multipliers) {
            forces
                .iter_mut()
                .zip(&case.forces)
                .for_each(|(sum, f)| *sum += factor * f);
        }
        for (force, &node) in lambda.chunks_exact(2).zip(self.condensed.interface_nodes()) {
            (0..2).for_each(|i| forces[2 * node + i] += force[i]);
        }
        forces
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    /// Forces and moments of loads, interface and reactions vanish; of a floating body there are no reactions.
    #[test]
    fn forces_and_moments_balance(sample in samples(), multipliers in prop::array::uniform2(-2.0..2.0_f64)) {
        let drawn = sample.draw();
        let condensed = &drawn.condensed;
        let lambda = drawn.balanced(multipliers);
        let motions = vec![0.01; condensed.modes().ncols()];
        let u = condensed.displacements(&lambda, &multipliers, &motions);
        let reactions = condensed.residual_forces(&u, &lambda, &multipliers);
        let mesh = condensed.body().mesh();
        let applied = drawn.applied(&lambda, multipliers);
        // K u is a sum of terms of this size; the heat of case 1 adds forces of the size of D ε₀, included in it.
        let terms = 200.0 * largest(&u) + largest(&applied) + 1.0;
        let (carried, put) = (resultants(mesh.nodes(), &reactions), resultants(mesh.nodes(), &applied));
        for i in 0..3 {
            prop_assert!((carried[i] + put[i]).abs() < 10.0 * ROUNDING * terms, "{carried:?} {put:?}");
        }
        if condensed.modes().ncols() == 3 {
            prop_assert!(largest(&reactions) < 10.0 * ROUNDING * terms);
        }
        let supports = sample.supports(mesh);
        for (node, force) in reactions.chunks_exact(2).enumerate() {
            if !supports.iter().any(|support| support.nodes.contains(&node)) {
                prop_assert!(largest(force) < 10.0 * ROUNDING * terms);
            }
        }
    }

    /// Betti (1872): the work of one set of loads on the displacements of another equals the reverse.
    #[test]
    fn work_is_reciprocal(sample in samples()) {
        let drawn = sample.draw();
        // Case 1 carries heat as well, which is not a nodal force: only case 0 takes part here.
        let first = drawn.balanced([1.0, 0.0]);
        let other = drawn.balanced([0.0, 0.0]);
        let u = |lambda: &[f64], factor| {
            let motions = vec![0.0; drawn.condensed.modes().ncols()];
            drawn.condensed.displacements(lambda, &[factor, 0.0], &motions)
        };
        let work = |f: &[f64], u: &[f64]| -> f64 { f.iter().zip(u).map(|(a, b)| a * b).sum() };
        let (f, g) = (drawn.applied(&first, [1.0, 0.0]), drawn.applied(&other, [0.0, 0.0]));
        let (there, back) = (work(&f, &u(&other, 0.0)), work(&g, &u(&first, 1.0)));
        let size = work(&f, &u(&first, 1.0)).max(work(&g, &u(&other, 0.0)));
        prop_assert!((there - back).abs() <= 10.0 * ROUNDING * size, "{there} {back}");
    }

    #[test]
    fn compliance_is_symmetric_and_positive_semidefinite(sample in samples()) {
        let drawn = sample.draw();
        let compliance = drawn.condensed.compliance().unwrap();
        let size = compliance.amax();
        prop_assert!((compliance - compliance.transpose()).amax() <= 4.0 * f64::EPSILON * size);
        let eigenvalues = SymmetricEigen::new(compliance.clone()).eigenvalues;
        prop_assert!(eigenvalues.min() > -ROUNDING * size);
        prop_assert!(eigenvalues.max() <= compliance.trace() * (1.0 + ROUNDING));
    }
}
