//! Compliances `[mm/N]` of a bolt in a symmetric double lap: displacement of the middle plate against both outer ones over the force on it.
//!
//! Formulas that are made for single laps see the joint cut at half of its middle plate into two of them side by side, C = ½ C(t/2, s).

use std::f64::consts::PI;

use stickslip::scene::schema::{Formula, HuthJoint, Lap, LapPlate};

use crate::joints::{BOLTS, PLATES, POISSON, RADIUS, THICKNESSES};
use crate::study::TaskError;

/// All formulas by their names.
pub(super) fn all() -> Result<Vec<(&'static str, f64)>, TaskError> {
    let named = [
        ("huth", Formula::Huth(HuthJoint::BoltedMetal)),
        ("tate_rosenfeld", Formula::TateRosenfeld),
        ("boeing", Formula::Boeing),
        ("swift", Formula::Swift),
        ("grumman", Formula::Grumman),
    ];
    let value = |formula: Formula| {
        let half = formula.compliance(&lap(0.5, false)).map(|own| 0.5 * own);
        formula.compliance(&lap(1.0, true)).or(half)
    };
    let all = named.map(|(name, formula)| Some((name, value(formula)?)));
    let all: Option<Vec<_>> = all.into_iter().collect();
    Ok(all.ok_or("a formula is for neither lap")?)
}

/// The joint, with a `part` of its middle plate.
fn lap(part: f64, is_double: bool) -> Lap {
    let [outer, middle, _] = THICKNESSES;
    Lap {
        plates: [part * middle, outer].map(|thickness| LapPlate {
            thickness,
            young: PLATES,
        }),
        is_double,
        diameter: 2.0 * RADIUS,
        young: BOLTS,
        poisson: POISSON,
    }
}

/// Shear and bending of the shank between head and nut, as `springs.beam` has it.
pub(super) fn beam() -> f64 {
    let [s, t, _] = THICKNESSES;
    let area = PI * RADIUS * RADIUS;
    let shear = BOLTS / (2.0 * (1.0 + POISSON));
    let bending = 32.0 * s.powi(3) + 80.0 * s * s * t + 40.0 * s * t * t + 4.0 * t.powi(3);
    let inertia = 0.25 * area * RADIUS * RADIUS;
    (2.0 * s + t) / (12.0 * 0.9 * shear * area) + bending / (2880.0 * BOLTS * inertia)
}
