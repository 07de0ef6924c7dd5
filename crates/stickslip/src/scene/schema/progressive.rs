//! What is asked about the progressive failure of a joint.

use std::sync::Arc;

use stickslip_joint::FractureEnergies;
use stickslip_laminate::laminate::Laminate;
use stickslip_laminate::progressive::{
    PlyDiscount, PointModel, ProgressiveError, TsaiHillPlasticity,
};
use stickslip_laminate::{
    Assessment, Degradation, FailureCriterion, FailureError, Ply, PlyLoading, Strength,
};

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

/// How plies lose stiffness.
#[derive(Debug, Clone)]
pub enum ProgressiveModel {
    /// At once, by a failure criterion.
    PlyDiscount {
        /// The criterion.
        criterion: Arc<dyn FailureCriterion>,
        /// What failed plies keep.
        degradation: Degradation,
    },
    /// By plastic flow from the Tsai–Hill surface on.
    Plasticity {
        /// H `[1/MPa]`, see [`TsaiHillPlasticity::new`].
        hardening: f64,
    },
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
        Ok(match self {
            Self::PlyDiscount {
                criterion,
                degradation,
            } => {
                let shared = Box::new(Shared(Arc::clone(criterion)));
                Arc::new(PlyDiscount::new(laminate, shared, *degradation)?)
            }
            Self::Plasticity { hardening } => {
                Arc::new(TsaiHillPlasticity::new(laminate, *hardening)?)
            }
        })
    }
}

/// A criterion that many points use.
#[derive(Debug)]
struct Shared(Arc<dyn FailureCriterion>);

impl FailureCriterion for Shared {
    fn name(&self) -> &'static str {
        self.0.name()
    }

    fn required(&self) -> &'static [Strength] {
        self.0.required()
    }

    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
        self.0.assess(ply, loading)
    }
}
