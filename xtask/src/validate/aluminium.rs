//! The pin-loaded aluminium plate of Post & Reddy (1988): that every load step converges, in how many iterations, and what
//! the report saw of friction.

use stickslip::results::{EdgeGeometry, EdgeResults, Results, StepResults};

use super::check::{Check, Checks, number};
use super::laboratory::{Laboratory, PSI};
use crate::publish::TaskError;

const SCENES: [&str; 6] = [
    "pin-loaded-aluminium",
    "pin-loaded-aluminium-mesh-a",
    "pin-loaded-aluminium-mesh-b",
    "pin-loaded-aluminium-mesh-c",
    "pin-loaded-aluminium-mu-0.15",
    "pin-loaded-aluminium-mu-0.30",
];
const LOAD_STEPS: usize = 14;
/// Iterations of each step in the report, part II, mesh A.
const REPORTED: [usize; LOAD_STEPS] = [8, 8, 3, 3, 3, 1, 2, 2, 2, 3, 2, 3, 3, 3];
/// Largest total on the report's meshes A and B.
const MOST_ITERATIONS: usize = 60;
/// Load steps that are looked at: 1240 lb and 1980 lb while loading, 535 lb and 40 lb while unloading.
const LOADED: usize = 3;
const HIGHEST: usize = 6;
const UNLOADED: usize = 11;
const LAST: usize = 13;

pub(super) fn frictional(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against("Post & Reddy 1988, II: iterations on mesh A");
    let mut fine = None;
    for name in SCENES {
        let results = laboratory.run(name, &[])?;
        checks.converges(name, &results, LOAD_STEPS);
        iterations(&mut checks, name, &results);
        fine.get_or_insert(results);
    }
    if let Some(results) = fine {
        checks.now_against("Post & Reddy 1988, I: measured");
        physics(&mut checks, &results)?;
    }
    Ok(checks.into_list())
}

pub(super) fn frictionless(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let overrides = ["contacts.0.friction={ coulomb = { mu = 0 } }".to_owned()];
    let results = laboratory.run(SCENES[0], &overrides)?;
    let mut checks = Checks::against("Post & Reddy 1988, I: measured");
    let hoop = hoop_at_bearing_point(&results.steps[HIGHEST])? / PSI;
    checks.holds(
        "μ = 0: σ_θ at the bearing point, 1980 lb",
        "tensile",
        format!("{} psi", number(hoop)),
        hoop > 0.0,
    );
    Ok(checks.into_list())
}

fn iterations(checks: &mut Checks, name: &str, results: &Results) {
    let found: Vec<usize> = results.steps.iter().map(|step| step.work.solves).collect();
    let list = |counts: &[usize]| {
        let texts: Vec<String> = counts.iter().map(ToString::to_string).collect();
        format!("{}: {}", counts.iter().sum::<usize>(), texts.join(" "))
    };
    let quantity = format!("{name}: iterations in all and per step");
    let reported = list(&REPORTED);
    if name.ends_with("mesh-a") || name.ends_with("mesh-b") {
        let total: usize = found.iter().sum();
        checks.completes(
            format!("{quantity}, at most {MOST_ITERATIONS} in all"),
            reported,
            list(&found),
            total <= MOST_ITERATIONS,
        );
    } else {
        checks.show(quantity, reported, list(&found));
    }
}

fn physics(checks: &mut Checks, results: &Results) -> Result<(), TaskError> {
    let geometry = &results.edges[0];
    let peaks: Vec<f64> = results.steps[LOADED..=HIGHEST]
        .iter()
        .map(|step| peak_radial(step, geometry))
        .collect::<Result<_, _>>()?;
    let texts: Vec<String> = peaks.iter().map(|peak| format!("{peak:.3}")).collect();
    checks.holds(
        "largest −σ_r D t/P at 1240, 1460, 1670, 1980 lb",
        "about 0.9: 0.85 to 1",
        texts.join(", "),
        peaks.iter().all(|peak| (0.85..=1.0).contains(peak)),
    );

    let mut extents = Vec::with_capacity(HIGHEST + 1);
    let mut hoops = Vec::with_capacity(HIGHEST + 1);
    for step in &results.steps[..=HIGHEST] {
        hoops.push(hoop_at_bearing_point(step)? / PSI);
        extents.push(compressive_extent(geometry, &step.edges[0]));
    }
    let list = |values: &[f64], decimals: usize| {
        let texts: Vec<String> = values.iter().map(|v| format!("{v:.decimals$}")).collect();
        texts.join(", ")
    };
    checks.holds(
        "σ_θ at the bearing point while loading [psi]",
        "compressive",
        list(&hoops, 0),
        hoops.iter().all(|hoop| *hoop < 0.0),
    );
    checks.holds(
        "half-extent of compressive σ_θ, from 520 lb [deg]",
        "shrinks with load",
        list(&extents[2..], 2),
        extents[2..].windows(2).all(|pair| pair[1] < pair[0]),
    );
    reversal(checks, results);
    Ok(())
}

/// Shear of the sign that loading never has, on unloading.
fn reversal(checks: &mut Checks, results: &Results) {
    let geometry = &results.edges[0];
    let (forward, _) = shear_range(geometry, &results.steps[2].edges[0]);
    let (_, backward) = shear_range(geometry, &results.steps[UNLOADED].edges[0]);
    let before: f64 = results.steps[..=HIGHEST]
        .iter()
        .map(|step| shear_range(geometry, &step.edges[0]).1)
        .fold(0.0, f64::max);
    checks.holds(
        "reversed shear at 535 lb unloading, of the largest at 520 lb loading",
        "reversed, more than half",
        format!(
            "{:.2}; {:.3} while loading",
            backward / forward,
            before / forward
        ),
        backward > 0.5 * forward && before < 0.1 * forward,
    );
    let force = results.steps[LAST].edges[0].friction_force;
    checks.holds(
        "friction force at 40 lb unloading, over the normal force",
        "reversed: negative",
        format!("{:.4}", force / results.steps[LAST].edges[0].normal_force),
        force < 0.0,
    );
}

/// Largest shear `[MPa]` that holds the plate back from sliding away from the bearing point, and largest against it.
fn shear_range(geometry: &EdgeGeometry, edge: &EdgeResults) -> (f64, f64) {
    let mut range = (0.0_f64, 0.0_f64);
    for (row, theta) in edge.rows.iter().zip(&geometry.parameter) {
        let holding = -row.shear * theta.signum();
        range = (range.0.max(holding), range.1.max(-holding));
    }
    range
}

/// −σ_r over P/(Dt).
fn peak_radial(step: &StepResults, geometry: &EdgeGeometry) -> Result<f64, TaskError> {
    let edge = &step.edges[0];
    let bearing = edge.bearing_stress(geometry).ok_or("no bearing stress")?;
    let peak = edge.rows.iter().map(|row| -row.sigma_normal);
    Ok(peak.fold(0.0, f64::max) / bearing)
}

fn hoop_at_bearing_point(step: &StepResults) -> Result<f64, TaskError> {
    let hoop = step.edges[0].hoop_at_bearing_point;
    Ok(hoop.ok_or("no stress at the bearing point")?)
}

/// Angle `[deg]` from the bearing point at which σ_θ first becomes tensile; 0 if it is so there.
fn compressive_extent(geometry: &EdgeGeometry, edge: &EdgeResults) -> f64 {
    let hoop = |k: usize| edge.rows[k].sigma_tangential;
    let start = geometry.parameter.partition_point(|theta| *theta < 0.0);
    let Some(first) = (start..edge.rows.len()).find(|&k| hoop(k) >= 0.0) else {
        return 180.0;
    };
    if first == start {
        return 0.0;
    }
    let part = -hoop(first - 1) / (hoop(first) - hoop(first - 1));
    let (left, right) = (geometry.parameter[first - 1], geometry.parameter[first]);
    (left + part * (right - left)).to_degrees()
}
