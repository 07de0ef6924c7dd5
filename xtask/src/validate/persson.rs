//! Frictionless pin of the plate's own material in an infinite plate (Persson 1964; Ciavarella & Decuzzi 2001).

use stickslip::results::Results;
use stickslip_laboratory::references::persson::{STEPS, pressure};

use super::check::Tolerance::{Absolute, Relative};
use super::check::{Check, Checks, percent};
use super::laboratory::{Laboratory, Worst};
use crate::publish::TaskError;

/// Allowed errors: of the half-angle `[deg]`, of the pressure.
const ANGLE: f64 = 0.1;
const PRESSURE: f64 = 1e-3;
/// Spacings `[deg]`; the scene's own, in the middle, and the finest have to meet the bounds. On these two the ends of contact are
/// corner nodes, on the coarse one mid-side nodes.
const SPACINGS: [f64; 3] = [2.0, 1.0, 0.5];
const BOUNDED: std::ops::Range<usize> = 1..3;

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut runs = Vec::with_capacity(SPACINGS.len());
    for spacing in SPACINGS {
        let overrides = [format!("mesh.spacing=\"{spacing} deg\"")];
        runs.push(laboratory.run("pin-infinite-plate", &overrides)?);
    }
    let mut checks = Checks::against("Persson 1964, closed form");
    for (step, (half_angle, factor)) in STEPS.into_iter().enumerate() {
        let found: Vec<Errors> = runs
            .iter()
            .zip(SPACINGS)
            .map(|(run, spacing)| errors(run, step, half_angle, factor, spacing))
            .collect::<Result<_, _>>()?;
        for (errors, spacing) in found[BOUNDED].iter().zip(&SPACINGS[BOUNDED]) {
            let what = format!("half-angle {half_angle}°, spacing {spacing}°");
            bounds(&mut checks, &what, errors, half_angle);
        }
        let end = found.iter().map(|e| percent(e.end.value));
        let root = 2.0_f64.sqrt();
        let limit = (root * found[2].end.value - found[1].end.value) / (root - 1.0);
        checks.show(
            format!("half-angle {half_angle}°: pressure within 2h of the end, of its peak"),
            "falls like √h",
            format!(
                "{} at {}; √h-extrapolated {}",
                end.collect::<Vec<_>>().join(", "),
                SPACINGS.map(|s| format!("{s}°")).join(", "),
                percent(limit)
            ),
        );
        let order = (found[0].core / found[2].core).ln() / (SPACINGS[0] / SPACINGS[2]).ln();
        checks.show(
            format!("half-angle {half_angle}°: observed order of the pressure, θ ≤ ε/2"),
            "",
            format!(
                "{order:.2} from errors {}",
                found
                    .iter()
                    .map(|e| format!("{:.1e}", e.core))
                    .collect::<Vec<_>>()
                    .join(", ")
            ),
        );
    }
    Ok(checks.into_list())
}

fn bounds(checks: &mut Checks, what: &str, errors: &Errors, half_angle: f64) {
    checks.near(
        format!("{what}: half-angle"),
        [errors.half_angle, half_angle],
        Absolute(ANGLE, "°"),
    );
    checks.near(
        format!("{what}: peak pressure R t/Q"),
        [errors.peak, pressure(half_angle.to_radians(), 0.0)],
        Relative(PRESSURE, ""),
    );
    checks.error_below(
        format!("{what}: pressure more than 2h from the end, of its peak"),
        errors.inside.clone(),
        PRESSURE,
    );
}

struct Errors {
    /// `[deg]`
    half_angle: f64,
    /// p R t/Q
    peak: f64,
    /// More than 2h from the end, of the peak.
    inside: Worst,
    /// Within 2h of the end, of the peak.
    end: Worst,
    /// Over the inner half of the contact: root mean square, of the peak.
    core: f64,
}

fn errors(
    run: &Results,
    step: usize,
    half_angle: f64,
    factor: f64,
    spacing: f64,
) -> Result<Errors, TaskError> {
    let (geometry, edge) = (&run.edges[0], &run.steps[step].edges[0]);
    let missing = || format!("no contact in step {}", step + 1);
    let epsilon = half_angle.to_radians();
    let highest = pressure(epsilon, 0.0);
    let (mut inside, mut end) = (Worst::default(), Worst::default());
    let (mut square, mut count) = (0.0, 0.0);
    for (row, theta) in edge.rows.iter().zip(&geometry.parameter) {
        let error = (row.pressure / factor - pressure(epsilon, *theta)).abs() / highest;
        let place = || format!("worst at {:.2}°", theta.to_degrees());
        if (theta.to_degrees() - half_angle).abs() > 2.0 * spacing + 1e-9 {
            inside.meet(error, place);
        } else {
            end.meet(error, place);
        }
        if *theta <= 0.5 * epsilon {
            square += error * error;
            count += 1.0;
        }
    }
    Ok(Errors {
        half_angle: edge.contact_half_extent.ok_or_else(missing)?.to_degrees(),
        peak: edge.peak_pressure.ok_or_else(missing)?.0 / factor,
        inside,
        end,
        core: (square / f64::max(count, 1.0)).sqrt(),
    })
}
