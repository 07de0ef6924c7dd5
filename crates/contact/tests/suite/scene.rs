//! Random small scenes with one answer each.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector, Matrix2};
use proptest::prelude::*;
use stickslip_contact::{Chain, InterfaceProblem, LoadHistory, Ramp, StepRecord};
use stickslip_friction::FrictionLaw;

use crate::{Ground, coulomb};
use stickslip_fem_core::GivenBody;

/// Matrices of order 8 at most and condition numbers below 100: two ways to one answer agree to this.
pub(crate) const ROUNDING: f64 = 1e-10;

/// The data of a small scene: a body of a few points on rigid ground under two load cases.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    pub(crate) compliance: DMatrix<f64>,
    pub(crate) responses: Vec<DVector<f64>>,
    pub(crate) angles: Vec<f64>,
    pub(crate) gaps: Vec<f64>,
    pub(crate) mu: f64,
    pub(crate) steps: Vec<Vec<f64>>,
}

impl Scene {
    /// Scenes whose friction is below the bound of uniqueness: the compliance is the unit matrix plus at most 0.3 in the
    /// norm, so with μ ≤ 0.4 normal and tangential motion couple less than either resists.
    pub(crate) fn any() -> impl Strategy<Value = Self> {
        (1..=4_usize).prop_flat_map(|count| {
            let size = 2 * count;
            let motion = prop::collection::vec(-1.0..1.0_f64, size);
            (
                prop::collection::vec(-1.0..1.0_f64, size * size),
                prop::collection::vec(motion, 2),
                prop::collection::vec(-3.0..3.0_f64, count),
                prop::collection::vec(0.0..0.3_f64, count),
                0.0..0.4_f64,
                prop::collection::vec(prop::collection::vec(-2.0..2.0_f64, 2), 1..6),
            )
                .prop_map(move |(entries, responses, angles, gaps, mu, steps)| {
                    let factor = DMatrix::from_row_slice(size, size, &entries);
                    let square = &factor * factor.transpose();
                    let compliance =
                        DMatrix::identity(size, size) + &square * (0.3 / square.trace().max(1.0));
                    let responses = responses.into_iter().map(DVector::from_vec).collect();
                    Self {
                        compliance,
                        responses,
                        angles,
                        gaps,
                        mu,
                        steps,
                    }
                })
        })
    }

    pub(crate) fn count(&self) -> usize {
        self.gaps.len()
    }

    pub(crate) fn problem_with(&self, law: Arc<dyn FrictionLaw>) -> InterfaceProblem {
        let body = GivenBody::held(self.compliance.clone(), self.responses.clone()).unwrap();
        let normals = self
            .angles
            .iter()
            .map(|angle| [angle.cos(), angle.sin()])
            .collect();
        Ground {
            normals,
            gaps: self.gaps.clone(),
            law,
        }
        .under(&body)
    }

    pub(crate) fn problem(&self) -> InterfaceProblem {
        self.problem_with(coulomb(self.mu))
    }

    pub(crate) fn follow(&self, substeps: usize) -> Vec<StepRecord> {
        follow(&self.problem(), &self.steps, substeps)
    }

    /// The scene under the orthogonal map `map` of the plane, which turns the angle of every normal by `turn`.
    pub(crate) fn mapped(&self, map: &Matrix2<f64>, turn: impl Fn(f64) -> f64) -> Self {
        let mut all = DMatrix::zeros(2 * self.count(), 2 * self.count());
        for k in 0..self.count() {
            all.fixed_view_mut::<2, 2>(2 * k, 2 * k).copy_from(map);
        }
        Self {
            compliance: &all * &self.compliance * all.transpose(),
            responses: self
                .responses
                .iter()
                .map(|response| &all * response)
                .collect(),
            angles: self.angles.iter().map(|&angle| turn(angle)).collect(),
            ..self.clone()
        }
    }
}

pub(crate) fn follow(
    problem: &InterfaceProblem,
    steps: &[Vec<f64>],
    substeps: usize,
) -> Vec<StepRecord> {
    let history = LoadHistory::new(steps.to_vec(), substeps, Ramp::Linear).unwrap();
    history.follow(problem, &Chain::default(), |_| {}).unwrap()
}

pub(crate) fn assert_close(left: &DVector<f64>, right: &DVector<f64>) {
    let scale = left.amax().max(1.0);
    assert!((left - right).amax() < ROUNDING * scale, "{left} {right}");
}
