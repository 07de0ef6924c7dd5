//! Problems whose solutions are all known as exact fractions.
//!
//! Source: independent exact enumeration in rational arithmetic, made apart from this project's solvers; the numbers are those
//! of the tests of the contact crate, in whose folder `data/README.md` describes them.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use serde::Deserialize;
use stickslip_contact::state::TrialState;
use stickslip_contact::{ContactState, InterfaceProblem, Status};
use stickslip_fem_core::GivenBody;
use stickslip_friction::Coulomb;

use super::{Discrete, GroundPoint, Known, commit, on_ground};
use crate::error::LaboratoryError;

/// A problem and the statuses of its solutions.
#[derive(Clone, Debug)]
pub struct Published {
    /// The increment; [`Discrete::solutions`] holds the solutions.
    pub discrete: Discrete,
    /// Statuses that each solution has; more than one where it lies on a border.
    pub statuses: Vec<Vec<Vec<Status>>>,
}

#[derive(Deserialize)]
struct Tables {
    static_increment_cases: Vec<Increment>,
    non_coercive: Vec<Increment>,
    load_histories: Vec<LoadHistory>,
}

#[derive(Deserialize)]
struct Increment {
    name: String,
    #[serde(rename = "K_N_per_mm")]
    stiffness: Vec<Vec<String>>,
    #[serde(rename = "F_N")]
    force: Vec<String>,
    #[serde(rename = "g0_mm")]
    gaps: Vec<String>,
    mu: String,
    #[serde(rename = "u_t_prev_mm")]
    previous: Vec<String>,
    number_of_solutions: usize,
    #[serde(default)]
    solutions: Vec<Solution>,
}

#[derive(Deserialize)]
struct Solution {
    status: Vec<String>,
    #[serde(rename = "u_mm", alias = "u")]
    displacement: Vec<String>,
    #[serde(rename = "lam_N", alias = "lam")]
    force: Vec<String>,
}

#[derive(Deserialize)]
struct LoadHistory {
    name: String,
    #[serde(rename = "K_N_per_mm")]
    stiffness: Vec<Vec<String>>,
    mu: String,
    steps: Vec<HistoryStep>,
}

#[derive(Deserialize)]
struct HistoryStep {
    #[serde(rename = "F")]
    force: Vec<String>,
    all_solutions: Vec<Solution>,
    followed: Vec<String>,
    #[serde(rename = "u")]
    displacement: Vec<String>,
    #[serde(rename = "lam")]
    reaction: Vec<String>,
}

/// All published increments: single ones with and without supports, and those of load histories, each from the state before.
///
/// # Errors
/// [`LaboratoryError::Missing`] if the tables do not read.
pub fn published() -> Result<Vec<Published>, LaboratoryError> {
    let text = include_str!("../../../contact/tests/data/discrete_coulomb.json");
    let tables: Tables = serde_json::from_str(text)
        .map_err(|cause| LaboratoryError::Missing(format!("published problems: {cause}")))?;
    let mut all = Vec::new();
    for (cases, coercive) in [
        (&tables.static_increment_cases, true),
        (&tables.non_coercive, false),
    ] {
        for case in cases {
            all.push(increment(case, coercive)?);
        }
    }
    for history in &tables.load_histories {
        follow(history, &mut all)?;
    }
    Ok(all)
}

fn increment(case: &Increment, coercive: bool) -> Result<Published, LaboratoryError> {
    let gaps = fractions(&case.gaps)?;
    let problem = problem(&case.stiffness, &gaps, fraction(&case.mu)?)?;
    let mut committed = ContactState::unloaded(&problem);
    for (k, previous) in fractions(&case.previous)?.into_iter().enumerate() {
        committed.motion[2 * k + 1] = previous;
    }
    let multipliers = normal_first(&fractions(&case.force)?).as_slice().to_vec();
    let states = states(&case.solutions, &gaps, &problem, &multipliers)?;
    let statuses = statuses_of(&case.solutions)?;
    // At the critical coefficient the solutions are a continuum, of which only the ends are listed.
    let continuum = case.name.starts_with("B2");
    Ok(Published {
        discrete: Discrete {
            name: case.name.clone(),
            problem,
            committed,
            multipliers,
            coercive,
            solutions: Some(Known {
                complete: !continuum && case.number_of_solutions == states.len(),
                states,
            }),
        },
        statuses,
    })
}

fn follow(history: &LoadHistory, all: &mut Vec<Published>) -> Result<(), LaboratoryError> {
    let gaps = vec![0.0; history.stiffness.len() / 2];
    let problem = problem(&history.stiffness, &gaps, fraction(&history.mu)?)?;
    let mut committed = ContactState::unloaded(&problem);
    for (index, step) in history.steps.iter().enumerate() {
        let multipliers = normal_first(&fractions(&step.force)?).as_slice().to_vec();
        let states = states(&step.all_solutions, &gaps, &problem, &multipliers)?;
        all.push(Published {
            discrete: Discrete {
                name: format!("{}, step {}", history.name, index + 1),
                problem: problem.clone(),
                committed: committed.clone(),
                multipliers: multipliers.clone(),
                coercive: true,
                solutions: Some(Known {
                    complete: true,
                    states,
                }),
            },
            statuses: statuses_of(&step.all_solutions)?,
        });
        let followed = TrialState {
            forces: normal_first(&fractions(&step.reaction)?),
            motion: normal_first(&fractions(&step.displacement)?),
            rigid: DVector::zeros(0),
            status: letters(step.followed.first().map_or("", String::as_str))?,
        };
        committed = commit(&committed, &followed, &multipliers);
    }
    Ok(())
}

/// The body K on the ground, with a unit force on each dof as a load case; directions that K leaves free are rigid motions.
fn problem(
    stiffness: &[Vec<String>],
    gaps: &[f64],
    mu: f64,
) -> Result<InterfaceProblem, LaboratoryError> {
    let size = stiffness.len();
    let rows: Vec<Vec<f64>> = stiffness
        .iter()
        .map(|row| fractions(row))
        .collect::<Result<_, _>>()?;
    if rows.iter().any(|row| row.len() != size) || size != 2 * gaps.len() {
        return Err(broken("a stiffness is not square"));
    }
    let mut held = DMatrix::from_fn(size, size, |i, j| rows[i ^ 1][j ^ 1]);
    let free: Vec<usize> = (0..size).filter(|&i| held.row(i).amax() == 0.0).collect();
    for &i in &free {
        held[(i, i)] = 1.0;
    }
    let mut compliance = held
        .try_inverse()
        .ok_or_else(|| broken("a stiffness is singular"))?;
    for &i in &free {
        compliance[(i, i)] = 0.0;
    }
    let modes = DMatrix::from_fn(size, free.len(), |i, j| f64::from(u8::from(i == free[j])));
    let responses = (0..size)
        .map(|i| compliance.column(i).into_owned())
        .collect();
    let mode_loads = (0..size).map(|i| modes.row(i).transpose()).collect();
    let body = GivenBody::floating(compliance, modes, responses, mode_loads)?;
    let points: Vec<GroundPoint> = gaps.iter().copied().map(GroundPoint::along_x).collect();
    let law = Coulomb::new(mu).map_err(|cause| broken(&cause.to_string()))?;
    Ok(on_ground(&body, &points, Arc::new(law))?)
}

fn states(
    solutions: &[Solution],
    gaps: &[f64],
    problem: &InterfaceProblem,
    multipliers: &[f64],
) -> Result<Vec<TrialState>, LaboratoryError> {
    let rigid = problem.modes().ncols();
    solutions
        .iter()
        .map(|solution| {
            let mut motion = normal_first(&fractions(&solution.displacement)?);
            for (k, gap) in gaps.iter().enumerate() {
                motion[2 * k] += gap;
            }
            let forces = normal_first(&fractions(&solution.force)?);
            // The rigid motions are displacements of their own, the elastic part being zero along them.
            let elastic =
                &*problem.compliance().to_matrix() * &forces + problem.load_motion(multipliers);
            let mut rest = &motion - elastic;
            for (k, gap) in gaps.iter().enumerate() {
                rest[2 * k] -= gap;
            }
            Ok(TrialState {
                rigid: if rigid == 0 {
                    DVector::zeros(0)
                } else {
                    problem.modes().tr_mul(&rest)
                },
                forces,
                motion,
                status: letters(solution.status.first().map_or("", String::as_str))?,
            })
        })
        .collect()
}

fn statuses_of(solutions: &[Solution]) -> Result<Vec<Vec<Vec<Status>>>, LaboratoryError> {
    let one = |solution: &Solution| solution.status.iter().map(|text| letters(text)).collect();
    solutions.iter().map(one).collect()
}

fn letters(text: &str) -> Result<Vec<Status>, LaboratoryError> {
    let status = |letter| match letter {
        'O' => Ok(Status::Open),
        'S' => Ok(Status::Stick),
        '+' => Ok(Status::SlipPositive),
        '-' => Ok(Status::SlipNegative),
        other => Err(broken(&format!("'{other}' is no status"))),
    };
    text.chars().map(status).collect()
}

/// A number written as "a" or "a/b".
fn fraction(text: &str) -> Result<f64, LaboratoryError> {
    let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
    numerator
        .parse::<f64>()
        .ok()
        .zip(denominator.parse::<f64>().ok())
        .map(|(a, b)| a / b)
        .ok_or_else(|| broken(&format!("'{text}' is no fraction")))
}

fn fractions(texts: &[String]) -> Result<Vec<f64>, LaboratoryError> {
    texts.iter().map(|text| fraction(text)).collect()
}

/// Swaps t, n of each node for n, t.
fn normal_first(values: &[f64]) -> DVector<f64> {
    DVector::from_fn(values.len(), |i, _| values[i ^ 1])
}

fn broken(what: &str) -> LaboratoryError {
    LaboratoryError::Missing(format!("published problems: {what}"))
}
