//! Bodies of a model.

use std::sync::Arc;

use stickslip_fem_core::body::BodyError;
use stickslip_fem_core::{CondensedBody, ElasticBody, RigidBody};

use super::singular::{ReentrantCorner, Singular};
use crate::series::SeriesBody;

/// A body ready to be condensed.
#[derive(Clone, Debug)]
pub struct ModelBody {
    /// Name in the scene.
    pub name: String,
    /// What it is.
    pub kind: ModelBodyKind,
    /// Mesh nodes of its contact points, in the order that pairs refer to; empty for rigid bodies.
    pub interface: Vec<usize>,
    /// Ends of its edges among these where its compliance has a block for each; empty where it is one matrix.
    pub ends: Vec<usize>,
    /// Coordinate that the two halves differ in, where one of them is modelled.
    pub across: Option<usize>,
    /// Largest angle `[rad]` along its contact by which it was seated under load: its points are that far from those that they are paired with.
    pub seated: f64,
    /// Where its stresses have no bound.
    pub singular: Vec<Singular>,
    /// Nodes at which tractions along its edges end, and others where the boundary goes on without a corner, each with the load case of the traction, if it is no spring.
    pub sheared: Vec<(usize, Option<usize>)>,
    /// Its re-entrant corners, towards which stress has no limit either.
    pub corners: Vec<ReentrantCorner>,
    /// Whether its shape is one of triangles with corners anywhere.
    pub is_general: bool,
    /// Von Mises stress at which its material yields `[MPa]`, where the scene gives one.
    pub yield_stress: Option<f64>,
    /// Its operator where it is a series, ready; its mesh is then the places where fields are shown.
    pub series: Option<Arc<SeriesBody>>,
}

impl ModelBody {
    /// The nodes at which tractions of load cases that `acts`, and of springs, end.
    pub fn traction_ends(&self, acts: impl Fn(usize) -> bool) -> impl Iterator<Item = usize> {
        let own = self.sheared.iter();
        own.filter(move |own| own.1.is_none_or(&acts))
            .map(|own| own.0)
    }

    /// The body, its mesh, loads and materials; `None` for a rigid one.
    pub fn elastic(&self) -> Option<&Arc<ElasticBody>> {
        match &self.kind {
            ModelBodyKind::Elastic(body) => Some(body),
            ModelBodyKind::Rigid(_) => None,
        }
    }

    /// Condenses `elastic`, this body or one with its geometry, to the contact points.
    ///
    /// # Errors
    /// As [`ElasticBody::condense`].
    pub fn condense(&self, elastic: &Arc<ElasticBody>) -> Result<CondensedBody, BodyError> {
        if self.ends.is_empty() {
            elastic.condense(&self.interface)
        } else {
            elastic.condense_edges(&self.interface, &self.ends)
        }
    }
}

/// An elastic or a rigid body.
#[derive(Clone, Debug)]
pub enum ModelBodyKind {
    /// To be condensed.
    Elastic(Arc<ElasticBody>),
    /// Ready.
    Rigid(RigidBody),
}
