//! What is known of the contact at the end of a load step.

use std::fmt;

use nalgebra::DVector;
use stickslip_friction::{History, PointStatus};

/// Status of a contact point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Status {
    /// No contact.
    #[default]
    Open,
    /// Contact, no relative tangential motion in the step.
    Stick,
    /// Contact, first body slips along +e_t against the second: λ_t = −F.
    SlipPositive,
    /// Contact, first body slips along −e_t against the second: λ_t = +F.
    SlipNegative,
}

impl Status {
    /// Whether the point is in contact.
    pub fn touches(self) -> bool {
        self != Self::Open
    }

    /// Direction of slip `[1]`: +1, −1, or 0 without slip.
    pub fn slip_sign(self) -> f64 {
        match self {
            Self::SlipPositive => 1.0,
            Self::SlipNegative => -1.0,
            Self::Open | Self::Stick => 0.0,
        }
    }

    /// Slip along the sign of `motion`, in any unit.
    pub fn slip_along(motion: f64) -> Self {
        if motion < 0.0 {
            Self::SlipNegative
        } else {
            Self::SlipPositive
        }
    }

    /// The status without its direction, as friction laws know it.
    pub fn without_direction(self) -> PointStatus {
        match self {
            Self::Open => PointStatus::Open,
            Self::Stick => PointStatus::Stick,
            Self::SlipPositive | Self::SlipNegative => PointStatus::Slip,
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::Open => "open",
            Self::Stick => "stick",
            Self::SlipPositive => "slip+",
            Self::SlipNegative => "slip-",
        })
    }
}

/// Contact at the end of an accepted load step. Solvers read it and never change it; accepting a step makes a new one.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactState {
    /// Contact forces `[force]` on the first bodies, normal and tangential interleaved, 2n.
    pub forces: DVector<f64>,
    /// Gap and tangential displacement since the start `[length]`, interleaved, 2n.
    pub motion: DVector<f64>,
    /// Amounts of the rigid motions α, m, in the units of [`InterfaceProblem::modes`](crate::InterfaceProblem::modes); those of a body
    /// are [`InterfaceProblem::motions_of_body`](crate::InterfaceProblem::motions_of_body).
    pub rigid: DVector<f64>,
    /// Status of each point.
    pub status: Vec<Status>,
    /// What each point remembers.
    pub history: Vec<History>,
    /// Multipliers of the load cases `[1]`.
    pub multipliers: Vec<f64>,
}

impl ContactState {
    /// Normal force `[force]` at a point, positive in compression.
    pub fn normal_force(&self, point: usize) -> f64 {
        self.forces[2 * point]
    }

    /// Tangential force `[force]` on the first body at a point, along e_t.
    pub fn tangential_force(&self, point: usize) -> f64 {
        self.forces[2 * point + 1]
    }

    /// Gap `[length]` at a point, positive when open.
    pub fn gap(&self, point: usize) -> f64 {
        self.motion[2 * point]
    }

    /// Tangential displacement `[length]` of the first body against the second since the start, along e_t.
    pub fn tangential_displacement(&self, point: usize) -> f64 {
        self.motion[2 * point + 1]
    }

    /// The state after an accepted step: histories advance by the slip increments.
    pub(crate) fn advance(&self, trial: TrialState, multipliers: &[f64]) -> Self {
        let history = (self.history.iter().zip(&trial.status))
            .enumerate()
            .map(|(k, (past, status))| {
                let increment = trial.motion[2 * k + 1] - self.motion[2 * k + 1];
                past.commit(status.without_direction(), increment)
            })
            .collect();
        Self {
            forces: trial.forces,
            motion: trial.motion,
            rigid: trial.rigid,
            status: trial.status,
            history,
            multipliers: multipliers.to_vec(),
        }
    }
}

/// What a solver proposes for the end of a step; it becomes a [`ContactState`] only when the step is accepted.
#[derive(Clone, Debug, PartialEq)]
pub struct TrialState {
    /// Contact forces `[force]`, 2n.
    pub forces: DVector<f64>,
    /// Gap and tangential displacement `[length]`, 2n.
    pub motion: DVector<f64>,
    /// Rigid motions, m, in the units of [`InterfaceProblem::modes`](crate::InterfaceProblem::modes).
    pub rigid: DVector<f64>,
    /// Status of each point.
    pub status: Vec<Status>,
}
