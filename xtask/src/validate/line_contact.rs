//! Cylinder on a block of the same material: Hertz, and Cattaneo–Mindlin partial slip over a cycle.
//!
//! 40 mm of block and cylinder stand for the half-planes of the closed forms; the scene's cylinder is one up to a/R = 0.0018. A
//! cylinder with a tenth of its radius under ten times the load has the same a and is shown beside it: there the shear that
//! pressing leaves, odd in x, is not small. Part of it is made by the increments of pressing and falls as they get finer; the
//! rest is a/R = 0.018, which is not in the closed form.

use stickslip::results::{EdgeResults, Results};
use stickslip_laboratory::references::line_contact::{
    CYCLE, FRICTION, HALF_WIDTH, PEAK, STICK, reversed_stick, shear_loaded, shear_returned,
};

use super::check::Tolerance::{Absolute, Relative};
use super::check::{Check, Checks, percent};
use super::laboratory::{Laboratory, Worst};
use crate::publish::TaskError;

/// Corner spacing of the scene of Cattaneo and Mindlin `[mm]`.
const SPACING: f64 = 0.011;
/// Allowed error of the stick half-width (of a), of the shear (of its peak) and of the work.
const BOUND: f64 = 1e-2;

pub(super) fn hertz(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let spacing = laboratory.sized(0.04, 0.02);
    let results = laboratory.run(
        "hertz-cylinder",
        &[format!("mesh.spacing=\"{spacing} mm\"")],
    )?;
    let edge = &results.steps[0].edges[0];
    let mut checks = Checks::against("Hertz 1882");
    checks.near("peak pressure", [peak(edge)?, PEAK], Relative(2e-3, " MPa"));
    checks.near(
        "half-width",
        [extent(edge)?, HALF_WIDTH],
        Relative(2e-3, " mm"),
    );
    Ok(checks.into_list())
}

/// The scene as it is, and what is seen with a tenth of the radius.
pub(super) fn cattaneo(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against("Cattaneo 1938, Mindlin 1949");
    let results = laboratory.run("cattaneo-mindlin", &[])?;
    let stuck = results.steps[1].edges[0]
        .stick_half_extent
        .ok_or("no stick zone")?;
    checks.near(
        "stick half-width at Q = 0.5 μP, bound 1 % of a",
        [stuck, STICK],
        Absolute(BOUND * HALF_WIDTH, " mm"),
    );
    let lost: f64 = results.steps[2..].iter().map(|step| step.dissipation).sum();
    checks.near(
        "work lost in a cycle",
        [lost, CYCLE],
        Relative(BOUND, " N mm/mm"),
    );
    for (name, worst) in shear_errors(&results, 0.1 * PEAK) {
        checks.error_below(format!("shear {name}, {AWAY}"), worst, BOUND);
    }
    for (substeps, ramp) in [(4, "linear"), (32, "quadratic")] {
        let results = laboratory.run("cattaneo-mindlin", &small_radius(substeps, ramp))?;
        for (name, worst) in shear_errors(&results, PEAK).into_iter().take(1) {
            checks.show(
                format!("R = 50 mm, {substeps} {ramp} sub-steps: shear {name}, {AWAY}"),
                "half-planes; here a/R = 0.018",
                format!("{}, {}", percent(worst.value), worst.place),
            );
        }
    }
    Ok(checks.into_list())
}

/// A tenth of the radius under ten times the loads: same contact, ten times the stress.
fn small_radius(substeps: usize, ramp: &str) -> [String; 5] {
    let press = ["\"500 N\""; 6].join(", ");
    let push =
        ["0 N", "100 N", "0 N", "-100 N", "0 N", "100 N"].map(|force| format!("\"{force}\""));
    [
        "bodies.upper.shape.cylinder.radius=\"50 mm\"".into(),
        format!("loads.0.force.steps=[{press}]"),
        format!("loads.1.force.steps=[{}]", push.join(", ")),
        format!("analysis.substeps={substeps}"),
        format!("analysis.ramp=\"{ramp}\""),
    ]
}

const AWAY: &str = "more than 2h from ends of contact and stick, of its peak";

/// A shear over μp₀ as a function of x.
type Profile<'a> = &'a dyn Fn(f64) -> f64;

/// Errors of the shear over half a cycle against the closed form for the peak pressure `peak` `[MPa]`.
fn shear_errors(results: &Results, peak: f64) -> [(&'static str, Worst); 3] {
    let back = reversed_stick();
    let states: [(&str, usize, Profile<'_>); 3] = [
        ("at +Q", 1, &shear_loaded),
        ("back at 0", 2, &shear_returned),
        ("at −Q", 3, &|x| -shear_loaded(x)),
    ];
    states.map(|(name, step, exact)| {
        (
            name,
            shear_error(results, step, peak, &[STICK, back], exact),
        )
    })
}

/// Largest error of λ_t/(μp₀) against `exact`, over the largest shear at Q = 0.5 μP, away from the ends.
fn shear_error(
    results: &Results,
    step: usize,
    peak: f64,
    stick: &[f64],
    exact: Profile<'_>,
) -> Worst {
    let highest = shear_loaded(STICK);
    let (geometry, edge) = (&results.edges[0], &results.steps[step].edges[0]);
    let mut worst = Worst::default();
    for (row, &x) in edge.rows.iter().zip(&geometry.parameter) {
        let near = |end: f64| (x.abs() - end).abs() <= 2.0 * SPACING;
        if near(HALF_WIDTH) || stick.iter().any(|&end| near(end)) {
            continue;
        }
        // On the upper body friction acts along −x when it is pushed along +x, and e_t is −x.
        let error = (row.shear / (FRICTION * peak) - exact(x)).abs() / highest;
        worst.meet(error, || format!("worst at x = {x:.3} mm"));
    }
    worst
}

fn peak(edge: &EdgeResults) -> Result<f64, TaskError> {
    Ok(edge.peak_pressure.ok_or(OPEN)?.0)
}

fn extent(edge: &EdgeResults) -> Result<f64, TaskError> {
    Ok(edge.contact_half_extent.ok_or(OPEN)?)
}

const OPEN: &str = "the cylinder does not touch";
