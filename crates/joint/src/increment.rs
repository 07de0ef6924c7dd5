//! One increment of load: Newton's iteration on linearised bodies in contact, and redistribution where plies fail.
//!
//! ```text
//! repeat   K_t (u − u_k) + f_int(u_k) = f + Bᵀ λ  with contact, exactly         one linearisation
//!          plies fail at u:  their loss is kept, the iteration goes on from u   a redistribution, at constant load
//!          otherwise until  |f_int(u) − f − Bᵀ λ| ≤ tolerance × the largest nodal force
//! ```
//!
//! Stresses and tangents come from the states at the start of the increment, or after the last redistribution. A model that fails at
//! once is linear between failures, so the state in which plies fail is an equilibrium. Nothing of the start is changed.

mod accept;
mod severed;
mod solve;

use std::sync::Arc;

use stickslip_contact::solver::{StepSolution, Work};
use stickslip_contact::state::TrialState;
use stickslip_contact::{ContactState, InterfaceProblem, InterfaceSolver, StepRecord};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::material::apply;
use stickslip_laminate::progressive::PointState;

use crate::body::{JointBody, ProgressiveBody, Response};
use crate::damage::{PlyEvent, newly_damaged};
use crate::energy::{Equilibrium, PassStart};
use crate::error::Halt;
use crate::joint::Joint;
use crate::operator::Factors;
use crate::state::{BodyState, JointState};

/// What an accepted increment yields.
#[derive(Debug)]
pub(crate) struct Accepted {
    pub(crate) state: JointState,
    pub(crate) contact: StepRecord,
    pub(crate) load: f64,
    pub(crate) displacement: f64,
    pub(crate) events: Vec<PlyEvent>,
    pub(crate) passes: usize,
    pub(crate) residuals: Vec<f64>,
    /// Whether failed plies alone bear the load.
    pub(crate) severed: bool,
}

/// An increment without an end, and what failed in it before it was given up.
#[derive(Debug)]
pub(crate) struct Refused {
    pub(crate) cause: Halt,
    pub(crate) events: Vec<PlyEvent>,
}

/// How an increment is to be solved.
#[derive(Clone, Copy, Debug)]
pub(crate) struct IncrementSettings {
    /// By the contact solver's cheapest means only.
    pub(crate) quickly: bool,
    /// Largest number of plies times points that the load itself may break.
    pub(crate) burst: usize,
    /// Largest load before, from which the load may not fall unresolved.
    pub(crate) peak: f64,
    /// Load before, where no ply has failed yet: the first is to fail close to it.
    pub(crate) sound: f64,
}

/// Stresses and tangents of all bodies with a history in the state `start`, without trial states; `None` for the others. All
/// attempts from one state share them.
pub(crate) fn starting_responses(
    joint: &Joint,
    start: &JointState,
) -> Result<Vec<Option<Response>>, Halt> {
    let respond = |(index, (body, state)): (usize, (&JointBody, &BodyState))| {
        let Some(body) = body.progressive() else {
            return Ok(None);
        };
        match body.respond(&state.points, &state.displacements) {
            Ok(response) => Ok(Some(Response {
                trial: Vec::new(),
                ..response
            })),
            Err((point, cause)) => Err(Halt::Material {
                body: index,
                point,
                cause,
            }),
        }
    };
    let bodies = joint.bodies.iter().zip(&start.bodies).enumerate();
    bodies.map(respond).collect()
}

/// A body with a history on its way through an increment.
struct Working<'a> {
    index: usize,
    body: &'a ProgressiveBody,
    start: &'a [PointState],
    /// States that the points come from, where plies have failed since the start.
    base: Option<Vec<PointState>>,
    response: Response,
    /// Since the start, or since plies failed last.
    pass_start: PassStart,
    /// Largest nodal force of the last linearisation.
    largest_force: f64,
}

impl Working<'_> {
    fn base(&self) -> &[PointState] {
        self.base.as_deref().unwrap_or(self.start)
    }

    fn respond(&self, u: &[f64]) -> Result<Response, Halt> {
        let response = self.body.respond(self.base(), u);
        response.map_err(|(point, cause)| Halt::Material {
            body: self.index,
            point,
            cause,
        })
    }

    /// Stresses that the linearisation predicts at the strains of `response`.
    fn predicted(&self, response: &Response) -> Vec<[f64; 3]> {
        let old = &self.response;
        (0..old.stress.len())
            .map(|q| {
                let turn = [0, 1, 2].map(|i| response.strain[q][i] - old.strain[q][i]);
                let change = apply(&old.tangents[q], turn);
                [0, 1, 2].map(|i| old.stress[q][i] + change[i])
            })
            .collect()
    }
}

/// A body in an increment.
enum Part<'a> {
    History(Box<Working<'a>>),
    Linear(&'a dyn InterfaceOperator),
}

/// One linearisation, solved.
struct Linear {
    problem: InterfaceProblem,
    solution: StepSolution,
    displacements: Vec<Vec<f64>>,
}

/// An increment on its way.
pub(crate) struct Solving<'a> {
    joint: &'a Joint,
    start: &'a JointState,
    /// Contact at the start, after the free travel of bodies that do not bear yet; known from the first linearisation on.
    origin: Option<ContactState>,
    multipliers: &'a [f64],
    settings: IncrementSettings,
    parts: Vec<Part<'a>>,
    /// Where the work of the loads has been reckoned up to.
    equilibrium: Equilibrium,
    external: f64,
    released: f64,
    events: Vec<PlyEvent>,
    passes: usize,
    residuals: Vec<f64>,
    work: Work,
}

impl<'a> Solving<'a> {
    /// `starting` is what [`starting_responses`] says of `start`.
    pub(crate) fn new(
        joint: &'a Joint,
        start: &'a JointState,
        starting: &[Option<Response>],
        multipliers: &'a [f64],
        settings: IncrementSettings,
    ) -> Self {
        let part = |(index, (body, state)): (usize, (&'a JointBody, &'a BodyState))| match body {
            JointBody::Rigid(body) => Part::Linear(body),
            JointBody::Elastic(body) => Part::Linear(body.as_ref()),
            JointBody::Progressive(body) => {
                let response = starting[index].clone().unwrap_or_default();
                Part::History(Box::new(Working {
                    index,
                    body: Arc::as_ref(body),
                    start: &state.points,
                    base: None,
                    pass_start: PassStart::new(&response, body.energies(&state.points)),
                    response,
                    largest_force: 0.0,
                }))
            }
        };
        let bodies = joint.bodies.iter().zip(&start.bodies).enumerate();
        Self {
            joint,
            start,
            origin: None,
            multipliers,
            settings,
            parts: bodies.map(part).collect(),
            equilibrium: Equilibrium::of(start),
            external: 0.0,
            released: 0.0,
            events: Vec::new(),
            passes: 0,
            residuals: Vec::new(),
            work: Work::default(),
        }
    }

    /// The state that contact comes from.
    fn origin(&self) -> &ContactState {
        self.origin.as_ref().unwrap_or(&self.start.contact)
    }

    fn histories(&self) -> impl Iterator<Item = &Working<'a>> {
        self.parts.iter().filter_map(|part| match part {
            Part::History(working) => Some(working.as_ref()),
            Part::Linear(_) => None,
        })
    }

    /// Iterates to equilibrium.
    pub(crate) fn run(
        mut self,
        solver: &dyn InterfaceSolver,
        factors: &mut Factors,
    ) -> Result<Accepted, Refused> {
        match self.iterate(solver, factors) {
            Ok(linear) => Ok(self.accept(linear)),
            Err(cause) => Err(Refused {
                cause,
                events: self.events,
            }),
        }
    }

    fn iterate(
        &mut self,
        solver: &dyn InterfaceSolver,
        factors: &mut Factors,
    ) -> Result<Linear, Halt> {
        let options = self.joint.options;
        let mut guess: Option<TrialState> = None;
        let mut iterations = 0;
        loop {
            let linear = self.linearised(solver, factors, guess.as_ref())?;
            let responses = (self.histories())
                .map(|working| working.respond(&linear.displacements[working.index]))
                .collect::<Result<Vec<Response>, Halt>>()?;
            let failed: Vec<_> = (self.histories().zip(&responses))
                .map(|(working, response)| newly_damaged(working.base(), &response.trial))
                .collect();
            iterations += 1;
            if failed.iter().all(Vec::is_empty) {
                let residual = self.residual(&linear, &responses);
                self.residuals.push(residual);
                self.take(responses);
                if residual <= options.tolerance {
                    let [load, _] = self.read(&linear);
                    self.check_peak(load)?;
                    return Ok(linear);
                }
                if iterations >= options.iterations || !residual.is_finite() {
                    return Err(Halt::NotConverged {
                        iterations,
                        residual,
                    });
                }
            } else {
                self.redistribute(&linear, responses, &failed)?;
                iterations = 0;
            }
            guess = Some(linear.solution.trial);
        }
    }

    /// Refuses to step over a peak of the load: a first failure well above all loads before, and a `load` that has fallen since.
    fn check_peak(&self, load: f64) -> Result<(), Halt> {
        let resolution = self.joint.options.peak_resolution;
        let before = self.settings.peak;
        match self.events.first() {
            Some(first)
                if first.load > before * (1.0 + resolution)
                    && load < first.load * (1.0 - resolution) =>
            {
                let failing = first.load;
                Err(Halt::PastPeak { before, failing })
            }
            _ => Ok(()),
        }
    }

    /// Refuses to step over the first failure of a sound joint, which is to happen close to a load that was borne.
    fn check_first(&self, load: f64) -> Result<(), Halt> {
        let before = self.settings.sound;
        if self.passes == 0 && load > before * (1.0 + self.joint.options.peak_resolution) {
            let failing = load;
            return Err(Halt::PastPeak { before, failing });
        }
        Ok(())
    }

    fn take(&mut self, responses: Vec<Response>) {
        let mut responses = responses.into_iter();
        for part in &mut self.parts {
            if let Part::History(working) = part
                && let Some(response) = responses.next()
            {
                working.response = response;
            }
        }
    }
}
