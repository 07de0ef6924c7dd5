//! Study 2: the size of load steps. Friction remembers its path, so the steps are part of the answer.

use std::sync::Arc;

use stickslip_contact::state::TrialState;
use stickslip_contact::{ContactState, InterfaceProblem};
use stickslip_friction::{FrictionLaw, StaticDynamic, Transition};
use stickslip_laboratory::discrete::commit;

use super::context::{Context, Found};
use super::history::increment;
use super::joint::{Joint, coulomb, set};
use super::judge::{distance, judge};
use super::methods::{CHAIN, Method, methods};
use super::row::Row;
use crate::publish::TaskError;

const LIMIT_LBF: f64 = 1240.0;
const CYCLE_LBF: [f64; 2] = [1980.0, 535.0];
/// Steps beyond which only the methods that are used for histories are tried.
const MANY: usize = 100;
const FAST: [&str; 3] = [CHAIN, "semismooth Newton", "status iteration"];

/// A load path under a friction law.
struct Case {
    name: &'static str,
    problem: InterfaceProblem,
    corners: Vec<f64>,
}

pub(super) fn run(context: &Context) -> Result<Found, TaskError> {
    let numbers: &[usize] = context.sized(
        &[1, 2, 5, 10, 100],
        &[1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000],
    );
    let spacing = context.sized("18 deg", "6 deg");
    let pin = Joint::of_scene("pin-benchmark", &set(&[("mesh.spacing", spacing.into())]))?;
    let cases = cases(&pin)?;
    let mut jobs: Vec<(usize, usize, Method)> = Vec::new();
    for case in 0..cases.len() {
        for &number in numbers {
            let fast = |method: &Method| number <= MANY || FAST.contains(&method.name);
            let own = methods().into_iter().filter(fast);
            jobs.extend(own.map(|method| (case, number, method)));
        }
    }
    // The longest first, so that both cores end together.
    jobs.sort_by_key(|(_, number, _)| usize::MAX - number);
    let unit: Vec<f64> = pin.loads[3].iter().map(|load| load / LIMIT_LBF).collect();
    let ends = std::sync::Mutex::new(Vec::new());
    let mut rows = context.rows_of(&jobs, |(case, number, method)| {
        let (row, end) = follow(&cases[*case], *number, &unit, method);
        if let (Some(end), Ok(mut ends)) = (end, ends.lock()) {
            ends.push((*case, *number, method.name, end));
        }
        Ok(vec![row])
    })?;
    let ends = ends.into_inner().map_err(|_| "a history panicked")?;
    let finest = numbers[numbers.len() - 1];
    for row in &mut rows {
        let Some(case) = cases.iter().position(|case| case.name == row.case) else {
            continue;
        };
        let end = |number: usize, method: &str| {
            let found = |(c, n, m, _): &&(usize, usize, &str, TrialState)| {
                *c == case && *n == number && *m == method
            };
            ends.iter().find(found).map(|(_, _, _, trial)| trial)
        };
        row.error = end(row.value as usize, row.method)
            .zip(end(finest, CHAIN))
            .map(|(trial, limit)| distance(&trial.forces, &limit.forces, 0.0));
    }
    let order = |row: &Row| {
        methods()
            .iter()
            .position(|method| method.name == row.method)
    };
    rows.sort_by(|a, b| {
        let place = |row: &Row| cases.iter().position(|case| case.name == row.case);
        (place(a), a.value as usize, order(a)).cmp(&(place(b), b.value as usize, order(b)))
    });
    Ok(Found::of("steps_per_leg", rows))
}

fn cases(pin: &Joint) -> Result<Vec<Case>, TaskError> {
    let coulomb = coulomb(0.25)?;
    let drop: Arc<dyn FrictionLaw> = Arc::new(StaticDynamic::new(0.35, 0.25, Transition::Drop)?);
    let once = vec![LIMIT_LBF];
    let cycle = CYCLE_LBF.to_vec();
    let list = [
        ("Coulomb, loaded", &coulomb, &once),
        ("Coulomb, loaded and unloaded", &coulomb, &cycle),
        ("static and dynamic, loaded", &drop, &once),
        ("static and dynamic, loaded and unloaded", &drop, &cycle),
    ];
    let case = |(name, law, corners): (_, _, &Vec<f64>)| {
        let (problem, corners) = (pin.problem_with(law)?, corners.clone());
        Ok(Case {
            name,
            problem,
            corners,
        })
    };
    list.into_iter().map(case).collect()
}

/// Follows a path in `number` equal steps per leg; the row, and the end if it is reached.
fn follow(case: &Case, number: usize, unit: &[f64], method: &Method) -> (Row, Option<TrialState>) {
    let start = ContactState::unloaded(&case.problem);
    let mut given = increment(case.problem.clone(), start, Vec::new());
    let mut steps = Vec::new();
    let mut end = None;
    let mut from = 0.0;
    'path: for &to in &case.corners {
        for k in 1..=number {
            let load = from + (to - from) * (k as f64 / number as f64);
            given.multipliers = unit.iter().map(|share| share * load).collect();
            // The step's own answer is not known: the judge looks at its conditions.
            if let Ok(solution) = method.solver.solve(&given.step()) {
                let violation = given.check(&solution.trial);
                steps.push(super::judge::accepted(method, &solution, violation));
                given.committed = commit(&given.committed, &solution.trial, &given.multipliers);
                end = Some(solution.trial);
            } else {
                steps.push(judge(method, &given, None));
                end = None;
                break 'path;
            }
        }
        from = to;
    }
    let mut row = Row::of_steps(case.name, number as f64, given.coercive, &steps);
    row.method = method.name;
    row.steps = number * case.corners.len();
    (row, end)
}
