//! Coulomb problems whose solutions are all known as exact fractions; `tests/data/README.md` names the source.

use nalgebra::{DMatrix, DVector};
use serde_json::Value;
use stickslip_contact::solver::{FailureCause, Residuals, Step, StepSolution};
use stickslip_contact::state::TrialState;
use stickslip_contact::{
    Chain, ContactState, Enumeration, InterfaceProblem, InterfaceSolver, LoadHistory, Pivoting,
    Ramp, SemismoothNewton, Status, StatusIteration,
};

use crate::oracle::{Conditions, STATUSES};
use crate::{Ground, coulomb, solve};
use stickslip_fem_core::GivenBody;

/// The numbers have one or two digits and the matrices condition numbers below 100: rounding stays far below this.
const ROUNDING: f64 = 1e-12;

pub(crate) fn data() -> Value {
    serde_json::from_str(include_str!("../data/discrete_coulomb.json")).unwrap()
}

pub(crate) fn cases(data: &Value, family: &str) -> Vec<Value> {
    data[family].as_array().unwrap().clone()
}

/// A number written as "a" or "a/b".
fn fraction(value: &Value) -> f64 {
    let text = value.as_str().unwrap();
    let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
    numerator.parse::<f64>().unwrap() / denominator.parse::<f64>().unwrap()
}

fn fractions(values: &Value) -> Vec<f64> {
    values.as_array().unwrap().iter().map(fraction).collect()
}

/// Swaps t, n of each node for n, t.
fn normal_first(values: &[f64]) -> DVector<f64> {
    DVector::from_fn(values.len(), |i, _| values[i ^ 1])
}

fn stiffness(case: &Value) -> DMatrix<f64> {
    let rows: Vec<Vec<f64>> = case["K_N_per_mm"]
        .as_array()
        .unwrap()
        .iter()
        .map(fractions)
        .collect();
    DMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i ^ 1][j ^ 1])
}

/// The body K on the case's ground, with a unit force on each dof as a load case; directions that K leaves free are rigid
/// motions.
pub(crate) fn problem(case: &Value) -> InterfaceProblem {
    let stiffness = stiffness(case);
    let size = stiffness.nrows();
    let free: Vec<usize> = (0..size)
        .filter(|&i| stiffness.row(i).amax() == 0.0)
        .collect();
    let mut held = stiffness;
    for &i in &free {
        held[(i, i)] = 1.0;
    }
    let mut compliance = held.try_inverse().unwrap();
    for &i in &free {
        compliance[(i, i)] = 0.0;
    }
    let modes = DMatrix::from_fn(size, free.len(), |i, j| f64::from(u8::from(i == free[j])));
    let responses = (0..size)
        .map(|i| compliance.column(i).into_owned())
        .collect();
    let mode_loads = (0..size).map(|i| modes.row(i).transpose()).collect();
    let body = GivenBody::floating(compliance, modes, responses, mode_loads).unwrap();
    let gaps = case
        .get("g0_mm")
        .map_or_else(|| vec![0.0; size / 2], fractions);
    Ground::along_x(gaps, coulomb(fraction(&case["mu"]))).under(&body)
}

pub(crate) fn load(case: &Value) -> Vec<f64> {
    normal_first(&fractions(&case["F_N"])).as_slice().to_vec()
}

/// The state before the increment: tangential displacements as given, all points with status `status`.
pub(crate) fn committed(
    case: &Value,
    problem: &InterfaceProblem,
    status: Vec<Status>,
) -> ContactState {
    let mut state = ContactState::unloaded(problem);
    for (k, displacement) in fractions(&case["u_t_prev_mm"]).into_iter().enumerate() {
        state.motion[2 * k + 1] = displacement;
    }
    state.status = status;
    state
}

/// All combinations of statuses to start from.
pub(crate) fn starts(count: usize) -> impl Iterator<Item = Vec<Status>> {
    (0..4_usize.pow(count as u32))
        .map(move |code| (0..count).map(|k| STATUSES[code >> (2 * k) & 3]).collect())
}

pub(crate) fn statuses(letters: &str) -> Vec<Status> {
    let status = |letter| match letter {
        'O' => Status::Open,
        'S' => Status::Stick,
        '+' => Status::SlipPositive,
        '-' => Status::SlipNegative,
        other => panic!("status {other}"),
    };
    letters.chars().map(status).collect()
}

/// Whether `trial` is one of the `solutions`; `keys` name their displacements and forces.
fn is_listed(trial: &TrialState, gaps: &[f64], solutions: &Value, keys: [&str; 2]) -> bool {
    solutions.as_array().unwrap().iter().any(|solution| {
        let mut motion = normal_first(&fractions(&solution[keys[0]]));
        for (k, gap) in gaps.iter().enumerate() {
            motion[2 * k] += gap;
        }
        let forces = normal_first(&fractions(&solution[keys[1]]));
        (&trial.forces - &forces).amax() < ROUNDING && (&trial.motion - &motion).amax() < ROUNDING
    })
}

pub(crate) fn check_increment(
    case: &Value,
    problem: &InterfaceProblem,
    committed: &ContactState,
    solution: &StepSolution,
) {
    let name = case["name"].as_str().unwrap();
    let gaps = fractions(&case["g0_mm"]);
    let conditions = Conditions::new(problem, committed, &load(case));
    let violation = conditions.violation(&solution.trial);
    assert!(violation < ROUNDING, "{name}: {violation}");
    assert!(solution.residuals.largest() < ROUNDING);
    let step = Step::new(problem, committed, &load(case));
    assert_eq!(Residuals::of(&step, &solution.trial), solution.residuals);
    // At the critical coefficient the solutions are a continuum, of which only the ends are listed.
    assert!(
        name.starts_with("B2")
            || is_listed(
                &solution.trial,
                &gaps,
                &case["solutions"],
                ["u_mm", "lam_N"]
            ),
        "{name} by {}: {:?}",
        solution.solver,
        solution.trial
    );
}

#[test]
fn every_supported_increment_is_solved_from_every_start() {
    let solvers: [&dyn InterfaceSolver; 4] = [
        &Chain::default(),
        &Chain::status_first(),
        &Pivoting::default(),
        &Enumeration::default(),
    ];
    for case in cases(&data(), "static_increment_cases") {
        let problem = problem(&case);
        for start in starts(problem.points().len()) {
            let committed = committed(&case, &problem, start);
            for solver in solvers {
                let solution = solve(solver, &problem, &committed, &load(&case))
                    .unwrap_or_else(|failure| panic!("{}: {failure}", case["name"]));
                check_increment(&case, &problem, &committed, &solution);
            }
        }
    }
}

#[test]
fn fast_solvers_solve_or_say_why_not() {
    let solvers: [&dyn InterfaceSolver; 2] =
        [&StatusIteration::default(), &SemismoothNewton::default()];
    for case in cases(&data(), "static_increment_cases") {
        let problem = problem(&case);
        for start in starts(problem.points().len()) {
            let committed = committed(&case, &problem, start);
            for solver in solvers {
                match solve(solver, &problem, &committed, &load(&case)) {
                    Ok(solution) => check_increment(&case, &problem, &committed, &solution),
                    Err(failure) => {
                        let [(name, cause)] = failure.attempts.as_slice() else {
                            panic!("{failure}")
                        };
                        assert_eq!(*name, solver.name());
                        let typed =
                            matches!(cause, FailureCause::Cycled { .. } | FailureCause::Singular);
                        assert!(typed, "{}: {failure}", case["name"]);
                        assert!(failure.work.solves > 0);
                    }
                }
            }
        }
    }
}

#[test]
fn enumeration_by_the_oracle_finds_the_listed_solutions() {
    for case in cases(&data(), "static_increment_cases") {
        let problem = problem(&case);
        let committed = committed(&case, &problem, vec![Status::Open; problem.points().len()]);
        let all = Conditions::new(&problem, &committed, &load(&case)).enumerate();
        assert_eq!(
            all.solutions.len() as u64,
            case["number_of_solutions"].as_u64().unwrap(),
            "{}",
            case["name"]
        );
        for solution in &all.solutions {
            assert!(is_listed(
                solution,
                &fractions(&case["g0_mm"]),
                &case["solutions"],
                ["u_mm", "lam_N"]
            ));
        }
    }
}

/// The traces in the data are those of the status iteration by its rules, made apart from this project.
#[test]
fn status_iteration_cycles_from_the_known_starts_with_the_known_period() {
    let mut cycles = 0;
    for case in cases(&data(), "static_increment_cases") {
        let Some(traces) = case.get("naive_iteration").and_then(Value::as_object) else {
            continue;
        };
        let problem = problem(&case);
        for (start, outcome) in traces {
            let committed = committed(&case, &problem, statuses(start));
            let found = solve(
                &StatusIteration::default(),
                &problem,
                &committed,
                &load(&case),
            );
            if outcome["result"] == "converged" {
                assert_eq!(found.unwrap().trial.status, statuses(start));
                continue;
            }
            let trace: Vec<Vec<Status>> = outcome["trace"]
                .as_array()
                .unwrap()
                .iter()
                .map(|status| statuses(status.as_str().unwrap()))
                .collect();
            let (last, before) = trace.split_last().unwrap();
            let first = before.iter().position(|status| status == last).unwrap();
            let cycle = &before[first..];
            let points = (0..last.len())
                .filter(|&k| cycle.iter().any(|status| status[k] != last[k]))
                .collect();
            let expected = FailureCause::Cycled {
                period: cycle.len(),
                points,
            };
            assert_eq!(
                found.unwrap_err().attempts,
                [("status iteration", expected)]
            );
            assert!(cycle.len() >= 2);
            cycles += 1;
        }
    }
    assert_eq!(cycles, 3 + 15);
}

#[test]
fn load_histories_follow_the_committed_state() {
    for case in cases(&data(), "load_histories") {
        let problem = problem(&case);
        let steps = case["steps"].as_array().unwrap();
        let loads = steps
            .iter()
            .map(|step| normal_first(&fractions(&step["F"])).as_slice().to_vec())
            .collect();
        let history = LoadHistory::new(loads, 1, Ramp::Linear).unwrap();
        for solver in [Chain::default(), Chain::status_first()] {
            let records = history.follow(&problem, &solver, |_| {}).unwrap();
            for (step, record) in steps.iter().zip(&records) {
                let forces = normal_first(&fractions(&step["lam"]));
                let motion = normal_first(&fractions(&step["u"]));
                assert!(
                    (&record.state.forces - forces).amax() < ROUNDING,
                    "{} {step}",
                    case["name"]
                );
                assert!(
                    (&record.state.motion - motion).amax() < ROUNDING,
                    "{} {step}",
                    case["name"]
                );
                assert_eq!((record.increments, record.cutbacks), (1, 0));
            }
        }
        // Pivoting does not look at the committed statuses: each of its increments is some solution of the same problem.
        let mut state = ContactState::unloaded(&problem);
        for step in steps {
            let load = normal_first(&fractions(&step["F"])).as_slice().to_vec();
            let solution = solve(&Pivoting::default(), &problem, &state, &load).unwrap();
            assert!(Conditions::new(&problem, &state, &load).violation(&solution.trial) < ROUNDING);
            assert!(is_listed(
                &solution.trial,
                &[0.0],
                &step["all_solutions"],
                ["u", "lam"]
            ));
            let followed = TrialState {
                forces: normal_first(&fractions(&step["lam"])),
                motion: normal_first(&fractions(&step["u"])),
                status: statuses(step["followed"][0].as_str().unwrap()),
                ..solution.trial
            };
            state = crate::commit(&state, &followed, &load);
        }
    }
}

#[test]
fn unsupported_increments_are_solved_or_proved_impossible() {
    for case in cases(&data(), "non_coercive") {
        let (name, problem) = (case["name"].as_str().unwrap(), problem(&case));
        for start in starts(1) {
            let committed = committed(&case, &problem, start);
            let found = solve(&Chain::default(), &problem, &committed, &load(&case));
            if case["number_of_solutions"] == 1 {
                check_increment(&case, &problem, &committed, &found.unwrap());
                continue;
            }
            let failure = found.unwrap_err();
            let (_, last) = failure.attempts.last().unwrap();
            if name.starts_with("N1") {
                // The load pulls along the only motion, and nothing holds that.
                assert_eq!(
                    *last,
                    FailureCause::Unbalanced {
                        part: 1.0,
                        motion: vec![1.0],
                        proved: true
                    }
                );
                assert!(failure.is_proved_impossible());
            } else {
                // Friction might hold the motion, so no Farkas direction proves anything; enumeration does.
                assert_eq!(
                    *last,
                    FailureCause::NoSolution {
                        combinations: 4,
                        proved: true
                    }
                );
                assert!(!failure.is_proved_impossible());
            }
        }
    }
}

/// K(n, t) = [[3, −5], [−5, 9]], μ = 9/4, F = (−2, −2), g₀ = 3/10, last u_t = −1/2: pivoting with a covering vector of ones
/// ends on a ray, though λ = (3.6, −1) sticks: K (−0.3, −0.5) − F = (1.6 + 2, −3 + 2), and 1 ≤ 9/4 · 3.6.
#[test]
fn pivoting_meets_no_ray_at_large_friction() {
    let compliance = DMatrix::from_row_slice(2, 2, &[3.0, -5.0, -5.0, 9.0])
        .try_inverse()
        .unwrap();
    let response = &compliance * DVector::from_vec(vec![-2.0, -2.0]);
    let body = GivenBody::held(compliance, vec![response]).unwrap();
    let problem = Ground::along_x(vec![0.3], coulomb(2.25)).under(&body);
    let mut committed = ContactState::unloaded(&problem);
    committed.motion[1] = -0.5;
    let conditions = Conditions::new(&problem, &committed, &[1.0]);
    let sticking = DVector::from_vec(vec![3.6, -1.0]);
    let known = |trial: &TrialState| (&trial.forces - &sticking).amax() < ROUNDING;
    assert!(conditions.enumerate().solutions.iter().any(known));
    let solution = solve(&Pivoting::default(), &problem, &committed, &[1.0]).unwrap();
    assert!(conditions.violation(&solution.trial) < ROUNDING);
}
