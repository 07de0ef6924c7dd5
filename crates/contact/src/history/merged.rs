//! The records of all parts of an interface as one record of the whole.

use std::sync::Arc;

use nalgebra::DVector;
use stickslip_friction::History;

use super::{Cycle, Recovery, StepRecord};
use crate::audit::{FloatingBalance, PairSums};
use crate::error::ContactError;
use crate::interface::{Interface, Part};
use crate::problem::Contacts;
use crate::state::{ContactState, Status};

impl Interface {
    /// The record of the whole from those of its parts, in their order.
    pub(super) fn merged(&self, mut parts: Vec<StepRecord>) -> StepRecord {
        if self.is_undivided()
            && let Some(only) = parts.pop()
        {
            return only;
        }
        let count = self.contacts().points().len();
        let mut whole = StepRecord::at(ContactState {
            forces: DVector::zeros(2 * count),
            motion: DVector::zeros(2 * count),
            rigid: DVector::zeros(self.mode_count()),
            status: vec![Status::Open; count],
            history: vec![History::default(); count],
            multipliers: Vec::new(),
        });
        whole.audit.pairs = vec![PairSums::default(); self.contacts().pairs().len()];
        for (part, record) in self.parts().iter().zip(&parts) {
            add(&mut whole, part, record);
        }
        whole.contacts = self.merged_contacts(&parts);
        near_its_bound(&mut whole, &parts);
        whole.loose.sort_unstable();
        whole.sliding.sort_unstable();
        whole.audit.bodies.sort_by_key(|balance| balance.body);
        whole.parts = parts;
        whole
    }

    /// The contact points on the deformed geometry, where the records of `parts` have them.
    fn merged_contacts(&self, parts: &[StepRecord]) -> Option<Arc<Contacts>> {
        let mut whole: Option<Contacts> = None;
        for (part, record) in self.parts().iter().zip(parts) {
            if let Some(contacts) = &record.contacts {
                let whole = whole.get_or_insert_with(|| self.contacts().clone());
                let group = part.group();
                whole.take_points(contacts, [&group.bodies, &group.pairs, part.points()]);
            }
        }
        whole.map(Arc::new)
    }

    /// The end of a history as it is reported of the whole: with the bodies of its part `part`.
    pub(super) fn ended(&self, part: usize, mut error: ContactError) -> ContactError {
        if let ContactError::StepFailed { bodies, .. } = &mut error
            && !self.is_undivided()
        {
            bodies.clone_from(&self.parts()[part].group().bodies);
        }
        error
    }
}

fn add(whole: &mut StepRecord, part: &Part, record: &StepRecord) {
    let (to, from) = (&mut whole.state, &record.state);
    for (own, &k) in part.points().iter().enumerate() {
        for component in 0..2 {
            to.forces[2 * k + component] = from.forces[2 * own + component];
            to.motion[2 * k + component] = from.motion[2 * own + component];
        }
        to.status[k] = from.status[own];
        to.history[k] = from.history[own];
        whole.slip[k] = record.slip[own];
        whole.friction_work[k] = record.friction_work[own];
    }
    for (own, &mode) in part.modes().iter().enumerate() {
        to.rigid[mode] = from.rigid[own];
    }
    to.multipliers.clone_from(&from.multipliers);

    whole.work += record.work;
    whole.residuals = whole.residuals.worse(record.residuals);
    whole.verified &= record.verified;
    whole.doubtful += record.doubtful;
    for solver in &record.solvers {
        if !whole.solvers.contains(solver) {
            whole.solvers.push(solver);
        }
    }
    add_recovery(&mut whole.recovery, part, &record.recovery);
    whole.solutions = whole.solutions.max(record.solutions);
    let (bodies, pairs) = (&part.group().bodies, &part.group().pairs);
    let numbered = |own: &usize| pairs[*own];
    whole.loose.extend(record.loose.iter().map(numbered));
    whole.sliding.extend(record.sliding.iter().map(numbered));
    whole.parted |= record.parted;
    whole.coefficient = whole.coefficient.max(record.coefficient);
    whole.increments = whole.increments.max(record.increments);
    whole.cutbacks += record.cutbacks;
    for (sums, &pair) in record.audit.pairs.iter().zip(pairs) {
        whole.audit.pairs[pair] = *sums;
    }
    let balances = record.audit.bodies.iter().map(|balance| FloatingBalance {
        body: bodies[balance.body],
        ..*balance
    });
    whole.audit.bodies.extend(balances);
    whole.audit.gap_work = whole.audit.gap_work.max(record.audit.gap_work);
}

fn add_recovery(whole: &mut Recovery, part: &Part, own: &Recovery) {
    for entry in &own.failures {
        whole.count(entry.solver, entry.kind, entry.count);
    }
    if whole.first_cycle.is_none() {
        whole.first_cycle = own.first_cycle.as_ref().map(|cycle| Cycle {
            points: cycle.points.iter().map(|&k| part.points()[k]).collect(),
            ..*cycle
        });
    }
}

/// Where the bound of uniqueness was estimated, the friction and the bound of that part whose friction is nearest to its bound.
fn near_its_bound(whole: &mut StepRecord, parts: &[StepRecord]) {
    let estimated = parts.iter().filter(|part| part.uniqueness.is_some());
    let nearness = |part: &StepRecord| part.coefficient / part.uniqueness.unwrap_or(f64::INFINITY);
    let nearest = estimated.max_by(|a, b| nearness(a).total_cmp(&nearness(b)));
    if let Some(nearest) = nearest {
        whole.coefficient = nearest.coefficient;
        whole.uniqueness = nearest.uniqueness;
    }
}
