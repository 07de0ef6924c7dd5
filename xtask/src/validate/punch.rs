//! Open edges in contact: a flat punch with rounded corners against closed forms, and the singular stress at the corner of a bonded square punch.

use std::f64::consts::PI;
use std::path::Path;

use stickslip::results::Results;
use stickslip::run::run;
use stickslip::scene::{Format, Scene};

use super::check::Tolerance::{Absolute, Relative};
use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use crate::publish::TaskError;

const SCENE: &str = include_str!("../../../scenes/rounded-punch.toml");
/// Half-widths of the flat, of contact, and of stick at Q = 0.5 μP in that scene `[mm]`.
const FLAT: f64 = 1.0;
const END: f64 = 1.2;
const STICK: f64 = 1.127_905;
/// Load and friction of that scene `[N]`.
const LOAD: f64 = 73.8556;
const FRICTION: f64 = 0.4;
/// Beside its largest the pressure is compared up to this part of the contact.
const INSIDE: f64 = 0.96;

/// A square punch that sticks to a block of the same material, finer towards its corners.
const SQUARE: &str = include_str!("square_punch.toml");
/// 1 − λ at a notch of 270°, sin(λ 3π/2) = −λ sin(3π/2) (Williams 1952).
const EXPONENT: f64 = 0.455_516;
/// Distances from the corner between which the exponent is fitted `[mm]`; the punch is 2 mm wide.
const FITTED: [f64; 2] = [1.5e-5, 2e-4];

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against("Ciavarella, Hills & Monno 1998; Ciavarella 1998, Jäger 1998");
    let spacing = laboratory.sized(2.0, 1.0);
    let found = solved(SCENE, &[format!("mesh.spacing={spacing} mm")])?;
    let half = |extent: Option<f64>| extent.ok_or("the punch does not touch");
    let [pressed, pushed] = [&found.steps[0].edges[0], &found.steps[1].edges[0]];
    let extent = half(pressed.contact_half_extent)?;
    checks.near(
        "half-width of contact",
        [extent, END],
        Absolute(0.005 * END, " mm"),
    );
    let rows = || found.edges[0].parameter.iter().zip(&pressed.rows);
    let largest = rows().map(|(&at, _)| pressure(at)).fold(0.0, f64::max);
    let inside = rows().filter(|(at, _)| at.abs() < INSIDE * END);
    let apart = inside.map(|(&at, row)| (row.pressure - pressure(at)).abs());
    let apart = apart.fold(0.0, f64::max) / largest;
    checks.holds(
        "largest deviation of the pressure, of its peak",
        "at most 0.5 %",
        format!("{:.2} %", 100.0 * apart),
        apart <= 0.005,
    );
    let peak = pressed.peak_pressure.ok_or("the punch does not touch")?.0;
    checks.near(
        "peak pressure",
        [peak, finest_peak()],
        Relative(0.005, " MPa"),
    );
    let stick = half(pushed.stick_half_extent)?;
    checks.near(
        "half-width of stick at Q = 0.5 μP",
        [stick, STICK],
        Absolute(0.005 * END, " mm"),
    );
    // p(x) μ in the slip zones, less μ times the pressure of the contact that sticks.
    let shear = |at: f64| {
        let smaller = FRICTION * pressure_of(0.5 * LOAD, STICK, at);
        FRICTION * pressure(at) - if at.abs() < STICK { smaller } else { 0.0 }
    };
    let rows = found.edges[0].parameter.iter().zip(&pushed.rows);
    let middle = rows.min_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
    let (&at, row) = middle.ok_or("the punch has no nodes")?;
    checks.near(
        "friction in the middle",
        [row.shear.abs(), shear(at)],
        Relative(0.01, " MPa"),
    );
    checks.now_against("Williams 1952");
    let found = solved(SQUARE, &[""; 0])?;
    checks.near(
        "exponent at the corner of a bonded square punch",
        [exponent(&found)?, EXPONENT],
        Relative(0.05, ""),
    );
    Ok(checks.into_list())
}

/// Pressure under the load of the scene at the place `at` `[MPa]`.
fn pressure(at: f64) -> f64 {
    pressure_of(LOAD, END, at)
}

/// Pressure of a flat of half-width [`FLAT`] with rounded corners that touches to `end` under `load`.
fn pressure_of(load: f64, end: f64, at: f64) -> f64 {
    if at.abs() >= end {
        return 0.0;
    }
    let (inner, place) = ((FLAT / end).asin(), (at.abs() / end).asin());
    let shape = PI - 2.0 * inner - (2.0 * inner).sin();
    let ratio = ((place + inner).sin() / (place - inner).sin()).abs().ln() * place.sin();
    let half = [place + inner, place - inner].map(|angle| (0.5 * angle).tan());
    let product = (half[0] * half[1]).abs().ln() * inner.sin();
    2.0 * load / (PI * end * shape) * ((PI - 2.0 * inner) * place.cos() + ratio + product)
}

/// The largest pressure of the closed form `[MPa]`.
fn finest_peak() -> f64 {
    const PLACES: u32 = 100_000;
    let places = (1..PLACES).map(|k| END * f64::from(k) / f64::from(PLACES));
    places
        .map(pressure)
        .filter(|value| value.is_finite())
        .fold(0.0, f64::max)
}

/// Exponent of the pressure at the corner, p ~ r^−e, by least squares of its logarithms.
fn exponent(found: &Results) -> Result<f64, TaskError> {
    let edge = &found.edges[0];
    let corner = edge
        .parameter
        .last()
        .copied()
        .ok_or("the punch has no nodes")?;
    let rows = edge.parameter.iter().zip(&found.steps[0].edges[0].rows);
    let near = rows.filter_map(|(&at, row)| {
        let away = corner - at;
        (away > FITTED[0] && away < FITTED[1]).then(|| [away.ln(), row.pressure.ln()])
    });
    let near: Vec<[f64; 2]> = near.collect();
    let count = near.len() as f64;
    let mean = [0, 1].map(|axis| near.iter().map(|place| place[axis]).sum::<f64>() / count);
    let sum = |other: usize| -> f64 {
        near.iter()
            .map(|place| (place[0] - mean[0]) * (place[other] - mean[other]))
            .sum()
    };
    Ok(-sum(1) / sum(0))
}

fn solved<S: AsRef<str>>(text: &str, changes: &[S]) -> Result<Results, TaskError> {
    let scene = Scene::from_text(text, Format::Toml, "punch.toml", Path::new(""), changes)?;
    Ok(run(&scene, &mut |_| {})?)
}
