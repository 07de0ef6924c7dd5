//! Runs the cases with friction once as they are and once with each deliberate mistake.
//!
//! A mistake is caught by a physical quantity that misses its bound, or by a proof that its load cannot be balanced at all. A
//! solver that gives up, and counts of its iterations, catch nothing.

use super::check::{Check, Checks, Verdict};
use super::laboratory::{Laboratory, Size, is_proved_impossible};
use super::mutation::Mutation;
use super::{Case, Outcome};
use crate::publish::TaskError;

/// Parts of cases that come out the same with a mistake: the case, and the beginning of the names of its checks.
const BLIND: [(&str, &str); 2] = [
    ("rigid-pin-friction", "orthotropic, μ = 0.2:"),
    ("rigid-pin-friction", "quasi-isotropic, μ = 0.2:"),
];
/// The mistake to which they are blind, and why.
const BLIND_TO: Mutation = Mutation::ForgottenHistory;
const PROPORTIONAL: &str =
    "zero clearance, one growing load: no slip reverses, and slip zones do not move";

/// Whether each of the `chosen` cases notices each mistake, on the quick meshes.
pub(super) fn outcome(chosen: &[&Case]) -> Outcome {
    let mut checks = Checks::against("");
    let (mut noticed, mut cases) = ([0_usize; Mutation::MISTAKES.len()], 0);
    for case in chosen.iter().filter(|case| case.friction) {
        eprintln!("{}, {}", case.title, Mutation::None.name());
        let control = case.checks(&Laboratory::new(Size::Quick, Mutation::None));
        let (found, met) = match &control {
            Ok(list) => {
                let (missed, of) = (missed(list).count(), bounded(list).count());
                (format!("{missed} of {of} fail"), missed == 0)
            }
            Err(error) => (error.to_string(), false),
        };
        let what = format!("{}: {}", case.title, Mutation::None.name());
        checks.holds(what, "all physical quantities pass", found, met);
        for (index, mutation) in Mutation::MISTAKES.into_iter().enumerate() {
            eprintln!("{}, {}", case.title, mutation.name());
            let mutant = case.checks(&Laboratory::new(Size::Quick, mutation));
            noticed[index] += usize::from(judge(&mut checks, case, mutation, mutant));
        }
        cases += 1;
    }
    for (mutation, count) in Mutation::MISTAKES.iter().zip(noticed) {
        checks.holds(
            format!("{}: cases that notice", mutation.name()),
            "at least one",
            format!("{count} of {cases}"),
            count > 0,
        );
    }
    Outcome {
        title: "Deliberate mistakes in friction".to_owned(),
        checks: checks.into_list(),
    }
}

/// Whether the case noticed.
fn judge(
    checks: &mut Checks,
    case: &Case,
    mutation: Mutation,
    mutant: Result<Vec<Check>, TaskError>,
) -> bool {
    let what = format!("{}: {}", case.title, mutation.name());
    let list = match mutant {
        Ok(list) => list,
        Err(error) if is_proved_impossible(&error) => {
            checks.holds(
                what,
                "impossible: a load without balance, by the solver's proof",
                error.to_string(),
                true,
            );
            return true;
        }
        Err(error) => {
            checks.show(
                what,
                "not solved and no proof: counts as not noticed",
                error.to_string(),
            );
            return false;
        }
    };
    let first = missed(&list).next().map_or_else(String::new, |check| {
        format!(
            "; first {}: {} {}",
            check.quantity, check.computed, check.error
        )
    });
    let caught = missed(&list).count();
    checks.holds(
        &what,
        "a physical quantity misses its bound",
        format!("{caught} of {} miss{first}", bounded(&list).count()),
        caught > 0,
    );
    let blind = |own: &&(&str, &str)| own.0 == case.name && mutation == BLIND_TO;
    for (_, quantities) in BLIND.iter().filter(blind) {
        let own = missed(&list).filter(|check| check.quantity.starts_with(quantities));
        let count = own.count();
        checks.holds(
            format!("{what}: {quantities} cannot notice"),
            PROPORTIONAL,
            format!("{count} miss"),
            count == 0,
        );
    }
    caught > 0
}

/// Physical quantities with a bound.
fn bounded(checks: &[Check]) -> impl Iterator<Item = &Check> {
    checks
        .iter()
        .filter(|check| check.physical && check.verdict != Verdict::Shown)
}

/// Those that miss it.
fn missed(checks: &[Check]) -> impl Iterator<Item = &Check> {
    bounded(checks).filter(|check| check.verdict == Verdict::Fail)
}
