//! Findings of friction.

use serde::{Serialize, Serializer};
use stickslip_experiment::history::{History, Tied, Untied};
use stickslip_experiment::{Experiment, State};
use stickslip_hybrid::identify::Bounds;
use thiserror::Error;

/// What slip zones show.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum FrictionFinding {
    /// One coefficient does not explain all zones together, though their own do not differ.
    Rejected,
    /// The coefficients of the zones differ by more than their errors.
    ZonesDisagree,
    /// A zone reaches the bearing point, so that nothing shows where it ends.
    ZoneWithoutEnd,
    /// The mesh moves the coefficient by more than noise.
    MeshMoves {
        /// The coefficient `[1]`.
        mu: f64,
        /// Cells along and across the coarser region.
        half_the_cells: [usize; 2],
        /// The coefficient on them `[1]`.
        mu_on_half: f64,
        /// Its bounds.
        #[serde(serialize_with = "ends")]
        bounds_on_half: Bounds,
    },
    /// How far static friction moves the edge is not known.
    MovesUnknown {
        /// Why.
        cause: String,
    },
    /// No pressure of a state exceeds its uncertainty.
    NoPressure {
        /// Its name.
        state: String,
    },
    /// No zone that slips is recognised on one side of the bearing point.
    NoZone {
        /// Name of the state.
        state: String,
        /// Whether it is the side of greater angles.
        after: bool,
        /// The bearing point `[degree]`.
        bearing_degrees: f64,
    },
}

impl FrictionFinding {
    pub(super) const fn warns(&self) -> bool {
        match self {
            Self::MovesUnknown { .. } | Self::NoPressure { .. } | Self::NoZone { .. } => false,
            Self::Rejected
            | Self::ZonesDisagree
            | Self::ZoneWithoutEnd
            | Self::MeshMoves { .. } => true,
        }
    }
}

/// Both ends of bounds, null where there is none.
fn ends<S: Serializer>(bounds: &Bounds, serializer: S) -> Result<S::Ok, S::Error> {
    bounds.ends().serialize(serializer)
}

/// Why no law is fitted to a state.
#[derive(Clone, Debug, Error, PartialEq, Serialize)]
#[error("State '{state}' is not among the data of the laws: {reason}.")]
pub struct LeftOut {
    /// Name of the state.
    pub state: String,
    /// Why.
    #[serde(flatten)]
    pub reason: LeftOutReason,
}

/// Why a state cannot be compared with predictions.
#[derive(Clone, Debug, Error, PartialEq, Serialize)]
#[serde(tag = "reason", rename_all = "snake_case")]
pub enum LeftOutReason {
    /// Its places are not those of the model.
    #[error("none of its places lies in the specimen of the scene")]
    OutsideOfScene,
    /// It is no load step of the scene.
    #[error(transparent)]
    #[serde(untagged)]
    Untied(#[from] Untied),
}

/// What the scene as a model shows: fitted laws and the whole plate.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum ModelFinding {
    /// No law is fitted to a state.
    LeftOutOfLaws(LeftOut),
    /// A state is not analysed as a whole plate.
    NoWholePlate {
        /// Its name.
        state: String,
        /// Why.
        #[serde(flatten)]
        reason: Untied,
    },
    /// The load of a measured null field is taken for that of a load step.
    NullLoadAssumed {
        /// Name of the state.
        state: String,
        /// The load step, counted from 1.
        step: usize,
        /// Its load, where that is a force `[N]`.
        load: Option<f64>,
    },
    /// The model has the mesh that made the synthetic pictures.
    SharedMesh,
    /// Intervals do not hold the error of the model's mesh.
    WithoutMeshError {
        /// Why.
        cause: String,
    },
    /// How far the edge moves with a parameter is not known.
    SensitivityUnknown {
        /// The law.
        law: String,
        /// The parameter.
        parameter: String,
        /// Its value, in the units of the law.
        value: f64,
        /// Why.
        cause: String,
    },
    /// A law among those fitted has a drop of friction without a length of its own.
    DropWithoutLength,
    /// No law explains the data.
    NoLawExplains {
        /// The best law.
        law: String,
        /// What it leaves, χ² `[1]`.
        chi_squared: f64,
        /// Degrees of freedom.
        degrees: usize,
        /// Number of standard deviations `[1]` by which that is too much.
        excess: f64,
    },
}

impl ModelFinding {
    /// The model of `experiment`, where it has the mesh that made the synthetic pictures.
    pub(crate) fn of_mesh(experiment: &Experiment) -> Option<Self> {
        (experiment.is_fitted_to_its_own_mesh()).then_some(Self::SharedMesh)
    }

    /// The load of the null field of a state, where it is assumed.
    pub(crate) fn of_null(history: &History<'_>, state: &State, tied: &Tied) -> Option<Self> {
        let null = tied.null.filter(|_| tied.assumed)?;
        Some(Self::NullLoadAssumed {
            state: state.name.clone(),
            step: null + 1,
            load: history.load(null),
        })
    }

    pub(super) const fn warns(&self) -> bool {
        !matches!(self, Self::DropWithoutLength)
    }
}
