//! Line contact of half-planes in closed form: against Hertz, Cattaneo and Mindlin, and against blocks of elements that stand for half-planes.

use std::f64::consts::PI;
use std::path::Path;

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use rayon::prelude::*;
use stickslip::results::{Results, Stated};
use stickslip::run::run;
use stickslip::scene::{Format, Scene};
use stickslip_laboratory::references::line_contact::{FRICTION, HALF_WIDTH, PEAK, STICK};

use super::check::Tolerance::Absolute;
use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use crate::accuracy::COVERAGE;
use crate::publish::TaskError;

const SCENE: &str = include_str!("../../../scenes/fretting-half-planes.toml");
/// Load and radius of that scene `[N, mm]`, with a tenth of the peak pressure of [`PEAK`].
const LOAD: f64 = 50.0;
const RADIUS: f64 = 500.0;
/// Seed of the random contacts.
const SEED: u64 = 1938;
/// What the outline of blocks adds at most to the peak pressure, times (a/d)², and to the stress along the edge, times P/td.
const OUTLINE: [f64; 2] = [0.42, 0.48];

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against("Hertz 1882, Cattaneo 1938, Mindlin 1949");
    let found = solved(SCENE, &[""; 0])?;
    for (what, stated, exact, unit) in [
        ("peak pressure", Stated::PeakPressure, 0.1 * PEAK, " MPa"),
        ("half-width", Stated::ContactExtent, HALF_WIDTH, " mm"),
        (
            "stick half-width at Q = 0.5 μP",
            Stated::StickExtent,
            STICK,
            " mm",
        ),
        (
            "stress at the trailing edge, 2 μ p₀ √(Q/μP)",
            Stated::PeakHoop,
            0.2 * FRICTION * PEAK * 0.5_f64.sqrt(),
            " MPa",
        ),
    ] {
        let [value, error] = number(&found, 1, stated)?;
        let name = format!("{what}, bound its own error");
        checks.near(name, [value, exact], Absolute(error, unit));
    }
    covered(laboratory.sized(24, 100), &mut checks)?;
    checks.now_against("half-planes");
    outlines(laboratory, &mut checks)?;
    Ok(checks.into_list())
}

/// How often errors hold the closed forms of random contacts, pressed and pushed.
fn covered(count: usize, checks: &mut Checks) -> Result<(), TaskError> {
    let mut rng = StdRng::seed_from_u64(SEED);
    let draws: Vec<Draw> = (0..count).map(|_| Draw::new(&mut rng)).collect();
    let found = draws.par_iter().map(Draw::within);
    let found: Vec<[bool; 4]> = found.collect::<Result<_, String>>()?;
    let names = [
        "peak pressure",
        "half-width",
        "stick half-width",
        "peak tangential stress",
    ];
    for (number, name) in names.into_iter().enumerate() {
        let held = found.iter().filter(|within| within[number]).count();
        checks.holds(
            format!("{name} of {count} random contacts within its stated error"),
            format!("at least {} %", 100.0 * COVERAGE),
            format!("{:.1} %", 100.0 * held as f64 / count as f64),
            held as f64 >= COVERAGE * count as f64,
        );
    }
    Ok(())
}

/// A contact of equal materials.
struct Draw {
    /// E `[MPa]` and ν.
    elastic: [f64; 2],
    /// R and a `[mm]`.
    sizes: [f64; 2],
    friction: f64,
    /// Q/μP.
    part: f64,
    accuracy: f64,
}

impl Draw {
    fn new(rng: &mut StdRng) -> Self {
        let mut between = |low: f64, high: f64| rng.random_range(low..high);
        let radius = 10_f64.powf(between(0.0, 3.0));
        Self {
            elastic: [10_f64.powf(between(3.0, 5.5)), between(0.0, 0.45)],
            sizes: [radius, radius * 10_f64.powf(between(-3.5, -1.5))],
            friction: between(0.05, 1.2),
            part: between(0.05, 0.95),
            accuracy: [0.05, 0.01, 0.002][between(0.0, 3.0) as usize],
        }
    }

    /// Whether peak pressure, half-widths of contact and stick, and the stress at the trailing edge lie within their errors.
    fn within(&self) -> Result<[bool; 4], String> {
        let Self {
            elastic: [young, poisson],
            sizes: [radius, half_width],
            friction,
            part,
            accuracy,
        } = self;
        let modulus = 0.5 * young / (1.0 - poisson * poisson);
        let load = PI * modulus * half_width * half_width / (4.0 * radius);
        let push = part * friction * load;
        let (length, depth) = (0.3 * radius, 0.5 * radius);
        let changes = [
            format!("analysis.accuracy={accuracy}"),
            format!("materials.aluminium.isotropic.young={young} MPa"),
            format!("materials.aluminium.isotropic.poisson={poisson}"),
            format!(
                "bodies.flat.shape.block={{ half_length = \"{length} mm\", depth = \"{depth} mm\" }}"
            ),
            format!(
                "bodies.cylinder.shape.cylinder={{ radius = \"{radius} mm\", half_length = \"{length} mm\", depth = \"{depth} mm\" }}"
            ),
            format!("contacts.0.friction.coulomb.mu={friction}"),
            format!("loads.0.force.steps=[\"{load} N\", \"{load} N\"]"),
            format!("loads.1.force.steps=[\"0 N\", \"{push} N\"]"),
            "output.fields=\"none\"".to_owned(),
        ];
        let found = solved(SCENE, &changes).map_err(|why| format!("{changes:?}: {why}"))?;
        let peak = 2.0 * load / (PI * half_width);
        let exact = [
            (Stated::PeakPressure, peak),
            (Stated::ContactExtent, *half_width),
            (Stated::StickExtent, half_width * (1.0 - part).sqrt()),
            (Stated::PeakHoop, 2.0 * friction * peak * part.sqrt()),
        ];
        let mut within = [false; 4];
        for (within, (stated, exact)) in within.iter_mut().zip(exact) {
            let [value, error] = number(&found, 1, stated).map_err(|why| why.to_string())?;
            *within = (value - exact).abs() <= error;
        }
        Ok(within)
    }
}

/// What outlines of elements change, which the finding `outline_left_out` gives as at most 0.4 (a/d)² and 0.75 a/d of the peak pressure.
fn outlines(laboratory: &Laboratory, checks: &mut Checks) -> Result<(), TaskError> {
    let spacing = laboratory.sized(0.02, 0.01);
    let text = SCENE.replace("accuracy = \"1 %\"\n", "");
    for [length, depth] in [[10.0, 10.0], [20.0, 20.0], [40.0, 10.0], [10.0, 40.0]] {
        let sizes = format!(
            "half_length = \"{} mm\", depth = \"{} mm\"",
            length * HALF_WIDTH,
            depth * HALF_WIDTH
        );
        let changes = [
            format!("bodies.flat.shape.block={{ {sizes} }}"),
            format!("bodies.cylinder.shape.cylinder={{ radius = \"{RADIUS} mm\", {sizes} }}"),
            format!("mesh.spacing={spacing} mm"),
            "mesh.fine_to=1.2 mm".to_owned(),
            format!("loads.0.force.steps=[\"{LOAD} N\"]"),
            "loads.1.force.steps=[\"0 N\"]".to_owned(),
            "contacts.0.friction.coulomb.mu=0.4".to_owned(),
            "output.fields=\"none\"".to_owned(),
        ];
        let elements = [
            "bodies.flat.model=elements",
            "bodies.cylinder.model=elements",
        ];
        let elements: Vec<String> = elements
            .map(String::from)
            .into_iter()
            .chain(changes.iter().cloned())
            .collect();
        let both = [solved(&text, &elements)?, solved(&text, &changes)?];
        let apart = |stated: Stated| -> Result<f64, TaskError> {
            let [own, half_planes] = [&both[0], &both[1]].map(|results| {
                stated
                    .value(&results.steps[0].edges[0])
                    .ok_or("the cylinder does not touch")
            });
            Ok(own? - half_planes?)
        };
        let ratio: f64 = length.min(depth);
        let peak = 0.1 * PEAK;
        let pressure = apart(Stated::PeakPressure)? / peak * ratio * ratio;
        let stress = apart(Stated::HoopAtBearing)? / (LOAD / (ratio * HALF_WIDTH));
        let outline = format!("elements, half length {length} a, depth {depth} a");
        for (what, value, most) in [
            ("peak pressure higher by, of (a/d)²", pressure, OUTLINE[0]),
            (
                "stress along the edge higher by, of P/td",
                stress,
                OUTLINE[1],
            ),
        ] {
            checks.holds(
                format!("{outline}: {what}"),
                format!("0 to {most}"),
                format!("{value:.2}"),
                (0.0..=most).contains(&value),
            );
        }
    }
    Ok(())
}

fn solved<S: AsRef<str>>(text: &str, changes: &[S]) -> Result<Results, TaskError> {
    let scene = Scene::from_text(text, Format::Toml, "fretting.toml", Path::new(""), changes)?;
    Ok(run(&scene, &mut |_| {})?)
}

/// The number `stated` of load step `step` with its error.
fn number(results: &Results, step: usize, stated: Stated) -> Result<[f64; 2], TaskError> {
    let edge = &results.steps[step].edges[0];
    let value = stated.value(edge).ok_or("the cylinder does not touch")?;
    let error = edge.errors.get(stated);
    Ok([
        value,
        error.ok_or_else(|| format!("no error of the {}", stated.describe()))?,
    ])
}
