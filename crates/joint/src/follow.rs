//! A load history, increment by increment, cut back where there is no equilibrium.

use stickslip_contact::history::{LoadIncrement, LoadPath, Progress, Walker};
use stickslip_contact::{ContactState, InterfaceProblem, InterfaceSolver};
use stickslip_fem_core::InterfaceOperator;

use crate::body::Response;
use crate::damage::PlyEvent;
use crate::error::{Halt, JointError};
use crate::increment::{Accepted, IncrementSettings, Refused, Solving, starting_responses};
use crate::joint::Joint;
use crate::operator::Factors;
use crate::record::{Ending, JointHistory, JointRecord};
use crate::state::JointState;

/// Part of an increment down to which a burst of failures is resolved.
const BURST_PART: f64 = 1.0 / 32.0;
/// Part of the largest load above which a load is more than rounding.
const LOADED: f64 = 1e-6;

impl Joint {
    /// Follows the load steps `steps`, each the multipliers `[1]` of all load cases at its end, from rest, with `solver` for the contact.
    /// `observe` sees each accepted increment and the state at its end.
    ///
    /// Under given loads the history ends at the joint's strength; driven supports carry it past the peak, until the load has
    /// fallen.
    ///
    /// # Errors
    /// [`JointError::Load`] for steps that make no sense, [`JointError::Contact`] for pairs that make none, [`JointError::Body`] for a
    /// body that cannot be condensed at rest, [`JointError::NoStart`] if nothing at all can be borne.
    pub fn follow(
        &self,
        steps: &[Vec<f64>],
        solver: &dyn InterfaceSolver,
        observe: impl FnMut(&JointRecord, &JointState),
    ) -> Result<JointHistory, JointError> {
        self.check_steps(steps)?;
        let mut factors = Factors::new(self.bodies.len());
        let mut walk = Walk {
            state: self.at_rest(&mut factors)?,
            joint: self,
            solver,
            factors,
            starting: Vec::new(),
            records: Vec::new(),
            observe,
            failed: false,
            counted: 0,
        };
        for (index, target) in steps.iter().enumerate() {
            if let Some(ending) = walk.step(index, target)? {
                return Ok(walk.finish(ending));
            }
        }
        Ok(walk.finish(Ending::Completed))
    }

    fn check_steps(&self, steps: &[Vec<f64>]) -> Result<(), JointError> {
        let cases = self.load_cases();
        let refuse = |step, what| Err(JointError::Load { step, what });
        if steps.is_empty() {
            return refuse(
                0,
                "missing; a history needs at least one load step".to_owned(),
            );
        }
        for (step, multipliers) in steps.iter().enumerate() {
            if multipliers.len() != cases {
                let given = multipliers.len();
                return refuse(step, format!("{given} multipliers for {cases} load cases"));
            }
            if let Some(value) = multipliers.iter().find(|value| !value.is_finite()) {
                return refuse(step, format!("the multiplier {value} is not finite"));
            }
        }
        Ok(())
    }

    /// The joint before any load: its bodies are condensed once, and its pairs checked.
    fn at_rest(&self, factors: &mut Factors) -> Result<JointState, JointError> {
        let nothing = InterfaceProblem::new(&[], Vec::new())?;
        let rest = JointState::at_rest(
            &self.bodies,
            ContactState::unloaded(&nothing),
            self.load_cases(),
        );
        let settings = IncrementSettings {
            quickly: false,
            burst: usize::MAX,
            peak: f64::INFINITY,
            sound: f64::INFINITY,
        };
        let still = vec![0.0; self.load_cases()];
        let starting = starting_responses(self, &rest).map_err(JointError::NoStart)?;
        let solving = Solving::new(self, &rest, &starting, &still, settings);
        let operators = solving.operators(factors).map_err(|halt| match halt {
            Halt::Stiffness { body, cause } => JointError::Body { body, cause },
            other => JointError::NoStart(other),
        })?;
        let faces: Vec<&dyn InterfaceOperator> = operators
            .iter()
            .map(crate::operator::Operator::interface)
            .collect();
        let problem = InterfaceProblem::new(&faces, self.pairs.clone())?;
        let contact = ContactState::unloaded(&problem);
        Ok(JointState { contact, ..rest })
    }
}

/// Where the joint begins to bear: the displacement without load on the line through the first two points of `curve`, pairs of load and
/// displacement, that climb under load. The gauge's own zero does not count: a pin may meet the hole before or after it.
fn onset(curve: &[[f64; 2]]) -> Option<f64> {
    let largest = curve
        .iter()
        .fold(0.0, |most: f64, [load, _]| most.max(*load));
    let mut loaded = (curve.iter()).filter(|[load, _]| *load > LOADED * largest);
    let [load, displacement] = *loaded.next()?;
    let [further, moved] = *loaded.find(|[more, moved]| *more > load && *moved > displacement)?;
    Some(displacement - load * (moved - displacement) / (further - load))
}

/// A history on its way.
struct Walk<'a, F> {
    joint: &'a Joint,
    solver: &'a dyn InterfaceSolver,
    factors: Factors,
    /// Responses in `state`, once they are known.
    starting: Vec<Option<Response>>,
    state: JointState,
    records: Vec<JointRecord>,
    observe: F,
    /// Whether a ply has failed.
    failed: bool,
    /// Factorisations that records have counted.
    counted: usize,
}

impl<F: FnMut(&JointRecord, &JointState)> Walk<'_, F> {
    /// Follows one load step; returns how the history ends, if it ends in it.
    fn step(&mut self, index: usize, target: &[f64]) -> Result<Option<Ending>, JointError> {
        let options = self.joint.options;
        let start = self.state.multipliers.clone();
        let walker = Walker {
            whole: 1.0 / options.increments as f64,
            smallest_part: options.smallest_part,
            effort: None,
        };
        let driven = self.joint.is_driven(&start, target);
        let mut path = StepPath {
            walk: self,
            index,
            start,
            target,
            driven,
            smooth: true,
        };
        let blocked = match walker.walk([0.0, 1.0], &mut path) {
            Ok(ending) => return Ok(ending),
            Err(blocked) => blocked,
        };
        let Refused { cause, events } = blocked.refusal;
        if self.records.is_empty() {
            return Err(JointError::NoStart(cause));
        }
        Ok(Some(Ending::NoEquilibrium {
            step: index,
            reached: blocked.reached,
            cause,
            collapse: events,
        }))
    }

    /// How `increment` is to be solved.
    fn settings(&self, increment: &LoadIncrement, driven: bool) -> IncrementSettings {
        let LoadIncrement { smallest, .. } = *increment;
        let watched = |unless: bool| {
            if unless {
                f64::INFINITY
            } else {
                self.largest_load()
            }
        };
        IncrementSettings {
            quickly: increment.is_between(),
            burst: if increment.exceeds(BURST_PART) && !smallest {
                self.joint.options.burst
            } else {
                usize::MAX
            },
            peak: watched(!driven || smallest),
            sound: watched(self.failed || smallest),
        }
    }

    fn attempt(
        &mut self,
        multipliers: &[f64],
        settings: IncrementSettings,
        driven: bool,
    ) -> Result<Accepted, Refused> {
        if self.starting.is_empty() {
            self.starting =
                starting_responses(self.joint, &self.state).map_err(|cause| Refused {
                    cause,
                    events: Vec::new(),
                })?;
        }
        let solving = Solving::new(
            self.joint,
            &self.state,
            &self.starting,
            multipliers,
            settings,
        );
        let mut accepted = solving.run(self.solver, &mut self.factors)?;
        if accepted.passes == 0 {
            return Ok(accepted);
        }
        match self.check_path(&mut accepted, driven) {
            Ok(()) => Ok(accepted),
            Err(cause) => Err(Refused {
                cause,
                events: accepted.events,
            }),
        }
    }

    /// Refuses an increment whose failures cost the joint its load path. Where supports are driven only one whose load is no less than
    /// all before: otherwise the load has fallen, and the history ends with it.
    fn check_path(&mut self, accepted: &mut Accepted, driven: bool) -> Result<(), Halt> {
        if !driven {
            self.check_stiffness(accepted)?;
        }
        accepted.severed = self
            .joint
            .is_severed(&accepted.state, self.solver, &mut self.factors);
        if accepted.severed && !(driven && accepted.load < self.largest_load()) {
            return Err(Halt::Severed);
        }
        Ok(())
    }

    fn check_stiffness(&self, accepted: &Accepted) -> Result<(), Halt> {
        let options = self.joint.options;
        // That of the increment itself, before plies failed.
        let before = accepted.events.first();
        let before = before.map(|event| [event.load, event.displacement]);
        let curve: Vec<[f64; 2]> = (self.records.iter())
            .map(|record| [record.load, record.displacement])
            .chain(before)
            .collect();
        let start = onset(&curve).unwrap_or(-self.joint.gauge.free_travel);
        let secant = |&[load, displacement]: &[f64; 2]| {
            let moved = displacement - start;
            if moved > 0.0 { load / moved } else { 0.0 }
        };
        let [load, displacement] = [accepted.load, accepted.displacement];
        let after = secant(&[load, displacement]);
        let stiffness = after / curve.iter().map(secant).fold(0.0, f64::max);
        let jump = options.jump * before.as_ref().map_or(0.0, secant);
        let lost = stiffness < options.residual_stiffness || after < jump;
        let last = self.records.last();
        let further = last.is_none_or(|last| displacement > last.displacement);
        if lost && further && displacement > start {
            return Err(Halt::LoadPathLost { stiffness });
        }
        Ok(())
    }

    fn record(&mut self, (step, reached): (usize, f64), accepted: Accepted, cutbacks: usize) {
        let mut contact = accepted.contact;
        contact.cutbacks = cutbacks;
        self.state = accepted.state;
        self.starting.clear();
        self.failed |= accepted.events.iter().any(PlyEvent::is_failure);
        let record = JointRecord {
            step,
            reached,
            multipliers: self.state.multipliers.clone(),
            load: accepted.load,
            displacement: accepted.displacement,
            energy: self.state.energy,
            contact,
            events: accepted.events,
            passes: accepted.passes,
            residuals: accepted.residuals,
            factorisations: self.factors.factorisations - self.counted,
        };
        self.counted = self.factors.factorisations;
        (self.observe)(&record, &self.state);
        self.records.push(record);
    }

    fn largest_load(&self) -> f64 {
        let loads = self.records.iter().map(|record| record.load);
        loads.fold(0.0, f64::max)
    }

    /// Whether the load has fallen far below its peak while the displacement went on.
    fn has_dropped(&self) -> bool {
        let Some(last) = self.records.last() else {
            return false;
        };
        let limit = self.joint.options.residual_load;
        self.records.iter().any(|record| {
            last.load < limit * record.load && last.displacement > record.displacement
        })
    }

    /// Plies fail in a trial state, whose load the joint does not reach where their failure costs it load: one above the peak is reported
    /// at the peak.
    fn finish(mut self, ending: Ending) -> JointHistory {
        let peak = self.largest_load();
        for event in self
            .records
            .iter_mut()
            .flat_map(|record| &mut record.events)
        {
            event.load = event.load.min(peak);
        }
        JointHistory {
            records: self.records,
            ending,
            state: self.state,
            factorisations: self.factors.factorisations,
        }
    }
}

/// A load step on its way.
struct StepPath<'w, 'a, 't, F> {
    walk: &'w mut Walk<'a, F>,
    index: usize,
    /// Multipliers of the load cases at both ends.
    start: Vec<f64>,
    target: &'t [f64],
    /// Whether supports move in it.
    driven: bool,
    /// Whether the last increment was accepted at once.
    smooth: bool,
}

impl<F: FnMut(&JointRecord, &JointState)> LoadPath for StepPath<'_, '_, '_, F> {
    type End = Ending;
    type Refusal = Refused;

    /// Grows again after increments without failure, and after two that were accepted at once.
    fn attempt(&mut self, increment: &LoadIncrement) -> Result<Progress<Ending>, Refused> {
        let reached = increment.to;
        // Exact at both ends.
        let multipliers: Vec<f64> = (self.start.iter().zip(self.target))
            .map(|(from, to)| (1.0 - reached) * from + reached * to)
            .collect();
        let settings = self.walk.settings(increment, self.driven);
        let accepted = self.walk.attempt(&multipliers, settings, self.driven)?;
        let grows = accepted.passes == 0 || self.smooth;
        self.smooth = increment.refusals == 0;
        let (step, severed) = (self.index, accepted.severed);
        (self.walk).record((step, reached), accepted, increment.refusals);
        Ok(if self.driven && self.walk.has_dropped() {
            Progress::End(Ending::LoadDropped { step, reached })
        } else if severed {
            Progress::End(Ending::Severed { step, reached })
        } else if grows {
            Progress::Grow
        } else {
            Progress::Keep
        })
    }

    fn cost(_refusal: &Refused) -> u64 {
        0
    }

    fn cut_back(&mut self, _refusal: Refused) {}
}
