//! Whether a law mirrors where it claims to.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::sample::{Random, Sample, State};
use super::violation::{Breach, Quantity};
use super::{Checked, ask};
use crate::law::{FrictionLaw, Mirror, Place};

/// Difference allowed between the answers at mirrored places, relative: far above the rounding of a reflection, far below what a
/// solution shows.
const MIRRORED: f64 = 1e-9;

/// The claimed symmetries about the x and y axes, the axes of the body and some line, at the places of the sample and at these turned
/// somewhere, so that nothing narrow hides between them.
pub(super) fn check(law: &dyn FrictionLaw, sample: &Sample) -> Checked {
    let mut random = Random::new(sample.seed);
    for &place in &sample.places {
        let material_angle = place.material_angle;
        let along = [0.0, material_angle, TAU * random.unit()];
        let places = [place, place.turned(TAU * random.unit())];
        for line in along.into_iter().flat_map(|line| [line, line + FRAC_PI_2]) {
            let mirror = Mirror {
                line,
                material_angle,
            };
            if law.is_symmetric(&mirror) {
                check_mirrored(law, sample, &mirror, places)?;
            }
        }
    }
    Ok(())
}

fn check_mirrored(
    law: &dyn FrictionLaw,
    sample: &Sample,
    mirror: &Mirror,
    places: [Place; 2],
) -> Checked {
    let sample = Sample {
        places: places.to_vec(),
        ..sample.clone()
    };
    for at in sample.states() {
        let image = State {
            place: mirror.image(&at.place),
            past: at.past.mirrored(),
            ..at
        };
        let (own, mirrored) = (ask(law, &at), ask(law, &image));
        let alike = |quantity: &Quantity| {
            let [own, mirrored] = [&own, &mirrored].map(|bound| quantity.of(bound));
            (own - mirrored).abs() <= MIRRORED * own.abs().max(mirrored.abs())
        };
        if !Quantity::ALL.iter().all(alike) {
            return Err(Box::new(Breach::NotSymmetric {
                own,
                mirrored,
                line: mirror.line,
                at,
            }));
        }
    }
    Ok(())
}
