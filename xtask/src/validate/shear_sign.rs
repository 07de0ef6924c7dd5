//! The pin-loaded graphite-epoxy plate of Post & Reddy (1988, part I): the sign of the shear on its edge (6.3) and the place of matrix
//! cracks (6.4). Angles are the report's: 0° at the net section, 90° at the bearing point.
//!
//! The report measured a change of sign at about 30° while the load grows. That no law gives it is a finding, held here;
//! `cargo xtask shear-sign` has the study.

use stickslip::results::Results;

use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use crate::publish::TaskError;
use crate::shear_sign::curve::{Pattern, Reading, read};
use crate::shear_sign::signs::points;

const SCENE: &str = "pin-quasi-isotropic";
const LOAD_STEPS: usize = 12;
/// Load steps: 20 lb, 100 lb to 1500 lb, 900 lb, and 700 lb while unloading.
const FIRST: usize = 0;
const GROWING: std::ops::RangeInclusive<usize> = 1..=9;
const REPORTED: usize = 7;
const UNLOADING: usize = 10;
/// The part of the edge, from the bearing point, to which shear may be reversed at 20 lb `[degree]`: half of the contact.
const NEAR: f64 = 75.0;

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against("finding of cargo xtask shear-sign");
    let spacing = laboratory.sized("2.25 deg", "1.125 deg");
    let changes = [
        format!("mesh.spacing=\"{spacing}\""),
        "output.fields=\"none\"".to_owned(),
        "failure.criteria=[\"max_stress\"]".to_owned(),
    ];
    let results = laboratory.run(SCENE, &changes)?;
    if results.steps.len() != LOAD_STEPS {
        return Err(format!("not {LOAD_STEPS} steps").into());
    }
    for (edge, law) in ["Coulomb friction", "fibre coverage"]
        .into_iter()
        .enumerate()
    {
        signs(&mut checks, law, &results, edge);
    }
    checks.now_against("Post & Reddy 1988, I 6.4: measured and predicted");
    cracks(&mut checks, &results)?;
    Ok(checks.into_list())
}

fn signs(checks: &mut Checks, law: &str, results: &Results, edge: usize) {
    let reading = |step: usize| {
        let own = &results.steps[step].edges[edge];
        read(&points(&results.edges[edge], own, |_, _| f64::INFINITY))
    };
    let growing: Vec<Reading> = GROWING.map(reading).collect();
    let other = growing.iter().filter(|own| own.pattern != Pattern::Forward);
    checks.holds(
        format!("{law}: shear on the edge, loading from 100 lb to 1500 lb"),
        "towards the bearing point everywhere; Post & Reddy 1988, I 6.3, measured a change at about 30°: not reproduced",
        format!(
            "otherwise in {} of {} load steps",
            other.clone().count(),
            growing.len()
        ),
        other.count() == 0,
    );
    let first = reading(FIRST);
    let end = first.reach().map_or(f64::NAN, |angle| 90.0 - angle);
    checks.holds(
        format!("{law}: at 20 lb, where reversed shear ends"),
        format!("between the bearing point and {NEAR}°"),
        format!("{end:.1}°"),
        first.pattern == Pattern::ReversedInside && end > NEAR,
    );
    let back = reading(UNLOADING);
    let places: Vec<String> = back
        .crossings
        .iter()
        .map(|angle| format!("{:.1}°", 90.0 - angle))
        .collect();
    checks.holds(
        format!("{law}: unloading from 1500 lb to 700 lb"),
        "reversed from the end of contact inwards",
        format!("change of sign at {}", places.join(", ")),
        back.pattern == Pattern::ReversedOutside && places.len() == 1,
    );
}

/// Largest stress across the fibres at 900 lb, by its place.
fn cracks(checks: &mut Checks, results: &Results) -> Result<(), TaskError> {
    const MISSING: &str = "no ply stresses on the edge";
    let mut bodies = results.failure.iter();
    let failure = bodies
        .find(|own| results.bodies[own.body].name == "plate")
        .ok_or(MISSING)?;
    let edge = failure.edges.first().ok_or(MISSING)?;
    let mut peaks = Vec::new();
    for (group, points) in failure.plies.iter().zip(&edge.steps[REPORTED]) {
        let places = edge.parameter.iter().zip(points);
        let largest = places
            .max_by(|a, b| a.1.stress[1].total_cmp(&b.1.stress[1]))
            .ok_or(MISSING)?;
        let stress = results.units.stress.from_base(largest.1.stress[1]);
        peaks.push((group.angle, 90.0 - largest.0.to_degrees(), stress));
    }
    let peak = |ply: f64| {
        let own = peaks.iter().find(|peak| (peak.0 - ply).abs() < 1e-9);
        own.copied().ok_or(MISSING)
    };
    let (_, angle, stress) = peak(60.0)?;
    let (_, mirrored, mirrored_stress) = peak(-60.0)?;
    let (_, _, straight) = peak(0.0)?;
    checks.holds(
        "900 lb: plies and sides of the largest tension across fibres",
        "60° plies from 0° to 45°, −60° plies from 135° to 180°",
        format!("60°: {stress:.2} ksi at {angle:.1}°; −60°: {mirrored_stress:.2} ksi at {mirrored:.1}°; 0°: {straight:.2} ksi"),
        (0.0..45.0).contains(&angle) && (135.0..180.0).contains(&mirrored) && straight < 0.5 * stress,
    );
    checks.show(
        "900 lb: angle of the largest tension in the 60° plies; it follows the end of contact",
        "about 20°",
        format!("{angle:.1}° with a radial clearance of 0.0005 in"),
    );
    Ok(())
}
