//! From chosen nodes to all of them, and on to those of the next step.

use std::sync::Arc;

use nalgebra::{DVector, Vector2};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::mesh::Point;
use stickslip_friction::History;

use super::record::StepRecord;
use crate::audit::PairSums;
use crate::interface::Part;
use crate::problem::{ContactPair, Contacts, frame};
use crate::state::{ContactState, Status};
use crate::thinned::{Thinned, ThinnedBody, Whole};

/// All points of a scene, and those that are chosen for a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Carry<'a> {
    pub(super) whole: &'a Whole<'a>,
    pub(super) thinned: &'a Thinned,
}

impl Carry<'_> {
    /// The record of all points for `own`, the record of a step on the chosen ones, and the displacements of all points of each body.
    pub(super) fn expand(&self, own: &StepRecord) -> (StepRecord, Vec<DVector<f64>>) {
        let whole = self.whole;
        let contacts = own.contacts_of(self.thinned.interface.contacts());
        let amounts: Vec<Vec<f64>> = (0..self.thinned.bodies.len())
            .map(|body| self.thinned.interface.motions_of_body(body, &own.state))
            .collect();
        let on_bodies = self.forces(own);
        let bodies = whole.bodies.iter().zip(&on_bodies).zip(&amounts);
        let multipliers = &own.state.multipliers;
        let moved: Vec<DVector<f64>> = bodies
            .map(|((body, forces), amounts)| body.displacements(forces, amounts, multipliers))
            .collect();
        let count = whole.interface.contacts().points().len();
        let mut record = StepRecord {
            slip: DVector::zeros(count),
            friction_work: DVector::zeros(count),
            contacts: None,
            parts: Vec::new(),
            ..own.clone()
        };
        record.state = ContactState {
            forces: DVector::zeros(2 * count),
            motion: DVector::zeros(2 * count),
            rigid: whole.interface.rigid_of(&amounts),
            status: vec![Status::Open; count],
            history: vec![History::default(); count],
            multipliers: own.state.multipliers.clone(),
        };
        for pair in 0..self.thinned.hats.len() {
            self.expand_pair(pair, own, &moved, &mut record);
        }
        if let Some(cycle) = &mut record.recovery.first_cycle {
            cycle.points.iter_mut().for_each(|k| *k = self.point(*k));
        }
        record.contacts = own
            .contacts
            .as_ref()
            .map(|_| Arc::new(self.tilted(contacts)));
        let seen = record.contacts_of(whole.interface.contacts());
        record.audit.pairs = PairSums::of(seen, &record.state);
        record.on_bodies = Some(Arc::new(on_bodies));
        (record, moved)
    }

    /// The point of `whole` that is the chosen one `own`.
    fn point(&self, own: usize) -> usize {
        let contacts = self.thinned.interface.contacts();
        let pair = contacts.points()[own].pair;
        let first = self.whole.interface.contacts().pair_points(pair).start;
        first + self.thinned.hats[pair].chosen()[own - contacts.pair_points(pair).start]
    }

    /// Forces on all contact points of each body, at the end of a step on the chosen ones.
    fn forces(&self, own: &StepRecord) -> Vec<Vec<f64>> {
        let thinned = self.thinned.bodies.iter();
        let bodies = thinned.zip(&self.whole.bodies).enumerate();
        let forces = |(index, (thin, body)): (usize, (&ThinnedBody, &&dyn InterfaceOperator))| {
            let count = thin.points().len();
            let on_hats = match &own.contacts {
                Some(contacts) => contacts.forces_on_body(index, count, &own.state.forces),
                None => self
                    .thinned
                    .interface
                    .forces_on_body(index, count, &own.state.forces),
            };
            thin.spread(&on_hats, body.points().len())
        };
        bodies.map(forces).collect()
    }

    fn expand_pair(
        &self,
        index: usize,
        own: &StepRecord,
        moved: &[DVector<f64>],
        record: &mut StepRecord,
    ) {
        let hats = &self.thinned.hats[index];
        let first = self.thinned.interface.contacts().pair_points(index).start;
        let points = self.whole.interface.contacts().pair_points(index);
        let pair = &self.whole.interface.contacts().pairs()[index];
        let state = &mut record.state;
        for (hat, k) in hats.all().iter().zip(first..) {
            for &(point, weight) in &hat.terms {
                let at = points.start + point;
                for i in 0..2 {
                    state.forces[2 * at + i] += weight * own.state.forces[2 * k + i];
                }
                record.friction_work[at] += weight * own.friction_work[k];
            }
        }
        let linear: Vec<[f64; 2]> = relative(pair, moved);
        // What motions on the deformed geometry have beyond those that are linear in displacements.
        let beyond: Vec<[f64; 2]> = (hats.all().iter().zip(first..))
            .map(|(hat, k)| {
                let mean = |i: usize| hat.mean(|point| linear[point][i]);
                [0, 1].map(|i| own.state.motion[2 * k + i] - mean(i))
            })
            .collect();
        for (point, over) in hats.over().iter().enumerate() {
            let at = points.start + point;
            for i in 0..2 {
                let more: f64 = over
                    .iter()
                    .map(|(hat, value)| value * beyond[*hat][i])
                    .sum();
                state.motion[2 * at + i] = linear[point][i] + more;
            }
            record.slip[at] = over
                .iter()
                .map(|(hat, value)| value * own.slip[first + hat])
                .sum();
            let touches = |(hat, _): &&(usize, f64)| own.state.status[first + hat].touches();
            // Pressure reaches from a point that touches to its neighbours.
            let nearest = over.iter().find(touches).unwrap_or(&over[0]).0;
            state.status[at] = own.state.status[first + nearest];
            let memory = |hat: usize| own.state.history[first + hat];
            state.history[at] = match over[..] {
                [(one, _), (other, part)] => memory(one).between(&memory(other), part),
                _ => memory(over[0].0),
            };
        }
    }

    /// All contact points, with normals that tilt as those of `thinned` do.
    fn tilted(&self, thinned: &Contacts) -> Contacts {
        let mut pairs: Vec<ContactPair> = self.whole.interface.contacts().pairs().to_vec();
        for (index, pair) in pairs.iter_mut().enumerate() {
            let hats = &self.thinned.hats[index];
            let first = thinned.pair_points(index).start;
            let tilts: Vec<f64> = (hats.all().iter().zip(&thinned.points()[first..]))
                .map(|(hat, point)| angle(hat.normal, point.normal))
                .collect();
            for (point, over) in pair.points.iter_mut().zip(hats.over()) {
                let tilt: f64 = over.iter().map(|(hat, value)| value * tilts[*hat]).sum();
                let (sine, cosine) = tilt.sin_cos();
                let [x, y] = point.normal;
                point.normal = [cosine * x - sine * y, sine * x + cosine * y];
            }
        }
        Contacts::new(pairs, &self.whole.bodies)
    }

    /// The displacements `moved` of all points of each body, as its nodes stand in `before`, where they stand here.
    pub(super) fn move_to_nodes(&self, before: &Whole<'_>, moved: &mut [DVector<f64>]) {
        let pairs = self.whole.interface.contacts().pairs();
        let facings = before.facings.iter().zip(&self.whole.facings);
        for (pair, (from, to)) in pairs.iter().zip(facings) {
            let (from, to) = (&from.second, &to.second);
            if from.places() == to.places() {
                continue;
            }
            let body = &mut moved[pair.second];
            let nodes = from.nodes();
            let known: Vec<Point> = nodes
                .iter()
                .map(|&node| [body[2 * node], body[2 * node + 1]])
                .collect();
            for (&node, &place) in nodes.iter().zip(to.places()) {
                let [x, y] = from.displacement(&known, place);
                (body[2 * node], body[2 * node + 1]) = (x, y);
            }
        }
    }

    /// The start of a step on the chosen points from the end of `before`, a record of all points where bodies are displaced by `moved`; one of each part of the interface.
    pub(super) fn start(&self, before: &StepRecord, moved: &[DVector<f64>]) -> Vec<StepRecord> {
        let whole = self.whole;
        let amounts: Vec<Vec<f64>> = (0..whole.bodies.len())
            .map(|body| whole.interface.motions_of_body(body, &before.state))
            .collect();
        let means: Vec<DVector<f64>> = (self.thinned.bodies.iter().zip(moved))
            .map(|(body, moved)| body.mean(moved))
            .collect();
        let rigid = self.thinned.interface.rigid_of(&amounts);
        let contacts = self.thinned.interface.contacts();
        let motion: Vec<[f64; 2]> = (contacts.pairs().iter())
            .flat_map(|pair| relative(pair, &means))
            .collect();
        let areas = |k: usize| contacts.points()[k].area;
        let all = whole.interface.contacts().points();
        let start = |part: &Part| {
            let own = part.points();
            let from: Vec<usize> = own.iter().map(|&k| self.point(k)).collect();
            let both = || own.iter().zip(&from);
            let forces = both().flat_map(|(&k, &at)| {
                let scale = areas(k) / all[at].area;
                [0, 1].map(|i| scale * before.state.forces[2 * at + i])
            });
            let record = StepRecord::at(ContactState {
                forces: DVector::from_iterator(2 * own.len(), forces),
                motion: DVector::from_iterator(2 * own.len(), own.iter().flat_map(|&k| motion[k])),
                rigid: DVector::from_iterator(
                    part.modes().len(),
                    part.modes().iter().map(|&mode| rigid[mode]),
                ),
                status: from.iter().map(|&at| before.state.status[at]).collect(),
                history: from.iter().map(|&at| before.state.history[at]).collect(),
                multipliers: before.state.multipliers.clone(),
            });
            let bodies = part.group().bodies.iter();
            StepRecord {
                moved: Some(Arc::new(bodies.map(|&body| means[body].clone()).collect())),
                ..record
            }
        };
        self.thinned.interface.parts().iter().map(start).collect()
    }
}

/// Gap and tangential displacement of the points of `pair`, single nodes of bodies that are displaced by `moved`, on the undeformed geometry.
fn relative(pair: &ContactPair, moved: &[DVector<f64>]) -> Vec<[f64; 2]> {
    let at = |body: usize, node: Option<usize>| -> Vector2<f64> {
        moved[body]
            .fixed_rows::<2>(2 * node.unwrap_or_default())
            .into_owned()
    };
    let points = pair.points.iter().map(|point| {
        let apart = at(pair.first, point.first.node()) - at(pair.second, point.second.node());
        let own = frame(point.normal) * apart;
        [own[0] + point.gap, own[1]]
    });
    points.collect()
}

/// The angle from the unit vector `from` to `to`.
fn angle(from: [f64; 2], to: [f64; 2]) -> f64 {
    let sine = from[0] * to[1] - from[1] * to[0];
    sine.atan2(from[0] * to[0] + from[1] * to[1])
}
