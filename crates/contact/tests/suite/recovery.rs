//! What a history says of solvers that failed on its way.

use stickslip_contact::history::Cycle;
use stickslip_contact::solver::{FailureCause, Step};
use stickslip_contact::{
    Chain, ContactState, InterfaceSolver, LoadHistory, Ramp, StatusIteration, uniqueness_bound,
};

use crate::discrete::{cases, data, load, problem};

/// The published problems on which the status iteration cycles from no contact: the chain goes on with another solver, and its
/// record keeps period and points of the cycle, however many increments repeat it.
#[test]
fn a_cycle_that_the_chain_recovers_from_is_kept() {
    let mut cycles = 0;
    for case in cases(&data(), "static_increment_cases") {
        let problem = problem(&case);
        let start = ContactState::unloaded(&problem);
        let multipliers = load(&case);
        let step = Step::new(&problem, &start, &multipliers);
        let Err(alone) = StatusIteration::default().solve(&step) else {
            continue;
        };
        let solution = Chain::status_first().solve(&step).unwrap();
        assert_eq!(solution.attempts[0], alone.attempts[0]);
        let FailureCause::Cycled { period, points } = alone.attempts[0].1.clone() else {
            continue;
        };
        cycles += 1;
        let history = LoadHistory::new(vec![multipliers], 1, Ramp::Linear).unwrap();
        let records = history
            .follow(&problem, &Chain::status_first(), |_| {})
            .unwrap();
        let recovery = &records[0].recovery;
        let expected = Cycle {
            solver: "status iteration",
            period,
            points,
        };
        assert_eq!(recovery.first_cycle, Some(expected));
        let first = recovery.failures[0];
        assert_eq!(
            (first.solver, first.kind, first.count),
            ("status iteration", "cycled", 1)
        );
        assert_eq!(recovery.failures.len(), solution.attempts.len());
    }
    assert!(cycles > 0, "no problem cycles");
}

/// Where the first solver solves every increment nothing is said; friction and the estimate of its bound are.
#[test]
fn an_ordinary_history_has_nothing_to_say_but_its_bound() {
    let case = &cases(&data(), "load_histories")[0];
    let problem = problem(case);
    let press = vec![-1.0, 0.0];
    let history = LoadHistory::new(vec![press], 4, Ramp::Linear).unwrap();
    let record = &history.follow(&problem, &Chain::default(), |_| {}).unwrap()[0];
    assert!(record.recovery.is_empty(), "{:?}", record.recovery);
    assert!(record.state.status[0].touches());
    let text = case["mu"].as_str().unwrap();
    let (above, below) = text.split_once('/').unwrap_or((text, "1"));
    let mu = above.parse::<f64>().unwrap() / below.parse::<f64>().unwrap();
    assert!((record.coefficient / mu - 1.0).abs() < 1e-12);
    assert_eq!(
        record.uniqueness,
        uniqueness_bound(&problem, &record.state.status)
    );
}
