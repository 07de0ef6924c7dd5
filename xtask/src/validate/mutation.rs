//! Deliberate mistakes in friction, to prove that the checks can fail.
//!
//! ```text
//! no friction         F = 0
//! wrong direction     λ_t = +F sign Δs        instead of  λ_t = −F sign Δs
//! forgotten history   Δs = s − 0              instead of  Δs = s − s_last
//! ```
//!
//! Each enters where a real mistake would: the first two as a friction law, the third as a solver that hands the solver of
//! the scene a state without tangential displacements and memory.

use serde::{Deserialize, Serialize};
use stickslip::run;
use stickslip::scene::Scene;
use stickslip_contact::solver::{Step, StepFailure, StepSolution};
use stickslip_contact::{InterfaceSolver, SemismoothNewton};
use stickslip_friction::{Bound, Coulomb, FrictionLaw, History, Mirror, Place};

use crate::publish::TaskError;

/// What is wrong with friction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mutation {
    /// Nothing.
    None,
    /// There is none.
    Frictionless,
    /// It acts along the slip.
    WrongDirection,
    /// Slip is measured from the unloaded state, and laws remember nothing.
    ForgottenHistory,
}

impl Mutation {
    /// All mistakes.
    pub(crate) const MISTAKES: [Self; 3] = [
        Self::Frictionless,
        Self::WrongDirection,
        Self::ForgottenHistory,
    ];

    /// As tables show it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::None => "unchanged",
            Self::Frictionless => "μ = 0",
            Self::WrongDirection => "friction along the slip",
            Self::ForgottenHistory => "slip history dropped",
        }
    }

    /// Makes the mistake in the laws of `scene`.
    pub(crate) fn change_laws(self, scene: &mut Scene) -> Result<(), TaskError> {
        for contact in &mut scene.contacts {
            match self {
                Self::None | Self::ForgottenHistory => {}
                Self::Frictionless => contact.law = Box::new(Coulomb::new(0.0)?),
                Self::WrongDirection => {
                    contact.law = Box::new(WrongDirection {
                        law: contact.law.clone(),
                    });
                }
            }
        }
        Ok(())
    }

    /// The solver of `scene`, with the mistake. Where friction acts along the slip there may be no equilibrium, and safer
    /// solvers would look for it long and in vain.
    pub(crate) fn solver(self, scene: &Scene) -> Box<dyn InterfaceSolver> {
        let solver = run::solver(scene.analysis.solver);
        match self {
            Self::None | Self::Frictionless => solver,
            Self::WrongDirection => Box::new(SemismoothNewton::default()),
            Self::ForgottenHistory => Box::new(Forgetful { solver }),
        }
    }
}

/// A law whose slip traction acts along the slip.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct WrongDirection {
    law: Box<dyn FrictionLaw>,
}

#[typetag::serde(name = "wrong_direction")]
impl FrictionLaw for WrongDirection {
    fn bound(&self, pressure: f64, slip_increment: f64, place: &Place, past: &History) -> Bound {
        let bound = self.law.bound(pressure, slip_increment, place, past);
        Bound {
            slip: -bound.slip,
            slip_dp: -bound.slip_dp,
            slip_ds: -bound.slip_ds,
            ..bound
        }
    }

    fn is_symmetric(&self, mirror: &Mirror) -> bool {
        self.law.is_symmetric(mirror)
    }

    fn box_clone(&self) -> Box<dyn FrictionLaw> {
        Box::new(self.clone())
    }
}

/// A solver that knows where the gaps were, and nothing of slip.
#[derive(Debug)]
struct Forgetful {
    solver: Box<dyn InterfaceSolver>,
}

impl InterfaceSolver for Forgetful {
    fn name(&self) -> &'static str {
        self.solver.name()
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let mut forgotten = step.committed.clone();
        for k in 0..step.count() {
            forgotten.motion[2 * k + 1] = 0.0;
            forgotten.history[k] = History::default();
        }
        self.solver.solve(&step.from_state(&forgotten))
    }
}
