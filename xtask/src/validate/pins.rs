//! Pins of other kinds: one pressed into a smaller hole, and a steel pin in an orthotropic strip.
//!
//! ```text
//! p = E c / (2R)                                  infinite plate, pin of the same material, interference c
//! p = (E c/R) / (2 + 2R²/(b² − R²))               ring of outer radius b
//! ```
//!
//! (Lamé 1852). An interference stores the more energy ½∮ p c ds the more material surrounds it, so the mean pressure in the
//! strip lies between that of the largest ring inside it and that of the infinite plate.

use std::f64::consts::PI;

use stickslip::results::{EdgeResults, Results};
use stickslip_contact::Status;

use super::check::{Check, Checks, number};
use super::laboratory::{Laboratory, PSI};
use super::rigid_pin;
use crate::publish::TaskError;

/// Young's modulus `[psi]`, interference, radius of the hole, thickness, and distance from its centre to the nearest edge `[in]`.
const YOUNG: f64 = 10.4e6;
const INTERFERENCE: f64 = 0.0005;
const RADIUS: f64 = 0.375;
const THICKNESS: f64 = 0.06;
const TO_EDGE: f64 = 1.495;
/// Loads of the scene's steps `[lbf]`.
const LOADS: [f64; 4] = [0.0, 310.0, 620.0, 1240.0];
/// Largest error of a force balance, relative: rounding of the solution.
const BALANCE: f64 = 1e-10;
/// 1 in in mm.
const INCH: f64 = 25.4;
/// 1 lbf in N.
const POUND: f64 = 4.448_221_615_260_5;

pub(super) fn interference(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let results = laboratory.run("interference-pin", &[])?;
    if results.steps.len() != LOADS.len() {
        return Err(format!("not {} steps", LOADS.len()).into());
    }
    let mut checks = Checks::against("statics; Lamé 1852");
    press_fit(&mut checks, &results.steps[0].edges[0]);
    let normal = results.steps[0].edges[0].normal_force;
    for (step, load) in results.steps.iter().zip(LOADS) {
        let [x, y] = step.edges[0].resultant;
        let (expected, scale) = (load * POUND, normal.max(load * POUND));
        checks.rounding_below(
            format!("{load} lb: force on the plate against the load, of the press fit's force or the load"),
            (format!("{} lb", number((x / POUND * 1e6).round() / 1e6)), (x - expected).hypot(y) / scale),
            BALANCE,
        );
    }
    let extents = results.steps.iter().map(|step| {
        let extent = step.edges[0].contact_half_extent.unwrap_or(0.0);
        format!("{:.1}", extent.to_degrees())
    });
    checks.show(
        "contact half-extent at 0, 310, 620, 1240 lb [deg]",
        "",
        extents.collect::<Vec<_>>().join(", "),
    );
    Ok(checks.into_list())
}

/// The step without load.
fn press_fit(checks: &mut Checks, edge: &EdgeResults) {
    let open = edge
        .rows
        .iter()
        .filter(|row| row.status == Status::Open)
        .count();
    checks.holds(
        "0 lb: open nodes",
        "0",
        format!("{open} of {}", edge.rows.len()),
        open == 0,
    );
    let pressures = edge.rows.iter().map(|row| row.pressure / PSI);
    let lowest = pressures.clone().fold(f64::INFINITY, f64::min);
    let highest = pressures.fold(f64::NEG_INFINITY, f64::max);
    let infinite = YOUNG * INTERFERENCE / (2.0 * RADIUS);
    let squares = [RADIUS, TO_EDGE].map(|length| length * length);
    let ring = YOUNG * INTERFERENCE / RADIUS / (2.0 + 2.0 * squares[0] / (squares[1] - squares[0]));
    let mean = edge.normal_force / (2.0 * PI * RADIUS * THICKNESS * INCH * INCH) / PSI;
    checks.holds(
        "0 lb: mean pressure, between inscribed ring and infinite plate",
        format!("{} to {} psi", number(ring), number(infinite)),
        format!("{} psi", number(mean)),
        (ring..=infinite).contains(&mean),
    );
    checks.holds(
        "0 lb: lowest and highest pressure",
        "positive, around the mean",
        format!("{} and {} psi", number(lowest), number(highest)),
        0.0 < lowest && lowest <= mean && mean <= highest,
    );
    checks.show(
        "0 lb: pressure, departure from the infinite plate's",
        format!("{} psi, uniform", number(infinite)),
        format!(
            "{:+.1} % to {:+.1} %",
            100.0 * (lowest / infinite - 1.0),
            100.0 * (highest / infinite - 1.0)
        ),
    );
}

pub(super) fn orthotropic(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against("statics");
    let steel = laboratory.run("pin-orthotropic", &[])?;
    let rigid = laboratory.run("pin-orthotropic", &["bodies.pin.rigid=true".into()])?;
    let pins = [("steel pin", &steel), ("rigid pin", &rigid)];
    for (name, results) in pins {
        checks.converges(name, results, 1);
        checks.rounding_below(
            format!("{name}: unbalanced force over the load"),
            ("", results.steps[0].balance_residual),
            BALANCE,
        );
    }
    checks.now_against("table of the rigid pin, μ = 0.2, infinite plate, every 5°");
    let (angle, peak) = rigid_pin::table_peak()?;
    for (name, results) in pins {
        let (place, value) = peak_radial(results);
        checks.show(
            format!("{name}, strip 40 R wide: largest −σ_r, of P/(2Rt)"),
            format!("{peak:.4} at {angle}°"),
            format!("{value:.4} at {place:.2}°"),
        );
    }
    Ok(checks.into_list())
}

/// Place `[deg]` and value of the largest −σ_r over P/(2Rt).
fn peak_radial(results: &Results) -> (f64, f64) {
    let rows = results.steps[0].edges[0].rows.iter();
    rows.zip(&results.edges[0].parameter)
        .map(|(row, theta)| {
            let ratio = -row.sigma_normal / rigid_pin::BEARING;
            (theta.to_degrees(), ratio)
        })
        .fold((0.0, f64::NEG_INFINITY), |best, at| {
            if at.1 > best.1 { at } else { best }
        })
}
