//! Pins in outlines, a round-ended lug and a hole near one side of a strip, against other programs, and stress concentration beside a handbook.
//!
//! ```text
//! K_t = σ_θ,max (W − D) t/P        W width of the lug, D diameter of its hole, t thickness, P force
//! ```
//!
//! How the numbers of `lugs.toml` were found is said in `crates/laboratory/data/README.md`.

use std::f64::consts::TAU;

use serde::Deserialize;
use stickslip::results::{EdgeResults, Results};

use super::check::Tolerance::{Absolute, Relative};
use super::check::{Check, Checks};
use super::laboratory::{Laboratory, Size, Worst};
use crate::publish::{TaskError, listed};

const PINS: &str = include_str!("lugs.toml");
/// Diameter of the hole over the width of a round-ended lug, and the factor of a chart for a pin that is 0.2 % smaller than the hole.
const CHART: [(f64, f64); 3] = [(0.4, 3.33), (0.5, 3.07), (0.6, 2.87)];
/// Allowed error of a number; of a stress on the edge as a part of its largest, of an end of contact as a part of the contact.
const BOUND: f64 = 5e-3;
/// Points closer to an end of contact than this `[deg]` are left out.
const END: f64 = 3.0;
/// Steps between angles that are nodes of every mesh, the largest and the smallest spacing `[deg]`, and its part of the distance to an end of contact.
const STEP: f64 = 5.0;
const LARGEST: f64 = 2.5;
const SMALLEST: f64 = 0.05;
const SHARE: f64 = 0.35;
/// Width and thickness of the lug `[mm]`, and its load `[N]`.
const WIDTH: f64 = 40.0;
const THICKNESS: f64 = 8.0;
const LOAD: f64 = 10e3;

/// A scene and what other programs found.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Pin {
    name: String,
    scene: String,
    #[serde(default)]
    overrides: Vec<String>,
    /// How far along the load the scene starts the pin from the centre of its hole `[mm]`.
    #[serde(default)]
    start: f64,
    found: Vec<Found>,
}

/// What one program found.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Found {
    by: String,
    /// Ends of contact `[deg]`.
    ends: [f64; 2],
    /// Largest pressure and largest σ_θ on the hole `[MPa]`.
    pressure: f64,
    hoop: f64,
    /// Mean displacement of the pin along its load from the centre of its hole `[mm]`.
    displacement: f64,
    /// Angle `[deg]`, pressure and σ_θ `[MPa]`; none of meshes with rays of 5°.
    #[serde(default)]
    points: Vec<[f64; 3]>,
}

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::default();
    for pin in listed::<Pin>(PINS, "pins")? {
        let ends = pin.found.first().ok_or("no program found anything")?.ends;
        let mut overrides = vec![format!("mesh={{ angles = {} }}", angles(ends))];
        overrides.extend_from_slice(&pin.overrides);
        let results = laboratory.run(&pin.scene, &overrides)?;
        for found in &pin.found {
            checks.now_against(&found.by);
            compare(&mut checks, &pin, found, &results)?;
        }
    }
    if laboratory.size == Size::Full {
        handbook(&mut checks, laboratory)?;
    }
    Ok(checks.into_list())
}

/// Angles of corner nodes around the hole: every 5°, halved towards the `ends` of contact.
fn angles(ends: [f64; 2]) -> String {
    let mut pending: Vec<[f64; 2]> = (0..72)
        .rev()
        .map(|k| [STEP * f64::from(k), STEP * f64::from(k + 1)])
        .collect();
    let mut nodes = Vec::new();
    while let Some([from, to]) = pending.pop() {
        let away = ends.iter().map(|&end| {
            let past = f64::rem_euclid(end - from, 360.0);
            let length: f64 = to - from;
            if past <= length {
                0.0
            } else {
                (past - length).min(360.0 - past)
            }
        });
        let allowed = SMALLEST.max(SHARE * away.fold(f64::INFINITY, f64::min));
        if to - from > allowed.min(LARGEST) {
            let middle = 0.5 * (from + to);
            pending.extend([[middle, to], [from, middle]]);
        } else {
            nodes.push(from);
        }
    }
    // A disk has an even number.
    if nodes.len() % 2 == 1 {
        nodes.extend(nodes.last().map(|last| 0.5 * (last + 360.0)));
    }
    let nodes: Vec<String> = nodes.iter().map(|at| format!("\"{at} deg\"")).collect();
    format!("[{}]", nodes.join(", "))
}

fn compare(
    checks: &mut Checks,
    pin: &Pin,
    found: &Found,
    results: &Results,
) -> Result<(), TaskError> {
    let name = &pin.name;
    let edge = &results.steps[0].edges[0];
    let nothing = || format!("{name}: nothing touches");
    let pressure = edge.peak_pressure.ok_or_else(nothing)?.0;
    let hoop = edge.peak_hoop.ok_or_else(nothing)?.0;
    let set = results.sets.iter().position(|set| set.name == "pull");
    let motion = set.and_then(|set| results.steps[0].sets[set]);
    let displacement = motion
        .ok_or("the pin's displacement is not known")?
        .displacement;
    for (quantity, pair, unit) in [
        ("largest pressure", [pressure, found.pressure], " MPa"),
        ("largest σ_θ", [hoop, found.hoop], " MPa"),
        (
            "displacement of the pin",
            [displacement + pin.start, found.displacement],
            " mm",
        ),
    ] {
        checks.near(format!("{name}: {quantity}"), pair, Relative(BOUND, unit));
    }
    let extent = found.ends[1] - found.ends[0];
    let ends = touching(edge).ok_or_else(nothing)?;
    for (which, pair) in ["first", "second"]
        .iter()
        .zip(ends.into_iter().zip(found.ends))
    {
        checks.near(
            format!("{name}: {which} end of contact"),
            pair.into(),
            Absolute(BOUND * extent, "°"),
        );
    }
    if found.points.is_empty() {
        return Ok(());
    }
    for (quantity, largest, column) in [("pressure", found.pressure, 1), ("σ_θ", found.hoop, 2)] {
        let (mut worst, mut count) = (Worst::default(), 0);
        for point in &found.points {
            let [angle, ..] = *point;
            let apart = |end: &f64| ((angle - end + 180.0).rem_euclid(360.0) - 180.0).abs();
            if found.ends.iter().any(|end| apart(end) < END) {
                continue;
            }
            let at = node(results, angle)?;
            let row = &edge.rows[at];
            let value = [angle, row.pressure, row.sigma_tangential][column];
            worst.meet((value - point[column]).abs() / largest, || {
                format!("{angle}°")
            });
            count += 1;
        }
        worst.place = format!("worst of {count} points: {}", worst.place);
        checks.error_below(
            format!("{name}: {quantity} around, of its largest"),
            worst,
            BOUND,
        );
    }
    Ok(())
}

/// Ends of contact `[deg]`.
fn touching(edge: &EdgeResults) -> Option<[f64; 2]> {
    let zones = || edge.zones.iter().filter(|zone| zone.status.touches());
    let first = zones().map(|zone| zone.start).reduce(f64::min)?;
    let last = zones().map(|zone| zone.end).reduce(f64::max)?;
    Some([first, last].map(f64::to_degrees))
}

/// The node at `degrees` of the first edge.
fn node(results: &Results, degrees: f64) -> Result<usize, TaskError> {
    let theta = degrees.to_radians();
    let mut places = results.edges[0].parameter.iter();
    let near = |at: &f64| {
        let apart = (at - theta).rem_euclid(TAU);
        apart.min(TAU - apart) < 1e-9
    };
    let found = places.position(near);
    Ok(found.ok_or_else(|| format!("no node at {degrees}°"))?)
}

/// Factors of lugs with a pin that is 0.2 % smaller than its hole. They depend on load and friction, which the chart does not name, so they have no bound.
fn handbook(checks: &mut Checks, laboratory: &Laboratory) -> Result<(), TaskError> {
    checks.now_against("ESDU 81006, figure 2, by a polynomial read from it");
    for (ratio, factor) in CHART {
        let radius = 0.5 * ratio * WIDTH;
        let net = (1.0 - ratio) * WIDTH * THICKNESS;
        let of = |clearance: f64, friction: f64| -> Result<f64, TaskError> {
            let overrides = [
                format!("bodies.lug.shape.outline.holes.bolt.radius=\"{radius} mm\""),
                format!(
                    "bodies.pin.shape.disk.radius=\"{} mm\"",
                    radius * (1.0 - clearance)
                ),
                format!("contacts.0.friction.coulomb.mu={friction}"),
            ];
            let results = laboratory.run("validation/lug", &overrides)?;
            let (hoop, _) = results.steps[0].edges[0].peak_hoop.ok_or("no stress")?;
            Ok(hoop * net / LOAD)
        };
        let [tight, loose, rough] = [of(0.0, 0.0)?, of(2e-3, 0.0)?, of(2e-3, 0.2)?];
        checks.show(
            format!("round-ended lug, D/W = {ratio}: K_t at 10 kN, clearance 0.2 % of D"),
            format!("{factor}"),
            format!("{loose:.3}; without clearance {tight:.3}; with friction 0.2 {rough:.3}"),
        );
    }
    Ok(())
}
