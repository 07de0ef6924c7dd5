//! Equilibrium of a step, reported and never assumed.

use crate::problem::InterfaceProblem;
use crate::state::ContactState;

/// Resultants and balances at the end of a load step.
#[derive(Clone, Debug, PartialEq)]
pub struct Audit {
    /// Resultant `[force]` of the contact forces on the first body of each pair, x and y.
    pub resultants: Vec<[f64; 2]>,
    /// Moment `[force·length]` of those forces about the origin.
    pub moments: Vec<f64>,
    /// Sum of |λ_t| over each pair `[force]`, and signed sum of λ_t.
    pub friction: Vec<FrictionSum>,
    /// Largest unbalanced resultant of a floating body, relative to the largest [`Self::scale`] of the whole history; while the
    /// history is still being followed, of the steps so far. So a step without load shows rounding too, not rounding by rounding.
    pub balance: f64,
    /// That unbalanced resultant itself `[force]`.
    pub unbalanced: f64,
    /// What forces are measured by `[force]`: the largest load resultant or sum of contact forces |λ| of a pair in this step.
    pub scale: f64,
    /// Virtual work of the contact forces on the gaps, Σ |λ_n g_n| relative to Σ |λ_n| times the largest motion or elastic
    /// give of a point: zero by complementarity.
    pub gap_work: f64,
}

/// Sums of contact forces over one pair.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrictionSum {
    /// Σ λ_n `[force]`.
    pub normal: f64,
    /// Σ λ_t `[force]`, along e_t.
    pub tangential: f64,
    /// Σ |λ_t| `[force]`.
    pub magnitude: f64,
}

impl Audit {
    /// Audits `state`.
    pub fn of(problem: &InterfaceProblem, state: &ContactState) -> Self {
        let pairs = problem.pairs().len();
        let mut audit = Self {
            resultants: vec![[0.0; 2]; pairs],
            moments: vec![0.0; pairs],
            friction: vec![FrictionSum::default(); pairs],
            balance: 0.0,
            unbalanced: 0.0,
            scale: 0.0,
            gap_work: 0.0,
        };
        let mut pressed = vec![0.0; pairs];
        let (mut work, mut effort) = (0.0, 0.0);
        // Where all points touch, their gaps are rounding, and no scale.
        let give = problem.compliance().diagonal().amax() * state.forces.amax();
        let widest = state.motion.amax().max(give);
        for (k, point) in problem.points().iter().enumerate() {
            let (normal, tangential) = (state.normal_force(k), state.tangential_force(k));
            let [pressing, shearing] = point.actions;
            let action = |i: usize| normal * pressing[i] + tangential * shearing[i];
            audit.resultants[point.pair][0] += action(0);
            audit.resultants[point.pair][1] += action(1);
            audit.moments[point.pair] += action(2);
            let sum = &mut audit.friction[point.pair];
            sum.normal += normal;
            sum.tangential += tangential;
            sum.magnitude += tangential.abs();
            pressed[point.pair] += normal.hypot(tangential);
            work += (normal * state.gap(k)).abs();
            effort += normal.abs() * widest;
        }
        audit.gap_work = if effort > 0.0 { work / effort } else { 0.0 };
        let load = problem.mode_load(&state.multipliers);
        let sum = &load + problem.modes().tr_mul(&state.forces);
        audit.scale = pressed.into_iter().fold(load.amax(), f64::max);
        audit.unbalanced = sum.amax();
        audit.measured_by(audit.scale);
        audit
    }

    /// Measures the balance by `scale` `[force]`.
    pub(crate) fn measured_by(&mut self, scale: f64) {
        self.balance = if scale > 0.0 {
            self.unbalanced / scale
        } else {
            0.0
        };
    }
}
