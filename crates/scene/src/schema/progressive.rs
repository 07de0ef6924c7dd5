//! Settings of the progressive failure analysis of a joint.

use std::sync::Arc;

use stickslip_joint::FractureEnergies;
use stickslip_laminate::FailureCriterion;
use stickslip_laminate::laminate::Laminate;
use stickslip_laminate::progressive::{PointModel, PointModelParameters, ProgressiveError};

use super::{Axis, SetRef};

/// The question of `[failure.progressive]`.
#[derive(Debug, Clone)]
pub struct Progressive {
    /// The laminated body whose plies fail; one contact touches its hole.
    pub body: String,
    /// How its plies lose stiffness.
    pub model: ProgressiveModel,
    /// Fracture energies `[N/mm]` that scale the strengths with the mesh, by ply discount only.
    pub crack_band: Option<FractureEnergies>,
    /// What is raised.
    pub control: Control,
}

/// How plies lose stiffness: a registered point model, as the scene gives it.
#[derive(Debug, Clone)]
pub struct ProgressiveModel {
    /// Its parameters.
    pub parameters: Arc<dyn PointModelParameters>,
    /// The criterion by which plies fail, for a model that needs one.
    pub criterion: Arc<dyn FailureCriterion>,
}

/// What is raised until the joint fails.
#[derive(Debug, Clone, PartialEq)]
pub enum Control {
    /// The loads, through the scene's steps.
    Loads {
        /// Increments of each step.
        increments: usize,
    },
    /// The displacement of an edge or point, in place of all loads.
    Displacement {
        /// What is driven.
        on: SetRef,
        /// Along which axis.
        axis: Axis,
        /// To where `[mm]`.
        end: f64,
        /// In how many increments.
        increments: usize,
        /// Part of the peak load, in (0, 1], by which the load falls before the history ends.
        drop: f64,
    },
}

impl ProgressiveModel {
    /// The model of a point of `laminate`.
    ///
    /// # Errors
    /// [`ProgressiveError`] for a missing strength, or strengths whose yield surface is open.
    pub fn point(&self, laminate: Laminate) -> Result<Arc<dyn PointModel>, ProgressiveError> {
        self.parameters.model(laminate, &self.criterion)
    }
}
