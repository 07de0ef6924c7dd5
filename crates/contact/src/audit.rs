//! Equilibrium of a step, reported and never assumed.

use crate::problem::{Contacts, InterfaceProblem};
use crate::state::ContactState;

/// Part of the largest forces on a body in the history that its forces in a step are at least measured by: below that, what is left
/// is rounding of the forces that were there.
const FLOOR: f64 = 1e-3;

/// The same part of the largest forces on any of the bodies: a body at rest beside others has rounding alone.
const FLOOR_OF_ALL: f64 = 1e-6;

/// Resultants and balances at the end of a load step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Audit {
    /// Sums of the contact forces of each pair.
    pub pairs: Vec<PairSums>,
    /// Balance of each body that can move as a whole.
    pub bodies: Vec<FloatingBalance>,
    /// Virtual work of the contact forces on the gaps, Σ |λ_n g_n| relative to Σ |λ_n| times the largest motion or elastic
    /// give of a point `[1]`: zero by complementarity.
    pub gap_work: f64,
}

/// Sums of the contact forces over one pair, as they act on its first body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairSums {
    /// Resultant `[force]`, x and y.
    pub resultant: [f64; 2],
    /// Moment about the origin `[force·length]`.
    pub moment: f64,
    /// Σ λ_n `[force]`.
    pub normal: f64,
    /// Σ λ_t `[force]`, along e_t.
    pub tangential: f64,
    /// Σ |λ_t| `[force]`.
    pub friction: f64,
    /// Σ |λ| `[force]`.
    pub magnitude: f64,
}

impl PairSums {
    /// The sums of every pair in `state`.
    pub fn of(contacts: &Contacts, state: &ContactState) -> Vec<Self> {
        let mut sums = vec![Self::default(); contacts.pairs().len()];
        for (k, point) in contacts.points().iter().enumerate() {
            let (normal, tangential) = (state.normal_force(k), state.tangential_force(k));
            let [pressing, shearing] = point.actions;
            let action = |i: usize| normal * pressing[i] + tangential * shearing[i];
            let sum = &mut sums[point.pair];
            sum.resultant[0] += action(0);
            sum.resultant[1] += action(1);
            sum.moment += action(2);
            sum.normal += normal;
            sum.tangential += tangential;
            sum.friction += tangential.abs();
            sum.magnitude += normal.hypot(tangential);
        }
        sums
    }
}

/// What the rigid motions of a body leave unbalanced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatingBalance {
    /// Index of the body.
    pub body: usize,
    /// Largest unbalanced resultant of its loads and contact forces `[force]`.
    pub unbalanced: f64,
    /// What its forces are measured by `[force]`: its largest load resultant or sum of contact forces |λ| of a pair in this step.
    pub scale: f64,
    /// The unbalanced resultant `[1]` relative to [`Self::scale`], to a thousandth of the body's largest in the whole history or to a
    /// millionth of that of all bodies, whichever is more; while the history is still being followed, in the steps so far. So a step without load shows rounding too, not
    /// rounding by rounding.
    pub relative: f64,
}

impl FloatingBalance {
    fn of(
        problem: &InterfaceProblem,
        state: &ContactState,
        pairs: &[PairSums],
        body: usize,
    ) -> Option<Self> {
        let modes = problem.body_modes(body);
        if modes.is_empty() {
            return None;
        }
        let load = problem.mode_load(&state.multipliers);
        let load = load.rows_range(modes.clone());
        let sum = load + problem.modes().columns_range(modes).tr_mul(&state.forces);
        let own = problem.pairs().iter().zip(pairs);
        let presses = own
            .filter(|(pair, _)| {
                [pair.first, pair.second]
                    .map(|own| problem.carrier(own))
                    .contains(&body)
            })
            .map(|(_, sums)| sums.magnitude);
        let mut balance = Self {
            body,
            unbalanced: sum.amax(),
            scale: presses.fold(load.amax(), f64::max),
            relative: 0.0,
        };
        balance.measured_by(0.0, 0.0);
        Some(balance)
    }

    fn measured_by(&mut self, largest: f64, largest_of_all: f64) {
        let scale = (self.scale)
            .max(FLOOR * largest)
            .max(FLOOR_OF_ALL * largest_of_all);
        self.relative = if scale > 0.0 {
            self.unbalanced / scale
        } else {
            0.0
        };
    }
}

impl Audit {
    /// Audits `state`.
    pub fn of(problem: &InterfaceProblem, state: &ContactState) -> Self {
        let pairs = PairSums::of(problem.contacts(), state);
        let bodies = (0..problem.body_count())
            .filter_map(|body| FloatingBalance::of(problem, state, &pairs, body))
            .collect();
        // Where all points touch, their gaps are rounding, and no scale.
        let give = problem.largest_give() * state.forces.amax();
        let widest = state.motion.amax().max(give);
        let (mut work, mut effort) = (0.0, 0.0);
        for k in 0..problem.points().len() {
            let normal = state.normal_force(k);
            work += (normal * state.gap(k)).abs();
            effort += normal.abs() * widest;
        }
        Self {
            pairs,
            bodies,
            gap_work: if effort > 0.0 { work / effort } else { 0.0 },
        }
    }

    /// The largest relative imbalance of a floating body `[1]`.
    pub fn balance(&self) -> f64 {
        let relative = self.bodies.iter().map(|body| body.relative);
        relative.fold(0.0, f64::max)
    }
}

/// The largest scale of each floating body in the audits of one history `[force]`.
#[derive(Clone, Debug, Default)]
pub(crate) struct LargestScales(Vec<f64>);

impl LargestScales {
    /// Takes `audit` into account, and measures its balance by the largest scales so far.
    pub(crate) fn add(&mut self, audit: &mut Audit) {
        self.0.resize(audit.bodies.len(), 0.0);
        for (largest, body) in self.0.iter_mut().zip(&audit.bodies) {
            *largest = largest.max(body.scale);
        }
        self.measure(audit);
    }

    /// Measures the balance of each body in `audit` by its largest scale.
    pub(crate) fn measure(&self, audit: &mut Audit) {
        let of_all = self.0.iter().copied().fold(0.0, f64::max);
        for (largest, body) in self.0.iter().zip(&mut audit.bodies) {
            body.measured_by(*largest, of_all);
        }
    }
}
