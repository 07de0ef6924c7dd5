//! What an outer edge adds to the potentials of an anisotropic plate.

use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

use nalgebra::Complex;

use crate::arnoldi::{Basis, sum};
use crate::lekhnitskii::Planes;
use crate::outline::corner_log;

type C64 = Complex<f64>;

/// What an outer edge adds in both planes: coefficients of polynomials, and amounts of the terms of corners.
#[derive(Clone, Debug)]
pub(crate) struct OuterPlanes {
    planes: Planes,
    bases: [Arc<Basis>; 2],
    coefficients: [Vec<C64>; 2],
    corners: [Vec<(C64, C64)>; 2],
    /// Coefficients of Φ_k0, and what is to be taken off so that it has no mean.
    further: OnceLock<[(Vec<C64>, C64); 2]>,
}

impl OuterPlanes {
    /// The polynomials Σ `coefficients[k][n]` q_n, of degrees below those of the bases, and ln(1 − w/c) times the amount of each of the `corners`.
    pub(crate) fn new(
        planes: Planes,
        bases: [Arc<Basis>; 2],
        coefficients: [Vec<C64>; 2],
        corners: [Vec<(C64, C64)>; 2],
    ) -> Self {
        Self {
            planes,
            bases,
            coefficients,
            corners,
            further: OnceLock::new(),
        }
    }

    /// φ_k0.
    pub(super) fn phi(&self, plane: usize, place: C64) -> C64 {
        let w = self.planes.at(plane, place);
        let corners = self.corners[plane].iter();
        let of_corners = corners.map(|(corner, amount)| amount * corner_log(*corner, w));
        sum(&self.coefficients[plane], &self.bases[plane].values(w)) + of_corners.sum::<C64>()
    }

    /// φ_k0 and Φ_k0.
    pub(super) fn both(&self, plane: usize, place: C64) -> [C64; 2] {
        let further = self
            .further
            .get_or_init(|| [0, 1].map(|plane| self.integrated(plane)));
        let (coefficients, mean) = &further[plane];
        let [phi, integral] = self.both_by(plane, place, coefficients);
        [phi, integral - mean]
    }

    fn integrated(&self, plane: usize) -> (Vec<C64>, C64) {
        const PLACES: usize = 256;
        let coefficients = self.bases[plane].antiderivative(&self.coefficients[plane]);
        let count = PLACES.max(2 * self.bases[plane].degree() + 4);
        let places = (0..count).map(|k| C64::from_polar(1.0, k as f64 * TAU / count as f64));
        let all = places.map(|place| self.both_by(plane, place, &coefficients)[1]);
        let mean = all.sum::<C64>() / count as f64;
        (coefficients, mean)
    }

    fn both_by(&self, plane: usize, place: C64, coefficients: &[C64]) -> [C64; 2] {
        let w = self.planes.at(plane, place);
        let values = self.bases[plane].values(w);
        let mut phi = sum(&self.coefficients[plane], &values);
        let mut integral = sum(coefficients, &values);
        for (corner, amount) in &self.corners[plane] {
            let log = corner_log(*corner, w);
            phi += amount * log;
            // ∫ ln(1 − w/c) = −(c − w) ln(1 − w/c) − w.
            integral += amount * (-(corner - w) * log - w);
        }
        [phi, integral]
    }
}
