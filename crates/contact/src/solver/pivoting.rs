//! One step of Coulomb-type friction as a linear complementarity problem (Klarbring 1986), solved by pivoting.
//!
//! Pivoting finds the statuses of all points; an active-set iteration from there solves the forces, and corrects statuses
//! that rounding, springs or the law's curvature got wrong. A law that is not proportional to pressure enters by its
//! secant, F ≈ (F(p)/p) λ_n, and the problem is repeated with new secants until that iteration confirms the statuses.

use super::active_set::confirm;
use super::complementarity::{Candidate, Complementarity};
use super::step::Step;
use super::{FailureCause, InterfaceSolver, StepFailure, StepSolution, Work};

/// Complementary pivoting with covering vectors that exclude rays for supported bodies; it needs no start.
#[derive(Clone, Copy, Debug)]
pub struct Pivoting {
    /// Largest number of pivots per complementarity problem, in multiples of its order.
    pub pivots_per_unknown: usize,
    /// Number of covering vectors that are tried.
    pub covers: usize,
    /// Largest number of repetitions with new secants of the law.
    pub repetitions: usize,
}

impl Default for Pivoting {
    fn default() -> Self {
        Self {
            pivots_per_unknown: 50,
            covers: 4,
            repetitions: 20,
        }
    }
}

/// Softness of the springs that hold floating bodies, beside the bodies' own.
const SOFTNESS: [f64; 2] = [1e5, 1e3];

impl InterfaceSolver for Pivoting {
    fn name(&self) -> &'static str {
        "pivoting"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let mut work = Work::default();
        self.run(step, &mut work)
            .map_err(|cause| StepFailure::new(self.name(), cause, work))
    }
}

impl Pivoting {
    fn run(&self, step: &Step<'_>, work: &mut Work) -> Result<StepSolution, FailureCause> {
        let springs = if step.mode_load.is_empty() {
            &SOFTNESS[..1]
        } else {
            &SOFTNESS
        };
        let mut secants = Secants::new(step);
        let mut last = FailureCause::Ray;
        for _ in 0..self.repetitions {
            let coefficients = secants.coefficients(step);
            let mut next = None;
            for &softness in springs {
                let problem = Complementarity::new(step, coefficients.clone(), softness);
                for cover in 0..self.covers {
                    let Some(candidate) =
                        problem.solve(cover, self.pivots_per_unknown, &mut work.pivots)
                    else {
                        continue;
                    };
                    match confirm(step, &candidate, self.name(), work) {
                        Ok(solution) => {
                            return Ok(StepSolution {
                                work: *work,
                                ..solution
                            });
                        }
                        Err(cause) => last = cause,
                    }
                    next = Some(candidate);
                }
            }
            let Some(candidate) = next else {
                return Err(FailureCause::Ray);
            };
            secants.advance(&candidate);
            if secants.coefficients(step) == coefficients {
                return Err(last);
            }
        }
        Err(last)
    }
}

/// Where the law's secants are taken.
struct Secants {
    normal: Vec<f64>,
    slip: Vec<f64>,
    /// Points that slipped once stay on their slip traction, so that a drop of the traction ends the repetition.
    slipped: Vec<bool>,
}

impl Secants {
    fn new(step: &Step<'_>) -> Self {
        let count = step.count();
        Self {
            normal: step.starting_forces(),
            slip: vec![0.0; count],
            slipped: vec![false; count],
        }
    }

    /// F/λ_n of all points; at open ones that of a small force.
    fn coefficients(&self, step: &Step<'_>) -> Vec<f64> {
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

    fn advance(&mut self, candidate: &Candidate) {
        for (slipped, status) in self.slipped.iter_mut().zip(&candidate.status) {
            *slipped |= status.slip_sign() != 0.0;
        }
        self.normal.clone_from(&candidate.normal);
        self.slip.clone_from(&candidate.slip);
    }
}
