//! A model whose history has been followed.

use std::sync::Arc;

use stickslip_contact::thinned::Thinned;
use stickslip_contact::{Facing, Interface, StepRecord};
use stickslip_fem_core::{CondensedBody, InterfaceOperator};

use crate::series::SeriesBody;

/// A body as the interface problem sees it.
#[derive(Clone, Debug)]
pub enum Operator {
    /// Condensed finite elements.
    Elastic(Arc<CondensedBody>),
    /// A series.
    Series(Arc<SeriesBody>),
    /// Rigid.
    Rigid(stickslip_fem_core::RigidBody),
}

impl Operator {
    /// The operator's common face.
    pub fn interface(&self) -> &dyn InterfaceOperator {
        match self {
            Self::Elastic(body) => body.as_ref(),
            Self::Series(body) => body.interface(),
            Self::Rigid(body) => body,
        }
    }

    /// The body by series, if it is one.
    pub fn series(&self) -> Option<&SeriesBody> {
        match self {
            Self::Series(body) => Some(body),
            Self::Elastic(_) | Self::Rigid(_) => None,
        }
    }

    /// The condensed body, if it is made of finite elements.
    pub fn elastic(&self) -> Option<&CondensedBody> {
        match self {
            Self::Elastic(body) => Some(body),
            Self::Series(_) | Self::Rigid(_) => None,
        }
    }
}

/// A model whose history has been followed.
#[derive(Debug)]
pub struct Solved {
    /// One operator per body.
    pub operators: Vec<Operator>,
    /// All contacts, in independent parts.
    pub interface: Interface,
    /// One record per load step.
    pub records: Vec<StepRecord>,
    /// The nodes of every load step, where these are not all.
    pub own: Option<OwnNodes>,
    /// Wall time of each load step `[s]`.
    pub step_seconds: Vec<f64>,
    /// Wall time of the phases `[s]`.
    pub phases: Vec<(&'static str, f64)>,
}

/// Load steps on nodes of their own.
#[derive(Debug)]
pub struct OwnNodes {
    /// The contacts of every step.
    pub thinned: Vec<Thinned>,
    /// One record per load step, of its own points.
    pub records: Vec<StepRecord>,
    /// How bodies sit in their holes in every step, where that is not as in the model.
    pub seated: Vec<Option<Arc<Seated>>>,
}

/// The bodies and undeformed edges of a load step in which bodies by series sit in their holes otherwise than in the model.
#[derive(Clone, Debug)]
pub struct Seated {
    /// One operator per body.
    pub(super) operators: Vec<Operator>,
    /// One per contact pair.
    pub(super) facings: Vec<Facing>,
}

impl OwnNodes {
    /// Number of compliances `[1]` that steps have of their own.
    pub fn matrices(&self) -> usize {
        let mut own: Vec<&Arc<Seated>> = self.seated.iter().flatten().collect();
        own.sort_by_key(|own| Arc::as_ptr(own));
        own.dedup_by_key(|own| Arc::as_ptr(own));
        own.len()
    }
}

impl Solved {
    /// How bodies sit in the load step with this index, where that is not as in the model.
    pub(super) fn seated(&self, step: usize) -> Option<&Seated> {
        self.own.as_ref()?.seated.get(step)?.as_deref()
    }

    /// Forces `[N]` on the contact points of body `body` at the end of the load step `record`, interleaved, on its nodes in the model.
    pub fn forces_on_body(&self, record: &StepRecord, body: usize) -> Vec<f64> {
        if let Some(on_bodies) = &record.on_bodies {
            return on_bodies[body].clone();
        }
        let count = self.operators[body].interface().points().len();
        let forces = &record.state.forces;
        match &record.contacts {
            Some(contacts) => contacts.forces_on_body(body, count, forces),
            None => self.interface.forces_on_body(body, count, forces),
        }
    }
}
