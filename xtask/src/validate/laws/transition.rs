//! The slip power law, whose coefficient passes from one value to another over a length.

use rayon::prelude::*;
use stickslip::experiment::laws::{Candidate, Comparison, Fit, coefficient};
use stickslip_hybrid::identify::Bounds;

use super::{PAIRS, Study, candidate, coulomb, drop_candidate, estimate, evaluations, law};
use crate::publish::TaskError;
use crate::validate::check::Checks;
use crate::validate::check::Tolerance::Relative;

/// How far the coefficient found may be from the truth anywhere along the slip path that was reached, a tenth of what it falls by.
const NEAR: f64 = 0.02;
/// Places along the slip path.
const PLACES: usize = 60;
/// A count of intervals of 95 % is asserted to be one that chance alone goes below with less than this probability.
const UNLIKELY: f64 = 0.01;
const TRANSITION: &str =
    r#"{ "slip_power": { "static": 0.4, "dynamic": 0.2, "slip_scale": 0.002, "exponent": 2.0 } }"#;
/// Its parameters, and how far off the median may be, parts. Length and exponent make up for each other: their own intervals span a factor
/// of ten and more, so that nothing can be asserted of so few values.
const KNOWN: [(&str, f64, Option<f64>); 4] = [
    ("static", 0.4, Some(0.05)),
    ("dynamic", 0.2, Some(0.05)),
    ("slip_scale", 0.002, None),
    ("exponent", 2.0, None),
];
/// Load steps at which a transition is seen, from 0.
const TRANSITION_STEPS: [usize; 4] = [2, 3, 6, 9];

/// The slip power law with its length: its parameters over seeds and pairs of meshes, and once its rivals.
pub(super) fn checks(
    checks: &mut Checks,
    studies: &[Study],
    seeds: u64,
) -> Result<usize, TaskError> {
    let power = candidate_of_transition()?;
    let rivals = [coulomb()?, drop_candidate()?, power.clone()];
    let first = studies[1].fitted(TRANSITION, &rivals, &TRANSITION_STEPS, 1)?;
    let mut solves = evaluations(&first);
    let distances: Vec<String> = (first.fits.iter())
        .map(|fit| format!("{} +{:.0}", fit.law.name, fit.distance))
        .collect();
    let ruled_out = first.fits[..2].iter().all(|fit| fit.distance > 10.0);
    let mut fits = Vec::new();
    for study in studies {
        let found: Vec<Comparison> = (1..=seeds)
            .into_par_iter()
            .map(|seed| {
                study.fitted(
                    TRANSITION,
                    std::slice::from_ref(&power),
                    &TRANSITION_STEPS,
                    seed,
                )
            })
            .collect::<Result<_, _>>()?;
        solves += found.iter().map(evaluations).sum::<usize>();
        fits.push(found.into_iter().flat_map(|own| own.fits).collect());
    }
    for known in KNOWN {
        parameter(checks, &fits, known)?;
    }
    curve(checks, studies, &fits)?;
    checks.holds(
        "displacements of the slip power law: AICc above the least",
        "slip power 0, all others above 10",
        distances.join(", "),
        first.best == 2 && ruled_out,
    );
    Ok(solves)
}

/// One parameter in the fits of each study.
fn parameter(
    checks: &mut Checks,
    fits: &[Vec<Fit>],
    (name, truth, limit): (&str, f64, Option<f64>),
) -> Result<(), TaskError> {
    let mut values = Vec::new();
    let mut counts = Vec::new();
    let mut two_ended = 0;
    for own in fits {
        let found: Vec<(f64, Bounds)> = (own.iter())
            .map(|fit| estimate(fit, name))
            .collect::<Result<_, _>>()?;
        counts.push(found.iter().filter(|own| own.1.contain(truth)).count());
        two_ended += found
            .iter()
            .filter(|own| matches!(own.1, Bounds::Between(..)))
            .count();
        values.extend(found.iter().map(|(value, _)| *value));
    }
    let count = values.len();
    values.sort_by(f64::total_cmp);
    let median = 0.5 * (values[(count - 1) / 2] + values[count / 2]);
    let what = format!("slip power law: {name}, median of {count} fits");
    let unit = if name == "slip_scale" { " mm" } else { "" };
    match limit {
        Some(limit) => checks.near(what, [median, truth], Relative(limit, unit)),
        None => checks.show(what, format!("{truth}{unit}"), format!("{median:.4}{unit}")),
    }
    let held: usize = counts.iter().sum();
    let each = counts.iter().zip(PAIRS);
    let each: Vec<String> = each
        .map(|(own, [truth, model])| format!("{own} with {truth}° and {model}°"))
        .collect();
    let least = fewest(count);
    checks.holds(
        format!("slip power law: intervals of 95 % of {name}, mesh error held, truth and model on meshes of two spacings"),
        format!("hold {truth} in {least} of {count} at least"),
        format!("{held} of {count}, {two_ended} of them with two ends: {}", each.join(", ")),
        held >= least,
    );
    Ok(())
}

/// The coefficient along the slip path, whose parameters make up for each other: the farthest from the truth in each study.
fn curve(checks: &mut Checks, studies: &[Study], fits: &[Vec<Fit>]) -> Result<(), TaskError> {
    let truth = law(TRANSITION)?;
    for (k, (study, own)) in studies.iter().zip(fits).enumerate() {
        let reach = study.slipped(TRANSITION, TRANSITION_STEPS[TRANSITION_STEPS.len() - 1])?;
        let slips: Vec<f64> = (0..=PLACES)
            .map(|k| reach * (k as f64 / PLACES as f64).powi(2))
            .collect();
        let mut apart = 0.0_f64;
        for fit in own {
            let found = fit.law.law(&fit.calibration.values())?;
            for &slip in &slips {
                let pair = [found.as_ref(), truth.as_ref()].map(|law| coefficient(law, slip));
                let [Some(a), Some(b)] = pair else {
                    return Err("a law of the slip path alone has a coefficient".into());
                };
                apart = apart.max((a - b).abs());
            }
        }
        let [finer, model] = PAIRS[k];
        checks.holds(
            format!("slip power law: μ(slip) up to {reach:.4} mm, truth and model on meshes of {finer}° and {model}°: farthest of {} fits", own.len()),
            format!("within {NEAR} of the truth, which falls by 0.2"),
            format!("{apart:.4}"),
            apart <= NEAR,
        );
    }
    Ok(())
}

/// The least number of `count` intervals of 95 % that hold the truth unless chance does what it does with less than [`UNLIKELY`].
fn fewest(count: usize) -> usize {
    // Probability that exactly `missed` do not.
    let mut exactly = 0.95_f64.powi(count as i32);
    let mut more = 1.0 - exactly;
    let mut missed = 0;
    while more > UNLIKELY && missed < count {
        exactly *= (count - missed) as f64 / (missed + 1) as f64 * (0.05 / 0.95);
        missed += 1;
        more -= exactly;
    }
    count - missed
}

fn candidate_of_transition() -> Result<Candidate, TaskError> {
    let free = [
        ("static", [0.0, 1.0]),
        ("dynamic", [0.0, 1.0]),
        ("slip_scale", [1e-4, 1e-1]),
        ("exponent", [0.2, 8.0]),
    ];
    candidate("slip power", TRANSITION, &free)
}
