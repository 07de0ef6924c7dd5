//! What is reported of a joint's history.

use stickslip_contact::StepRecord;

use crate::damage::PlyEvent;
use crate::error::Halt;
use crate::state::{Energy, JointState};

/// One accepted increment: a point of the load–displacement curve.
#[derive(Clone, Debug)]
pub struct JointRecord {
    /// Index of the load step, from 0.
    pub step: usize,
    /// Part `[1]` of the load step reached at its end, in (0, 1].
    pub reached: f64,
    /// Multipliers of the load cases at its end `[1]`.
    pub multipliers: Vec<f64>,
    /// Load `[force]` by the joint's gauge.
    pub load: f64,
    /// Displacement `[length]` by the joint's gauge.
    pub displacement: f64,
    /// Energies since the start.
    pub energy: Energy,
    /// Contact, with `cutbacks` before the increment.
    pub contact: StepRecord,
    /// Plies that failed or began to flow.
    pub events: Vec<PlyEvent>,
    /// Redistributions at constant load.
    pub passes: usize,
    /// Unbalanced nodal forces, relative to the largest `[1]`, after each linearisation in which no ply failed.
    pub residuals: Vec<f64>,
    /// Numeric factorisations of bodies, those of failed attempts included.
    pub factorisations: usize,
}

/// How a history ended.
#[derive(Clone, Debug)]
pub enum Ending {
    /// All load steps were followed.
    Completed,
    /// Beyond this no equilibrium was found, or none near: under given loads the load reached is the joint's strength.
    NoEquilibrium {
        /// Index of the load step, from 0.
        step: usize,
        /// Part of it that was reached `[1]`.
        reached: f64,
        /// Why the smallest increment beyond failed.
        cause: Halt,
        /// What failed in that increment before it was given up: how the joint comes apart.
        collapse: Vec<PlyEvent>,
    },
    /// Supports were driven until the joint came apart: what it bears at the end is borne by what failed plies are left with.
    Severed {
        /// Index of the load step, from 0.
        step: usize,
        /// Part of it that was reached `[1]`.
        reached: f64,
    },
    /// The load has fallen to the part of its peak at which a history ends.
    LoadDropped {
        /// Index of the load step, from 0.
        step: usize,
        /// Part of it that was reached `[1]`.
        reached: f64,
    },
}

/// A joint's history.
#[derive(Clone, Debug)]
pub struct JointHistory {
    /// Accepted increments; never empty.
    pub records: Vec<JointRecord>,
    /// How it ended.
    pub ending: Ending,
    /// The joint at its end.
    pub state: JointState,
    /// Numeric factorisations in all.
    pub factorisations: usize,
}

impl JointHistory {
    /// Index of the record with the largest load, the first of equals.
    pub fn peak(&self) -> usize {
        let mut best = 0;
        for (index, record) in self.records.iter().enumerate() {
            if record.load > self.records[best].load {
                best = index;
            }
        }
        best
    }

    /// Index of the first record after which the load fell by the part `drop` `[1]` of itself, or more, before it rose above it again: the
    /// first peak of a curve that climbs on, as in bearing. `None` if there is no such fall.
    pub fn first_peak(&self, drop: f64) -> Option<usize> {
        let mut best = 0;
        for (index, record) in self.records.iter().enumerate() {
            if record.load >= self.records[best].load {
                best = index;
            } else if record.load <= (1.0 - drop) * self.records[best].load {
                return Some(best);
            }
        }
        None
    }

    /// The largest load `[force]` that the joint bore, if the history shows that it cannot bear more: no equilibrium was found beyond,
    /// the joint was severed, or the load has fallen to the part of it at which a history ends. A dip shows no strength: the load may climb again.
    pub fn strength(&self) -> Option<f64> {
        let shown = !matches!(self.ending, Ending::Completed);
        shown.then(|| self.records[self.peak()].load)
    }

    /// All events, in the order in which they happened.
    pub fn events(&self) -> impl Iterator<Item = &PlyEvent> {
        self.records.iter().flat_map(|record| &record.events)
    }

    /// The first ply failure: of plies that fail in one increment, the first in the order of bodies, points and layers.
    pub fn first_failure(&self) -> Option<&PlyEvent> {
        self.events().find(|event| event.is_failure())
    }
}
