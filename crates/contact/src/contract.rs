//! What every [`InterfaceSolver`] must fulfil, as a check that a new solver calls in its tests.
//!
//! ```text
//! a solution    meets complementarity, friction cones and balance as well as it says, in the state that it returns
//! its stop      is Verified, unless the solver is declared experimental
//! a refusal     names the solver and its reason
//! either way    the last accepted state is untouched, the same step gives the same bits, and other units the same answer
//! ```
//!
//! Steps are those of small problems with known properties: pressed and sheared points of a held body, a block that its
//! load brings to contact, and a load that nothing can balance, which has no solution at all.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::{GivenBody, GivenBodyError, InterfaceOperator, RigidBody};
use stickslip_friction::{Coulomb, FrictionError};
use thiserror::Error;

use crate::error::ContactError;
use crate::history::Increment;
use crate::problem::{ContactPair, ContactPoint, InterfaceProblem};
use crate::solver::{InterfaceSolver, Residuals, SolverInfo, Step, StepSolution, Stop};
use crate::state::ContactState;

/// Largest residual of a verified solution, relative to the scales of its step.
const VERIFIED: f64 = 1e-10;
/// Residuals that are reported and measured differ by no more than rounding of sums.
const ROUNDING: f64 = 1e-12;
/// Part of the largest force up to which answers in other units agree, beyond what their residuals leave open.
const SAME: f64 = 1e-8;

/// How a solver breaks the contract.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Breach {
    /// A sample problem cannot be made.
    #[error("the sample cannot be made: {0}")]
    Sample(String),
    /// A solution does not meet the contact conditions as it says.
    #[error(
        "{sample}: the solution violates the contact conditions by {found:.1e} of their scale, {said:.1e} allowed or reported"
    )]
    Violated {
        /// The sample step.
        sample: &'static str,
        /// Measured violation `[1]`.
        found: f64,
        /// What the solution may have, or says to have `[1]`.
        said: f64,
    },
    /// A solver that is not declared experimental returns an answer that is not verified.
    #[error(
        "{sample}: the answer is not verified ({stop:?}); a solver of such answers must be declared experimental"
    )]
    Unverified {
        /// The sample step.
        sample: &'static str,
        /// Why the solver stopped.
        stop: Stop,
    },
    /// A step without solution was solved.
    #[error("{sample}: a load that nothing can balance was balanced")]
    Impossible {
        /// The sample step.
        sample: &'static str,
    },
    /// A step that the solver is expected to solve was refused.
    #[error("{sample}: refused: {reason}")]
    Refused {
        /// The sample step.
        sample: &'static str,
        /// What the failure says.
        reason: String,
    },
    /// A failure without reasons.
    #[error("{sample}: a refusal names neither solver nor reason")]
    NoReason {
        /// The sample step.
        sample: &'static str,
    },
    /// The same step has two answers.
    #[error("{sample}: the same step has another answer the second time")]
    NotRepeatable {
        /// The sample step.
        sample: &'static str,
    },
    /// The answer depends on units.
    #[error("{sample}: in other units the forces differ by {difference:.1e} of the largest")]
    DependsOnUnits {
        /// The sample step.
        sample: &'static str,
        /// Largest difference of a force, relative to the largest force `[1]`.
        difference: f64,
    },
}

impl From<ContactError> for Breach {
    fn from(error: ContactError) -> Self {
        Self::Sample(error.to_string())
    }
}

impl From<GivenBodyError> for Breach {
    fn from(error: GivenBodyError) -> Self {
        Self::Sample(error.to_string())
    }
}

impl From<FrictionError> for Breach {
    fn from(error: FrictionError) -> Self {
        Self::Sample(error.to_string())
    }
}

/// A problem and the loads that are applied to it one after the other.
struct Sample {
    name: &'static str,
    floating: bool,
    loads: &'static [[f64; 2]],
    solvable: bool,
}

const SAMPLES: [Sample; 3] = [
    Sample {
        name: "held body, pressed and sheared",
        floating: false,
        loads: &[[1.0, 0.0], [1.0, 0.2], [1.0, 1.0], [0.7, 0.3]],
        solvable: true,
    },
    Sample {
        name: "floating block, pressed and pushed",
        floating: true,
        loads: &[[1.0, 0.0], [1.0, 0.1], [1.2, -0.1]],
        solvable: true,
    },
    Sample {
        name: "floating block, pulled off",
        floating: true,
        loads: &[[-1.0, 0.0]],
        solvable: false,
    },
];

/// Tests a line of the list of solvers: by [`check_experimental`] if it is declared experimental, otherwise by [`check`].
///
/// # Errors
/// The first [`Breach`].
pub fn check_listed(solver: &SolverInfo) -> Result<(), Breach> {
    let made = (solver.make)();
    if solver.experimental {
        check_experimental(made.as_ref())
    } else {
        check(made.as_ref())
    }
}

/// Tests `solver`, whose answers are verified, on all sample steps.
///
/// ```
/// use stickslip_contact::contract::check;
/// use stickslip_contact::solver::SolverKind;
///
/// check(SolverKind::Pivoting.make().as_ref()).unwrap();
/// ```
///
/// # Errors
/// The first [`Breach`].
pub fn check(solver: &dyn InterfaceSolver) -> Result<(), Breach> {
    check_all(solver, |sample, stop| match stop {
        Stop::Verified => Ok(()),
        stop => Err(Breach::Unverified { sample, stop }),
    })
}

/// As [`check`], for a solver whose answers may be regularised or of a looser tolerance.
///
/// # Errors
/// The first [`Breach`].
pub fn check_experimental(solver: &dyn InterfaceSolver) -> Result<(), Breach> {
    check_all(solver, |_, _| Ok(()))
}

/// Whether a solver may stop so on a sample.
type Allowed<'a> = dyn Fn(&'static str, Stop) -> Result<(), Breach> + 'a;

fn check_all(
    solver: &dyn InterfaceSolver,
    allowed: impl Fn(&'static str, Stop) -> Result<(), Breach>,
) -> Result<(), Breach> {
    for sample in &SAMPLES {
        // Powers of two, so that scaling itself changes no digit.
        let units = [[1.0, 1.0], [1.0 / 1024.0, 1.0], [32.0, 1.0 / 65536.0]];
        let [one, others @ ..] = units;
        let forces = follow(solver, sample, one, &allowed)?;
        for unit in others {
            let scaled = follow(solver, sample, unit, &allowed)?;
            for (one, other) in forces.iter().zip(&scaled) {
                let largest = one.amax().max(f64::MIN_POSITIVE);
                let difference = (other / unit[1] - one).amax() / largest;
                if difference.is_nan() || difference > SAME {
                    return Err(Breach::DependsOnUnits {
                        sample: sample.name,
                        difference,
                    });
                }
            }
        }
    }
    Ok(())
}

/// Forces at the end of each step of `sample`, in units `[length, force]`.
fn follow(
    solver: &dyn InterfaceSolver,
    sample: &Sample,
    units: [f64; 2],
    allowed: &Allowed<'_>,
) -> Result<Vec<DVector<f64>>, Breach> {
    let name = sample.name;
    let problem = problem(sample.floating, units)?;
    let mut state = ContactState::unloaded(&problem);
    let mut forces = Vec::new();
    for load in sample.loads {
        let step = Step::new(&problem, &state, load);
        let again = solver.solve(&step);
        match (solver.solve(&step), again) {
            (Ok(_), Ok(_)) if !sample.solvable => {
                return Err(Breach::Impossible { sample: name });
            }
            (Ok(solution), Ok(again)) => {
                if solution.trial != again.trial {
                    return Err(Breach::NotRepeatable { sample: name });
                }
                check_solution(name, &step, &solution)?;
                allowed(name, solution.stop)?;
                let end = Increment::accept(&step, solution.trial).state;
                forces.push(end.forces.clone());
                state = end;
            }
            (Err(failure), Err(again)) => {
                if failure != again {
                    return Err(Breach::NotRepeatable { sample: name });
                }
                if failure.attempts.iter().all(|(solver, _)| solver.is_empty()) {
                    return Err(Breach::NoReason { sample: name });
                }
                if sample.solvable {
                    let reason = failure.to_string();
                    return Err(Breach::Refused {
                        sample: name,
                        reason,
                    });
                }
            }
            _ => return Err(Breach::NotRepeatable { sample: name }),
        }
    }
    Ok(forces)
}

/// Measures a solution by the conditions themselves: complementarity, cones and balance, and motion that follows from its forces.
fn check_solution(
    sample: &'static str,
    step: &Step<'_>,
    solution: &StepSolution,
) -> Result<(), Breach> {
    let trial = &solution.trial;
    let violated = |found: f64, said: f64| {
        if found > said || found.is_nan() {
            Err(Breach::Violated {
                sample,
                found,
                said,
            })
        } else {
            Ok(())
        }
    };
    let residuals = Residuals::of(step, trial).largest();
    let said = solution.residuals.largest();
    violated((residuals - said).abs(), ROUNDING)?;
    if solution.stop == Stop::Verified {
        violated(residuals, VERIFIED)?;
    }
    let motion = step.total_motion(step.motion(&trial.forces, &trial.rigid));
    // Points that stick where they were have moved by rounding only, which is no scale.
    let scale = motion.amax().max(step.free_motion().amax());
    let scale = scale.max(f64::MIN_POSITIVE);
    violated((motion - &trial.motion).amax() / scale, VERIFIED)
}

/// Two coupled points on a rigid ground below them, pressed by the first load case and pushed along it by the second.
fn problem(floating: bool, [length, force]: [f64; 2]) -> Result<InterfaceProblem, Breach> {
    let give = length / force;
    let compliance = give
        * DMatrix::from_row_slice(
            4,
            4,
            &[
                2.0, 0.2, 0.4, 0.0, 0.2, 1.5, 0.0, 0.3, 0.4, 0.0, 1.8, 0.1, 0.0, 0.3, 0.1, 1.2,
            ],
        );
    let body = if floating {
        let motions = DMatrix::from_row_slice(4, 2, &[1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0]);
        let resultants = [[-force, 0.0], [0.0, force]].map(|load| DVector::from_row_slice(&load));
        GivenBody::floating(
            compliance,
            motions,
            vec![DVector::zeros(4); 2],
            resultants.to_vec(),
        )?
    } else {
        let responses = [[-1.0, 0.1, -0.6, 0.0], [0.0, 0.9, 0.1, 0.5]];
        let responses = responses.map(|response| length * DVector::from_row_slice(&response));
        GivenBody::held(compliance, responses.to_vec())?
    };
    let ground = RigidBody::held(body.points().to_vec(), 2);
    let points = (0..2).map(|k| ContactPoint {
        first: k.into(),
        second: k.into(),
        normal: [1.0, 0.0],
        gap: 0.125 * length * k as f64,
        area: length * length,
        material_angle: 0.0,
    });
    let pair = ContactPair {
        name: "ground".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points: points.collect(),
        law: Arc::new(Coulomb::new(0.3)?),
    };
    Ok(InterfaceProblem::new(&[&body, &ground], vec![pair])?)
}
