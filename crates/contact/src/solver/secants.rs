//! What the pivoting methods put in place of a law that is not proportional to pressure, and of rigid motions: secants and springs.

use super::candidate::Candidate;
use super::step::Step;

/// Softness of the springs that hold floating bodies, beside the bodies' own.
const SOFTNESS: [f64; 2] = [1e5, 1e3];

/// The softnesses to try; without floating bodies there are no springs.
pub(super) fn softnesses(step: &Step<'_>) -> &'static [f64] {
    if step.mode_load.is_empty() {
        &SOFTNESS[..1]
    } else {
        &SOFTNESS
    }
}

/// Where the law's secants are taken.
pub(super) struct Secants {
    normal: Vec<f64>,
    slip: Vec<f64>,
    /// Points that slipped once stay on their slip traction, so that a drop of the traction ends the repetition.
    slipped: Vec<bool>,
}

impl Secants {
    pub(super) fn new(step: &Step<'_>) -> Self {
        let count = step.count();
        Self {
            normal: step.starting_forces(),
            slip: vec![0.0; count],
            slipped: vec![false; count],
        }
    }

    /// F/λ_n of all points; at open ones that of a small force.
    pub(super) fn coefficients(&self, step: &Step<'_>) -> Vec<f64> {
        const SMALL: f64 = 1e-3;
        let largest = self
            .normal
            .iter()
            .fold(f64::MIN_POSITIVE, |largest, &force| largest.max(force));
        (0..step.count())
            .map(|k| {
                let force = self.normal[k].max(SMALL * largest);
                let bound = step.bound(k, force, self.slip[k]);
                if self.slipped[k] {
                    bound.slip / force
                } else {
                    bound.stick / force
                }
            })
            .collect()
    }

    pub(super) fn advance(&mut self, candidate: &Candidate) {
        for (slipped, status) in self.slipped.iter_mut().zip(&candidate.status) {
            *slipped |= status.slip_sign() != 0.0;
        }
        self.normal.clone_from(&candidate.normal);
        self.slip.clone_from(&candidate.slip);
    }
}
